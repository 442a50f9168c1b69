// Skins: pictures that bodies wear, and where on a body they lie.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "document.hpp"

namespace sulfurchamber {

class Tool;
class Workbench;

/// Where a picture lies, in the frame of a blueprint.
struct SkinMapping {
    sulfur::Point centre{0, 0};  ///< metres
    sulfur::Point size{1, 1};    ///< metres, of the whole picture; negative mirrors it
    double angle = 0;            ///< radians, anticlockwise
    /// Lower left, lower right, upper right, upper left.
    std::array<sulfur::Point, 4> corners() const;
};

/// Limits of a mapping: texture coordinates stay within those of files.
struct SkinLimits {
    static constexpr double leastSize = 0.02;  ///< metres
    static constexpr double mostSize = 500;    ///< metres
};

/// The texture's name, "" where a body wears none.
std::string skinOf(const sulfur::scene::Prefab& prefab);
/// Nothing where a body wears none, or one that no rectangle says.
std::optional<SkinMapping> mappingOf(const sulfur::scene::Prefab& prefab);
/// Whether a picture can lie on it: discs and what has triangles.
bool canWear(const sulfur::scene::Prefab& prefab);
/// The same of a body of a document; what is of the moment alone cannot.
bool canWear(const Document& document, sulfur::BodyId body);
/// Dresses a body; the picture covers its bounding rectangle. Throws std::runtime_error for a name
/// that files refuse, and for a body that has no inside.
void wear(sulfur::scene::Prefab& prefab, const std::string& texture);
/// Puts the picture elsewhere. Throws std::runtime_error when the mapping is out of its limits.
void setMapping(sulfur::scene::Prefab& prefab, const SkinMapping& mapping);
void undress(sulfur::scene::Prefab& prefab);

// The same for bodies of a document, as a part of the open edit; those that cannot wear one are
// left alone. wearAll() throws std::runtime_error when none can.
void wearAll(Document& document, std::span<const sulfur::BodyId> bodies,
             const std::string& texture);
void undressAll(Document& document, std::span<const sulfur::BodyId> bodies);

/// Moves, scales and turns the picture of a body by handles: its frame moves it, its corners scale
/// it, its knob turns it.
std::unique_ptr<Tool> makeSkinTool(Workbench& bench, sulfur::BodyId body);

/// Where pictures lie and whither new ones are copied. Plain value.
class SkinStore {
public:
    /// The user's folder, and folders of the program, which are asked last.
    SkinStore(std::filesystem::path own, std::vector<std::filesystem::path> programs);

    /// The file of a texture of a scene that lies in a folder (empty: it has none). Empty: there is
    /// none.
    std::filesystem::path find(const std::string& texture,
                               const std::filesystem::path& sceneFolder) const;
    /// Makes a picture usable for scenes: what does not lie below the scene's folder is copied to
    /// the user's. Returns the texture's name. Throws std::runtime_error for what is no PNG, JPEG
    /// or SVG, or cannot be read.
    std::string adopt(const std::filesystem::path& picture,
                      const std::filesystem::path& sceneFolder) const;
    /// Copies what a scene wears of the user's folder beside its file, so that it goes with it.
    /// Returns what could not be copied, one sentence each.
    std::vector<std::string> copyBeside(const sulfur::scene::Scene& scene,
                                        const std::filesystem::path& sceneFolder) const;

private:
    std::filesystem::path own_;
    std::vector<std::filesystem::path> programs_;
};

/// Whether a file's name says that it is a picture that can be worn.
bool isPicture(const std::filesystem::path& file);

}  // namespace sulfurchamber
