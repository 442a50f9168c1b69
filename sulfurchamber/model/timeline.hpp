// The recorded past of a running world, with the other futures that it had.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <sulfur/world.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "mark.hpp"

namespace sulfurchamber {

/// A force on a particle during one tick, newtons. It wakes the body.
struct Push {
    sulfur::ParticleId particle;
    sulfur::Vec2 force{0, 0};
};

/// A force during one tick that is fixed to the frame of a body. It wakes the body.
struct Thrust {
    sulfur::BodyId body;
    sulfur::Vec2 at{0, 0};     ///< metres, in the frame
    sulfur::Vec2 force{0, 0};  ///< newtons, in the frame
};
/// For the next tick. Nothing happens to a body that is gone.
void apply(sulfur::World& world, const Thrust& thrust);

/// What drives a mechanism from a tick on.
struct DriveChange {
    sulfur::MechanismId mechanism;
    sulfur::Drive drive;
};

/// A body that comes into the world as a part of a tick.
struct Arrival {
    std::shared_ptr<const sulfur::Blueprint> blueprint;
    sulfur::Pose pose;
    std::uint64_t userData = 0;
};

/// A tick of the line that ends with `branch`: its own ticks and, before they begin, those of the
/// branches that it came from.
struct Moment {
    std::uint32_t branch = 0;
    std::uint64_t tick = 0;
    bool operator==(const Moment&) const = default;
};

struct TimelineLimits {
    /// Of memory, all branches together. With the pictures of the time bar it is 64 MiB.
    std::size_t bytes = std::size_t{60} << 20;
    double assured = 60;    ///< seconds that fit into it, as far as one can choose
    double longest = 120;   ///< seconds of the line that is shown
    double interval = 0.1;  ///< seconds between two keys at least
};

/// Keeps snapshots of a world every so often ("keys") and what acted on it in between, so that it
/// can go back to any tick, to the bit: from a key it is simulated again.
///
/// Keys are kept as what differs from the first of eight, compressed. For 2,000 particles that all
/// move a snapshot has 1.8 MB and a key 0.4 MB; a key each 0.4 s then fills the 60 MiB in 60 s.
/// How often there is one follows from how large they are. When there is no room, the oldest of
/// other branches goes first, then the oldest of the line that is shown.
///
/// Whoever goes on from an earlier moment starts a branch; what was the future stays. The world is
/// the caller's and is handed to each function. One thread.
class Timeline {
public:
    explicit Timeline(const TimelineLimits& limits = {});
    ~Timeline();
    Timeline(const Timeline&) = delete;
    Timeline& operator=(const Timeline&) = delete;

    // -- recording --

    /// Forgets all.
    void clear();
    /// Before anything acts on the world as a part of a tick, and before each tick: where the world
    /// is not at the end of what was recorded, a branch begins.
    void prepare(const sulfur::World& world);
    /// These act in the next tick. After prepare().
    void note(const Push& push);
    void note(const Arrival& arrival);
    void note(const Thrust& thrust);
    void note(const DriveChange& change);
    /// After each tick.
    void ticked(const sulfur::World& world);
    /// An edit has changed the world. The moment shows it changed, and what came later is another
    /// branch.
    void changed(const sulfur::World& world);
    /// Marks an edit at the present moment.
    void mark(const std::string& label);

    // -- where the world is --

    /// What is needed to come back to a place by other means, such as a snapshot of one's own.
    struct Place {
        std::optional<Moment> moment;
        bool exact = false;
        std::uint64_t serial = 0;
    };
    Place place() const { return {now_, exact_, serial_}; }
    /// The world was brought back to what it was when place() gave this. Where that moment is no
    /// longer recorded, as leave().
    void comeBack(const Place& place);
    /// The world is stamped anew: it is at no recorded moment.
    void leave();
    /// The present moment; none before time has passed.
    const std::optional<Moment>& now() const { return now_; }

    // -- going --

    /// Brings the world to a moment, or to the nearest that is still recorded. It stops on the way,
    /// at an earlier tick, once `milliseconds` are spent on simulating. Returns where it is: then
    /// ask again. Precondition: something is recorded.
    Moment go(sulfur::World& world, const Moment& wanted, double milliseconds);

    /// Brings another world, which nobody else moves, to a moment, and leaves this one's where it
    /// is. It stops on the way as go() does; then ask again. Whether it is there. Throws
    /// std::runtime_error where the moment is no longer recorded.
    bool replay(sulfur::World& other, const Moment& wanted, double milliseconds);

    // -- what there is --

    bool empty() const { return branches_.empty(); }
    /// The branch with which the shown line ends; 0 when there is none.
    std::uint32_t line() const { return line_; }
    /// The same moment, told by the branch whose own tick it is. Precondition: there is the branch.
    Moment own(const Moment& moment) const { return {owner(moment), moment.tick}; }
    /// Whether a branch, with ticks of its own, still has this moment.
    bool owns(const Moment& moment) const;
    /// First and last recorded tick of a line.
    std::uint64_t first(std::uint32_t line) const;
    std::uint64_t last(std::uint32_t line) const;
    /// Marks of a line in the order of time.
    std::vector<Mark> marks(std::uint32_t line) const;
    /// Whether the line of a moment was edited between that and another tick.
    bool edited(const Moment& moment, std::uint64_t other) const;
    /// A future that is not on the shown line: its own recorded ticks, from where it parted.
    struct Other {
        std::uint32_t branch = 0;
        std::uint64_t from = 0;
        std::uint64_t last = 0;
    };
    std::vector<Other> others() const;
    /// Memory that all of it takes.
    std::size_t bytes() const;
    /// Snapshots that are kept.
    std::size_t keys() const;

private:
    struct Key;
    struct Branch;
    struct Seen;

    Branch& at(std::uint32_t id);
    const Branch& at(std::uint32_t id) const;
    std::vector<std::uint32_t> pathTo(std::uint32_t line) const;
    std::uint32_t owner(const Moment& moment) const;
    void startBranch(const sulfur::World& world);
    void addKey(Branch& branch, const sulfur::World& world);
    void scheduleKey(const Branch& branch, const sulfur::World& world);
    const Key& keyBefore(const Branch& branch, std::uint64_t tick) const;
    sulfur::Snapshot unpack(const Branch& branch, const Key& key);
    void simulate(sulfur::World& world, const Branch& branch, std::uint64_t to,
                  double milliseconds) const;
    void noteEvents(const sulfur::World& world);
    void addMark(Branch& branch, Mark mark, std::uint64_t near);
    void dropUnstepped();
    void trim(const sulfur::World& world);
    bool dropOldestOther();
    bool dropOldestOfLine();
    void dropFront(std::uint32_t id);
    void cut(Branch& branch);
    void recallSeen();

    TimelineLimits limits_;
    std::map<std::uint32_t, Branch> branches_;
    std::uint32_t lastId_ = 0;
    std::uint32_t line_ = 0;
    std::optional<Moment> now_;
    bool exact_ = false;  ///< whether the world is what is recorded of now_
    std::uint64_t serial_ = 0;
    std::uint64_t uses_ = 0;
    std::uint64_t nextKey_ = 0;                                 ///< tick
    std::set<std::pair<sulfur::BodyId, sulfur::BodyId>> seen_;  ///< who has touched on the line
    std::size_t packed_ = 0;                                    ///< bytes of all keys
    std::uint64_t keySerial_ = 0;
    // The first key of the group that grows, and of the one that was read last, as they are.
    struct Unpacked {
        std::uint64_t serial = 0;
        sulfur::Snapshot bytes;
    };
    Unpacked growing_;
    Unpacked read_;
};

}  // namespace sulfurchamber
