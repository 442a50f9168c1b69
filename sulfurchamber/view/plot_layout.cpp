#include "plot_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "../model/words.hpp"

namespace sulfurchamber {
namespace {

constexpr double shortestTime = 0.01;  // seconds that can be shown alone
constexpr double roomAround = 0.06;    // of the range of values

std::string printed(const char* format, double value) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

}  // namespace

std::vector<double> roundNumbers(double low, double high, int most) {
    const double least = (high - low) / std::max(1, most);
    if (!(least > 0) || !std::isfinite(least)) return {};
    const double power = std::pow(10, std::floor(std::log10(least)));
    double step = 10 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least) {
            step = factor * power;
            break;
        }
    std::vector<double> numbers;
    for (double n = std::ceil(low / step); n * step <= high + 1e-9 * step; ++n)
        numbers.push_back(n * step == 0 ? 0 : n * step);
    return numbers;
}

std::string numberText(double value, double step) {
    const int digits =
        step > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9) : 3;
    if (std::abs(value) >= 1e5 || (digits > 5 && value != 0)) return printed("%.3g", value);
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, value);
    return text.data();
}

// --- the time that is shown ------------------------------------------------------------------

std::pair<double, double> PlotRange::whole(std::span<const Series> series) {
    double low = INFINITY;
    double high = -INFINITY;
    for (const Series& one : series) {
        if (one.samples.empty()) continue;
        low = std::min(low, one.samples.front().time);
        high = std::max(high, one.samples.back().time);
    }
    if (!(low <= high)) return {0, 1};
    return {low, std::max(high, low + 1)};
}

void PlotRange::show(double from, double to) {
    if (std::abs(to - from) >= shortestTime)
        part_ = std::minmax({from, to});
    else
        showAll();
}

void PlotRange::zoom(std::span<const Series> series, double factor, double about) {
    const auto [low, high] = shown(series);
    const auto [first, last] = whole(series);
    double from = about - (about - low) * factor;
    double to = about + (high - about) * factor;
    if (to - from < shortestTime) return;
    from = std::max(from, first);
    to = std::min(to, last);
    if (to - from >= (last - first) * 0.999)
        showAll();
    else
        show(from, to);
}

std::pair<double, double> PlotRange::shown(std::span<const Series> series) const {
    return part_ ? *part_ : whole(series);
}

// --- fits ------------------------------------------------------------------------------------

double Fitted::at(double time) const {
    if (line) return line->at(time);
    return sine ? sine->at(time) : mean;
}

std::optional<Fitted> fitted(const Series& series, std::pair<double, double> shown, FitKind fit) {
    const auto samples = between(series.samples, shown.first, shown.second);
    const std::string unit =
        series.quantity->unit.empty() ? "" : " " + std::string(series.quantity->unit);
    Fitted made;
    if (samples.empty() || fit == FitKind::none) return std::nullopt;
    made.mean = mean(samples);
    if (fit == FitKind::mean) made.text = tr("mean {}", {printed("%.4g", made.mean) + unit});
    if (fit == FitKind::line) {
        made.line = fitLine(samples);
        if (!made.line) return std::nullopt;
        made.text = tr("slope {} per s", {printed("%.4g", made.line->slope) + unit});
    }
    if (fit == FitKind::sine) {
        made.sine = fitSine(samples);
        if (!made.sine) return std::nullopt;
        made.text = tr("sine {} Hz, ±{}", {printed("%.4g", made.sine->frequency),
                                           printed("%.3g", made.sine->amplitude) + unit});
    }
    return made;
}

// --- scales and curves -----------------------------------------------------------------------

std::vector<std::string_view> unitsOf(std::span<const Series> series) {
    std::vector<std::string_view> units;
    for (const Series& one : series)
        if (std::find(units.begin(), units.end(), one.quantity->unit) == units.end())
            units.push_back(one.quantity->unit);
    return units;
}

std::pair<double, double> valuesOf(std::span<const Series> series, std::string_view unit,
                                   std::pair<double, double> shown) {
    double low = INFINITY;
    double high = -INFINITY;
    for (const Series& one : series) {
        if (one.quantity->unit != unit) continue;
        for (const Sample& sample : between(one.samples, shown.first, shown.second)) {
            low = std::min(low, sample.value);
            high = std::max(high, sample.value);
        }
    }
    if (!(low <= high)) return {0, 1};
    // What hardly changes is no noise that fills the picture.
    const double least = std::max(1e-3 * std::max(std::abs(low), std::abs(high)), 1e-6);
    const double room = std::max(roomAround * (high - low), least);
    return {low - room, high + room};
}

std::vector<std::pair<double, double>> curve(std::span<const Sample> samples, const PlotScale& time,
                                             const PlotScale& values) {
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < samples.size();) {
        const double column = std::floor(time.pixel(samples[i].time));
        std::size_t lowest = i;
        std::size_t highest = i;
        // An empty range has no pixels, and NaN is not itself: one sample goes on in any case.
        for (++i; i < samples.size() && std::floor(time.pixel(samples[i].time)) == column; ++i) {
            if (samples[i].value < samples[lowest].value) lowest = i;
            if (samples[i].value > samples[highest].value) highest = i;
        }
        const auto add = [&](std::size_t at) {
            points.emplace_back(time.pixel(samples[at].time), values.pixel(samples[at].value));
        };
        add(std::min(lowest, highest));
        if (lowest != highest) add(std::max(lowest, highest));
    }
    return points;
}

// --- the legend ------------------------------------------------------------------------------

namespace {

using WidthOf = std::function<double(const std::string&)>;

// Characters of UTF-8, not bytes.
std::vector<std::string> charactersOf(const std::string& text) {
    std::vector<std::string> characters;
    for (const char byte : text) {
        const bool continues = (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
        if (continues && !characters.empty())
            characters.back() += byte;
        else
            characters.emplace_back(1, byte);
    }
    return characters;
}

// Without as much of its middle as is too wide.
std::string shortened(const std::string& text, double width, const WidthOf& widthOf) {
    if (widthOf(text) <= width) return text;
    const auto characters = charactersOf(text);
    if (characters.empty()) return text;
    std::string found;
    for (std::size_t kept = characters.size() - 1; kept > 0; --kept) {
        const std::size_t first = (kept + 1) / 2;
        found.clear();
        for (std::size_t i = 0; i < first; ++i) found += characters[i];
        found += "\xE2\x80\xA6";
        for (std::size_t i = characters.size() - (kept - first); i < characters.size(); ++i)
            found += characters[i];
        if (widthOf(found) <= width) break;
    }
    return found;
}

// What tells a series apart from the others, if that is less than its title.
std::string briefTitle(std::span<const Series> all, const Series& one) {
    const auto same = [&](auto Series::*part) {
        return std::all_of(all.begin(), all.end(),
                           [&](const Series& other) { return other.*part == one.*part; });
    };
    if (same(&Series::subject)) return tr(std::string(one.quantity->name));
    return same(&Series::quantity) ? tr(one.subject) : one.title();
}

}  // namespace

std::vector<LegendLine> legendLines(std::span<const Series> series,
                                    std::span<const std::string> values,
                                    std::span<const std::string> fits, double width,
                                    std::size_t most, const WidthOf& widthOf) {
    std::vector<LegendLine> lines;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const std::string fit = fits[i].empty() ? "" : "   " + fits[i];
        std::vector<LegendLine> own;
        std::string title = series[i].title();
        if (widthOf(title + values[i] + fit) <= width) {
            own.push_back({i, title + values[i] + fit});
        } else {
            if (widthOf(title + values[i]) > width) title = briefTitle(series, series[i]);
            title = shortened(title, width - widthOf(values[i]), widthOf);
            own.push_back({i, title + values[i]});
            if (!fit.empty()) own.push_back({i, shortened(fit, width, widthOf)});
        }
        const std::size_t rest = i + 1 < series.size() ? 1 : 0;  // a line that says how many
        if (lines.size() + own.size() + rest > most) {
            lines.push_back({std::nullopt, "+" + std::to_string(series.size() - i)});
            break;
        }
        lines.insert(lines.end(), own.begin(), own.end());
    }
    return lines;
}

}  // namespace sulfurchamber
