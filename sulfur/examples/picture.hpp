// Pictures of the examples, as SVG. Nobody needs this file to understand an example: it draws what
// the example has done into the file that its command line names.
#pragma once

#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <sulfur/sulfur.hpp>
#include <vector>

/// Shows what lies between two corners of the world, in the file argv[1]; does nothing when there
/// is no such argument. The file is written when the picture goes out of scope. Where it cannot be
/// opened, the program says so and ends with status 2.
class Picture final : private sulfur::DebugDraw {
public:
    /// Corners in metres.
    Picture(int argc, char** argv, sulfur::Point low, sulfur::Point high);
    ~Picture() override;
    Picture(Picture&&) = delete;
    Picture& operator=(Picture&&) = delete;

    /// Gives a body a colour by name: blue, orange, green, pink, teal, red, violet, gold or grey.
    /// Others have them in turn.
    void paint(sulfur::BodyId body, const char* colour);
    /// Adds the world as it is now, upon what was added before; `opacity` 0 (nothing) to 1.
    void take(const sulfur::World& world, double opacity = 1);
    /// Adds a thin line, such as a ray.
    void line(sulfur::Point a, sulfur::Point b, double opacity = 1);
    /// Adds a dot, such as a place on a way.
    void dot(sulfur::Point centre, double opacity = 1);

private:
    struct Look {
        const char* name;
        const char* dark;   // of its surface
        const char* light;  // of its inside
    };
    struct Side {
        sulfur::ParticleId a, b;
        sulfur::Point from, to;
        double pixels;  // thickness
    };
    using Loop = std::vector<sulfur::Point>;

    void body(const Body& b) override;
    void capsule(const Capsule& c) override;
    void joint(const Joint& j) override;
    void disc(const Disc& d) override;
    void particle(const Particle& p) override;
    void attachment(const Attachment& a) override;
    void grab(const Grab& g) override;

    void finishBody();
    void drawBones(bool solid);
    void drawSides(const char* style);
    void tintGround();
    bool drawLoop();
    bool fillTriangles();
    void corners(const Loop& loop);
    void stroke(sulfur::Point a, sulfur::Point b, double pixels, const char* colour);
    void circle(sulfur::Point centre, double pixels, const char* fill, const char* edge);
    double x(sulfur::Point p) const { return (p.x() - low_.x()) * scale_; }
    double y(sulfur::Point p) const { return (high_.y() - p.y()) * scale_; }

    static const std::array<Look, 9> looks;

    std::ofstream file_;
    std::ostringstream svg_;
    sulfur::Point low_, high_;
    double scale_;                                // pixels per metre
    std::map<sulfur::BodyId, const Look*> look_;  // of bodies seen or painted so far
    std::size_t next_ = 0;                        // colour

    // What is being drawn.
    const sulfur::World* world_ = nullptr;
    sulfur::BodyId body_ = {};
    std::vector<Side> sides_;   // capsules of body_
    std::vector<Joint> bones_;  // its other joints
    std::ostringstream links_;  // joints between bodies
};
