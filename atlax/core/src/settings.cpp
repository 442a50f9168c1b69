#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <atlax/settings.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "utf8.hpp"

namespace atlax {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

constexpr std::size_t longestKey = 64;
constexpr int deepest = 3;  ///< the document, its values, one list
constexpr int lastAside = 9;

bool isKey(std::string_view key) {
    return !key.empty() && key.size() <= longestKey &&
           std::all_of(key.begin(), key.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
                      c == '-';
           });
}

struct Newer : Error {
    using Error::Error;
};

[[noreturn]] void fail(std::string_view name, const std::string& reason) {
    throw Error(std::string(name) + ": these settings cannot be read: " + reason);
}

Json parseJson(std::string_view text, std::string_view name) {
    if (text.size() > maxSettingsBytes) fail(name, "they are too long");
    const auto shallow = [&](int depth, Json::parse_event_t event, Json&) {
        const bool opens =
            event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
        if (opens && depth >= deepest) fail(name, "something in them is nested too deep");
        return true;
    };
    try {
        return Json::parse(text.begin(), text.end(), shallow);
    } catch (const Json::parse_error& error) {
        fail(name, "they are no JSON near byte " + std::to_string(error.byte));
    } catch (const Json::exception&) {
        fail(name, "they are no JSON with numbers of a sensible size");
    }
}

SettingValue readValue(const Json& json, const std::string& key, std::string_view name) {
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_number_unsigned() && json.get<std::uint64_t>() > INT64_MAX)
        fail(name, "the number of \"" + key + "\" is too large");
    if (json.is_number_integer()) return json.get<std::int64_t>();
    if (json.is_number_float()) return json.get<double>();
    if (json.is_string()) return json.get<std::string>();
    if (!json.is_array())
        fail(name, "\"" + key + "\" must be a number, a text, true, false or a list");
    std::vector<std::string> list;
    for (const Json& item : json) {
        if (!item.is_string()) fail(name, "the list \"" + key + "\" may hold only texts");
        list.push_back(item.get<std::string>());
    }
    return list;
}

/// `key` and a number for names of copies: "settings.json.damaged-2".
fs::path asideName(const fs::path& file, const char* kind) {
    for (int i = 1;; ++i) {
        const fs::path name = file.string() + "." + kind + "-" + std::to_string(i);
        std::error_code ignored;
        if (i == lastAside || !fs::exists(fs::symlink_status(name, ignored))) return name;
    }
}

template <class T>
const T* valueOf(const SettingMap& values, std::string_view key) {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : std::get_if<T>(&found->second);
}

}  // namespace

SettingsDocument parseSettings(std::string_view text, std::string_view name) {
    const Json json = parseJson(text, name);
    if (!json.is_object() || !json.contains("version") || !json.contains("settings"))
        fail(name, "they must be an object with \"version\" and \"settings\"");
    const Json& version = json["version"];
    if (!version.is_number_integer() || version < 1 || version > 1'000'000)
        fail(name, "\"version\" must be an integer from 1 to 1000000");
    if (!json["settings"].is_object()) fail(name, "\"settings\" must be an object");
    SettingsDocument out;
    out.version = version.get<int>();
    for (const auto& [key, value] : json["settings"].items()) {
        if (!isKey(key)) fail(name, "\"" + printable(key) + "\" is no name of a setting");
        out.values.emplace(key, readValue(value, key, name));
    }
    return out;
}

std::string formatSettings(const SettingsDocument& document) {
    Json settings = Json::object();
    for (const auto& [key, value] : document.values)
        std::visit([&, &name = key](const auto& v) { settings[name] = v; }, value);
    const Json json{{"version", document.version}, {"settings", settings}};
    return json.dump(2) + "\n";
}

Settings::Settings(Options options) : options_(std::move(options)) {
    if (options_.version < 1) throw Error("the version of settings must be 1 or more");
}

/// Whether the values now come from this file. Throws Error when it cannot be read.
bool Settings::read(const fs::path& file, bool isBackup) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(file, ignored))) return false;
    SettingsDocument document = parseSettings(readFile(file, maxSettingsBytes), file.string());
    if (document.version > options_.version)
        throw Newer(file.string() + ": these settings are of a newer program (version " +
                    std::to_string(document.version) + "; this one knows " +
                    std::to_string(options_.version) + ")");
    const bool older = document.version < options_.version;
    if (older && options_.migrate) options_.migrate(document.version, document.values);
    values_ = std::move(document.values);
    changed_ = older || isBackup;
    return true;
}

/// Best effort: in a read-only folder the file stays where it is.
void Settings::setAside(const char* kind) noexcept {
    try {
        const fs::path aside = asideName(options_.file, kind);
        std::error_code failed;
        fs::rename(options_.file, aside, failed);
        problem_ += failed ? "; it cannot be set aside: " + failed.message()
                           : "; it was set aside as " + aside.filename().string();
    } catch (const std::exception&) {  // NOLINT: out of memory, then without a message
    }
}

Settings::Origin Settings::load() noexcept {
    problem_.clear();
    values_.clear();
    changed_ = false;
    Origin origin = Origin::Defaults;
    const fs::path backup = options_.file.string() + ".bak";
    const auto attempt = [&](const fs::path& file, bool isBackup) {
        try {
            if (read(file, isBackup)) origin = isBackup ? Origin::Backup : Origin::File;
        } catch (const Newer& error) {
            problem_ += (problem_.empty() ? "" : "; ") + std::string(error.what());
            if (!isBackup) setAside("newer");
        } catch (const std::exception& error) {
            problem_ += (problem_.empty() ? "" : "; ") + std::string(error.what());
            if (!isBackup) setAside("damaged");
        }
    };
    attempt(options_.file, false);
    if (origin == Origin::Defaults) attempt(backup, true);
    if (problem_.empty()) return origin;
    problem_ += origin == Origin::Backup ? "; the backup is used" : "; the defaults are used";
    log(LogLevel::Warning, problem_);
    return origin;
}

void Settings::save() {
    writeFileAtomic(options_.file, formatSettings({options_.version, values_}), Backup::KeepOne);
    changed_ = false;
    problem_.clear();
}

bool Settings::trySave() noexcept {
    try {
        save();
        return true;
    } catch (const std::exception& error) {
        problem_ = error.what();
        log(LogLevel::Warning, "the settings could not be saved: " + problem_);
        return false;
    }
}

bool Settings::get(std::string_view key, bool fallback) const {
    const auto* value = valueOf<bool>(values_, key);
    return value != nullptr ? *value : fallback;
}

std::int64_t Settings::get(std::string_view key, std::int64_t fallback, std::int64_t low,
                           std::int64_t high) const {
    const auto* value = valueOf<std::int64_t>(values_, key);
    return value != nullptr && *value >= low && *value <= high ? *value : fallback;
}

double Settings::get(std::string_view key, double fallback, double low, double high) const {
    double number = std::nan("");
    if (const auto* value = valueOf<double>(values_, key)) number = *value;
    if (const auto* value = valueOf<std::int64_t>(values_, key))
        number = static_cast<double>(*value);
    return number >= low && number <= high ? number : fallback;
}

std::string Settings::get(std::string_view key, std::string_view fallback) const {
    const auto* value = valueOf<std::string>(values_, key);
    return value != nullptr ? *value : std::string(fallback);
}

std::string Settings::get(std::string_view key, const char* fallback) const {
    return get(key, std::string_view(fallback));
}

std::vector<std::string> Settings::get(std::string_view key,
                                       const std::vector<std::string>& fallback) const {
    const auto* value = valueOf<std::vector<std::string>>(values_, key);
    return value != nullptr ? *value : fallback;
}

void Settings::set(std::string_view key, SettingValue value) {
    if (!isKey(key)) throw Error("\"" + printable(key) + "\" is no name of a setting");
    const auto refuseText = [&](const std::string& text) {
        if (!isUtf8(text)) throw Error("the setting \"" + std::string(key) + "\" is no UTF-8");
    };
    if (const auto* number = std::get_if<double>(&value); number && !std::isfinite(*number))
        throw Error("the setting \"" + std::string(key) + "\" must be a finite number");
    if (const auto* text = std::get_if<std::string>(&value)) refuseText(*text);
    if (const auto* list = std::get_if<std::vector<std::string>>(&value))
        std::for_each(list->begin(), list->end(), refuseText);
    const auto found = values_.find(key);
    if (found != values_.end() && found->second == value) return;
    values_.insert_or_assign(std::string(key), std::move(value));
    changed_ = true;
}

void Settings::erase(std::string_view key) {
    const auto found = values_.find(key);
    if (found == values_.end()) return;
    values_.erase(found);
    changed_ = true;
}

}  // namespace atlax
