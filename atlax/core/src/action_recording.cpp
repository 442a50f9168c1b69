#include <algorithm>
#include <array>
#include <atlax/action_recording.hpp>
#include <atlax/error.hpp>
#include <string>

namespace atlax {

namespace {

// Bytes: the mark, the number of ticks, then changes. A change is the number of ticks since the
// last one, the number of actions that differ, and for each its number, value, presses and flags;
// number 255 stands for the pointer. Numbers are LEB128.
constexpr std::array mark{std::byte{'A'}, std::byte{'X'}, std::byte{'R'}, std::byte{'1'}};
constexpr std::uint8_t pointer = 255;

void put(std::vector<std::byte>& to, std::uint64_t value) {
    while (value >= 0x80) {
        to.push_back(static_cast<std::byte>(value | 0x80));
        value >>= 7;
    }
    to.push_back(static_cast<std::byte>(value));
}

void putByte(std::vector<std::byte>& to, unsigned value) {
    to.push_back(static_cast<std::byte>(value));
}

class Reader {
public:
    Reader(std::span<const std::byte> bytes, std::size_t at) : bytes_(bytes), at_(at) {}

    std::uint8_t byte() {
        if (at_ >= bytes_.size()) fail("is cut short");
        return std::to_integer<std::uint8_t>(bytes_[at_++]);
    }
    std::uint64_t number() {
        std::uint64_t out = 0;
        for (unsigned shift = 0; shift < 63; shift += 7) {
            const std::uint8_t part = byte();
            out |= std::uint64_t{part & 0x7fu} << shift;
            if (part < 0x80) return out;
        }
        fail("has a number that is too large");
    }
    std::size_t at() const { return at_; }
    bool atEnd() const { return at_ == bytes_.size(); }
    [[noreturn]] void fail(const std::string& what) const {
        throw Error("a recording of actions " + what + " at byte " + std::to_string(at_));
    }

private:
    std::span<const std::byte> bytes_;
    std::size_t at_;
};

unsigned flags(const ActionState& state, std::size_t i) {
    return (state.down[i] ? 1u : 0u) | (state.pressed[i] ? 2u : 0u) | (state.released[i] ? 4u : 0u);
}

bool sameAction(const ActionState& a, const ActionState& b, std::size_t i) {
    return a.values[i] == b.values[i] && a.presses[i] == b.presses[i] && flags(a, i) == flags(b, i);
}

bool samePointer(const ActionState& a, const ActionState& b) {
    return a.pointerX == b.pointerX && a.pointerY == b.pointerY;
}

void putChange(std::vector<std::byte>& to, const ActionState& from, const ActionState& state) {
    unsigned differing = samePointer(from, state) ? 0 : 1;
    for (std::size_t i = 0; i < maxActions; ++i)
        if (!sameAction(from, state, i)) ++differing;
    putByte(to, differing);
    for (std::size_t i = 0; i < maxActions; ++i) {
        if (sameAction(from, state, i)) continue;
        for (const unsigned value : {static_cast<unsigned>(i), unsigned{state.values[i]},
                                     unsigned{state.presses[i]}, flags(state, i)})
            putByte(to, value);
    }
    if (samePointer(from, state)) return;
    putByte(to, pointer);
    for (const std::int16_t part : {state.pointerX, state.pointerY}) {
        const auto bits = static_cast<std::uint16_t>(part);
        putByte(to, bits & 0xffu);
        putByte(to, bits >> 8);
    }
}

std::int16_t readPixel(Reader& in) {
    const unsigned low = in.byte();
    const unsigned high = in.byte();
    return static_cast<std::int16_t>(low | high << 8);
}

void takeChange(Reader& in, ActionState& state) {
    for (unsigned left = in.byte(); left > 0; --left) {
        const std::size_t action = in.byte();
        if (action == pointer) {
            state.pointerX = readPixel(in);
            state.pointerY = readPixel(in);
            continue;
        }
        if (action >= maxActions) in.fail("names an action that cannot exist");
        state.values[action] = in.byte();
        state.presses[action] = in.byte();
        const unsigned bits = in.byte();
        if (bits > 7) in.fail("has unknown flags");
        state.down[action] = (bits & 1) != 0;
        state.pressed[action] = (bits & 2) != 0;
        state.released[action] = (bits & 4) != 0;
    }
}

}  // namespace

void ActionRecording::append(const ActionState& state) {
    if (!(state == last_)) {
        put(changes_, ticks_ - lastChange_);
        putChange(changes_, last_, state);
        lastChange_ = ticks_;
        last_ = state;
    }
    ++ticks_;
}

std::vector<std::byte> ActionRecording::encode() const {
    std::vector<std::byte> out(mark.begin(), mark.end());
    put(out, ticks_);
    out.insert(out.end(), changes_.begin(), changes_.end());
    return out;
}

ActionRecording ActionRecording::decode(std::span<const std::byte> bytes, std::uint64_t maxTicks) {
    if (bytes.size() < mark.size() || !std::equal(mark.begin(), mark.end(), bytes.begin()))
        throw Error("this is no recording of actions");
    Reader in(bytes, mark.size());
    ActionRecording out;
    out.ticks_ = in.number();
    if (out.ticks_ > maxTicks)
        in.fail("has more than the " + std::to_string(maxTicks) + " ticks allowed here");
    const std::size_t begin = in.at();
    for (bool first = true; !in.atEnd(); first = false) {
        const std::uint64_t wait = in.number();
        if (!first && wait == 0) in.fail("changes twice in one tick");
        if (wait >= out.ticks_ - out.lastChange_) in.fail("changes after its end");
        out.lastChange_ += wait;
        takeChange(in, out.last_);
    }
    out.changes_.assign(bytes.begin() + static_cast<std::ptrdiff_t>(begin), bytes.end());
    return out;
}

ActionPlayback::ActionPlayback(const ActionRecording& recording) : recording_(&recording) {
    announceNext();
}

/// When the next change comes; never, after the last one.
void ActionPlayback::announceNext() {
    if (at_ >= recording_->changes_.size()) {
        nextChange_ = recording_->ticks_;
        return;
    }
    Reader in(recording_->changes_, at_);
    nextChange_ += in.number();
    at_ = in.at();
}

void ActionPlayback::readChange() {
    Reader in(recording_->changes_, at_);
    takeChange(in, state_);
    at_ = in.at();
    announceNext();
}

const ActionState& ActionPlayback::next() {
    if (done()) {
        state_ = {};
        return state_;
    }
    if (tick_ == nextChange_) readChange();
    ++tick_;
    return state_;
}

}  // namespace atlax
