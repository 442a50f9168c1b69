// Draws a session on a canvas. Sees the session only through its public, constant side: drawing
// never changes the game.
#pragma once

#include <array>
#include <atlax/camera.hpp>
#include <map>
#include <memory>
#include <optional>
#include <quaoar/session.hpp>
#include <quaoar/view/art.hpp>
#include <quaoar/view/follow_camera.hpp>
#include <quaoar/view/quality.hpp>
#include <vector>

namespace quaoar {

class IceView;
class Backdrop;
class Texts;

/// What is drawn beside the world itself.
struct ViewOptions {
    bool aim = true;                                      ///< the range line and the crosshair
    bool hints = true;                                    ///< the level's sentences
    std::optional<atlax::Vec2> crosshair = std::nullopt;  ///< pixels; the mouse
    Quality quality = {};                                 ///< the best unless said otherwise
    const Texts* texts = nullptr;                         ///< null: sentences as the level has them
    bool shake = true;                                    ///< the picture trembles with blows
    bool flashes = true;                                  ///< sudden lights
    bool highContrast = false;  ///< what can be held and what hurts stands out from the rest
};

/// The picture of one session: camera, backdrop, ice, bodies, hero, rope, sparks.
class GameView {
public:
    /// Both must outlive the view.
    GameView(Art& art, const Session& session);
    ~GameView();

    /// Call once after every tick of the session: moves camera, scarf and sparks.
    void tick();
    /// Back to the hero at once, as after a restart.
    void cut();
    /// Looks where another view of the same session looks, at the same moment of its scenery.
    void resume(const GameView& before);
    /// Looks somewhere else than at the hero until cut() is called; metres.
    void lookAt(atlax::Vec2 centre);

    void draw(atlax::Canvas& canvas, double alpha, const ViewOptions& options);

    /// The camera of the last draw, for turning the mouse into a direction.
    atlax::Camera camera(atlax::PixelSize size) const;

private:
    struct Spark {
        atlax::Vec2 position, velocity;
        float life = 0, lasts = 1, size = 0.01f;
        atlax::Color color;
    };
    /// Points that trail behind the hero, held together by their distances.
    struct Trail {
        std::array<atlax::Vec2, 7> now, before;
    };

    /// What a body's drawing needs of its blueprint, found once.
    struct SkinPlan {
        std::unique_ptr<sulfur::Skin> skin;  ///< null: drawn as its capsules and discs
        std::vector<std::uint32_t> indices;  ///< of the skin's triangles
        std::vector<std::uint32_t> outline;  ///< indices of particles, counter-clockwise
        float thickness = 0;                 ///< metres, radius of the outline's capsules
    };

    void drawScene(atlax::Canvas& canvas, double alpha, const ViewOptions& options);
    void drawLamp(atlax::Canvas& canvas, const Quality& quality);
    void moveTrails();
    void moveSparks();
    void burst(atlax::Vec2 at, int count, float speed, atlax::Color color);
    float random();

    void drawBodies(atlax::Canvas& canvas, double alpha);
    void drawBody(atlax::Canvas& canvas, sulfur::BodyId id, const Surface& surface, double alpha);
    void drawBolt(atlax::Canvas& canvas, atlax::Vec2 at);
    void drawBare(atlax::Canvas& canvas, sulfur::BodyId id, double alpha);
    const SkinPlan& skinPlan(sulfur::BodyId id);
    std::vector<atlax::Vec2> dressedPlaces(sulfur::BodyId id, const SkinPlan& plan,
                                           double alpha) const;
    void drawGate(atlax::Canvas& canvas, bool front);
    void drawHints(atlax::Canvas& canvas, const Texts* texts);
    void drawHero(atlax::Canvas& canvas, double alpha);
    void drawFace(atlax::Canvas& canvas, atlax::Vec2 middle, atlax::Vec2 squash);
    void drawAntenna(atlax::Canvas& canvas, atlax::Vec2 crown);
    void drawScarf(atlax::Canvas& canvas);
    void drawCollar(atlax::Canvas& canvas, atlax::Vec2 middle, atlax::Vec2 squash);
    void drawArm(atlax::Canvas& canvas, atlax::Vec2 middle, double alpha);
    void drawRope(atlax::Canvas& canvas, atlax::Vec2 middle, double alpha);
    void drawRange(atlax::Canvas& canvas);
    void drawSparks(atlax::Canvas& canvas);
    void drawCrosshair(atlax::Canvas& canvas, atlax::Vec2 pixels);
    atlax::Vec2 handPlace(atlax::Vec2 middle, double alpha) const;

    Art& art_;
    const Session& session_;
    std::unique_ptr<Backdrop> backdrop_;
    std::vector<std::unique_ptr<IceView>> ice_;
    std::vector<sulfur::BodyId> iceBodies_;
    atlax::RenderTarget coarse_;
    std::map<sulfur::BodyId, SkinPlan> plans_;
    std::vector<Spark> sparks_;
    Trail scarf_;
    atlax::Vec2 antenna_, antennaVelocity_;
    FollowCamera follow_;
    std::optional<atlax::Vec2> lookAt_;
    std::uint64_t time_ = 0;  ///< ticks since the view was made
    std::uint32_t dice_ = 12345;
};

}  // namespace quaoar
