#include <quaoar/view/quality.hpp>

#include <algorithm>

namespace quaoar {

void FrameGovernor::frame(double seconds) {
    if (!(seconds > 0) || seconds > 0.5) return;
    sum_ += seconds;
    ++count_;
    since_ += seconds;
    settled_ = std::max(0.0, settled_ - seconds);
    // A third of a second and eight frames, so that one hiccup decides nothing; fewer where all of
    // them are so long that waiting for eight would be felt.
    const bool crawls = sum_ > count_ * 2 * tooLong;
    if (sum_ < 0.33 || count_ < (crawls ? 4 : 8)) return;
    const double mean = sum_ / count_;
    sum_ = 0;
    count_ = 0;
    judge(mean);
}

void FrameGovernor::judge(double mean) {
    const int cheapest = static_cast<int>(qualities.size()) - 1;
    if (mean > tooLong && settled_ <= 0) {
        if (level_ < cheapest) {
            if (!lowering_) {
                fromLevel_ = level_;
                fromMean_ = mean;
            }
            if (raised_ && since_ < 2) patience_ = std::min(60.0, patience_ * 2);  // in vain
            lowering_ = true;
            change(std::min(cheapest, level_ + (mean > 2 * tooLong ? 2 : 1)));
        } else if (lowering_) {
            lowering_ = false;
            if (mean < 0.85 * fromMean_) return;
            // The cheapest comes no sooner: it is not the drawing that takes the time.
            change(fromLevel_);
            settled_ = 60;
        }
        return;
    }
    lowering_ = false;
    if (mean < roomy && level_ > 0 && since_ > patience_) {
        change(level_ - 1);
        raised_ = true;
    }
}

void FrameGovernor::change(int level) {
    level_ = level;
    since_ = 0;
    raised_ = false;
}

}  // namespace quaoar
