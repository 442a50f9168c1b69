// Measuring: quantities of bodies over time, and what can be read from them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sulfur/world.hpp>
#include <vector>

namespace sulfurchamber {

/// Something that a body has at any moment.
struct Quantity {
    std::string_view key;   ///< for scripts and menus: "height"
    std::string_view name;  ///< for people
    std::string_view unit;  ///< UTF-8, "" for none
    std::string_view help;  ///< one line
    /// Nothing where it means nothing, such as the strain of a body without joints. Null for what a
    /// meter tells.
    std::optional<double> (*get)(const sulfur::World&, sulfur::BodyId) = nullptr;
    bool adds = false;   ///< whether that of a scene is the sum of those of what moves
    bool turns = false;  ///< an angle, which goes on beyond half a turn
};

/// Heights, speeds, energies, momenta, angles, and the forces of joints and contacts.
std::span<const Quantity> quantities();
/// Null when there is none of this key.
const Quantity* quantity(std::string_view key);

/// %, by how much a joint is longer than at rest.
double strainOf(const sulfur::World& world, const sulfur::JointInfo& joint);

struct Sample {
    double time = 0;  ///< s
    double value = 0;
};

/// A quantity of one body, of a meter or of the whole scene, over time.
struct Series {
    sulfur::BodyId body;         ///< null: the scene, or a meter
    std::uint64_t userData = 0;  ///< by which it is found again when it has another handle
    std::string subject;         ///< what people call it
    const Quantity* quantity = nullptr;
    std::vector<Sample> samples;
    std::string meter = {};  ///< id of a meter; empty: of a body or of the scene
    /// "height of box".
    std::string title() const;
};

/// Records what is watched, a sample each tick.
///
/// Where time has been rewound, samples from there on are replaced as it goes on. Sixty thousand of
/// each series are kept. One thread.
class Measurements {
public:
    static constexpr std::size_t mostSeries = 12;
    static constexpr std::size_t mostSamples = 60'000;

    struct Subject {
        sulfur::BodyId body;  ///< null: the scene, or a meter
        std::uint64_t userData = 0;
        std::string name;
        std::string meter = {};               ///< id of a meter
        std::span<const Series> record = {};  ///< what that has shown: it is plotted from there on
    };
    /// What the first reading, or another one, of a meter is now.
    using MeterReader =
        std::function<std::optional<double>(const std::string& meter, const Quantity& reading)>;
    /// Watches these quantities of these subjects from now on. What was watched already keeps its
    /// samples. No more than mostSeries. Of meters all readings are watched.
    void watch(std::span<const Subject> subjects, std::span<const Quantity* const> quantities);
    /// Forgets all samples; what is watched stays.
    void clear();
    /// Takes a sample of each; those of meters are told by `meters`.
    void sample(const sulfur::World& world, const MeterReader& meters = {});
    const std::vector<Series>& series() const { return series_; }

private:
    std::vector<Series> series_;
};

/// Adds a sample in place of all that are as late or later. What is nothing or not finite is left
/// out; angles go on beyond half a turn.
void addSample(Series& series, double time, std::optional<double> value);

/// The part of samples within a time, both ends with it.
std::span<const Sample> between(std::span<const Sample> samples, double from, double to);
/// The one nearest in time. Nothing where there is none.
std::optional<Sample> nearest(std::span<const Sample> samples, double time);

/// Mean over time.
double mean(std::span<const Sample> samples);
/// y = value + slope (t - time), by least squares.
struct LineFit {
    double time = 0;  ///< middle of the samples
    double value = 0;
    double slope = 0;
    double deviation = 0;  ///< root of the mean square of what is left
    double at(double t) const { return value + slope * (t - time); }
};
/// Nothing with fewer than two moments.
std::optional<LineFit> fitLine(std::span<const Sample> samples);
/// y = mean + amplitude sin(2 pi frequency t + phase), by least squares.
struct SineFit {
    double mean = 0;
    double amplitude = 0;
    double frequency = 0;  ///< Hz
    double phase = 0;      ///< rad
    double deviation = 0;
    double at(double t) const;
};
/// Nothing with fewer than eight samples or where nothing varies. Frequencies from half a period
/// in the time up to 250 periods are found.
std::optional<SineFit> fitSine(std::span<const Sample> samples);

/// A table with a head: the time, then a column for each series, separated by commas.
std::string csv(std::span<const Series> series);

}  // namespace sulfurchamber
