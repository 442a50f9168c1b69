// How far it is to the exit along free space.
#pragma once

#include <quaoar/session.hpp>
#include <vector>

namespace quaoar {

/// Distances to the exit on a grid, flooded around what is solid and above what is deadly deep. A
/// straight line misleads a search wherever the way first leads away from the exit. Where nothing
/// above is in reach of the rope a metre counts as two.
class DistanceField {
public:
    static constexpr double cell = 0.25;  ///< metres

    explicit DistanceField(const Session& session);

    /// Metres to the exit from the nearest grid point; `unreachable` where there is no way or
    /// outside of the level.
    double at(const sulfur::Point& place) const;
    static constexpr double unreachable = 1e9;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    sulfur::Point place(int x, int y) const;
    void flood(const Session& session, int startX, int startY);

    sulfur::Point origin_{0, 0};
    int width_ = 0;
    int height_ = 0;
    std::vector<double> distances_;
};

}  // namespace quaoar
