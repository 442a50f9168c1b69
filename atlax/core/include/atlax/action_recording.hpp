#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <atlax/actions.hpp>

namespace atlax {

/// The actions of consecutive ticks, for replays: what was appended comes back bit by bit. Only
/// what changes is stored: a key that is held for an hour takes no more than one that is tapped.
///
/// A plain value that owns its bytes. Different objects may be used in different threads. Errors
/// are atlax::Error.
class ActionRecording {
public:
    /// The state of the next tick.
    void append(const ActionState& state);
    std::uint64_t ticks() const { return ticks_; }

    /// The recording as bytes, the same on every machine; compress() makes them smaller.
    std::vector<std::byte> encode() const;
    /// The opposite. Throws Error, naming the place, for anything that encode() does not make or
    /// that has more than `maxTicks` ticks.
    static ActionRecording decode(std::span<const std::byte> bytes, std::uint64_t maxTicks);

private:
    friend class ActionPlayback;

    std::vector<std::byte> changes_;
    std::uint64_t ticks_ = 0;
    std::uint64_t lastChange_ = 0;
    ActionState last_;
};

/// Plays a recording tick by tick. Refers to the recording, which must live on and not change.
class ActionPlayback {
public:
    explicit ActionPlayback(const ActionRecording& recording);

    bool done() const { return tick_ >= recording_->ticks(); }
    /// The state of the next tick; after the end one in which nothing happens. The reference holds
    /// until the next call.
    const ActionState& next();

private:
    void readChange();
    void announceNext();

    const ActionRecording* recording_;
    std::size_t at_ = 0;
    std::uint64_t tick_ = 0;
    std::uint64_t nextChange_ = 0;
    ActionState state_;
};

}  // namespace atlax
