// Files, time and history of a document; what changes it is in edits.cpp.
#include "document.hpp"

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <cmath>
#include <cstring>

#include "document_steps.hpp"
#include "geometry.hpp"
#include "keep_layout.hpp"
#include "meter.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::World;
using sulfur::scene::Placement;
using sulfur::scene::Scene;

constexpr std::size_t mostKept = std::size_t{1} << 20;  // bytes of a file whose layout is kept

Scene emptyScene() {
    Scene scene;
    scene.title = "Untitled";
    scene.blueprints.push_back(sulfur::scene::makePrefab(
        "floor", sulfur::scene::FloorOptions{.from = {-20, 0}, .to = {20, 0}, .material = {}}));
    Placement floor;
    floor.id = "floor";
    floor.blueprint = "floor";
    scene.bodies.push_back(floor);
    return scene;
}

}  // namespace

Document::Document(std::filesystem::path historyFolder) : shelf_(std::move(historyFolder)) {
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
    noteFile(file);
}

// Levels are small, and their proofs hold for their bytes.
void Document::noteFile(const std::filesystem::path& file) {
    fileText_.clear();
    fileFormat_.clear();
    if (levelText().empty()) return;
    try {
        fileText_ = atlax::readFile(file, mostKept);
        fileFormat_ = sulfur::scene::format(planScene());
    } catch (const atlax::Error&) {
        fileText_.clear();  // too large: it is written anew
    }
}

void Document::recover(const std::filesystem::path& kept, const std::filesystem::path& of) {
    adopt(sulfur::scene::read(kept));
    file_ = of;
    state_ = ++lastState_;
}

void Document::adopt(Scene scene) {
    Plan plan(std::move(scene));
    std::string text = sulfur::scene::format(plan.scene());
    thrustersOf(plan.scene());  // refuses those that are unusable
    {
        metersOf(plan.scene());              // what cannot be used is refused here
        World trial(plan.scene().settings);  // and what cannot be stamped
        sulfur::scene::instantiate(plan.scene(), trial);
    }
    if (!world_) world_ = std::make_unique<World>();
    plan_ = std::move(plan);
    text_ = std::move(text);
    file_.clear();
    fileText_.clear();
    fileFormat_.clear();
    constants_ = Constants{};
    constants_.gravity = -static_cast<double>(plan_.scene().settings.gravity.y());
    constants_.airFriction = static_cast<double>(plan_.scene().settings.airFriction);
    initialConstants_ = constants_;
    keys_.clear();
    ids_.clear();
    passing_.clear();
    undo_.clear();
    redo_.clear();
    open_.reset();
    falling_ = {};
    timeline_.clear();
    state_ = savedState_ = ++lastState_;
    playing_ = false;
    moved_ = false;
    stamp();
}

Scene Document::planScene() const {
    return scaled(plan_.scene(), constants_);
}

std::string Document::text() const {
    std::string text = sulfur::scene::format(planScene());
    return fileText_.empty() ? text : keepLayout(fileText_, fileFormat_, text);
}

Document::Captured Document::captureMoment() const {
    Captured captured;
    std::vector<BodyId> pieces;
    Scene base = planScene();
    sulfur::scene::Instance instance;
    const auto own = pinsOf(*world_);
    std::size_t rained = 0;
    for (const auto& prefab : passing_) {
        base.blueprints.push_back(prefab);
        base.blueprints.back().blueprint.name = "passing" + std::to_string(++rained);
    }
    rained = 0;
    for (const BodyId body : world_->bodies()) {
        const auto key = world_->userData(body);
        if (const std::string id = idOf(body); !id.empty()) {
            instance.bodies.emplace(id, body);
            captured.bodies.push_back(body);
        } else if (isPassing(key)) {
            Placement placement;
            do placement.id = world_->name(body) + std::to_string(++rained);
            while (plan_.contains(placement.id));
            placement.blueprint = "passing" + std::to_string(passingPlace(key) + 1);
            instance.bodies.emplace(placement.id, body);
            base.bodies.push_back(std::move(placement));
            captured.bodies.push_back(body);
        } else if (!own.contains(body)) {
            pieces.push_back(body);
        }
    }
    instance.mechanisms = made();
    for (std::size_t i = 0; i < base.fields.size(); ++i) instance.fields.push_back(fieldOf(i));
    // What has a name comes first.
    captured.bodies.insert(captured.bodies.end(), pieces.begin(), pieces.end());
    Scene& moment = captured.scene;
    moment = sulfur::scene::capture(*world_, base, instance);
    std::erase_if(moment.blueprints, [&](const auto& prefab) {
        return prefab.blueprint.name.starts_with("passing") &&
               std::none_of(moment.bodies.begin(), moment.bodies.end(), [&](const auto& body) {
                   return body.blueprint == prefab.blueprint.name;
               });
    });
    return captured;
}

Document::Captured Document::captureForClipboard() const {
    if (moved_) {
        Captured captured = captureMoment();
        Constants back;
        back.elasticity = 1 / constants_.elasticity;
        back.friction = constants_.friction > 0 ? 1 / constants_.friction : 1;
        captured.scene = scaled(std::move(captured.scene), back);
        return captured;
    }
    Captured captured{plan_.scene(), {}};
    std::unordered_map<std::string, BodyId> bodies;
    for (const BodyId body : world_->bodies()) bodies.emplace(idOf(body), body);
    for (const Placement& placement : captured.scene.bodies)
        captured.bodies.push_back(bodies[placement.id]);
    return captured;
}

void Document::save(const std::filesystem::path& file) {
    commit();
    if (fileText_.empty())
        sulfur::scene::write(planScene(), file);
    else
        sulfur::scene::writeFile(text(), file);
    file_ = file;
    noteFile(file);
    savedState_ = state_;
}

void Document::saveMoment(const std::filesystem::path& file) const {
    sulfur::scene::write(momentScene(), file);
}

std::string Document::name() const {
    return file_.empty() ? "Untitled" : file_.filename().string();
}

// --- the world -------------------------------------------------------------------------------

std::uint64_t Document::keyOf(const std::string& id) {
    const auto [found, isNew] = keys_.emplace(id, ids_.size() + 1);
    if (isNew) ids_.push_back(id);
    return found->second;
}

std::string Document::idOf(BodyId body) const {
    const auto key = world_->userData(body);
    if (key == 0 || key > ids_.size()) return "";
    const std::string& id = ids_[key - 1];
    if (!plan_.contains(id)) return "";
    // What has broken is no longer what the plan says.
    const auto& blueprint = plan_.prefab(plan_.body(id).blueprint).blueprint;
    return world_->particles(body).size() == blueprint.particles.size() ? id : "";
}

std::string Document::originOf(BodyId body) const {
    const auto key = world_->userData(body);
    if (key == 0 || key > ids_.size() || !plan_.contains(ids_[key - 1])) return "";
    return ids_[key - 1];
}

BodyId Document::bodyOf(std::string_view id) const {
    const auto key = keys_.find(std::string(id));
    if (key == keys_.end()) return {};
    for (const BodyId body : world_->bodies())
        if (world_->userData(body) == key->second && idOf(body) == id) return body;
    return {};
}

// Runs what gives bodies new handles, and says so.
void Document::takeOver(const std::function<void()>& change) {
    std::unordered_map<std::uint64_t, BodyId> after;
    std::vector<std::pair<BodyId, std::uint64_t>> before;
    for (const BodyId body : world_->bodies())
        if (!idOf(body).empty()) before.emplace_back(body, world_->userData(body));
    change();
    ++revision_;
    for (const BodyId body : world_->bodies())
        if (!idOf(body).empty()) after.emplace(world_->userData(body), body);
    if (!onNewHandles) return;
    std::sort(before.begin(), before.end());
    onNewHandles([&](BodyId old) {
        const auto known =
            std::lower_bound(before.begin(), before.end(), std::pair(old, 0ull),
                             [](const auto& a, const auto& b) { return a.first < b.first; });
        if (known == before.end() || known->first != old) return BodyId{};
        const auto now = after.find(known->second);
        return now == after.end() ? BodyId{} : now->second;
    });
}

void Document::stamp() {
    takeOver([this] {
        World made(plan_.scene().settings);
        const auto instance = sulfur::scene::instantiate(planScene(), made);
        for (const auto& [id, body] : instance.bodies) made.setUserData(body, keyOf(id));
        *world_ = std::move(made);
        moved_ = false;
        touched_ = false;
        timeline_.leave();
    });
}

// --- time ------------------------------------------------------------------------------------

void Document::startTime() {
    if (moved_) return;
    commit();
    moved_ = true;
}

void Document::play() {
    if (playing_) return;
    startTime();
    playing_ = true;
}

void Document::tick() {
    beforeActing();
    world_->step();
    timeline_.ticked(*world_);
}

// What an edit has done to the world is recorded before anything else happens to it.
void Document::beforeActing() {
    startTime();
    if (touched_) timeline_.changed(*world_);
    touched_ = false;
    timeline_.prepare(*world_);
}

void Document::touched() {
    ++revision_;
    touched_ = touchedInStep_ = true;
}

void Document::push(const Push& push) {
    beforeActing();
    timeline_.note(push);
    world_->wake(world_->info(push.particle).body);
    world_->applyForce(push.particle, push.force);
}

void Document::thrust(const Thrust& thrust) {
    beforeActing();
    timeline_.note(thrust);
    apply(*world_, thrust);
}

void Document::drive(sulfur::MechanismId mechanism, const sulfur::Drive& drive) {
    beforeActing();
    timeline_.note(DriveChange{mechanism, drive});
    world_->setDrive(mechanism, drive);
}

std::optional<Moment> Document::recordedMoment() const {
    const Timeline::Place place = timeline_.place();
    return touched_ || !place.exact ? std::nullopt : place.moment;
}

bool Document::goTo(const Moment& moment, double milliseconds) {
    commit();
    playing_ = false;
    const auto go = [&] {
        timeline_.go(*world_, moment, milliseconds);
        moved_ = true;
        touched_ = false;
    };
    const auto& now = timeline_.now();
    if (now && now->branch == moment.branch && !timeline_.edited(*now, moment.tick))
        followTime(go);
    else
        takeOver(go);
    const Moment reached = *timeline_.now();
    return reached.tick ==
           std::clamp(moment.tick, timeline_.first(reached.branch), timeline_.last(reached.branch));
}

void Document::lookAt(std::unique_ptr<World>& other, const std::function<void()>& look) {
    struct Exchange {
        std::unique_ptr<World>& a;
        std::unique_ptr<World>& b;
        Exchange(std::unique_ptr<World>& one, std::unique_ptr<World>& two) : a(one), b(two) {
            a.swap(b);
        }
        ~Exchange() { a.swap(b); }
    };
    const Exchange exchange(world_, other);
    look();
}

// Where no edit lies between two moments, a handle means the same body in both. While the slider is
// dragged there is one after the other, and views keep what they know of bodies.
void Document::followTime(const std::function<void()>& go) {
    const auto span = world_->bodies();
    const std::vector<BodyId> before(span.begin(), span.end());
    go();
    const auto after = world_->bodies();
    if (std::equal(before.begin(), before.end(), after.begin(), after.end())) return;
    ++revision_;
    if (onNewHandles)
        onNewHandles([this](BodyId old) { return world_->contains(old) ? old : BodyId{}; });
}

void Document::reset() {
    if (!moved_) return;
    commit();
    playing_ = false;
    Step step;
    step.label = "Reset";
    step.other = side();
    stamp();
    undo_.push_back(std::move(step));
    redo_.clear();
}

}  // namespace sulfurchamber
