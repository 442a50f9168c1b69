#include "share.hpp"

#include <array>
#include <atlax/base64.hpp>
#include <atlax/compression.hpp>
#include <atlax/error.hpp>
#include <cstdlib>
#include <optional>
#include <span>

namespace quaoar {
namespace {

constexpr std::string_view prefix = "quaoar-replay:";
constexpr std::uint8_t formatVersion = 1;
constexpr int half = 512;       ///< aims of players lie on the edge of a square of this half side
constexpr int edge = 8 * half;  ///< points of that edge
constexpr std::size_t mostBytes = std::size_t{4} << 20;

[[noreturn]] void refuse(const std::string& why) {
    throw RecordingError("this is no replay of the game: " + why);
}

class Writer {
public:
    void byte(std::uint8_t value) { bytes.push_back(static_cast<std::byte>(value)); }
    void fixed(std::uint64_t value, int count) {
        for (int i = 0; i < count; ++i) byte(static_cast<std::uint8_t>(value >> (8 * i)));
    }
    void number(std::uint64_t value) {
        for (; value >= 128; value >>= 7) byte(static_cast<std::uint8_t>(value | 128));
        byte(static_cast<std::uint8_t>(value));
    }
    void text(std::string_view value) {
        number(value.size());
        for (const char c : value) byte(static_cast<std::uint8_t>(c));
    }
    std::vector<std::byte> bytes;
};

class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    std::uint8_t byte() {
        if (rest_.empty()) refuse("it ends too early");
        const auto value = std::to_integer<std::uint8_t>(rest_.front());
        rest_ = rest_.subspan(1);
        return value;
    }
    std::uint64_t fixed(int count) {
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i) value |= std::uint64_t{byte()} << (8 * i);
        return value;
    }
    std::uint64_t number(std::uint64_t most) {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 63; shift += 7) {
            const std::uint8_t next = byte();
            value |= std::uint64_t{next & 127u} << shift;
            if (next < 128 && value <= most) return value;
            if (next < 128) break;
        }
        refuse("it holds a number above " + std::to_string(most));
    }
    std::string text() {
        std::string value(number(200), ' ');
        for (char& c : value) c = static_cast<char>(byte());
        return value;
    }
    std::size_t left() const { return rest_.size(); }

private:
    std::span<const std::byte> rest_;
};

/// The place of an aim on the edge of the square, counter-clockwise; nothing for other aims.
std::optional<int> edgeOf(int x, int y) {
    if (std::max(std::abs(x), std::abs(y)) != half) return {};
    if (x == half && y < half) return y + half;
    if (y == half && x > -half) return 2 * half + half - x;
    if (x == -half && y > -half) return 4 * half + half - y;
    return 6 * half + x + half;
}

void setAimOnEdge(TickInput& input, int place) {
    const int along = place % (2 * half) - half;
    const auto to16 = [](int value) { return static_cast<std::int16_t>(value); };
    const int side = place / (2 * half);
    input.aimX = to16(side == 0 ? half : side == 1 ? -along : side == 2 ? -half : along);
    input.aimY = to16(side == 0 ? along : side == 1 ? half : side == 2 ? -along : -half);
}

int buttonBits(const TickInput& input) {
    return (input.fire ? 1 : 0) | (input.reelIn ? 2 : 0) | (input.reelOut ? 4 : 0) |
           (input.boost ? 8 : 0) | (input.restart ? 16 : 0) | (input.retry ? 32 : 0);
}

/// The change from the aim before as a small number, 0 and the aim itself where it has no place.
void writeAim(Writer& out, const TickInput& input, int& place) {
    const auto next = edgeOf(input.aimX, input.aimY);
    if (!next) {
        out.number(0);
        out.fixed(static_cast<std::uint16_t>(input.aimX), 2);
        out.fixed(static_cast<std::uint16_t>(input.aimY), 2);
        return;
    }
    const int turn = (*next - place + edge + edge / 2) % edge - edge / 2;
    out.number(static_cast<std::uint64_t>(turn < 0 ? -2 * turn - 1 : 2 * turn) + 1);
    place = *next;
}

void readAim(Reader& in, TickInput& input, int& place) {
    const auto code = static_cast<int>(in.number(edge + 1));
    if (code == 0) {
        input.aimX = static_cast<std::int16_t>(in.fixed(2));
        input.aimY = static_cast<std::int16_t>(in.fixed(2));
        if (input.aimX == -32768 || input.aimY == -32768) refuse("it holds no direction");
        return;
    }
    const int turn = (code - 1) % 2 == 1 ? -(code / 2) : (code - 1) / 2;
    place = (place + turn + edge) % edge;
    setAimOnEdge(input, place);
}

Recording readRecording(Reader& in) {
    if (in.byte() != formatVersion) refuse("it is of another version of the game");
    Recording recording;
    recording.levelHash = in.fixed(8);
    recording.finalHash = in.fixed(8);
    recording.numbers = in.byte() == 1 ? "double" : "float";
    recording.levelId = in.text();
    recording.library = in.text();
    constexpr std::size_t leastPerRun = 4;  // bytes: nobody makes us reserve what is not there
    std::vector<InputRun> runs(in.number(in.left() / leastPerRun));
    std::uint64_t ticks = 0;
    for (InputRun& run : runs) {
        run.ticks = static_cast<std::uint32_t>(in.number(Recording::maxTicks));
        ticks += run.ticks;
        if (run.ticks == 0 || ticks > Recording::maxTicks) refuse("it is longer than an hour");
    }
    for (InputRun& run : runs) {
        const std::uint8_t bits = in.byte();
        run.input.fire = (bits & 1) != 0;
        run.input.reelIn = (bits & 2) != 0;
        run.input.reelOut = (bits & 4) != 0;
        run.input.boost = (bits & 8) != 0;
        run.input.restart = (bits & 16) != 0;
        run.input.retry = (bits & 32) != 0;
    }
    for (InputRun& run : runs) run.input.push = static_cast<std::int8_t>(in.byte());
    int place = 0;
    for (InputRun& run : runs) readAim(in, run.input, place);
    if (in.left() > 0) refuse("something follows after its end");
    for (const InputRun& run : runs)
        for (std::uint32_t n = 0; n < run.ticks; ++n) recording.append(run.input);
    return recording;
}

}  // namespace

std::vector<std::byte> shareBytes(const Recording& recording) {
    Writer out;
    out.byte(formatVersion);
    out.fixed(recording.levelHash, 8);
    out.fixed(recording.finalHash, 8);
    out.byte(recording.numbers == "double" ? 1 : 0);
    out.text(recording.levelId.substr(0, 200));
    out.text(recording.library.substr(0, 200));
    out.number(recording.runs().size());
    for (const InputRun& run : recording.runs()) out.number(run.ticks);
    for (const InputRun& run : recording.runs())
        out.byte(static_cast<std::uint8_t>(buttonBits(run.input)));
    for (const InputRun& run : recording.runs())
        out.byte(static_cast<std::uint8_t>(run.input.push));
    int place = 0;
    for (const InputRun& run : recording.runs()) writeAim(out, run.input, place);
    return out.bytes;
}

Recording parseShareBytes(std::span<const std::byte> bytes) {
    Reader in(bytes);
    return readRecording(in);
}

std::string shareText(const Recording& recording) {
    return std::string(prefix) + atlax::toBase64(atlax::compress(shareBytes(recording), 19));
}

Recording parseShareText(std::string_view text) {
    const std::size_t start = text.find(prefix);
    if (start == std::string_view::npos)
        refuse("\"" + std::string(prefix) + "\" is missing at its beginning");
    const std::vector<std::byte> packed = atlax::fromBase64(text.substr(start + prefix.size()));
    try {
        return parseShareBytes(atlax::decompress(packed, mostBytes));
    } catch (const atlax::Error&) {
        refuse("it is damaged or cut short");
    }
}

}  // namespace quaoar
