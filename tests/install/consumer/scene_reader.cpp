// Reads a scene with the installed sulfur::scene and runs it.
#include <cstdio>
#include <sulfur/scene.hpp>
#include <sulfur/sulfur.hpp>

int main() {
    const sulfur::scene::Scene scene = sulfur::scene::parse(R"({
        "format": "sulfur-scene", "version": 1, "title": "drop",
        "blueprints": {
            "floor": {"shape": "floor", "from": [-5, 0], "to": [5, 0]},
            "ball": {"shape": "ball", "radius": 0.25}
        },
        "bodies": [
            {"id": "floor", "blueprint": "floor"},
            {"id": "ball", "blueprint": "ball", "position": [0, 2]}
        ]
    })",
                                                            "drop.json");
    sulfur::World world{scene.settings};
    const auto instance = sulfur::scene::instantiate(scene, world);
    while (world.time() < 2) world.step();
    std::printf("%s: %zu bodies; the ball is at %.2f m after 2 s\n", scene.title.c_str(),
                world.bodies().size(), world.centreOfMass(instance.body("ball")).y());
}
