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

bool wearsAny(const Workbench& bench) {
    const Document& document = bench.document();
    const auto& bodies = bench.selection();
    return std::any_of(bodies.begin(), bodies.end(), [&](sulfur::BodyId body) {
        const std::string id = document.idOf(body);
        return !id.empty() &&
               !skinOf(document.plan().prefab(document.plan().body(id).blueprint)).empty();
    });
}

// Handles stand around the picture of one body.
bool hasOnePicture(const Workbench& bench) {
    if (bench.selection().size() != 1 || !wearsAny(bench)) return false;
    const Document& document = bench.document();
    return mappingOf(document.plan().dressed(document.idOf(bench.selection().front()))).has_value();
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
    bench_.take(makeSkinTool(bench_, bench_.selection().front()));
}

void MainFrame::addSkinActions() {
    const auto m = MenuId::edit;
    const auto able = [this] {
        const auto& bodies = bench_.selection();
        return std::any_of(bodies.begin(), bodies.end(), [this](sulfur::BodyId body) {
            return canWear(bench_.document(), body);
        });
    };
    const auto dressed = [this] { return wearsAny(bench_); };
    const auto entry = [&](const char* name, const wxString& label, const char* help,
                           std::function<void()> run, std::function<bool()> enabled) {
        add({name, m, label, 0, help, "", std::move(run), std::move(enabled)}).under = "Skin";
    };
    entry(
        "skin-choose", wxString::FromUTF8("&Choose a picture\xE2\x80\xA6"),
        "A PNG, JPEG or SVG that the selected bodies wear",
        [this] {
            const auto file = canvas_->platform().chooseFile(
                {.title = tr("Choose a picture to wear"), .kinds = pictureKinds()});
            if (file) wearPicture(bench_.selection(), *file);
        },
        able);
    entry(
        "skin-place", "&Place it by handles",
        "Move, scale and turn the picture on the one body that is selected",
        [this] { placeSkin(); }, [this] { return hasOnePicture(bench_); });
    entry(
        "skin-fit", "&Fit it to the body", "The picture covers the body's whole rectangle",
        [this] {
            bench_.document().edit("Fit the skin", [this] {
                bench_.document().change(bench_.selection(), [](sulfur::scene::Prefab& prefab) {
                    if (const std::string texture = skinOf(prefab); !texture.empty())
                        wear(prefab, texture);
                });
            });
        },
        dressed);
    entry(
        "skin-remove", "&Remove it", "The usual colours again",
        [this] {
            bench_.document().edit("Remove the skin",
                                   [this] { undressAll(bench_.document(), bench_.selection()); });
        },
        dressed);
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
