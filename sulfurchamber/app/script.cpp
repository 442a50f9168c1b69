#include "script.hpp"

#include <atlax/files.hpp>
#include <cmath>
#include <ctime>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "../model/fitting_properties.hpp"
#include "../model/properties.hpp"
#include "../model/skins.hpp"
#include "../model/switches.hpp"
#include "../model/transform.hpp"
#include "chamber_app.hpp"
#include "library_panel.hpp"
#include "outline_panel.hpp"
#include "screen_picture.hpp"

namespace sulfurchamber {
namespace {

// Frames after which an event that has not arrived never will.
constexpr std::uint64_t patience = 3000;

}  // namespace

std::string scriptHelp() {
    return "A script has one command a line; # begins a comment. Places are in metres.\n"
           "  tool NAME               select box ball wheel polygon wall ground jelly draw\n"
           "                          cloth rope chain bridge particle joint hinge motor weld\n"
           "                          spring cable winch slider axle pulley gear thruster wind\n"
           "                          gravity conveyor liquid pin cut erase measure\n"
           "                          protractor tracer gauge gun\n"
           "  click X Y               press and release the left button\n"
           "  drag X Y X2 Y2          press, move, release\n"
           "  stroke X Y X2 Y2 ...    the same through all of these places\n"
           "  hold X Y X2 Y2 SECONDS  the same, holding for simulated seconds\n"
           "  wheel X Y NOTCHES       turn the wheel, positive away from you\n"
           "  key NAME                a letter, Space, Period, Comma, Escape, Delete, Home, End,\n"
           "                          Left, Right, Up, Down, Enter, PageUp, PageDown, or one of "
           "them after Ctrl+\n"
           "  hold-key NAME SECONDS   plays on with a key held, for simulated seconds\n"
           "  slide A B               drag the time bar from one share of it to another;\n"
           "                          A = B hovers\n"
           "  plot-drag A B           drag over the diagram, in shares of its time; A = B hovers\n"
           "  plot-wheel A NOTCHES    zoom the diagram\n"
           "  save-plot FILE          the diagram as .png, or the table as .csv\n"
           "  table4 SECONDS          runs the columns of the paper's Table 4, so long each\n"
           "  save-table4 FILE        that table as .csv or its diagram as .png\n"
           "  seek SECONDS            to a recorded moment of the shown line\n"
           "  point ACTION            the pointer to its button on a bar\n"
           "  do ACTION               anything of the menus, such as play, undo, strain\n"
           "  set CONSTANT VALUE      gravity, elasticity, friction, air-friction, rain\n"
           "  run SECONDS             play for simulated seconds, then pause\n"
           "  property KEY VALUE      of what is selected: mass, stiffness, width, x, y, angle,\n"
           "                          speed, torque, ... or inf\n"
           "  keys ON BACK            that drive the fitting which is selected; none: no key\n"
           "  colour RRGGBB           of what is selected\n"
           "  layers N ...            of what is selected, 1 to 8\n"
           "  select NAME ...         bodies by their names\n"
           "  name NAME               of the body that is selected\n"
           "  title WORDS, describe WORDS  of the scene\n"
           "  material NAME           makes what is selected of ice, rubber, wood, steel, ...\n"
           "  outline WHAT ROW        clicks the page Outline: name double eye lock arrow, or\n"
           "                          search with a word, - for all\n"
           "  place X Y TEMPLATE      an instance of a template of the library\n"
           "  library WORDS           searches the library, whose first find is then chosen\n"
           "  drop-template X Y       drags what is chosen in the library into the scene\n"
           "  save-template NAME      makes a template of what is selected\n"
           "  skin FILE               a picture that is worn by what is selected\n"
           "  open FILE, save FILE    without questions\n"
           "  drop FILE X Y [USE]     drop a file on the scene; uses: wear, place,\n"
           "                          open, add, outline\n"
           "  import FILE KIND METRES bodies from outlines: rigid, soft or fixed, so large\n"
           "  save-moment FILE        the state of this moment as a scene of its own\n"
           "  export-cpp FILE         the selection, or the scene, as C++ source\n"
           "  film FILE               the last 10 s as an animated picture\n"
           "  screenshot FILE         the window as PNG\n"
           "  expect QUANTITY OP N    fails unless it holds; OP is = != < or >; quantities:\n"
           "                          bodies particles joints contacts time selected modified\n"
           "                          playing problem newest.x newest.y gravity elasticity rain\n"
           "                          fittings strays steps property.KEY branches speed fps\n"
           "                          past.pictures (on the time bar) past.card (above it)\n"
           "                          meters meter.ID (what it shows) table4.cells\n"
           "                          measured difference (of the textbook's first formula)\n"
           "                          hidden locked outline-rows zoom (metres of a pixel)\n"
           "                          series samples plot.from plot.to plot.fit plot.cursor\n"
           "                          film lesson.step lesson.showing gallery.pictures\n"
           "                          page (of the side panel, the first is 1)\n"
           "                          instances overrides (of what is selected) templates (shown)\n"
           "                          skins (bodies that wear one)\n"
           "                          swatch (colours that the page Object shows)\n"
           "                          pictures (of templates that are still to come)\n"
           "                          slide-cost (ms of processor time a frame of the last slide)\n"
           "                          level.things level.problems level.checked level.proof\n"
           "                          level.survival playtest playtest.first playtest.time\n"
           "                          playtest.x\n"
           "  await QUANTITY OP N SECONDS   goes on once it holds, fails after so long\n"
           "  thing KIND INDEX        selects a thing of the level: spawn exit hints zones ...\n"
           "  field PATH VALUE        sets a field of the selected thing, such as radius 0.7\n"
           "  keep-key NAME SECONDS   keeps a key down in a play-test\n"
           "  swing X Y KEY SECONDS   shoots the rope at a place of a play-test and holds it, "
           "with\n"
           "                          a key\n"
           "  label ACTION WORDS      fails unless the menu says this of an action\n"
           "  every-action FILE TICKS [BUT...]   opens a file for each action that asks nothing,\n"
           "                          lets time pass, does it with all selected, and fails\n"
           "                          if it refuses, or unless undo takes it back\n"
           "  every-key FILE TICKS [BUT...]   the same with keys, which are pressed\n"
           "  whole                   fails if a text or a number of the window is cut\n"
           "  quit                    also what follows the last line\n";
}

Script::Script(MainFrame& frame, const Options& options) : frame_(frame) {
    std::string text;
    if (options.script.empty()) {
        name_ = "--screenshot";
        lines_.push_back({1, {"run", std::to_string(options.at)}});
        lines_.push_back({2, {"screenshot", options.screenshot.string()}});
    } else {
        name_ = options.script.string();
        text = atlax::readFile(options.script, 1 << 20);
    }
    std::istringstream stream(text);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        std::istringstream words(line.substr(0, line.find('#')));
        Words found;
        for (std::string word; words >> word;) found.push_back(word);
        if (!found.empty()) lines_.push_back({number, found});
    }
    frame_.setOnFrame([this] { step(); });
}

void Script::fail(const std::string& why) {
    throw std::runtime_error(why);
}

double Script::number(const std::string& word) {
    std::size_t used = 0;
    double value = 0;
    try {
        value = std::stod(word, &used);
    } catch (const std::exception&) {
        used = 0;
    }
    if (used != word.size() || !std::isfinite(value)) fail("\"" + word + "\" is no number");
    return value;
}

void Script::step() {
    if (busy_) return;
    busy_ = true;
    std::size_t current = next_ == 0 ? 0 : next_ - 1;
    try {
        if (waiting_)
            goOn();
        else if (next_ == lines_.size())
            frame_.finish(0);
        else
            start(lines_[current = next_++].words);
    } catch (const std::exception& error) {
        std::cerr << name_ << ":" << lines_[current].number << ": " << error.what() << "\n";
        frame_.finish(1);
    }
    busy_ = false;
}

void Script::goOn() {
    if (++waitedFrames_ > patience) fail("nothing happened within 3000 frames");
    if (!waiting_()) return;
    waiting_ = nullptr;
    // May begin the next wait.
    if (const auto then = std::exchange(then_, nullptr)) then();
}

void Script::waitFor(std::function<bool()> done, std::function<void()> then) {
    waiting_ = std::move(done);
    then_ = std::move(then);
    waitedFrames_ = 0;
}

void Script::start(const Words& words) {
    if (words[0] == "quit") {
        next_ = lines_.size();
    } else if (words[0] == "expect" && words.size() == 4) {
        expect(words);
    } else if (words[0] == "label" && words.size() > 2) {
        std::string wanted;
        for (std::size_t i = 2; i < words.size(); ++i) wanted += (i > 2 ? " " : "") + words[i];
        waitForFrames(12, [this, action = words[1], wanted] {
            const std::string is = frame_.menuLabel(action);
            if (is != wanted) fail("the menu says \"" + is + "\", expected \"" + wanted + "\"");
        });
    } else if (words[0] == "whole" && words.size() == 1) {
        waitForFrames(12, [this] {
            const auto cut = frame_.cutTexts();
            if (!cut.empty()) fail("this text is cut: \"" + cut.front() + "\"");
        });
    } else if ((words[0] == "every-action" || words[0] == "every-key") && words.size() > 2) {
        everyAction(words);
    } else if (words[0] == "do" && words.size() == 2) {
        if (!frame_.perform(words[1]))
            fail("the action " + words[1] + " is not there or not available");
    } else if (words[0] == "point" && words.size() == 2) {
        const auto button = frame_.buttonOnScreen(words[1]);
        if (!button) fail(words[1] + " has no button");
        simulator_.MouseMove(button->x + 1, button->y);
        simulator_.MouseMove(*button);
        waitForFrames(60, {});
    } else if (words[0] == "slide" && words.size() == 3) {
        slide(number(words[1]), number(words[2]));
    } else if (words[0] == "plot-drag" && words.size() == 3) {
        dragPlot(number(words[1]), number(words[2]));
    } else if (words[0] == "table4" && words.size() == 2) {
        frame_.perform("table4");
        frame_.table4()->begin(number(words[1]));
        waitFor([this] {
            waitedFrames_ = 0;
            return frame_.table4() == nullptr || !frame_.table4()->table().running();
        });
    } else if (words[0] == "plot-wheel" && words.size() == 3) {
        frame_.plot().turnWheel(number(words[1]), static_cast<int>(number(words[2])));
    } else if (!startPointer(words) && !startWorld(words) && !startTemplate(words) &&
               !startFile(words) && !startLevel(words) && !startOutline(words)) {
        fail("\"" + words[0] + "\" with " + std::to_string(words.size() - 1) +
             " words is no command; see --script-help");
    }
}

// --- world and files -------------------------------------------------------------------------

// By number: of a fitting, or of bodies.
void Script::setOfSelection(const std::string& key, double value) {
    Workbench& bench = frame_.bench();
    Document& document = bench.document();
    const std::string label = "Change " + key;
    if (const auto ref = bench.fitting()) {
        const FittingProperty* property = fittingProperty(key, document.fitting(*ref));
        if (property == nullptr) fail("it has no property " + key);
        document.edit(label, [&] { setFittingProperty(document, *ref, *property, value); });
        return;
    }
    if (const PlaceProperty* place = placeProperty(key)) {
        document.edit(label, [&] { setPlace(bench, *place, value); });
        return;
    }
    if (const SwitchProperty* toggled = switchProperty(key)) {
        document.edit(label, [&] { setSwitch(document, bench.selection(), *toggled, value != 0); });
        return;
    }
    const NumberProperty* property = numberProperty(key);
    if (property == nullptr) fail("there is no property " + key);
    document.edit(label, [&] { setProperty(document, bench.selection(), *property, value); });
}

bool Script::startWorld(const Words& words) {
    Document& document = frame_.bench().document();
    if (words[0] == "run" && words.size() == 2) {
        const double seconds = number(words[1]);
        if (!(seconds > 0)) return true;
        document.play();
        frame_.sceneView().pauseAt(document.world().time() + seconds);
        // Playing is slow only where the machine is: the patience is for what does not move.
        double last = -1;
        waitFor([this, last]() mutable {
            const Document& running = frame_.bench().document();
            if (running.world().time() != last) waitedFrames_ = 0;
            last = running.world().time();
            return !running.playing();
        });
    } else if (words[0] == "seek" && words.size() == 2) {
        const Timeline& timeline = document.timeline();
        if (timeline.empty()) fail("nothing is recorded");
        const double ticks =
            number(words[1]) / static_cast<double>(document.world().tickDuration());
        frame_.sceneView().seek(
            {timeline.line(), static_cast<std::uint64_t>(std::max(0.0, std::round(ticks)))});
        waitFor([this] { return !frame_.sceneView().seeking(); });
    } else if (words[0] == "set" && words.size() == 3) {
        Constants constants = document.constants();
        const double value = number(words[2]);
        if (words[1] == "gravity")
            constants.gravity = value;
        else if (words[1] == "elasticity")
            constants.elasticity = value;
        else if (words[1] == "friction")
            constants.friction = value;
        else if (words[1] == "air-friction")
            constants.airFriction = value;
        else if (words[1] == "rain")
            frame_.bench().setRain(value);
        else
            fail("there is no constant " + words[1]);
        if (words[1] != "rain") document.setConstants(constants);
    } else if (words[0] == "property" && words.size() == 3) {
        setOfSelection(words[1], words[2] == "inf" ? std::numeric_limits<double>::infinity()
                                                   : number(words[2]));
    } else if (words[0] == "keys" && words.size() == 3) {
        const auto ref = frame_.bench().fitting();
        auto keys = ref ? keysOf(document.fitting(*ref)) : std::nullopt;
        if (!keys) fail("nothing is selected that a key can drive");
        keys->forward = words[1] == "none" ? "" : words[1];
        keys->back = words[2] == "none" ? "" : words[2];
        document.edit("Choose a key", [&] { setFittingKeys(document, *ref, *keys); });
    } else if (words[0] == "colour" && words.size() == 2) {
        if (words[1].size() != 6 ||
            words[1].find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
            fail("\"" + words[1] + "\" is no colour; allowed are six hexadecimal digits");
        document.edit("Colour",
                      [&] { setColour(document, frame_.bench().selection(), "#" + words[1]); });
    } else if (words[0] == "layers" && words.size() > 1) {
        std::set<int> wanted;
        for (std::size_t i = 1; i < words.size(); ++i) {
            const int layer = static_cast<int>(number(words[i]));
            if (layer < 1 || layer > layerCount) fail("there are layers 1 to 8");
            wanted.insert(layer - 1);
        }
        document.edit("Change layers", [&] {
            for (int layer = 0; layer < layerCount; ++layer)
                setInLayer(document, frame_.bench().selection(), layer, wanted.contains(layer));
        });
    } else if (words[0] == "select" && words.size() > 1) {
        std::vector<sulfur::BodyId> bodies;
        for (std::size_t i = 1; i < words.size(); ++i) {
            bodies.push_back(document.bodyOf(words[i]));
            if (!bodies.back()) fail("there is no body " + words[i]);
        }
        frame_.bench().select(std::move(bodies));
    } else if (words[0] == "name" && words.size() == 2) {
        if (frame_.bench().selection().size() != 1) fail("a name needs one selected body");
        document.edit("Rename", [&] { document.rename(frame_.bench().selection()[0], words[1]); });
    } else if ((words[0] == "title" || words[0] == "describe") && words.size() > 1) {
        std::string text;
        for (std::size_t i = 1; i < words.size(); ++i) text += (i > 1 ? " " : "") + words[i];
        document.edit(words[0] == "title" ? "Title" : "Description", [&] {
            auto& scene = document.planForEditing();
            (words[0] == "title" ? scene.title : scene.description) = text;
        });
    } else if (words[0] == "material" && words.size() == 2) {
        for (const MaterialPreset& preset : materialPresets())
            if (wxString::FromUTF8(preset.name.data(), preset.name.size()).Lower() == words[1]) {
                document.edit("Make of " + words[1],
                              [&] { applyPreset(document, frame_.bench().selection(), preset); });
                return true;
            }
        fail("there is no material " + words[1]);
    } else {
        return false;
    }
    return true;
}

// Real clicks on rows of the page, counted from 1.
bool Script::startOutline(const Words& words) {
    if (words.size() != 3 || words[0] != "outline") return false;
    OutlinePanel& outline = frame_.outline();
    if (words[1] == "search") {
        outline.search(words[2] == "-" ? "" : words[2]);
        waitForFrames(4, {});
        return true;
    }
    const double row = number(words[2]);
    if (!(row >= 1 && row <= static_cast<double>(outline.rowCount())))
        fail("the outline has no row " + words[2]);
    const auto place = static_cast<std::size_t>(row) - 1;
    const bool twice = words[1] == "double";
    const bool known = twice || words[1] == "name" || words[1] == "eye" || words[1] == "lock" ||
                       words[1] == "arrow";
    if (!known) fail("\"" + words[1] + "\" is not one of search name double eye lock arrow");
    clickScreen(outline.placeOnScreen(place, twice ? "name" : words[1]), twice);
    return true;
}

void Script::clickScreen(const wxPoint& place, bool twice) {
    simulator_.MouseMove(place.x, place.y);
    waitForFrames(4, [this, twice] {
        if (twice)
            simulator_.MouseDblClick();
        else
            simulator_.MouseClick();
        waitForFrames(20, {});
    });
}

bool Script::startTemplate(const Words& words) {
    const auto rest = [&](std::size_t first) {
        std::string text;
        for (std::size_t i = first; i < words.size(); ++i)
            text += (i > first ? " " : "") + words[i];
        return text;
    };
    LibraryPanel& library = frame_.side().library();
    if (words[0] == "place" && words.size() > 3) {
        frame_.templates().library().rescan();
        frame_.templates().place(rest(3), {number(words[1]), number(words[2])});
    } else if (words[0] == "skin" && words.size() == 2) {
        frame_.wearFile(words[1]);
    } else if (words[0] == "save-template" && words.size() > 1) {
        frame_.templates().save(rest(1), "", false);
    } else if (words[0] == "library") {
        frame_.perform("page-library");
        library.search(wxString::FromUTF8(rest(1)));
        library.grid().choose(library.grid().items().empty() ? std::nullopt
                                                             : std::optional<std::size_t>(0));
    } else if (words[0] == "drop-template" && words.size() == 3) {
        const auto chosen = library.grid().chosen();
        if (!chosen) fail("nothing is chosen in the library");
        const wxRect cell = library.grid().onScreen(*chosen);
        simulator_.MouseMove(cell.GetLeft() + cell.GetWidth() / 2,
                             cell.GetTop() + cell.GetHeight() / 2);
        simulator_.MouseDown();
        waitForFrames(10, [this, to = sulfur::Point(number(words[1]), number(words[2]))] {
            const atlax::Vec2 pixels = frame_.sceneView().toPixels(to);
            const auto scale = static_cast<float>(frame_.canvas().GetContentScaleFactor());
            const wxPoint at = frame_.canvas().ClientToScreen(
                wxPoint(static_cast<int>(pixels.x / scale), static_cast<int>(pixels.y / scale)));
            simulator_.MouseMove(at);
            waitForFrames(10, [this] {
                simulator_.MouseUp();
                waitForFrames(20, {});
            });
        });
    } else {
        return false;
    }
    return true;
}

bool Script::startFile(const Words& words) {
    if (words[0] == "drop" && (words.size() == 4 || words.size() == 5)) {
        moveMouse({number(words[2]), number(words[3])},
                  [this, file = words[1], use = words.size() == 5 ? words[4] : ""] {
                      frame_.dropFile(file, use);
                      waitForFrames(2, {});
                  });
        return true;
    }
    if (words[0] == "import" && words.size() == 4) {
        const auto kind = outlineKindFromName(words[2]);
        if (!kind) fail("\"" + words[2] + "\" is not one of rigid soft fixed");
        frame_.importOutlines(words[1], *kind, {.size = number(words[3])},
                              frame_.sceneView().pointer().value_or(sulfur::Point(0, 2)));
        return true;
    }
    if (words.size() != 2) return false;
    if (words[0] == "open") {
        // A file that cannot be read is not the script's failure: it may expect a problem.
        frame_.openFile(words[1]);
        waitForFrames(2, {});
    } else if (words[0] == "save") {
        if (!frame_.saveFile(words[1])) fail(frame_.lastProblem());
    } else if (words[0] == "save-moment") {
        if (!frame_.saveMoment(words[1])) fail(frame_.lastProblem());
    } else if (words[0] == "export-cpp") {
        if (!frame_.exportCpp(words[1])) fail(frame_.lastProblem());
    } else if (words[0] == "film") {
        frame_.makeFilm(words[1]);
        waitFor([this] { return !frame_.sceneView().filmProgress(); });
    } else if (words[0] == "save-plot") {
        if (!frame_.savePlot(words[1])) fail(frame_.lastProblem());
    } else if (words[0] == "save-table4") {
        if (frame_.table4() == nullptr) fail("the experiment is not open");
        frame_.table4()->save(words[1]);
    } else if (words[0] == "screenshot") {
        waitForFrames(8, [this, file = words[1]] { saveScreen(frame_.GetScreenRect(), file); });
    } else {
        return false;
    }
    return true;
}

}  // namespace sulfurchamber
