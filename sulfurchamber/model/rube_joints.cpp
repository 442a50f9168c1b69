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

Drive lengthOfRube(const std::string& type, const Node& joint, double mass) {
    Drive drive;
    if (type == "rope") {
        drive.upper = rubeReal(joint, "maxLength");
        return drive;
    }
    const Real length = rubeReal(joint, "length");
    const double frequency = rubeNumber(joint, "frequency", 0);
    if (frequency > 0) {
        drive.rest = length;
        setSpring(drive, frequency, rubeNumber(joint, "dampingRatio", 0), mass);
    } else {
        drive.lower = drive.upper = length;
    }
    return drive;
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
    if (a == nullptr || b == nullptr || a == b || (isStill(a) && isStill(b))) {
        leaveOut(tr("joints of bodies that have nothing to hold"));
        return;
    }
    const std::optional<Spec> spec = specOf(type, joint, endsOf(joint, *a, *b));
    if (!spec) {
        leaveOut(tr("joints of the kind “{}”", {type}));
        return;
    }
    sulfur::scene::SceneMechanism made;
    made.spec = *spec;
    made_.scene.mechanisms.push_back(std::move(made));
    if (!rubeFlag(joint, "collideConnected")) letPass(*a, *b);
}

RubeReader::Ends RubeReader::endsOf(const Node& joint, const Body& a, const Body& b) {
    Ends ends;
    ends.atA = a.toWorld(rubePoint(joint, "anchorA"));
    ends.atB = b.toWorld(rubePoint(joint, "anchorB"));
    ends.a = a.nearest(ends.atA).id;
    ends.b = b.nearest(ends.atB).id;
    const Point axis = joint.find("localAxisA") ? rubePoint(joint, "localAxisA") : Point(1, 0);
    ends.axis = Eigen::Rotation2Dd(a.pose.angle) * axis;
    ends.angle = b.pose.angle - a.pose.angle - rubeNumber(joint, "refAngle", 0);
    const bool stillA = a.kind != sulfur::BodyKind::dynamic;
    const bool stillB = b.kind != sulfur::BodyKind::dynamic;
    ends.mass = stillA ? b.mass() : stillB ? a.mass() : a.mass() * b.mass() / (a.mass() + b.mass());
    return ends;
}

std::optional<RubeReader::Spec> RubeReader::specOf(const std::string& type, const Node& joint,
                                                   const Ends& ends) {
    const sulfur::Vec2 axis = ends.axis.cast<Real>();
    std::optional<Spec> made;
    if (type == "revolute") {
        sulfur::scene::Hinge hinge{ends.a, ends.b, ends.atB, {}};
        hinge.options.drive = limitsAndMotor(joint, "maxMotorTorque");
        hinge.options.value = ends.angle;
        made = hinge;
    } else if (type == "weld") {
        made = sulfur::scene::Weld{ends.a, ends.b, ends.atB, {}, {}};
    } else if (type == "prismatic") {
        sulfur::scene::Slider slider{ends.a, ends.b, ends.atB, axis, {}, {}};
        slider.options.drive = limitsAndMotor(joint, "maxMotorForce");
        slider.options.value = ends.axis.normalized().dot(ends.atB - ends.atA);
        slider.options.turns = false;
        made = slider;
    } else if (type == "wheel") {
        sulfur::scene::Wheel wheel{ends.a, ends.b, ends.atB, axis, {}};
        wheel.options.motor = limitsAndMotor(joint, "maxMotorTorque");
        setSpring(wheel.options.spring, rubeNumber(joint, "springFrequency", 0),
                  rubeNumber(joint, "springDampingRatio", 0), ends.mass);
        made = wheel;
    } else if (type == "distance" || type == "rope") {
        sulfur::scene::Distance distance{ends.a, ends.b, ends.atA, ends.atB, {}};
        distance.options.drive = lengthOfRube(type, joint, ends.mass);
        made = distance;
    }
    const bool collide = rubeFlag(joint, "collideConnected");
    const auto set = [&](auto& spec) {
        if constexpr (requires { spec.options.collide; }) spec.options.collide = collide;
    };
    if (made) std::visit(set, *made);
    return made;
}

}  // namespace sulfurchamber
