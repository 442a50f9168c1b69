// Bodies and what ties them; what is shown above them is in scene_marks.cpp.
#include "scene_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <sulfur/draw.hpp>

#include "../model/geometry.hpp"
#include "../model/properties.hpp"
#include "../model/rail.hpp"
#include "../model/transform.hpp"
#include "fitting_painter.hpp"
#include "palette.hpp"

namespace sulfurchamber {
namespace {

using atlax::Color;
using atlax::Vec2;
using sulfur::BodyId;
using sulfur::JointId;
using sulfur::ParticleId;
using sulfur::World;

constexpr float innerJointPixels = 9;  // shorter inner joints would only be noise
constexpr float smallestDotPixels = 2.6f;
constexpr float smallBodyPixels = 14;  // up to which a body has no rim of its own
constexpr std::size_t denseLinks = 2000;
constexpr float denseLinkPixels = 5;

float toFloat(sulfur::Real value) {
    return static_cast<float>(value);
}

sulfur::Point pointOf(const Vec2& at) {
    return {static_cast<double>(at.x), static_cast<double>(at.y)};
}

// Neighbours of one kind differ a little, so that a heap of boxes is not one blot.
float shade(BodyId body) {
    const std::uint32_t mixed = (body.index * 2654435761u) >> 16;
    return static_cast<float>(mixed % 64u) / 64.0f;
}

// Whether another body lies inside: then the outline is a cave and not a rock.
bool holdsOthers(const World& world, const std::vector<std::vector<std::uint32_t>>& loops,
                 BodyId body) {
    const auto particles = world.particles(body);
    for (const auto& loop : loops) {
        std::vector<sulfur::Point> polygon;
        for (const std::uint32_t index : loop) polygon.push_back(world.position(particles[index]));
        for (const BodyId other : world.bodies())
            if (other != body && inside(polygon, world.centreOfMass(other))) return true;
    }
    return false;
}

// A mechanism that the plan does not have, as its places and lines between them.
class MechanismPen final : public sulfur::DebugDraw {
public:
    MechanismPen(atlax::Canvas& canvas, const Document& document, float pixel)
        : canvas_(canvas), pixel_(pixel) {
        for (const auto& made : document.made()) planned_.insert({made.id, made.spring});
    }

    void mechanism(const Mechanism& mechanism) override {
        if (planned_.contains(mechanism.id)) return;
        const bool isLoose = mechanism.info.kind == sulfur::MechanismKind::gear;
        const Color color = isLoose ? palette::ice.withAlpha(0.5f) : palette::ice;
        for (std::size_t i = 1; i < mechanism.places.size(); ++i)
            canvas_.dashedLine(Vec2(mechanism.places[i - 1]), Vec2(mechanism.places[i]),
                               1.4f * pixel_, 5 * pixel_, (isLoose ? 5 : 2) * pixel_, color);
        if (isLoose) return;
        for (const auto& place : mechanism.places) {
            const Vec2 at(place);
            const float radius = 4.5f * pixel_;
            canvas_.circle(at, radius, palette::deep);
            if (mechanism.info.kind == sulfur::MechanismKind::weld)
                canvas_.rect({at - Vec2{radius, radius} * 0.6f, Vec2{radius, radius} * 1.2f},
                             palette::ice);
            else
                canvas_.circleOutline(at, radius, 1.6f * pixel_, palette::ice);
        }
    }

private:
    atlax::Canvas& canvas_;
    float pixel_;
    std::set<sulfur::MechanismId> planned_;
};

}  // namespace

const ScenePainter::Look& ScenePainter::lookOf(const Workbench& bench, BodyId body) {
    const Document& document = bench.document();
    const World& world = document.world();
    const auto joints = world.joints(body);
    const auto found = looks_.find(body);
    if (found != looks_.end() && found->second.jointCount == joints.size()) return found->second;
    Look look;
    look.jointCount = joints.size();
    look.marks = bench.marks(body);
    const auto loops = outlines(world, body);
    look.filled = world.kind(body) != sulfur::BodyKind::fixed || !holdsOthers(world, loops, body);
    std::vector<sulfur::Point> points;
    for (const ParticleId particle : world.particles(body))
        points.push_back(world.position(particle));
    for (LoopRegion& region : regionsOfLoops(loops, points)) {
        auto triangles =
            region.holes.empty() ? std::vector<CornerTriple>{} : trianglesOf(region, points);
        look.fills.push_back({std::move(region), std::move(triangles)});
    }
    std::vector<ParticleId> tied;
    for (const JointId joint : joints) {
        const auto info = world.info(joint);
        if (std::isfinite(info.stiffness)) look.soft = true;
        tied.push_back(info.a);
        tied.push_back(info.b);
    }
    if (const std::string id = document.idOf(body); !id.empty())
        if (const std::string text = colourOf(document.plan().body(id)); !text.empty())
            look.colour =
                Color::hex(static_cast<std::uint32_t>(std::stoul(text.substr(1), nullptr, 16)));
    std::sort(tied.begin(), tied.end());
    const auto particles = world.particles(body);
    for (std::uint32_t i = 0; i < particles.size(); ++i)
        if (!std::binary_search(tied.begin(), tied.end(), particles[i])) look.lone.push_back(i);
    return looks_.insert_or_assign(body, std::move(look)).first->second;
}

void ScenePainter::pose(BodyId body, const Look& look, Posed& posed) const {
    posed.id = body;
    posed.look = &look;
    posed.kind = world_->kind(body);
    posed.points.clear();
    for (const ParticleId particle : world_->particles(body))
        posed.points.push_back(place(particle));
    const float light = shade(body);
    if (posed.look->colour) {
        posed.fill = atlax::mix(palette::deep, *posed.look->colour, 0.8f);
        posed.rim = atlax::mix(*posed.look->colour, palette::ice, 0.35f);
    } else if (posed.kind == sulfur::BodyKind::fixed) {
        posed.fill = palette::steel;
        posed.rim = atlax::mix(palette::steel, palette::sky, 0.45f);
    } else if (posed.look->soft) {
        posed.fill = atlax::mix(palette::deep, palette::amber, 0.66f + 0.16f * light);
        posed.rim = atlax::mix(palette::amber, palette::ice, 0.35f);
    } else if (posed.kind == sulfur::BodyKind::kinematic) {
        posed.fill = atlax::mix(palette::steel, palette::cold, 0.25f);
        posed.rim = palette::cold;
    } else {
        posed.fill = atlax::mix(palette::steel, palette::sky, 0.12f + 0.38f * light);
        posed.rim = atlax::mix(palette::sky, palette::ice, 0.25f);
    }
}

bool ScenePainter::isHidden(BodyId body) const {
    const auto look = looks_.find(body);
    return look != looks_.end() && look->second.marks.hidden;
}

Vec2 ScenePainter::place(ParticleId particle) const {
    return world_->interpolated(particle, alpha_);
}

void ScenePainter::paint(atlax::Canvas& canvas, const Workbench& bench, const ViewOptions& options,
                         double alpha) {
    const Document& document = bench.document();
    canvas_ = &canvas;
    document_ = &document;
    world_ = &document.world();
    options_ = &options;
    alpha_ = alpha;
    pixel_ = canvas.pixel() * canvas.scaleFactor();
    if (revision_ != document.revision()) {
        looks_.clear();
        dresses_.clear();
        if (textures_ != nullptr) textures_->lookAgain();
    }
    revision_ = document.revision();

    FittingPainter fittings(canvas, bench, pixel_);
    fittings.paintZones();
    poseInOrder(bench);
    for (const Posed& body : posed_) paintBody(body, options.tools && bench.selected(body.id));
    if (options.bodies) paintConnections();
    paintMechanisms();
    fittings.paintMarks();
    if (font_ != nullptr) fittings.paintKeys(*font_);
    if (options.strain) paintStrain();
    paintPins();
    if (options.contacts) paintContacts();
    if (options.velocities) paintVelocities();
    const Preview preview = bench.preview();
    // A picture that is being placed has handles of its own.
    const bool handles = bench.tool() == ToolKind::select && !bench.stretching() &&
                         preview.kind != Preview::Kind::skin;
    if (options.tools && handles) paintHandles(bench);
    if (bench.trails()) paintTrails(bench);
    if (options.tools) paintPreview(preview);
    if (options.tools && bench.snapMark()) paintSnap(*bench.snapMark());
}

// What is visible, the hindmost first: by their order, and of the same what is fixed. Those of the
// frame before lend their memory.
void ScenePainter::poseInOrder(const Workbench& bench) {
    std::size_t count = 0;
    for (const BodyId body : world_->bodies()) {
        const Look& look = lookOf(bench, body);
        if (look.marks.hidden) continue;
        if (count == posed_.size()) posed_.emplace_back();
        pose(body, look, posed_[count++]);
    }
    posed_.resize(count);
    const auto key = [](const Posed& body) {
        return std::pair(body.look->marks.order, body.kind != sulfur::BodyKind::fixed);
    };
    const auto isBehind = [&](const Posed& a, const Posed& b) { return key(a) < key(b); };
    if (!std::is_sorted(posed_.begin(), posed_.end(), isBehind))
        std::stable_sort(posed_.begin(), posed_.end(), isBehind);
}

// A body of a few pixels is its outline, filled: its rim would be as wide as it is, and thousands
// of them cost more than all else.
bool ScenePainter::paintedSmall(const Posed& body, bool selected) {
    const Color color = selected ? palette::ice : atlax::mix(body.fill, body.rim, 0.25f);
    if (body.points.size() == 1) {
        const float radius = toFloat(world_->info(world_->particles(body.id)[0]).radius);
        if (!(radius > 0) || 2 * radius > smallBodyPixels * pixel_) return false;
        canvas_->circle(body.points[0], radius, color);
        return true;
    }
    if (body.look->fills.empty() || !body.look->filled || !body.look->lone.empty()) return false;
    Vec2 low = body.points[0];
    Vec2 high = low;
    for (const Vec2& point : body.points) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    const float size = std::max(high.x - low.x, high.y - low.y);
    if (size > smallBodyPixels * pixel_) return false;
    std::vector<Vec2> polygon;
    for (const auto& fill : body.look->fills) {
        const auto& loop = fill.region.outer;
        polygon.clear();
        for (const std::uint32_t index : loop) polygon.push_back(body.points[index]);
        canvas_->polygon(polygon, color);
    }
    return true;
}

// A lattice of thousands of links of a few pixels, such as a large cloth seen from afar, is a
// sheet: stripes that leave no gaps. Each link for itself would cost most of the frame, and nobody
// tells them apart.
bool ScenePainter::paintedDense(const Posed& body) {
    const auto joints = world_->joints(body.id);
    if (joints.size() < denseLinks || joints.size() < body.points.size() * 3 / 2) return false;
    const Color color = atlax::mix(body.fill, body.rim, 0.6f);
    stripes_.clear();
    stripeCorners_.clear();
    for (const JointId joint : joints) {
        const auto info = world_->info(joint);
        const Vec2 a = place(info.a), b = place(info.b);
        const float length = atlax::length(b - a);
        if (length > denseLinkPixels * pixel_ || info.bend != 0) return false;
        if (!(info.radius > 0 || body.look->fills.empty()) || !(length > 0)) continue;
        const float half = std::max(toFloat(info.radius), length / 2);
        const Vec2 side = atlax::perpendicular((b - a) / length) * half;
        const auto first = static_cast<std::uint32_t>(stripes_.size());
        for (const Vec2& corner : {a + side, b + side, b - side, a - side})
            stripes_.push_back({corner, {}, color});
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
            stripeCorners_.push_back(first + corner);
    }
    canvas_->mesh({}, stripes_, stripeCorners_);
    return true;
}

void ScenePainter::paintBody(const Posed& body, bool selected) {
    if (paintedSmall(body, selected)) return;
    const auto particles = world_->particles(body.id);
    // The rim is the collision surface: capsules as thick as they are, the fill above them.
    const auto capsules = [&](float grow, const Color& color) {
        for (const JointId joint : world_->joints(body.id)) {
            const auto info = world_->info(joint);
            const bool thin = !(info.radius > 0);
            if (thin && !body.look->fills.empty()) continue;
            const float radius = std::max(toFloat(info.radius), (thin ? 0.8f : 1.1f) * pixel_);
            if (info.bend == 0) {
                canvas_->capsule(place(info.a), place(info.b), radius + grow, color);
                continue;
            }
            const auto line = chordsOf(pointOf(place(info.a)), pointOf(place(info.b)),
                                       static_cast<double>(info.bend));
            for (std::size_t i = 1; i < line.size(); ++i)
                canvas_->capsule(Vec2(line[i - 1]), Vec2(line[i]), radius + grow, color);
        }
        for (std::size_t i = 0; i < particles.size(); ++i)
            if (const float radius = toFloat(world_->info(particles[i]).radius); radius > 0)
                canvas_->circle(body.points[i], radius + grow, color);
    };
    // What others have drawn is where it was before the drag.
    const bool drawn = !options_->bodies && !(selected && document_->editing());
    if (selected) capsules(3 * pixel_, palette::ice.withAlpha(drawn ? 0.5f : 0.9f));
    if (drawn) return;
    if (paintSkin(body)) return;
    if (!paintedDense(body)) capsules(0, body.rim);
    if (body.look->filled) paintFill(body);
    if (options_->joints && !body.look->fills.empty()) paintJoints(body);
    paintDiscs(body);
    paintBelt(body);
}

void ScenePainter::paintFill(const Posed& body) {
    std::vector<Vec2> polygon;
    for (const auto& [region, triangles] : body.look->fills) {
        // Lines between triangles cover the seams.
        for (const auto& [a, b, c] : triangles) {
            const Vec2 p = body.points[a], q = body.points[b], r = body.points[c];
            canvas_->triangle(p, q, r, body.fill);
            canvas_->line(p, q, 1.5f * pixel_, body.fill);
            canvas_->line(q, r, 1.5f * pixel_, body.fill);
            canvas_->line(r, p, 1.5f * pixel_, body.fill);
        }
        if (!triangles.empty()) continue;
        polygon.clear();
        for (const std::uint32_t index : region.outer) polygon.push_back(body.points[index]);
        canvas_->polygon(polygon, body.fill);
    }
}

// As the game draws it, with the same code. False where the body wears none that can be drawn.
bool ScenePainter::paintSkin(const Posed& body) {
    const auto& skin = world_->skin(body.id);
    if (!skin || textures_ == nullptr) return false;
    const atlax::Texture* picture = textures_->of(*canvas_, skin->texture, *document_);
    if (picture == nullptr) return false;
    const quaoar::BodyShape& shape = dressOf(body.id);
    if (shape.particles == 1) {
        const auto particle = world_->particles(body.id).front();
        const float radius = toFloat(world_->info(particle).radius);
        if (!(radius > 0)) return false;
        const double angle = world_->interpolatedPose(body.id, alpha_).angle;
        quaoar::drawSkinnedDisc(*canvas_, *picture, body.points.front(), radius,
                                static_cast<float>(angle));
        canvas_->circleOutline(body.points.front(), radius, 1.4f * pixel_, body.rim);
        return true;
    }
    if (shape.triangles.empty()) return false;
    const quaoar::SkinColors colors{body.rim, body.fill, palette::ice,
                                    palette::deep.withAlpha(0.8f)};
    const auto places = quaoar::dressedPlaces(*world_, body.id, shape, alpha_);
    // Joints that are left without a triangle hang on as threads.
    for (const auto& edge : shape.loose)
        canvas_->line(places[edge[0]], places[edge[1]],
                      std::max(2 * shape.thickness, 1.2f * pixel_), body.rim);
    quaoar::drawSkin(*canvas_, picture, shape, colors, places);
    quaoar::drawSkinBorder(*canvas_, shape, colors, places);
    return true;
}

// Found anew when joints have gone: skins tear there.
const quaoar::BodyShape& ScenePainter::dressOf(BodyId body) {
    const auto found = dresses_.find(body);
    if (found != dresses_.end() && found->second.fits(*world_, body)) return found->second;
    const std::string id = document_->originOf(body);
    if (id.empty())
        return dresses_.insert_or_assign(body, quaoar::shapeOf(*world_, body, nullptr))
            .first->second;
    const sulfur::Blueprint plan = document_->plan().blueprint(id);
    return dresses_.insert_or_assign(body, quaoar::shapeOf(*world_, body, &plan)).first->second;
}

void ScenePainter::paintJoints(const Posed& body) {
    for (const JointId joint : world_->joints(body.id)) {
        const auto info = world_->info(joint);
        if (info.radius > 0) continue;
        const Vec2 a = place(info.a);
        const Vec2 b = place(info.b);
        if (atlax::length(b - a) < innerJointPixels * pixel_) continue;
        canvas_->line(a, b, pixel_,
                      body.look->soft ? palette::deep.withAlpha(0.22f) : body.rim.withAlpha(0.28f));
    }
}

void ScenePainter::paintDiscs(const Posed& body) {
    const auto particles = world_->particles(body.id);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const float radius = toFloat(world_->info(particles[i]).radius);
        if (!(radius > 0)) continue;
        const Vec2 at = body.points[i];
        canvas_->circle(at, std::max(radius - 2 * pixel_, radius * 0.5f), body.fill);
        canvas_->circle(at + Vec2{-0.3f, 0.34f} * radius, radius * 0.22f, body.rim.withAlpha(0.4f));
    }
    for (const std::uint32_t index : body.look->lone) {
        const auto info = world_->info(particles[index]);
        const Vec2 at = body.points[index];
        if (!(info.radius > 0)) {
            canvas_->circle(at, smallestDotPixels * pixel_, body.rim);
            continue;
        }
        // Else one would not see it roll.
        const float radius = toFloat(info.radius), angle = static_cast<float>(info.angle);
        const Vec2 outward = Vec2{std::cos(angle), std::sin(angle)} * radius;
        canvas_->line(at + 0.35f * outward, at + 0.9f * outward, 2 * pixel_,
                      body.rim.withAlpha(0.7f));
    }
}

void ScenePainter::paintConnections() {
    for (const JointId joint : world_->connections()) {
        const auto info = world_->info(joint);
        if (isHidden(world_->info(info.a).body) || isHidden(world_->info(info.b).body)) continue;
        const Color color = std::isfinite(info.stiffness) ? palette::amber : palette::ice;
        canvas_->capsule(place(info.a), place(info.b),
                         std::max(toFloat(info.radius), 1.2f * pixel_), color);
    }
}

void ScenePainter::paintMechanisms() {
    if (world_->mechanisms().empty()) return;
    MechanismPen pen(*canvas_, *document_, pixel_);
    world_->draw(pen, {.bodies = false,
                       .particles = false,
                       .discs = false,
                       .joints = false,
                       .capsules = false,
                       .contacts = false,
                       .attachments = false,
                       .fields = false,
                       .grabs = false,
                       .alpha = alpha_});
}

// A belt: chevrons that run along the sides of a body whose surface runs.
void ScenePainter::paintBelt(const Posed& body) {
    const auto speed = static_cast<float>(world_->material(body.id).surfaceSpeed);
    if (speed == 0) return;
    const float gap = std::max(0.25f, 14 * pixel_);
    const float size = 4 * pixel_;
    const auto time = static_cast<float>(std::fmod(world_->time(), 1000.0));
    const float start = std::fmod(time * speed, gap);
    for (const JointId joint : world_->joints(body.id)) {
        const auto info = world_->info(joint);
        if (!(info.radius > 0)) continue;
        const Vec2 a = place(info.a), b = place(info.b);
        const float length = atlax::length(b - a);
        if (length < gap / 2) continue;
        const Vec2 along = (b - a) / length;
        const Vec2 side = atlax::perpendicular(along) * size;
        const Vec2 ahead = along * (speed > 0 ? size : -size);
        for (float at = start < 0 ? start + gap : start; at < length; at += gap) {
            const Vec2 tip = a + along * at + ahead;
            canvas_->line(tip, tip - ahead + side, 1.6f * pixel_, palette::amber);
            canvas_->line(tip, tip - ahead - side, 1.6f * pixel_, palette::amber);
        }
    }
}

}  // namespace sulfurchamber
