#include "battery/joints/joints.hpp"

namespace sulfur::lab {

Rows joints(const Setup& setup) {
    Rows rows;
    for (const auto family : {rolling, bending, motors, limits, sliders, bumps, gears, ragdolls})
        for (Row& row : family(setup)) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
