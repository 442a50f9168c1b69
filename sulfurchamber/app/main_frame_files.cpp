// Files: new, open, save, recent ones, examples, settings.
#include <wx/config.h>
#include <wx/fileconf.h>
#include <wx/filedlg.h>
#include <wx/msgdlg.h>

#include <atlax/files.hpp>

#include "gallery.hpp"
#include "main_frame.hpp"

namespace sulfurchamber {
namespace {

constexpr const char* filter = "Scenes and levels (*.json)|*.json|All files|*";

}  // namespace

void MainFrame::adoptDocument() {
    bench_.cancel();
    bench_.select({});  // another world: its handles mean other bodies
    view_.zoomToFit();
    nextRefreshNs_ = 0;
}

bool MainFrame::openFile(const std::filesystem::path& file) {
    bench_.cancel();
    try {
        bench_.document().open(file);
    } catch (const std::exception& error) {
        tellInDialog(error.what(), "The file cannot be opened");
        return false;
    }
    adoptDocument();
    noteRecent(file);
    return true;
}

bool MainFrame::saveFile(const std::filesystem::path& file) {
    bench_.cancel();
    try {
        bench_.document().save(file);
    } catch (const std::exception& error) {
        tellInDialog(error.what(), "The scene cannot be saved");
        return false;
    }
    noteRecent(file);
    nextRefreshNs_ = 0;
    return true;
}

bool MainFrame::mayDiscard() {
    if (!bench_.document().modified() || options_.unattended()) return true;
    wxMessageDialog dialog(
        this, wxString::FromUTF8("Save the changes to " + bench_.document().name() + "?"),
        "SulfurChamber", wxYES_NO | wxCANCEL | wxICON_QUESTION);
    dialog.SetYesNoCancelLabels("Save", "Discard", "Cancel");
    switch (dialog.ShowModal()) {
        case wxID_YES:
            return save();
        case wxID_NO:
            return true;
        default:
            return false;
    }
}

void MainFrame::newFile() {
    if (!mayDiscard()) return;
    bench_.cancel();
    bench_.document().clear();
    adoptDocument();
}

void MainFrame::openDialog() {
    if (!mayDiscard()) return;
    wxFileDialog dialog(this, "Open a scene or a level", "", "", filter,
                        wxFD_OPEN | wxFD_FILE_MUST_EXIST);
    if (dialog.ShowModal() == wxID_OK) openFile(dialog.GetPath().utf8_string());
}

bool MainFrame::save() {
    const auto& file = bench_.document().file();
    return file.empty() ? saveDialog() : saveFile(std::filesystem::path(file));
}

bool MainFrame::saveDialog() {
    const auto& file = bench_.document().file();
    wxFileDialog dialog(
        this, "Save the scene", wxString::FromUTF8(file.parent_path().string()),
        file.empty() ? wxString("scene.json") : wxString::FromUTF8(file.filename().string()),
        filter, wxFD_SAVE | wxFD_OVERWRITE_PROMPT);
    return dialog.ShowModal() == wxID_OK && saveFile(dialog.GetPath().utf8_string());
}

void MainFrame::openRecent(int index) {
    const wxString file = recent_.GetHistoryFile(static_cast<std::size_t>(index));
    if (mayDiscard() && !openFile(file.utf8_string()))
        recent_.RemoveFileFromHistory(static_cast<std::size_t>(index));
}

void MainFrame::showGallery() {
    if (!mayDiscard()) return;
    const auto file = chooseExample(this);
    if (!file) return;
    // An example is a beginning: saving it asks for a name of one's own.
    bench_.cancel();
    try {
        bench_.document().adopt(sulfur::scene::read(*file));
    } catch (const std::exception& error) {
        tellInDialog(error.what(), "The example cannot be opened");
        return;
    }
    adoptDocument();
}

void MainFrame::loadSettings() {
    if (options_.unattended()) return;
    const auto folder = atlax::configFolder("sulfurchamber");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return;  // a home that cannot be written to: nothing is remembered
    settings_ = std::make_unique<wxFileConfig>(
        "sulfurchamber", "", wxString::FromUTF8((folder / "settings.ini").string()), "",
        wxCONFIG_USE_LOCAL_FILE);
    recent_.Load(*settings_);
    if (!bench_.document().file().empty()) noteRecent(bench_.document().file());
}

void MainFrame::noteRecent(const std::filesystem::path& file) {
    if (!settings_) return;
    std::error_code error;
    const auto whole = std::filesystem::absolute(file, error);
    recent_.AddFileToHistory(wxString::FromUTF8((error ? file : whole).string()));
    recent_.Save(*settings_);
    settings_->Flush();
}

}  // namespace sulfurchamber
