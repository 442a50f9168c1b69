#include <quaoar/view/recipes.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "dice.hpp"

namespace quaoar {
namespace {

constexpr double turn = 6.283185307179586;

/// Renders `seconds` of a function of time in seconds, with a short fade at both ends so that
/// nothing clicks.
std::vector<float> render(double seconds, const std::function<double(double)>& wave) {
    const auto count = static_cast<std::size_t>(seconds * soundRate);
    std::vector<float> samples(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / soundRate;
        const double edge = std::min({1.0, t / 0.002, (seconds - t) / 0.01});
        samples[i] = static_cast<float>(std::clamp(edge * wave(t), -1.0, 1.0));
    }
    return samples;
}

double fall(double t, double perSecond) {
    return std::exp(-t * perSecond);
}

/// White noise behind a low pass: `smooth` 1 lets all of it through.
class Noise {
public:
    Noise(std::uint32_t seed, double smooth) : dice_(seed), smooth_(smooth) {}
    double next() {
        low_ += smooth_ * (static_cast<double>(dice_.between(-1, 1)) - low_);
        return low_;
    }

private:
    Dice dice_;
    double smooth_;
    double low_ = 0;
};

/// A tone whose pitch may change: the phase goes on without a jump.
class Tone {
public:
    double next(double hertz) {
        phase_ += turn * hertz / soundRate;
        return std::sin(phase_);
    }

private:
    double phase_ = 0;
};

std::vector<float> shoot() {
    Noise air(3, 0.25);
    Tone tone;
    return render(0.22, [&](double t) {
        return 0.28 * tone.next(260 + 900 * fall(t, 18)) * fall(t, 16) +
               0.5 * air.next() * fall(t, 22);
    });
}

/// A disappointed fall, and the cord that slaps together.
std::vector<float> miss() {
    Noise air(21, 0.12);
    Tone tone;
    return render(0.5, [&](double t) {
        const double whistle = 0.22 * tone.next(520 - 620 * t) * fall(t, 5);
        const double slap = t > 0.16 ? fall(t - 0.16, 26) * std::sin(turn * 120 * t) : 0;
        return whistle + 0.4 * slap + 1.1 * air.next() * fall(std::abs(t - 0.17), 22);
    });
}

std::vector<float> release() {
    Tone tone;
    return render(0.24, [&](double t) {
        const double a = tone.next(190 + 260 * fall(t, 9) + 18 * std::sin(turn * 31 * t));
        return 0.34 * a * (1 + 0.3 * a) * fall(t, 15);
    });
}

std::vector<float> slip() {
    return render(0.16, [](double t) {
        return 0.3 * (std::sin(turn * (2400 - 6000 * t) * t) + 0.5 * std::sin(turn * 3310 * t)) *
               fall(t, 30);
    });
}

/// A string that is cut: a crack and a tone that drops.
std::vector<float> cut() {
    Noise crack(31, 0.8);
    Tone tone;
    return render(0.4, [&](double t) {
        return 0.8 * crack.next() * fall(t, 90) +
               0.4 * tone.next(700 * fall(t, 5) + 60) * fall(t, 9);
    });
}

/// What is hit sounds by the frequencies and the decays of its material.
std::vector<float> struck(double seconds, double body, double bodyFall, double ring,
                          double ringFall, double grit, double gritFall, std::uint32_t seed) {
    Noise noise(seed, 0.45);
    return render(seconds, [&](double t) {
        const double low = std::sin(turn * (body - 0.25 * body * t) * t) * fall(t, bodyFall);
        const double high =
            (0.5 * std::sin(turn * ring * t) + 0.3 * std::sin(turn * ring * 1.66 * t) +
             0.2 * std::sin(turn * ring * 2.71 * t)) *
            fall(t, ringFall);
        return 0.55 * low + (ring > 0 ? 0.34 * high : 0) + grit * noise.next() * fall(t, gritFall);
    });
}

/// Wet: a tone that rises and wobbles.
std::vector<float> squelch(double from, double to, double seconds, std::uint32_t seed) {
    Noise wet(seed, 0.09);
    Tone tone;
    return render(seconds, [&](double t) {
        const double part = t / seconds;
        const double wobble = 1 + 0.12 * std::sin(turn * 24 * t);
        return 0.45 * tone.next((from + (to - from) * part) * wobble) * fall(t, 9) +
               1.0 * wet.next() * fall(t, 14);
    });
}

std::vector<float> snap() {
    Noise crack(41, 0.9), chips(42, 0.5);
    return render(0.35, [&](double t) {
        const double tick = std::fmod(t, 0.045) < 0.006 ? 1.0 : 0.15;
        return 0.85 * crack.next() * fall(t, 70) + 0.4 * chips.next() * tick * fall(t, 12) +
               0.35 * std::sin(turn * 210 * t) * fall(t, 28);
    });
}

std::vector<float> crumble() {
    Noise rubble(51, 0.14);
    Dice dice(52);
    double grain = 0;
    return render(0.9, [&](double t) {
        if (dice.unit() < 0.002f) grain = 1;
        grain *= 0.996;
        return 1.7 * rubble.next() * (0.35 + grain) * fall(t, 3.5) +
               0.3 * std::sin(turn * 62 * t) * fall(t, 5);
    });
}

/// Notes one after the other, each a bell.
std::vector<float> bells(double seconds, const std::vector<double>& notes, double apart,
                         double decay, double gain) {
    return render(seconds, [&](double t) {
        double sum = 0;
        for (std::size_t n = 0; n < notes.size(); ++n) {
            const double since = t - apart * static_cast<double>(n);
            if (since < 0) break;
            sum += (std::sin(turn * notes[n] * since) +
                    0.4 * std::sin(turn * 2.76 * notes[n] * since) * fall(since, 6)) *
                   fall(since, decay);
        }
        return gain * sum;
    });
}

/// A growl that asks a question.
std::vector<float> notice() {
    Tone a, b;
    return render(0.5, [&](double t) {
        const double pitch = 85 + 130 * t;
        const double rough = 0.6 + 0.4 * std::sin(turn * 34 * t);
        return 0.42 * (a.next(pitch) + 0.6 * b.next(pitch * 1.51)) * rough * std::min(1.0, t * 14) *
               fall(t, 4);
    });
}

std::vector<float> defeat() {
    Noise air(61, 0.2);
    Tone tone;
    return render(0.9, [&](double t) {
        return 0.4 * tone.next(420 * fall(t, 2.6) + 40) * (0.7 + 0.3 * std::sin(turn * 13 * t)) *
                   fall(t, 2.8) +
               0.5 * air.next() * fall(t, 7);
    });
}

std::vector<float> die() {
    Noise burst(71, 0.3);
    Tone tone;
    return render(0.6, [&](double t) {
        return 0.42 * tone.next(560 * fall(t, 4) + 70) * fall(t, 5) +
               0.7 * burst.next() * fall(t, 16);
    });
}

/// The last part runs into the first, so that a loop has no seam.
std::vector<float> seamless(std::vector<float> samples) {
    constexpr std::size_t seam = 2000;
    for (std::size_t i = 0; i < seam; ++i) {
        const float part = static_cast<float>(i) / seam;
        float& end = samples[samples.size() - seam + i];
        end = end * (1 - part) + samples[i] * part;
    }
    samples.erase(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(seam));
    return samples;
}

}  // namespace

std::vector<float> recipeOf(Effect effect) {
    switch (effect) {
        case Effect::shoot:
            return shoot();
        case Effect::miss:
            return miss();
        case Effect::release:
            return release();
        case Effect::slip:
            return slip();
        case Effect::cut:
            return cut();
        case Effect::stickIce:
            return struck(0.25, 170, 30, 1270, 24, 0.5, 90, 5);
        case Effect::stickMetal:
            return struck(0.6, 240, 20, 870, 7, 0.35, 120, 6);
        case Effect::stickRock:
            return struck(0.2, 130, 26, 0, 1, 0.9, 40, 8);
        case Effect::stickSoft:
            return squelch(150, 420, 0.25, 9);
        case Effect::bumpIce:
            return struck(0.3, 95, 16, 640, 30, 0.8, 34, 7);
        case Effect::bumpMetal:
            return struck(0.7, 120, 12, 430, 6, 0.3, 60, 11);
        case Effect::bumpRock:
            return struck(0.3, 74, 14, 0, 1, 1.3, 26, 12);
        case Effect::bumpSoft:
            return squelch(210, 110, 0.34, 13);
        case Effect::snap:
            return snap();
        case Effect::crumble:
            return crumble();
        case Effect::switched:
            return struck(0.3, 320, 40, 1500, 26, 0.4, 120, 14);
        case Effect::checkpoint:
            return bells(1.4, {523.25, 783.99, 1046.5}, 0.09, 3, 0.2);
        case Effect::pickup:
            return bells(0.8, {1174.7, 1568.0, 2349.3}, 0.055, 6, 0.2);
        case Effect::notice:
            return notice();
        case Effect::defeat:
            return defeat();
        case Effect::die:
            return die();
        case Effect::finish:
            return bells(2.2, {392.0, 493.88, 587.33, 783.99, 987.77}, 0.11, 2.6, 0.16);
        case Effect::restart:
            return render(0.2, [](double t) {
                return 0.22 * std::sin(turn * (300 + 1500 * t) * t) * fall(t, 10);
            });
        case Effect::click:
            break;
    }
    return render(0.06, [](double t) { return 0.3 * std::sin(turn * 880 * t) * fall(t, 60); });
}

std::vector<float> creakLoop() {
    Dice dice(11);
    double band = 0, slow = 0, grain = 0;
    std::vector<float> samples(soundRate);
    for (float& sample : samples) {
        if (dice.unit() < 0.0016f) grain = static_cast<double>(dice.between(0.4f, 1));
        grain *= 0.9975;
        const double noise = static_cast<double>(dice.between(-1, 1)) * grain;
        slow += 0.045 * (band);
        band += 0.045 * (noise - slow - 0.25 * band);
        sample = static_cast<float>(std::clamp(2.2 * band, -1.0, 1.0));
    }
    return seamless(std::move(samples));
}

std::vector<float> humLoop() {
    std::vector<float> samples(soundRate);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double t = static_cast<double>(i) / soundRate;
        // Whole turns a second: the end meets the beginning.
        const double beat = 0.75 + 0.25 * std::sin(turn * 6 * t);
        samples[i] = static_cast<float>(0.3 * beat *
                                        (std::sin(turn * 196 * t) + 0.5 * std::sin(turn * 393 * t) +
                                         0.25 * std::sin(turn * 787 * t)));
    }
    return samples;
}

}  // namespace quaoar
