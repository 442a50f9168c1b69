#include <quaoar/view/follow_camera.hpp>

#include <algorithm>
#include <cmath>

namespace quaoar {

using atlax::Rect;
using atlax::Vec2;

namespace {

constexpr float cameraTick = 1.0f / Session::tickRate;
constexpr float heroReach = 0.12f;
/// Metres over the picture's height at rest: the hero's 0.24 m are 8.7 % to 7.2 % of it.
constexpr float nearHeight = 2.76f, farHeight = 3.32f;
/// The part of width and height to either side of the middle that may hold the hero. A little less
/// than the 0.4 that are promised, for the trembling.
constexpr float holdShare = 0.385f;
constexpr float calmSpeed = 3;  // m/s up to which the view stays as at rest
constexpr float fullSpeed = 9;  // m/s from which it is as wide as it becomes
constexpr float trembling = 0.03f;
constexpr std::uint64_t ticksPerChoice = 10;

float towards(float from, float to, float seconds) {
    return from + (to - from) * (1 - std::exp(-cameraTick / seconds));
}

float squareOf(float value) {
    return value * value;
}

}  // namespace

FollowCamera::FollowCamera(const Session& session, OpenSpace space)
    : session_(session), space_(std::move(space)) {
    cut();
}

void FollowCamera::setAspect(float aspect) {
    aspect_ = std::clamp(aspect, 0.4f, 4.0f);
}

void FollowCamera::shake(float strength) {
    shake_ = std::clamp(std::max(shake_, strength), 0.0f, 1.0f);
}

void FollowCamera::cut() {
    const Vec2 hero(session_.heroPosition());
    goal_ = choose(hero, wanted(Vec2(session_.aim()), {}), std::nullopt);
    centre_ = hero + goal_.offset;
    height_ = goal_.height;
    velocity_ = heroVelocity_ = {};
    speed_ = shake_ = 0;
    ticks_ = 0;
}

/// Ahead of the hero: farther where he moves, nearer where he aims.
Vec2 FollowCamera::wanted(Vec2 aim, Vec2 velocity) const {
    const float sideways = std::min(aspect_, 1.0f) * 0.9f;
    const Vec2 look{aim.x * sideways, aim.y * 0.62f + 0.12f};
    return look + Vec2{std::clamp(velocity.x * 0.24f, -1.6f, 1.6f),
                       std::clamp(velocity.y * 0.2f, -1.3f, 0.9f)};
}

/// Tries heights and places on a grid. What costs: rock beyond a quarter of the picture, and far
/// more beyond what is allowed; what lies outside of the bounds; being elsewhere than wanted; being
/// near; and, so that it does not waver between two places, being elsewhere than before.
FollowCamera::Goal FollowCamera::choose(Vec2 hero, Vec2 wanted,
                                        const std::optional<Goal>& before) const {
    constexpr int across = 7, up = 6;
    Goal best{wanted, farHeight};
    float least = 1e9f;
    for (const float height : {farHeight, (nearHeight + farHeight) * 0.5f, nearHeight}) {
        const Vec2 size{height * aspect_, height};
        const Vec2 most = size * holdShare - Vec2{heroReach, heroReach};
        const Vec2 limited{std::clamp(wanted.x, -most.x, most.x),
                           std::clamp(wanted.y, -most.y, most.y)};
        for (int i = -across; i <= across; ++i) {
            for (int k = -up; k <= up; ++k) {
                const Vec2 offset{most.x * static_cast<float>(i) / across,
                                  most.y * static_cast<float>(k) / up};
                const Rect view = Rect::around(hero + offset, size);
                const float rock = space_.rock(view), closed = space_.closed(view);
                const Vec2 away = offset - limited;
                float cost = 14 * squareOf(std::max(0.0f, closed - 0.22f)) +
                             1500 * squareOf(std::max(0.0f, rock - 0.36f)) +
                             0.8f * squareOf(away.x / most.x) + 0.8f * squareOf(away.y / most.y) +
                             0.25f * squareOf((farHeight - height) / (farHeight - nearHeight));
                if (before) {
                    const Vec2 moved = offset - before->offset;
                    cost += 0.12f * dot(moved, moved) + 0.4f * squareOf(height - before->height);
                }
                if (cost >= least) continue;
                least = cost;
                best = {offset, height};
            }
        }
    }
    return best;
}

void FollowCamera::tick() {
    const Vec2 hero(session_.heroPosition()), moves(session_.heroVelocity());
    heroVelocity_ = {towards(heroVelocity_.x, moves.x, 0.1f),
                     towards(heroVelocity_.y, moves.y, 0.1f)};
    const float fast = length(moves);
    speed_ = towards(speed_, fast, fast > speed_ ? 0.35f : 1.4f);
    if (ticks_++ % ticksPerChoice == 0)
        goal_ = choose(hero, wanted(Vec2(session_.aim()), heroVelocity_), goal_);

    const float open = std::clamp((speed_ - calmSpeed) / (fullSpeed - calmSpeed), 0.0f, 1.0f);
    const float wide = std::max(farHeight * 1.15f, static_cast<float>(session_.level().viewHeight));
    height_ = towards(height_, goal_.height + (wide - goal_.height) * open, 0.45f);

    // Critically damped about the hero's own movement, so that it does not fall behind.
    constexpr float rate = 5.5f;
    const Vec2 gap = hero + goal_.offset - centre_;
    velocity_ += (gap * (rate * rate) - (velocity_ - heroVelocity_) * (2 * rate)) * cameraTick;
    centre_ += velocity_ * cameraTick;
    const Vec2 held = holding(centre_, {height_ * aspect_, height_});
    // Pushed along at the edge it takes up the speed, and does not spring back.
    if (held.x != centre_.x) velocity_.x = heroVelocity_.x;
    if (held.y != centre_.y) velocity_.y = heroVelocity_.y;
    centre_ = held;
    shake_ *= 0.985f;
}

Vec2 FollowCamera::holding(Vec2 centre, Vec2 view) const {
    const Vec2 hero(session_.heroPosition());
    const Vec2 most = view * holdShare - Vec2{heroReach, heroReach};
    return {std::clamp(centre.x, hero.x - std::max(most.x, 0.0f), hero.x + std::max(most.x, 0.0f)),
            std::clamp(centre.y, hero.y - std::max(most.y, 0.0f), hero.y + std::max(most.y, 0.0f))};
}

atlax::Camera FollowCamera::camera(atlax::PixelSize size) const {
    atlax::Camera camera = atlax::Camera::withHeight(centre_, height_, size);
    camera.centre = holding(centre_, camera.view(size).size);
    const float t = static_cast<float>(ticks_ % 100000) * 0.14f;
    camera.centre += Vec2{std::sin(t), std::cos(t * 1.3f)} * (trembling * shake_ * shake_);
    return camera;
}

Rect FollowCamera::restingView(Vec2 hero, Vec2 aim) const {
    const Goal goal = choose(hero, wanted(aim, {}), std::nullopt);
    return Rect::around(hero + goal.offset, {goal.height * aspect_, goal.height});
}

}  // namespace quaoar
