// How a file of R.U.B.E. is read. Only its own files include this.
#pragma once

#include <map>
#include <optional>

#include "rube.hpp"

namespace sulfurchamber {

/// Members of an object: numbers, vectors and flags, as that program leaves them out.
double rubeNumber(const sulfur::scene::Node& object, std::string_view key, double otherwise);
sulfur::Point rubePoint(const sulfur::scene::Node& object, std::string_view key);
bool rubeFlag(const sulfur::scene::Node& object, std::string_view key);

class RubeReader {
public:
    RubeScene read(const sulfur::scene::Node& root);

private:
    /// A fixture.
    struct Piece {
        std::string id;
        sulfur::Point middle;  ///< metres, of the world
        double mass = 0;
    };
    struct Body {
        sulfur::Pose pose;
        sulfur::BodyKind kind = sulfur::BodyKind::fixed;
        std::size_t index = 0;
        bool heavy = false;  ///< whether any of its fixtures has mass
        std::vector<Piece> pieces;
        sulfur::Point toWorld(const sulfur::Point& local) const;
        double mass() const;
        const Piece& nearest(const sulfur::Point& place) const;
    };

    /// What a fixture becomes.
    struct Shape {
        sulfur::scene::Prefab prefab;
        sulfur::Point offset;  ///< of its frame, and its middle: in the frame of the body
        sulfur::Point middle;
    };

    void leaveOut(const std::string& what);
    void addBody(const sulfur::scene::Node& node);
    std::optional<Shape> shapeOf(const Body& body, const sulfur::scene::Node& fixture);
    void addFixture(Body& body, const sulfur::scene::Node& fixture, const std::string& base,
                    const sulfur::Vec2& velocity);
    void holdTogether(const Body& body);
    static double massOf(const sulfur::Blueprint& blueprint);

    // rube_joints.cpp
    void noteAnchors(const sulfur::scene::Node& joint);
    bool heldAt(std::size_t body, const sulfur::Point& middle) const;
    void addJoint(const sulfur::scene::Node& joint);
    /// What a joint holds.
    struct Ends {
        std::string a;  ///< ids of pieces
        std::string b;
        sulfur::Point atA;  ///< metres, of the world
        sulfur::Point atB;
        sulfur::Point axis;
        double angle = 0;  ///< radians of b against a
        double mass = 0;   ///< kg that a spring between both moves
    };
    using Spec = decltype(sulfur::scene::SceneMechanism::spec);
    static Ends endsOf(const sulfur::scene::Node& joint, const Body& a, const Body& b);
    static std::optional<Spec> specOf(const std::string& type, const sulfur::scene::Node& joint,
                                      const Ends& ends);
    void letPass(const Body& a, const Body& b);

    RubeScene made_;
    std::vector<Body> bodies_;
    std::multimap<std::size_t, sulfur::Point> anchors_;  ///< by body, in its frame
};

}  // namespace sulfurchamber
