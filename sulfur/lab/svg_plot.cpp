#include "svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sulfur::lab {

namespace {

constexpr double width = 900, height = 560;
constexpr double left = 80, right = 640, top = 60, bottom = 490;

class Drawing {
public:
    explicit Drawing(const Plot& plot) : plot_(plot) {
        const double first = plot.xTicks.front(), last = plot.xTicks.back();
        const double margin = 0.04 * (along(last) - along(first));
        xLow_ = along(first) - margin;
        xHigh_ = along(last) + margin;
    }

    std::string run() {
        out_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
            "height=\"{1}\" font-family=\"sans-serif\" font-size=\"14\">\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
            width, height);
        // A long title is set smaller, so that it ends within the picture.
        const double size =
            std::min(17.0, 1.7 * (width - left) / static_cast<double>(plot_.title.size()));
        text(left, 34, "start", plot_.title,
             fmt::format("font-size=\"{:.1f}\" font-weight=\"bold\"", size));
        axes();
        for (const Series& series : plot_.series) draw(series);
        legend();
        return out_ + "</svg>\n";
    }

private:
    double along(double x) const { return plot_.xLogarithmic ? std::log10(x) : x; }
    double px(double x) const {
        return left + (along(x) - xLow_) / (xHigh_ - xLow_) * (right - left);
    }
    double py(double y) const {
        const double low = std::log10(plot_.yLow), high = std::log10(plot_.yHigh);
        return bottom - (std::log10(y) - low) / (high - low) * (bottom - top);
    }

    void text(double x, double y, const char* anchor, const std::string& content,
              const std::string& more = "") {
        out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x,
                            y, anchor, more, content);
    }
    void line(double x1, double y1, double x2, double y2, const char* colour) {
        out_ += fmt::format(
            "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1,
            y1, x2, y2, colour);
    }

    void axes() {
        for (double y = plot_.yLow; y <= plot_.yHigh * 1.01; y *= 10) {
            line(left, py(y), right, py(y), "#d0d0d0");
            const std::string label =
                y < 1e4 && y > 1e-4
                    ? fmt::format("{:g}", y)
                    : fmt::format("10<tspan dy=\"-6\" font-size=\"10\">{:g}</tspan>",
                                  std::round(std::log10(y)));
            text(left - 8, py(y) + 5, "end", label);
        }
        for (const double x : plot_.xTicks) {
            line(px(x), top, px(x), bottom, "#e4e4e4");
            text(px(x), bottom + 22, "middle", fmt::format("{:g}", x));
        }
        out_ += fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
            "stroke=\"#404040\"/>\n",
            left, top, right - left, bottom - top);
        text((left + right) / 2, bottom + 50, "middle", plot_.xTitle);
        text(0, 0, "middle", plot_.yTitle,
             fmt::format("transform=\"translate(24 {}) rotate(-90)\"", (top + bottom) / 2));
    }

    void mark(const Series& series, double x, double y) {
        out_ += fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" stroke=\"{}\" "
            "stroke-width=\"2\"/>\n",
            x, y, series.hollow ? 6 : 3.5, series.hollow ? "none" : series.colour, series.colour);
    }
    std::string stroke(const Series& series) const {
        return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}", series.colour,
                           series.dashed ? " stroke-dasharray=\"6 4\"" : "");
    }

    void draw(const Series& series) {
        if (series.line && series.points.size() > 1) {
            std::string path;
            for (const auto& [x, y] : series.points)
                path += fmt::format("{}{:.1f},{:.1f}", path.empty() ? "" : " ", px(x), py(y));
            out_ += fmt::format("<polyline points=\"{}\" {}/>\n", path, stroke(series));
        }
        for (const auto& [x, y] : series.points) mark(series, px(x), py(y));
    }

    void legend() {
        // Many lines are set closer, so that the last one is within the picture.
        const double step =
            std::min(26.0, (height - top - 24) / static_cast<double>(plot_.series.size()));
        double y = top + 12;
        for (const Series& series : plot_.series) {
            const double x = right + 18;
            if (series.line)
                out_ += fmt::format("<path d=\"M{} {}h30\" {}/>\n", x, y, stroke(series));
            if (!series.points.empty()) mark(series, x + 15, y);
            text(x + 40, y + 5, "start", series.title);
            y += step;
        }
    }

    const Plot& plot_;
    double xLow_ = 0, xHigh_ = 1;
    std::string out_;
};

}  // namespace

std::string draw(const Plot& plot) {
    return Drawing(plot).run();
}

}  // namespace sulfur::lab
