// Saving a file that somebody has written by hand: what was not changed keeps its bytes.
#pragma once

#include <string>

namespace sulfurchamber {

/// The text `now` of a scene in the layout of the file from which it was opened. `before` is the
/// text that the program made of the file when it was opened: members, blueprints and bodies that
/// are the same in `before` and `now` stay as the file has them. Where that is not possible, such
/// as after a change of their order, it is `now`. For small files: takes the square of the bodies.
std::string keepLayout(const std::string& file, const std::string& before, const std::string& now);

}  // namespace sulfurchamber
