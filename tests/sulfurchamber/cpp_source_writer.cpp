// What cpp_source.cmake and the build need of a scene: `write SCENE FILE.cpp`, `hash SCENE TICKS`.
// The scene "everything" is the one that uses every member of the format.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>

#include "../sulfur/scene/samples.hpp"
#include "model/cpp_source.hpp"

int main(int argc, char** argv) {
    try {
        if (argc != 4) return 2;
        const auto scene =
            std::strcmp(argv[2], "everything") == 0
                ? sulfur::scene::parse(sulfur::scene::testing::fullScene, "everything")
                : sulfur::scene::read(argv[2]);
        if (std::strcmp(argv[1], "write") == 0) {
            std::ofstream out(argv[3]);
            out << sulfurchamber::cppSource(scene);
            return out.flush() ? 0 : 1;
        }
        sulfur::World world(scene.settings);
        sulfur::scene::instantiate(scene, world);
        for (int tick = 0; tick < std::atoi(argv[3]); ++tick) world.step();
        std::printf("hash %016llx\n", static_cast<unsigned long long>(world.hash()));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
