// What a body is or is not: switches of its blueprint, its layers, its skin.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "document.hpp"

namespace sulfurchamber {

/// Something that a blueprint is or is not.
struct SwitchProperty {
    std::string_view key;   ///< for scripts: "pin-first"
    std::string_view name;  ///< for people
    std::string_view help;  ///< one line
    /// Nothing where it means nothing.
    std::optional<bool> (*get)(const sulfur::scene::Prefab&) = nullptr;
    void (*set)(sulfur::scene::Prefab&, bool) = nullptr;
};
/// In the order in which a panel shows them.
std::span<const SwitchProperty> switchProperties();
/// Null when there is none of this key.
const SwitchProperty* switchProperty(std::string_view key);

/// What several bodies have in common.
struct CommonSwitch {
    bool applies = false;    ///< whether at least one of them has it
    std::optional<bool> on;  ///< nothing where they differ
};
CommonSwitch common(const Document& document, std::span<const sulfur::BodyId> bodies,
                    const SwitchProperty& property);
/// Sets it for those that have it, as a part of the open edit.
void setSwitch(Document& document, std::span<const sulfur::BodyId> bodies,
               const SwitchProperty& property, bool on);

inline constexpr int layerCount = 8;
/// Whether bodies are in a layer (0 to 7); nothing where they differ.
std::optional<bool> inLayer(const Document& document, std::span<const sulfur::BodyId> bodies,
                            int layer);
/// Puts all of them into a layer or takes them out; their other layers stay. A part of the open
/// edit.
void setInLayer(Document& document, std::span<const sulfur::BodyId> bodies, int layer, bool on);

/// The texture of their skin, which the game shows; "" for none, nothing where they differ.
std::optional<std::string> skinOf(const Document& document, std::span<const sulfur::BodyId> bodies);
/// Dresses them, fitted to their outlines, or takes skins off (""). A part of the open edit. Throws
/// std::runtime_error when it is no name of a file below the game's pictures.
void setSkin(Document& document, std::span<const sulfur::BodyId> bodies,
             const std::string& texture);

}  // namespace sulfurchamber
