// Files of results.
#pragma once

#include <filesystem>
#include <string>

namespace sulfur::lab {

/// Writes beside `file` and renames, through links: whatever ends the program, there is the old
/// file or the new one, whole. Signals that would end it wait until nothing stands beside it any
/// more. Throws std::runtime_error where that cannot be done or `file` is a pipe, a device or a
/// folder.
void writeWhole(const std::filesystem::path& file, const std::string& text);

}  // namespace sulfur::lab
