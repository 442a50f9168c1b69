// A whole scene as a text for clipboards, chats and mail.
#pragma once

#include <string>
#include <string_view>
#include <sulfur/scene.hpp>

namespace sulfurchamber {

/// One word of letters: "sulfur-scene-1:", then the scene, compressed, with a checksum. A scene of
/// some dozen bodies has a few kB.
std::string shareText(const sulfur::scene::Scene& scene);

/// Whether a text holds such a word.
bool isShareText(std::string_view text);

/// The scene of such a word, which may stand in the middle of other text and be broken into lines.
/// Throws std::runtime_error that says why not: it is cut short or changed, of a newer version, or
/// sulfur::scene::ReadError as for a file.
sulfur::scene::Scene parseShareText(std::string_view text);

}  // namespace sulfurchamber
