#include "bench/history.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <vector>

#include "whole_file.hpp"

namespace sulfur::lab::bench {

namespace {

const char* const head = "date,version,scene,variant,setting,ms_per_s,error_name,error";
constexpr std::size_t fieldCount = 8;

std::vector<std::string> fieldsOf(const std::string& line) {
    std::vector<std::string> fields;
    std::string field;
    for (const char c : line) {
        if (c == ',') {
            fields.push_back(std::move(field));
            field.clear();
        } else {
            field += c;
        }
    }
    fields.push_back(std::move(field));
    return fields;
}

struct Past {
    std::string date, version;
    double time = 0;
};

double timeOf(const std::string& text) {
    double time = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), time);
    const bool whole = problem == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(time) && time > 0 ? time : -1;
}

struct History {
    std::string text;                  ///< of the whole file
    std::map<std::string, Past> last;  ///< of each row
};

History readHistory(const std::string& file) {
    History history;
    std::ifstream stream(file);
    if (!stream && std::filesystem::exists(file))
        throw std::runtime_error(file + " cannot be read; choose a file with --history that can");
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        history.text += line + '\n';
        if (number == 1 && line == head) continue;
        const auto fields = fieldsOf(line);
        const double time = fields.size() == fieldCount ? timeOf(fields[5]) : -1;
        if (time < 0 || number == 1)
            throw std::runtime_error(
                fmt::format("{}, line {}: this is no entry of a history; choose a file with "
                            "--history that a comparison wrote, or one that is not there",
                            file, number));
        history.last[fields[2] + ',' + fields[3] + ',' + fields[4]] = {fields[0], fields[1], time};
    }
    if (history.text.empty()) history.text = std::string(head) + '\n';
    return history;
}

/// Without commas, which the file has between its fields.
std::string plain(std::string text) {
    std::erase(text, ',');
    return text;
}

}  // namespace

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    return fmt::format("{:04}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
}

void checkDate(const std::string& date) {
    bool good = date.size() == 10;
    for (std::size_t i = 0; good && i < date.size(); ++i)
        good = i == 4 || i == 7 ? date[i] == '-' : date[i] >= '0' && date[i] <= '9';
    if (!good)
        throw std::runtime_error(
            fmt::format("--date {}: this is no date; give one as 2026-01-31", date));
}

std::string keepHistory(const std::string& file, const std::string& date,
                        const Comparison& comparison) {
    auto [text, last] = readHistory(file);
    std::string told;
    for (const Row& row : comparison.rows) {
        const Engine& engine = engineOf(row.setting.engine);
        if (!engine.ours || row.cut()) continue;
        const std::string key = plain(row.scene.key) + ',' + plain(row.scene.variant) + ',' +
                                plain(row.setting.label());
        const double time = row.msPerSecond.median;
        text += fmt::format("{},{},{},{:.6g},{},{:.6g}\n", date, plain(engine.version), key, time,
                            plain(row.scene.error), row.figure(row.scene.error));
        const auto before = last.find(key);
        if (before == last.end()) continue;
        const double change = time / before->second.time - 1;
        if (std::abs(change) > regression)
            told += fmt::format("{}: {} {}, {}: {:.4g} ms/s, {:.4g} on {} ({}), {:+.0f} %\n",
                                change > 0 ? "REGRESSION" : "faster", row.scene.key,
                                row.scene.variant, row.setting.label(), time, before->second.time,
                                before->second.date, before->second.version, 100 * change);
    }
    files::writeWhole(file, text);
    if (told.empty())
        told = fmt::format("No row of ours changed by more than {:.0f} % since its last entry.\n",
                           100 * regression);
    return fmt::format("\nHistory in {}:\n{}", file, told);
}

}  // namespace sulfur::lab::bench
