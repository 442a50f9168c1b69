// How much a picture may cost, and how that is chosen by the time that frames take.
#pragma once

#include <array>

namespace quaoar {

/// What a picture leaves out or draws coarser. The simulation knows nothing of it.
struct Quality {
    float scene = 1;     ///< pixels of the world per pixel of the screen, along a side
    float backdrop = 1;  ///< the same of what lies behind, times `scene`
    float weather = 1;   ///< share of flakes, spores, embers
    bool foreground = true;
    bool glints = true;  ///< small lights in the rock, the lamp's light on it
};

/// From the dearest, 0, to the cheapest.
inline constexpr std::array<Quality, 5> qualities{{
    {1, 1, 1, true, true},
    {1, 0.5f, 1, true, true},
    {1, 0.34f, 0.6f, true, true},
    {0.75f, 0.4f, 0.5f, false, true},
    {0.5f, 0.5f, 0.3f, false, false},
}};

/// Chooses a quality so that frames come quickly enough: 50 a second and more. Goes down soon when
/// they do not, and up again where there seems to be room, more and more rarely if that fails.
/// Where even the cheapest picture comes no sooner (a slow display), it takes the first one back.
class FrameGovernor {
public:
    /// Index into `qualities`.
    int level() const { return level_; }
    const Quality& quality() const { return qualities[static_cast<std::size_t>(level_)]; }
    /// A frame came this long after the one before. Times beyond half a second say nothing about
    /// drawing and are ignored.
    void frame(double seconds);

private:
    void judge(double mean);
    void change(int level);

    static constexpr double tooLong = 1 / 48.0;  // s
    static constexpr double roomy = 1 / 58.0;    // s: at 60 Hz nothing waits
    int level_ = 1;
    double sum_ = 0;
    int count_ = 0;
    double since_ = 0;       ///< s at this level
    double patience_ = 3;    ///< s before a dearer one is tried
    bool raised_ = false;    ///< the last change was to a dearer one
    bool lowering_ = false;  ///< on the way down, from ...
    int fromLevel_ = 0;      ///< ... this level,
    double fromMean_ = 0;    ///< s: a frame there
    double settled_ = 0;     ///< s for which the level is not lowered
};

}  // namespace quaoar
