// Comparing and merging parts of instances with those of their template; for instances.cpp.
#pragma once

#include "instances.hpp"
#include "plan.hpp"

namespace sulfurchamber {

/// A body with its blueprint, which nobody else has.
struct Part {
    sulfur::scene::Prefab prefab;
    sulfur::scene::Placement placement;
};

/// Something of a part that can differ from its template.
struct Trait {
    std::string_view key;
    std::string_view name;
};
/// All of them, numbers of blueprints first.
const std::vector<Trait>& traits();
/// Whether two parts agree in a trait.
bool agree(std::string_view trait, const Part& a, const Part& b);
/// Gives `part` what `from` has.
void take(std::string_view trait, Part& part, const Part& from);
/// What `mine` is when it follows its template from `base` to `next` and keeps what is its own.
Part merged(const Part& base, const Part& mine, const Part& next);

/// An instance in the frame of its template, with the names of parts as ids.
struct Looked {
    sulfur::scene::Scene scene;  ///< what ties its parts to each other, and its thrusters
    std::map<std::string, Part> parts;
    sulfur::Pose frame;
};
/// The parts of a template.
std::map<std::string, Part> partsOf(const Template& made);
/// Looks at an instance. `base` tells where parts belong; the frame is where most of them agree.
Looked look(const Plan& plan, const Instance& instance, const std::map<std::string, Part>& base);
/// The ties of an instance that follow the template, those that are its own kept.
sulfur::scene::Scene mergedTies(const sulfur::scene::Scene& base, const sulfur::scene::Scene& mine,
                                const sulfur::scene::Scene& next);
/// How many ties differ.
std::size_t tieDifferences(const sulfur::scene::Scene& base, const sulfur::scene::Scene& mine);

}  // namespace sulfurchamber
