// What the caller's objects are.
#pragma once

#include <sulfur/c/sulfur.h>

#include <cstddef>
#include <memory>
#include <string>
#include <sulfur/sulfur.hpp>
#include <vector>

#include "convert.hpp"

namespace sulfur::c {

/// The last tick's events as C sees them.
struct EventArrays {
    std::vector<SulfurContactBegun> contactsBegun;
    std::vector<SulfurContactPersisted> contactsPersisted;
    std::vector<SulfurContactEnded> contactsEnded;
    std::vector<SulfurJointBroken> jointsBroken;
    std::vector<SulfurBodySplit> bodiesSplit;
    std::vector<SulfurParticleLost> particlesLost;
    std::vector<SulfurSensorEvent> sensorsEntered, sensorsLeft;
    std::vector<SulfurLimitEvent> limitsReached, limitsLeft;
    std::vector<SulfurMechanismBroken> mechanismsBroken;
    std::vector<SulfurAngleBroken> anglesBroken;
};

/// Threads that a host lends by functions.
class HostTasks final : public Tasks {
public:
    explicit HostTasks(const SulfurTasks& host);
    std::size_t threads() const override { return host_.threads(host_.user); }
    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
        host_.run(host_.user, count, task, context);
    }
    double overhead() const override {
        return host_.overhead ? host_.overhead(host_.user) : Tasks::overhead();
    }
    void rest() override {
        if (host_.rest) host_.rest(host_.user);
    }

private:
    SulfurTasks host_;
};

}  // namespace sulfur::c

struct SulfurWorld {
    sulfur::World world;
    std::unique_ptr<sulfur::c::HostTasks> tasks = {};  // that were lent as functions
    // What was given out, until the next call of the same function.
    mutable sulfur::c::EventArrays events = {};
    mutable std::string broken = {};
    mutable std::vector<SulfurVec> uv = {};
};

struct SulfurBlueprint {
    sulfur::Blueprint plan;
    mutable std::vector<SulfurVec> uv = {};  // that were given out
};

struct SulfurSnapshot {
    sulfur::Snapshot bytes;
};

struct SulfurThreadPool {
    sulfur::ThreadPool pool;
};

namespace sulfur::c {

inline World& of(SulfurWorld* world) {
    return required(world, "the world").world;
}
inline const World& of(const SulfurWorld* world) {
    return required(world, "the world").world;
}
inline Blueprint& of(SulfurBlueprint* blueprint) {
    return required(blueprint, "the blueprint").plan;
}
inline const Blueprint& of(const SulfurBlueprint* blueprint) {
    return required(blueprint, "the blueprint").plan;
}

}  // namespace sulfur::c
