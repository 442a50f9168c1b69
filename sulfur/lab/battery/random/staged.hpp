// A scene that lives in a world.
#pragma once

#include <sulfur/sulfur.hpp>
#include <vector>

#include "battery/random/scene.hpp"

namespace sulfur::lab {

class Staged {
public:
    /// Makes everything, at rest. What nobody could tie stays loose: a tie that the library
    /// refuses.
    Staged(const Scene& scene, bool sleeping);

    /// Waits until all sleep or the calm of the scene is over, then lets everything go.
    void launch();
    /// One tick; `twin` is a restored copy that gets the same calls.
    void step(World* twin = nullptr);

    /// How far a surface is behind the axis of a wall of the room, m; 0 where none is.
    double behindWalls() const;
    /// The largest speed of the middle of a body that moves by itself, m/s.
    double fastest() const;
    /// Whether all is at finite places with finite velocities.
    bool finite() const;
    /// Bodies that physics moves.
    std::vector<BodyId> movers() const;

    World world;

private:
    /// What flies, and what is tied to it: a velocity that is set is that of the moment, others are
    /// those of the middle of the step before, and momentum is that of one time.
    std::vector<bool> whoGoes() const;
    void addRoom(double half);
    void add(const Thing& thing);
    void tie(const Tie& tie);
    void keepIfWhole(AttachmentId id);
    void add(const Influence& influence);
    ParticleId particleAt(std::size_t thing, double along);
    void drive(World& which);

    const Scene& scene_;
    std::vector<Body> bodies_;
    long driven_ = 0;  // ticks
};

}  // namespace sulfur::lab
