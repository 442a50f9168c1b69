#include <algorithm>
#include <set>
#include <sulfur/scene/mechanism.hpp>

namespace sulfur::scene {

std::vector<std::string*> bodiesOf(SceneMechanism& mechanism) {
    return std::visit(
        [](auto& spec) {
            std::vector<std::string*> names;
            if constexpr (requires { spec.a; }) names = {&spec.a, &spec.b};
            if constexpr (requires { spec.frame; }) names.push_back(&spec.frame);
            return names;
        },
        mechanism.spec);
}

std::vector<Point*> pointsOf(SceneMechanism& mechanism, std::string_view body) {
    return std::visit(
        [&](auto& spec) {
            std::vector<Point*> points;
            if constexpr (requires { spec.at; }) {
                if (spec.b == body) points.push_back(&spec.at);
            }
            if constexpr (requires { spec.atA; }) {
                if (spec.a == body) points.push_back(&spec.atA);
                if (spec.b == body) points.push_back(&spec.atB);
            }
            if constexpr (requires { spec.frame; }) {
                if (spec.frame == body) points.insert(points.end(), {&spec.overA, &spec.overB});
            }
            return points;
        },
        mechanism.spec);
}

void removeMechanisms(std::vector<SceneMechanism>& mechanisms,
                      const std::function<bool(const std::string&)>& gone) {
    std::set<std::string> left;
    std::erase_if(mechanisms, [&](SceneMechanism& mechanism) {
        const auto names = bodiesOf(mechanism);
        bool isGone =
            std::any_of(names.begin(), names.end(), [&](const auto* name) { return gone(*name); });
        // Parts of a gear come before it.
        if (const auto* gear = std::get_if<Gear>(&mechanism.spec))
            isGone = !left.contains(gear->first) || !left.contains(gear->second);
        if (!isGone && !mechanism.id.empty()) left.insert(mechanism.id);
        return isGone;
    });
}

}  // namespace sulfur::scene
