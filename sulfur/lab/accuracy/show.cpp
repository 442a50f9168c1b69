#include "accuracy/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "svg_plot.hpp"

namespace sulfur::lab {

namespace {

std::string cell(const WorkPoint& point) {
    if (!std::isfinite(point.error)) return "exploded";
    return fmt::format("{:.1e}@{:.1e}", point.error, point.cost);
}

std::string strainCell(const WorkPoint& point) {
    return std::isfinite(point.strain) ? fmt::format("{:.1e}", point.strain) : "exploded";
}

/// What strain is measured of, and its unit.
std::string strainOf(const AccuracyScene& scene) {
    return scene.pins.empty() ? "strain of a rigid joint" : "opening of a pin (m)";
}

/// The rates of the longest curve.
std::vector<int> ratesOf(const WorkPrecision& scene) {
    std::vector<int> rates;
    for (const WorkCurve& curve : scene.curves) {
        if (curve.points.size() <= rates.size()) continue;
        rates.clear();
        for (const WorkPoint& point : curve.points) rates.push_back(point.rate);
    }
    return rates;
}

/// A line for each curve, in columns of rates.
template <class Cell>
std::string table(const WorkPrecision& work, Cell&& cellOf) {
    std::string out = fmt::format("{:<22}", "rate (Hz)");
    for (const int rate : ratesOf(work)) out += fmt::format("{:>16}", rate);
    for (const WorkCurve& curve : work.curves) {
        out += fmt::format("\n{:<22}", curve.title);
        for (const WorkPoint& point : curve.points) out += fmt::format("{:>16}", cellOf(point));
    }
    return out + '\n';
}

/// The cheapest run of each kind that is no further off than `error`.
std::string cheapest(const WorkPrecision& scene, double error) {
    std::string text = fmt::format("  within {:g} m: ", error);
    for (const bool ours : {true, false}) {
        const WorkCurve* best = nullptr;
        WorkPoint bestPoint;
        for (const WorkCurve& curve : scene.curves) {
            for (const WorkPoint& point : curve.points) {
                if (curve.ours != ours || !(point.error <= error)) continue;
                if (best && point.cost >= bestPoint.cost) continue;
                best = &curve;
                bestPoint = point;
            }
        }
        text +=
            best ? fmt::format("{} at {} Hz, {:.2e} s", best->title, bestPoint.rate, bestPoint.cost)
                 : fmt::format("{}", ours ? "World not at all" : "no other method");
        if (ours) text += "; ";
    }
    return text + '\n';
}

}  // namespace

std::string asText(const std::vector<WorkPrecision>& scenes, const CostOptions& options) {
    std::string out = fmt::format(
        "Error against run time. A cell is the error in metres @ the processor time in seconds for "
        "the\nwhole scene, stepping only: the median of {} measurements of at least {:g} s. "
        "Exploded: further\noff than {:g} m, or not finite. An empty cell was not run, because the "
        "rate is not offered or a\nrun takes longer than {:g} s.\n",
        options.repeats, options.least, explosion, options.most);
    for (const WorkPrecision& work : scenes) {
        const AccuracyScene& scene = work.scene;
        out += fmt::format(
            "\n{}: {}\nError: {} from the reference, the largest at any multiple of "
            "{:g} s in {:g} s.\nReference: {}{}.\n",
            scene.key, scene.title, scene.error, scene.interval, scene.seconds(), scene.reference,
            scene.referenceError > 0 ? fmt::format(", itself within {:.1e} m", scene.referenceError)
                                     : "");
        if (scene.hasRigidJoints())
            out += fmt::format(
                "The World's joints are rigid; for the integrators, which know "
                "springs only, springs of {:.3g} N/m stand for them.\n",
                scene.rigidStandIn);
        out += table(work, cell);
        if (scene.isTied())
            out += fmt::format("The largest {} at the end of any tick:\n", strainOf(scene)) +
                   table(work, strainCell);
        out += "The cheapest:\n";
        for (const double error : {0.1, 0.01, 0.001, 0.0001}) out += cheapest(work, error);
        out += "Pareto front, from cheap to exact:\n";
        for (const FrontPoint& p : paretoFront(work))
            out += fmt::format("  {:<24}{:>7} Hz  {:.1e} m  {:.2e} s\n", p.title, p.point.rate,
                               p.point.error, p.point.cost);
    }
    return out;
}

std::string asCsv(const std::vector<WorkPrecision>& scenes) {
    std::string out = "scene,method,rate_hz,error_m,cpu_s,scene_s,reference_error_m,strain\n";
    for (const WorkPrecision& work : scenes)
        for (const WorkCurve& curve : work.curves)
            for (const WorkPoint& point : curve.points)
                out += fmt::format("{},{},{},{},{},{},{},{}\n", work.scene.key, curve.key,
                                   point.rate, point.error, point.cost, work.scene.seconds(),
                                   work.scene.referenceError, point.strain);
    return out;
}

std::string asJson(const std::vector<WorkPrecision>& scenes) {
    // JSON knows neither NaN nor infinity.
    const auto number = [](double value) {
        return std::isfinite(value) ? fmt::format("{}", value) : std::string("null");
    };
    std::string out = "{\n  \"scenes\": [";
    const char* sceneSeparator = "\n";
    for (const WorkPrecision& work : scenes) {
        out += fmt::format(
            "{}    {{\"scene\": \"{}\", \"title\": \"{}\", \"reference\": \"{}\", "
            "\"referenceError\": {}, \"seconds\": {}, \"points\": [",
            sceneSeparator, work.scene.key, work.scene.title, work.scene.reference,
            work.scene.referenceError, work.scene.seconds());
        sceneSeparator = ",\n";
        const char* separator = "\n";
        for (const WorkCurve& curve : work.curves) {
            for (const WorkPoint& point : curve.points) {
                out += fmt::format(
                    "{}      {{\"method\": \"{}\", \"rate\": {}, \"error\": {}, "
                    "\"cpuSeconds\": {}, \"strain\": {}}}",
                    separator, curve.key, point.rate, number(point.error), number(point.cost),
                    number(point.strain));
                separator = ",\n";
            }
        }
        out += "\n    ]}";
    }
    return out + "\n  ]\n}\n";
}

std::string asSvg(const WorkPrecision& work, Measure by) {
    constexpr double rounding = 1e-12;  // m; less is rounding, or the strain of what stands still
    static const std::map<std::string, const char*> colours{
        {"world-1", "#27ae60"},  {"world-4", "#117a65"}, {"world-16", "#0b3d2e"},
        {"euler", "#c0392b"},    {"suvat", "#d68910"},   {"rk2", "#7d8c1f"},
        {"rk2-held", "#7d8c1f"}, {"rk4", "#2471a3"},     {"rk4-held", "#2471a3"},
        {"nsv", "#6c3483"},      {"verlet", "#a569bd"},  {"implicit", "#707070"}};
    Plot plot;
    plot.title = work.scene.title;
    plot.xTitle = "processor time for the scene (s), stepping only";
    plot.yTitle = by == &WorkPoint::strain ? "largest " + strainOf(work.scene) : "error (m)";
    plot.xLogarithmic = true;
    double least = 1e9, most = 1e-9, low = 1, high = 1e-9;
    for (const WorkCurve& curve : work.curves) {
        Series series{curve.title, curve.colour.empty() ? colours.at(curve.key) : curve.colour,
                      false,       curve.ours,
                      true,        {}};
        series.dashed = curve.key.find("held") != std::string::npos ||
                        curve.key.find("stiff") != std::string::npos;
        for (const WorkPoint& point : curve.points) {
            const double value = point.*by;
            if (!std::isfinite(value) || !(value >= rounding)) continue;
            series.points.emplace_back(point.cost, value);
            least = std::min(least, point.cost);
            most = std::max(most, point.cost);
            low = std::min(low, value);
            high = std::max(high, value);
        }
        plot.series.push_back(std::move(series));
    }
    Series front{"Pareto front", "#f1c40f", true, false, true, {}};
    for (const FrontPoint& p : paretoFront(work, by, rounding))
        front.points.emplace_back(p.point.cost, p.point.*by);
    plot.series.push_back(std::move(front));
    for (double x = std::floor(std::log10(least)); x <= std::ceil(std::log10(most)); ++x)
        plot.xTicks.push_back(std::pow(10, x));
    plot.yLow = std::pow(10, std::floor(std::log10(low)));
    plot.yHigh = std::pow(10, std::ceil(std::log10(high)));
    plot.series.push_back({"reference: " + std::string(work.scene.reference.starts_with("analytic")
                                                           ? "analytic"
                                                           : "converged RK4"),
                           "none",
                           false,
                           false,
                           false,
                           {}});
    if (work.scene.hasRigidJoints())
        for (const char* line : {"the paper's integrators have", "springs for rigid joints"})
            plot.series.push_back({line, "none", false, false, false, {}});
    return draw(plot);
}

}  // namespace sulfur::lab
