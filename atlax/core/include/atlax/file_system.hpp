#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <atlax/pack.hpp>

namespace atlax {

/// Folders and packs that look like one tree of files, and one folder to write to (PhysicsFS).
///
/// Names are plain (see isPlainName): relative, with '/', never leading out. Symbolic links inside
/// of mounted folders are not followed. What was mounted last is looked at first; before all of it
/// comes the write folder, so that what a user saved hides what was shipped.
///
/// PhysicsFS keeps one state per process, so only one object may exist at a time; a second one
/// throws Error. Reading (exists, list, read) may happen in any thread; mounting, unmounting and
/// writing in one at a time, best the main thread. Owns the mounts, which end with it. Every
/// failure is an atlax::Error with name and reason that leaves the mounts and the files as they
/// were.
class FileSystem {
public:
    /// The write folder of an application is dataFolder("name"): XDG_DATA_HOME/name, else
    /// ~/.local/share/name. It is made by the first write, not here.
    explicit FileSystem(const std::filesystem::path& writeFolder);
    ~FileSystem();
    FileSystem(const FileSystem&) = delete;
    FileSystem& operator=(const FileSystem&) = delete;

    /// Puts what is below `folder` at `place`, a plain name, or "" for the root.
    void mountFolder(const std::filesystem::path& folder, std::string_view place = "");
    /// The same for a pack, which is checked and verified first: one that lies about sizes, climbs
    /// out of its root or is damaged is refused, and nothing of it is mounted. Takes time in
    /// proportion to the unpacked size.
    void mountPack(const std::filesystem::path& pack, std::string_view place = "",
                   const PackLimits& limits = {});
    /// Ends what was mounted under this path of a folder or pack. Throws Error when nothing was.
    void unmount(const std::filesystem::path& mounted);
    /// Folders and packs in the order in which they are looked at, without the write folder.
    const std::vector<std::filesystem::path>& mounted() const { return mounted_; }

    /// Whether there is a file (not a folder) of this name. False for names that are not plain.
    bool exists(std::string_view name) const;
    /// Names of the files and folders in `folder` ("" is the root), sorted, without their path.
    /// Empty when there is no such folder.
    std::vector<std::string> list(std::string_view folder) const;
    /// Reads a whole file of at most `maxBytes`.
    std::vector<std::byte> read(std::string_view name, std::size_t maxBytes) const;
    std::string readText(std::string_view name, std::size_t maxBytes) const;

    const std::filesystem::path& writeFolder() const { return writeFolder_; }
    /// Writes below the write folder, atomically as writeFileAtomic does, and makes missing
    /// folders. Links below the write folder are not written through.
    void write(std::string_view name, std::span<const std::byte> bytes);
    void write(std::string_view name, std::string_view text);

private:
    void mountWriteFolder();
    void putWriteFolderFirst();

    std::filesystem::path writeFolder_;
    bool writeFolderMounted_ = false;
    std::vector<std::filesystem::path> mounted_;
};

}  // namespace atlax
