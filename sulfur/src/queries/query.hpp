// What all queries share: who is asked, and what a caller is told.
#pragma once

#include <cstdint>
#include <sulfur/queries.hpp>
#include <tuple>
#include <vector>

#include "queries/convex_hull.hpp"
#include "queries/nearby.hpp"

namespace sulfur::detail {

/// Throws unless both coordinates are in the range of queries.
void requireCoordinates(const Point& point, const char* what);

/// Whether a filter lets a query see a body.
bool admits(const State& state, const QueryFilter& filter, std::uint32_t body);

/// The bodies whose outlines enclose a point, ascending by dense index, that `filter` admits.
std::vector<std::uint32_t> enclosing(State& state, const Point& point, const QueryFilter& filter);

/// Where the way of something meets a collider.
struct Strike {
    Entry entry;
    Collider collider;

    /// Ties are won by the lower joint, then particle, so that the order of the search decides
    /// nothing.
    friend bool operator<(const Strike& x, const Strike& y) {
        return std::tie(x.entry.fraction, x.collider.joint, x.collider.a) <
               std::tie(y.entry.fraction, y.collider.joint, y.collider.a);
    }
};

/// What a caller is told about a hit at `point`, which need not be on the surface exactly.
CastHit hitAt(const State& state, const Strike& strike, const Point& point);

}  // namespace sulfur::detail
