// How a diagram of measured series is laid out: axes, what is shown, what is read. Knows no window.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../model/measurement.hpp"

namespace sulfurchamber {

/// A range of values on pixels. `from` may be below `to` on the screen: then it runs upwards.
struct PlotScale {
    double low = 0;
    double high = 1;
    double from = 0;  ///< pixel of `low`
    double to = 1;    ///< pixel of `high`

    double pixel(double value) const { return from + (value - low) / (high - low) * (to - from); }
    double value(double pixel) const { return low + (pixel - from) / (to - from) * (high - low); }
};

/// Round numbers within a range, `most` at most: 1, 2 or 5 times a power of ten apart.
std::vector<double> roundNumbers(double low, double high, int most);
/// The shortest text that tells neighbours `step` apart.
std::string numberText(double value, double step);

/// The time that is shown: all of it, or a part.
class PlotRange {
public:
    /// Of all samples, a second at least.
    static std::pair<double, double> whole(std::span<const Series> series);
    /// Shows the part between two times, in either order; all where it is shorter than 0.01 s.
    void show(double from, double to);
    void showAll() { part_.reset(); }
    /// Smaller than 1 shows less time around `about`.
    void zoom(std::span<const Series> series, double factor, double about);
    std::pair<double, double> shown(std::span<const Series> series) const;
    bool zoomed() const { return part_.has_value(); }

private:
    std::optional<std::pair<double, double>> part_;
};

/// What is laid over a series.
enum class FitKind : std::uint8_t { none, mean, line, sine };
/// A fit of what is shown, ready to be drawn and read. Nothing where it cannot be made.
struct Fitted {
    std::string text;  ///< "slope -9.81 m/s per s"
    std::optional<LineFit> line;
    std::optional<SineFit> sine;
    double mean = 0;
    double at(double time) const;
};
std::optional<Fitted> fitted(const Series& series, std::pair<double, double> shown, FitKind fit);

/// Units of the series in the order in which they come, each once: each has a scale of its own.
std::vector<std::string_view> unitsOf(std::span<const Series> series);
/// The range of all that is shown of a unit, with a little room.
std::pair<double, double> valuesOf(std::span<const Series> series, std::string_view unit,
                                   std::pair<double, double> shown);

/// A line of the legend: of a series, or how many have no room.
struct LegendLine {
    std::optional<std::size_t> series;
    std::string text;
};
/// The legend in so much width and so many lines. `values` and `fits` are what stands behind the
/// titles of the series, or empty. Where they are too long titles say only what tells them apart,
/// then they are shortened in the middle; fits go to lines of their own. "+3": as many have no
/// room.
std::vector<LegendLine> legendLines(std::span<const Series> series,
                                    std::span<const std::string> values,
                                    std::span<const std::string> fits, double width,
                                    std::size_t most,
                                    const std::function<double(const std::string&)>& widthOf);

/// A line of a picture: at most two points for a pixel, so that no peak is lost.
std::vector<std::pair<double, double>> curve(std::span<const Sample> samples, const PlotScale& time,
                                             const PlotScale& values);

}  // namespace sulfurchamber
