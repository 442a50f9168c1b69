// Draws a session on a canvas. Sees the session only through its public, constant side: drawing
// never changes the game.
#pragma once

#include <array>
#include <atlax/camera.hpp>
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
class BodyPainter;
class MechanicsView;
class MonsterView;

/// What is drawn beside the world itself.
struct ViewOptions {
    bool aim = true;                                      ///< the range line and the crosshair
    std::optional<atlax::Vec2> crosshair = std::nullopt;  ///< pixels; the mouse
    Quality quality = {};                                 ///< the best unless said otherwise
    bool shake = true;                                    ///< the picture trembles with blows
    bool flashes = true;                                  ///< sudden lights
    bool highContrast = false;  ///< what can be held and what hurts stands out from the rest
};

/// The picture of one session: camera, backdrop, ice, bodies, hero, rope, sparks.
class GameView {
public:
    /// Both must outlive the view. Grounds that another view of the same art has already drawn in
    /// the same way are taken from it: these take longest.
    GameView(Art& art, const Session& session, const GameView* like = nullptr);
    ~GameView();

    /// Call once after every tick of the session: moves camera, scarf and sparks.
    void tick();
    /// Back to the hero at once, as after a restart.
    void cut();
    /// Looks where another view of the same session looks, at the same moment of its scenery.
    void resume(const GameView& before);
    /// Looks somewhere else than at the hero until cut() is called; metres.
    void lookAt(atlax::Vec2 centre);
    /// The same through this camera, also beyond the level's bounds: for editors.
    void lookThrough(const atlax::Camera& camera);

    void draw(atlax::Canvas& canvas, double alpha, const ViewOptions& options);

    /// How brightly the rope's reach flashes after a miss, 0 to 1.
    float reachFlash() const { return reachFlash_; }
    /// Ropes that nothing holds and that still fall.
    std::size_t looseRopes() const { return strands_.size(); }
    /// How strained the rope looks, 0 to 1.
    float strain() const { return strain_; }

    /// The camera of the last draw, for turning the mouse into a direction.
    atlax::Camera camera(atlax::PixelSize size) const;

private:
    struct Spark {
        atlax::Vec2 position, velocity;
        float life = 0, lasts = 1, size = 0.01f;
        atlax::Color color;
        bool mist = false;  ///< grows and rises instead of falling
    };
    /// Points that trail behind the hero, held together by their distances.
    struct Trail {
        std::array<atlax::Vec2, 7> now, before;
    };

    /// A rope that nothing holds any more: it falls, or is drawn back, and fades.
    struct Strand {
        std::vector<atlax::Vec2> now, before;
        float life = 1;          ///< 1 to 0
        bool drawnBack = false;  ///< into the hand
    };
    /// What the hero's face shows, 0 to 1 each.
    struct Mood {
        float fear = 0, joy = 0, effort = 0;
    };

    void drawScene(atlax::Canvas& canvas, double alpha, const ViewOptions& options);
    void dim(atlax::Canvas& canvas) const;
    void drawOutlines(atlax::Canvas& canvas, double alpha);
    void drawLamp(atlax::Canvas& canvas, const Quality& quality);
    void moveTrails();
    void notice();
    void moveMood();
    void moveRopes();
    void dropRope(const std::vector<atlax::Vec2>& points, bool drawnBack);
    std::vector<atlax::Vec2> ropePoints(double alpha) const;
    void breathe();
    void moveSparks();
    void burst(atlax::Vec2 at, int count, float speed, atlax::Color color);
    float random();

    void drawGate(atlax::Canvas& canvas, bool front);
    void drawHero(atlax::Canvas& canvas, double alpha);
    void drawFace(atlax::Canvas& canvas, atlax::Vec2 middle, atlax::Vec2 squash);
    void drawEye(atlax::Canvas& canvas, atlax::Vec2 eye, float side, atlax::Vec2 squash);
    void drawMouth(atlax::Canvas& canvas, atlax::Vec2 mouth);
    void drawAntenna(atlax::Canvas& canvas, atlax::Vec2 crown);
    void drawScarf(atlax::Canvas& canvas);
    void drawCollar(atlax::Canvas& canvas, atlax::Vec2 middle, atlax::Vec2 squash);
    void drawArm(atlax::Canvas& canvas, atlax::Vec2 middle, double alpha);
    void drawRope(atlax::Canvas& canvas, atlax::Vec2 middle, double alpha);
    void drawStrands(atlax::Canvas& canvas);
    void drawReachFlash(atlax::Canvas& canvas, bool bright);
    void drawRange(atlax::Canvas& canvas);
    void drawSparks(atlax::Canvas& canvas);
    void drawCrosshair(atlax::Canvas& canvas, atlax::Vec2 pixels);
    atlax::Vec2 handPlace(atlax::Vec2 middle, double alpha) const;

    Art& art_;
    const Session& session_;
    std::unique_ptr<Backdrop> backdrop_;
    std::vector<std::shared_ptr<const IceView>> ice_;
    atlax::RenderTarget coarse_;
    std::unique_ptr<BodyPainter> painter_;
    std::unique_ptr<MechanicsView> mechanics_;
    std::unique_ptr<MonsterView> monsters_;
    std::vector<sulfur::BodyId> drawnElsewhere_;  ///< not by the painter
    std::vector<Spark> sparks_;
    Trail scarf_;
    atlax::Vec2 antenna_, antennaVelocity_;
    FollowCamera follow_;
    std::optional<atlax::Vec2> lookAt_;
    std::optional<atlax::Camera> eye_;  ///< instead of all others
    std::vector<Strand> strands_;
    std::vector<atlax::Vec2> lastRope_;  ///< of the last tick, from the head to the hand
    Mood mood_;
    float strain_ = 0;        ///< of the rope, 0 to 1, smoothed
    float strainRate_ = 0;    ///< how fast it changes: how much the rope trembles
    float reachFlash_ = 0;    ///< 1 to 0 after a miss
    std::uint64_t time_ = 0;  ///< ticks since the view was made
    std::uint32_t dice_ = 12345;
};

}  // namespace quaoar
