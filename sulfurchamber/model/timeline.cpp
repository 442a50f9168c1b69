// Recording, keys and going; what is forgotten is in timeline_forgetting.cpp.
#include "timeline.hpp"

#include <algorithm>
#include <atlax/compression.hpp>
#include <chrono>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "timeline_record.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Snapshot;
using sulfur::World;

constexpr std::size_t keysOfGroup = 8;
constexpr double markEvery = 0.1;           // seconds of one mark
constexpr double roomForKeys = 0.9;         // of the bytes; the rest is for groups that end late
constexpr double secondsPerMebibyte = 0.2;  // of snapshots: keys cost less than a tenth of the time
constexpr std::size_t mostSeen = 100'000;

// What differs, as bytes that are zero where nothing does. Its own inverse.
void exclusiveOr(Snapshot& bytes, const Snapshot& other) {
    const std::size_t common = std::min(bytes.size(), other.size());
    for (std::size_t i = 0; i < common; ++i) bytes[i] ^= other[i];
}

double milliseconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

void act(World& world, const Push& push) {
    world.wake(world.info(push.particle).body);
    world.applyForce(push.particle, push.force);
}
void act(World& world, const Arrival& arrival) {
    const auto body = world.add(*arrival.blueprint, arrival.pose);
    world.setUserData(body.id(), arrival.userData);
}
void act(World& world, const Thrust& thrust) {
    apply(world, thrust);
}
void act(World& world, const DriveChange& change) {
    if (world.contains(change.mechanism)) world.setDrive(change.mechanism, change.drive);
}

}  // namespace

void apply(World& world, const Thrust& thrust) {
    if (!world.contains(thrust.body)) return;
    world.applyForce(thrust.body, world.vectorToWorld(thrust.body, thrust.force),
                     world.toWorld(thrust.body, thrust.at.cast<double>()));
}

Timeline::Timeline(const TimelineLimits& limits) : limits_(limits) {}
Timeline::~Timeline() = default;

Timeline::Branch& Timeline::at(std::uint32_t id) {
    return branches_.at(id);
}
const Timeline::Branch& Timeline::at(std::uint32_t id) const {
    return branches_.at(id);
}

// --- recording -------------------------------------------------------------------------------

void Timeline::clear() {
    branches_.clear();
    line_ = 0;
    now_.reset();
    exact_ = false;
    ++serial_;
    seen_.clear();
    packed_ = 0;
    growing_ = {};
    read_ = {};
}

void Timeline::prepare(const World& world) {
    if (now_ && exact_ && now_->tick == at(line_).last) return;
    startBranch(world);
}

void Timeline::startBranch(const World& world) {
    const std::uint32_t parent = now_ ? owner(*now_) : 0;
    const std::uint32_t id = ++lastId_;
    Branch& branch = branches_[id];
    branch.parent = parent;
    branch.begin = branch.last = world.ticks();
    line_ = id;
    now_ = Moment{id, world.ticks()};
    exact_ = true;
    ++serial_;
    addKey(branch, world);
    recallSeen();
    trim(world);
}

void Timeline::note(const Push& push) {
    at(line_).inputs.push_back({now_->tick, push});
}

void Timeline::note(const Arrival& arrival) {
    at(line_).inputs.push_back({now_->tick, arrival});
}

void Timeline::note(const Thrust& thrust) {
    at(line_).inputs.push_back({now_->tick, thrust});
}

void Timeline::note(const DriveChange& change) {
    at(line_).inputs.push_back({now_->tick, change});
}

void Timeline::ticked(const World& world) {
    Branch& branch = at(line_);
    branch.last = world.ticks();
    now_ = Moment{line_, world.ticks()};
    exact_ = true;
    ++serial_;
    noteEvents(world);
    if (world.ticks() < nextKey_) return;
    addKey(branch, world);
    trim(world);
}

void Timeline::changed(const World& world) {
    if (!now_ || now_->tick != at(line_).last) {
        startBranch(world);
        return;
    }
    Branch& branch = at(line_);
    dropUnstepped();
    ++serial_;
    exact_ = true;
    // The key of this tick, if there is one, shows the world before the edit. It may be what others
    // of its group differ from only if there are others, which are later.
    if (branch.keys.back().tick == world.ticks()) {
        packed_ -= branch.keys.back().packed.size();
        branch.keys.pop_back();
    }
    addKey(branch, world);
    trim(world);
}

void Timeline::mark(const std::string& label) {
    if (!now_) return;
    addMark(at(line_), {now_->tick, Mark::Kind::edit, label, 1}, 0);
}

void Timeline::noteEvents(const World& world) {
    const sulfur::Events& events = world.events();
    Branch& branch = at(line_);
    std::size_t fresh = 0;
    for (const auto& contact : events.contactsBegun) {
        const auto pair = std::minmax(contact.a, contact.b);
        if (seen_.size() >= mostSeen || !seen_.insert(pair).second) continue;
        branch.seen.push_back({world.ticks(), pair});
        ++fresh;
    }
    const std::uint64_t near = ticksOf(world, markEvery);
    if (fresh > 0) addMark(branch, {world.ticks(), Mark::Kind::contact, "", fresh}, near);
    const std::size_t broken = events.jointsBroken.size() + events.mechanismsBroken.size();
    if (broken > 0) addMark(branch, {world.ticks(), Mark::Kind::breakage, "", broken}, near);
}

// Of one kind there is one mark within `near` ticks.
void Timeline::addMark(Branch& branch, Mark mark, std::uint64_t near) {
    for (auto other = branch.marks.rbegin(); other != branch.marks.rend(); ++other) {
        if (other->tick + near < mark.tick) break;
        if (other->kind != mark.kind || other->label != mark.label) continue;
        if (mark.kind != Mark::Kind::edit) other->count += mark.count;
        return;
    }
    branch.marks.push_back(std::move(mark));
}

// Who has touched before the present moment of the line.
void Timeline::recallSeen() {
    seen_.clear();
    std::uint64_t until = now_->tick;
    for (std::uint32_t id = line_; id != 0; id = at(id).parent) {
        for (const Seen& one : at(id).seen)
            if (one.tick <= until) seen_.insert(one.pair);
        until = std::min(until, at(id).begin);
    }
}

// --- keys ------------------------------------------------------------------------------------

void Timeline::addKey(Branch& branch, const World& world) {
    Key key;
    key.tick = world.ticks();
    key.serial = key.base = ++keySerial_;
    Snapshot bytes = world.snapshot();
    key.size = bytes.size();
    std::size_t inGroup = 0;
    for (auto other = branch.keys.rbegin(); other != branch.keys.rend(); ++other)
        if (other->base == growing_.serial) ++inGroup;
    if (inGroup > 0 && inGroup < keysOfGroup) {
        key.base = growing_.serial;
        exclusiveOr(bytes, growing_.bytes);
        key.packed = atlax::compress(bytes, 1);
    } else {
        key.packed = atlax::compress(bytes, 1);
        growing_ = {key.serial, std::move(bytes)};
    }
    key.packed.shrink_to_fit();  // as it grew, it has taken up to twice as much
    packed_ += key.packed.size();
    branch.keys.push_back(std::move(key));
    scheduleKey(branch, world);
}

// So often that the assured time fits into the bytes, and that keys cost little beside ticks.
void Timeline::scheduleKey(const Branch& branch, const World& world) {
    std::size_t sum = 0;
    std::size_t count = 0;
    for (auto key = branch.keys.rbegin(); key != branch.keys.rend() && count < keysOfGroup; ++key) {
        sum += key->packed.size();
        ++count;
    }
    const double mean = static_cast<double>(sum) / static_cast<double>(count);
    const double room = roomForKeys * static_cast<double>(limits_.bytes);
    const double size = static_cast<double>(branch.keys.back().size) / (1 << 20);
    const double seconds =
        std::max({limits_.interval, limits_.assured * mean / room, size * secondsPerMebibyte});
    nextKey_ = world.ticks() + ticksOf(world, seconds);
}

const Timeline::Key& Timeline::keyBefore(const Branch& branch, std::uint64_t tick) const {
    const auto later =
        std::upper_bound(branch.keys.begin(), branch.keys.end(), tick,
                         [](std::uint64_t t, const Key& key) { return t < key.tick; });
    return *std::prev(later);
}

Snapshot Timeline::unpack(const Branch& branch, const Key& key) {
    if (key.base == key.serial) return atlax::decompress(key.packed, key.size);
    if (growing_.serial != key.base && read_.serial != key.base) {
        const auto base = std::find_if(branch.keys.begin(), branch.keys.end(),
                                       [&](const Key& one) { return one.serial == key.base; });
        read_ = {key.base, atlax::decompress(base->packed, base->size)};
    }
    Snapshot bytes = atlax::decompress(key.packed, key.size);
    exclusiveOr(bytes, growing_.serial == key.base ? growing_.bytes : read_.bytes);
    return bytes;
}

// --- going -----------------------------------------------------------------------------------

std::vector<std::uint32_t> Timeline::pathTo(std::uint32_t line) const {
    std::vector<std::uint32_t> path;
    for (std::uint32_t id = line; id != 0; id = at(id).parent) path.push_back(id);
    std::reverse(path.begin(), path.end());
    return path;
}

// The branch whose own tick a moment is.
std::uint32_t Timeline::owner(const Moment& moment) const {
    std::uint32_t id = moment.branch;
    while (moment.tick < at(id).begin && at(id).parent != 0) id = at(id).parent;
    return id;
}

// What was to act in a tick that did not come.
void Timeline::dropUnstepped() {
    if (line_ == 0) return;
    Branch& branch = at(line_);
    while (!branch.inputs.empty() && branch.inputs.back().tick >= branch.last)
        branch.inputs.pop_back();
}

void Timeline::comeBack(const Place& place) {
    dropUnstepped();
    const auto kept = [this](const Moment& one) {
        return branches_.contains(one.branch) && one.tick >= first(one.branch) &&
               one.tick <= last(one.branch);
    };
    if (!place.moment || !kept(*place.moment)) {
        leave();
        return;
    }
    exact_ = place.exact && place.serial == serial_;
    now_ = place.moment;
    line_ = now_->branch;
    at(line_).used = ++uses_;
    ++serial_;
    recallSeen();
}

void Timeline::leave() {
    dropUnstepped();
    now_.reset();
    exact_ = false;
    ++serial_;
}

Moment Timeline::go(World& world, const Moment& wanted, double budget) {
    const double until = milliseconds() + budget;
    dropUnstepped();
    Moment goal = wanted;
    if (!branches_.contains(goal.branch)) goal.branch = line_;
    goal.tick = std::clamp(goal.tick, first(goal.branch), last(goal.branch));
    const std::uint32_t id = owner(goal);
    Branch& branch = at(id);
    const Key& key = keyBefore(branch, goal.tick);
    const bool onTheWay = now_ && exact_ && owner(*now_) == id && now_->tick <= goal.tick &&
                          now_->tick >= key.tick && now_->tick == world.ticks();
    if (!onTheWay) world.restore(unpack(branch, key));
    simulate(world, branch, goal.tick, until - milliseconds());
    line_ = goal.branch;
    now_ = Moment{line_, world.ticks()};
    exact_ = true;
    ++serial_;
    at(line_).used = ++uses_;
    if (now_->tick == at(line_).last) {
        recallSeen();
        scheduleKey(branch, world);
    }
    return *now_;
}

// Where a key lies on the way, an edit may too: it comes from there.
bool Timeline::replay(World& other, const Moment& wanted, double budget) {
    const bool kept = branches_.contains(wanted.branch) && wanted.tick >= first(wanted.branch) &&
                      wanted.tick <= last(wanted.branch);
    if (!kept) throw std::runtime_error("this moment is no longer recorded");
    const Branch& branch = at(owner(wanted));
    const Key& key = keyBefore(branch, wanted.tick);
    if (other.ticks() > wanted.tick || key.tick >= other.ticks())
        other.restore(unpack(branch, key));
    simulate(other, branch, wanted.tick, budget);
    return other.ticks() == wanted.tick;
}

void Timeline::simulate(World& world, const Branch& branch, std::uint64_t to, double budget) const {
    const double until = milliseconds() + budget;
    auto input = std::lower_bound(
        branch.inputs.begin(), branch.inputs.end(), world.ticks(),
        [](const Branch::Input& one, std::uint64_t tick) { return one.tick < tick; });
    while (world.ticks() < to) {
        for (; input != branch.inputs.end() && input->tick == world.ticks(); ++input) {
            std::visit([&](const auto& what) { act(world, what); }, input->what);
        }
        world.step();
        if (milliseconds() > until) return;
    }
}

// --- what there is ---------------------------------------------------------------------------

std::uint64_t Timeline::first(std::uint32_t line) const {
    return line == 0 ? 0 : at(pathTo(line).front()).begin;
}

std::uint64_t Timeline::last(std::uint32_t line) const {
    return line == 0 ? 0 : at(line).last;
}

bool Timeline::owns(const Moment& moment) const {
    const auto branch = branches_.find(moment.branch);
    return branch != branches_.end() && moment.tick >= branch->second.begin &&
           moment.tick <= branch->second.last;
}

std::vector<Mark> Timeline::marks(std::uint32_t line) const {
    std::vector<Mark> marks;
    const auto path = pathTo(line);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const bool ends = i + 1 == path.size();
        for (const Mark& mark : at(path[i]).marks)
            if (ends || mark.tick <= at(path[i + 1]).begin) marks.push_back(mark);
    }
    return marks;
}

bool Timeline::edited(const Moment& moment, std::uint64_t other) const {
    const auto [low, high] = std::minmax(moment.tick, other);
    const auto path = pathTo(moment.branch);
    return std::any_of(path.begin(), path.end(), [&, from = low, to = high](std::uint32_t id) {
        const auto& marks = at(id).marks;
        return std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) {
            return mark.kind == Mark::Kind::edit && mark.tick >= from && mark.tick <= to;
        });
    });
}

std::vector<Timeline::Other> Timeline::others() const {
    const auto path = pathTo(line_);
    std::vector<Other> others;
    for (const auto& [id, branch] : branches_) {
        const auto place = std::find(path.begin(), path.end(), id);
        if (place == path.end()) {
            // One without a tick of its own is only a way to others.
            if (branch.last > branch.begin) others.push_back({id, branch.begin, branch.last});
        } else if (std::next(place) != path.end()) {
            const std::uint64_t parted = at(*std::next(place)).begin;
            if (branch.last > parted) others.push_back({id, parted, branch.last});
        }
    }
    return others;
}

std::size_t Timeline::bytes() const {
    std::size_t sum = packed_ + growing_.bytes.size() + read_.bytes.size();
    for (const auto& [id, branch] : branches_) {
        sum += branch.inputs.capacity() * sizeof(Branch::Input);
        sum += branch.marks.capacity() * sizeof(Mark) + branch.seen.capacity() * sizeof(Seen);
        sum += branch.keys.capacity() * sizeof(Key);
    }
    return sum;
}

std::size_t Timeline::keys() const {
    std::size_t count = 0;
    for (const auto& [id, branch] : branches_) count += branch.keys.size();
    return count;
}

}  // namespace sulfurchamber
