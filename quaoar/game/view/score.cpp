#include <quaoar/view/score.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "dice.hpp"

namespace quaoar {
namespace {

/// What makes a world's music its own.
struct Style {
    double beat;               ///< seconds
    std::array<int, 8> roots;  ///< semitones from A2, one chord each
    std::array<int, 7> scale;  ///< semitones of the mode
    int bellsPerBar;           ///< how busy the melody is
    double bellFall;           ///< 1/s
    double bellOvertone;       ///< ratio: 2 is soft, 2.76 a bell, 5.4 glass
    int bassPerBar;            ///< notes of the bass
    double padDetune;          ///< share of the pitch
    double padGain, bellGain, bassGain, noiseGain;
};

Style styleOf(Theme::World world) {
    switch (world) {
        case Theme::World::dawn:
            break;
        case Theme::World::bog:
            return {0.92,
                    {5, 5, 3, 0, 5, 8, 3, 0},
                    {0, 2, 3, 5, 7, 9, 10},
                    3,
                    9,
                    3.9,
                    2,
                    0.006,
                    0.8,
                    1.2,
                    1.1,
                    0.05};
        case Theme::World::machine:
            return {0.52,
                    {-5, -5, -2, -7, -5, -5, 0, -2},
                    {0, 2, 3, 5, 7, 8, 10},
                    4,
                    12,
                    4.2,
                    8,
                    0.004,
                    0.55,
                    0.7,
                    1.3,
                    0.5};
        case Theme::World::deep:
            return {1.05,
                    {4, 0, -3, 2, 4, 7, -3, -1},
                    {0, 2, 3, 5, 7, 8, 11},
                    3,
                    1.3,
                    5.4,
                    1,
                    0.009,
                    1.2,
                    0.8,
                    0.9,
                    0.0};
    }
    return {0.80,
            {0, -4, 3, -2, 0, -4, 5, -2},
            {0, 2, 3, 5, 7, 8, 10},
            4,
            2.2,
            2.76,
            2,
            0.005,
            1.0,
            1.0,
            0.8,
            0.0};
}

constexpr int beatsPerBar = 4;

/// A loop into which notes are laid; what rings beyond its end rings at its beginning.
class Loop {
public:
    explicit Loop(double seconds) : samples_(static_cast<std::size_t>(seconds * scoreRate), 0.0f) {}

    /// A tone with its rise and decay, `overtone` times its pitch mixed in.
    void note(double start, double hertz, double seconds, double rise, double decay, double gain,
              double overtone = 0, double overtoneGain = 0) {
        const auto count = static_cast<std::size_t>(seconds * scoreRate);
        auto at = static_cast<std::size_t>(start * scoreRate) % samples_.size();
        Turning low(hertz), high(hertz * overtone);
        double level = gain;
        const double keep = std::exp(-decay / scoreRate);
        const double riseStep = rise > 0 ? 1 / (rise * scoreRate) : 1;
        double up = 0;
        const double end = 0.25 * seconds * scoreRate;
        for (std::size_t i = 0; i < count; ++i) {
            up = std::min(1.0, up + riseStep);
            const double away = std::min(1.0, static_cast<double>(count - i) / end);
            const double wave = low.next() + (overtone > 0 ? overtoneGain * high.next() : 0);
            samples_[at] += static_cast<float>(level * up * away * wave);
            level *= keep;
            if (++at == samples_.size()) at = 0;
        }
    }

    /// A short hiss.
    void hiss(double start, double seconds, double smooth, double gain, Dice& dice) {
        const auto count = static_cast<std::size_t>(seconds * scoreRate);
        auto at = static_cast<std::size_t>(start * scoreRate) % samples_.size();
        double low = 0;
        for (std::size_t i = 0; i < count; ++i) {
            low += smooth * (static_cast<double>(dice.between(-1, 1)) - low);
            const double part = 1 - static_cast<double>(i) / static_cast<double>(count);
            samples_[at] += static_cast<float>(gain * low * part * part);
            if (++at == samples_.size()) at = 0;
        }
    }

    /// Echoes that run on over the seam: twice round, so that the first round has them too.
    void echo(double seconds, float share) {
        const std::size_t back = static_cast<std::size_t>(seconds * scoreRate) % samples_.size();
        std::vector<float> wet = samples_;
        for (int round = 0; round < 2; ++round) {
            for (std::size_t i = 0; i < wet.size(); ++i)
                wet[i] = samples_[i] + share * wet[(i + wet.size() - back) % wet.size()];
        }
        samples_ = std::move(wet);
    }

    /// To this loudness at its peak.
    std::vector<float> finish(float peak) {
        float most = 1e-6f;
        for (const float s : samples_) most = std::max(most, std::abs(s));
        for (float& s : samples_) s *= peak / most;
        return std::move(samples_);
    }

private:
    /// A sine by turning a pointer: far cheaper than asking for one.
    class Turning {
    public:
        explicit Turning(double hertz)
            : c_(std::cos(6.283185307179586 * hertz / scoreRate)),
              s_(std::sin(6.283185307179586 * hertz / scoreRate)) {}
        double next() {
            const double x = x_ * c_ - y_ * s_;
            y_ = x_ * s_ + y_ * c_;
            x_ = x;
            return y_;
        }

    private:
        double c_, s_, x_ = 1, y_ = 0;
    };

    std::vector<float> samples_;
};

double pitch(int semitones) {
    return 110 * std::exp2(semitones / 12.0);
}

class Composer {
public:
    Composer(Theme::World world, std::uint32_t seed)
        : style_(styleOf(world)), bar_(style_.beat * beatsPerBar), dice_(seed * 7 + 3) {}

    Score compose() {
        const double length = bar_ * static_cast<double>(style_.roots.size());
        Loop calm(length), danger(length);
        for (std::size_t bar = 0; bar < style_.roots.size(); ++bar) {
            const double start = bar_ * static_cast<double>(bar);
            pad(calm, start, style_.roots[bar]);
            melody(calm, start, style_.roots[bar]);
            bass(calm, start, style_.roots[bar]);
            if (style_.noiseGain > 0.2) rhythm(calm, start);
            fright(danger, start, style_.roots[bar]);
        }
        calm.echo(style_.beat * 0.75, 0.34f);
        danger.echo(style_.beat * 0.5, 0.2f);
        return {calm.finish(0.62f), danger.finish(0.55f)};
    }

private:
    /// A tone of the mode, `step` steps above the chord's root.
    int tone(int root, int step) const {
        const int octave = step >= 0 ? step / 7 : -((6 - step) / 7);
        const int rest = step - octave * 7;
        // The chord's root is itself a tone of the mode; its own steps follow the mode from there.
        int place = 0;
        const int within = ((root % 12) + 12) % 12;
        for (int k = 0; k < 7; ++k)
            if (style_.scale[static_cast<std::size_t>(k)] <= within) place = k;
        const int at = place + rest;
        const int semitone = style_.scale[static_cast<std::size_t>(at % 7)] + 12 * (at / 7) -
                             style_.scale[static_cast<std::size_t>(place)];
        return root + semitone + 12 * octave;
    }

    void pad(Loop& loop, double start, int root) {
        for (const int step : {0, 2, 4, 6}) {
            const double hertz = pitch(tone(root, step) + (step == 6 ? 0 : 12));
            const double gain = 0.05 * style_.padGain * (step == 6 ? 0.5 : 1);
            for (const double off : {-style_.padDetune, 0.0, style_.padDetune})
                loop.note(start, hertz * (1 + off), bar_ * 1.45, bar_ * 0.35, 0.15, gain, 2, 0.25);
        }
    }

    void melody(Loop& loop, double start, int root) {
        const int slots = beatsPerBar * 2;
        for (int n = 0; n < style_.bellsPerBar; ++n) {
            const int slot = static_cast<int>(dice_.next() % static_cast<std::uint32_t>(slots));
            // Small steps about the last note, drawn to the tones of the chord.
            last_ = std::clamp(last_ + static_cast<int>(dice_.next() % 5) - 2, 0, 11);
            const int step = slot % 4 == 0 ? last_ / 2 * 2 : last_;
            const double gain =
                0.16 * style_.bellGain * static_cast<double>(dice_.between(0.5f, 1));
            loop.note(start + style_.beat * 0.5 * slot, pitch(tone(root, step) + 24),
                      4 / std::max(1.0, style_.bellFall * 0.5), 0.004, style_.bellFall, gain,
                      style_.bellOvertone, 0.35);
        }
    }

    void bass(Loop& loop, double start, int root) {
        for (int n = 0; n < style_.bassPerBar; ++n) {
            const double at = start + bar_ * n / style_.bassPerBar;
            const int low = n % 4 == 3 ? tone(root, 4) - 12 : root;
            loop.note(at, pitch(low), std::min(bar_ / style_.bassPerBar * 1.3, 3.0), 0.012,
                      2.6 * style_.bassPerBar / 2.0, 0.17 * style_.bassGain, 2, 0.4);
        }
    }

    /// Hammers and valves.
    void rhythm(Loop& loop, double start) {
        for (int n = 0; n < beatsPerBar * 2; ++n) {
            const double at = start + style_.beat * 0.5 * n;
            if (n % 4 == 2) loop.note(at, 310, 0.3, 0.001, 14, 0.10, 2.7, 0.8);
            loop.hiss(at, n % 2 == 0 ? 0.05 : 0.11, 0.9, 0.10 * style_.noiseGain, dice_);
            if (n % 4 == 0) loop.note(at, 52, 0.3, 0.002, 11, 0.34);
        }
    }

    /// A heart that beats, and two notes that do not agree.
    void fright(Loop& loop, double start, int root) {
        for (int n = 0; n < beatsPerBar; ++n) {
            const double at = start + style_.beat * n;
            loop.note(at, 58, 0.28, 0.003, 13, 0.5);
            loop.note(at + style_.beat * 0.3, 52, 0.26, 0.003, 15, 0.34);
        }
        for (int n = 0; n < beatsPerBar * 4; ++n) {
            const double at = start + style_.beat * 0.25 * n;
            const int semitone = n % 2 == 0 ? 0 : 1;
            loop.note(at, pitch(root + 24 + semitone), style_.beat * 0.3, 0.01, 7, 0.075, 3, 0.3);
        }
    }

    Style style_;
    double bar_;
    Dice dice_;
    int last_ = 4;
};

}  // namespace

Score compose(Theme::World world, std::uint32_t seed) {
    return Composer(world, seed).compose();
}

}  // namespace quaoar
