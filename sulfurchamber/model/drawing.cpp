#include "drawing.hpp"

#include <libxml/parser.h>
#include <libxml/tree.h>

#include <algorithm>
#include <array>
#include <atlax/files.hpp>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

#include "file_kind.hpp"
#include "path_data.hpp"
#include "refusals.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

[[noreturn]] void refuseDrawing(const std::string& name, const std::string& why) {
    throw std::runtime_error(name + ": " + why);
}

struct FreeXml {
    void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};

std::string attribute(const xmlNode& node, const char* name) {
    for (const xmlAttr* one = node.properties; one != nullptr; one = one->next)
        if (xmlStrEqual(one->name, reinterpret_cast<const xmlChar*>(name)) != 0 &&
            one->children != nullptr && one->children->content != nullptr)
            return reinterpret_cast<const char*>(one->children->content);
    return "";
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

// A property as an attribute, or in "style", which comes first.
std::string presentation(const xmlNode& node, const std::string& name) {
    const std::string style = attribute(node, "style");
    for (std::size_t at = 0; at < style.size();) {
        const std::size_t end = std::min(style.find(';', at), style.size());
        const std::string entry = style.substr(at, end - at);
        const std::size_t colon = entry.find(':');
        if (colon != std::string::npos && trimmed(entry.substr(0, colon)) == name)
            return trimmed(entry.substr(colon + 1));
        at = end + 1;
    }
    return trimmed(attribute(node, name.c_str()));
}

// In user units; absent: `otherwise`.
double lengthOf(const xmlNode& node, const char* name, double otherwise) {
    const std::string text = trimmed(attribute(node, name));
    if (text.empty()) return otherwise;
    double value = 0;
    const char* begin = text.data() + (text.front() == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    static const std::map<std::string, double> units{
        {"", 1},    {"px", 1},         {"mm", 96 / 25.4}, {"cm", 96 / 2.54},
        {"in", 96}, {"pt", 96.0 / 72}, {"pc", 16}};
    const auto unit = units.find(std::string(end, text.data() + text.size()));
    if (error != std::errc{} || unit == units.end() || !(std::abs(value) <= PathLimits::coordinate))
        throw std::runtime_error(tr(
            "{} is \"{}\"; allowed is a number, also with px, mm, cm, in, pt or pc", {name, text}));
    return value * unit->second;
}

// "#rrggbb" of "#rgb" and "#rrggbb"; of others none.
std::string colourOfFill(const std::string& fill) {
    const bool hex = fill.starts_with('#') &&
                     fill.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (hex && fill.size() == 7) return fill;
    if (!hex || fill.size() != 4) return "";
    std::string colour = "#";
    for (std::size_t i = 1; i < 4; ++i) colour += std::string(2, fill[i]);
    return colour;
}

PenPath rectPath(const xmlNode& node) {
    const double x = lengthOf(node, "x", 0);
    const double y = lengthOf(node, "y", 0);
    const double width = lengthOf(node, "width", 0);
    const double height = lengthOf(node, "height", 0);
    if (!(width > 0) || !(height > 0)) return {};
    double rx = lengthOf(node, "rx", -1);
    double ry = lengthOf(node, "ry", -1);
    if (rx < 0) rx = ry;
    if (ry < 0) ry = rx;
    rx = std::clamp(rx, 0.0, width / 2);
    ry = std::clamp(ry, 0.0, height / 2);
    if (rx == 0 || ry == 0)
        return linePath({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, true);
    // The four quarters of an ellipse, moved apart: lines lie between them.
    const PenPath round = ellipsePath({0, 0}, rx, ry);
    SubPath path;
    path.closed = true;
    const std::size_t quarter = round[0].curves.size() / 4;
    const std::array<Point, 4> centres{Point(x + width - rx, y + height - ry),
                                       Point(x + rx, y + height - ry), Point(x + rx, y + ry),
                                       Point(x + width - rx, y + ry)};
    path.start = round[0].start + centres[0];
    for (std::size_t k = 0; k < 4; ++k) {
        const Point begin =
            (k == 0 ? round[0].start : round[0].curves[k * quarter - 1].end) + centres[k];
        if (k > 0) path.curves.push_back({true, begin, begin, begin});
        for (std::size_t i = 0; i < quarter; ++i) {
            Curve curve = round[0].curves[k * quarter + i];
            for (Point* point : {&curve.first, &curve.second, &curve.end}) *point += centres[k];
            path.curves.push_back(curve);
        }
    }
    return {path};
}

PenPath penPathOf(const xmlNode& node, const std::string& kind) {
    if (kind == "path") return readPathData(attribute(node, "d"));
    if (kind == "rect") return rectPath(node);
    if (kind == "circle" || kind == "ellipse") {
        const Point centre(lengthOf(node, "cx", 0), lengthOf(node, "cy", 0));
        const bool circle = kind == "circle";
        const double rx = lengthOf(node, circle ? "r" : "rx", 0);
        const double ry = circle ? rx : lengthOf(node, "ry", 0);
        return rx > 0 && ry > 0 ? ellipsePath(centre, rx, ry) : PenPath{};
    }
    const auto numbers = readNumbers(attribute(node, "points"));
    if (numbers.size() % 2 != 0)
        throw std::runtime_error(tr("points has {} numbers; allowed is two for each point",
                                    {std::to_string(numbers.size())}));
    std::vector<Point> points;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
        points.emplace_back(numbers[i], numbers[i + 1]);
    return linePath(points, kind == "polygon");
}

struct DrawnPath {
    std::string name;
    PenPath path;  // in the units of the drawing
    FillRule rule = FillRule::nonzero;
    bool filled = true;
    std::string colour;
};

// What groups hand down.
struct Inherited {
    Affine place = Affine::Identity();
    std::string fill;
    std::string rule;
};

class DrawingReader {
public:
    DrawingReader(std::string name, std::vector<std::string>& leftOut)
        : file_(std::move(name)), leftOut_(leftOut) {}

    void visit(const xmlNode& node, Inherited from, int depth) {
        if (node.type != XML_ELEMENT_NODE) return;
        if (++elements_ > DrawingLimits::elements)
            refuseDrawing(file_, "has more than 20000 elements");
        if (depth > DrawingLimits::depth)
            refuseDrawing(file_, "has more than 100 groups in each other");
        const std::string kind = reinterpret_cast<const char*>(node.name);
        if (presentation(node, "display") == "none") return;
        const bool group = kind == "svg" || kind == "g" || kind == "a" || kind == "switch";
        const bool shape = kind == "path" || kind == "rect" || kind == "circle" ||
                           kind == "ellipse" || kind == "polygon" || kind == "polyline";
        const std::string called = nameOf(node, kind);
        if (kind == "use" || kind == "image" || kind == "text")
            leftOut_.push_back(called + ": " +
                               tr("a {} is no outline; make it a path first", {kind}));
        if (!group && !shape) return;
        if (shape && paths.size() == DrawingLimits::shapes)
            refuseDrawing(file_, "has more than 500 shapes");
        try {
            inherit(node, from);
            if (shape) add(node, kind, called, from);
        } catch (const std::runtime_error& error) {
            leftOut_.push_back(tr("{}, line {}: {}", {called, std::to_string(xmlGetLineNo(&node)),
                                                      trRefusal(error.what())}));
            return;
        }
        if (group)
            for (const xmlNode* child = node.children; child != nullptr; child = child->next)
                visit(*child, from, depth + 1);
    }

    std::vector<DrawnPath> paths;

private:
    static std::string nameOf(const xmlNode& node, const std::string& kind) {
        std::string name = attribute(node, "id");
        if (name.empty()) name = kind;
        if (name.size() > 60) name.resize(60);
        for (char& c : name)
            if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126 ||
                c == '"' || c == '\\')
                c = '-';
        return name;
    }

    static void inherit(const xmlNode& node, Inherited& from) {
        if (const std::string t = attribute(node, "transform"); !t.empty())
            from.place = from.place * readTransform(t);
        if (const std::string fill = presentation(node, "fill"); !fill.empty()) from.fill = fill;
        if (const std::string rule = presentation(node, "fill-rule"); !rule.empty())
            from.rule = rule;
    }

    void add(const xmlNode& node, const std::string& kind, const std::string& called,
             const Inherited& from) {
        PenPath path = transformed(penPathOf(node, kind), from.place);
        if (path.empty()) return;
        if (path.size() > DrawingLimits::outlines)
            throw std::runtime_error(
                tr("has {} outlines; allowed are at most 200", {std::to_string(path.size())}));
        if (paths.size() == DrawingLimits::shapes) refuseDrawing(file_, "has more than 500 shapes");
        paths.push_back({called, std::move(path),
                         from.rule == "evenodd" ? FillRule::evenOdd : FillRule::nonzero,
                         from.fill != "none", colourOfFill(from.fill)});
    }

    std::string file_;
    std::vector<std::string>& leftOut_;
    std::size_t elements_ = 0;
};

std::unique_ptr<xmlDoc, FreeXml> parseXml(std::string_view text, const std::string& name) {
    if (text.size() > DrawingLimits::bytes)
        refuseDrawing(name,
                      tr("has {} bytes; allowed are at most {}",
                         {std::to_string(text.size()), std::to_string(DrawingLimits::bytes)}));
    if (text.starts_with("\x1F\x8B"))
        refuseDrawing(name, "is a compressed drawing; save it as plain SVG first");
    // Nothing is fetched and no entity is replaced by its text; depth and sizes have libxml2's own
    // limits.
    const int options = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
    std::unique_ptr<xmlDoc, FreeXml> document(
        xmlReadMemory(text.data(), static_cast<int>(text.size()), nullptr, nullptr, options));
    if (document == nullptr) {
        const auto* error = xmlGetLastError();
        if (error == nullptr || error->message == nullptr)
            refuseDrawing(name, "is not well-formed");
        refuseDrawing(name, tr("is not well-formed, line {}: {}",
                               {std::to_string(error->line), trimmed(error->message)}));
    }
    return document;
}

// Of the lines that stay within `tolerance` of the curves.
Bounds boundsOf(const std::vector<DrawnPath>& paths, double tolerance) {
    std::optional<Bounds> bounds;
    for (const DrawnPath& drawn : paths)
        for (const SubPath& one : drawn.path)
            for (const Point& point : flattened(one, tolerance)) {
                if (!bounds) bounds = Bounds{point, point};
                bounds->include(point);
            }
    return bounds.value_or(Bounds{});
}

void checkOptions(const DrawingOptions& options) {
    if (!(options.size >= DrawingLimits::leastSize && options.size <= DrawingLimits::mostSize))
        throw std::runtime_error("the size must be 0.01 m to 100 m");
    if (!(options.tolerance >= 1e-5 && options.tolerance <= 1))
        throw std::runtime_error("the accuracy must be 0.00001 m to 1 m");
}

// The outlines of one path as shapes, in metres.
void addShapesOf(const DrawnPath& drawn, const Affine& toMetres, double tolerance,
                 std::size_t& points, Drawing& drawing, const std::string& file) {
    std::vector<Outline> outlines;
    for (const SubPath& one : transformed(drawn.path, toMetres)) {
        if (!one.closed && !drawn.filled) continue;
        Outline line = simplified(flattened(one, tolerance / 2), tolerance / 2, true);
        points += line.size();
        if (points > DrawingLimits::points)
            refuseDrawing(file,
                          "has more than 60000 corners; allow lines to miss its curves by "
                          "more, or make it simpler");
        if (line.size() > 2) outlines.push_back(std::move(line));
    }
    const auto regions = regionsOf(outlines, drawn.rule);
    if (regions.empty()) drawing.leftOut.push_back(drawn.name + ": " + tr("encloses nothing"));
    for (const Region& region : regions)
        drawing.shapes.push_back({drawn.name, region, drawn.colour});
}

void requireShapes(const Drawing& drawing, const std::string& name) {
    if (!drawing.shapes.empty()) return;
    if (drawing.leftOut.empty()) refuseDrawing(name, "holds no closed outline");
    refuseDrawing(name, tr("holds no closed outline ({})", {drawing.leftOut.front()}));
}

}  // namespace

Drawing readDrawing(std::string_view svg, const std::string& name, const DrawingOptions& options) {
    checkOptions(options);
    const auto document = parseXml(svg, name);
    const xmlNode* root = xmlDocGetRootElement(document.get());
    if (root == nullptr || xmlStrEqual(root->name, reinterpret_cast<const xmlChar*>("svg")) == 0)
        refuseDrawing(name, "is XML, but no SVG drawing");
    Drawing drawing;
    DrawingReader reader(name, drawing.leftOut);
    reader.visit(*root, {}, 0);
    // The ends of curves tell how fine is fine enough to find out how far they go.
    const double rough = boundsOf(reader.paths, 1e300).size().maxCoeff();
    const Bounds bounds = boundsOf(reader.paths, std::max(rough / 1000, 1e-9));
    const double longest = bounds.size().maxCoeff();
    if (!(longest > 0) || !std::isfinite(longest)) requireShapes(drawing, name);
    const double scale = options.size / longest;
    const Affine toMetres =
        Eigen::Scaling(Point(scale, -scale)) * Eigen::Translation2d(-bounds.centre());
    std::size_t points = 0;
    for (const DrawnPath& drawn : reader.paths)
        addShapesOf(drawn, toMetres, options.tolerance, points, drawing, name);
    requireShapes(drawing, name);
    return drawing;
}

Drawing readOutlines(const std::filesystem::path& file, const DrawingOptions& options) {
    const std::string name = file.filename().string();
    switch (kindOfFile(file)) {
        case FileKind::drawing:
            return readDrawing(atlax::readFile(file, DrawingLimits::bytes), name, options);
        case FileKind::picture:
            return traced(atlax::loadImage(file), name, options);
        default:
            refuseDrawing(name, "is neither an SVG drawing nor a picture (PNG)");
    }
}

}  // namespace sulfurchamber
