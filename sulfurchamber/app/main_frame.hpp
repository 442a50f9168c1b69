// The window: menus, bars, panels, and the drawing area in the middle.
#pragma once

#include <wx/aui/auibar.h>
#include <wx/aui/framemanager.h>
#include <wx/filehistory.h>
#include <wx/frame.h>
#include <wx/infobar.h>
#include <wx/panel.h>
#include <wx/stattext.h>
#include <wx/weakref.h>

#include <atlax/wx/view.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "../level/level_stage.hpp"
#include "../model/drawing.hpp"
#include "../model/recovery.hpp"
#include "../model/template_desk.hpp"
#include "../view/scene_view.hpp"
#include "../view/thumbnails.hpp"
#include "drop_use.hpp"
#include "gallery.hpp"
#include "lesson_panel.hpp"
#include "options.hpp"
#include "plot_panel.hpp"
#include "preferences.hpp"
#include "side_panel.hpp"
#include "table4_window.hpp"
#include "time_bar.hpp"

namespace sulfurchamber {

class LevelPanel;

enum class MenuId : std::uint8_t { file, edit, tools, view, simulation, measure, level, help };

/// In a key of an action: it is held together with these.
inline constexpr int withShift = 1 << 16;
inline constexpr int withControl = 1 << 17;
inline constexpr int withAlt = 1 << 18;

/// Something that one can do from a menu, with a key, on a bar, or from a script.
struct Action {
    std::string name;  ///< for scripts: "play", "tool-box"
    MenuId menu = MenuId::file;
    wxString label;    ///< with '&', and '\t' before an accelerator with modifiers
    /// A key with `withShift` and the like, handled only outside of text fields and menus.
    int plainKey = 0;
    std::string help;  ///< one line for the tooltip
    std::string icon;  ///< on a bar when not empty
    std::function<void()> run;
    std::function<bool()> enabled = {};  ///< empty: always
    std::function<bool()> checked = {};  ///< not empty: has a check mark
    bool separatorBefore = false;
    wxString under = {};  ///< the menu in the menu, if it is in one
    int id = 0;
};

class MainFrame final : public wxFrame {
public:
    /// `bench` must outlive the frame.
    MainFrame(Workbench& bench, const Options& options);
    ~MainFrame() override;

    Workbench& bench() { return bench_; }
    SceneView& sceneView() { return view_; }
    atlax::wx::View& canvas() { return *canvas_; }
    const TimeBar& timeBar() const { return *timeBar_; }
    PlotPanel& plot() { return *plot_; }
    LevelStage& stage() { return *stage_; }
    SidePanel& side() { return *side_; }
    /// The mouse was pressed: no menu is open, and nobody walks through the side panel with keys.
    void leaveKeys() { openMenus_.clear(), walksPanel_ = false; }
    /// The experiment that is open, or null.
    Table4Window* table4() { return table4_.get(); }
    OutlinePanel& outline() { return side_->outline(); }
    LessonPanel& lesson() { return *lesson_; }
    /// Null while it is not shown.
    GalleryDialog* gallery() { return gallery_; }
    /// The middle of an action's button on a bar, in pixels of the screen.
    std::optional<wxPoint> buttonOnScreen(const std::string& name) const;
    TemplateDesk& templates() { return desk_; }
    Thumbnails& thumbnails() { return thumbnails_; }
    /// The measurements as a picture (.png) or a table; the reason of a failure is shown.
    bool savePlot(const std::filesystem::path& file);

    /// Runs the action of this name; false when there is none or it is not available now.
    bool perform(const std::string& name);
    /// Opens a file without asking about unsaved changes. A file that cannot be read changes
    /// nothing; the reason is shown.
    bool openFile(const std::filesystem::path& file);
    /// Saves; the reason of a failure is shown.
    bool saveFile(const std::filesystem::path& file);
    /// The same for the state of this moment, as a scene of its own.
    bool saveMoment(const std::filesystem::path& file);
    /// The selection, or the scene, as C++ source; the reason of a failure is shown.
    bool exportCpp(const std::filesystem::path& file);
    /// Begins to make a film of the last seconds; that it is done, or why not, is told.
    void makeFilm(const std::filesystem::path& file);
    /// Bodies from the outlines of a drawing or a picture, their middle at a place. What could not
    /// be used is told. Whether any was made.
    bool importOutlines(const std::filesystem::path& file, OutlineKind kind,
                        const DrawingOptions& options, const sulfur::Point& place);
    /// Does with a file, at the pointer, what the table of uses has for it (dropping.cpp): the use
    /// of this name, or what the user chooses. The reason of a failure is told.
    void dropFile(const std::filesystem::path& file, const std::string& use = "");
    /// Dresses what is selected in a picture; the reason of a failure is shown.
    bool wearFile(const std::filesystem::path& file);
    /// What was last told to be wrong; empty at the start.
    const std::string& lastProblem() const { return lastProblem_; }
    /// The action that was done last, by a menu, a button, a key or a script.
    const std::string& lastAction() const { return lastAction_; }
    /// All that menus, keys and scripts can do.
    const std::vector<Action>& actions() const { return actions_; }
    /// What the menu says of an action, without its key; "" when there is none.
    std::string menuLabel(const std::string& name) const;
    /// Texts of the window that do not fit into their places.
    std::vector<std::string> cutTexts() const;
    /// After each frame, for scripts.
    void setOnFrame(std::function<void()> function) { onFrame_ = std::move(function); }
    /// Closes without questions; `exitCode` becomes the program's.
    void finish(int exitCode);

private:
    // actions.cpp
    void makeActions();
    void addFileActions();
    void addEditActions();
    void addTransformActions();
    void addArrangeActions();
    void addAlignActions();
    void addGridActions();
    void addSnapActions();
    void addTemplateActions();
    void addToolActions();
    void addPointerActions();
    void addViewActions();
    void addSimulationActions();
    void addSpeedActions();
    void addRewindActions();
    void addMeasureActions();
    void addPlotActions();
    void addThemeActions();
    void addLanguageActions();
    void addHelpActions();
    Action& add(Action action);

    // level_actions.cpp
    void addLevelActions();
    void addPlacingActions();
    void addPlayingActions();
    void addProvingActions();
    void newLevelFile();
    void publishLevel();

    // guiding.cpp
    void startLesson(const Lesson& lesson);
    void watchPalette(wxAuiToolBar& bar);
    void pointAtTool(std::optional<ToolKind> tool);
    void refreshGuide();

    // layout.cpp
    void makeMenus();
    void makeBars();
    void makePanels();
    void makeStatusBar();
    void arrange();
    void makePalette();
    void showGroup(ToolGroup group);
    void followTool();
    void showSide(bool on);
    wxString tooltip(const Action& action) const;
    wxString withKey(const wxString& text, const Action& action) const;
    std::string filmName(ToolKind tool) const;

    // main_frame_files.cpp
    void newFile();
    void openDialog();
    bool save();
    bool saveDialog();
    void saveMomentDialog();
    void saveProof();
    bool mayDiscard();
    void keepUnsaved();
    void offerRecovery();
    void openRecent(int index);
    void showGallery();
    void openExample(const std::filesystem::path& file);
    void showRecent();
    void showScenes(const wxString& title, std::vector<PictureGrid::Item> items,
                    std::function<void(const std::filesystem::path&)> open);
    void openRecentFile(const std::filesystem::path& file);
    void adoptDocument();
    void loadPreferences();
    void savePreferences();
    void noteRecent(const std::filesystem::path& file);

    // sharing.cpp
    void addShareActions();
    void openShared();
    void exportCppDialog();
    void filmDialog();

    // import_dialog.cpp
    void importDialog(const std::filesystem::path& file, const sulfur::Point& place);
    void chooseImport();

    // dropping.cpp
    void makeDropUses();
    const DropUse* chooseDropUse(const std::vector<const DropUse*>& fitting);

    // skin_actions.cpp
    void addSkinActions();
    void wearPicture(const std::vector<sulfur::BodyId>& bodies, const std::filesystem::path& file);
    void placeSkin();
    void addSkinDropUse();

    // template_actions.cpp
    void addTemplateDropUse();
    void saveTemplateDialog();
    void dropTemplate(const std::string& name, wxPoint screen);
    std::string templateInQuestion() const;
    void editTemplate();

    // main_frame.cpp
    void onClose(wxCloseEvent& event);
    void onKey(wxKeyEvent& event);
    bool walkPanel(wxKeyEvent& event, const wxWindow* focus);
    void onFrame();
    bool holdControl(const wxKeyEvent& event);
    void bindControls();
    void runAction(const Action& action);
    void changeSpeed(int steps);
    void seekBy(double seconds);
    void seekMark(bool forward);
    void showOtherFuture();
    void chooseSpeed(wxWindow& at);
    void chooseUnder(const wxString& under, wxWindow& at);
    void showPlot(bool on);
    void showTable4();
    void toggleQuantity(const Quantity& one);
    void refresh();
    void refreshActions();
    void refreshStatus();
    void showHint();
    void refreshHistoryLabels();
    void setStatus(int field, const std::vector<wxString>& variants);
    void onStatusClick(wxMouseEvent& event);
    void tellWhenNearlyFull(std::size_t particles);
    /// Sentences in English are shown in the language of the user.
    void tell(const std::string& english);
    void notify(const std::string& english);
    void tellInDialog(const std::string& english, const wxString& title);
    void chooseLanguage(const std::string& language);
    void chooseTheme(const std::string& theme);
    void about();

    Workbench& bench_;
    const Options& options_;
    SceneView view_;
    Library library_;
    TemplateDesk desk_;
    Thumbnails thumbnails_;
    std::string language_;  ///< that is chosen; empty for the system's
    std::string theme_;     ///< that is chosen: dark, light or system
    std::vector<Action> actions_;
    std::vector<DropUse> dropUses_;
    wxAuiManager manager_;
    atlax::wx::View* canvas_ = nullptr;
    wxPanel* centre_ = nullptr;
    wxInfoBar* infoBar_ = nullptr;
    SidePanel* side_ = nullptr;
    std::unique_ptr<LevelStage> stage_;
    LevelPanel* levelPanel_ = nullptr;
    TimeBar* timeBar_ = nullptr;
    PlotPanel* plot_ = nullptr;
    wxWeakRef<Table4Window> table4_;
    LessonPanel* lesson_ = nullptr;
    GalleryDialog* gallery_ = nullptr;     ///< while it is shown
    std::optional<ToolKind> pointedTool_;  ///< on the palette
    std::int64_t pointedNs_ = 0;
    wxStaticText* hint_ = nullptr;
    wxString shownHint_;  ///< not wrapped
    int hintWidth_ = 0;   ///< at which it is wrapped
    wxAuiToolBar* toolBar_ = nullptr;
    wxAuiToolBar* palette_ = nullptr;
    wxAuiToolBar* secondPalette_ = nullptr;    ///< the tools of the group that is shown
    std::map<ToolGroup, int> groupIds_;        ///< of the buttons of the palette
    std::map<ToolGroup, ToolKind> lastTools_;  ///< that were chosen of the groups
    std::optional<ToolGroup> shownGroup_;
    wxFileHistory recent_;
    wxMenu* recentMenu_ = nullptr;
    std::set<const wxMenu*> openMenus_;       // of the menu bar, and what opens out of these
    bool walksPanel_ = false;                 // with Tab, through the side panel
    std::optional<Preferences> preferences_;  ///< none while unattended
    std::optional<Recovery> recovery_;        ///< none while unattended
    std::int64_t nextKeepNs_ = 0;
    std::function<void()> onFrame_;
    std::string lastProblem_;
    std::string lastAction_;
    std::int64_t nextRefreshNs_ = 0;
    bool shownPlaying_ = false;
    std::uint64_t toldAt_ = 0;  ///< the document's revision when something was told
    std::size_t strays_ = 0;
    bool toldNearlyFull_ = false;
    std::string shownUndo_;
    std::string shownRedo_;
};

}  // namespace sulfurchamber
