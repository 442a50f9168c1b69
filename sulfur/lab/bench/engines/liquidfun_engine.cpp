// LiquidFun: Box2D 2.3 with particles.
#include <Box2D/Box2D.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "bench/engine.hpp"

namespace sulfur::lab::bench {

namespace {

#include "bench/engines/box2d_v2_world.ipp"

class LiquidFunWorld final : public ClassicWorld {
public:
    explicit LiquidFunWorld(const Setting& setting) : ClassicWorld(setting) {
        b2ParticleSystemDef def;
        def.radius = static_cast<float>(BlobPlan::radius);
        particles_ = world_.CreateParticleSystem(&def);
        const float tick = 1 / static_cast<float>(setting.rate);
        // What its own helper suggests; at high rates that is 1.
        particleIterations_ = world_.CalculateReasonableParticleIterations(tick);
    }

    /// A solid elastic group. Its particles overlap by a quarter, so that it is smaller than what
    /// the plan says, with a mass of 1 kg.
    void addBlob(const Point& centre) override {
        constexpr float stride = 0.25F;
        std::vector<b2Vec2> places;
        for (int i = 0; i < BlobPlan::side * BlobPlan::side; ++i)
            places.emplace_back((static_cast<float>(i % BlobPlan::side) - 1.5F) * stride,
                                (static_cast<float>(i / BlobPlan::side) - 1.5F) * stride);
        b2ParticleGroupDef def;
        def.flags = b2_elasticParticle;
        def.groupFlags = b2_solidParticleGroup;
        def.position = vec(centre);
        def.particleCount = static_cast<int32>(places.size());
        def.positionData = places.data();
        blobs_.push_back(particles_->CreateParticleGroup(def));
    }
    std::vector<Point> blob(std::size_t i) const override {
        const b2Vec2* all = particles_->GetPositionBuffer();
        std::vector<Point> found;
        const int32 first = blobs_[i]->GetBufferIndex();
        for (int32 k = 0; k < blobs_[i]->GetParticleCount(); ++k)
            found.push_back(pointOf(all[first + k]));
        return found;
    }

    void step() override {
        const int positions = setting_.iterations > 1 ? 3 * setting_.iterations / 8 : 1;
        world_.Step(1 / static_cast<float>(setting_.rate), setting_.iterations, positions,
                    particleIterations_);
    }

private:
    b2ParticleSystem* particles_ = nullptr;
    int particleIterations_ = 1;
    std::vector<b2ParticleGroup*> blobs_;
};

}  // namespace

std::unique_ptr<EngineWorld> makeLiquidFun(const Setting& setting) {
    return std::make_unique<LiquidFunWorld>(setting);
}

std::string liquidFunVersion() {
    return std::to_string(b2_liquidFunVersion.major) + '.' +
           std::to_string(b2_liquidFunVersion.minor) + '.' +
           std::to_string(b2_liquidFunVersion.revision);
}

}  // namespace sulfur::lab::bench
