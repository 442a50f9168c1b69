// Recordings as text, and back with every line checked.
#include <charconv>
#include <cstdio>
#include <quaoar/recording.hpp>

namespace quaoar {
namespace {

constexpr int versionNumber = 1;
constexpr std::string_view firstLine = "quaoar-recording 1";

int buttons(const TickInput& input) {
    return (input.fire ? 1 : 0) + (input.reelIn ? 2 : 0) + (input.reelOut ? 4 : 0) +
           (input.boost ? 8 : 0) + (input.restart ? 16 : 0) + (input.retry ? 32 : 0);
}

std::string hexadecimal(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

/// Walks through the lines of a text and knows where it is.
class Lines {
public:
    Lines(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

    std::string_view next() {
        ++line_;
        const std::size_t end = rest_.find('\n');
        if (end == std::string_view::npos) {
            fail("the recording ends in the middle of a line or too early; it was cut short");
        }
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return line;
    }
    bool empty() const { return rest_.empty(); }

    [[noreturn]] void fail(const std::string& problem) const {
        throw RecordingError(file_ + ":" + std::to_string(line_) + ": " + problem);
    }

    /// The value of a line "key value".
    std::string_view value(std::string_view key) {
        const std::string_view line = next();
        if (line.size() <= key.size() + 1 || !line.starts_with(key) || line[key.size()] != ' ') {
            fail("expected \"" + std::string(key) + " ...\"");
        }
        return line.substr(key.size() + 1);
    }

    std::int64_t number(std::string_view text, std::int64_t low, std::int64_t high) const {
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || value < low ||
            value > high) {
            fail("\"" + std::string(text.substr(0, 40)) + "\" is not a whole number from " +
                 std::to_string(low) + " to " + std::to_string(high));
        }
        return value;
    }

    std::uint64_t hash(std::string_view text) const {
        std::uint64_t value = 0;
        const auto [end, error] =
            std::from_chars(text.data(), text.data() + text.size(), value, 16);
        if (error != std::errc() || end != text.data() + text.size() || text.size() != 16) {
            fail("a hash has 16 hexadecimal digits");
        }
        return value;
    }

private:
    std::string_view rest_;
    std::string file_;
    int line_ = 0;
};

InputRun readRun(const Lines& lines, std::string_view line) {
    std::int64_t values[5] = {};
    constexpr std::int64_t low[5] = {1, -32767, -32767, 0, -127};
    constexpr std::int64_t high[5] = {static_cast<std::int64_t>(Recording::maxTicks), 32767, 32767,
                                      63, 127};
    for (int i = 0; i < 5; ++i) {
        const std::size_t space = line.find(' ');
        if ((space == std::string_view::npos) != (i == 4)) {
            lines.fail("a run has five numbers: ticks aimX aimY buttons push");
        }
        values[i] = lines.number(line.substr(0, space), low[i], high[i]);
        line.remove_prefix(i == 4 ? line.size() : space + 1);
    }
    InputRun run;
    run.ticks = static_cast<std::uint32_t>(values[0]);
    run.input.aimX = static_cast<std::int16_t>(values[1]);
    run.input.aimY = static_cast<std::int16_t>(values[2]);
    run.input.fire = (values[3] & 1) != 0;
    run.input.reelIn = (values[3] & 2) != 0;
    run.input.reelOut = (values[3] & 4) != 0;
    run.input.boost = (values[3] & 8) != 0;
    run.input.restart = (values[3] & 16) != 0;
    run.input.retry = (values[3] & 32) != 0;
    run.input.push = static_cast<std::int8_t>(values[4]);
    return run;
}

}  // namespace

std::string Recording::format() const {
    std::string text(firstLine);
    const auto line = [&text](const char* key, const std::string& value) {
        text.append("\n").append(key).append(" ").append(value);
    };
    line("level", levelId);
    line("level-hash", hexadecimal(levelHash));
    line("library", library);
    line("numbers", numbers);
    line("ticks", std::to_string(ticks_));
    line("final-hash", hexadecimal(finalHash));
    text.append("\ninputs\n");
    for (const InputRun& run : runs_) {
        const int values[] = {run.input.aimX, run.input.aimY, buttons(run.input), run.input.push};
        text.append(std::to_string(run.ticks));
        for (const int value : values) text.append(" ").append(std::to_string(value));
        text.append("\n");
    }
    return text + "end\n";
}

Recording Recording::parse(std::string_view text, const std::string& file) {
    Lines lines(text, file);
    if (lines.next() != firstLine) {
        lines.fail("this is no recording of version " + std::to_string(versionNumber) +
                   "; the first line must be \"" + std::string(firstLine) + "\"");
    }
    Recording recording;
    recording.levelId = lines.value("level");
    recording.levelHash = lines.hash(lines.value("level-hash"));
    recording.library = lines.value("library");
    recording.numbers = lines.value("numbers");
    if (recording.numbers != "float" && recording.numbers != "double") {
        lines.fail("allowed are \"float\" and \"double\"");
    }
    const auto ticks = static_cast<std::uint64_t>(
        lines.number(lines.value("ticks"), 0, static_cast<std::int64_t>(maxTicks)));
    recording.finalHash = lines.hash(lines.value("final-hash"));
    if (lines.next() != "inputs") lines.fail("expected \"inputs\"");
    for (std::string_view line = lines.next(); line != "end"; line = lines.next()) {
        recording.runs_.push_back(readRun(lines, line));
        recording.ticks_ += recording.runs_.back().ticks;
        if (recording.ticks_ > ticks) lines.fail("the runs are longer than \"ticks\" says");
    }
    if (recording.ticks_ != ticks) lines.fail("the runs are shorter than \"ticks\" says");
    if (!lines.empty()) lines.fail("nothing may follow after \"end\"");
    return recording;
}

}  // namespace quaoar
