#include "document.hpp"

#include <algorithm>
#include <cmath>

namespace sulfurchamber {
namespace {

using sulfur::Real;
using sulfur::World;

// Bytes of snapshots that the history keeps; the oldest steps go first.
constexpr std::size_t historyBudget = std::size_t{256} << 20;

sulfur::scene::Scene emptyScene() {
    sulfur::scene::Scene scene;
    scene.title = "Untitled";
    scene.blueprints.push_back(sulfur::scene::makePrefab(
        "floor", sulfur::scene::FloorOptions{.from = {-20, 0}, .to = {20, 0}, .material = {}}));
    sulfur::scene::Placement floor;
    floor.id = "floor";
    floor.blueprint = "floor";
    scene.bodies.push_back(floor);
    return scene;
}

}  // namespace

// Everything that an edit can change.
struct Document::Checkpoint {
    sulfur::Snapshot snapshot;
    Constants constants;
    std::map<sulfur::JointId, Real> unscaledStiffness;
    std::map<sulfur::BodyId, sulfur::Material> unscaledMaterial;
    std::uint64_t state = 0;
    std::shared_ptr<const Checkpoint> beforePlay;  // where reset() led
};

struct Document::Step {
    std::string label;
    std::unique_ptr<Checkpoint> other;  // the state on the other side of the step
};

Document::Document() {
    adopt(emptyScene());
}
Document::~Document() = default;

// --- files -----------------------------------------------------------------------------------

void Document::clear() {
    adopt(emptyScene());
}

void Document::open(const std::filesystem::path& file) {
    adopt(sulfur::scene::read(file));
    file_ = file;
}

void Document::adopt(sulfur::scene::Scene scene) {
    auto world = std::make_unique<World>(scene.settings);
    auto instance = sulfur::scene::instantiate(scene, *world);
    // Nothing below throws: the old scene is there until the new one is complete.
    scene_ = std::move(scene);
    instance_ = std::move(instance);
    world_ = std::move(world);
    file_.clear();
    constants_ = Constants{};
    constants_.gravity = -static_cast<double>(world_->gravity().y());
    constants_.airFriction = static_cast<double>(world_->airFriction());
    initialConstants_ = constants_;
    unscaledStiffness_.clear();
    unscaledMaterial_.clear();
    undo_.clear();
    redo_.clear();
    open_.reset();
    beforePlay_.reset();
    state_ = savedState_ = ++lastState_;
    ++revision_;
    playing_ = false;
}

sulfur::scene::Scene Document::capture() const {
    return sulfur::scene::capture(*world_, scene_, instance_);
}

void Document::save(const std::filesystem::path& file) {
    commit();
    sulfur::scene::write(capture(), file);
    file_ = file;
    savedState_ = state_;
}

std::string Document::name() const {
    return file_.empty() ? "Untitled" : file_.filename().string();
}

// --- time ------------------------------------------------------------------------------------

void Document::startTime() {
    if (!beforePlay_) beforePlay_ = checkpoint();
}

void Document::play() {
    if (playing_) return;
    startTime();
    playing_ = true;
}

void Document::tick() {
    startTime();
    world_->step();
}

void Document::reset() {
    if (!beforePlay_) return;
    commit();
    playing_ = false;
    Step step{"Reset", checkpoint()};
    const auto target = beforePlay_;
    restore(*target);
    push(undo_, std::move(step));
    redo_.clear();
}

// --- edits -----------------------------------------------------------------------------------

std::unique_ptr<Document::Checkpoint> Document::checkpoint() const {
    auto made = std::make_unique<Checkpoint>();
    made->snapshot = world_->snapshot();
    made->constants = constants_;
    made->unscaledStiffness = unscaledStiffness_;
    made->unscaledMaterial = unscaledMaterial_;
    made->state = state_;
    made->beforePlay = beforePlay_;
    return made;
}

void Document::restore(const Checkpoint& checkpoint) {
    world_->restore(checkpoint.snapshot);
    constants_ = checkpoint.constants;
    unscaledStiffness_ = checkpoint.unscaledStiffness;
    unscaledMaterial_ = checkpoint.unscaledMaterial;
    state_ = checkpoint.state;
    beforePlay_ = checkpoint.beforePlay;
    ++revision_;
}

void Document::push(std::deque<Step>& steps, Step step) {
    steps.push_back(std::move(step));
    std::size_t bytes = 0;
    std::size_t kept = 0;
    for (auto it = steps.rbegin(); it != steps.rend(); ++it, ++kept) {
        bytes += it->other->snapshot.size();
        if (bytes > historyBudget && kept > 0) break;
    }
    while (steps.size() > kept) steps.pop_front();
}

void Document::edit(const std::string& label, const std::function<void(World&)>& change) {
    begin(label);
    try {
        change(*world_);
    } catch (...) {
        rollback();
        throw;
    }
    commit();
}

void Document::begin(const std::string& label) {
    commit();
    open_ = std::make_unique<Step>(Step{label, checkpoint()});
    redo_.clear();
    state_ = ++lastState_;
    ++revision_;
}

void Document::commit() {
    if (!open_) return;
    push(undo_, std::move(*open_));
    open_.reset();
    ++revision_;
}

void Document::rollback() {
    if (!open_) return;
    const auto step = std::move(open_);
    restore(*step->other);
}

void Document::undo() {
    commit();
    if (undo_.empty()) return;
    Step step = std::move(undo_.back());
    undo_.pop_back();
    auto now = checkpoint();
    restore(*step.other);
    step.other = std::move(now);
    push(redo_, std::move(step));
    playing_ = false;
}

void Document::redo() {
    commit();
    if (redo_.empty()) return;
    Step step = std::move(redo_.back());
    redo_.pop_back();
    auto now = checkpoint();
    restore(*step.other);
    step.other = std::move(now);
    push(undo_, std::move(step));
    playing_ = false;
}

std::string Document::undoLabel() const {
    if (open_) return open_->label;
    return undo_.empty() ? "" : undo_.back().label;
}

std::string Document::redoLabel() const {
    return redo_.empty() ? "" : redo_.back().label;
}

// --- constants -------------------------------------------------------------------------------

void Document::setConstants(const Constants& wanted) {
    using L = ConstantLimits;
    const bool own = !open_;
    if (own) begin("Change constants");
    try {
        const double gravity = std::clamp(wanted.gravity, -L::gravity, L::gravity);
        if (gravity != constants_.gravity) {
            world_->setGravity({world_->gravity().x(), static_cast<Real>(-gravity)});
            constants_.gravity = gravity;
        }
        const double air =
            std::clamp(wanted.airFriction, 0.0,
                       std::min(L::airFriction, static_cast<double>(world_->settings().tickRate)));
        if (air != constants_.airFriction) {
            world_->setAirFriction(static_cast<Real>(air));
            constants_.airFriction = air;
        }
        applyElasticity(std::clamp(wanted.elasticity, L::minElasticity, L::maxElasticity));
        applyFriction(std::clamp(wanted.friction, 0.0, L::friction));
    } catch (...) {
        rollback();
        throw;
    }
    if (own) commit();
}

void Document::applyElasticity(double factor) {
    if (factor == constants_.elasticity) return;
    const auto scale = [&](sulfur::JointId joint) {
        const Real now = world_->info(joint).stiffness;
        if (!std::isfinite(now)) return;
        const auto known = unscaledStiffness_.find(joint);
        const double base = known != unscaledStiffness_.end()
                                ? static_cast<double>(known->second)
                                : static_cast<double>(now) / constants_.elasticity;
        unscaledStiffness_.emplace(joint, static_cast<Real>(base));
        world_->setStiffness(joint, static_cast<Real>(base * factor));
    };
    for (const sulfur::BodyId body : world_->bodies())
        for (const sulfur::JointId joint : world_->joints(body)) scale(joint);
    for (const sulfur::JointId joint : world_->connections()) scale(joint);
    if (factor == 1) unscaledStiffness_.clear();
    constants_.elasticity = factor;
}

void Document::applyFriction(double factor) {
    if (factor == constants_.friction) return;
    for (const sulfur::BodyId body : world_->bodies()) {
        // A body that broke off while the factor was on has no entry; what it had is computed
        // back, or is the usual friction when the factor was 0.
        auto known = unscaledMaterial_.find(body);
        if (known == unscaledMaterial_.end()) {
            sulfur::Material base = world_->material(body);
            if (constants_.friction > 0) {
                base.staticFriction /= static_cast<Real>(constants_.friction);
                base.kineticFriction /= static_cast<Real>(constants_.friction);
            } else {
                base.staticFriction = sulfur::Material{}.staticFriction;
                base.kineticFriction = sulfur::Material{}.kineticFriction;
            }
            known = unscaledMaterial_.emplace(body, base).first;
        }
        sulfur::Material material = known->second;
        material.staticFriction *= static_cast<Real>(factor);
        material.kineticFriction *= static_cast<Real>(factor);
        world_->setMaterial(body, material);
    }
    if (factor == 1) unscaledMaterial_.clear();
    constants_.friction = factor;
}

sulfur::Body Document::addScaled(const sulfur::Blueprint& blueprint, const sulfur::Pose& pose) {
    sulfur::Body body = world_->add(blueprint, pose);
    if (constants_.elasticity != 1) {
        for (const sulfur::JointId joint : body.joints()) {
            const Real stiffness = world_->info(joint).stiffness;
            if (!std::isfinite(stiffness)) continue;
            unscaledStiffness_.emplace(joint, stiffness);
            world_->setStiffness(
                joint, static_cast<Real>(static_cast<double>(stiffness) * constants_.elasticity));
        }
    }
    if (constants_.friction != 1) {
        sulfur::Material material = world_->material(body);
        unscaledMaterial_.emplace(body.id(), material);
        material.staticFriction *= static_cast<Real>(constants_.friction);
        material.kineticFriction *= static_cast<Real>(constants_.friction);
        world_->setMaterial(body, material);
    }
    return body;
}

}  // namespace sulfurchamber
