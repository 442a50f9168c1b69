// memory: what a world holds for each particle, joint, contact, and whether that grows with it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <sulfur/sulfur.hpp>

#include "battery/scenes.hpp"
#include "bench/show.hpp"
#include "bench/ticks.hpp"
#include "experiments/experiment.hpp"
#include "experiments/number.hpp"

namespace sulfur::lab {

namespace {

/// Half of the particles are of crates, a quarter of soft squares, a quarter of ropes; far enough
/// apart to stay so.
std::unique_ptr<World> mixedWorld(std::size_t particles) {
    auto world = std::make_unique<World>(still({}, standardGravity));
    const Blueprint crate = shapes::box();
    const Blueprint soft = shapes::jelly({.columns = 4, .rows = 4});
    const Blueprint rope = shapes::rope({.to = {0, -5}, .links = 10, .pinFirst = true});
    const auto along = static_cast<std::size_t>(std::sqrt(static_cast<double>(particles) / 8)) + 1;
    std::size_t made = 0, place = 0;
    const auto add = [&](const Blueprint& plan, std::size_t wanted) {
        while (made < wanted) {
            world->add(plan, {.position = Point(8.0 * static_cast<double>(place % along),
                                                8.0 * static_cast<double>(place / along))});
            made += plan.particles.size();
            ++place;
        }
    };
    add(crate, particles / 2);
    add(soft, particles * 3 / 4);
    add(rope, particles);
    return world;
}

struct Measured {
    std::size_t particles = 0, joints = 0;
    std::vector<MemoryUse> uses;
    bench::Spread tick;  ///< s

    double perParticle() const {
        double bytes = 0;
        for (const MemoryUse& use : uses) bytes += static_cast<double>(use.bytes);
        return bytes / static_cast<double>(particles);
    }
};

class Memory final : public Experiment {
public:
    std::string name() const override { return "memory"; }
    std::string description() const override {
        return "bytes a world holds, part by part, up to a million particles";
    }

    void declare(CLI::App& app) override {
        app.add_option("--particles", sizes_, "Sizes of the world, with commas between them")
            ->delimiter(',')
            ->check(between(1'000, 10'000'000))
            ->capture_default_str();
    }

    Report run() override {
        std::vector<Measured> all;
        for (const std::size_t size : sizes_) {
            const auto world = mixedWorld(size);
            const auto tick = bench::tickTime(*world, {.warmUp = 5, .ticks = 5, .repeats = 3});
            all.push_back(
                {world->statistics().particles, world->statistics().joints, world->memory(), tick});
        }
        return {asText(all), asCsv(all), asJson(all)};
    }

private:
    static std::string asText(const std::vector<Measured>& all) {
        std::string out =
            "What a world of crates (half of the particles), jellies and ropes (a quarter each) "
            "holds.\n";
        for (const Measured& m : all) {
            out += fmt::format(
                "\n{} particles, {} joints: {:.0f} bytes a particle in all, a tick takes {:.2f} "
                "ms\n{:<36}{:>12}{:>14}{:>12}\n",
                m.particles, m.joints, m.perParticle(), 1e3 * m.tick.median, "", "items", "bytes",
                "an item");
            for (const MemoryUse& use : m.uses)
                out += fmt::format("{:<36}{:>12}{:>14}{:>12.1f}{}\n", use.name, use.items,
                                   use.bytes, use.perItem(), use.hot ? "  hot" : "");
        }
        return out;
    }

    static std::string asCsv(const std::vector<Measured>& all) {
        std::string out = "particles,joints,part,items,bytes,hot,tick_s\n";
        for (const Measured& m : all)
            for (const MemoryUse& use : m.uses)
                out += fmt::format("{},{},{},{},{},{},{}\n", m.particles, m.joints,
                                   bench::csvField(use.name), use.items, use.bytes, use.hot ? 1 : 0,
                                   m.tick.median);
        return out;
    }

    static std::string asJson(const std::vector<Measured>& all) {
        std::string out = "{\n  \"worlds\": [";
        const char* separator = "\n";
        for (const Measured& m : all) {
            out +=
                fmt::format("{}    {{\"particles\": {}, \"joints\": {}, \"tick\": {}, \"parts\": [",
                            separator, m.particles, m.joints, bench::jsonNumber(m.tick.median));
            separator = ",\n";
            const char* comma = "";
            for (const MemoryUse& use : m.uses) {
                out += fmt::format("{}{{\"part\": {}, \"items\": {}, \"bytes\": {}, \"hot\": {}}}",
                                   comma, bench::jsonText(use.name), use.items, use.bytes, use.hot);
                comma = ", ";
            }
            out += "]}";
        }
        return out + "\n  ]\n}\n";
    }

    std::vector<std::size_t> sizes_{10'000, 100'000, 1'000'000};
};

}  // namespace

std::unique_ptr<Experiment> makeMemory() {
    return std::make_unique<Memory>();
}

}  // namespace sulfur::lab
