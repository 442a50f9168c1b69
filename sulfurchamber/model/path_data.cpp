#include "path_data.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

constexpr int mostHalvings = 16;  // of a curve: 65,536 lines

// Numbers and flags of an attribute, from left to right.
class PathScanner {
public:
    explicit PathScanner(std::string_view text) : text_(text) {}

    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error(tr("character {}: {}", {std::to_string(at_ + 1), tr(what)}));
    }
    void skipSpace() {
        while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
    }
    void skipSeparators() {
        skipSpace();
        if (at_ < text_.size() && text_[at_] == ',') ++at_;
        skipSpace();
    }
    bool atEnd() {
        skipSpace();
        return at_ == text_.size();
    }
    // The next character, which stays; 0 at the end.
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    char take() { return text_[at_++]; }
    bool atNumber() {
        skipSeparators();
        const char c = peek();
        return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
    }

    double number() {
        skipSeparators();
        if (peek() == '+') ++at_;
        double value = 0;
        const auto [end, error] =
            std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error == std::errc::invalid_argument) fail("a number is missing");
        at_ = static_cast<std::size_t>(end - text_.data());
        if (error != std::errc{} || !(std::abs(value) <= PathLimits::coordinate))
            fail("the number is larger than 1e9");
        return value;
    }
    // 0 or 1, which need nothing between them.
    bool flag() {
        skipSeparators();
        const char c = peek();
        if (c != '0' && c != '1') fail("an arc's flag must be 0 or 1");
        ++at_;
        return c == '1';
    }
    std::string word() {
        skipSeparators();
        std::string name;
        while (at_ < text_.size() &&
               ((peek() >= 'a' && peek() <= 'z') || peek() == 'X' || peek() == 'Y'))
            name += take();
        skipSpace();
        return name;
    }

private:
    static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

    std::string_view text_;
    std::size_t at_ = 0;
};

Curve lineTo(const Point& end) {
    return {true, end, end, end};
}

// An arc of at most an eighth of a turn of the unit circle, from angle a to b.
Curve unitArc(double a, double b) {
    const double reach = 4.0 / 3 * std::tan((b - a) / 4);
    const Point from(std::cos(a), std::sin(a));
    const Point to(std::cos(b), std::sin(b));
    return {false, from + reach * Point(-from.y(), from.x()), to - reach * Point(-to.y(), to.x()),
            to};
}

void addArc(std::vector<Curve>& curves, const Affine& circle, double from, double sweep) {
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (std::numbers::pi / 4) - 1e-9)));
    for (int i = 0; i < pieces; ++i) {
        Curve curve = unitArc(from + sweep * i / pieces, from + sweep * (i + 1) / pieces);
        for (Point* point : {&curve.first, &curve.second, &curve.end}) *point = circle * *point;
        curves.push_back(curve);
    }
}

// The commands of a path, one after the other.
class PathReader {
public:
    explicit PathReader(std::string_view data) : in_(data) {}

    PenPath read() {
        char command = 0;
        while (!in_.atEnd()) {
            const bool repeats = in_.atNumber();
            if (!repeats)
                command = in_.take();
            else if (command == 0 || command == 'Z' || command == 'z')
                in_.fail("a command is missing");
            // More pairs after a move are lines.
            else if (command == 'M' || command == 'm')
                command = command == 'M' ? 'L' : 'l';
            if (path_.empty() && command != 'M' && command != 'm')
                in_.fail("a path begins with M or m");
            step(command);
            if (++count_ > PathLimits::curves) in_.fail("the path has more than 100000 parts");
        }
        std::erase_if(path_, [](const SubPath& one) { return one.curves.empty(); });
        return std::move(path_);
    }

private:
    Point pair(bool relative) {
        const double x = in_.number();
        const double y = in_.number();
        return relative ? Point(at_ + Point(x, y)) : Point(x, y);
    }
    // The pen goes on where the last stroke was closed.
    SubPath& stroke() {
        if (path_.back().closed) path_.push_back({at_, {}, false});
        return path_.back();
    }
    void line(const Point& to) {
        stroke().curves.push_back(lineTo(to));
        at_ = to;
    }
    void cubic(const Point& first, const Point& second, const Point& end) {
        stroke().curves.push_back({false, first, second, end});
        at_ = end;
    }
    void quadratic(const Point& control, const Point& end) {
        const Point from = at_;
        cubic(from + (control - from) * 2.0 / 3, end + (control - end) * 2.0 / 3, end);
    }

    void step(char command) {
        const bool relative = command >= 'a';
        const char kind = static_cast<char>(relative ? command - 'a' + 'A' : command);
        const char before = std::exchange(last_, kind);
        switch (kind) {
            case 'M':
                at_ = pair(relative);
                path_.push_back({at_, {}, false});
                break;
            case 'L':
                line(pair(relative));
                break;
            case 'H':
                line({in_.number() + (relative ? at_.x() : 0), at_.y()});
                break;
            case 'V':
                line({at_.x(), in_.number() + (relative ? at_.y() : 0)});
                break;
            case 'C':
            case 'S': {
                const bool smooth = kind == 'S';
                const bool follows = before == 'C' || before == 'S';
                const Point first = !smooth   ? pair(relative)
                                    : follows ? Point(2 * at_ - control_)
                                              : at_;
                control_ = pair(relative);
                cubic(first, control_, pair(relative));
                break;
            }
            case 'Q':
            case 'T': {
                const bool follows = before == 'Q' || before == 'T';
                if (kind == 'Q')
                    control_ = pair(relative);
                else
                    control_ = follows ? Point(2 * at_ - control_) : at_;
                quadratic(control_, pair(relative));
                break;
            }
            case 'A':
                arc(relative);
                break;
            case 'Z':
                path_.back().closed = true;
                at_ = path_.back().start;
                break;
            default:
                in_.fail(tr("\"{}\" is no command; allowed are M L H V C S Q T A Z",
                            {std::string(1, command)}));
        }
    }

    // From two ends to the centre: appendix F.6 of SVG 1.1.
    void arc(bool relative) {
        double rx = std::abs(in_.number());
        double ry = std::abs(in_.number());
        const double turn = in_.number() * std::numbers::pi / 180;
        const bool large = in_.flag();
        const bool clockwise = in_.flag();
        const Point from = at_;
        const Point to = pair(relative);
        if (from == to) return;
        if (rx == 0 || ry == 0) return line(to);
        const Eigen::Rotation2Dd turned(turn);
        const Point half = turned.inverse() * Point((from - to) / 2);
        const double fit = half.x() * half.x() / (rx * rx) + half.y() * half.y() / (ry * ry);
        if (fit > 1) {
            rx *= std::sqrt(fit);
            ry *= std::sqrt(fit);
        }
        const double rest = fit >= 1 ? 0 : 1 / fit - 1;
        const double sign = large == clockwise ? -1 : 1;
        const Point middle =
            sign * std::sqrt(rest) * Point(rx * half.y() / ry, -ry * half.x() / rx);
        const Point centre = turned * middle + (from + to) / 2;
        const auto angleOf = [&](const Point& p) {
            return std::atan2((p.y() - middle.y()) / ry, (p.x() - middle.x()) / rx);
        };
        const double start = angleOf(half);
        double sweep = angleOf(-half) - start;
        if (clockwise && sweep < 0) sweep += 2 * std::numbers::pi;
        if (!clockwise && sweep > 0) sweep -= 2 * std::numbers::pi;
        const Affine circle = Eigen::Translation2d(centre) * turned * Eigen::Scaling(Point(rx, ry));
        addArc(stroke().curves, circle, start, sweep);
        stroke().curves.back().end = at_ = to;
    }

    PathScanner in_;
    PenPath path_;
    Point at_{0, 0};
    Point control_{0, 0};  // the last one of a smooth curve
    char last_ = 0;
    std::size_t count_ = 0;
};

double offChord(const Point& a, const Point& b, const Point& point) {
    const Point way = b - a;
    const double length = way.norm();
    return length > 0 ? std::abs(sulfur::cross(way, point - a)) / length : (point - a).norm();
}

// Halves until the control points are near the chord and between its ends: the curve is within
// three quarters of their distance.
void addLines(Outline& line, const Point& a, const Point& b, const Point& c, const Point& d,
              double tolerance, int left) {
    const Point way = d - a;
    const auto between = [&](const Point& p) {
        const double along = way.dot(p - a);
        return along >= -tolerance * way.norm() &&
               along <= way.squaredNorm() + tolerance * way.norm();
    };
    const bool flat = std::max(offChord(a, d, b), offChord(a, d, c)) * 0.75 <= tolerance &&
                      between(b) && between(c);
    if (flat || left == 0) {
        line.push_back(d);
        return;
    }
    const Point ab = (a + b) / 2, bc = (b + c) / 2, cd = (c + d) / 2;
    const Point abc = (ab + bc) / 2, bcd = (bc + cd) / 2;
    const Point middle = (abc + bcd) / 2;
    addLines(line, a, ab, abc, middle, tolerance, left - 1);
    addLines(line, middle, bcd, cd, d, tolerance, left - 1);
}

}  // namespace

PenPath readPathData(std::string_view data) {
    return PathReader(data).read();
}

PenPath ellipsePath(const Point& centre, double radiusX, double radiusY) {
    const Affine circle = Eigen::Translation2d(centre) * Eigen::Scaling(Point(radiusX, radiusY));
    SubPath path{circle * Point(1, 0), {}, true};
    addArc(path.curves, circle, 0, 2 * std::numbers::pi);
    return {path};
}

PenPath linePath(const std::vector<Point>& points, bool closed) {
    if (points.size() < 2) return {};
    SubPath path{points.front(), {}, closed};
    for (std::size_t i = 1; i < points.size(); ++i) path.curves.push_back(lineTo(points[i]));
    return {path};
}

std::vector<double> readNumbers(std::string_view text) {
    PathScanner in(text);
    std::vector<double> numbers;
    while (!in.atEnd()) {
        numbers.push_back(in.number());
        if (numbers.size() > 2 * PathLimits::curves) in.fail("there are more than 200000 numbers");
    }
    return numbers;
}

Affine readTransform(std::string_view text) {
    PathScanner in(text);
    Affine whole = Affine::Identity();
    for (in.skipSeparators(); !in.atEnd(); in.skipSeparators()) {
        const std::string name = in.word();
        if (in.peek() != '(') in.fail("a transform such as translate(1, 2) is expected");
        in.take();
        std::vector<double> n;
        while (in.atNumber()) n.push_back(in.number());
        if (in.peek() != ')') in.fail("a bracket is not closed");
        in.take();
        const auto degrees = [](double angle) { return angle * std::numbers::pi / 180; };
        Affine one = Affine::Identity();
        if (name == "matrix" && n.size() == 6)
            one.matrix() << n[0], n[2], n[4], n[1], n[3], n[5], 0, 0, 1;
        else if (name == "translate" && (n.size() == 1 || n.size() == 2))
            one.translate(Point(n[0], n.size() == 2 ? n[1] : 0));
        else if (name == "scale" && (n.size() == 1 || n.size() == 2))
            one.scale(Point(n[0], n.back()));
        else if (name == "rotate" && n.size() == 1)
            one.rotate(degrees(n[0]));
        else if (name == "rotate" && n.size() == 3)
            one = Eigen::Translation2d(n[1], n[2]) * Eigen::Rotation2Dd(degrees(n[0])) *
                  Eigen::Translation2d(-n[1], -n[2]);
        else if (name == "skewX" && n.size() == 1)
            one.matrix()(0, 1) = std::tan(degrees(n[0]));
        else if (name == "skewY" && n.size() == 1)
            one.matrix()(1, 0) = std::tan(degrees(n[0]));
        else
            in.fail(
                tr("\"{}\" with {} numbers is no transform; allowed are matrix, translate, "
                   "scale, rotate, skewX, skewY",
                   {name, std::to_string(n.size())}));
        whole = whole * one;
    }
    return whole;
}

PenPath transformed(const PenPath& path, const Affine& by) {
    PenPath result = path;
    for (SubPath& one : result) {
        one.start = by * one.start;
        for (Curve& curve : one.curves)
            for (Point* point : {&curve.first, &curve.second, &curve.end}) *point = by * *point;
    }
    return result;
}

Outline flattened(const SubPath& path, double tolerance) {
    Outline line{path.start};
    for (const Curve& curve : path.curves) {
        if (curve.straight)
            line.push_back(curve.end);
        else
            addLines(line, Point(line.back()), curve.first, curve.second, curve.end, tolerance,
                     mostHalvings);
    }
    line.erase(std::unique(line.begin(), line.end()), line.end());
    while (line.size() > 1 && line.back() == line.front()) line.pop_back();
    return line;
}

}  // namespace sulfurchamber
