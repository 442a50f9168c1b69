// Bodies and their fixtures; joints are in rube_joints.cpp.
#include "rube.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <numbers>

#include "refusals.hpp"
#include "region.hpp"
#include "rube_reader.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;
using sulfur::scene::Node;

constexpr double mostMetres = 1e5;
constexpr double mostNumber = 1e6;
constexpr int cornersOfRound = 24;  // of a circle that something holds beside its middle
constexpr double leastMass = 1e-3;  // kg
constexpr double usualMass = 1;     // kg, of a body of Box2D whose fixtures have no density

// Eight digits are the bits of a float, big end first: an option of the exporter.
double numberIn(const Node& node, double limit) {
    if (node.type() != sulfur::scene::ValueType::string) return node.number(-limit, limit);
    const std::string digits = node.string(8, 8);
    std::uint32_t bits = 0;
    for (const char c : digits) {
        const auto place =
            std::string_view("0123456789ABCDEF")
                .find(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
        if (place == std::string_view::npos) node.fail(tr("is no number"));
        bits = bits << 4 | static_cast<std::uint32_t>(place);
    }
    const double value = static_cast<double>(std::bit_cast<float>(bits));
    if (!(std::abs(value) <= limit)) node.fail(tr("is no number"));
    return value;
}

std::vector<Point> verticesOf(const Node& shape) {
    const Node vertices = shape.at("vertices");
    const auto xs = vertices.at("x").array(1, 10'000), ys = vertices.at("y").array(1, 10'000);
    std::vector<Point> points;
    for (std::size_t i = 0; i < std::min(xs.size(), ys.size()); ++i)
        points.emplace_back(numberIn(xs[i], mostMetres), numberIn(ys[i], mostMetres));
    return points;
}

sulfur::Material materialOf(const Node& fixture) {
    sulfur::Material material;
    material.staticFriction = material.kineticFriction =
        static_cast<Real>(std::max(0.0, rubeNumber(fixture, "friction", 0)));
    material.restitution =
        static_cast<Real>(std::clamp(rubeNumber(fixture, "restitution", 0), 0.0, 1.0));
    return material;
}

sulfur::scene::Prefab polygonOf(const std::vector<Point>& points, double density, double lightest,
                                const sulfur::Material& material) {
    const double area = momentsOf({points}).area;
    sulfur::shapes::PolygonOptions options;
    for (const Point& point : points) options.points.push_back(point.cast<Real>());
    options.mass = static_cast<Real>(std::max(lightest, density * std::abs(area)));
    options.material = material;
    constexpr int mostTries = 8;
    double radius = std::min(0.01, std::sqrt(std::abs(area)) / 40);
    for (int tries = 1;; ++tries, radius /= 2) {
        options.radius = static_cast<Real>(radius);
        try {
            return sulfur::scene::makePrefab("shape", options);
        } catch (const sulfur::Error&) {
            if (tries == mostTries) throw;
        }
    }
}

std::vector<Point> roundOf(const Point& centre, double radius) {
    std::vector<Point> points;
    for (int i = 0; i < cornersOfRound; ++i) {
        const double angle = 2 * std::numbers::pi * i / cornersOfRound;
        points.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
    }
    return points;
}

sulfur::scene::Prefab lineOfRube(std::vector<Point> points, const sulfur::Material& material) {
    sulfur::shapes::GroundOptions options;
    options.closed = points.size() > 3 && (points.front() - points.back()).norm() < 1e-6;
    if (options.closed) points.pop_back();
    for (const Point& point : points) options.points.push_back(point.cast<Real>());
    options.radius = Real(0.01);
    options.material = material;
    return sulfur::scene::makePrefab("line", options);
}

}  // namespace

double rubeNumber(const Node& object, std::string_view key, double otherwise) {
    const auto member = object.find(key);
    return member ? numberIn(*member, mostNumber) : otherwise;
}

// A vector of zeros is written as 0.
Point rubePoint(const Node& object, std::string_view key) {
    const auto member = object.find(key);
    if (!member || member->type() != sulfur::scene::ValueType::object) return {0, 0};
    return {numberIn(member->at("x"), mostMetres), numberIn(member->at("y"), mostMetres)};
}

bool rubeFlag(const Node& object, std::string_view key) {
    const auto member = object.find(key);
    return member && member->boolean();
}

void RubeReader::leaveOut(const std::string& what) {
    auto& all = made_.leftOut;
    if (std::find(all.begin(), all.end(), what) == all.end()) all.push_back(what);
}

RubeScene RubeReader::read(const Node& root) {
    const Point gravity = root.find("gravity") ? rubePoint(root, "gravity") : Point(0, -10);
    made_.scene.settings.gravity = gravity.cast<Real>();
    std::vector<Node> joints;
    if (const auto list = root.find("joint")) joints = list->array(0, 100'000);
    for (const Node& joint : joints) noteAnchors(joint);
    if (const auto list = root.find("body"))
        for (const Node& body : list->array(0, 100'000)) addBody(body);
    for (const Node& joint : joints) addJoint(joint);
    if (root.find("image")) leaveOut(tr("images"));
    return std::move(made_);
}

void RubeReader::addBody(const Node& node) {
    Body body;
    body.pose = {rubePoint(node, "position"), rubeNumber(node, "angle", 0)};
    constexpr std::array kinds{sulfur::BodyKind::fixed, sulfur::BodyKind::kinematic,
                               sulfur::BodyKind::dynamic};
    const auto type = static_cast<std::size_t>(std::clamp(rubeNumber(node, "type", 0), 0.0, 2.0));
    body.kind = kinds.at(type);
    body.index = bodies_.size();
    body.heavy = rubeNumber(node, "massData-mass", 0) > 0;
    if (rubeNumber(node, "angularVelocity", 0) != 0) leaveOut(tr("spins of bodies"));
    if (rubeFlag(node, "fixedRotation")) leaveOut(tr("bodies that do not turn"));
    if (rubeNumber(node, "gravityScale", 1) != 1) leaveOut(tr("weights of single bodies"));
    const auto name = node.find("name");
    const std::string base = name && !name->string(0, 200).empty() ? name->string(1, 200) : "body";
    const Vec2 velocity = rubePoint(node, "linearVelocity").cast<Real>();
    if (const auto fixtures = node.find("fixture"))
        for (const Node& fixture : fixtures->array(0, 10'000)) {
            try {
                addFixture(body, fixture, base, velocity);
            } catch (const sulfur::Error& error) {
                leaveOut(base + ": " + trRefusal(error.what()));
            }
        }
    holdTogether(body);
    bodies_.push_back(std::move(body));
}

// Nothing where it has no counterpart.
std::optional<RubeReader::Shape> RubeReader::shapeOf(const Body& body, const Node& fixture) {
    const sulfur::Material material = materialOf(fixture);
    const double density = std::max(0.0, rubeNumber(fixture, "density", 0));
    const double lightest = density > 0 || body.heavy ? leastMass : usualMass;
    if (const auto circle = fixture.find("circle")) {
        const double radius = std::max(1e-4, rubeNumber(*circle, "radius", 0));
        const Point middle = rubePoint(*circle, "center");
        if (!heldAt(body.index, middle))
            return Shape{
                polygonOf(roundOf(middle, radius), density, lightest, material), {0, 0}, middle};
        const double mass = density * std::numbers::pi * radius * radius;
        sulfur::shapes::BallOptions ball;
        ball.radius = static_cast<Real>(radius);
        ball.mass = static_cast<Real>(std::max(lightest, mass));
        ball.material = material;
        return Shape{sulfur::scene::makePrefab("ball", ball), middle, middle};
    }
    if (const auto polygon = fixture.find("polygon")) {
        const auto points = verticesOf(*polygon);
        return Shape{
            polygonOf(points, density, lightest, material), {0, 0}, momentsOf({points}).centre};
    }
    const auto line = fixture.find("chain") ? fixture.find("chain") : fixture.find("loop");
    if (line && body.kind == sulfur::BodyKind::fixed) {
        const auto points = verticesOf(*line);
        return Shape{lineOfRube(points, material), {0, 0}, points.front()};
    }
    leaveOut(line ? tr("lines of bodies that move") : tr("fixtures of an unknown kind"));
    return std::nullopt;
}

void RubeReader::addFixture(Body& body, const Node& fixture, const std::string& base,
                            const Vec2& velocity) {
    std::optional<Shape> shape = shapeOf(body, fixture);
    if (!shape) return;
    sulfur::Blueprint& blueprint = shape->prefab.blueprint;
    blueprint.kind = body.kind;
    blueprint.sensor = rubeFlag(fixture, "sensor");
    const auto bits = [&](std::string_view key, std::uint32_t& into) {
        if (fixture.find(key))
            into = static_cast<std::uint32_t>(std::max(0.0, rubeNumber(fixture, key, 0)));
    };
    bits("filter-categoryBits", blueprint.filter.category);
    bits("filter-maskBits", blueprint.filter.mask);
    blueprint.filter.group = static_cast<std::int32_t>(rubeNumber(fixture, "filter-groupIndex", 0));
    sulfur::scene::Placement placement;
    placement.id = made_.scene.freeId(base);
    placement.blueprint = blueprint.name = made_.scene.freeName(placement.id);
    placement.pose = {body.toWorld(shape->offset), body.pose.angle};
    placement.velocity = velocity;
    body.pieces.push_back({placement.id, body.toWorld(shape->middle), massOf(blueprint)});
    made_.scene.blueprints.push_back(std::move(shape->prefab));
    made_.scene.bodies.push_back(std::move(placement));
}

// Pieces are one body: they do not touch each other, and what moves is welded.
void RubeReader::holdTogether(const Body& body) {
    for (std::size_t i = 1; i < body.pieces.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            made_.scene.vetoes.push_back({body.pieces[k].id, body.pieces[i].id});
        if (body.kind != sulfur::BodyKind::dynamic) continue;
        sulfur::scene::SceneMechanism weld;
        weld.spec = sulfur::scene::Weld{
            body.pieces[0].id, body.pieces[i].id, body.pieces[i].middle, {}, {}};
        made_.scene.mechanisms.push_back(std::move(weld));
    }
}

RubeScene readRube(const std::filesystem::path& file) {
    const auto document = sulfur::scene::Document::read(file);
    document.root().requireObject();
    RubeScene made = RubeReader().read(document.root());
    made.scene.title = file.stem().string();
    return made;
}

}  // namespace sulfurchamber
