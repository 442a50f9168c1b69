#include "scene_film.hpp"

#include <algorithm>
#include <atlax/files.hpp>
#include <cmath>

#include "scene_view.hpp"

namespace sulfurchamber {

SceneFilm::SceneFilm(const SceneView& view, Document& document, const atlax::Camera& camera,
                     atlax::PixelSize size, std::filesystem::path file)
    : view_(view),
      document_(document),
      camera_(camera),
      options_(view.options()),
      file_(std::move(file)),
      world_(std::make_unique<sulfur::World>(document.world().settings())) {
    options_.tools = false;
    options_.bodies = true;
    const int longest = std::max({1, size.width, size.height});
    const float scale = std::min(1.0f, static_cast<float>(mostSide) / static_cast<float>(longest));
    const auto side = [&](int pixels) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(pixels) * scale)));
    };
    size_ = {side(size.width), side(size.height)};
    camera_.pixelsPerMetre *= scale;
    const Timeline& timeline = document.timeline();
    const std::uint32_t line = timeline.line();
    const int rate = document.world().settings().tickRate;
    last_ = timeline.now() ? timeline.now()->tick : timeline.last(line);
    const auto most = static_cast<std::uint64_t>(mostSeconds * rate);
    first_ = std::max(timeline.first(line), last_ > most ? last_ - most : 0);
    ticksPerPicture_ = static_cast<std::uint64_t>(std::max(1, rate * delay / 1000));
    next_ = {line, first_};
}

bool SceneFilm::step(atlax::Canvas& canvas) {
    if (!document_.replay(*world_, next_, patience)) return false;
    if (!target_.valid()) target_ = canvas.createTarget(size_);
    canvas.pushTarget(target_);
    document_.lookAt(world_, [&] { view_.paintWorld(canvas, camera_, painter_, options_, 1); });
    canvas.popTarget();
    film_.add(canvas.read(target_));
    if (next_.tick == last_) {
        atlax::writeFileAtomic(file_, film_.bytes());
        return true;
    }
    next_.tick = std::min(last_, next_.tick + ticksPerPicture_);
    return false;
}

double SceneFilm::progress() const {
    if (last_ == first_) return 1;
    return static_cast<double>(next_.tick - first_) / static_cast<double>(last_ - first_);
}

}  // namespace sulfurchamber
