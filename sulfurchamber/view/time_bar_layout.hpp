// Where things stand on the time bar: ticks become pixels and back. Knows no window.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../model/timeline.hpp"

namespace sulfurchamber {

/// One picture of the time bar. The shown line lies lowest; other futures lie above it, each from
/// where it parted. A plain value; a new one is made for each picture.
class TimeBarLayout {
public:
    static constexpr int mostRows = 3;  ///< of other futures; more of them share the last row

    struct Lane {
        std::uint32_t branch = 0;
        double from = 0;  ///< pixels
        double to = 0;
        int row = 0;  ///< 0 is next to the line
    };
    struct Spot {
        double x = 0;
        Mark mark;
    };

    /// `width` in pixels. The bar has a second at least, so that what has just begun is no jump.
    TimeBarLayout(const Timeline& timeline, double tickSeconds, double width);

    bool empty() const { return line_ == 0; }
    /// Both ends of the shown line, pixels.
    double from() const { return place(first_); }
    double to() const { return place(last_); }
    /// Where the present moment is; nothing before time has passed.
    std::optional<double> now() const { return now_; }
    const std::vector<Lane>& lanes() const { return lanes_; }
    const std::vector<Spot>& spots() const { return spots_; }
    /// The moment of the shown line under a pixel. Precondition: not empty.
    Moment momentAt(double x) const;
    /// The same of another future that is under the pixel in this row, within `reach` pixels.
    std::optional<Moment> otherAt(double x, int row, double reach) const;
    /// "3.20 s", and what is marked within `reach` pixels.
    std::string textAt(double x, double reach) const;

private:
    double place(std::uint64_t tick) const;
    std::uint64_t tickAt(double x) const;

    std::uint32_t line_ = 0;
    std::uint64_t first_ = 0;
    std::uint64_t last_ = 0;
    std::uint64_t begin_ = 0;  ///< ticks at both ends of the bar
    std::uint64_t end_ = 1;
    double width_ = 1;
    double tickSeconds_ = 0;
    std::optional<double> now_;
    std::vector<Lane> lanes_;
    std::vector<Spot> spots_;
};

}  // namespace sulfurchamber
