#include "rail.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::JointId;
using sulfur::JointInfo;
using sulfur::ParticleId;
using sulfur::Point;
using sulfur::World;

constexpr double turnOfChord = 0.12;  // radians: a chord of a circle of 1 m is off by 2 mm

std::vector<Point> lineOf(const World& world, const JointInfo& link) {
    return chordsOf(world.position(link.a), world.position(link.b), static_cast<double>(link.bend));
}

Point nearestOn(const std::vector<Point>& line, const Point& to) {
    Point found = line.front();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point way = line[i] - line[i - 1];
        const double along = (to - line[i - 1]).dot(way) / std::max(1e-12, way.squaredNorm());
        const Point on = line[i - 1] + std::clamp(along, 0.0, 1.0) * way;
        if ((on - to).norm() < (found - to).norm()) found = on;
    }
    return found;
}

// The joints of a body that a line may go through.
class Lines {
public:
    Lines(const World& world, BodyId body) : world_(world) {
        const auto joints = world.joints(body);
        const bool surface = std::any_of(joints.begin(), joints.end(), [&](JointId joint) {
            return world.info(joint).radius > 0;
        });
        for (const JointId joint : joints) {
            const JointInfo info = world.info(joint);
            if (surface && !(info.radius > 0)) continue;
            joints_.emplace(joint, info);
            for (const ParticleId end : {info.a, info.b}) ends_[end].push_back(joint);
        }
    }

    /// The one whose surface is nearest to a point, within `reach`; null when there is none.
    JointId nearest(const Point& to, double reach, Point& at) const {
        JointId found;
        double least = reach;
        for (const auto& [joint, info] : joints_) {
            const Point on = nearestOn(lineOf(world_, info), to);
            const double off = (on - to).norm() - static_cast<double>(info.radius);
            if (off > least) continue;
            least = off;
            found = joint;
            at = on;
        }
        return found;
    }

    std::vector<JointId> through(JointId joint) const {
        const JointInfo& info = joints_.at(joint);
        const std::vector<JointId> onwards = from(joint, info.b);
        std::vector<JointId> line;
        if (!closes(onwards, joint, info.a)) {
            line = from(joint, info.a);
            std::reverse(line.begin(), line.end());
        }
        line.push_back(joint);
        line.insert(line.end(), onwards.begin(), onwards.end());
        return line;
    }

private:
    // Those that follow a joint beyond its end.
    std::vector<JointId> from(JointId joint, ParticleId end) const {
        std::vector<JointId> line;
        JointId last = joint;
        for (;;) {
            const auto& here = ends_.at(end);
            if (here.size() != 2) return line;
            const JointId next = here[0] == last ? here[1] : here[0];
            if (next == joint || next == last) return line;
            line.push_back(next);
            const JointInfo& info = joints_.at(next);
            end = info.a == end ? info.b : info.a;
            last = next;
        }
    }
    bool closes(const std::vector<JointId>& onwards, JointId joint, ParticleId begin) const {
        if (onwards.empty() || onwards.back() == joint) return false;
        const JointInfo& last = joints_.at(onwards.back());
        return (last.a == begin || last.b == begin) && ends_.at(begin).size() == 2;
    }

    const World& world_;
    std::map<JointId, JointInfo> joints_;
    std::map<ParticleId, std::vector<JointId>> ends_;
};

double lengthOfLine(const std::vector<Point>& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    return length;
}

}  // namespace

std::vector<RailLine> railsAt(const World& world, const Point& point, double reach) {
    std::vector<RailLine> found;
    for (const BodyId body : world.bodies()) {
        const auto bounds = world.bounds(body);
        if ((point.array() < bounds.low.array() - reach).any() ||
            (point.array() > bounds.high.array() + reach).any())
            continue;
        const Lines lines(world, body);
        RailLine one;
        const JointId link = lines.nearest(point, reach, one.at);
        if (!link) continue;
        one.body = body;
        one.links = lines.through(link);
        one.length = lengthOfLine(lineOf(world, one.links));
        found.push_back(std::move(one));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const RailLine& a, const RailLine& b) { return a.length > b.length; });
    return found;
}

std::vector<Point> lineOf(const World& world, std::span<const JointId> links) {
    std::vector<Point> line;
    ParticleId end;
    for (std::size_t k = 0; k < links.size(); ++k) {
        const JointInfo info = world.info(links[k]);
        if (k == 0) {
            end = info.a;
            if (links.size() > 1) {
                const JointInfo next = world.info(links[1]);
                if (next.a != info.b && next.b != info.b) end = info.b;
            }
            line.push_back(world.position(end));
        }
        std::vector<Point> part = lineOf(world, info);
        if (info.a != end) std::reverse(part.begin(), part.end());
        line.insert(line.end(), std::next(part.begin()), part.end());
        end = info.a == end ? info.b : info.a;
    }
    return line;
}

std::vector<Point> chordsOf(const Point& a, const Point& b, double bend) {
    const Point chord = b - a;
    const double half = std::abs(bend) / 2;
    if (!(half > 1e-6)) return {a, b};
    const Point right = Point(chord.y(), -chord.x()) * (bend > 0 ? 1 : -1);
    const Point centre = (a + b) / 2 - right / (2 * std::tan(half));
    const int count = std::max(1, static_cast<int>(std::ceil(2 * half / turnOfChord)));
    std::vector<Point> points{a};
    for (int k = 1; k < count; ++k)
        points.emplace_back(centre + Eigen::Rotation2Dd(bend * k / count) * (a - centre));
    points.push_back(b);
    return points;
}

}  // namespace sulfurchamber
