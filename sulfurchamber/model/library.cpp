#include "library.hpp"
#include "words.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

namespace sulfurchamber {
namespace {

namespace fs = std::filesystem;

constexpr const char* folderName = "templates";  // beside a scene

std::string loweredText(std::string_view text) {
    std::string low(text);
    for (char& c : low) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return low;
}

// What every file system takes: letters and digits, the rest as '-'.
std::string fileNameOf(const std::string& name) {
    std::string made;
    for (const char c : loweredText(name))
        made += std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<signed char>(c) < 0
                    ? c
                    : '-';
    return made + ".json";
}

}  // namespace

Library::Library(std::vector<fs::path> starters, fs::path own)
    : starters_(std::move(starters)), own_(std::move(own)) {}

void Library::setSceneFolder(const fs::path& folder) {
    scene_ = folder;
}

void Library::scan(const fs::path& folder, LibraryEntry::Origin origin) {
    if (folder.empty()) return;
    std::error_code error;
    for (const auto& file : fs::directory_iterator(folder, error)) {
        if (file.path().extension() != ".json") continue;
        try {
            const Template made = readTemplate(sulfur::scene::read(file.path()));
            std::erase_if(entries_, [&](const auto& one) { return one.name == made.name(); });
            entries_.push_back(
                {made.name(), made.category, made.scene.description, file.path(), origin});
        } catch (const std::exception& problem) {
            problems_.emplace_back(problem.what());
        }
    }
}

void Library::rescan() {
    entries_.clear();
    problems_.clear();
    for (const fs::path& folder : starters_) scan(folder, LibraryEntry::Origin::starter);
    scan(own_, LibraryEntry::Origin::own);
    if (!scene_.empty()) scan(scene_ / folderName, LibraryEntry::Origin::scene);
    std::sort(entries_.begin(), entries_.end(), [](const auto& a, const auto& b) {
        if (a.category != b.category) return standsBefore(tr(a.category), tr(b.category));
        return standsBefore(tr(a.name), tr(b.name));
    });
}

std::vector<LibraryEntry> Library::matching(std::string_view words) const {
    std::vector<std::string> wanted;
    std::istringstream stream(alphabetKey(words));
    for (std::string word; stream >> word;) wanted.push_back(word);
    std::vector<LibraryEntry> found;
    for (const LibraryEntry& entry : entries_) {
        const std::string text =
            alphabetKey(entry.name + "\n" + entry.category + "\n" + entry.description + "\n" +
                        tr(entry.name) + "\n" + tr(entry.category) + "\n" + tr(entry.description));
        if (std::all_of(wanted.begin(), wanted.end(), [&](const std::string& word) {
                return text.find(word) != std::string::npos;
            }))
            found.push_back(entry);
    }
    return found;
}

const LibraryEntry* Library::find(std::string_view name) const {
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const auto& one) { return one.name == name; });
    return found == entries_.end() ? nullptr : &*found;
}

Template Library::load(const LibraryEntry& entry) {
    return readTemplate(sulfur::scene::read(entry.file));
}

fs::path Library::save(const Template& made, bool besideScene) {
    if (besideScene && scene_.empty())
        throw std::runtime_error(
            "the scene has no folder yet; save it first, or keep the "
            "template among your own ones");
    const fs::path folder = besideScene ? scene_ / folderName : own_;
    std::error_code error;
    fs::create_directories(folder, error);
    // A template keeps its file, whatever that is called.
    const auto origin = besideScene ? LibraryEntry::Origin::scene : LibraryEntry::Origin::own;
    const LibraryEntry* known = find(made.name());
    const fs::path file = known != nullptr && known->origin == origin
                              ? known->file
                              : folder / fileNameOf(made.name());
    sulfur::scene::writeFile(textOf(made), file);
    rescan();
    return file;
}

void Library::remove(std::string_view name) {
    const LibraryEntry* entry = find(name);
    if (entry == nullptr) throw std::runtime_error(tr("there is no template \"{}\"", {name}));
    if (entry->origin == LibraryEntry::Origin::starter)
        throw std::runtime_error(tr("\"{}\" comes with the program and stays", {entry->name}));
    std::error_code error;
    if (!fs::remove(entry->file, error))
        throw std::runtime_error(
            tr("{} cannot be removed: {}", {entry->file.string(), error.message()}));
    rescan();
}

bool differsFromLibrary(const sulfur::scene::Scene& scene, const LibraryEntry& entry) {
    const auto own = definition(scene, entry.name);
    if (!own) return false;
    try {
        return textOf(*own) != textOf(Library::load(entry));
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace sulfurchamber
