#include "measurement.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::BodyKind;
using sulfur::ContactInfo;
using sulfur::JointId;
using sulfur::ParticleId;
using sulfur::Point;
using sulfur::World;
using Value = std::optional<double>;

// What is pinned has no part in energies, as in World::energy().
Value kineticEnergy(const World& world, BodyId body) {
    double sum = 0;
    for (const ParticleId particle : world.particles(body)) {
        const auto info = world.info(particle);
        if (info.pinned) continue;
        sum +=
            0.5 * static_cast<double>(info.mass) * static_cast<double>(info.velocity.squaredNorm());
    }
    return sum;
}

// Where a particle was `before` seconds ago, in a straight line.
Point placeBefore(const World& world, ParticleId particle, double before) {
    return world.position(particle) - before * world.velocity(particle).cast<double>();
}

double heightEnergyBefore(const World& world, BodyId body, double before) {
    const Point g = world.gravity().cast<double>();
    double sum = 0;
    for (const ParticleId particle : world.particles(body)) {
        const auto info = world.info(particle);
        if (!info.pinned)
            sum -= static_cast<double>(info.mass) * g.dot(placeBefore(world, particle, before));
    }
    return sum;
}

double elasticEnergyBefore(const World& world, BodyId body, double before) {
    double sum = 0;
    for (const JointId joint : world.joints(body)) {
        const auto info = world.info(joint);
        if (!std::isfinite(info.stiffness)) continue;
        const Point edge = placeBefore(world, info.a, before) - placeBefore(world, info.b, before);
        const double stretch = edge.norm() - static_cast<double>(info.restLength);
        sum += 0.5 * static_cast<double>(info.stiffness) * stretch * stretch;
    }
    return sum;
}

Value heightEnergy(const World& world, BodyId body) {
    return heightEnergyBefore(world, body, 0);
}

Value elasticEnergy(const World& world, BodyId body) {
    return elasticEnergyBefore(world, body, 0);
}

// At the time of the velocities, which is the middle of the last step: else what swings seems to
// gain and lose energy.
Value wholeEnergy(const World& world, BodyId body) {
    // Rates are whole numbers; a duration as a float is not quite one over them.
    const double rate = std::round(1 / static_cast<double>(world.tickDuration()));
    const double before = 1 / rate / std::ceil(480 / rate) / 2;
    return *kineticEnergy(world, body) + heightEnergyBefore(world, body, before) +
           elasticEnergyBefore(world, body, before);
}

Value momentum(const World& world, BodyId body, int axis) {
    return static_cast<double>(world.mass(body)) *
           static_cast<double>(world.meanVelocity(body)[axis]);
}

// Of all joints the value that is farthest from 0.
Value farthestOfJoints(const World& world, BodyId body,
                       double (*of)(const World&, const sulfur::JointInfo&)) {
    Value most;
    for (const JointId joint : world.joints(body)) {
        const double value = of(world, world.info(joint));
        if (!most || std::abs(value) > std::abs(*most)) most = value;
    }
    return most;
}

// What others push on it, along and across their normals: the sum of all.
Value contactForce(const World& world, BodyId body) {
    std::array<ContactInfo, 64> contacts;
    const std::size_t count = std::min(world.contacts(body, contacts), contacts.size());
    Point sum(0, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const ContactInfo& contact = contacts[i];
        if (contact.a == contact.b) continue;
        const Point normal = contact.normal.cast<double>();
        const Point push = static_cast<double>(contact.impulse) * normal +
                           static_cast<double>(contact.friction) * Point(-normal.y(), normal.x());
        sum += contact.a == body ? push : Point(-push);
    }
    return sum.norm() / static_cast<double>(world.tickDuration());
}

constexpr std::array<Quantity, 16> table{{
    {"height", "Height", "m", "Of the centre of mass",
     [](const World& w, BodyId b) -> Value { return w.centreOfMass(b).y(); }},
    {"x", "Horizontal place", "m", "Of the centre of mass",
     [](const World& w, BodyId b) -> Value { return w.centreOfMass(b).x(); }},
    {"angle", "Angle", "\xC2\xB0", "Anticlockwise, counted on beyond half a turn",
     [](const World& w, BodyId b) -> Value { return w.angle(b) * 180 / std::numbers::pi; }, false,
     true},
    {"speed", "Speed", "m/s", "Of the centre of mass",
     [](const World& w, BodyId b) -> Value {
         return static_cast<double>(w.meanVelocity(b).norm());
     }},
    {"velocity-x", "Horizontal velocity", "m/s", "Of the centre of mass",
     [](const World& w, BodyId b) -> Value { return static_cast<double>(w.meanVelocity(b).x()); }},
    {"velocity-y", "Vertical velocity", "m/s", "Of the centre of mass",
     [](const World& w, BodyId b) -> Value { return static_cast<double>(w.meanVelocity(b).y()); }},
    {"spin", "Angular velocity", "rad/s", "Anticlockwise",
     [](const World& w, BodyId b) -> Value { return w.angularVelocity(b); }},
    {"energy", "Energy", "J", "Of motion, height and springs together", wholeEnergy, true},
    {"kinetic", "Energy of motion", "J", "Of all particles", kineticEnergy, true},
    {"potential", "Energy of height", "J", "Over a height of 0", heightEnergy, true},
    {"elastic", "Energy of springs", "J", "Of its own elastic joints", elasticEnergy, true},
    {"momentum-x", "Horizontal momentum", "N s", "Mass times velocity",
     [](const World& w, BodyId b) { return momentum(w, b, 0); }, true},
    {"momentum-y", "Vertical momentum", "N s", "Mass times velocity",
     [](const World& w, BodyId b) { return momentum(w, b, 1); }, true},
    {"joint-force", "Force of a joint", "N", "Of its joint with the largest; above 0 it pulls",
     [](const World& w, BodyId b) {
         return farthestOfJoints(w, b, [](const World&, const sulfur::JointInfo& joint) {
             return static_cast<double>(joint.force);
         });
     }},
    {"strain", "Strain of a joint", "%", "Of its joint with the largest; above 0 it is stretched",
     [](const World& w, BodyId b) { return farthestOfJoints(w, b, strainOf); }},
    {"contact-force", "Contact force", "N", "Sum of what others push on it", contactForce},
}};

Value sumOver(const World& world, const Quantity& what) {
    if (!what.adds) return std::nullopt;
    double sum = 0;
    for (const BodyId body : world.bodies())
        if (world.kind(body) == BodyKind::dynamic) sum += what.get(world, body).value_or(0);
    return sum;
}

// A body with another handle, after undo or rewinding.
BodyId bodyWith(const World& world, std::uint64_t userData) {
    if (userData == 0) return {};
    for (const BodyId body : world.bodies())
        if (world.userData(body) == userData) return body;
    return {};
}

// The least squares of a sine of one frequency: mean + a cos + b sin.
struct Sinusoid {
    Eigen::Vector3d weights{0, 0, 0};
    double squares = 0;  // of what is left
};

Sinusoid project(std::span<const Sample> samples, double frequency, double middle) {
    const double omega = 2 * std::numbers::pi * frequency;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double all = 0;
    for (const Sample& one : samples) {
        const double phase = omega * (one.time - middle);
        const Eigen::Vector3d row(1, std::cos(phase), std::sin(phase));
        normal += row * row.transpose();
        right += one.value * row;
        all += one.value * one.value;
    }
    Sinusoid fit;
    fit.weights = normal.ldlt().solve(right);
    fit.squares = std::max(0.0, all - fit.weights.dot(right));
    return fit;
}

std::vector<Sample> thinned(std::span<const Sample> samples, std::size_t most) {
    const std::size_t step = std::max<std::size_t>(1, (samples.size() + most - 1) / most);
    std::vector<Sample> some;
    for (std::size_t i = 0; i < samples.size(); i += step) some.push_back(samples[i]);
    return some;
}

// The frequency in an interval that leaves the least, by golden section.
double bestWithin(std::span<const Sample> samples, double low, double high, double middle) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    const auto left = [&](double f) { return project(samples, f, middle).squares; };
    double a = high - golden * (high - low);
    double b = low + golden * (high - low);
    double atA = left(a);
    double atB = left(b);
    for (int i = 0; i < 40; ++i) {
        if (atA < atB) {
            high = std::exchange(b, a);
            atB = atA;
            a = high - golden * (high - low);
            atA = left(a);
        } else {
            low = std::exchange(a, b);
            atA = atB;
            b = low + golden * (high - low);
            atB = left(b);
        }
    }
    return (low + high) / 2;
}

// A field of a table, quoted where it needs to be.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

std::string shortest(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.9g", value);
    return text.data();
}

}  // namespace

double strainOf(const World& world, const sulfur::JointInfo& joint) {
    const double rest = std::max(1e-9, static_cast<double>(joint.restLength));
    return ((world.position(joint.a) - world.position(joint.b)).norm() / rest - 1) * 100;
}

std::span<const Quantity> quantities() {
    return table;
}

const Quantity* quantity(std::string_view key) {
    for (const Quantity& one : table)
        if (one.key == key) return &one;
    return nullptr;
}

std::string Series::title() const {
    return tr("{} of {}", {tr(std::string(quantity->name)), tr(subject)});
}

// --- recording -------------------------------------------------------------------------------

void Measurements::watch(std::span<const Subject> subjects,
                         std::span<const Quantity* const> quantities) {
    std::vector<Series> next;
    const auto add = [&](Series one, const std::vector<Sample>* known) {
        if (next.size() == mostSeries) return;
        if (known != nullptr) one.samples = *known;
        for (Series& old : series_)
            if (old.quantity == one.quantity && old.body == one.body &&
                old.userData == one.userData && old.meter == one.meter && known == nullptr)
                one.samples = std::move(old.samples);
        next.push_back(std::move(one));
    };
    for (const Subject& subject : subjects) {
        for (const Series& reading : subject.record)
            add({{}, 0, subject.name, reading.quantity, {}, subject.meter}, &reading.samples);
        if (!subject.meter.empty()) continue;
        for (const Quantity* what : quantities)
            if (subject.body || what->adds)
                add({subject.body, subject.userData, subject.name, what, {}}, nullptr);
    }
    series_ = std::move(next);
}

void Measurements::clear() {
    for (Series& one : series_) one.samples.clear();
}

void addSample(Series& series, double time, std::optional<double> value) {
    auto& samples = series.samples;
    const auto later =
        std::lower_bound(samples.begin(), samples.end(), time,
                         [](const Sample& sample, double t) { return sample.time < t; });
    samples.erase(later, samples.end());
    if (!value || !std::isfinite(*value)) return;
    if (series.quantity->turns && !samples.empty())
        *value += 360 * std::round((samples.back().value - *value) / 360);
    samples.push_back({time, *value});
    // A tenth at once: that costs little.
    if (samples.size() > Measurements::mostSamples)
        samples.erase(samples.begin(), samples.begin() + Measurements::mostSamples / 10);
}

void Measurements::sample(const World& world, const MeterReader& meters) {
    const double time = world.time();
    for (Series& one : series_) {
        if (!one.meter.empty()) {
            if (meters) addSample(one, time, meters(one.meter, *one.quantity));
            continue;
        }
        const bool scene = !one.body && one.userData == 0;
        if (!scene && (!world.contains(one.body) || world.userData(one.body) != one.userData)) {
            const BodyId now = bodyWith(world, one.userData);
            if (!now) continue;
            one.body = now;
        }
        addSample(one, time,
                  scene ? sumOver(world, *one.quantity) : one.quantity->get(world, one.body));
    }
}

// --- reading ---------------------------------------------------------------------------------

std::span<const Sample> between(std::span<const Sample> samples, double from, double to) {
    const auto low = std::lower_bound(samples.begin(), samples.end(), from,
                                      [](const Sample& s, double t) { return s.time < t; });
    const auto high = std::upper_bound(low, samples.end(), to,
                                       [](double t, const Sample& s) { return t < s.time; });
    return {low, high};
}

std::optional<Sample> nearest(std::span<const Sample> samples, double time) {
    if (samples.empty()) return std::nullopt;
    const auto next = std::lower_bound(samples.begin(), samples.end(), time,
                                       [](const Sample& s, double t) { return s.time < t; });
    if (next == samples.end()) return samples.back();
    if (next == samples.begin()) return *next;
    const Sample& before = *(next - 1);
    return time - before.time < next->time - time ? before : *next;
}

double mean(std::span<const Sample> samples) {
    double sum = 0;
    for (const Sample& one : samples) sum += one.value;
    return samples.empty() ? 0 : sum / static_cast<double>(samples.size());
}

std::optional<LineFit> fitLine(std::span<const Sample> samples) {
    if (samples.size() < 2) return std::nullopt;
    const auto n = static_cast<double>(samples.size());
    LineFit fit;
    fit.value = mean(samples);
    for (const Sample& one : samples) fit.time += one.time / n;
    double tt = 0;
    double ty = 0;
    for (const Sample& one : samples) {
        tt += (one.time - fit.time) * (one.time - fit.time);
        ty += (one.time - fit.time) * (one.value - fit.value);
    }
    if (!(tt > 0)) return std::nullopt;
    fit.slope = ty / tt;
    double squares = 0;
    for (const Sample& one : samples) squares += std::pow(one.value - fit.at(one.time), 2);
    fit.deviation = std::sqrt(squares / n);
    return fit;
}

double SineFit::at(double t) const {
    return mean + amplitude * std::sin(2 * std::numbers::pi * frequency * t + phase);
}

std::optional<SineFit> fitSine(std::span<const Sample> samples) {
    if (samples.size() < 8) return std::nullopt;
    const double duration = samples.back().time - samples.front().time;
    if (!(duration > 0)) return std::nullopt;
    const double middle = (samples.front().time + samples.back().time) / 2;
    // A search over all frequencies on few samples, then the exact one on many.
    const auto few = thinned(samples, 500);
    const auto many = thinned(samples, 4000);
    const double step = 0.5 / duration;
    double best = 0;
    double least = 0;
    for (std::size_t i = 1; i < few.size(); ++i) {
        const double squares = project(few, step * static_cast<double>(i), middle).squares;
        if (best > 0 && squares >= least) continue;
        least = squares;
        best = step * static_cast<double>(i);
    }
    SineFit fit;
    fit.frequency = bestWithin(many, std::max(0.5 * step, best - step), best + step, middle);
    const Sinusoid found = project(many, fit.frequency, middle);
    fit.mean = found.weights[0];
    fit.amplitude = std::hypot(found.weights[1], found.weights[2]);
    if (!(fit.amplitude > 0) || !std::isfinite(fit.amplitude)) return std::nullopt;
    const double turns = std::atan2(found.weights[1], found.weights[2]) -
                         2 * std::numbers::pi * fit.frequency * middle;
    fit.phase = std::remainder(turns, 2 * std::numbers::pi);
    fit.deviation = std::sqrt(found.squares / static_cast<double>(many.size()));
    return fit;
}

std::string csv(std::span<const Series> series) {
    std::string text = "time/s";
    std::vector<double> times;
    for (const Series& one : series) {
        const std::string unit(one.quantity->unit);
        text += "," + quoted(one.title() + (unit.empty() ? "" : "/" + unit));
        for (const Sample& sample : one.samples) times.push_back(sample.time);
    }
    text += "\n";
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    std::vector<std::size_t> next(series.size(), 0);
    for (const double time : times) {
        text += shortest(time);
        for (std::size_t i = 0; i < series.size(); ++i) {
            const auto& samples = series[i].samples;
            text += ",";
            if (next[i] < samples.size() && samples[next[i]].time == time)
                text += shortest(samples[next[i]++].value);
        }
        text += "\n";
    }
    return text;
}

}  // namespace sulfurchamber
