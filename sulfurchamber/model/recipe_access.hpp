// Members that some recipes have and others do not.
#pragma once

#include <optional>

#include "plan.hpp"

namespace sulfurchamber {

/// Asks the recipe of a prefab for a member, by a function that names it, and makes the blueprint
/// anew. Where the recipe has no such member, `with` is not called and the answer is false.
template <class Access, class With>
bool inRecipe(sulfur::scene::Prefab& prefab, const Access& access, const With& with) {
    bool had = false;
    std::visit(
        [&](auto& options) {
            if constexpr (requires { access(options); }) {
                with(access(options));
                had = true;
            }
        },
        prefab.generator);
    if (had) rebuild(prefab);
    return had;
}

/// The same to look at; nothing where the recipe has no such member.
template <class Value, class Access>
std::optional<Value> ofRecipe(const sulfur::scene::Prefab& prefab, const Access& access) {
    std::optional<Value> value;
    std::visit(
        [&](const auto& options) {
            if constexpr (requires { access(options); })
                value = static_cast<Value>(access(options));
        },
        prefab.generator);
    return value;
}

}  // namespace sulfurchamber
