// Scenes that are chosen by their pictures, such as the examples that come with the program.
#pragma once

#include <wx/dialog.h>
#include <wx/stattext.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "picture_grid.hpp"

namespace sulfurchamber {

struct Example {
    std::filesystem::path file;
    std::string title;        ///< in English, as the next
    std::string description;  ///< what it teaches
};

/// All that can be read, by title in the language of the user.
std::vector<Example> findExamples();

/// A window beside the program's: what is chosen in it is opened, and it goes.
class GalleryDialog final : public wxDialog {
public:
    /// The frames of a SceneView draw the pictures, which must outlive the window.
    GalleryDialog(wxWindow* parent, const wxString& title, std::vector<PictureGrid::Item> items,
                  Thumbnails& thumbnails, std::function<void(const std::filesystem::path&)> open);
    /// How many scenes have their pictures by now.
    std::size_t pictures() const;

private:
    void bind();
    void tell();
    void openChosen();

    Thumbnails& thumbnails_;
    std::function<void(const std::filesystem::path&)> open_;
    PictureGrid* grid_ = nullptr;
    wxStaticText* text_ = nullptr;
};

}  // namespace sulfurchamber
