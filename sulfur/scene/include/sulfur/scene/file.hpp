/// \file
/// Scenes and blueprints to and from files. The format is version 1 of scene.schema.json.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sulfur/scene/scene.hpp>

namespace sulfur::scene {

/// A file that could not be written. The file that was there before is as it was.
class WriteError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reads a scene, checking all of it first: instantiate() takes what comes back. Throws ReadError.
Scene read(const std::filesystem::path& file);
/// The same from a text; `fileName` is for messages.
Scene parse(std::string_view text, std::string fileName);

/// The scene as the text of a file. parse(format(s)) gives s again, number for number, and
/// format(parse(t)) == t for every text t that format made.
std::string format(const Scene& scene);

/// Writes a new file beside `file`, brings it to the disk, then renames it; what was there before
/// is kept as `file` with ".bak" added. Throws ReadError, leaving everything as it was, when the
/// scene is one that read() would refuse, and WriteError when the disk refuses.
void write(const Scene& scene, const std::filesystem::path& file);

/// The same for one blueprint in a file of its own.
Prefab readBlueprint(const std::filesystem::path& file);
/// The same from a text; `fileName` is for messages.
Prefab parseBlueprint(std::string_view text, std::string fileName);
/// The text of a blueprint file.
std::string format(const Prefab& prefab);
/// Writes a blueprint file, as write() does a scene.
void writeBlueprint(const Prefab& prefab, const std::filesystem::path& file);

/// Writes any text in this safe way: new file, fsync, rename, one backup. Throws WriteError.
void writeFile(const std::string& text, const std::filesystem::path& file);

}  // namespace sulfur::scene
