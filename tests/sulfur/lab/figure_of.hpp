#pragma once

#include <gtest/gtest.h>

#include <string>

#include "bench/scenes.hpp"

namespace sulfur::lab::bench {

/// The figure of that name; fails the test without one.
inline double figureOf(const Figures& figures, const std::string& name) {
    for (const Figure& figure : figures)
        if (figure.name == name) return figure.value;
    ADD_FAILURE() << name;
    return 0;
}

}  // namespace sulfur::lab::bench
