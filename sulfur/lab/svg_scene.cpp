#include "svg_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace sulfur::lab {

namespace {

constexpr double pictureSize = 1000, margin = 20, titleHeight = 40;  // pixels
constexpr double widestView = 200;  // m; what is farther away is not in the picture

/// Told apart also by people who do not see all colours (Okabe and Ito, 2008).
constexpr std::array<const char*, 6> colours{"#0072b2", "#e69f00", "#009e73",
                                             "#cc79a7", "#56b4e9", "#d55e00"};

struct Line {
    Point a, b;
    double radius;  // m
    const char* colour;
    double opacity;
};

/// Collects what World::draw shows, because its extent has to be known first.
class Collector final : public DebugDraw {
public:
    void body(const Body& b) override {
        if (b.kind == BodyKind::dynamic) {
            colour_[b.id] = colours[next_++ % colours.size()];
            cover(b.low);
            cover(b.high);
        } else {
            colour_[b.id] = b.kind == BodyKind::fixed ? "#808080" : "#404040";
            others_.emplace_back(b.low, b.high);
        }
    }
    void capsule(const Capsule& c) override {
        lines.push_back({c.a, c.b, static_cast<double>(c.radius), colourOf(c.body), shade(c)});
    }
    void disc(const Disc& d) override {
        lines.push_back(
            {d.centre, d.centre, static_cast<double>(d.radius), colourOf(d.body), shade(d)});
    }
    void joint(const Joint& j) override { bones.emplace_back(j.a, j.b); }
    void contact(const ContactInfo& c) override { dots.push_back(c.point); }

    /// Around all that moves, and around the rest unless it is much larger, as floors are.
    void finish() {
        const double reach = seen_ ? 2 * (high - low).maxCoeff() + 2 : widestView;
        for (const auto& [from, to] : others_) {
            if ((to - from).maxCoeff() > reach) continue;
            cover(from);
            cover(to);
        }
        low -= Point(0.5, 0.5);
        high += Point(0.5, 0.5);
    }

    std::vector<Line> lines;
    std::vector<std::pair<Point, Point>> bones;
    std::vector<Point> dots;
    Point low{0, 0}, high{0, 0};

private:
    void cover(const Point& p) {
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > widestView) return;
        low = seen_ ? Point(low.cwiseMin(p)) : p;
        high = seen_ ? Point(high.cwiseMax(p)) : p;
        seen_ = true;
    }
    const char* colourOf(BodyId body) const {
        const auto found = colour_.find(body);
        return found == colour_.end() ? "#404040" : found->second;
    }
    template <class Thing>
    static double shade(const Thing& thing) {
        return thing.asleep ? 0.35 : 0.8;
    }

    std::map<BodyId, const char*> colour_;
    std::vector<std::pair<Point, Point>> others_;
    std::size_t next_ = 0;
    bool seen_ = false;
};

class Drawing {
public:
    explicit Drawing(const Collector& scene) : scene_(scene) {
        const Point size = scene.high - scene.low;
        scale_ = (pictureSize - 2 * margin) / size.maxCoeff();
        width_ = size.x() * scale_ + 2 * margin;
        height_ = size.y() * scale_ + 2 * margin + titleHeight;
    }

    std::string run(const std::string& title) {
        out_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
            "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"sans-serif\">\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
            "<text x=\"{2}\" y=\"28\" font-size=\"18\">{3}</text>\n",
            width_, height_, margin, title);
        for (const Line& line : scene_.lines)
            stroke(line.a, line.b, 2 * line.radius * scale_, line.colour, line.opacity);
        for (const auto& [a, b] : scene_.bones) stroke(a, b, 0.5, "#202020", 0.5);
        const double dotSize = std::clamp(0.04 * scale_, 1.5, 5.0);
        for (const Point& dot : scene_.dots) stroke(dot, dot, dotSize, "#d00000", 1);
        return out_ + "</svg>\n";
    }

private:
    double x(const Point& p) const { return (p.x() - scene_.low.x()) * scale_ + margin; }
    double y(const Point& p) const {
        return (scene_.high.y() - p.y()) * scale_ + margin + titleHeight;
    }
    /// A line with round ends; a dot where both ends are one place.
    void stroke(const Point& a, const Point& b, double width, const char* colour, double opacity) {
        if (!a.allFinite() || !b.allFinite()) return;
        out_ += fmt::format(
            "<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\" stroke=\"{}\" stroke-width=\"{:.2f}\" "
            "stroke-opacity=\"{:g}\" stroke-linecap=\"round\"/>\n",
            x(a), y(a), x(b), y(b), colour, width, opacity);
    }

    const Collector& scene_;
    double scale_ = 1, width_ = 0, height_ = 0;
    std::string out_;
};

}  // namespace

std::string drawScene(const World& world, const std::string& title) {
    Collector scene;
    world.draw(scene);
    scene.finish();
    return Drawing(scene).run(title);
}

}  // namespace sulfur::lab
