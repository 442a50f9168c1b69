// Files: new, open, save, recent ones, examples, settings.
#include <wx/msgdlg.h>

#include <atlax/backend.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>

#include "../model/rube.hpp"
#include "gallery.hpp"
#include "main_frame.hpp"
#include "program_files.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

std::filesystem::path recoveryFolder() {
    return atlax::stateFolder("sulfurchamber") / "recovery";
}

std::vector<atlax::FileKind> fileKinds() {
    return {{tr("Scenes and levels"), {"json"}}, {tr("All files"), {}}};
}

}  // namespace

void MainFrame::adoptDocument() {
    bench_.cancel();
    bench_.select({});  // another world: its handles mean other bodies
    bench_.clearMeasurements();
    stage_->opened();
    lesson_->stop();  // it was about another scene
    view_.zoomToFit();
    toldNearlyFull_ = false;
    nextRefreshNs_ = 0;
}

bool MainFrame::openFile(const std::filesystem::path& file) {
    bench_.cancel();
    std::vector<std::string> leftOut;
    try {
        if (std::filesystem::is_regular_file(file) && kindOfFile(file) == FileKind::rube) {
            RubeScene imported = readRube(file);
            bench_.document().adopt(std::move(imported.scene));
            leftOut = std::move(imported.leftOut);
        } else {
            bench_.document().open(file);
        }
    } catch (const std::exception& error) {
        tellInDialog(error.what(), "The file cannot be opened");
        return false;
    }
    adoptDocument();
    noteRecent(file);
    std::string all;
    for (const std::string& one : leftOut) all += (all.empty() ? "" : ", ") + one;
    if (!all.empty()) notify(tr("This was left out: {}", {all}));
    return true;
}

bool MainFrame::saveFile(const std::filesystem::path& file) {
    bench_.cancel();
    try {
        bench_.document().save(file);
        // What it wears goes with it.
        for (const std::string& problem :
             skinStore().copyBeside(bench_.document().scene(), file.parent_path()))
            tell(problem);
    } catch (const std::exception& error) {
        tellInDialog(error.what(), "The scene cannot be saved");
        return false;
    }
    saveProof();
    noteRecent(file);
    nextRefreshNs_ = 0;
    return true;
}

// The proof of a level lies beside it.
void MainFrame::saveProof() {
    try {
        stage_->desk().saved();
    } catch (const std::exception& error) {
        tell(error.what());
    }
}

bool MainFrame::saveMoment(const std::filesystem::path& file) {
    bench_.cancel();
    try {
        bench_.document().saveMoment(file);
    } catch (const std::exception& error) {
        tellInDialog(error.what(), "The moment cannot be saved");
        return false;
    }
    noteRecent(file);
    return true;
}

void MainFrame::saveMomentDialog() {
    const auto& file = bench_.document().file();
    const auto chosen = canvas_->platform().chooseFile(
        {.title = tr("Save this moment as a new scene"),
         .save = true,
         .folder = file.parent_path(),
         .name = file.empty() ? "moment.json" : file.stem().string() + "-moment.json",
         .kinds = fileKinds()});
    if (chosen) saveMoment(*chosen);
}

bool MainFrame::mayDiscard() {
    if (!bench_.document().modified() || options_.unattended()) return true;
    wxMessageDialog dialog(this, wxTr("Save the changes to “{}”?", {tr(bench_.document().name())}),
                           "SulfurChamber", wxYES_NO | wxCANCEL | wxICON_QUESTION);
    dialog.SetYesNoCancelLabels(wxTr("&Save"), wxTr("&Discard"), wxTr("&Cancel"));
    switch (dialog.ShowModal()) {
        case wxID_YES:
            return save();
        case wxID_NO:
            return true;
        default:
            return false;
    }
}

void MainFrame::keepUnsaved() {
    if (!recovery_ || atlax::monotonicNs() < nextKeepNs_) return;
    nextKeepNs_ = atlax::monotonicNs() + options_.autosave * std::int64_t{1'000'000'000};
    if (bench_.document().editing()) return;
    const std::string problem = recovery_->keep(bench_.document());
    if (!problem.empty()) atlax::log(atlax::LogLevel::Warning, problem);
}

// What a program that ended without asking has left. A file on the command line comes first: then
// it is offered the next time.
void MainFrame::offerRecovery() {
    if (!recovery_ || !bench_.document().file().empty() || bench_.document().modified()) return;
    const auto found = Recovery::left(recoveryFolder());
    if (found.empty()) return;
    const auto& left = found.front();
    const std::string name = left.of.empty() ? tr("a new scene") : left.of.filename().string();
    wxMessageDialog dialog(this, wxTr("SulfurChamber ended before {} was saved.", {name}),
                           "SulfurChamber", wxYES_NO | wxCANCEL | wxICON_QUESTION);
    dialog.SetExtendedMessage(wxTr("What was built had been kept. It can be opened now."));
    dialog.SetYesNoCancelLabels(wxTr("&Open it"), wxTr("&Delete it"), wxTr("&Later"));
    const int answer = dialog.ShowModal();
    if (answer == wxID_CANCEL) return;
    if (answer == wxID_YES) {
        try {
            bench_.document().recover(left.kept, left.of);
        } catch (const std::exception& error) {
            tellInDialog(error.what(), "What was kept cannot be opened");
            return;
        }
        adoptDocument();
        // It is kept anew before the old file goes.
        nextKeepNs_ = 0;
        keepUnsaved();
    }
    Recovery::discard(left);
}

void MainFrame::newFile() {
    if (!mayDiscard()) return;
    bench_.cancel();
    bench_.document().clear();
    adoptDocument();
}

void MainFrame::openDialog() {
    if (!mayDiscard()) return;
    const auto file = canvas_->platform().chooseFile(
        {.title = tr("Open a scene or a level"), .kinds = fileKinds()});
    if (file) openFile(*file);
}

bool MainFrame::save() {
    const auto& file = bench_.document().file();
    return file.empty() ? saveDialog() : saveFile(std::filesystem::path(file));
}

bool MainFrame::saveDialog() {
    const auto& file = bench_.document().file();
    const auto chosen = canvas_->platform().chooseFile(
        {.title = tr("Save the scene"),
         .save = true,
         .folder = file.parent_path(),
         .name = file.empty() ? "scene.json" : file.filename().string(),
         .kinds = fileKinds()});
    return chosen && saveFile(*chosen);
}

void MainFrame::openRecent(int index) {
    openRecentFile(recent_.GetHistoryFile(static_cast<std::size_t>(index)).utf8_string());
}

// What is no longer there leaves the list.
void MainFrame::openRecentFile(const std::filesystem::path& file) {
    if (!mayDiscard() || openFile(file)) return;
    for (std::size_t i = 0; i < recent_.GetCount(); ++i)
        if (recent_.GetHistoryFile(i).utf8_string() == file.string()) {
            recent_.RemoveFileFromHistory(i);
            break;
        }
    if (preferences_) preferences_->forgetFile(file);
}

void MainFrame::showRecent() {
    std::vector<PictureGrid::Item> items;
    for (std::size_t i = 0; i < recent_.GetCount(); ++i) {
        const std::filesystem::path file = recent_.GetHistoryFile(i).utf8_string();
        items.push_back({"", file.stem().string(), "", file.string(), file, false});
    }
    showScenes(wxTr("Recent scenes"), std::move(items),
               [this](const std::filesystem::path& file) { openRecentFile(file); });
}

void MainFrame::showGallery() {
    std::vector<PictureGrid::Item> items;
    for (const Example& one : findExamples())
        items.push_back({"", one.title, tr(one.title), tr(one.description), one.file, false});
    showScenes(wxTr("Example scenes"), std::move(items),
               [this](const std::filesystem::path& file) { openExample(file); });
}

// One such window at a time.
void MainFrame::showScenes(const wxString& title, std::vector<PictureGrid::Item> items,
                           std::function<void(const std::filesystem::path&)> open) {
    if (gallery_ != nullptr && gallery_->GetTitle() != title) {
        delete gallery_;
        gallery_ = nullptr;
    }
    if (gallery_ == nullptr) {
        gallery_ = new GalleryDialog(this, title, std::move(items), thumbnails_, std::move(open));
        gallery_->Bind(wxEVT_DESTROY, [this](wxWindowDestroyEvent& event) {
            if (event.GetEventObject() == gallery_) gallery_ = nullptr;
            event.Skip();
        });
    }
    gallery_->Show();
    gallery_->Raise();
}

// An example is a beginning: saving it asks for a name of one's own.
void MainFrame::openExample(const std::filesystem::path& file) {
    if (!mayDiscard()) return;
    bench_.cancel();
    try {
        bench_.document().adopt(sulfur::scene::read(file));
    } catch (const std::exception& error) {
        tellInDialog(error.what(), "The example cannot be opened");
        return;
    }
    adoptDocument();
}

void MainFrame::loadPreferences() {
    if (options_.unattended()) return;
    recovery_.emplace(recoveryFolder());
    nextKeepNs_ = atlax::monotonicNs() + options_.autosave * std::int64_t{1'000'000'000};
    CallAfter([this] { offerRecovery(); });
    preferences_.emplace(Preferences::settingsFile());
    view_.options() = preferences_->viewOptions();
    view_.snapping() = preferences_->snapping();
    const auto files = preferences_->recentFiles();
    for (auto file = files.rbegin(); file != files.rend(); ++file)
        recent_.AddFileToHistory(wxString::FromUTF8(file->string()));
    if (!bench_.document().file().empty()) noteRecent(bench_.document().file());
}

void MainFrame::savePreferences() {
    if (!preferences_) return;
    if (!IsFullScreen() && !IsIconized()) {
        preferences_->setMaximised(IsMaximized());
        const wxSize size = GetSize();
        if (!IsMaximized()) preferences_->setWindowSize({size.GetWidth(), size.GetHeight()});
    }
    preferences_->setViewOptions(view_.options());
    preferences_->setSnapping(view_.snapping());
    preferences_->save();
}

void MainFrame::noteRecent(const std::filesystem::path& file) {
    if (!preferences_) return;
    std::error_code error;
    const auto absolute = std::filesystem::absolute(file, error);
    const std::filesystem::path whole = error ? file : absolute;
    recent_.AddFileToHistory(wxString::FromUTF8(whole.string()));
    preferences_->noteFile(whole);
    preferences_->save();
}

}  // namespace sulfurchamber
