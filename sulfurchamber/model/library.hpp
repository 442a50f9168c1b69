// The templates that one can place: those that come with the program, one's own, and those beside
// the scene.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "templates.hpp"

namespace sulfurchamber {

/// A template file.
struct LibraryEntry {
    enum class Origin : std::uint8_t { starter, own, scene };
    std::string name;
    std::string category;
    std::string description;
    std::filesystem::path file;
    Origin origin = Origin::starter;
};

/// Plain value, one thread. Of several templates of one name that beside the scene counts, then
/// one's own.
class Library {
public:
    /// Folders of the program, and the user's, which is made when something is saved.
    Library(std::vector<std::filesystem::path> starters, std::filesystem::path own);

    /// The folder of the scene that is open; empty: it has none. Its templates lie in "templates".
    void setSceneFolder(const std::filesystem::path& folder);
    const std::filesystem::path& sceneFolder() const { return scene_; }
    /// Reads all files anew. What cannot be read is left out; problems() says why.
    void rescan();
    /// One sentence each.
    const std::vector<std::string>& problems() const { return problems_; }

    /// By category, then by name.
    const std::vector<LibraryEntry>& entries() const { return entries_; }
    /// Those whose name, category or description has all words, whatever their case.
    std::vector<LibraryEntry> matching(std::string_view words) const;
    /// Null when there is none.
    const LibraryEntry* find(std::string_view name) const;
    /// Throws sulfur::scene::ReadError or std::runtime_error.
    static Template load(const LibraryEntry& entry);

    /// Writes one's own template, or one beside the scene, and scans again. Returns the file.
    /// Throws std::runtime_error where the scene has no folder, sulfur::scene::WriteError when the
    /// disk refuses.
    std::filesystem::path save(const Template& made, bool besideScene);
    /// Removes a file that is not one of the program's; else throws std::runtime_error.
    void remove(std::string_view name);

private:
    void scan(const std::filesystem::path& folder, LibraryEntry::Origin origin);

    std::vector<std::filesystem::path> starters_;
    std::filesystem::path own_;
    std::filesystem::path scene_;
    std::vector<LibraryEntry> entries_;
    std::vector<std::string> problems_;
};

/// Whether a scene's template is another one than the library's: that was changed elsewhere.
bool differsFromLibrary(const sulfur::scene::Scene& scene, const LibraryEntry& entry);

}  // namespace sulfurchamber
