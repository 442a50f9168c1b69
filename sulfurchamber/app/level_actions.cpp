// The menu "Level": pieces to place, play-test, proof, publishing.
#include "level_panel.hpp"
#include "main_frame.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {

void MainFrame::addLevelActions() {
    const auto m = MenuId::level;
    add({"level-new", m, "&New level\tCtrl+Shift+N", 0,
         "Begin with a small level that can be played", "", [this] { newLevelFile(); }});
    add({"level-make", m, "&Make a level of this scene", 0,
         "Add a spawn, an exit and bounds about what there is", "",
         [this] {
             bench_.cancel();
             Document& document = bench_.document();
             document.reset();
             document.edit("Make a level", [&] { makeLevel(document); });
         },
         [this] { return !isLevel(bench_.document()); }});
    addPlacingActions();
    addPlayingActions();
    addProvingActions();
}

void MainFrame::addPlacingActions() {
    const auto level = [this] { return isLevel(bench_.document()); };
    for (const LevelPieceInfo& info : levelPieces()) {
        Action& action = add({"place-" + std::string(info.name), MenuId::level,
                              wxString::FromUTF8(info.label.data(), info.label.size()), 0,
                              std::string(info.hint), "",
                              [this, piece = info.piece] { bench_.setPlacing(piece); }, level,
                              [this, piece = info.piece] { return bench_.placing() == piece; }});
        action.under = "Place";
        action.separatorBefore = info.piece == LevelPiece::ground;
    }
}

void MainFrame::addPlayingActions() {
    const auto m = MenuId::level;
    const auto level = [this] { return isLevel(bench_.document()); };
    add({"level-play", m, "P&lay from the spawn\tF5", 0,
         "Play the level in this window; Esc goes back to editing", "",
         [this] {
             stage_->play();
             canvas_->SetFocus();
         },
         level})
        .separatorBefore = true;
    add({"level-play-here", m, "Play from the mo&use\tShift+F5", 0,
         "The same with the hero where the pointer is", "",
         [this] {
             const auto at = view_.pointer();
             stage_->play(at);
             canvas_->SetFocus();
         },
         level});
    add({"level-edit", m, "&Back to editing", 0, "End the play-test", "",
         [this] { stage_->endPlay(); }, [this] { return stage_->playing(); }});
}

void MainFrame::addProvingActions() {
    const auto m = MenuId::level;
    const auto level = [this] { return isLevel(bench_.document()); };
    const auto running = [this] {
        const SearchJob* job = stage_->desk().job();
        return job != nullptr && !job->progress().over();
    };
    add({"level-solve", m, "&Can it be finished?\tF6", 0,
         "Search for a way through the level, beside the editing", "",
         [this] {
             bench_.cancel();
             stage_->desk().search();
             stage_->setWayShown(true);
         },
         level})
        .separatorBefore = true;
    add({"level-stop", m, "&Stop the search\tShift+F6", 0, "Ends the search for a way", "",
         [this] { stage_->desk().stopSearch(); }, running});
    add({"level-medals", m, "Medals by the p&roof", 0, "Enter the times that the proof suggests",
         "",
         [this] {
             bench_.cancel();
             stage_->desk().takeMedals();
         },
         [this] { return stage_->desk().proof() == LevelDesk::Proof::holds; }});
    add({"level-problem", m, "Next pro&blem\tF7", 0, "Go to what is wrong and select it", "",
         [this] { stage_->goToNext(); }, [this] { return !stage_->desk().problems().empty(); }});
    add({"level-publish", m, "Pu&blish in the game", 0,
         "Put the level with its proof into the game's own menu", "", [this] { publishLevel(); },
         level});
    add({"level-picture", m, "As in the &game", 0, "Ground, bodies and sky as the game draws them",
         "", [this] { stage_->setPictured(!stage_->pictured()); }, level,
         [this] { return stage_->pictured(); }})
        .separatorBefore = true;
    add({"level-way", m, "The &way of the proof", 0,
         "Where the hero goes, and where the search has been", "",
         [this] { stage_->setWayShown(!stage_->wayShown()); }, level,
         [this] { return stage_->wayShown(); }});
    add({"page-level", m, "Page of the le&vel\tCtrl+7", 0,
         "Bring this page of the side panel to the front", "",
         [this] {
             showSide(true);
             side_->showPage("level");
         }})
        .separatorBefore = true;
}

void MainFrame::newLevelFile() {
    if (!mayDiscard()) return;
    bench_.cancel();
    bench_.document().adopt(newLevel());
    adoptDocument();
    showSide(true);
    side_->showPage("level");
}

void MainFrame::publishLevel() {
    bench_.cancel();
    const auto file = stage_->desk().publish(LevelDesk::gameFolder());
    const bool proven = stage_->desk().proof() == LevelDesk::Proof::holds;
    notify(tr(proven ? "The level is in the game's menu now, with its proof: {}"
                     : "The level is in the game's menu now, without a proof: {}",
              {file.string()}));
}

}  // namespace sulfurchamber
