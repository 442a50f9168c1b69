// Selects and drags: bodies are put elsewhere while time stands still, and pulled by a spring
// while it runs. Handles of the selection stretch, scale and turn it at any time.
#include <algorithm>
#include <cmath>

#include "fitting_marks.hpp"
#include "geometry.hpp"
#include "level_hand.hpp"
#include "meter_grip.hpp"
#include "tool.hpp"
#include "transform.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

constexpr double turnCatch = 0.05;          // radians about a step that count as the step
constexpr std::size_t mostOwnPlaces = 200;  // of what is moved, that snap to others

class SelectTool final : public Tool {
public:
    explicit SelectTool(Workbench& bench) : Tool(bench), level_(bench) {}

    void press(const Pointer& pointer) override {
        cancel();
        from_ = to_ = pointer.position;
        if (level_.press(pointer)) return;
        if (pressHandle(pointer)) return;
        // While time runs what moves is caught, not the meters on it.
        if (!document().playing() && (meter_ = MeterGrip::take(bench(), pointer))) return;
        const BodyId body = bench().bodyUnder(pointer);
        // Marks lie on bodies. While time runs these are what one wants to pull.
        if (!body || !document().playing()) {
            auto ref = partUnder(pointer, body);
            if (!ref) ref = fittingAt(document(), pointer.position, pointer.reach);
            if (!ref && !body) ref = partAt(document(), {}, pointer.position, pointer.reach);
            if (ref) {
                bench().chooseFitting(ref);
                const bool isJoint = ref->isPart() && ref->kind != FittingRef::Kind::particle;
                if (!document().playing() && !isJoint) doing_ = Doing::fitting;
                return;
            }
        }
        const bool additive = pointer.shift || pointer.control;
        if (!body) {
            additive_ = additive;
            doing_ = Doing::band;
            return;
        }
        const bool single = pointer.alt || pointer.clicks > 1;
        clicked_ = single ? std::vector<BodyId>{body} : bench().withGroup(body);
        if (additive) {
            toggle(clicked_);
            return;
        }
        if (!bench().selected(body) || pointer.clicks > 1) bench().select(clicked_);
        copies_ = pointer.alt;
        if (document().playing()) {
            grip_ = Grip::take(world(), pointer.position, pointer.reach,
                               [this](BodyId one) { return bench().pickable(one); });
            if (grip_) doing_ = Doing::pull;
        } else {
            doing_ = Doing::move;
        }
    }

    void move(const Pointer& pointer) override {
        level_.move(pointer);
        if (meter_) meter_->moveTo(bench(), pointer);
        to_ = pointer.position;
        if (doing_ == Doing::pull) grip_->moveTo(to_);
        if (doing_ == Doing::move) moveSelection(pointer);
        if (doing_ == Doing::turn) turnTo(pointer);
        if (doing_ == Doing::stretch) stretchTo(pointer);
    }

    void release(const Pointer& pointer) override {
        level_.release();
        if (meter_) {
            meter_->moveTo(bench(), pointer);
            meter_->release(bench());
            meter_.reset();
        }
        if (doing_ == Doing::idle) return;
        move(pointer);
        const Doing done = doing_;
        doing_ = Doing::idle;
        if (done == Doing::band) selectBand();
        if (done == Doing::fitting) moveChosen(pointer);
        if (done == Doing::stretch && stretch_.factors != Point(1, 1))
            document().edit(stretch_.isUniform() ? "Scale" : "Stretch",
                            [&] { stretchSelection(bench(), stretch_); });
        if (done == Doing::turn && !moved_ && turned_ != 0)
            document().edit("Turn", [&] { turnSelection(bench(), frameNow().middle, turned_); });
        // A click without a drag means this one of several.
        const bool clicked = done == Doing::move && !moved_;
        if (moved_) document().commit();
        if (clicked) bench().select(clicked_);
        toIdle();
    }

    void cancel() override {
        level_.cancel();
        if (meter_) meter_->cancel(bench());
        meter_.reset();
        if (moved_) document().rollback();
        toIdle();
    }

    void tick() override {
        if (doing_ == Doing::stretch) stretch_ = stretchNow();  // what falls takes its frame along
        if (doing_ != Doing::pull) return;
        for (const Push& push : grip_->pushes(world())) document().push(push);
        if (!grip_->holds(world())) toIdle();
    }

    Preview preview() const override {
        switch (doing_) {
            case Doing::band:
                return {Preview::Kind::band, from_, to_, 0};
            case Doing::pull:
                if (!grip_->holds(world())) return {};
                return {Preview::Kind::spring, grip_->anchor(world()), grip_->target(), 0};
            case Doing::stretch:
                return stretchPreview();
            case Doing::turn:
                return turnPreview();
            case Doing::move:
                return movePreview();
            case Doing::fitting:
                if ((to_ - from_).norm() == 0) return {};
                return {Preview::Kind::arrow, from_, to_, 0};
            case Doing::idle:
                break;
        }
        return {};
    }

    bool showsFrame() const override { return doing_ == Doing::stretch || doing_ == Doing::turn; }

    std::string hint() const override {
        if (level_.holds()) return level_.hint();
        switch (doing_) {
            case Doing::pull:
                return "Pulling with a spring: let go to release";
            case Doing::move:
                return copies_ && moved_ ? "Moving a copy: Escape takes it back"
                                         : "Moving the selection: Escape puts it back";
            case Doing::fitting:
                return "Release where it is to be; Escape leaves it where it is";
            case Doing::band:
                return "Release to select what lies wholly in the frame";
            case Doing::turn:
                return tr("Turning by {}, with Shift in steps of 15 degrees; Escape takes it back",
                          {degreesText(turned_)});
            case Doing::stretch:
                return stretchHint();
            case Doing::idle:
                break;
        }
        return idleHint();
    }

private:
    enum class Doing { idle, band, move, pull, turn, stretch, fitting };

    std::string idleHint() const {
        std::string hint =
            document().playing()
                ? "Drag a body to pull it with a spring, or drag a frame to select"
                : "Click to select, drag to move, with Alt a copy; handles turn and scale";
        if (const auto ref = bench().fitting(); ref && ref->isPart())
            return ref->kind == FittingRef::Kind::particle
                       ? "Drag the particle to move it; Delete takes it away with its joints"
                       : "Page Object has the numbers of the joint; Delete takes it away";
        if (!document().playing() && bench().selection().size() == 1)
            hint = "Drag to move, with Alt a copy; a double click takes a particle or joint alone";
        if (const std::size_t hidden = hiddenCount(document()); hidden > 0)
            hint = trCount("{} body is hidden and still simulated",
                           "{} bodies are hidden and still simulated", hidden) +
                   "; " + tr(hint);
        return hint;
    }

    // A second click on a body takes it out of its group, or else a single part of it, and what is
    // chosen so can be dragged.
    std::optional<FittingRef> partUnder(const Pointer& pointer, BodyId body) const {
        const auto chosen = bench().fitting();
        if (chosen && !chosen->isPart()) return std::nullopt;  // a mark lies on it
        if (!body || (pointer.clicks < 2 && !(chosen && chosen->isPart()))) return std::nullopt;
        const auto part = partAt(document(), body, pointer.position, pointer.reach);
        if (part && part == chosen) return part;
        const bool alone = bench().withGroup(body).size() == 1 ||
                           bench().selection() == std::vector<BodyId>{body};
        return pointer.clicks > 1 && alone ? part : std::nullopt;
    }

    // Less than the reach is a click.
    void moveChosen(const Pointer& pointer) {
        const auto ref = bench().fitting();
        const Point by = to_ - from_;
        if (!ref || by.norm() <= pointer.reach) return;
        document().edit("Move", [&] { moveFitting(document(), *ref, from_, by); });
    }

    std::string stretchHint() const {
        const auto percent = [](double factor) {
            return std::to_string(std::lround(factor * 100)) + " %";
        };
        const Point& f = stretch_.factors;
        if (stretch_.isUniform())
            return tr(
                "Scaling to {}, mass with the area; with Ctrl the middle stays; Escape takes it "
                "back",
                {percent(f.x())});
        return tr("Stretching to {}; with Ctrl the middle stays; Escape takes it back",
                  {percent(f.x() != 1 ? f.x() : f.y())});
    }

    void toggle(const std::vector<BodyId>& bodies) {
        const bool all = std::all_of(bodies.begin(), bodies.end(),
                                     [&](BodyId body) { return bench().selected(body); });
        auto chosen = bench().selection();
        if (all)
            std::erase_if(chosen, [&](BodyId body) {
                return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
            });
        else
            chosen.insert(chosen.end(), bodies.begin(), bodies.end());
        bench().select(std::move(chosen));
    }

    // --- handles ---

    Frame frameNow() const { return selectionFrame(bench()).value_or(Frame{}); }

    bool pressHandle(const Pointer& pointer) {
        const auto frame = selectionFrame(bench());
        if (!frame) return false;
        for (const Handle& handle : handlesOf(*frame, pointer.reach)) {
            if ((handle.at - pointer.position).norm() > pointer.reach) continue;
            handle_ = handle;
            about_ = frame->middle;
            turned_ = 0;
            stretch_ = {};
            way_ = {0, 0};
            freely_ = canStretch(bench());
            doing_ = handle.kind == Handle::Kind::turn ? Doing::turn : Doing::stretch;
            return true;
        }
        return false;
    }

    Stretch stretchNow() const {
        return stretchBy(frameNow(), handle_, way_, freely_, aboutMiddle_);
    }

    // What is dragged is the corner or side itself: the handle stands a little outside of it.
    void stretchTo(const Pointer& pointer) {
        aboutMiddle_ = pointer.control;
        way_ = pointer.position - from_;
        const Point dragged = frameNow().at(handle_.x, handle_.y);
        const Snapped snapped = snapPoint(
            world(), dragged + way_, pointer.reach, bench().snapping(), {},
            [this](BodyId body) { return !bench().selected(body) && !bench().marks(body).hidden; });
        bench().showSnap(snapped.place);
        way_ = snapped.point - dragged;
        stretch_ = stretchNow();
    }

    void turnTo(const Pointer& pointer) {
        const Point before = from_ - about_;
        const Point now = pointer.position - about_;
        double angle = std::atan2(sulfur::cross(before, now), before.dot(now));
        const double begun = handleAngle();
        if (pointer.shift)
            angle = std::round(angle / snapAngleStep) * snapAngleStep;
        else if (bench().snapping().angles)
            angle = snapAngle(begun + angle, turnCatch) - begun;
        if (angle == turned_) return;
        if (!document().playing()) {
            if (!moved_) document().begin("Turn");
            moved_ = true;
            turnSelection(bench(), about_, angle - turned_);
        }
        turned_ = angle;
    }

    // Of the frame when it was taken, so that steps are those of the world.
    double handleAngle() const { return std::atan2(-(from_ - about_).x(), (from_ - about_).y()); }

    Preview framePreview(const Frame& frame) const {
        Preview shown{Preview::Kind::frame, frame.middle, frame.middle, 0};
        for (const Point& corner : frame.corners()) shown.points.push_back(corner);
        return shown;
    }

    Preview stretchPreview() const {
        const Frame frame = stretched(frameNow(), stretch_);
        Preview shown = framePreview(frame);
        shown.labels = sizeLabels(frame.corners(), massAfter(bench(), stretch_));
        return shown;
    }

    Preview turnPreview() const {
        Frame frame = frameNow();
        if (!moved_) frame.angle += turned_;
        Preview shown = framePreview(frame);
        shown.labels = {{about_, degreesText(turned_)}};
        return shown;
    }

    // --- moving ---

    void moveSelection(const Pointer& pointer) {
        const Point by = pointer.position - from_;
        if (!moved_) {
            if (by.norm() == 0) return;
            beginMove();
        }
        const Snapped snapped = snapMove(own_, others_, by, pointer.reach, bench().snapping());
        bench().showSnap(snapped.place);
        if (snapped.point == way_) return;
        document().translate(bench().selection(), snapped.point - way_);
        way_ = snapped.point;
    }

    void beginMove() {
        document().begin(copies_ ? "Copy" : "Move");
        moved_ = true;
        way_ = {0, 0};
        if (copies_) bench().insertCopy();
        gatherPlaces();
    }

    void gatherPlaces() {
        own_.clear();
        others_.clear();
        const SnapOptions& options = bench().snapping();
        const auto bounds = selectionBounds(bench());
        if (!bounds) return;
        if (options.grid > 0) own_.push_back({bounds->low, SnapPlace::Kind::grid});
        if (!options.corners && !options.centres) return;
        for (const BodyId body : world().bodies()) {
            const bool mine = bench().selected(body);
            if (bench().marks(body).hidden || (mine && own_.size() > mostOwnPlaces)) continue;
            const auto places = snapPlaces(world(), body, options);
            auto& into = mine ? own_ : others_;
            into.insert(into.end(), places.begin(), places.end());
        }
    }

    Preview movePreview() const {
        if (!moved_) return {};
        Preview shown;
        const auto bounds = selectionBounds(bench());
        if (!bounds) return shown;
        shown.labels = {{{bounds->centre().x(), bounds->high.y()},
                         tr("{} right, {} up", {metresText(way_.x()), metresText(way_.y())})}};
        return shown;
    }

    void selectBand() {
        std::vector<BodyId> found;
        for (const BodyId body : bodiesIn(world(), from_, to_)) {
            if (!bench().pickable(body)) continue;
            const auto whole = bench().withGroup(body);
            found.insert(found.end(), whole.begin(), whole.end());
        }
        if (additive_)
            found.insert(found.end(), bench().selection().begin(), bench().selection().end());
        bench().select(std::move(found));
    }

    void toIdle() {
        doing_ = Doing::idle;
        moved_ = false;
        grip_.reset();
    }

    LevelHand level_;
    Doing doing_ = Doing::idle;
    bool additive_ = false;
    bool copies_ = false;
    bool moved_ = false;  // a step of the history is open
    std::vector<BodyId> clicked_;
    Point from_{0, 0};
    Point to_{0, 0};
    Point way_{0, 0};  // of what moves, or of the handle, so far
    Handle handle_;
    Stretch stretch_;
    Point about_{0, 0};
    bool freely_ = false;
    bool aboutMiddle_ = false;
    double turned_ = 0;  // radians so far
    std::vector<SnapPlace> own_;
    std::vector<SnapPlace> others_;
    std::optional<Grip> grip_;
    std::optional<MeterGrip> meter_;
};

}  // namespace

std::unique_ptr<Tool> makeSelectTool(Workbench& bench) {
    return std::make_unique<SelectTool>(bench);
}

}  // namespace sulfurchamber
