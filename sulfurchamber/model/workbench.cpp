#include "workbench.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geometry.hpp"
#include "tool.hpp"
#include "transform.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::World;

std::unique_ptr<Tool> makeTool(Workbench& bench, ToolKind kind) {
    switch (groupOf(kind)) {
        case ToolGroup::select:
            return makeSelectTool(bench);
        case ToolGroup::particles:
            return makeParticleTool(bench, kind);
        case ToolGroup::mechanisms:
            return makeMechanismTool(bench, kind);
        case ToolGroup::zones:
            return makeZoneTool(bench, kind);
        case ToolGroup::change:
            return makeChangeTool(bench, kind);
        case ToolGroup::measure:
            return makeMeterTool(bench, kind);
        default:
            break;
    }
    if (kind == ToolKind::polygon || kind == ToolKind::draw) return makeOutlineTool(bench, kind);
    return makeCreateTool(bench, kind);
}

}  // namespace

Workbench::Workbench(std::filesystem::path historyFolder)
    : document_(std::move(historyFolder)), tool_(makeTool(*this, ToolKind::select)) {
    document_.onNewHandles = [this](const auto& now) { followHandles(now); };
}
Workbench::~Workbench() = default;

void Workbench::setTool(ToolKind tool) {
    tool_->cancel();
    snapMark_.reset();
    tool_ = makeTool(*this, tool);
    toolKind_ = tool;
}

// What a tool has made is selected: its properties are at hand.
void Workbench::making(const std::function<void()>& act) {
    const std::size_t before = document_.scene().bodies.size();
    const auto chosen = fitting();
    act();
    const auto& bodies = document_.scene().bodies;
    if (bodies.size() <= before || fitting() != chosen || !things_.empty()) return;
    std::vector<BodyId> made;
    for (std::size_t i = before; i < bodies.size(); ++i)
        if (const BodyId body = document_.bodyOf(bodies[i].id);
            body && !document_.isPeg(bodies[i].id))
            made.push_back(body);
    select(std::move(made));
}

void Workbench::setPlacing(LevelPiece piece) {
    tool_->cancel();
    tool_ = makePlaceTool(*this, piece);
    toolKind_ = ToolKind::place;
    placing_ = piece;
}

std::optional<LevelPiece> Workbench::placing() const {
    return toolKind_ == ToolKind::place ? std::optional(placing_) : std::nullopt;
}

void Workbench::take(std::unique_ptr<Tool> tool) {
    tool_->cancel();
    tool_ = std::move(tool);
    toolKind_ = ToolKind::select;
}

void Workbench::press(const Pointer& pointer) {
    snapMark_.reset();
    making([&] { tool_->press(pointer); });
}
void Workbench::move(const Pointer& pointer) {
    snapMark_.reset();
    tool_->move(pointer);
}
void Workbench::release(const Pointer& pointer) {
    making([&] { tool_->release(pointer); });
    snapMark_.reset();
    forgetRemoved();
    if (tool_->done()) setTool(ToolKind::select);
}
void Workbench::finish() {
    making([&] { tool_->finish(); });
}
void Workbench::cancel() {
    tool_->cancel();
    snapMark_.reset();
}
Preview Workbench::preview() const {
    return tool_->preview();
}
std::string Workbench::hint() const {
    return tool_->hint();
}
bool Workbench::stretching() const {
    return tool_->showsFrame();
}

Point Workbench::snapped(const Point& point) const {
    const double grid = snapping_.grid;
    if (!(grid > 0)) return point;
    return {std::round(point.x() / grid) * grid, std::round(point.y() / grid) * grid};
}

Point Workbench::snapped(const Pointer& pointer, std::optional<Point> from) {
    const Snapped found = snapPoint(document_.world(), pointer.position, pointer.reach, snapping_,
                                    from, [this](BodyId body) { return !marks(body).hidden; });
    snapMark_ = found.place;
    return found.point;
}

void Workbench::documentChanged() {
    forgetRemoved();
}

void Workbench::forgetRemoved() {
    std::erase_if(selection_, [&](BodyId body) { return !document_.world().contains(body); });
    std::erase_if(things_, [&](const LevelThing& thing) { return !contains(document_, thing); });
    std::erase_if(selectedMeters_,
                  [&](const std::string& id) { return meters_.find(id) == nullptr; });
}

// --- time ------------------------------------------------------------------------------------

void Workbench::tick() {
    document_.startTime();
    tool_->tick();
    if (rain_ > 0) addRainBox();
    controls_.tick(document_);
    textbook_.beforeTick();
    if (timing_) document_.world().setProfiling(true);
    document_.tick();
    if (timing_) stageTimes_.add(document_.world().statistics());
    textbook_.sample();
    meters_.sample();
    measurements_.sample(document_.world(), [this](const std::string& id, const Quantity& reading) {
        const Meter* meter = meters_.find(id);
        return meter == nullptr ? std::nullopt : meters_.read(*meter, reading);
    });
    if (trailing_) trails_.sample(document_.world());
}

// --- history ---------------------------------------------------------------------------------

namespace {

std::vector<std::string> namesOf(const Document& document) {
    std::vector<std::string> names;
    for (const auto& body : document.scene().bodies) names.push_back(body.id);
    return names;
}

// A step that leaves as many bodies, with a new name at the place of another, has renamed one.
void followNames(std::vector<std::string>& chosen, const std::vector<std::string>& before,
                 const std::vector<std::string>& after) {
    if (before.size() != after.size() || before == after) return;
    const std::set<std::string> known(before.begin(), before.end());
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i] != after[i] && !known.contains(after[i]))
            std::replace(chosen.begin(), chosen.end(), before[i], after[i]);
}

}  // namespace

void Workbench::undo() {
    cancel();
    document_.commit();  // an open edit counts as a step, but one that changed nothing is none
    if (const std::size_t place = document_.historyPlace(); place > 0) goToStep(place - 1);
}

void Workbench::redo() {
    cancel();
    document_.commit();
    goToStep(document_.historyPlace() + 1);
}

void Workbench::goToStep(std::size_t steps) {
    cancel();
    std::vector<std::string> chosen;
    for (const BodyId body : selection_) chosen.push_back(document_.idOf(body));
    const auto go = [&](void (Document::*step)()) {
        const auto before = chosen.empty() ? std::vector<std::string>() : namesOf(document_);
        (document_.*step)();
        if (!chosen.empty()) followNames(chosen, before, namesOf(document_));
    };
    while (document_.historyPlace() > steps && document_.canUndo()) go(&Document::undo);
    while (document_.historyPlace() < steps && document_.canRedo()) go(&Document::redo);
    if (!chosen.empty()) selectAgain(chosen);
    documentChanged();
}

// Bodies of the plan by their names, beside the pieces that are still selected.
void Workbench::selectAgain(const std::vector<std::string>& names) {
    const std::set<std::string> wanted(names.begin(), names.end());
    std::vector<BodyId> bodies = selection_;
    for (const BodyId body : document_.world().bodies())
        if (const std::string id = document_.idOf(body); !id.empty() && wanted.contains(id))
            bodies.push_back(body);
    setSelection(std::move(bodies));
}

// --- selection -------------------------------------------------------------------------------

bool Workbench::selected(BodyId body) const {
    return std::binary_search(selection_.begin(), selection_.end(), body);
}

void Workbench::select(std::vector<BodyId> bodies) {
    selectedMeters_.clear();
    setSelection(std::move(bodies));
}

// Meters that are selected stay so.
void Workbench::setSelection(std::vector<BodyId> bodies) {
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    const auto pins = pinsOf(document_.world());  // these go with what they hold
    std::erase_if(bodies, [&](BodyId body) { return pins.contains(body); });
    selection_ = std::move(bodies);
    chosen_.reset();
    things_.clear();
    forgetRemoved();
    watchSelection();
}

const BodyMarks& Workbench::marks(BodyId body) const {
    return markBook_.of(document_, body);
}

bool Workbench::pickable(BodyId body) const {
    const BodyMarks& own = marks(body);
    // A peg is not seen: what is fitted to it has a mark.
    return !own.locked && !own.hidden && !document_.isPeg(document_.idOf(body));
}

BodyId Workbench::bodyUnder(const Pointer& pointer) const {
    return bodyAt(document_.world(), pointer.position, pointer.reach,
                  {.counts = [this](BodyId body) { return pickable(body); },
                   .order = [this](BodyId body) { return marks(body).order; }});
}

void Workbench::deselectUnpickable() {
    auto kept = selection_;
    std::erase_if(kept, [&](BodyId body) { return !pickable(body); });
    select(std::move(kept));
}

std::vector<BodyId> Workbench::withGroup(BodyId body) const {
    const std::string group = outermost(marks(body).group);
    if (group.empty()) return {body};
    std::vector<BodyId> bodies;
    for (const BodyId other : document_.world().bodies())
        if (outermost(marks(other).group) == group && pickable(other)) bodies.push_back(other);
    return bodies;
}

void Workbench::toggle(BodyId body) {
    auto bodies = selection_;
    if (selected(body))
        std::erase(bodies, body);
    else
        bodies.push_back(body);
    setSelection(std::move(bodies));
}

// Mechanisms are known by their ids, others by their place.
std::optional<FittingRef> Workbench::fitting() const {
    if (!chosen_) return std::nullopt;
    if (chosen_->ref.isPart())
        return document_.hasPart(chosen_->ref) && document_.markOf(chosen_->ref) == chosen_->id
                   ? std::optional(chosen_->ref)
                   : std::nullopt;
    const auto describe = [&](const FittingRef& ref) {
        const Fitting is = document_.fitting(ref);
        const auto* mechanism = std::get_if<sulfur::scene::SceneMechanism>(&is);
        return mechanism == nullptr ? std::string() : mechanism->id;
    };
    const auto all = document_.fittings();
    for (const FittingRef& ref : all)
        if (ref == chosen_->ref && describe(ref) == chosen_->id) return ref;
    if (chosen_->id.empty()) return std::nullopt;
    for (const FittingRef& ref : all)
        if (describe(ref) == chosen_->id) return ref;
    return std::nullopt;
}

void Workbench::chooseFitting(const std::optional<FittingRef>& ref) {
    select({});
    if (!ref) return;
    if (ref->isPart()) {
        chosen_ = Chosen{*ref, document_.markOf(*ref)};
        return;
    }
    const Fitting is = document_.fitting(*ref);
    const auto* mechanism = std::get_if<sulfur::scene::SceneMechanism>(&is);
    chosen_ = Chosen{*ref, mechanism == nullptr ? "" : mechanism->id};
}

// --- measuring -------------------------------------------------------------------------------

void Workbench::measure(std::vector<const Quantity*> quantities) {
    measured_ = std::move(quantities);
    watchSelection(true);
}

void Workbench::watchSelection(bool plotting) {
    if (measured_.empty() && measurements_.series().empty() && !trailing_ && !plotting) return;
    const World& world = document_.world();
    std::vector<Measurements::Subject> subjects;
    for (const BodyId body : selection_) {
        const std::string id = document_.idOf(body);
        subjects.push_back({body, world.userData(body),
                            id.empty() ? tr("a piece of {}", {world.name(body)}) : id});
    }
    for (const std::string& id : selectedMeters_)
        subjects.push_back({BodyId{}, 0, id, id, meters_.record(id)});
    // What was measured goes on to be, as long as it is there.
    if (subjects.empty())
        for (auto& subject : subjects_) {
            if (!subject.meter.empty()) subject.record = meters_.record(subject.meter);
            if (!subject.record.empty() || (subject.body && world.contains(subject.body) &&
                                            world.userData(subject.body) == subject.userData))
                subjects.push_back(subject);
        }
    if (subjects.empty()) subjects.push_back({BodyId{}, 0, "the scene"});
    subjects_ = std::move(subjects);
    measurements_.watch(subjects_, measured_);
    if (!trailing_) return;
    const std::array<const Quantity*, 2> place{quantity("x"), quantity("height")};
    trails_.watch(subjects_, place);
}

void Workbench::clearMeasurements() {
    measurements_.clear();
    meters_.clear();
    trails_.clear();
}

void Workbench::setTrails(bool on) {
    trailing_ = on;
    if (on)
        watchSelection();
    else
        trails_.watch({}, {});
}

void Workbench::selectAll() {
    std::vector<BodyId> all;
    for (const BodyId body : document_.world().bodies())
        if (pickable(body)) all.push_back(body);
    select(std::move(all));
}

void Workbench::selectThings(std::vector<LevelThing> things) {
    std::sort(things.begin(), things.end());
    select({});
    things_ = std::move(things);
    forgetRemoved();
}

void Workbench::deleteThings() {
    if (std::none_of(things_.begin(), things_.end(), isRemovable))
        throw std::runtime_error("a level always has its spawn, its exit and its bounds");
    tool_->cancel();
    const auto gone = std::exchange(things_, {});
    document_.edit("Delete", [&] { removeThings(document_, gone); });
}

void Workbench::deleteSelection() {
    if (const auto ref = fitting()) {
        tool_->cancel();
        chosen_.reset();
        document_.edit("Delete", [&] { document_.unfit(*ref); });
        return;
    }
    if (!things_.empty()) deleteThings();
    if (selection_.empty() && selectedMeters_.empty()) return;
    tool_->cancel();
    const auto gone = std::exchange(selection_, {});
    const auto meters = std::exchange(selectedMeters_, {});
    document_.edit("Delete", [&] {
        document_.remove(gone);
        if (!meters.empty()) removeMeters(document_.planForEditing(), meters);
    });
}

void Workbench::setStageTimes(bool on) {
    if (on != timing_) stageTimes_.clear();
    timing_ = on;
    document_.world().setProfiling(on);
}

bool Workbench::meterSelected(const std::string& id) const {
    return std::find(selectedMeters_.begin(), selectedMeters_.end(), id) != selectedMeters_.end();
}

void Workbench::selectMeters(std::vector<std::string> ids, bool too) {
    if (!too) setSelection({});
    selectedMeters_ = std::move(ids);
    forgetRemoved();
    watchSelection();
}

void Workbench::nudge(const Point& by) {
    if (!anythingSelected()) return;
    tool_->cancel();
    document_.edit("Nudge", [&] {
        document_.translate(selection_, by);
        for (const LevelThing& thing : things_) moveThing(document_, thing, by);
    });
}

void Workbench::turn(double radians) {
    const auto bounds = selectionBounds(*this);
    if (!bounds) return;
    tool_->cancel();
    document_.edit("Turn", [&] { turnSelection(*this, bounds->centre(), radians); });
}

void Workbench::scale(double factor) {
    const auto bounds = selectionBounds(*this);
    if (!bounds) return;
    tool_->cancel();
    document_.edit("Scale", [&] { scaleSelection(*this, bounds->centre(), factor); });
}

void Workbench::mirror() {
    const auto bounds = selectionBounds(*this);
    if (!bounds) return;
    tool_->cancel();
    document_.edit("Mirror", [&] { mirrorSelection(*this, bounds->centre()); });
}

void Workbench::followHandles(const std::function<BodyId(BodyId)>& now) {
    std::vector<BodyId> kept;
    for (const BodyId body : selection_)
        if (const BodyId is = now(body))
            kept.push_back(is);
        else if (document_.world().contains(body) && document_.idOf(body).empty())
            kept.push_back(body);
    // These have no handles: they stay.
    auto chosen = std::move(chosen_);
    auto things = std::move(things_);
    setSelection(std::move(kept));
    chosen_ = std::move(chosen);
    things_ = std::move(things);
}

}  // namespace sulfurchamber
