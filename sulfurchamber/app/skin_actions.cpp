// The actions of skins, also of pictures that are dropped on bodies.
#include <algorithm>
#include <atlax/backend.hpp>

#include "../model/skins.hpp"
#include "../model/tool.hpp"
#include "main_frame.hpp"
#include "program_files.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

std::vector<atlax::FileKind> pictureKinds() {
    return {{tr("Pictures"), {"svg", "png", "jpg", "jpeg"}}, {tr("All files"), {}}};
}

}  // namespace

void MainFrame::wearPicture(const std::vector<sulfur::BodyId>& bodies,
                            const std::filesystem::path& file) {
    const auto folder = bench_.document().file().parent_path();
    const std::string texture = skinStore().adopt(file, folder);
    bench_.cancel();
    bench_.document().edit(tr("Wear {}", {file.filename().string()}),
                           [&] { wearAll(bench_.document(), bodies, texture); });
}

bool MainFrame::wearFile(const std::filesystem::path& file) {
    try {
        wearPicture(bench_.selection(), file);
    } catch (const std::exception& problem) {
        tell(problem.what());
        return false;
    }
    return true;
}

void MainFrame::placeSkin() {
    const auto& selection = bench_.selection();
    if (selection.size() != 1) throw std::runtime_error("one body must be selected for that");
    const std::string id = bench_.document().idOf(selection.front());
    if (id.empty() || !mappingOf(bench_.document().plan().dressed(id)))
        throw std::runtime_error("the selected body wears no picture that could be placed");
    bench_.take(makeSkinTool(bench_, selection.front()));
}

void MainFrame::addSkinActions() {
    const auto m = MenuId::edit;
    const auto any = [this] { return !bench_.selection().empty(); };
    const auto entry = [&](const char* name, const wxString& label, const char* help,
                           std::function<void()> run) {
        add({name, m, label, 0, help, "", std::move(run), any}).under = "Skin";
    };
    entry("skin-choose", wxString::FromUTF8("&Choose a picture\xE2\x80\xA6"),
          "A PNG, JPEG or SVG that the selected bodies wear", [this] {
              const auto file = canvas_->platform().chooseFile(
                  {.title = tr("Choose a picture to wear"), .kinds = pictureKinds()});
              if (file) wearPicture(bench_.selection(), *file);
          });
    entry("skin-place", "&Place it by handles",
          "Move, scale and turn the picture on the selected body", [this] { placeSkin(); });
    entry("skin-fit", "&Fit it to the body", "The picture covers the body's whole rectangle",
          [this] {
              bench_.document().edit("Fit the skin", [this] {
                  bench_.document().change(bench_.selection(), [](sulfur::scene::Prefab& prefab) {
                      if (const std::string texture = skinOf(prefab); !texture.empty())
                          wear(prefab, texture);
                  });
              });
          });
    entry("skin-remove", "&Remove it", "The usual colours again", [this] {
        bench_.document().edit("Remove the skin",
                               [this] { undressAll(bench_.document(), bench_.selection()); });
    });
}

// A picture is worn by the body on which it falls.
void MainFrame::addSkinDropUse() {
    const auto fits = [](const DroppedFile& dropped) {
        return dropped.under && isPicture(dropped.file);
    };
    dropUses_.push_back({"wear", "&Wear it", fits, [this](const DroppedFile& dropped) {
                             const std::string id = bench_.document().idOf(dropped.under);
                             wearPicture({dropped.under}, dropped.file);
                             if (const auto now = bench_.document().bodyOf(id))
                                 bench_.select({now});
                         }});
}

}  // namespace sulfurchamber
