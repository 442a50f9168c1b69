#include <sulfur/error.hpp>
#include <sulfur/scene/prefab.hpp>

namespace sulfur::scene {

namespace {

struct Builder {
    Blueprint operator()(std::monostate) const {
        throw Error(ErrorCode::degenerate,
                    "the generator is empty; allowed is one of the ready-made shapes");
    }
    Blueprint operator()(const FloorOptions& o) const {
        Blueprint plan = shapes::floor(o.from, o.to, o.radius);
        plan.material = o.material;
        return plan;
    }
    Blueprint operator()(const shapes::GroundOptions& o) const { return shapes::ground(o); }
    Blueprint operator()(const shapes::BoxOptions& o) const { return shapes::box(o); }
    Blueprint operator()(const shapes::BallOptions& o) const { return shapes::ball(o); }
    Blueprint operator()(const shapes::RopeOptions& o) const { return shapes::rope(o); }
    Blueprint operator()(const shapes::JellyOptions& o) const { return shapes::jelly(o); }
    Blueprint operator()(const shapes::BlobOptions& o) const { return shapes::blob(o); }
    Blueprint operator()(const shapes::PolygonOptions& o) const { return shapes::polygon(o); }
    Blueprint operator()(const shapes::WheelOptions& o) const { return shapes::wheel(o); }
    Blueprint operator()(const shapes::ChainOptions& o) const { return shapes::chain(o); }
    Blueprint operator()(const shapes::BridgeOptions& o) const { return shapes::bridge(o); }
    Blueprint operator()(const shapes::ClothOptions& o) const { return shapes::cloth(o); }
    Blueprint operator()(const shapes::WallOptions& o) const { return shapes::wall(o); }
};

}  // namespace

Blueprint build(const Generator& generator) {
    Blueprint plan = std::visit(Builder{}, generator);
    plan.validate();
    return plan;
}

Prefab makePrefab(std::string name, const Generator& generator, const std::string& texture) {
    Prefab prefab;
    prefab.generator = generator;
    prefab.blueprint = build(generator);
    prefab.blueprint.name = std::move(name);
    if (!texture.empty()) {
        prefab.blueprint.skin = fitSkin(generator, prefab.blueprint, texture);
        prefab.skinFitted = true;
    }
    return prefab;
}

}  // namespace sulfur::scene
