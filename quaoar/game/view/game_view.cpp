// The picture's parts in their order, the camera, and the bodies of the world.
#include <quaoar/skin/outline.hpp>
#include <quaoar/view/game_view.hpp>

#include <algorithm>
#include <cmath>

#include "backdrop.hpp"
#include "body_painter.hpp"
#include "ice.hpp"
#include "mechanics_view.hpp"
#include "monster_view.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

GameView::GameView(Art& art, const Session& session, const GameView* like)
    : art_(art),
      session_(session),
      backdrop_(std::make_unique<Backdrop>(session.level())),
      painter_(std::make_unique<BodyPainter>(art, session)),
      mechanics_(std::make_unique<MechanicsView>(session)),
      monsters_(std::make_unique<MonsterView>(art, session, *painter_)),
      follow_(session, OpenSpace(session.level(), fixedShapes(session))) {
    const Level& level = session.level();
    const Vec2 beyond{3, 3};
    const Vec2 low = Vec2(level.boundsMin) - beyond, high = Vec2(level.boundsMax) + beyond;
    const atlax::Rect shown{low, high - low};
    for (const FixedShape& shape : fixedShapes(session)) {
        const IceMould mould{shape.loop, shape.radius, level.surface(shape.name), level.theme,
                             shown};
        std::shared_ptr<const IceView> ice;
        if (like != nullptr)
            for (const auto& known : like->ice_)
                if (known->mould() == mould) ice = known;
        ice_.push_back(ice ? ice : std::make_shared<const IceView>(art_, mould));
        drawnElsewhere_.push_back(shape.id);
    }
    const auto& monsters = monsters_->bodies();
    drawnElsewhere_.insert(drawnElsewhere_.end(), monsters.begin(), monsters.end());
    cut();
}

GameView::~GameView() = default;

void GameView::cut() {
    lookAt_.reset();
    eye_.reset();
    follow_.cut();
    const Vec2 hero(session_.heroPosition());
    scarf_.now.fill(hero);
    scarf_.before.fill(hero);
    antenna_ = hero + Vec2{0, 0.2f};
    antennaVelocity_ = {};
    sparks_.clear();
    strands_.clear();
    lastRope_.clear();
    mood_ = {};
    strain_ = strainRate_ = reachFlash_ = 0;
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

void GameView::lookThrough(const atlax::Camera& camera) {
    eye_ = camera;
}

atlax::Camera GameView::camera(atlax::PixelSize size) const {
    if (eye_) return *eye_;
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
    if (options.highContrast)
        dim(canvas);
    else
        backdrop_->drawWeather(canvas, eye, seconds, false, options.quality);
    canvas.setCamera(eye);
    mechanics_->drawLiquids(canvas, eye.view(canvas.size()), seconds);
    drawGate(canvas, false);
    for (std::size_t i = 0; i < ice_.size(); ++i) {
        ice_[i]->draw(canvas, art_, eye.view(canvas.size()));
        const auto& material = session_.world().material(drawnElsewhere_[i]);
        ice_[i]->drawTrim(canvas, static_cast<float>(material.surfaceSpeed), seconds);
    }
    drawLamp(canvas, options.quality);
    mechanics_->drawBehind(canvas, art_, seconds);
    const Vec2 room{0.4f, 0.4f};  // for spikes and lights that stand out of bodies
    const atlax::Rect view = eye.view(canvas.size());
    painter_->draw(canvas, {view.min - room, view.size + room * 2}, alpha, seconds,
                   drawnElsewhere_);
    painter_->drawTies(canvas, alpha);
    monsters_->draw(canvas, alpha, seconds);
    if (options.highContrast) drawOutlines(canvas, alpha);
    const bool playing = session_.phase() == Session::Phase::playing;
    if (options.aim && playing && session_.rope().state() == Rope::State::idle) drawRange(canvas);
    drawReachFlash(canvas, options.flashes);
    drawStrands(canvas);
    drawScarf(canvas);
    drawRope(canvas, middle, alpha);
    drawHero(canvas, alpha);
    drawGate(canvas, true);
    mechanics_->drawBefore(canvas, art_, seconds);
    drawSparks(canvas);
    if (options.highContrast) return;
    if (options.quality.foreground) backdrop_->drawForeground(canvas, eye);
    backdrop_->drawWeather(canvas, eye, seconds, true, options.quality);
}

/// What is only scenery steps back.
void GameView::dim(atlax::Canvas& canvas) const {
    canvas.setScreenSpace();
    canvas.rect({{0, 0}, canvas.size().toVec()}, palette::night.withAlpha(0.72f));
}

/// White round what can be held or stood on, magenta and double round what hurts.
void GameView::drawOutlines(atlax::Canvas& canvas, double alpha) {
    const sulfur::World& world = session_.world();
    for (const sulfur::BodyId body : world.bodies()) {
        if (!session_.origin(body) || !world.isEnabled(body)) continue;
        const Surface& surface = session_.surface(body);
        const bool hurts = surface.deadly || surface.cuts || surface.deadlySpeed;
        const Color color = hurts            ? palette::danger
                            : surface.sticky ? palette::frost
                                             : palette::ice;
        const float width = hurts ? 0.05f : 0.03f;
        for (const sulfur::JointId joint : world.joints(body)) {
            const sulfur::JointInfo info = world.info(joint);
            if (!(info.radius > 0)) continue;
            canvas.line(Vec2(world.interpolated(info.a, alpha)),
                        Vec2(world.interpolated(info.b, alpha)), width, color);
        }
    }
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

}  // namespace quaoar
