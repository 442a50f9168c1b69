// Joints of R.U.B.E. as mechanisms.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "rube_reader.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Drive;
using sulfur::Point;
using sulfur::Real;
using sulfur::scene::Node;

Real rubeReal(const Node& joint, std::string_view key) {
    return static_cast<Real>(rubeNumber(joint, key, 0));
}

Drive limitsAndMotor(const Node& joint, std::string_view most) {
    Drive drive;
    if (rubeFlag(joint, "enableLimit")) {
        drive.lower = rubeReal(joint, "lowerLimit");
        drive.upper = std::max(drive.lower, rubeReal(joint, "upperLimit"));
    }
    if (rubeFlag(joint, "enableMotor")) {
        drive.motorSpeed = rubeReal(joint, "motorSpeed");
        drive.motorMax = std::abs(rubeReal(joint, most));
    }
    return drive;
}

// A frequency in Hz and a share of critical damping, for this mass.
void setSpring(Drive& drive, double frequency, double ratio, double mass) {
    const double w = 2 * std::numbers::pi * frequency;
    drive.stiffness = static_cast<Real>(mass * w * w);
    drive.damping = static_cast<Real>(std::max(0.0, 2 * ratio * mass * w));
}

}  // namespace

Point RubeReader::Body::toWorld(const Point& local) const {
    return pose.position + Eigen::Rotation2Dd(pose.angle) * local;
}

double RubeReader::Body::mass() const {
    double sum = 0;
    for (const Piece& piece : pieces) sum += piece.mass;
    return sum;
}

const RubeReader::Piece& RubeReader::Body::nearest(const Point& place) const {
    return *std::min_element(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
        return (a.middle - place).norm() < (b.middle - place).norm();
    });
}

double RubeReader::massOf(const sulfur::Blueprint& blueprint) {
    double sum = 0;
    for (const auto& particle : blueprint.particles) sum += static_cast<double>(particle.mass);
    return sum;
}

void RubeReader::noteAnchors(const Node& joint) {
    for (const auto& [body, anchor] :
         {std::pair{"bodyA", "anchorA"}, std::pair{"bodyB", "anchorB"}})
        anchors_.emplace(static_cast<std::size_t>(std::max(0.0, rubeNumber(joint, body, 0))),
                         rubePoint(joint, anchor));
}

// A disc is held at its middle alone.
bool RubeReader::heldAt(std::size_t body, const Point& middle) const {
    const auto [first, last] = anchors_.equal_range(body);
    return std::all_of(first, last,
                       [&](const auto& one) { return (one.second - middle).norm() < 1e-4; });
}

void RubeReader::letPass(const Body& a, const Body& b) {
    for (const Piece& one : a.pieces)
        for (const Piece& other : b.pieces) made_.scene.vetoes.push_back({one.id, other.id});
}

void RubeReader::addJoint(const Node& joint) {
    const std::string type = joint.at("type").string(1, 40);
    const auto bodyAt = [&](std::string_view key) -> const Body* {
        const double index = rubeNumber(joint, key, -1);
        if (!(index >= 0 && index < static_cast<double>(bodies_.size())))
            joint.at(key).fail(tr("is the place of no body"));
        const Body& body = bodies_[static_cast<std::size_t>(index)];
        return body.pieces.empty() ? nullptr : &body;
    };
    const Body* a = bodyAt("bodyA");
    const Body* b = bodyAt("bodyB");
    const auto isStill = [](const Body* body) { return body->kind != sulfur::BodyKind::dynamic; };
    if (a == nullptr || b == nullptr || (isStill(a) && isStill(b))) {
        leaveOut(tr("joints of bodies that have nothing to hold"));
        return;
    }
    const Point atA = a->toWorld(rubePoint(joint, "anchorA"));
    const Point atB = b->toWorld(rubePoint(joint, "anchorB"));
    const std::string idA = a->nearest(atA).id, idB = b->nearest(atB).id;
    const Point axis = Eigen::Rotation2Dd(a->pose.angle) *
                       (joint.find("localAxisA") ? rubePoint(joint, "localAxisA") : Point(1, 0));
    const bool collide = rubeFlag(joint, "collideConnected");
    const double reduced = isStill(a)   ? b->mass()
                           : isStill(b) ? a->mass()
                                        : a->mass() * b->mass() / (a->mass() + b->mass());
    sulfur::scene::SceneMechanism made;
    if (type == "revolute") {
        sulfur::scene::Hinge hinge{idA, idB, atB, {}};
        hinge.options.drive = limitsAndMotor(joint, "maxMotorTorque");
        hinge.options.value = b->pose.angle - a->pose.angle - rubeNumber(joint, "refAngle", 0);
        hinge.options.collide = collide;
        made.spec = hinge;
    } else if (type == "weld") {
        sulfur::scene::Weld weld{idA, idB, atB, {}, {}};
        weld.options.collide = collide;
        made.spec = weld;
    } else if (type == "prismatic" || type == "wheel") {
        const sulfur::Vec2 line = axis.cast<Real>();
        if (type == "prismatic") {
            sulfur::scene::Slider slider{idA, idB, atB, line, {}, {}};
            slider.options.drive = limitsAndMotor(joint, "maxMotorForce");
            slider.options.value = axis.normalized().dot(atB - atA);
            slider.options.turns = false;
            slider.options.collide = collide;
            made.spec = slider;
        } else {
            sulfur::scene::Wheel wheel{idA, idB, atB, line, {}};
            wheel.options.motor = limitsAndMotor(joint, "maxMotorTorque");
            setSpring(wheel.options.spring, rubeNumber(joint, "springFrequency", 0),
                      rubeNumber(joint, "springDampingRatio", 0), reduced);
            wheel.options.collide = collide;
            made.spec = wheel;
        }
    } else if (type == "distance" || type == "rope") {
        sulfur::scene::Distance distance{idA, idB, atA, atB, {}};
        Drive& drive = distance.options.drive;
        const Real length = rubeReal(joint, type == "rope" ? "maxLength" : "length");
        const double frequency = rubeNumber(joint, "frequency", 0);
        drive.upper = type == "distance" && frequency > 0 ? sulfur::infinite : length;
        if (type == "distance" && frequency > 0) {
            drive.rest = length;
            setSpring(drive, frequency, rubeNumber(joint, "dampingRatio", 0), reduced);
        } else if (type == "distance") {
            drive.lower = length;
        }
        distance.options.collide = collide;
        made.spec = distance;
    } else {
        leaveOut(tr("joints of the kind “{}”", {type}));
        return;
    }
    made_.scene.mechanisms.push_back(std::move(made));
    if (!collide) letPass(*a, *b);
}

}  // namespace sulfurchamber
