// Steps of a document, undone and done again.
#include <cstring>

#include "document.hpp"
#include "document_steps.hpp"

namespace sulfurchamber {
namespace {

std::string bytesOf(const sulfur::Snapshot& snapshot) {
    return {reinterpret_cast<const char*>(snapshot.data()), snapshot.size()};
}

sulfur::Snapshot snapshotOf(const std::string& bytes) {
    sulfur::Snapshot snapshot(bytes.size());
    std::memcpy(snapshot.data(), bytes.data(), bytes.size());
    return snapshot;
}

}  // namespace

Document::Side Document::side() {
    Side side;
    side.constants = constants_;
    side.state = state_;
    side.moved = moved_;
    side.place = timeline_.place();
    if (moved_) side.moment = shelf_.put(bytesOf(world_->snapshot()));
    return side;
}

// The plan must be that of the side already.
void Document::restore(const Side& side) {
    constants_ = side.constants;
    state_ = side.state;
    if (!side.moved) {
        stamp();
        return;
    }
    const auto snapshot = snapshotOf(side.moment.read());
    takeOver([&] {
        world_->restore(snapshot);
        moved_ = true;
        touched_ = false;
        timeline_.comeBack(side.place);
    });
}

void Document::edit(const std::string& label, const std::function<void()>& change) {
    begin(label);
    try {
        change();
    } catch (...) {
        rollback();
        throw;
    }
    commit();
}

void Document::begin(const std::string& label) {
    commit();
    open_ = std::make_unique<Step>();
    open_->label = label;
    open_->other = side();
    touchedInStep_ = false;
    state_ = ++lastState_;
    ++revision_;
}

void Document::commit() {
    if (!open_) return;
    std::string text = sulfur::scene::format(plan_.scene());
    const bool sameText = text == text_;
    const bool sameWorld = !open_->other.moved && !moved_;
    if (sameText && sameWorld && constants_ == open_->other.constants) {
        state_ = open_->other.state;
        open_.reset();
        return;
    }
    try {
        // What is saved and opened again is what was built: the plan is always one that was read.
        if (!sameText) plan_ = Plan(sulfur::scene::parse(text, planName));
        if (sameWorld) stamp();
    } catch (...) {
        rollback();
        throw;
    }
    open_->change = shelf_.put(TextChange::between(text_, text).bytes());
    text_ = std::move(text);
    if (moved_ && touched_) timeline_.changed(*world_);
    touched_ = false;
    if (moved_ && touchedInStep_) timeline_.mark(open_->label);
    undo_.push_back(std::move(*open_));
    open_.reset();
    redo_.clear();
    ++revision_;
}

void Document::rollback() {
    if (!open_) return;
    const auto step = std::move(open_);
    plan_ = Plan(sulfur::scene::parse(text_, planName));
    restore(step->other);
}

// Takes the last step of a list back, or does it again, and puts it to the other list.
void Document::go(std::vector<Step>& from, std::vector<Step>& to, bool back) {
    commit();
    if (from.empty()) return;
    const auto change = TextChange::fromBytes(from.back().change.read());
    std::string text = back ? change.revert(text_) : change.apply(text_);
    Step step = std::move(from.back());
    from.pop_back();
    plan_ = Plan(sulfur::scene::parse(text, planName));
    text_ = std::move(text);
    Side now = side();
    restore(step.other);
    step.other = std::move(now);
    playing_ = false;
    to.push_back(std::move(step));
}

void Document::undo() {
    go(undo_, redo_, true);
}

void Document::redo() {
    go(redo_, undo_, false);
}

std::string Document::undoLabel() const {
    if (open_) return open_->label;
    return undo_.empty() ? "" : undo_.back().label;
}

std::string Document::redoLabel() const {
    return redo_.empty() || open_ ? "" : redo_.back().label;
}

std::size_t Document::historyPlace() const {
    return undo_.size() + (open_ ? 1 : 0);
}

std::vector<std::string> Document::history() const {
    std::vector<std::string> labels;
    for (const Step& step : undo_) labels.push_back(step.label);
    if (open_) labels.push_back(open_->label);
    for (auto step = redo_.rbegin(); step != redo_.rend(); ++step) labels.push_back(step->label);
    return labels;
}

}  // namespace sulfurchamber
