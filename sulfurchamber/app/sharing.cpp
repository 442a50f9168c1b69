// Scenes that go elsewhere: as text, as source, as a film.
#include <atlax/files.hpp>

#include "../model/share_text.hpp"
#include "main_frame.hpp"

namespace sulfurchamber {

void MainFrame::addShareActions() {
    const auto m = MenuId::file;
    add({"copy-scene", m, "&Copy the scene as text\tCtrl+Shift+C", 0,
         "Put the whole scene into the clipboard, as a text for chats, mail or another window", "",
         [this] { canvas_->platform().setClipboard(shareText(bench_.document().planScene())); }})
        .separatorBefore = true;
    add({"open-text", m, "Open the scene in the clip&board\tCtrl+Shift+V", 0,
         "Open a scene that was copied as text", "", [this] { openShared(); }});
    add({"export-cpp", m, wxString::FromUTF8("Export as C&++ source\xE2\x80\xA6"), 0,
         "The selection, or the whole scene, as a program for libsulfur", "",
         [this] { exportCppDialog(); }});
    add({"film", m, wxString::FromUTF8("&Film of the last 10 s\xE2\x80\xA6"), 0,
         "An animated picture (PNG) of what has just happened, as it is seen now", "",
         [this] { filmDialog(); },
         [this] { return !bench_.document().timeline().empty() && !view_.filmProgress(); }});
}

// It is a beginning, as an example is: saving asks for a name.
void MainFrame::openShared() {
    const std::string text = canvas_->platform().clipboard();
    auto scene = parseShareText(text);
    if (!mayDiscard()) return;
    bench_.cancel();
    bench_.document().adopt(std::move(scene));
    adoptDocument();
}

bool MainFrame::exportCpp(const std::filesystem::path& file) {
    try {
        atlax::writeFileAtomic(file, bench_.cppSource());
    } catch (const std::exception& error) {
        tellInDialog(error.what(), "The source cannot be written");
        return false;
    }
    return true;
}

void MainFrame::exportCppDialog() {
    const auto& file = bench_.document().file();
    const auto chosen = canvas_->platform().chooseFile(
        {.title = tr("Export as C++ source"),
         .save = true,
         .folder = file.parent_path(),
         .name = (file.empty() ? "scene" : file.stem().string()) + ".cpp",
         .kinds = {{tr("C++ source"), {"cpp"}}}});
    if (chosen) exportCpp(*chosen);
}

void MainFrame::makeFilm(const std::filesystem::path& file) {
    view_.startFilm(file);
}

void MainFrame::filmDialog() {
    const auto& file = bench_.document().file();
    const auto chosen = canvas_->platform().chooseFile(
        {.title = tr("Film of the last 10 s"),
         .save = true,
         .folder = file.parent_path(),
         .name = (file.empty() ? "scene" : file.stem().string()) + "-film.png",
         .kinds = {{tr("Animated pictures"), {"png"}}}});
    if (chosen) makeFilm(*chosen);
}

}  // namespace sulfurchamber
