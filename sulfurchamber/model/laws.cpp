#include "laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measurement.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::World;
using LawBodies = std::span<const BodyId>;
using LawNotes = std::span<const Textbook::Note>;
using LawNumbers = std::span<const double>;

constexpr double degreeOf = 180 / std::numbers::pi;

double gravityOf(const World& world) {
    return static_cast<double>(world.gravity().norm());
}

Point downOf(const World& world) {
    const Point g = world.gravity().cast<double>();
    return g.norm() > 0 ? Point(g.normalized()) : Point(0, -1);
}

double joint(const World& world, BodyId body, sulfur::Real sulfur::JointInfo::*what) {
    return static_cast<double>(world.info(world.joints(body)[0]).*what);
}

// From the pinned particle to the other one.
Point armOf(const World& world, BodyId body) {
    const auto particles = world.particles(body);
    return world.position(particles[1]) - world.position(particles[0]);
}

std::string lacksPendulum(const World& world, LawBodies bodies) {
    const auto particles = world.particles(bodies[0]);
    if (particles.size() != 2 || world.joints(bodies[0]).size() != 1)
        return "The formula is that of two particles with one joint.";
    if (!world.info(particles[0]).pinned || world.info(particles[1]).pinned)
        return "The first of both particles must be pinned, the second free.";
    if (!(gravityOf(world) > 0)) return "Without gravity nothing swings.";
    return "";
}

std::string lacksSpring(const World& world, LawBodies bodies) {
    std::string lacking = lacksPendulum(world, bodies);
    if (lacking.empty() && !std::isfinite(joint(world, bodies[0], &sulfur::JointInfo::stiffness)))
        lacking = "The joint must be elastic.";
    return lacking;
}

std::string lacksRigid(const World& world, LawBodies bodies) {
    std::string lacking = lacksPendulum(world, bodies);
    if (lacking.empty() && std::isfinite(joint(world, bodies[0], &sulfur::JointInfo::stiffness)))
        lacking = "The joint must be rigid.";
    return lacking;
}

std::string lacksGravity(const World& world, LawBodies) {
    return gravityOf(world) > 0 ? "" : "Without gravity nothing falls.";
}

std::string lacksNothing(const World&, LawBodies) {
    return "";
}

std::string lacksSlope(const World& world, LawBodies bodies) {
    if (world.particles(bodies[1]).size() < 2)
        return "The slope must be a line of two particles at least.";
    return lacksGravity(world, bodies);
}

// Seconds of a whole swing: between crossings of `middle` upwards.
std::optional<double> periodOf(LawNotes notes, double middle) {
    std::optional<double> first, last;
    int periods = 0;
    for (std::size_t i = 1; i < notes.size(); ++i) {
        const double a = notes[i - 1].values[0] - middle, b = notes[i].values[0] - middle;
        if (!(a < 0 && b >= 0)) continue;
        const double at = notes[i - 1].time + (notes[i].time - notes[i - 1].time) * a / (a - b);
        if (!first)
            first = at;
        else
            ++periods;
        last = at;
    }
    if (periods == 0) return std::nullopt;
    return (*last - *first) / periods;
}

double largest(LawNotes notes, std::size_t value) {
    double most = 0;
    for (const auto& note : notes) most = std::max(most, std::abs(note.values[value]));
    return most;
}

Finding share(std::string name, std::string formula, std::string unit, double expected,
              std::optional<double> measured, double part) {
    return {std::move(name), std::move(formula),  std::move(unit),
            expected,        std::move(measured), part * std::abs(expected)};
}

// The arithmetic-geometric mean: with it the period is exact for every amplitude.
double agm(double a, double b) {
    for (int i = 0; i < 40 && std::abs(a - b) > 1e-15 * a; ++i) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}

// --- pendulum and spring ---------------------------------------------------------------------

std::vector<double> pendulumNumbers(const World& world, LawBodies bodies) {
    return {joint(world, bodies[0], &sulfur::JointInfo::restLength), gravityOf(world)};
}

std::array<double, 4> pendulumLook(const World& world, LawBodies bodies) {
    const Point down = downOf(world), arm = armOf(world, bodies[0]);
    return {std::atan2(sulfur::cross(down, arm), down.dot(arm)), 0, 0, 0};
}

std::vector<Finding> pendulumFind(LawNumbers numbers, LawNotes notes) {
    const double amplitude = largest(notes, 0);
    const double swing =
        2 * std::numbers::pi * std::sqrt(numbers[0] / numbers[1]) / agm(1, std::cos(amplitude / 2));
    return {share("Period",
                  "T = 2\xCF\x80 \xE2\x88\x9A(l/g) / agm(1, cos \xCE\xB8/2), "
                  "with the amplitude \xCE\xB8",
                  "s", swing, periodOf(notes, 0), 0.002)};
}

std::vector<double> springNumbers(const World& world, LawBodies bodies) {
    using Info = sulfur::JointInfo;
    const auto bob = world.info(world.particles(bodies[0])[1]);
    return {static_cast<double>(bob.mass), joint(world, bodies[0], &Info::stiffness),
            joint(world, bodies[0], &Info::restLength), gravityOf(world)};
}

std::array<double, 4> springLook(const World& world, LawBodies bodies) {
    return {-downOf(world).dot(armOf(world, bodies[0])), 0, 0, 0};
}

std::vector<Finding> springFind(LawNumbers n, LawNotes notes) {
    // It swings about where it would hang still.
    const double middle = -(n[2] + n[0] * n[3] / n[1]);
    return {share("Period", "T = 2\xCF\x80 \xE2\x88\x9A(m/k)", "s",
                  2 * std::numbers::pi * std::sqrt(n[0] / n[1]), periodOf(notes, middle), 0.002)};
}

// --- fall and throw --------------------------------------------------------------------------

std::vector<double> gravityNumbers(const World& world, LawBodies) {
    return {gravityOf(world)};
}

// Height above the ground, speed downwards, whether it touches.
std::array<double, 4> fallLook(const World& world, LawBodies bodies) {
    const double above = static_cast<double>(world.bounds(bodies[0]).low.y()) -
                         static_cast<double>(world.bounds(bodies[1]).high.y());
    return {above, -static_cast<double>(world.meanVelocity(bodies[0]).y()),
            world.touches(bodies[0], bodies[1]) ? 1.0 : 0.0, 0};
}

std::vector<Finding> fallFind(LawNumbers n, LawNotes notes) {
    const double g = n[0], height = std::max(0.0, notes[0].values[0]), start = notes[0].values[1];
    const double speed = std::sqrt(start * start + 2 * g * height);
    std::optional<double> time, end;
    for (std::size_t i = 1; i < notes.size() && !time; ++i) {
        if (notes[i].values[2] == 0) continue;
        // It came down within this tick.
        const auto& before = notes[i - 1];
        end = before.values[1] + g * (notes[i].time - before.time) / 2;
        time = before.time - notes[0].time + before.values[0] / std::max(*end, 1e-9);
    }
    return {share("Time", "t = (\xE2\x88\x9A(v\xC2\xB2 + 2 g h) \xE2\x88\x92 v) / g", "s",
                  (speed - start) / g, time, 0.005),
            share("Speed at the end", "\xE2\x88\x9A(v\xC2\xB2 + 2 g h)", "m/s", speed, end, 0.005)};
}

// Place and velocity; heights count against gravity.
std::array<double, 4> throwLook(const World& world, LawBodies bodies) {
    const Point up = -downOf(world), right(up.y(), -up.x());
    const Point place = world.centreOfMass(bodies[0]);
    const Point velocity = world.meanVelocity(bodies[0]).cast<double>();
    return {right.dot(place), up.dot(place), right.dot(velocity), up.dot(velocity)};
}

std::vector<Finding> throwFind(LawNumbers n, LawNotes notes) {
    const auto& start = notes[0].values;
    const double across = start[2], up = std::max(0.0, start[3]);
    std::optional<double> width, height;
    double most = 0;
    for (std::size_t i = 1; i < notes.size() && !width; ++i) {
        const auto &a = notes[i - 1].values, &b = notes[i].values;
        most = std::max(most, b[1] - start[1]);
        if (b[3] < 0) height = most;
        if (!(a[1] > start[1] && b[1] <= start[1])) continue;
        const double part = (a[1] - start[1]) / (a[1] - b[1]);
        width = a[0] + part * (b[0] - a[0]) - start[0];
    }
    return {share("Range", "R = v\xC2\xB2 sin 2\xCE\xB1 / g, at the height of the start", "m",
                  2 * across * up / n[0], width, 0.005),
            share("Height", "H = v\xC2\xB2 sin\xC2\xB2\xCE\xB1 / 2g", "m", up * up / (2 * n[0]),
                  height, 0.005)};
}

// --- slopes ----------------------------------------------------------------------------------

std::vector<double> slopeNumbers(const World& world, LawBodies bodies) {
    const auto a = static_cast<double>(world.material(bodies[0]).staticFriction);
    const auto b = static_cast<double>(world.material(bodies[1]).staticFriction);
    return {std::sqrt(a * b)};
}

// How steep the plank is, where the block is on it, and how fast it slips.
std::array<double, 4> slopeLook(const World& world, LawBodies bodies) {
    const BodyId block = bodies[0], plank = bodies[1];
    const double angle = world.angle(plank);
    const Point along(std::cos(angle), std::sin(angle));
    const Point centre = world.centreOfMass(block);
    const Point arm = centre - world.centreOfMass(plank);
    const Point carried = world.meanVelocity(plank).cast<double>() +
                          world.angularVelocity(plank) * Point(-arm.y(), arm.x());
    const Point slip = world.meanVelocity(block).cast<double>() - carried;
    return {std::abs(angle) * degreeOf, along.dot(arm), along.dot(slip), 0};
}

std::vector<Finding> slopeFind(LawNumbers n, LawNotes notes) {
    constexpr double settled = 0.3;   // seconds after which the block lies
    constexpr double slipped = 0.02;  // metres that are no creeping
    constexpr double still = 0.004;   // m/s
    std::optional<double> angle;
    std::size_t first = 0;
    while (first < notes.size() && notes[first].time < notes[0].time + settled) ++first;
    for (std::size_t i = first; i < notes.size() && !angle; ++i) {
        if (std::abs(notes[i].values[1] - notes[first].values[1]) < slipped) continue;
        // Back to when it began.
        while (i > first && std::abs(notes[i].values[2]) > still) --i;
        angle = notes[i].values[0];
    }
    return {{"Angle", "\xCE\xB1 = arctan \xCE\xBC", "\xC2\xB0", std::atan(n[0]) * degreeOf, angle,
             0.5}};
}

std::vector<double> rollingNumbers(const World& world, LawBodies bodies) {
    const auto line = world.particles(bodies[1]);
    const Point along = (world.position(line.back()) - world.position(line.front())).normalized();
    return {gravityOf(world), std::abs(along.dot(downOf(world)))};
}

// Speed down the slope, and whether it is on it.
std::array<double, 4> rollingLook(const World& world, LawBodies bodies) {
    const auto line = world.particles(bodies[1]);
    Point along = (world.position(line.back()) - world.position(line.front())).normalized();
    if (along.dot(downOf(world)) < 0) along = -along;
    return {along.dot(world.meanVelocity(bodies[0]).cast<double>()),
            world.touches(bodies[0], bodies[1]) ? 1.0 : 0.0, 0, 0};
}

std::vector<Finding> rollingFind(LawNumbers n, LawNotes notes) {
    std::vector<Sample> speeds;
    for (const auto& note : notes)
        if (note.values[1] != 0 && note.time > notes[0].time + 0.1)
            speeds.push_back({note.time, note.values[0]});
    std::optional<double> measured;
    if (speeds.size() > 50)
        if (const auto fit = fitLine(speeds)) measured = fit->slope;
    return {share("Acceleration", "a = 2/3 g sin \xCE\xB1", "m/s\xC2\xB2", n[0] * n[1] * 2 / 3,
                  measured, 0.01)};
}

// --- collision -------------------------------------------------------------------------------

std::vector<double> collisionNumbers(const World& world, LawBodies bodies) {
    return {static_cast<double>(world.mass(bodies[0])), static_cast<double>(world.mass(bodies[1])),
            std::max(static_cast<double>(world.material(bodies[0]).restitution),
                     static_cast<double>(world.material(bodies[1]).restitution))};
}

std::array<double, 4> collisionLook(const World& world, LawBodies bodies) {
    return {static_cast<double>(world.meanVelocity(bodies[0]).x()),
            static_cast<double>(world.meanVelocity(bodies[1]).x()),
            world.centreOfMass(bodies[1]).x() - world.centreOfMass(bodies[0]).x(), 0};
}

std::vector<Finding> collisionFind(LawNumbers n, LawNotes notes) {
    const double v = notes[0].values[0], w = notes[0].values[1];
    const double closing = v - w, both = n[0] + n[1];
    const double first = (n[0] * v + n[1] * w - n[1] * n[2] * closing) / both;
    const double second = (n[0] * v + n[1] * w + n[0] * n[2] * closing) / both;
    std::optional<double> one, other;
    // After they have met: they no longer come nearer.
    for (const auto& note : notes)
        if (!one && std::abs(note.values[0] - v) > 1e-4 * std::abs(closing) &&
            (note.values[0] - note.values[1]) * closing <= 0) {
            one = note.values[0];
            other = note.values[1];
        }
    const double bound = 0.005 * std::abs(closing);
    const std::string law = " = (m\xE2\x82\x81v\xE2\x82\x81 + m\xE2\x82\x82v\xE2\x82\x82 ";
    const std::string end =
        " e (v\xE2\x82\x81 \xE2\x88\x92 v\xE2\x82\x82)) / (m\xE2\x82\x81 + m\xE2\x82\x82)";
    return {{"Speed of the first",
             "v\xE2\x82\x81\xE2\x80\xB2" + law + "\xE2\x88\x92 m\xE2\x82\x82" + end, "m/s", first,
             one, bound},
            {"Speed of the second", "v\xE2\x82\x82\xE2\x80\xB2" + law + "+ m\xE2\x82\x81" + end,
             "m/s", second, other, bound}};
}

constexpr std::array<LawBook, 7> allLaws{
    {{"pendulum", "Period of a pendulum", 1, lacksRigid, pendulumNumbers, pendulumLook,
      pendulumFind},
     {"fall", "Free fall", 2, lacksGravity, gravityNumbers, fallLook, fallFind},
     {"throwing", "Range of a throw", 1, lacksGravity, gravityNumbers, throwLook, throwFind},
     {"slope", "Angle of friction", 2, lacksGravity, slopeNumbers, slopeLook, slopeFind},
     {"spring", "Period of a spring", 1, lacksSpring, springNumbers, springLook, springFind},
     {"collision", "Elastic collision", 2, lacksNothing, collisionNumbers, collisionLook,
      collisionFind},
     {"rolling", "A rolling disc", 2, lacksSlope, rollingNumbers, rollingLook, rollingFind}}};

}  // namespace

const LawBook& lawBook(Law law) {
    return allLaws[static_cast<std::size_t>(law)];
}

std::span<const LawBook> lawBooks() {
    return allLaws;
}

}  // namespace sulfurchamber
