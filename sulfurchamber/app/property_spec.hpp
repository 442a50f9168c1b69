// Rows for properties that stand in tables of the model.
#pragma once

#include <string>
#include <string_view>

#include "../model/document.hpp"
#include "value_row.hpp"

namespace sulfurchamber {

inline wxString utf8(std::string_view text) {
    return wxString::FromUTF8(text.data(), text.size());
}

/// What a row says of a property, which has the members of NumberProperty: its name, unit, help and
/// range. What the row gets and sets is still to be said.
template <class Property>
ValueSpec specOf(const Property& property) {
    ValueSpec spec;
    spec.name = utf8(property.name);
    spec.unit = utf8(property.unit);
    spec.help = utf8(property.help);
    spec.low = property.low;
    spec.high = property.high;
    if constexpr (requires { property.endless; }) {
        spec.scale = property.scale;
        spec.endless = utf8(property.endless);
        spec.whole = property.whole;
    }
    return spec;
}

/// Sets a value as a part of the step of this name, which begins unless it is open. What throws
/// takes the step back and is refused.
template <class Set>
void setInStep(Document& document, const std::string& label, const Set& set,
               const std::function<void(const std::string&)>& refuse) {
    if (!document.editing() || document.undoLabel() != label) document.begin(label);
    try {
        set();
    } catch (const std::exception& problem) {
        document.rollback();
        refuse(problem.what());
    }
}

}  // namespace sulfurchamber
