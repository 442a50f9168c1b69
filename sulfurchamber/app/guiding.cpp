// What the menus do for beginners: lessons, films of tools, examples.
#include <wx/aui/auibar.h>

#include <atlax/backend.hpp>

#include "main_frame.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

constexpr std::int64_t dwellNs = 350'000'000;  // before a film begins under the pointer

}  // namespace

void MainFrame::addHelpActions() {
    const auto m = MenuId::help;
    add({"gallery", m, wxString::FromUTF8("&Example scenes\xE2\x80\xA6\tF1"), 0,
         "A gallery of things to play with", "", [this] { showGallery(); }});
    for (const Lesson& lesson : lessons())
        add({"lesson-" + std::string(lesson.name),
             m,
             lesson.title,
             0,
             lesson.about,
             "",
             [this, &lesson] { startLesson(lesson); },
             {},
             [this, &lesson] {
                 return lesson_->running() && &lesson_->run()->lesson() == &lesson;
             }})
            .under = "Lessons";
    const auto running = [this] { return lesson_->running() && !lesson_->run()->finished(); };
    add({"lesson-show", m, "&Show me the step", 0, "A hand does what the lesson asks for", "",
         [this] { lesson_->showStep(); }, running})
        .under = "Lessons";
    add({"lesson-skip", m, "S&kip the step", 0, "Go on with the lesson", "",
         [this] { lesson_->skipStep(); }, running})
        .under = "Lessons";
    add({"lesson-end", m, "&End the lesson", 0, "What was built stays", "",
         [this] { lesson_->stop(); }, [this] { return lesson_->running(); }})
        .under = "Lessons";
    add({"demo",
         m,
         "How this &tool works",
         '?',
         "A film of three seconds",
         "",
         [this] {
             const bool on = view_.guide().film().has_value();
             if (on)
                 view_.guide().showFilm({});
             else
                 view_.guide().showFilm(bench_.tool(), filmName(bench_.tool()));
         },
         {},
         [this] { return view_.guide().film().has_value(); }});
    add({"films",
         m,
         "&Films of the tools",
         0,
         "A tool under the pointer shows in three seconds what it does",
         "",
         [this] { view_.options().films = !view_.options().films; },
         {},
         [this] { return view_.options().films; }});
    addLanguageActions();
    add({"about", m, "&About SulfurChamber", 0, "Version and licence", "", [this] { about(); }});
}

void MainFrame::startLesson(const Lesson& lesson) {
    if (!mayDiscard()) return;
    bench_.cancel();
    bench_.document().clear();
    adoptDocument();
    view_.setSpeedPermille(1000);
    lesson_->start(lesson);
}

// A tool's button under the pointer begins its film after a moment; elsewhere it ends.
void MainFrame::watchPalette(wxAuiToolBar& bar) {
    bar.Bind(wxEVT_MOTION, [this, &bar](wxMouseEvent& event) {
        event.Skip();
        const wxAuiToolBarItem* item = bar.FindToolByPosition(event.GetX(), event.GetY());
        std::optional<ToolKind> tool;
        for (const Action& action : actions_)
            if (item != nullptr && action.id == item->GetId() && action.name.starts_with("tool-"))
                tool = toolFromName(action.name.substr(5));
        pointAtTool(tool);
    });
    bar.Bind(wxEVT_LEAVE_WINDOW, [this](wxMouseEvent& event) {
        event.Skip();
        pointAtTool({});
    });
}

void MainFrame::pointAtTool(std::optional<ToolKind> tool) {
    if (tool == pointedTool_) return;
    pointedTool_ = tool;
    pointedNs_ = atlax::monotonicNs();
    if (!tool) view_.guide().showFilm({});
}

void MainFrame::refreshGuide() {
    lesson_->refresh();
    if (!pointedTool_ || !view_.options().films || view_.guide().film() == pointedTool_ ||
        atlax::monotonicNs() < pointedNs_ + dwellNs)
        return;
    secondPalette_->UnsetToolTip();  // it would hide the film, which says the same
    view_.guide().showFilm(pointedTool_, filmName(*pointedTool_));
}

// As the menu has it: "Bridge  (U)".
std::string MainFrame::filmName(ToolKind tool) const {
    for (const Action& action : actions_)
        if (action.name == "tool-" + std::string(toolName(tool)))
            return withKey(wxMenuItem::GetLabelText(action.label.BeforeFirst('\t')), action)
                .utf8_string();
    return "";
}

std::optional<wxPoint> MainFrame::buttonOnScreen(const std::string& name) const {
    for (const Action& action : actions_) {
        if (action.name != name) continue;
        for (const wxAuiToolBar* bar : {toolBar_, palette_, secondPalette_}) {
            if (bar->FindTool(action.id) == nullptr) continue;
            const wxRect place = bar->GetToolRect(action.id);
            return bar->ClientToScreen(place.GetTopLeft() + place.GetSize() / 2);
        }
    }
    return std::nullopt;
}

}  // namespace sulfurchamber
