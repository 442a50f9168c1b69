// Files that are dropped on the drawing area.
#include <wx/menu.h>

#include <algorithm>
#include <atlax/files.hpp>

#include "../model/geometry.hpp"
#include "../model/rube.hpp"
#include "main_frame.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

constexpr std::size_t mostSceneBytes = std::size_t{64} << 20;

}  // namespace

// The table: who has another use for files adds a line. The first that fits is the default.
void MainFrame::makeDropUses() {
    addSkinDropUse();
    addTemplateDropUse();
    const auto isScene = [](const DroppedFile& dropped) {
        return dropped.kind == FileKind::scene || dropped.kind == FileKind::rube;
    };
    dropUses_.push_back(
        {"open", wxTr("&Open this scene"), isScene, [this](const DroppedFile& dropped) {
             if (mayDiscard()) openFile(dropped.file);
         }});
    dropUses_.push_back(
        {"add", wxTr("&Add its bodies here"), isScene, [this](const DroppedFile& dropped) {
             bench_.pasteAt(dropped.kind == FileKind::rube
                                ? sulfur::scene::format(readRube(dropped.file).scene)
                                : atlax::readFile(dropped.file, mostSceneBytes),
                            dropped.place);
         }});
    dropUses_.push_back(
        {"outline", wxTr("Bodies from its ou&tlines\xE2\x80\xA6"),
         [](const DroppedFile& dropped) {
             return dropped.kind == FileKind::drawing || dropped.kind == FileKind::picture;
         },
         [this](const DroppedFile& dropped) { importDialog(dropped.file, dropped.place); }});
}

void MainFrame::dropFile(const std::filesystem::path& file, const std::string& use) {
    bench_.cancel();
    DroppedFile dropped;
    dropped.file = file;
    dropped.place = view_.pointer().value_or(sulfur::Point(0, 0));
    dropped.under = bodyAt(bench_.document().world(), dropped.place, 0);
    try {
        dropped.kind = kindOfFile(file);
        std::vector<const DropUse*> fitting;
        for (const DropUse& one : dropUses_)
            if (one.fits(dropped) && (use.empty() || one.name == use)) fitting.push_back(&one);
        if (fitting.empty())
            throw std::runtime_error(tr(use.empty() ? "{}: nothing can be made of such a file"
                                                    : "{}: this cannot be made of such a file",
                                        {file.filename().string()}));
        if (const DropUse* chosen = chooseDropUse(fitting)) chosen->run(dropped);
    } catch (const std::exception& error) {
        tell(error.what());
    }
    nextRefreshNs_ = 0;
}

// The first one where nobody can be asked; none when the menu was left.
const DropUse* MainFrame::chooseDropUse(const std::vector<const DropUse*>& fitting) {
    if (fitting.size() == 1 || options_.unattended()) return fitting.front();
    wxMenu menu;
    for (std::size_t i = 0; i < fitting.size(); ++i)
        menu.Append(static_cast<int>(i) + 1, fitting[i]->label);
    const int chosen = GetPopupMenuSelectionFromUser(menu);
    return chosen < 1 ? nullptr : fitting[static_cast<std::size_t>(chosen) - 1];
}

}  // namespace sulfurchamber
