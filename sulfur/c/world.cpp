// The world: its life, time, settings, state and threads.
#include <cstring>

#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

HostTasks::HostTasks(const SulfurTasks& host) : host_(host) {
    if (!host.threads) throw NullPointer{"the function that tells how many threads there are"};
    if (!host.run) throw NullPointer{"the function that runs tasks"};
}

extern "C" {

SulfurZone sulfur_zone_default(void) {
    return toC(Zone{});
}

SulfurWorldSettings sulfur_world_settings_default(void) {
    return toC(WorldSettings{});
}

SulfurResult sulfur_world_create(const SulfurWorldSettings* settings, SulfurWorld** world) {
    return make(world, [&] { return World(orDefault<WorldSettings>(settings)); });
}

SulfurResult sulfur_world_clone(const SulfurWorld* world, SulfurWorld** clone) {
    return make(clone, [&] { return of(world).clone(); });
}

void sulfur_world_destroy(SulfurWorld* world) {
    delete world;
}

// --- time ----------------------------------------------------------------------------------------

SulfurResult sulfur_world_step(SulfurWorld* world) {
    return call([&] { of(world).step(); });
}

SulfurResult sulfur_world_ticks(const SulfurWorld* world, uint64_t* ticks) {
    return give(ticks, [&] { return of(world).ticks(); });
}

SulfurResult sulfur_world_time(const SulfurWorld* world, double* seconds) {
    return give(seconds, [&] { return of(world).time(); });
}

SulfurResult sulfur_world_tick_duration(const SulfurWorld* world, double* seconds) {
    return give(seconds, [&] { return of(world).tickDuration(); });
}

// --- settings ------------------------------------------------------------------------------------

SulfurResult sulfur_world_settings(const SulfurWorld* world, SulfurWorldSettings* settings) {
    return give(settings, [&] { return of(world).settings(); });
}

SulfurResult sulfur_world_gravity(const SulfurWorld* world, SulfurVec* gravity) {
    return give(gravity, [&] { return of(world).gravity(); });
}

SulfurResult sulfur_world_set_gravity(SulfurWorld* world, SulfurVec gravity) {
    return call([&] { of(world).setGravity(vec(gravity)); });
}

SulfurResult sulfur_world_air_friction(const SulfurWorld* world, double* air_friction) {
    return give(air_friction, [&] { return of(world).airFriction(); });
}

SulfurResult sulfur_world_set_air_friction(SulfurWorld* world, double air_friction) {
    return call([&] { of(world).setAirFriction(real(air_friction)); });
}

SulfurResult sulfur_world_set_tick_rate(SulfurWorld* world, int32_t tick_rate) {
    return call([&] { of(world).setTickRate(tick_rate); });
}

SulfurResult sulfur_world_set_damper(SulfurWorld* world, SulfurDamper kind) {
    return call([&] { of(world).setDamper(damper(kind)); });
}

// --- state ---------------------------------------------------------------------------------------

SulfurResult sulfur_world_energy(const SulfurWorld* world, double* joules) {
    return give(joules, [&] { return of(world).energy(); });
}

SulfurResult sulfur_world_hash(const SulfurWorld* world, uint64_t* hash) {
    return give(hash, [&] { return of(world).hash(); });
}

SulfurResult sulfur_world_snapshot(const SulfurWorld* world, SulfurSnapshot** snapshot) {
    return make(snapshot, [&] { return of(world).snapshot(); });
}

SulfurResult sulfur_snapshot_bytes(const SulfurSnapshot* snapshot, const void** bytes,
                                   size_t* size) {
    return call([&] {
        const Snapshot& whole = required(snapshot, "the snapshot").bytes;
        const void*& start = required(bytes, "bytes");
        required(size, "size") = whole.size();
        start = whole.data();
    });
}

void sulfur_snapshot_destroy(SulfurSnapshot* snapshot) {
    delete snapshot;
}

SulfurResult sulfur_world_restore(SulfurWorld* world, const void* bytes, size_t size) {
    return call([&] {
        World& restored = of(world);
        if (!bytes) throw NullPointer{"bytes"};
        Snapshot snapshot(size);
        if (size > 0) std::memcpy(snapshot.data(), bytes, size);
        restored.restore(snapshot);
    });
}

SulfurResult sulfur_world_validate(const SulfurWorld* world, const char** broken) {
    return give(broken, [&]() -> const std::string& {
        std::string found = of(world).validate();
        return world->broken = std::move(found);
    });
}

// --- statistics ----------------------------------------------------------------------------------

const char* sulfur_stage_name(int32_t stage) {
    return stage >= 0 && stage < SULFUR_STAGE_COUNT ? name(static_cast<Stage>(stage)) : "?";
}

SulfurResult sulfur_world_statistics(const SulfurWorld* world, SulfurStatistics* statistics) {
    return give(statistics, [&] { return of(world).statistics(); });
}

SulfurResult sulfur_world_set_profiling(SulfurWorld* world, bool on) {
    return call([&] { of(world).setProfiling(on); });
}

SulfurResult sulfur_world_memory(const SulfurWorld* world, SulfurMemoryUse* out, size_t capacity,
                                 size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).memory(); });
}

// --- threads -------------------------------------------------------------------------------------

SulfurResult sulfur_thread_pool_create(size_t threads, SulfurThreadPool** pool) {
    return make(pool, [&] { return ThreadPool(threads); });
}

void sulfur_thread_pool_destroy(SulfurThreadPool* pool) {
    delete pool;
}

SulfurResult sulfur_world_set_thread_pool(SulfurWorld* world, SulfurThreadPool* pool) {
    return call([&] {
        of(world).setTasks(pool ? &pool->pool : nullptr);
        world->tasks.reset();
    });
}

SulfurTasks sulfur_tasks_default(void) {
    return {};
}

SulfurResult sulfur_world_set_tasks(SulfurWorld* world, const SulfurTasks* tasks) {
    return call([&] {
        World& borrower = of(world);
        auto lent = tasks ? std::make_unique<HostTasks>(*tasks) : nullptr;
        borrower.setTasks(lent.get());
        world->tasks = std::move(lent);
    });
}

}  // extern "C"

}  // namespace sulfur::c
