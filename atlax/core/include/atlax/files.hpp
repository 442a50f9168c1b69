#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace atlax {

// Plain files by their paths. The functions own nothing and may be called from any thread; those
// that can fail throw atlax::Error. For mounted folders and packs see file_system.hpp.

/// Reads a whole file of at most `maxBytes`. Throws Error with the name and the reason (missing,
/// a folder, too large, unreadable). Never blocks on a device or pipe: only regular files are read.
std::string readFile(const std::filesystem::path& file, std::size_t maxBytes);
std::vector<std::byte> readBytes(const std::filesystem::path& file, std::size_t maxBytes);

enum class Backup { None, KeepOne };

/// Writes to a new file in the same folder, flushes it to the disk and renames it over the target:
/// whatever happens, the target is the old or the new content, never a part. Missing folders are
/// made. With Backup::KeepOne the previous content stays as "<name>.bak". Through a symbolic link,
/// the file that it points to is written. What killed writers of this file have left is removed.
/// Throws Error, also for a pipe, a device or a folder; the target is then as before.
void writeFileAtomic(const std::filesystem::path& file, std::span<const std::byte> bytes,
                     Backup backup = Backup::None);
void writeFileAtomic(const std::filesystem::path& file, std::string_view text,
                     Backup backup = Backup::None);

/// The user's folders for this application after the XDG base directory rules
/// (XDG_CONFIG_HOME, XDG_DATA_HOME, XDG_CACHE_HOME, XDG_STATE_HOME, else below HOME). Not created
/// here.
std::filesystem::path configFolder(std::string_view application);
std::filesystem::path dataFolder(std::string_view application);
std::filesystem::path cacheFolder(std::string_view application);
/// For what is worth keeping but not for ever: logs, reports.
std::filesystem::path stateFolder(std::string_view application);

/// Folder of the running program's file; empty when it cannot be found out.
std::filesystem::path programFolder();

/// Finds an application's own files, wherever it was installed or built.
///
/// Folders are asked in this order: the environment variable, folders given by the program, then
/// "../share/<application>" beside the program, then the source tree (for programs that
/// run from the build folder).
///
/// A plain value that owns the names of the folders; one that does not change may be asked by
/// several threads at once.
class Assets {
public:
    struct Options {
        std::string application;             ///< name of the folder below share/
        std::string environmentVariable;     ///< may name one folder; empty for none
        std::filesystem::path sourceFolder;  ///< in the source tree; empty for none
    };

    explicit Assets(const Options& options);

    /// Asked before all others that were added earlier.
    void addFolder(const std::filesystem::path& folder);

    /// Path of an existing file. `name` is relative, with '/', and must not climb out ("..").
    /// Throws Error with the name and the folders that were searched.
    std::filesystem::path find(std::string_view name) const;
    bool exists(std::string_view name) const;

    const std::vector<std::filesystem::path>& folders() const { return folders_; }

private:
    std::vector<std::filesystem::path> folders_;
};

}  // namespace atlax
