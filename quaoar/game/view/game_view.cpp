// The picture's parts in their order, the camera, and the bodies of the world.
#include <quaoar/view/game_view.hpp>

#include <algorithm>
#include <cmath>

#include "backdrop.hpp"
#include "ice.hpp"
#include "outline.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

GameView::GameView(Art& art, const Session& session)
    : art_(art),
      session_(session),
      backdrop_(std::make_unique<Backdrop>(session.level())),
      follow_(session, OpenSpace(session.level(), fixedShapes(session))) {
    const Level& level = session.level();
    const Vec2 beyond{3, 3};
    const Vec2 low = Vec2(level.boundsMin) - beyond, high = Vec2(level.boundsMax) + beyond;
    const atlax::Rect shown{low, high - low};
    for (const FixedShape& shape : fixedShapes(session)) {
        ice_.push_back(std::make_unique<IceView>(art_, shape.loop, shape.radius,
                                                 level.surface(shape.name), level.theme, shown));
        iceBodies_.push_back(shape.id);
    }
    cut();
}

GameView::~GameView() = default;

void GameView::cut() {
    lookAt_.reset();
    follow_.cut();
    const Vec2 hero(session_.heroPosition());
    scarf_.now.fill(hero);
    scarf_.before.fill(hero);
    antenna_ = hero + Vec2{0, 0.2f};
    antennaVelocity_ = {};
    sparks_.clear();
}

void GameView::resume(const GameView& before) {
    follow_.resume(before.follow_);
    lookAt_ = before.lookAt_;
    scarf_ = before.scarf_;
    antenna_ = before.antenna_;
    time_ = before.time_;
}

void GameView::lookAt(Vec2 centre) {
    lookAt_ = centre;
}

atlax::Camera GameView::camera(atlax::PixelSize size) const {
    if (!lookAt_) return follow_.camera(size);
    const Level& level = session_.level();
    const auto metres = static_cast<float>(level.viewHeight);
    atlax::Camera camera = atlax::Camera::withHeight(*lookAt_, metres, size);
    const Vec2 half = camera.view(size).size * 0.5f;
    const Vec2 low(level.boundsMin), high(level.boundsMax);
    const auto within = [](float value, float from, float to) {
        return from > to ? (from + to) * 0.5f : std::clamp(value, from, to);
    };
    camera.centre.x = within(camera.centre.x, low.x + half.x, high.x - half.x);
    camera.centre.y = within(camera.centre.y, low.y + half.y, high.y - half.y);
    return camera;
}

void GameView::draw(atlax::Canvas& canvas, double alpha, const ViewOptions& options) {
    const Vec2 screen = canvas.size().toVec();
    follow_.setAspect(screen.x / std::max(screen.y, 1.0f));
    follow_.setTrembling(options.shake);
    if (options.quality.scene >= 1) {
        coarse_ = {};
        drawScene(canvas, alpha, options);
    } else {
        const atlax::PixelSize size{
            std::max(1, static_cast<int>(screen.x * options.quality.scene)),
            std::max(1, static_cast<int>(screen.y * options.quality.scene))};
        if (!coarse_.valid() || coarse_.size() != size) coarse_ = canvas.createTarget(size);
        canvas.pushTarget(coarse_);
        drawScene(canvas, alpha, options);
        canvas.popTarget();
        canvas.setScreenSpace();
        canvas.setShader(art_.plain());
        canvas.sprite(coarse_.texture(), screen * 0.5f, screen);
        canvas.setShader({});
    }
    if (options.crosshair && options.aim) drawCrosshair(canvas, *options.crosshair);
}

void GameView::drawScene(atlax::Canvas& canvas, double alpha, const ViewOptions& options) {
    const atlax::Camera eye = camera(canvas.size());
    const double seconds = (static_cast<double>(time_) + alpha) / Session::tickRate;
    const Vec2 middle(session_.world().interpolated(session_.hand(), alpha));

    backdrop_->drawBehind(canvas, art_, eye, seconds, options.quality);
    canvas.setCamera(eye);
    backdrop_->drawWeather(canvas, eye, seconds, false, options.quality);
    drawGate(canvas, false);
    for (const auto& ice : ice_) ice->draw(canvas, art_);
    drawLamp(canvas, options.quality);
    drawBodies(canvas, alpha);
    if (options.hints) drawHints(canvas, options.texts);
    const bool playing = session_.phase() == Session::Phase::playing;
    if (options.aim && playing && session_.rope().state() == Rope::State::idle) drawRange(canvas);
    drawScarf(canvas);
    drawRope(canvas, middle, alpha);
    drawHero(canvas, alpha);
    drawGate(canvas, true);
    drawSparks(canvas);
    if (options.quality.foreground) backdrop_->drawForeground(canvas, eye);
    backdrop_->drawWeather(canvas, eye, seconds, true, options.quality);
}

/// The bulb of the hero's antenna lights air and rock about him.
void GameView::drawLamp(atlax::Canvas& canvas, const Quality& quality) {
    const Color light = Color::hex(0xFFE2B8);
    canvas.setBlend(atlax::Blend::Additive);
    canvas.glow(antenna_, 1.5f, light.withAlpha(0.16f));
    if (quality.glints) {
        for (const auto& ice : ice_) ice->drawLit(canvas, antenna_, 1.9f, light);
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

void GameView::drawBodies(atlax::Canvas& canvas, double alpha) {
    const sulfur::World& world = session_.world();
    const Level& level = session_.level();
    for (const sulfur::scene::Placement& placement : level.scene.bodies) {
        const sulfur::BodyId id = session_.instance().body(placement.id);
        if (!world.contains(id)) continue;
        if (std::find(iceBodies_.begin(), iceBodies_.end(), id) != iceBodies_.end()) continue;
        drawBody(canvas, id, level.surface(placement.id), alpha);
    }
}

void GameView::drawBody(atlax::Canvas& canvas, sulfur::BodyId id, const Surface& surface,
                        double alpha) {
    const sulfur::World& world = session_.world();
    if (surface.look == Surface::Look::peg) {
        drawBolt(canvas, Vec2(world.centreOfMass(id)));
        return;
    }
    const SkinPlan& plan = skinPlan(id);
    if (plan.skin == nullptr) {
        drawBare(canvas, id, alpha);
        return;
    }
    const std::vector<Vec2> places = dressedPlaces(id, plan, alpha);
    std::vector<atlax::MeshVertex> vertices;
    for (std::size_t i = 0; i < places.size(); ++i) {
        vertices.push_back({places[i], Vec2(plan.skin->uv[i]), atlax::colors::white});
    }
    canvas.mesh(art_.picture(plan.skin->texture), vertices, plan.indices);
    std::vector<Vec2> border;
    for (const std::uint32_t i : plan.outline) border.push_back(places[i]);
    canvas.polyline(border, 0.018f, palette::night.withAlpha(0.75f), true);
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Vec2 a = border[i], b = border[(i + 1) % border.size()];
        const Vec2 outward = -perpendicular(normalized(b - a));
        const float lit = std::max(0.0f, dot(outward, normalized(Vec2{-0.35f, 0.94f})));
        if (lit > 0.2f) canvas.line(a, b, 0.008f, palette::frost.withAlpha(0.65f * lit));
    }
}

void GameView::drawBolt(atlax::Canvas& canvas, Vec2 at) {
    canvas.setBlend(atlax::Blend::Additive);
    const float pulse = 0.8f + 0.2f * std::sin(static_cast<float>(time_ % 3000) * 0.0062832f);
    canvas.sprite(art_.light(), at, {0.95f, 0.95f},
                  {.tint = palette::amber.withAlpha(0.4f * pulse)});
    canvas.setBlend(atlax::Blend::Alpha);
    canvas.sprite(art_.picture("bolt.svg"), at, {0.34f, 0.34f});
}

void GameView::drawBare(atlax::Canvas& canvas, sulfur::BodyId id, double alpha) {
    const sulfur::World& world = session_.world();
    for (const sulfur::JointId joint : world.joints(id)) {
        const sulfur::JointInfo info = world.info(joint);
        const Vec2 a(world.interpolated(info.a, alpha)), b(world.interpolated(info.b, alpha));
        const float radius = std::max(0.01f, static_cast<float>(info.radius));
        canvas.capsule(a, b, radius, palette::ice);
    }
    for (const sulfur::ParticleId particle : world.particles(id)) {
        const auto radius = static_cast<float>(world.info(particle).radius);
        if (radius <= 0) continue;
        const Vec2 at(world.interpolated(particle, alpha));
        canvas.circle(at, radius, palette::ice);
        canvas.circle(at + Vec2{-0.3f, 0.3f} * radius, radius * 0.35f,
                      palette::frost.withAlpha(0.5f));
    }
}

const GameView::SkinPlan& GameView::skinPlan(sulfur::BodyId id) {
    const auto known = plans_.find(id);
    if (known != plans_.end()) return known->second;
    SkinPlan plan;
    const sulfur::World& world = session_.world();
    const auto particles = world.particles(id);
    sulfur::Blueprint shape;
    for (const sulfur::ParticleId particle : particles) {
        shape.particles.push_back({.position = world.position(particle).cast<sulfur::Real>()});
    }
    for (const sulfur::JointId joint : world.joints(id)) {
        const sulfur::JointInfo info = world.info(joint);
        const auto index = [&](sulfur::ParticleId p) {
            return static_cast<std::uint32_t>(std::find(particles.begin(), particles.end(), p) -
                                              particles.begin());
        };
        shape.joints.push_back({.a = index(info.a), .b = index(info.b), .radius = info.radius});
        plan.thickness = std::max(plan.thickness, static_cast<float>(info.radius));
    }
    plan.outline = outlineOf(shape);
    const auto& skin = world.skin(id);
    if (skin && !plan.outline.empty() && skin->uv.size() == particles.size()) {
        plan.skin = std::make_unique<sulfur::Skin>(*skin);
        for (const auto& t : skin->triangles)
            plan.indices.insert(plan.indices.end(), t.begin(), t.end());
    }
    return plans_.emplace(id, std::move(plan)).first->second;
}

/// Particles where they are, those of the outline moved out by its thickness, so that the skin
/// covers what collides.
std::vector<Vec2> GameView::dressedPlaces(sulfur::BodyId id, const SkinPlan& plan,
                                          double alpha) const {
    std::vector<Vec2> places;
    for (const sulfur::ParticleId particle : session_.world().particles(id)) {
        places.emplace_back(session_.world().interpolated(particle, alpha));
    }
    std::vector<Vec2> border;
    for (const std::uint32_t i : plan.outline) border.push_back(places[i]);
    const std::vector<Vec2> outer = grown(border, plan.thickness);
    for (std::size_t k = 0; k < outer.size(); ++k) places[plan.outline[k]] = outer[k];
    return places;
}

}  // namespace quaoar
