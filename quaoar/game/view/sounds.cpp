#include <algorithm>
#include <chrono>
#include <cmath>
#include <quaoar/view/sounds.hpp>

#include <quaoar/view/recipes.hpp>
#include <quaoar/view/score.hpp>

namespace quaoar {

namespace {
constexpr float musicGain = 0.55f;
constexpr float menuLoudness = 0.35f;  // share of it that is left under a menu
}  // namespace

Sounds::Sounds(atlax::Audio& audio) : audio_(audio), played_(effectCount, 0) {
    for (std::size_t i = 0; i < effectCount; ++i)
        effects_.push_back(audio_.createSound(recipeOf(static_cast<Effect>(i)), soundRate));
    creak_ = audio_.createSound(creakLoop(), soundRate);
    hum_ = audio_.createSound(humLoop(), soundRate);
}

int Sounds::played(Effect effect) const {
    return played_[static_cast<std::size_t>(effect)];
}

void Sounds::play(Effect effect, float gain, float pitch) {
    const auto place = static_cast<std::size_t>(effect);
    ++played_[place];
    const atlax::Bus bus = effect == Effect::click ? atlax::Bus::Interface : atlax::Bus::Effects;
    audio_.play(effects_[place], {.gain = gain, .pitch = pitch, .bus = bus});
}

void Sounds::tick(const Session& session) {
    hushed_ = false;
    accompany(session.level());
    playEvents(session);
    playBlows(session);
    if (--followRest_ <= 0) follow(session);
}

void Sounds::playEvents(const Session& session) {
    const TickEvents& events = session.events();
    constexpr Effect sticks[] = {Effect::stickIce, Effect::stickMetal, Effect::stickRock,
                                 Effect::stickSoft};
    if (events.fired) play(Effect::shoot, 0.7f);
    if (events.stuck) {
        const auto body = holding(session);
        const Material material = body ? materialOf(session, *body) : Material::ice;
        play(sticks[static_cast<std::size_t>(material)], 0.9f);
    }
    if (events.slipped) play(Effect::slip, 0.8f);
    if (events.missed) play(Effect::miss, 0.8f);
    if (events.released) play(Effect::release, 0.6f, 0.85f + 0.5f * strain_);
    if (events.cut) play(Effect::cut, 0.9f);
    if (events.died) play(Effect::die, 0.9f);
    if (events.restarted && !events.died) play(Effect::restart, 0.7f);
    if (events.checkpoint) play(Effect::checkpoint, 0.8f);
    if (events.pickedUp) play(Effect::pickup, 0.8f);
    if (events.switched) play(Effect::switched, 0.7f);
    if (events.crumbled) play(Effect::crumble, 0.9f);
    if (events.noticed) play(Effect::notice, 0.8f);
    if (events.defeated) play(Effect::defeat, 0.9f);
    if (events.finished) play(Effect::finish, 1);
}

/// Thumps by the speed of the hero's blows and the impulse of those of others, cracks of what
/// breaks; not more than the ear can tell apart.
void Sounds::playBlows(const Session& session) {
    constexpr Effect bumps[] = {Effect::bumpIce, Effect::bumpMetal, Effect::bumpRock,
                                Effect::bumpSoft};
    if (bumpRest_ > 0) --bumpRest_;
    if (snapRest_ > 0) --snapRest_;
    const sulfur::Events& events = session.world().events();
    if (!events.jointsBroken.empty() && snapRest_ == 0) {
        snapRest_ = 30;
        const auto count = static_cast<float>(events.jointsBroken.size());
        play(Effect::snap, std::min(1.0f, 0.45f + 0.06f * count),
             std::max(0.6f, 1.1f - 0.02f * count));
    }
    if (bumpRest_ > 0) return;
    float loudest = 0.06f;
    Material material = Material::ice;
    for (const sulfur::ContactBegun& contact : events.contactsBegun) {
        const bool hero = contact.a == session.hero() || contact.b == session.hero();
        if (!hero && (!session.origin(contact.a) || !session.origin(contact.b))) continue;
        const sulfur::BodyId other = contact.a == session.hero() ? contact.b : contact.a;
        if (!session.origin(other)) continue;
        const double away = (contact.point - session.heroPosition()).norm();
        const auto far = static_cast<float>(1 / (1 + 0.12 * away * away));
        const float gain = hero ? 0.12f * static_cast<float>(contact.speed)
                                : 0.10f * static_cast<float>(contact.impulse) * far;
        if ((hero && contact.speed < 1) || gain <= loudest) continue;
        loudest = gain;
        material = materialOf(session, other);
    }
    if (loudest <= 0.06f) return;
    bumpRest_ = 40;
    play(bumps[static_cast<std::size_t>(material)], std::min(1.0f, loudest),
         std::max(0.7f, 1.3f - 0.5f * loudest));
}

Sounds::Material Sounds::materialOf(const Session& session, sulfur::BodyId body) const {
    if (!session.origin(body)) return Material::ice;
    const auto joints = session.world().joints(body);
    const bool soft =
        !joints.empty() && session.world().info(joints.front()).stiffness < sulfur::Real(2e4);
    if (soft) return Material::soft;
    switch (session.surface(body).look) {
        case Surface::Look::metal:
        case Surface::Look::peg:
            return Material::metal;
        case Surface::Look::rock:
            return Material::rock;
        case Surface::Look::ice:
        case Surface::Look::mirror:
            break;
    }
    const bool machine = session.level().theme.world == Theme::World::machine;
    const bool ground = session.world().kind(body) == sulfur::BodyKind::fixed;
    return machine && ground ? Material::metal : Material::ice;
}

/// What the rope's head lies in: found by a short ray from its first particle through the head.
std::optional<sulfur::BodyId> Sounds::holding(const Session& session) const {
    const sulfur::Point head = session.rope().head(session.world());
    const sulfur::Point way = head - session.heroPosition();
    const double length = way.norm();
    if (length < 1e-6) return std::nullopt;
    const sulfur::Point on = way / length * 0.08;
    const auto hit = session.world().castSegment(head - on, head + on,
                                                 {.mask = ~(Category::hero | Category::rope)});
    if (!hit) return std::nullopt;
    return hit->body;
}

/// 50 times a second is enough for what goes on.
void Sounds::follow(const Session& session) {
    followRest_ = 10;
    followRope(session);
    followDanger(session);
}

/// The creak follows tension and, more than that, its change; the hum comes near the end.
void Sounds::followRope(const Session& session) {
    const double tension = std::max(0.0, session.rope().tension(session.world()));
    const double change = std::abs(tension - lastTension_);
    lastTension_ = tension;
    const double goal = std::min(1.0, tension / 220 + change / 40);
    strain_ += 0.2f * (static_cast<float>(goal) - strain_);
    if (session.rope().state() != Rope::State::attached || strain_ < 0.01f) {
        audio_.stop(creakVoice_);
        audio_.stop(humVoice_);
        creakVoice_ = humVoice_ = {};
        return;
    }
    if (!audio_.playing(creakVoice_)) creakVoice_ = audio_.play(creak_, {.gain = 0, .loop = true});
    if (!audio_.playing(humVoice_)) humVoice_ = audio_.play(hum_, {.gain = 0, .loop = true});
    const float pull = std::min(1.0f, static_cast<float>(tension) / 150);
    audio_.setGain(creakVoice_, 0.9f * strain_);
    audio_.setPitch(creakVoice_, 0.7f + 0.8f * strain_);
    audio_.setGain(humVoice_, 0.35f * pull * pull);
    audio_.setPitch(humVoice_, 0.6f + 0.9f * pull);
}

/// Monsters that are roused, and the end of a countdown.
void Sounds::followDanger(const Session& session) {
    float goal = 0;
    const auto& monsters = session.level().monsters;
    for (std::size_t i = 0; i < monsters.size(); ++i) {
        const Monsters::Mood mood = session.workings().monsters.mood(i);
        if (mood == Monsters::Mood::alert) goal = std::max(goal, 0.6f);
        if (mood == Monsters::Mood::angry) goal = 1;
    }
    if (const auto left = session.secondsLeft())
        goal = std::max(goal, static_cast<float>(std::clamp(1.5 - *left / 20, 0.0, 1.0)));
    danger_ += (goal > danger_ ? 0.03f : 0.008f) * (goal - danger_);
    loudness_ += 0.03f * (1 - loudness_);
    setMusicGain();
}

void Sounds::setMusicGain() {
    const float gain = musicGain * loudness_;
    audio_.setGain(calmVoice_, gain * (1 - 0.25f * danger_));
    audio_.setGain(dangerVoice_, gain * danger_);
}

void Sounds::accompany(const Level& level) {
    const Theme::World world = level.theme.world;
    Piece& piece = pieces_[world];
    if (!piece.calm.valid()) {
        if (!piece.coming.valid())
            piece.coming = std::async(std::launch::async, [world] { return compose(world, 11); });
        if (piece.coming.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        const Score score = piece.coming.get();
        piece.calm = audio_.createSound(score.calm, scoreRate);
        piece.danger = audio_.createSound(score.danger, scoreRate);
    }
    if (world_ == world && audio_.playing(calmVoice_)) return;
    audio_.stop(calmVoice_);
    audio_.stop(dangerVoice_);
    world_ = world;
    loudness_ = hushed_ ? menuLoudness : 0.2f;
    const atlax::PlayOptions loop{.gain = 0, .loop = true, .bus = atlax::Bus::Music, .priority = 5};
    calmVoice_ = audio_.play(piece.calm, loop);
    dangerVoice_ = audio_.play(piece.danger, loop);
    setMusicGain();
}

void Sounds::hush() {
    audio_.stop(creakVoice_);
    audio_.stop(humVoice_);
    creakVoice_ = humVoice_ = {};
    strain_ = 0;
    hushed_ = true;
    loudness_ = std::min(loudness_, menuLoudness);
    danger_ = 0;
    setMusicGain();
}

void Sounds::click() {
    play(Effect::click, 0.6f);
}

}  // namespace quaoar
