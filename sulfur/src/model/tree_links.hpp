// What holds the nodes of trees and networks to each other.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

#include "core/slots.hpp"

namespace sulfur::detail {

/// What connects two nodes.
enum class LinkKind : std::uint8_t {
    joint,       // a distance: one row
    attachment,  // two points that stay together: two rows
    hinge,       // the same, inside a body (Clusters::hinges)
};

/// One end of a link: a particle, or a place of a cluster.
struct LinkEnd {
    std::uint32_t particle = none;  // of the joint; `none` where an attachment holds a place
    Point place{0, 0};              // m, in the frame of the node's cluster

    template <class Archive>
    void archive(Archive& a) {
        a(particle);
        a(place);
    }
};

}  // namespace sulfur::detail
