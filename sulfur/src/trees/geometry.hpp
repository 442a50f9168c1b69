// The rows of a tree's links, for points and for rigid components.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/elimination.hpp"
#include "model/tree_scratch.hpp"

namespace sulfur::detail {

/// The row of a link's gradient along `direction` for a node that it holds at `arm`.
template <int N>
typename Elimination<N>::Vector rowAlong(const Point& direction, const Point& arm) {
    typename Elimination<N>::Vector row;
    row[0] = direction[0];
    row[1] = direction[1];
    if constexpr (N == 3) row[2] = arm[0] * direction[1] - arm[1] * direction[0];
    return row;
}

/// Rows and columns of a distance: it changes along `now`, and pushes along `push` at the arms of
/// `start`, where the step began.
template <int N>
void setDistance(typename Elimination<N>::Link& link, const Span& start, const Span& now,
                 const Point& pushDirection, const Point& direction) {
    link.rows = 1;
    link.rowHere[0] = rowAlong<N>(direction, now.armHere);
    link.rowThere[0] = -rowAlong<N>(direction, now.armThere);
    link.columnHere[0] = rowAlong<N>(pushDirection, start.armHere);
    link.columnThere[0] = -rowAlong<N>(pushDirection, start.armThere);
}

/// Rows and columns of two places that stay together.
template <int N>
void setMeeting(typename Elimination<N>::Link& link, const Span& start, const Span& now) {
    link.rows = 2;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const Point unit = axis == 0 ? Point(1, 0) : Point(0, 1);
        link.rowHere[axis] = rowAlong<N>(unit, now.armHere);
        link.rowThere[axis] = -rowAlong<N>(unit, now.armThere);
        link.columnHere[axis] = rowAlong<N>(unit, start.armHere);
        link.columnThere[axis] = -rowAlong<N>(unit, start.armThere);
        link.value[axis] = now.apart[static_cast<Eigen::Index>(axis)];
    }
    link.compliance = {0, 0};
}

/// Value and compliance of a distance for the solver, which works on C + alpha lambda = 0.
inline double complianceOf(const Elastic& e) {
    return e.rigid ? 0 : 1 / (e.hk + e.hb);
}
/// `error`: C; `change`: C since the step began; `lambda`: accumulated in it.
inline double valueOf(const Elastic& e, double error, double change, double lambda) {
    return e.rigid ? error : (lambda + e.hk * error + e.hb * change) / (e.hk + e.hb);
}

}  // namespace sulfur::detail
