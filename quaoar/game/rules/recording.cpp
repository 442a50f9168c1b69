#include <quaoar/recording.hpp>

#include <algorithm>
#include <array>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <sulfur/version.hpp>

namespace quaoar {

Recording::Recording(const Level& level)
    : levelId(level.id),
      levelHash(level.contentHash),
      library(sulfur::version()),
      numbers(sizeof(sulfur::Real) == sizeof(double) ? "double" : "float") {}

bool Recording::append(const TickInput& input) {
    if (ticks_ >= maxTicks) return false;
    if (!runs_.empty() && runs_.back().input == input) {
        ++runs_.back().ticks;
    } else {
        runs_.push_back({1, input});
    }
    ++ticks_;
    return true;
}

void Recording::clear() {
    runs_.clear();
    ticks_ = 0;
    finalHash = 0;
}

Recording Recording::read(const std::filesystem::path& file) {
    try {
        return parse(atlax::readFile(file, maxBytes), file.string());
    } catch (const atlax::Error& error) {
        throw RecordingError(error.what());
    }
}

void Recording::write(const std::filesystem::path& file) const {
    atlax::writeFileAtomic(file, format());
}

Playback::Playback(std::shared_ptr<const Recording> recording) : recording_(std::move(recording)) {}

TickInput Playback::next() {
    if (done()) {
        TickInput idle;
        idle.aimX = last_.aimX;
        idle.aimY = last_.aimY;
        return idle;
    }
    const InputRun& run = recording_->runs()[run_];
    last_ = run.input;
    if (++tick_ >= run.ticks) {
        tick_ = 0;
        ++run_;
    }
    return last_;
}

void requireMatch(const Level& level, const Recording& recording) {
    if (recording.levelHash == level.contentHash) return;
    const bool sameName = recording.levelId == level.id;
    throw RecordingError("the recording was made for " +
                         (sameName
                              ? "another version of level \"" + level.id + "\""
                              : "level \"" + recording.levelId + "\", not \"" + level.id + "\"") +
                         "; record it again");
}

Verdict verify(std::shared_ptr<const Level> level, const Recording& recording) {
    requireMatch(*level, recording);
    Session session(std::move(level));
    for (const InputRun& run : recording.runs()) {
        for (std::uint32_t n = 0; n < run.ticks; ++n) session.tick(run.input);
    }
    Verdict verdict;
    verdict.finished = session.phase() == Session::Phase::finished;
    verdict.seconds = session.seconds();
    verdict.ticks = recording.ticks();
    verdict.hash = session.hash();
    verdict.sameAsRecorded = verdict.hash == recording.finalHash;
    return verdict;
}

std::filesystem::path proofOf(const std::filesystem::path& levelFile) {
    std::filesystem::path proof = levelFile;
    return proof.replace_extension(".proof");
}

}  // namespace quaoar
