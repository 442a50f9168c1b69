// Example scenes that come with the program, with pictures.
#pragma once

#include <wx/dialog.h>
#include <wx/imaglist.h>
#include <wx/listctrl.h>
#include <wx/stattext.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "../view/scene_view.hpp"

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
    /// `view` draws the pictures, one in each of its frames; it must outlive the window.
    GalleryDialog(wxWindow* parent, SceneView& view,
                  std::function<void(const std::filesystem::path&)> open);
    ~GalleryDialog() override;
    /// How many examples have their pictures by now.
    int pictures() const { return pictures_; }

private:
    void askPicture(std::size_t example);
    void tell();
    void openChosen();

    std::vector<Example> examples_;
    SceneView& view_;
    std::function<void(const std::filesystem::path&)> open_;
    wxImageList images_;
    wxListCtrl* list_ = nullptr;
    wxStaticText* text_ = nullptr;
    int pictures_ = 0;
};

}  // namespace sulfurchamber
