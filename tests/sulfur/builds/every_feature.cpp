// A scene that uses most features of the library, stepped tick by tick. Every build of the library
// must print the same. `every_feature` prints a line for each tick: its number, the hash of the
// world, and one of each array. `every_feature TICK` prints each element of that tick.
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <sulfur/sulfur.hpp>
#include <utility>
#include <vector>

#include "every_feature.hpp"

namespace {

using namespace sulfur;

constexpr int ticks = test::EveryFeature::ticks;

/// All numbers of a world that its public interface shows, by name.
struct Arrays {
    explicit Arrays(const World& world) {
        for (const BodyId body : world.bodies()) addBody(world, body);
        for (const ContactInfo& contact : world.contacts()) {
            add(contacts, contact.point);
            add(contacts, contact.normal);
            add(contacts, contact.impulse);
            add(contacts, contact.friction);
        }
        for (const GrabId grab : world.grabs()) add(grabs, world.info(grab).force);
        add(energy, world.energy());
    }

    using Array = std::pair<const char*, std::vector<double>>;
    std::vector<Array> all() const {
        return {{"position", positions}, {"velocity", velocities}, {"spin", spins},
                {"joint force", forces}, {"contact", contacts},    {"grab", grabs},
                {"energy", energy}};
    }

private:
    void addBody(const World& world, BodyId body) {
        for (const ParticleId p : world.particles(body)) {
            const ParticleInfo info = world.info(p);
            add(positions, info.position);
            add(velocities, info.velocity);
            add(spins, info.spin);
        }
        for (const JointId j : world.joints(body)) add(forces, world.info(j).force);
    }
    template <class Value>
    static void add(std::vector<double>& to, const Value& value) {
        if constexpr (requires { value[1]; }) {
            to.push_back(static_cast<double>(value[0]));
            to.push_back(static_cast<double>(value[1]));
        } else {
            to.push_back(static_cast<double>(value));
        }
    }

    std::vector<double> positions, velocities, spins, forces, contacts, grabs, energy;
};

std::uint64_t hashOf(const std::vector<double>& numbers) {  // FNV-1a, by whole numbers
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const double number : numbers)
        hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3u;
    return hash;
}

void printTick(int t, const World& world) {
    std::printf("tick %d hash %016llx", t, static_cast<unsigned long long>(world.hash()));
    for (const auto& [name, numbers] : Arrays(world).all())
        std::printf(" | %s %016llx", name, static_cast<unsigned long long>(hashOf(numbers)));
    std::printf("\n");
}

void printElements(const World& world) {
    for (const auto& [name, numbers] : Arrays(world).all())
        for (std::size_t i = 0; i < numbers.size(); ++i)
            std::printf("%s %zu: %a\n", name, i, numbers[i]);
}

void play(Friction friction, const char* name, int wanted) {
    std::printf("friction: %s\n", name);
    test::EveryFeature scene(friction);
    for (int t = 0; t < ticks; ++t) {
        scene.tick(t);
        if (wanted < 0) printTick(t, scene.world());
        if (wanted == t) return printElements(scene.world());
    }
}

}  // namespace

int main(int count, char** arguments) {
    int wanted = -1;
    if (count > 1) {
        const char* text = arguments[1];
        const auto end = text + std::strlen(text);
        if (std::from_chars(text, end, wanted).ptr != end || wanted < 0 || wanted >= ticks) {
            std::fprintf(stderr, "every_feature: no tick '%s'; allowed is 0 to %d\n", text,
                         ticks - 1);
            return 2;
        }
    }
    try {
        play(Friction::coulomb, "coulomb", wanted);
        play(Friction::sliding, "sliding", wanted);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "every_feature: %s\n", error.what());
        return 1;
    }
}
