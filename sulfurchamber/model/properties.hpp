// The properties of bodies, by name, with units and ranges: what a panel shows and changes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sulfur/scene.hpp>
#include <vector>

#include "document.hpp"

namespace sulfurchamber {

/// How a slider divides a range.
enum class Scale : std::uint8_t { linear, logarithmic, cubic };

/// A number that a blueprint has or not.
struct NumberProperty {
    std::string_view key;   ///< for scripts: "mass"
    std::string_view name;  ///< for people
    std::string_view unit;  ///< UTF-8
    std::string_view help;  ///< one line
    double low = 0;         ///< allowed at least
    double high = 1;        ///< allowed at most
    Scale scale = Scale::linear;
    std::string_view endless;  ///< not empty: infinity is allowed too, and this is its word
    bool whole = false;        ///< without a fraction
    /// Nothing where it means nothing. NaN where the parts of the body differ.
    std::optional<double> (*get)(const sulfur::scene::Prefab&) = nullptr;
    /// In a recipe, if that has it, otherwise in the blueprint, which has no recipe then.
    void (*set)(sulfur::scene::Prefab&, double) = nullptr;
};

/// In the order in which a panel shows them.
std::span<const NumberProperty> numberProperties();
/// Null when there is none of this key.
const NumberProperty* numberProperty(std::string_view key);

/// What several bodies have in common.
struct Common {
    bool applies = false;         ///< whether at least one of them has the property
    std::optional<double> value;  ///< nothing where they differ
};
Common common(const Document& document, std::span<const sulfur::BodyId> bodies,
              const NumberProperty& property);
/// Sets it for those that have it, as a part of the open edit. Throws std::runtime_error with the
/// range when it is outside.
void setProperty(Document& document, std::span<const sulfur::BodyId> bodies,
                 const NumberProperty& property, double value);

/// What things are made of: density, surface, stiffness and strength together.
struct MaterialPreset {
    std::string_view name;
    double density = 4;  ///< kg/m^2
    double kineticFriction = 0.5;
    double staticFriction = 0.6;
    double restitution = 0;
    double stiffness = 0;  ///< N/m for a body of a kilogram; infinite: rigid
};
std::span<const MaterialPreset> materialPresets();
/// As a part of the open edit.
void applyPreset(Document& document, std::span<const sulfur::BodyId> bodies,
                 const MaterialPreset& preset);

/// Whether nothing moves them; nothing where they differ.
std::optional<bool> heldInPlace(const Document& document, std::span<const sulfur::BodyId> bodies);
void holdInPlace(Document& document, std::span<const sulfur::BodyId> bodies, bool on);

/// "#rrggbb", "" where a body has none of its own; nothing where they differ. Files keep it as a
/// member "color" of the body, which means nothing to the physics.
std::optional<std::string> colour(const Document& document, std::span<const sulfur::BodyId> bodies);
void setColour(Document& document, std::span<const sulfur::BodyId> bodies,
               const std::string& colour);
/// In which they are seen, each once, in the order of the bodies. Who has none of its own has that
/// of the scene for what is soft or rigid.
std::vector<std::string> shownColours(const Document& document,
                                      std::span<const sulfur::BodyId> bodies);
/// Of one body of the plan; "" where it has none.
std::string colourOf(const sulfur::scene::Placement& body);

/// m^2 that the outline of a body encloses, with its thickness; 0 for what has none.
double areaOf(const sulfur::Blueprint& blueprint);

}  // namespace sulfurchamber
