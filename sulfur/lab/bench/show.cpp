#include "bench/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sulfur::lab::bench {

namespace {

std::string number(double value) {
    if (!std::isfinite(value)) return "exploded";
    const double size = std::abs(value);
    if (size >= 1e5 || (size > 0 && size < 1e-3)) return fmt::format("{:.1e}", value);
    return fmt::format("{:.4g}", value);
}

std::string titleOf(const Setting& setting) {
    return engineOf(setting.engine).title + ", " + setting.label();
}

bool sameTable(const Row& a, const Row& b) {
    return a.scene.key == b.scene.key && a.scene.variant == b.scene.variant;
}

std::string heading(const Row& row) {
    std::string out =
        fmt::format("\n{} {}: {}\n", row.scene.key, row.scene.variant, row.scene.title);
    out += fmt::format("{:<36}{:>10}{:>20}{:>10}", "", "ms/s", "least - most", "last s");
    for (const Figure& figure : row.figures)
        out += fmt::format("  {}", figure.unit.empty()
                                       ? figure.name
                                       : fmt::format("{} ({})", figure.name, figure.unit));
    return out + '\n';
}

std::string line(const Row& row) {
    const Spread& t = row.msPerSecond;
    std::string out =
        fmt::format("{:<36}{:>10}{:>20}{:>10}", titleOf(row.setting), number(t.median),
                    fmt::format("{} - {}", number(t.least), number(t.most)),
                    row.lastSecond.count > 0 ? number(row.lastSecond.median) : "");
    for (const Figure& figure : row.figures) {
        const std::size_t width =
            figure.name.size() + (figure.unit.empty() ? 0 : figure.unit.size() + 3);
        out += fmt::format("  {:>{}}", number(figure.value), width);
    }
    if (row.cut()) out += fmt::format("  stopped after {:.3g} s", row.simulated);
    return out + '\n';
}

/// Shares, because engines read the clock on the wall, which also counts what other programs take.
std::string stagesOf(const Row& row) {
    double sum = 0;
    for (const auto& [name, seconds] : row.stages) sum += seconds;
    for (const auto& [name, seconds] : row.stages)
        if (name == "whole step") sum = seconds;
    std::string out =
        fmt::format("{} {:<12} {:<28}", row.scene.key, row.scene.variant, titleOf(row.setting));
    for (const auto& [name, seconds] : row.stages)
        if (name != "whole step" && seconds >= 0.005 * sum)
            out += fmt::format("  {} {:.1f}", name, 100 * seconds / sum);
    return out + '\n';
}

std::string introduction(const Comparison& comparison) {
    std::string out = fmt::format(
        "Engines on the same scenes. ms/s: milliseconds of processor time for a simulated second "
        "(1000 is\nreal time), stepping and, in S1, making the boxes; {} of {} round{} in which "
        "all take turns, {}.\nNothing sleeps but in S8 smash. S7 is timed on the wall, with the "
        "cores that its threads need.\n",
        comparison.options.rounds == 1 ? "the one run" : "the median", comparison.options.rounds,
        comparison.options.rounds == 1 ? "" : "s",
        comparison.core < 0 ? "not bound to a core"
                            : fmt::format("bound to core {}", comparison.core));
    for (const Engine& engine : engines())
        if (engine.found()) out += fmt::format("{} {}\n", engine.title, engine.version);
    return out + missingEngines();
}

}  // namespace

std::string jsonNumber(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : std::string("null");
}

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + '"';
}

std::string jsonText(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out + '"';
}

std::string asText(const Comparison& comparison) {
    std::string out = introduction(comparison);
    const Row* before = nullptr;
    for (const Row& row : comparison.rows) {
        if (before == nullptr || !sameTable(*before, row)) out += heading(row);
        out += line(row);
        before = &row;
    }
    const bool staged = std::any_of(comparison.rows.begin(), comparison.rows.end(),
                                    [](const Row& row) { return !row.stages.empty(); });
    if (staged)
        out += "\nStages, % of a tick, in a run of their own; what is below 0.5 % is left out:\n";
    for (const Row& row : comparison.rows)
        if (!row.stages.empty()) out += stagesOf(row);
    return out;
}

std::string asCsv(const Comparison& comparison) {
    std::string out =
        "scene,variant,engine,version,rate_hz,iterations,threads,stiff,simulated_s,quantity,unit,"
        "value,least,most,runs\n";
    for (const Row& row : comparison.rows) {
        const std::string begin =
            fmt::format("{},{},{},{},{},{},{},{},{}", row.scene.key, csvField(row.scene.variant),
                        row.setting.engine, csvField(engineOf(row.setting.engine).version),
                        row.setting.rate, row.setting.iterations, row.setting.threads,
                        row.setting.stiffJoints ? 1 : 0, row.simulated);
        const auto spread = [&](const char* name, const Spread& s) {
            if (s.count > 0)
                out += fmt::format("{},{},ms/s,{},{},{},{}\n", begin, name, s.median, s.least,
                                   s.most, s.count);
        };
        spread("time", row.msPerSecond);
        spread("time in the last second", row.lastSecond);
        for (const Figure& f : row.figures)
            out += fmt::format("{},{},{},{},,,1\n", begin, csvField(f.name), csvField(f.unit),
                               f.value);
        for (const auto& [name, seconds] : row.stages)
            out += fmt::format("{},{},ms/s,{},,,1\n", begin, csvField("stage: " + name),
                               1e3 * seconds / row.simulated);
    }
    return out;
}

std::string asJson(const Comparison& comparison) {
    std::string out = fmt::format("{{\n  \"rounds\": {},\n  \"core\": {},\n  \"missing\": [",
                                  comparison.options.rounds, comparison.core);
    const char* separator = "";
    for (const Engine& engine : engines()) {
        if (engine.found()) continue;
        out += separator + jsonText(engine.title);
        separator = ", ";
    }
    out += "],\n  \"rows\": [";
    separator = "\n";
    for (const Row& row : comparison.rows) {
        out += fmt::format(
            "{}    {{\"scene\": {}, \"variant\": {}, \"engine\": {}, \"version\": {}, \"rate\": "
            "{}, \"iterations\": {}, \"threads\": {}, \"stiffJoints\": {}, \"simulated\": {}",
            separator, jsonText(row.scene.key), jsonText(row.scene.variant),
            jsonText(row.setting.engine), jsonText(engineOf(row.setting.engine).version),
            row.setting.rate, row.setting.iterations, row.setting.threads, row.setting.stiffJoints,
            jsonNumber(row.simulated));
        separator = ",\n";
        const Spread &t = row.msPerSecond, &l = row.lastSecond;
        out += fmt::format(
            ", \"msPerSecond\": {{\"median\": {}, \"least\": {}, \"most\": {}, \"runs\": {}}}",
            jsonNumber(t.median), jsonNumber(t.least), jsonNumber(t.most), t.count);
        if (l.count > 0) out += fmt::format(", \"lastSecond\": {}", jsonNumber(l.median));
        out += ", \"figures\": {";
        const char* comma = "";
        for (const Figure& f : row.figures) {
            out += fmt::format("{}{}: {{\"value\": {}, \"unit\": {}}}", comma, jsonText(f.name),
                               jsonNumber(f.value), jsonText(f.unit));
            comma = ", ";
        }
        out += "}, \"stages\": {";
        comma = "";
        for (const auto& [name, seconds] : row.stages) {
            out += fmt::format("{}{}: {}", comma, jsonText(name),
                               jsonNumber(1e3 * seconds / row.simulated));
            comma = ", ";
        }
        out += "}}";
    }
    return out + "\n  ]\n}\n";
}

}  // namespace sulfur::lab::bench
