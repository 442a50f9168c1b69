// What a person does to a document: tools, selection, clipboard, falling boxes. Knows nothing of
// windows: a view tells it where the pointer is, in metres.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "arrange.hpp"
#include "controls.hpp"
#include "dimensions.hpp"
#include "document.hpp"
#include "grip.hpp"
#include "level_pieces.hpp"
#include "measurement.hpp"
#include "meters.hpp"
#include "snapping.hpp"
#include "stage_times.hpp"
#include "textbook.hpp"

namespace sulfurchamber {

enum class ToolKind : std::uint8_t {
    select,
    box,
    ball,
    wheel,
    polygon,
    wall,
    ground,
    jelly,
    draw,
    cloth,
    rope,
    chain,
    bridge,
    particle,
    joint,
    hinge,
    motor,
    weld,
    spring,
    cable,
    winch,
    slider,
    axle,
    pulley,
    gear,
    thruster,
    wind,
    gravity,
    conveyor,
    liquid,
    pin,
    cut,
    erase,
    measure,
    protractor,
    tracer,
    gauge,
    gun,
    place  ///< a piece of a level; see Workbench::setPlacing
};
/// All but `place`, which a menu of its own offers.
std::span<const ToolKind> allTools();

/// Which tools stand together in a palette.
enum class ToolGroup : std::uint8_t {
    select,
    create,
    soft,
    particles,
    mechanisms,
    zones,
    change,
    measure
};
struct ToolGroupInfo {
    ToolGroup group;
    std::string_view name;   ///< for scripts: "mechanisms"
    std::string_view title;  ///< for people
    std::string_view icon;
};
/// In the order of the palette.
std::span<const ToolGroupInfo> toolGroups();
ToolGroup groupOf(ToolKind tool);

/// "select", "box", ...: for scripts and settings.
std::string_view toolName(ToolKind tool);
/// Nothing when there is no tool of this name.
std::optional<ToolKind> toolFromName(std::string_view name);

/// The pointer, seen from the world.
struct Pointer {
    sulfur::Point position{0, 0};  ///< metres
    double reach = 0.1;            ///< metres within which something counts as hit
    bool shift = false;
    bool control = false;
    bool alt = false;
    int clicks = 1;  ///< 2 for the second press of a double click
};

/// What a tool shows while it is at work.
struct Preview {
    enum class Kind : std::uint8_t {
        none,
        rectangle,
        circle,
        line,
        band,
        stroke,
        spring,
        outline,
        ruler,
        path,
        arrow,
        frame,
        skin  ///< the frame of a picture, `to` is the knob that turns it
    };
    Kind kind = Kind::none;
    sulfur::Point from{0, 0};
    sulfur::Point to{0, 0};
    double size = 0;  ///< radius of the circle, or the length in metres that is shown
    std::vector<sulfur::Point> points = {};  ///< of the outline, corners of the frame
    std::vector<Label> labels = {};          ///< how large it is
};

class Tool;

class Workbench {
public:
    /// `historyFolder` as Document has it.
    explicit Workbench(std::filesystem::path historyFolder = {});
    ~Workbench();

    Document& document() { return document_; }
    const Document& document() const { return document_; }

    // -- the pointer --

    ToolKind tool() const { return toolKind_; }
    /// Changes the tool; what the old one was doing is dropped.
    void setTool(ToolKind tool);
    /// Chooses the tool that places pieces of a level, and one of them.
    void setPlacing(LevelPiece piece);
    /// The piece that is being placed; nothing with another tool.
    std::optional<LevelPiece> placing() const;
    /// To what creating tools and moved things go.
    void setSnapping(const SnapOptions& options) { snapping_ = options; }
    const SnapOptions& snapping() const { return snapping_; }
    /// Takes a tool that is not in the palette, until it is done or another one is chosen.
    void take(std::unique_ptr<Tool> tool);
    /// Distance to which creating tools round their points, metres; 0: not at all.
    void setSnap(double metres) { snapping_.grid = metres; }
    double snap() const { return snapping_.grid; }
    /// To what the tool's point has gone; nothing where it is free.
    const std::optional<SnapPlace>& snapMark() const { return snapMark_; }
    void press(const Pointer& pointer);
    void move(const Pointer& pointer);
    void release(const Pointer& pointer);
    /// Ends what takes several clicks (Enter).
    void finish();
    /// Drops what the tool is doing (Escape, lost focus).
    void cancel();
    Preview preview() const;
    /// One sentence: what the mouse does now.
    std::string hint() const;
    /// While a handle is dragged.
    bool stretching() const;

    // -- time --

    /// One tick: the grip's force, falling boxes, the world.
    void tick();
    /// Boxes per second of simulated time that fall into the scene; 0 stops.
    void setRain(double boxesPerSecond);
    double rain() const { return rain_; }
    /// Lets this many boxes fall from above the scene, one edit.
    void dropBoxes(int count);

    /// Keys that are held, for what they drive.
    Controls& controls() { return controls_; }
    const Controls& controls() const { return controls_; }

    // -- history --

    /// A step back or forth. What is selected stays so, as far as it is there then.
    void undo();
    void redo();
    /// The same for several: to where so many steps are done. There it ends at either end.
    void goToStep(std::size_t steps);

    // -- selection --

    const std::vector<sulfur::BodyId>& selection() const { return selection_; }
    bool selected(sulfur::BodyId body) const;
    void select(std::vector<sulfur::BodyId> bodies);
    /// Whether a click may mean this body: neither locked nor hidden.
    bool pickable(sulfur::BodyId body) const;
    /// What the scene keeps of a body beside its physics.
    const BodyMarks& marks(sulfur::BodyId body) const;
    /// The body under the pointer, in front of others; null where there is none.
    sulfur::BodyId bodyUnder(const Pointer& pointer) const;
    /// Takes what is locked or hidden out of the selection.
    void deselectUnpickable();
    /// A body with all of its outermost group.
    std::vector<sulfur::BodyId> withGroup(sulfur::BodyId body) const;
    void toggle(sulfur::BodyId body);
    void selectAll();
    /// The fitting that is selected, if one is: then no body is.
    std::optional<FittingRef> fitting() const;
    void chooseFitting(const std::optional<FittingRef>& ref);
    /// Also of things of the level. Throws std::runtime_error where only such are selected that a
    /// level must have.
    void deleteSelection();
    /// Things of the level that are selected; then no bodies are, and the other way round.
    const std::vector<LevelThing>& things() const { return things_; }
    void selectThings(std::vector<LevelThing> things);
    bool anythingSelected() const {
        return !selection_.empty() || !things_.empty() || fitting().has_value();
    }
    /// What is selected as the text of a scene: bodies with what a level says of them, and things
    /// of a level, those that are about a body with it. Empty where nothing of it can be copied.
    std::string copy() const;
    /// Whether copy() has something.
    bool canCopy() const;
    /// The same as copy(), and takes away what is in it.
    std::string cut();
    /// The selected bodies as C++ source, or all of the plan where nothing is selected.
    std::string cppSource() const;
    /// Adds what is in such a text, or in one of a whole scene, and selects it, moved by `by`
    /// metres. Throws sulfur::scene::ReadError, naming the clipboard, when it is something else,
    /// and std::runtime_error for things of a level in a scene that is none.
    void paste(const std::string& text, const sulfur::Point& by);
    /// The same, with the middle of what is pasted at a place.
    void pasteAt(const std::string& text, const sulfur::Point& place);
    void duplicate();

    // -- measuring --

    /// Records these quantities of what is selected, or else of what was measured so far; of the
    /// scene where that is nothing. A sample each tick. Meters that are selected join them with
    /// their readings.
    void measure(std::vector<const Quantity*> quantities);
    const std::vector<const Quantity*>& measured() const { return measured_; }
    const Measurements& measurements() const { return measurements_; }
    void clearMeasurements();
    /// Lets what is selected leave trails from now on.
    void setTrails(bool on);
    bool trails() const { return trailing_; }
    /// Pairs of series: the way to the right and the height of each.
    const Measurements& trailMeasurements() const { return trails_; }

    // -- meters --

    /// Those of the scene, with what they show.
    const Meters& meters() const { return meters_; }
    /// Ids of meters that are selected beside the bodies.
    const std::vector<std::string>& selectedMeters() const { return selectedMeters_; }
    bool meterSelected(const std::string& id) const;
    /// Selects these meters, and no bodies unless `too`.
    void selectMeters(std::vector<std::string> ids, bool too = false);

    /// What the scene's formula expects and what is measured.
    const Textbook& textbook() const { return textbook_; }
    /// Measures the time of each stage from now on, which costs a little.
    void setStageTimes(bool on);
    const StageTimes& stageTimes() const { return stageTimes_; }

    // -- transforming, each one step --

    void nudge(const sulfur::Point& by);
    void turn(double radians);
    void scale(double factor);
    void mirror();

    // -- what has left --

    /// Moving bodies that are wholly outside of worldBounds(): they fall for ever, unseen.
    std::vector<sulfur::BodyId> strays() const;
    /// Puts them back at rest: where the plan has them, what it does not have in a row above the
    /// rest. Of this moment alone.
    void bringBackStrays();
    void deleteStrays();

    // -- for tools --

    /// On the grid.
    sulfur::Point snapped(const sulfur::Point& point) const;
    /// To whatever it snaps to, with a mark; `from` is where a line began that ends there.
    sulfur::Point snapped(const Pointer& pointer, std::optional<sulfur::Point> from = {});
    void showSnap(std::optional<SnapPlace> place) { snapMark_ = place; }
    /// A copy of the selection where it is, which is selected then; a part of the open edit.
    void insertCopy();
    /// Everything else that opens, undoes or resets documents calls this first.
    void documentChanged();

private:
    enum class Drop : std::uint8_t { rain, passing, planned };
    void making(const std::function<void()>& act);
    void addRainBox();
    void dropBox(Drop kind, double width);
    void followHandles(const std::function<sulfur::BodyId(sulfur::BodyId)>& now);
    void forgetRemoved();
    void selectAgain(const std::vector<std::string>& names);
    void setSelection(std::vector<sulfur::BodyId> bodies);
    void watchSelection(bool plotting = false);
    void deleteThings();
    std::vector<sulfur::BodyId> chosenBodies() const;
    void insertScene(const sulfur::scene::Scene& scene, const sulfur::Point& by);
    void pasteAs(const char* name, const std::string& text, const sulfur::Point& by);

    Document document_;
    std::unique_ptr<Tool> tool_;
    ToolKind toolKind_ = ToolKind::select;
    Controls controls_;
    LevelPiece placing_ = LevelPiece::ground;
    std::vector<sulfur::BodyId> selection_;  // sorted
    std::vector<LevelThing> things_;         // sorted
    // What is selected, and how it is recognised after others have come or gone.
    struct Chosen {
        FittingRef ref;
        std::string id;
    };
    std::optional<Chosen> chosen_;
    std::vector<const Quantity*> measured_;
    std::vector<Measurements::Subject> subjects_;
    Measurements measurements_;
    Measurements trails_;
    Meters meters_{document_};
    std::vector<std::string> selectedMeters_;
    Textbook textbook_{document_};
    StageTimes stageTimes_;
    bool timing_ = false;
    bool trailing_ = false;
    SnapOptions snapping_;
    std::optional<SnapPlace> snapMark_;
    mutable MarkBook markBook_;
    double rain_ = 0;
    double rainDue_ = 0;
    std::uint64_t dropped_ = 0;
};

}  // namespace sulfurchamber
