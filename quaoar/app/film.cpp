#include "film.hpp"

#include <atlax/files.hpp>
#include <atlax/image.hpp>

namespace quaoar {
namespace {

constexpr std::uint64_t ticksPerFrame = Session::tickRate / Film::framesPerSecond;
/// Before the film's first frame nothing is drawn; so many ticks take a few milliseconds.
constexpr int ticksPerStep = 250;

}  // namespace

Film::Film(Art& art, std::shared_ptr<const Level> level, std::shared_ptr<const Recording> recording,
           std::filesystem::path file)
    : recording_(std::move(recording)),
      session_(std::move(level)),
      view_(art, session_),
      playback_(recording_),
      file_(std::move(file)) {
    // Half a second of arriving at the end.
    end_ = recording_->ticks() + Session::tickRate / 2;
    const auto most = static_cast<std::uint64_t>(mostSeconds * Session::tickRate);
    first_ = end_ > most ? end_ - most : 0;
}

void Film::tick() {
    session_.tick(playback_.next());
    view_.tick();
    ++ticks_;
}

bool Film::step(atlax::Canvas& canvas) {
    for (int n = 0; n < ticksPerStep && ticks_ < first_; ++n) tick();
    if (ticks_ < first_) return false;
    if (!target_.valid()) target_ = canvas.createTarget(size);
    canvas.pushTarget(target_);
    ViewOptions options;
    options.aim = false;
    view_.draw(canvas, 1, options);
    canvas.popTarget();
    film_.add(canvas.read(target_));
    for (std::uint64_t n = 0; n < ticksPerFrame; ++n) tick();
    if (ticks_ < end_) return false;
    atlax::writeFileAtomic(file_, film_.bytes());
    return true;
}

double Film::progress() const {
    return static_cast<double>(ticks_) / static_cast<double>(end_);
}

}  // namespace quaoar
