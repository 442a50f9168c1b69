// Example scenes that come with the program.
#pragma once

#include <wx/window.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sulfurchamber {

struct Example {
    std::filesystem::path file;
    std::string title;
    std::string description;
};

/// All that can be read, by title.
std::vector<Example> findExamples();

/// Lets one be chosen; nothing when the dialog was cancelled or there are none.
std::optional<std::filesystem::path> chooseExample(wxWindow* parent);

}  // namespace sulfurchamber
