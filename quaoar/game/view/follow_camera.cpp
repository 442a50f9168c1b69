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

void FollowCamera::resume(const FollowCamera& before) {
    aspect_ = before.aspect_;
    now_ = before.now_;
}

void FollowCamera::shake(float strength) {
    now_.shake = std::clamp(std::max(now_.shake, strength), 0.0f, 1.0f);
}

void FollowCamera::cut() {
    const Vec2 hero(session_.heroPosition());
    now_.goal = choose(hero, wanted(interest(), {}), std::nullopt);
    now_.centre = hero + now_.goal.offset;
    now_.height = now_.goal.height;
    now_.velocity = now_.heroVelocity = {};
    now_.speed = now_.shake = 0;
    now_.ticks = 0;
}

/// Where he aims, or where the rope holds that he hangs on; a unit vector at most.
Vec2 FollowCamera::interest() const {
    if (session_.rope().state() != Rope::State::attached) return Vec2(session_.aim());
    const Vec2 rope = Vec2(session_.rope().head(session_.world())) - Vec2(session_.heroPosition());
    return rope * (1 / std::max(1.2f, length(rope)));
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
    now_.heroVelocity = {towards(now_.heroVelocity.x, moves.x, 0.1f),
                         towards(now_.heroVelocity.y, moves.y, 0.1f)};
    const float fast = length(moves);
    now_.speed = towards(now_.speed, fast, fast > now_.speed ? 0.35f : 1.4f);
    if (now_.ticks++ % ticksPerChoice == 0)
        now_.goal = choose(hero, wanted(interest(), now_.heroVelocity), now_.goal);

    const float open = std::clamp((now_.speed - calmSpeed) / (fullSpeed - calmSpeed), 0.0f, 1.0f);
    const float wide = std::max(farHeight * 1.15f, static_cast<float>(session_.level().viewHeight));
    now_.height = towards(now_.height, now_.goal.height + (wide - now_.goal.height) * open, 0.45f);

    // Critically damped about the hero's own movement, so that it does not fall behind.
    constexpr float rate = 5.5f;
    const Vec2 gap = hero + now_.goal.offset - now_.centre;
    now_.velocity +=
        (gap * (rate * rate) - (now_.velocity - now_.heroVelocity) * (2 * rate)) * cameraTick;
    now_.centre += now_.velocity * cameraTick;
    const Vec2 held = holding(now_.centre, {now_.height * aspect_, now_.height});
    // Pushed along at the edge it takes up the speed, and does not spring back.
    if (held.x != now_.centre.x) now_.velocity.x = now_.heroVelocity.x;
    if (held.y != now_.centre.y) now_.velocity.y = now_.heroVelocity.y;
    now_.centre = held;
    now_.shake *= 0.985f;
}

Vec2 FollowCamera::holding(Vec2 centre, Vec2 view) const {
    const Vec2 hero(session_.heroPosition());
    const Vec2 most = view * holdShare - Vec2{heroReach, heroReach};
    return {std::clamp(centre.x, hero.x - std::max(most.x, 0.0f), hero.x + std::max(most.x, 0.0f)),
            std::clamp(centre.y, hero.y - std::max(most.y, 0.0f), hero.y + std::max(most.y, 0.0f))};
}

atlax::Camera FollowCamera::camera(atlax::PixelSize size) const {
    atlax::Camera camera = atlax::Camera::withHeight(now_.centre, now_.height, size);
    camera.centre = holding(now_.centre, camera.view(size).size);
    if (!trembles_) return camera;
    const float t = static_cast<float>(now_.ticks % 100000) * 0.14f;
    camera.centre += Vec2{std::sin(t), std::cos(t * 1.3f)} * (trembling * now_.shake * now_.shake);
    return camera;
}

Rect FollowCamera::restingView(Vec2 hero, Vec2 aim) const {
    const Goal goal = choose(hero, wanted(aim, {}), std::nullopt);
    return Rect::around(hero + goal.offset, {goal.height * aspect_, goal.height});
}

}  // namespace quaoar
