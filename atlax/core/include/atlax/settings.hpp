#pragma once

#include <climits>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace atlax {

/// What one setting may be. Numbers with and without a fraction are different kinds.
using SettingValue =
    std::variant<bool, std::int64_t, double, std::string, std::vector<std::string>>;

/// Settings by key. Keys are made of lower-case letters, digits, '.', '_' and '-', at most 64 of
/// them, as "audio.music_volume".
using SettingMap = std::map<std::string, SettingValue, std::less<>>;

/// What a settings file holds.
struct SettingsDocument {
    int version = 1;  ///< of the application's settings, 1 or more
    SettingMap values;
};

/// Largest settings file that is read, bytes.
inline constexpr std::size_t maxSettingsBytes = 1u << 20;

/// Reads the text of a settings file. Throws Error with `name` and the reason. Any thread.
SettingsDocument parseSettings(std::string_view text, std::string_view name);
/// The opposite: JSON, sorted by key, the same text for the same settings. Any thread.
std::string formatSettings(const SettingsDocument& document);

/// The settings of an application in a file that survives crashes, full disks and damage.
///
/// The object owns the values; the file is read once, by load(), and written by save(): to a new
/// file, flushed, then renamed over the old one, which stays as "<name>.bak". Whatever happens, the
/// program goes on with what it has. One thread at a time.
class Settings {
public:
    struct Options {
        std::filesystem::path file;
        /// Of the settings that this program writes.
        int version = 1;
        /// Brings the values of an older version up to date; called by load() with the version that
        /// was read. When it throws, the file counts as damaged.
        std::function<void(int from, SettingMap& values)> migrate = {};
    };

    /// Where the values came from.
    enum class Origin {
        Defaults,  ///< there was no file, or nothing that could be read
        File,
        Backup,  ///< the file could not be read, but its backup could
    };

    /// Reads nothing yet. Throws Error for a version below 1.
    explicit Settings(Options options);

    /// Reads the file. A damaged one, or one of a newer version of the program, is set aside as
    /// "<name>.damaged-1" or "<name>.newer-1" (2, 3, ... up to 9, of which the last is replaced),
    /// and the backup is read instead; when that cannot be read either, all settings have their
    /// defaults. Never throws; what went wrong is in the log and in problem(). A file that could
    /// not be set aside (a read-only home) stays where it is.
    Origin load() noexcept;

    /// Writes the file. Throws Error (a full disk, a read-only home); file, backup and the values
    /// are then as before.
    void save();
    /// The same without throwing: a failure goes to the log and to problem().
    bool trySave() noexcept;

    /// Whether something was changed since the last load() or save().
    bool changed() const { return changed_; }
    /// The sentence about the last failure of load() or trySave(); empty when there was none.
    const std::string& problem() const { return problem_; }

    /// The value of a key, or `fallback` when there is none or it is of another kind. An integer in
    /// the file serves as a number with a fraction too. A number outside of low..high counts as
    /// none.
    bool get(std::string_view key, bool fallback) const;
    std::int64_t get(std::string_view key, std::int64_t fallback, std::int64_t low = INT64_MIN,
                     std::int64_t high = INT64_MAX) const;
    template <std::same_as<int> T>
    int get(std::string_view key, T fallback, int low = INT_MIN, int high = INT_MAX) const {
        return static_cast<int>(
            get(key, std::int64_t{fallback}, std::int64_t{low}, std::int64_t{high}));
    }
    double get(std::string_view key, double fallback, double low, double high) const;
    std::string get(std::string_view key, std::string_view fallback) const;
    std::string get(std::string_view key, const char* fallback) const;
    std::vector<std::string> get(std::string_view key,
                                 const std::vector<std::string>& fallback) const;
    bool has(std::string_view key) const { return values_.contains(key); }

    /// Throws Error for a key that cannot be written, a number that is not finite, or text that is
    /// no UTF-8.
    void set(std::string_view key, SettingValue value);
    void set(std::string_view key, const char* value) {
        set(key, SettingValue(std::string(value)));
    }
    /// Of exactly this type, so that no fraction is cut off.
    template <std::same_as<int> T>
    void set(std::string_view key, T value) {
        set(key, SettingValue(static_cast<std::int64_t>(value)));
    }
    /// Back to the default.
    void erase(std::string_view key);

    const SettingMap& values() const { return values_; }

private:
    bool read(const std::filesystem::path& file, bool isBackup);
    void setAside(const char* kind) noexcept;

    Options options_;
    SettingMap values_;
    std::string problem_;
    bool changed_ = false;
};

}  // namespace atlax
