#include <algorithm>
#include <cmath>
#include <functional>
#include <quaoar/view/sounds.hpp>
#include <vector>

#include "dice.hpp"

namespace quaoar {
namespace {

constexpr int rate = 44100;
constexpr double turn = 6.283185307179586;

/// Renders `seconds` of a function of time in seconds, with a short fade at both ends so that
/// nothing clicks.
std::vector<float> render(double seconds, const std::function<double(double)>& wave) {
    const auto count = static_cast<std::size_t>(seconds * rate);
    std::vector<float> samples(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / rate;
        const double edge = std::min({1.0, t / 0.002, (seconds - t) / 0.01});
        samples[i] = static_cast<float>(edge * wave(t));
    }
    return samples;
}

double fall(double t, double perSecond) {
    return std::exp(-t * perSecond);
}

std::vector<float> shootRecipe() {
    Dice dice(3);
    double phase = 0, low = 0;
    return render(0.22, [&](double t) {
        phase += turn * (260 + 900 * fall(t, 18)) / rate;
        low += 0.25 * (static_cast<double>(dice.between(-1, 1)) - low);
        return 0.28 * std::sin(phase) * fall(t, 16) + 0.5 * low * fall(t, 22);
    });
}

std::vector<float> stickRecipe() {
    Dice dice(5);
    double low = 0;
    return render(0.25, [&](double t) {
        low += 0.5 * (static_cast<double>(dice.between(-1, 1)) - low);
        const double body = std::sin(turn * 170 * t) * fall(t, 30);
        const double ring = 0.3 * std::sin(turn * 1270 * t) + 0.2 * std::sin(turn * 2110 * t);
        return 0.6 * body + 0.5 * low * fall(t, 90) + ring * fall(t, 24) * 0.5;
    });
}

std::vector<float> slipRecipe() {
    return render(0.16, [](double t) {
        return 0.3 * (std::sin(turn * (2400 - 6000 * t) * t) + 0.5 * std::sin(turn * 3310 * t)) *
               fall(t, 30);
    });
}

std::vector<float> releaseRecipe() {
    double phase = 0;
    return render(0.24, [&](double t) {
        phase += turn * (190 + 260 * fall(t, 9) + 18 * std::sin(turn * 31 * t)) / rate;
        return 0.33 * (std::sin(phase) + 0.35 * std::sin(2 * phase)) * fall(t, 15);
    });
}

std::vector<float> bumpRecipe() {
    Dice dice(7);
    double low = 0;
    return render(0.3, [&](double t) {
        low += 0.08 * (static_cast<double>(dice.between(-1, 1)) - low);
        return 0.8 * std::sin(turn * (95 - 110 * t) * t) * fall(t, 16) + 1.2 * low * fall(t, 30);
    });
}

/// A rising chord of bells.
std::vector<float> finishRecipe() {
    constexpr double notes[] = {392.0, 493.88, 587.33, 783.99, 987.77};
    return render(2.2, [&](double t) {
        double sum = 0;
        for (int n = 0; n < 5; ++n) {
            const double since = t - 0.11 * n;
            if (since < 0) break;
            const double f = notes[n];
            sum += (std::sin(turn * f * since) +
                    0.4 * std::sin(turn * 2.76 * f * since) * fall(since, 6)) *
                   fall(since, 2.6);
        }
        return 0.16 * sum;
    });
}

/// A loop of one second: grains of filtered noise, like a taut cord under load.
std::vector<float> creakRecipe() {
    Dice dice(11);
    double band = 0, slow = 0, grain = 0;
    std::vector<float> samples(rate);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (dice.unit() < 0.0016f) grain = static_cast<double>(dice.between(0.4f, 1));
        grain *= 0.9975;
        const double noise = static_cast<double>(dice.between(-1, 1)) * grain;
        slow += 0.045 * (band);
        band += 0.045 * (noise - slow - 0.25 * band);
        samples[i] = static_cast<float>(std::clamp(2.2 * band, -1.0, 1.0));
    }
    constexpr std::size_t seam = 2000;
    for (std::size_t i = 0; i < seam; ++i) {
        const float part = static_cast<float>(i) / seam;
        float& end = samples[samples.size() - seam + i];
        end = end * (1 - part) + samples[i] * part;
    }
    // The end now runs into what follows the faded beginning.
    samples.erase(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(seam));
    return samples;
}

std::vector<float> clickRecipe() {
    return render(0.06, [](double t) { return 0.3 * std::sin(turn * 880 * t) * fall(t, 60); });
}

std::vector<float> restartRecipe() {
    return render(
        0.2, [](double t) { return 0.22 * std::sin(turn * (300 + 1500 * t) * t) * fall(t, 10); });
}

}  // namespace

Sounds::Sounds(atlax::Audio& audio) : audio_(audio) {
    const auto make = [&](const std::vector<float>& samples) {
        return audio_.createSound(samples, rate);
    };
    shoot_ = make(shootRecipe());
    stick_ = make(stickRecipe());
    slip_ = make(slipRecipe());
    release_ = make(releaseRecipe());
    bump_ = make(bumpRecipe());
    finish_ = make(finishRecipe());
    creak_ = make(creakRecipe());
    click_ = make(clickRecipe());
    restart_ = make(restartRecipe());
}

void Sounds::tick(const Session& session) {
    const TickEvents& events = session.events();
    if (events.fired) audio_.play(shoot_, {.gain = 0.7f});
    if (events.stuck) audio_.play(stick_, {.gain = 0.9f});
    if (events.slipped) audio_.play(slip_, {.gain = 0.8f});
    if (events.released) audio_.play(release_, {.gain = 0.6f});
    if (events.restarted) audio_.play(restart_, {.gain = 0.7f});
    if (events.finished) audio_.play(finish_, {.gain = 1});
    if (bumpRest_ > 0) --bumpRest_;
    if (events.impact > 1 && bumpRest_ == 0) {
        bumpRest_ = 40;
        audio_.play(bump_, {.gain = std::min(1.0f, 0.12f * events.impact),
                            .pitch = std::max(0.7f, 1.3f - 0.06f * events.impact)});
    }
    if (--followRest_ <= 0) follow(session);
}

/// The creak follows tension and, more than that, its change: 50 times a second is enough.
void Sounds::follow(const Session& session) {
    followRest_ = 10;
    const double tension = std::max(0.0, session.rope().tension(session.world()));
    const double change = std::abs(tension - lastTension_);
    lastTension_ = tension;
    const double goal = std::min(1.0, tension / 220 + change / 40);
    strain_ += 0.2f * (static_cast<float>(goal) - strain_);
    if (session.rope().state() != Rope::State::attached || strain_ < 0.01f) {
        audio_.stop(creakVoice_);
        creakVoice_ = {};
        return;
    }
    if (!audio_.playing(creakVoice_)) {
        creakVoice_ = audio_.play(creak_, {.gain = 0, .loop = true});
    }
    audio_.setGain(creakVoice_, 0.9f * strain_);
    audio_.setPitch(creakVoice_, 0.7f + 0.8f * strain_);
}

void Sounds::hush() {
    audio_.stop(creakVoice_);
    creakVoice_ = {};
    strain_ = 0;
}

void Sounds::click() {
    audio_.play(click_, {.gain = 0.6f, .bus = atlax::Bus::Interface});
}

}  // namespace quaoar
