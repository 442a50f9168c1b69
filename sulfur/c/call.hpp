// How every function of the C interface runs: no exception leaves it, and nothing is written
// unless all went well.
#pragma once

#include <sulfur/c/base.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <sulfur/error.hpp>

#include "convert.hpp"

namespace sulfur::c {

/// Leaves the exception that is being handled as the last error of this thread.
SulfurResult noteFailure() noexcept;

template <class Function>
SulfurResult call(Function&& function) noexcept {
    try {
        function();
        return SULFUR_OK;
    } catch (...) {
        return noteFailure();
    }
}

/// Leaves a value at `out`.
template <class Out, class Function>
SulfurResult give(Out* out, Function&& value) noexcept {
    return call([&] {
        Out& result = required(out, "a result");
        result = toC(value());
    });
}

/// Leaves a value at `out` if there is one.
template <class Out, class Function>
SulfurResult giveIfAny(Out* out, bool* found, Function&& value) noexcept {
    return call([&] {
        Out& result = required(out, "a result");
        bool& isThere = required(found, "found");
        const auto& answer = value();
        if (answer) result = toC(*answer);
        isThere = answer.has_value();
    });
}

/// Leaves the first entries at `out` and how many there are at `count`.
template <class Out, class Function>
SulfurResult giveList(Out* out, std::size_t capacity, std::size_t* count,
                      Function&& entries) noexcept {
    return call([&] {
        std::size_t& number = required(count, "count");
        if (capacity > 0) required(out, "out");
        const auto& all = entries();
        for (std::size_t i = 0; i < std::min(capacity, all.size()); ++i) out[i] = toC(all[i]);
        number = all.size();
    });
}

/// Leaves a new object, made of what `parts` returns, at `out`.
template <class Object, class Function>
SulfurResult make(Object** out, Function&& parts) noexcept {
    return call([&] {
        Object*& result = required(out, "a result");
        result = new Object{parts()};
    });
}

/// The entry at `index`.
template <class List>
auto& entry(List& list, std::size_t index, const char* what) {
    if (index < list.size()) return list[index];
    throw Error(ErrorCode::badIndex, std::string("there is no ") + what + " " +
                                         std::to_string(index) + "; allowed is less than " +
                                         std::to_string(list.size()));
}

}  // namespace sulfur::c
