// What can be done with a file that is dropped on the drawing area.
#pragma once

#include <wx/string.h>

#include <filesystem>
#include <functional>
#include <string>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>

#include "../model/file_kind.hpp"

namespace sulfurchamber {

/// A file that was dropped.
struct DroppedFile {
    std::filesystem::path file;
    FileKind kind = FileKind::other;
    sulfur::Point place{0, 0};  ///< metres
    sulfur::BodyId under;       ///< the body at this place; null where there is none
};

/// One thing that can be done with it. Where several fit, a menu at the place asks.
struct DropUse {
    std::string name;  ///< for scripts: "open"
    wxString label;    ///< in that menu
    std::function<bool(const DroppedFile&)> fits;
    std::function<void(const DroppedFile&)> run;  ///< what it throws is told
};

}  // namespace sulfurchamber
