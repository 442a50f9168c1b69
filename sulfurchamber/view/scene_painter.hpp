// Draws a world: bodies softly filled, joints, pins, arrows, and what the tools show.
#pragma once

#include <atlax/canvas.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <quaoar/skin/skin_painter.hpp>
#include <vector>

#include "../model/loop_region.hpp"
#include "../model/workbench.hpp"
#include "skin_textures.hpp"

namespace sulfurchamber {

inline constexpr float reachPixels = 9;  ///< logical pixels within which the pointer hits
inline constexpr float velocityArrowSeconds = 0.12f;  ///< an arrow is the way of this time
inline constexpr float strainAtFullColour = 0.08f;    ///< at which the colour is strongest
/// Amber and red for what is stretched, cyan for what is pressed.
atlax::Color strainColour(float strain);

/// What is drawn beside the bodies.
struct ViewOptions {
    bool grid = true;
    double gridStep = 0;  ///< metres between its fine lines; 0: it follows the zoom
    bool rulers = true;
    bool joints = true;  ///< inner joints of bodies, where they are large enough
    bool velocities = false;
    bool strain = false;  ///< joints coloured by how far they are stretched
    bool contacts = false;
    bool films = true;           ///< of tools under the pointer
    bool bodies = true;          ///< else somebody else has drawn them, and only marks are
    bool tools = true;           ///< the selection, its handles, and what a tool is doing
    bool gravity = false;        ///< arrows of weights
    bool contactForces = false;  ///< arrows of what contacts push
    bool jointForces = false;    ///< arrows of what joints and mechanisms pull
    bool skeleton = false;       ///< over all, what the physics library sees (paintDebug)
};

/// Keeps what it finds out about bodies between frames.
class ScenePainter {
public:
    /// Where pictures of skins come from; null: bodies are drawn without. It must outlive the
    /// painter.
    void setTextures(SkinTextures* textures) { textures_ = textures; }
    /// The canvas must be in world space; `alpha` as Application::draw has it.
    void paint(atlax::Canvas& canvas, const Workbench& bench, const ViewOptions& options,
               double alpha);
    /// For keys beside what they drive; without one there are none.
    void setFont(const atlax::Font* font) { font_ = font; }

private:
    // How a body looks, found out once.
    struct Look {
        std::size_t jointCount = 0;
        bool soft = false;
        bool filled = true;
        BodyMarks marks;
        /// What is filled; those with holes as triangles of particles.
        struct Fill {
            LoopRegion region;
            std::vector<CornerTriple> triangles;
        };
        std::vector<Fill> fills;
        std::vector<std::uint32_t> lone;     // particles without joints
        std::optional<atlax::Color> colour;  // of its own
    };
    // A body with the places of its particles in this frame.
    struct Posed {
        sulfur::BodyId id;
        const Look* look = nullptr;
        sulfur::BodyKind kind = sulfur::BodyKind::dynamic;
        std::vector<atlax::Vec2> points;
        atlax::Color fill;
        atlax::Color rim;
    };

    const Look& lookOf(const Workbench& bench, sulfur::BodyId body);
    void pose(sulfur::BodyId body, const Look& look, Posed& posed) const;
    void poseInOrder(const Workbench& bench);
    bool paintedSmall(const Posed& body, bool selected);
    bool paintedDense(const Posed& body);
    void paintBody(const Posed& body, bool selected);
    void paintJoints(const Posed& body);
    void paintDiscs(const Posed& body);
    void paintConnections();
    void paintMechanisms();
    void paintBelt(const Posed& body);
    void paintPins();
    void paintStrain();
    void paintVelocities();
    void paintTrails(const Workbench& bench);
    void paintContacts();
    void paintPreview(const Preview& preview);
    void paintSkinFrame(const Preview& preview);
    bool paintSkin(const Posed& body);
    const quaoar::BodyShape& dressOf(sulfur::BodyId body);
    void paintHandles(const Workbench& bench);
    void paintFrame(const std::vector<sulfur::Point>& corners);
    void paintSnap(const SnapPlace& place);
    void paintFill(const Posed& body);
    void arrow(atlax::Vec2 from, atlax::Vec2 to, atlax::Color color);
    bool isHidden(sulfur::BodyId body) const;
    atlax::Vec2 place(sulfur::ParticleId particle) const;

    std::map<sulfur::BodyId, Look> looks_;
    std::map<sulfur::BodyId, quaoar::BodyShape> dresses_;
    SkinTextures* textures_ = nullptr;
    std::uint64_t revision_ = 0;
    std::vector<Posed> posed_;
    std::vector<atlax::MeshVertex> stripes_;
    std::vector<std::uint32_t> stripeCorners_;
    // Of the frame that is being painted.
    atlax::Canvas* canvas_ = nullptr;
    const Document* document_ = nullptr;
    const sulfur::World* world_ = nullptr;
    const ViewOptions* options_ = nullptr;
    const atlax::Font* font_ = nullptr;
    double alpha_ = 0;
    float pixel_ = 0.01f;  // one logical pixel in metres
};

}  // namespace sulfurchamber
