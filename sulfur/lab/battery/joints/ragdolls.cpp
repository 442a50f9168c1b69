// Ragdolls that fall down stairs.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "battery/joints/joints.hpp"
#include "battery/joints/subjects.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

using bench::EngineWorld;

/// Of a person of 1.8 m that stands upright with its hips at the origin: a capsule from one end to
/// the other, which hangs on another bone at its first end.
struct Bone {
    int parent = -1;
    Point from{0, 0}, to{0, 0};   // m
    double radius = 0.05;         // m
    double lower = 0, upper = 0;  // rad
};

const std::vector<Bone>& bones() {
    static const std::vector<Bone> all{
        {-1, {0, 0}, {0, 0.25}, 0.1, 0, 0},         // hips and belly
        {0, {0, 0.25}, {0, 0.55}, 0.1, -0.4, 0.4},  // chest
        {1, {0, 0.55}, {0, 0.8}, 0.08, -0.5, 0.5},  // neck and head
        {1, {0, 0.5}, {0, 0.22}, 0.04, -2, 2},      // upper arms
        {1, {0, 0.5}, {0, 0.22}, 0.04, -2, 2},
        {3, {0, 0.22}, {0, -0.08}, 0.035, 0, 2.4},  // forearms
        {4, {0, 0.22}, {0, -0.08}, 0.035, 0, 2.4},
        {0, {0, 0}, {0, -0.42}, 0.06, -0.4, 1.8},  // thighs
        {0, {0, 0}, {0, -0.42}, 0.06, -0.4, 1.8},
        {7, {0, -0.42}, {0, -0.85}, 0.05, -2.2, 0},  // shanks
        {8, {0, -0.42}, {0, -0.85}, 0.05, -2.2, 0},
    };
    return all;
}

/// Some of them on one flight of stairs. Each is taken away after 8 s, and another one begins
/// above.
class Stairs {
public:
    Stairs(const JointSubject& subject, const Setup& setup)
        : subject_(subject),
          world_(subject.world(false)),
          workshop_(*world_),
          seconds_(setup.seconds(600, 20)) {
        constexpr int steps = 30;
        for (int i = 0; i < steps; ++i)
            workshop_.add({.parts = {bench::rectangle({0.25, 2})},
                           .mover = bench::Mover::nobody,
                           .place = {0.5 * i, -2 - 0.35 * i},
                           .friction = 0.2});
        workshop_.add({.parts = {bench::rectangle({10, 1})},
                       .mover = bench::Mover::nobody,
                       .place = {0.5 * steps + 9.75, -1 - 0.35 * steps}});
    }

    Rows run() {
        constexpr double life = 8;  // s
        std::vector<Doll> dolls(3);
        long next = 0;
        std::size_t turn = 0;
        for (long i = 0; i < subject_.ticks(seconds_); ++i) {
            if (i >= next) {
                replace(dolls[turn]);
                turn = (turn + 1) % dolls.size();
                next += subject_.ticks(life / static_cast<double>(dolls.size()));
            }
            world_->step();
            for (const Doll& doll : dolls) look(doll);
        }
        const std::string name = fmt::format("ragdolls down stairs, {:g} s: ", seconds_);
        const std::string apart = name + "a joint comes apart (m)";
        return {subject_.ours ? fallsShort(subject_.label() + ": " + apart, apart_, 4e-3, 1e-3)
                              : subject_.row(apart, apart_, unbounded),
                subject_.row(name + "a joint beyond its limit (rad)", beyond_, unbounded),
                subject_.row(name + "still above the tenth step when taken away (share)",
                             started_ > 0 ? static_cast<double>(stuck_) / started_ : unmeasured,
                             unbounded)};
    }

private:
    struct Doll {
        std::vector<std::size_t> bodies, joints;
    };

    void replace(Doll& doll) {
        if (!doll.bodies.empty()) {
            ++started_;
            stuck_ += world_->body(doll.bodies[0]).place.y() > -3.5 ? 1 : 0;
        }
        for (const std::size_t body : doll.bodies) world_->removeBody(body);
        doll = {};
        // Each in a bearing of its own, with a push down the stairs.
        const double angle = random_.uniform(-std::numbers::pi, std::numbers::pi);
        const bench::Motion hips{.place = {random_.uniform(0, 1), 1.5}, .angle = angle};
        const int group = ++group_;
        for (const Bone& bone : bones()) {
            const Point middle = (bone.from + bone.to) / 2, half = (bone.to - bone.from) / 2;
            doll.bodies.push_back(
                workshop_.add({.parts = {bench::capsule(-half, half, bone.radius)},
                               .place = hips.at(middle),
                               .angle = angle,
                               .velocity = {3, 0},
                               .density = 100,
                               .friction = 0.2,
                               .group = group}));
            if (bone.parent < 0) continue;
            doll.joints.push_back(
                workshop_.join({.a = doll.bodies[static_cast<std::size_t>(bone.parent)],
                                .b = doll.bodies.back(),
                                .at = hips.at(bone.from),
                                .lower = bone.lower,
                                .upper = bone.upper}));
        }
    }

    void look(const Doll& doll) {
        for (std::size_t k = 0; k < doll.joints.size(); ++k) {
            const Anchors& anchors = workshop_.anchors(doll.joints[k]);
            apart_ = worst(apart_, anchors.gap(*world_).norm());
            const Bone& bone = bones()[k + 1];
            const double value = anchors.value(*world_);
            beyond_ = worst(beyond_, std::max(value - bone.upper, bone.lower - value));
        }
    }

    JointSubject subject_;
    std::unique_ptr<EngineWorld> world_;
    Workshop workshop_;
    double seconds_;
    Random random_{21};
    double apart_ = 0, beyond_ = 0;
    int started_ = 0, stuck_ = 0, group_ = 0;
};

}  // namespace

Rows ragdolls(const Setup& setup) {
    Rows rows;
    for (const JointSubject& subject : jointSubjects(setup))
        for (Row& row : Stairs(subject, setup).run()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
