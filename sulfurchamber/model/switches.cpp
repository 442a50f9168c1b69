#include "switches.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "recipe_access.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::scene::Prefab;

#define SULFURCHAMBER_SWITCH(NAME, MEMBER)                                                     \
    std::optional<bool> is##NAME(const Prefab& prefab) {                                       \
        return ofRecipe<bool>(prefab,                                                          \
                              [](const auto& o) -> decltype((o.MEMBER)) { return o.MEMBER; }); \
    }                                                                                          \
    void set##NAME(Prefab& prefab, bool on) {                                                  \
        inRecipe(                                                                              \
            prefab, [](auto& o) -> decltype((o.MEMBER)) { return o.MEMBER; },                  \
            [&](bool& own) { own = on; });                                                     \
    }

SULFURCHAMBER_SWITCH(PinnedFirst, pinFirst)
SULFURCHAMBER_SWITCH(PinnedLast, pinLast)
SULFURCHAMBER_SWITCH(PinnedCorners, pinCorners)
SULFURCHAMBER_SWITCH(PinnedBottom, pinBottom)
SULFURCHAMBER_SWITCH(Braced, diagonals)

#undef SULFURCHAMBER_SWITCH

std::optional<bool> isSensor(const Prefab& prefab) {
    return prefab.blueprint.sensor;
}
void setSensor(Prefab& prefab, bool on) {
    prefab.blueprint.sensor = on;
}

constexpr std::array switches{
    SwitchProperty{"pin-first", "Pinned at its start", "Its first particle is held where it is",
                   isPinnedFirst, setPinnedFirst},
    SwitchProperty{"pin-last", "Pinned at its end", "Its last particle is held where it is",
                   isPinnedLast, setPinnedLast},
    SwitchProperty{"pin-corners", "Hung by its corners", "Both upper corners are held",
                   isPinnedCorners, setPinnedCorners},
    SwitchProperty{"pin-bottom", "On a foundation", "The lowest particles are held", isPinnedBottom,
                   setPinnedBottom},
    SwitchProperty{"diagonals", "Braced meshes", "Meshes of the cloth resist shear", isBraced,
                   setBraced},
    SwitchProperty{"sensor", "Sensor", "Pushes nothing; it only notices who is in it", isSensor,
                   setSensor},
};

// Blueprints of bodies as they are; pieces have none.
template <class Visit>
void forEachDressed(const Document& document, std::span<const BodyId> bodies, const Visit& visit) {
    std::set<std::string> seen;
    for (const BodyId body : bodies) {
        const std::string id = document.idOf(body);
        if (id.empty()) continue;
        const auto& placement = document.plan().body(id);
        const bool own =
            placement.kind || placement.material || placement.filter || placement.sensor;
        if (own || seen.insert(placement.blueprint).second) visit(document.plan().dressed(id));
    }
}

}  // namespace

std::span<const SwitchProperty> switchProperties() {
    return switches;
}

const SwitchProperty* switchProperty(std::string_view key) {
    const auto* found = std::find_if(switches.begin(), switches.end(),
                                     [&](const auto& property) { return property.key == key; });
    return found == switches.end() ? nullptr : found;
}

CommonSwitch common(const Document& document, std::span<const BodyId> bodies,
                    const SwitchProperty& property) {
    CommonSwitch all;
    bool same = true;
    forEachDressed(document, bodies, [&](const Prefab& prefab) {
        const auto own = property.get(prefab);
        if (!own) return;
        same = same && (!all.applies || all.on == own);
        all.applies = true;
        all.on = own;
    });
    if (!same) all.on.reset();
    return all;
}

void setSwitch(Document& document, std::span<const BodyId> bodies, const SwitchProperty& property,
               bool on) {
    document.change(bodies, [&](Prefab& prefab) {
        if (property.get(prefab)) property.set(prefab, on);
    });
}

std::optional<bool> inLayer(const Document& document, std::span<const BodyId> bodies, int layer) {
    std::optional<bool> value;
    bool same = true;
    forEachDressed(document, bodies, [&](const Prefab& prefab) {
        const bool own = (prefab.blueprint.filter.category >> layer & 1u) != 0;
        same = same && (!value || *value == own);
        value = own;
    });
    return same ? value : std::nullopt;
}

void setInLayer(Document& document, std::span<const BodyId> bodies, int layer, bool on) {
    const std::uint32_t bit = 1u << layer;
    document.change(bodies, [&](Prefab& prefab) {
        auto& filter = prefab.blueprint.filter;
        filter.category = on ? filter.category | bit : filter.category & ~bit;
        // Whoever was of all layers to others is of its own ones now.
        filter.mask = (filter.mask & ~0xffu) | (filter.category & 0xffu);
    });
}

std::optional<std::string> skinOf(const Document& document, std::span<const BodyId> bodies) {
    std::optional<std::string> value;
    bool same = true;
    forEachDressed(document, bodies, [&](const Prefab& prefab) {
        std::string own = prefab.blueprint.skin ? prefab.blueprint.skin->texture : "";
        same = same && (!value || *value == own);
        value = std::move(own);
    });
    return same ? value : std::nullopt;
}

void setSkin(Document& document, std::span<const BodyId> bodies, const std::string& texture) {
    if (!texture.empty() && !sulfur::scene::safeAssetName(texture))
        throw std::runtime_error(tr(
            "\"{}\" is no name of a skin; allowed is a relative name of at most 200 bytes with / "
            "between its parts",
            {texture}));
    document.change(bodies, [&](Prefab& prefab) {
        prefab.skinFitted = !texture.empty();
        if (texture.empty())
            prefab.blueprint.skin.reset();
        else
            prefab.blueprint.skin =
                sulfur::scene::fitSkin(prefab.generator, prefab.blueprint, texture);
        if (prefab.generator.index() == 0) prefab.skinFitted = false;
    });
}

}  // namespace sulfurchamber
