// Scenes with one key that are made by name: those of S8 and S9.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/scenes.hpp"

namespace sulfur::lab::bench {

/// What a variant is made of.
struct VariantScene {
    std::string title;
    double seconds = 0, bodies = 0;
    std::string error = {};  ///< empty: what the scenes of its key are judged by
    std::function<std::unique_ptr<Play>()> play;
    bool sleeping = false, weightless = false;
};

struct Variant {
    const char* name;
    VariantScene (*make)(Extent);
};

inline std::vector<std::string> namesOf(std::span<const Variant> variants) {
    std::vector<std::string> all;
    for (const Variant& variant : variants) all.emplace_back(variant.name);
    return all;
}

/// Throws std::out_of_range if there is none of this name. `error`: that of most of them.
inline Scene variantOf(const std::string& key, Feature needs, const std::string& error,
                       std::span<const Variant> variants, const std::string& name, Extent extent) {
    for (const Variant& variant : variants) {
        if (variant.name != name) continue;
        VariantScene made = variant.make(extent);
        return {.key = key,
                .variant = name,
                .title = std::move(made.title),
                .needs = needs,
                .seconds = made.seconds,
                .size = made.bodies,
                .looksPerSecond = 1'000'000,
                .sleeping = made.sleeping,
                .weightless = made.weightless,
                .timesTicks = true,
                .error = made.error.empty() ? error : std::move(made.error),
                .play = std::move(made.play)};
    }
    throw std::out_of_range(key + " has no scene " + name);
}

}  // namespace sulfur::lab::bench
