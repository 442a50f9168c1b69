// The properties of mechanisms, zones and thrusters, by name, with units and ranges.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "document.hpp"
#include "properties.hpp"

namespace sulfurchamber {

/// As NumberProperty, of a fitting.
struct FittingProperty {
    std::string_view key;
    std::string_view name;
    std::string_view unit;  ///< UTF-8
    std::string_view help;
    double low = 0;
    double high = 1;
    Scale scale = Scale::linear;
    std::string_view endless;
    bool whole = false;
    bool live = false;  ///< a running mechanism takes it without being made anew
    /// Nothing where it means nothing.
    std::optional<double> (*get)(const Fitting&) = nullptr;
    void (*set)(Fitting&, double) = nullptr;
};

/// In the order in which a panel shows them.
std::span<const FittingProperty> fittingProperties();
/// That of this key which means something to a fitting, or null.
const FittingProperty* fittingProperty(std::string_view key, const Fitting& fitting);
/// As a part of the open edit. Throws std::runtime_error with the range when it is outside.
void setFittingProperty(Document& document, const FittingRef& ref, const FittingProperty& property,
                        double value);

/// Nothing where no key can drive it.
std::optional<DriveKeys> keysOf(const Fitting& fitting);
/// As a part of the open edit. Throws std::runtime_error for what is no control key.
void setFittingKeys(Document& document, const FittingRef& ref, const DriveKeys& keys);

}  // namespace sulfurchamber
