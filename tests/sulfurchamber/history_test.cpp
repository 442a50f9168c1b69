// The history: texts that differ, bytes on the disk, and steps that restore all to the byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>

#include "model/properties.hpp"
#include "model/shelf.hpp"
#include "model/switches.hpp"
#include "model/text_change.hpp"
#include "model/transform.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

// Lines, some of them equal, taken out, put in and exchanged.
std::string randomText(std::mt19937& random, const std::string& like) {
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < like.size();) {
        const std::size_t end = std::min(like.find('\n', from), like.size() - 1) + 1;
        lines.push_back(like.substr(from, end - from));
        from = end;
    }
    for (int i = 0; i < 5; ++i) {
        const std::size_t at = lines.empty() ? 0 : random() % lines.size();
        const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
        if (random() % 3 == 0 && !lines.empty())
            lines.erase(place);
        else if (random() % 2 == 0 && !lines.empty())
            std::swap(lines[at], lines[random() % lines.size()]);
        else
            lines.insert(place, std::to_string(random() % 20) + "\n");
    }
    std::string text;
    for (const std::string& line : lines) text += line;
    return random() % 4 == 0 ? text + "no end of line" : text;
}

TEST(TextChange, LeadsToTheOtherTextAndBack) {
    std::mt19937 random(7);
    std::string before;
    for (int i = 0; i < 500; ++i) {
        const std::string after = randomText(random, before);
        const auto change = TextChange::fromBytes(TextChange::between(before, after).bytes());
        ASSERT_EQ(change.apply(before), after);
        ASSERT_EQ(change.revert(after), before);
        ASSERT_EQ(change.empty(), before == after);
        before = after;
    }
}

TEST(TextChange, IsAsSmallAsWhatDiffers) {
    std::string before;
    for (int i = 0; i < 4000; ++i) before += "line " + std::to_string(i) + "\n";
    std::string after = before;
    after.replace(after.find("line 2000\n"), 10, "another\nand one more\n");
    after.insert(after.find("line 3000\n"), "a third\n");
    EXPECT_LT(TextChange::between(before, after).bytes().size(), 200u);
}

TEST(Shelf, GivesBackWhatWasPutThereAndUsesItsRoomAgain) {
    Shelf shelf;
    std::mt19937 random(3);
    std::vector<std::pair<std::string, Shelf::Place>> there;
    std::size_t most = 0;
    for (int i = 0; i < 400; ++i) {
        if (there.size() > 20) there.erase(there.begin() + static_cast<long>(random() % 20));
        std::string bytes(random() % 5000, static_cast<char>('a' + random() % 26));
        there.emplace_back(bytes, shelf.put(bytes));
        most = std::max(most, shelf.used());
        for (const auto& [text, place] : there) ASSERT_EQ(place.read(), text);
    }
    EXPECT_GT(most, 20'000u);
    EXPECT_LT(most, 21u * 5000u);
    there.clear();
    EXPECT_EQ(shelf.used(), 0u);
}

TEST(Shelf, WorksWhereItsFolderCannotBeMade) {
    Shelf shelf("/dev/null/nothing");
    const std::string bytes(10'000, 'x');
    EXPECT_EQ(shelf.put(bytes).read(), bytes);
}

// What a person may do, at random.
class RandomHand {
public:
    RandomHand(Workbench& bench, std::mt19937& random) : bench_(bench), random_(random) {}

    void act() {
        switch (const auto dice = random_() % 24) {
            case 0:
            case 1:
            case 2:
            case 3:
            case 4:
            case 5:
            case 6:
                useAnyTool();
                break;
            case 7:
            case 8:
                bench_.select({someone()});
                bench_.deleteSelection();
                break;
            case 9:
            case 10:
                moveSomeone();
                break;
            case 11:
            case 12:
                dragAHandle();
                break;
            case 13:
            case 14:
                changeAProperty();
                break;
            case 15:
                chooseSome();
                bench_.duplicate();
                break;
            case 16:
            case 17:
                transform();
                break;
            case 18:
            case 19:
                arrange();
                break;
            case 20:
                changeConstants();
                break;
            case 21:
                bench_.document().reset();
                break;
            default:
                for (std::size_t i = 0; i < 10 * (dice - 20); ++i) bench_.tick();
                break;
        }
        bench_.cancel();
    }

private:
    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    Point point() { return {number(-4, 4), number(0.5, 5)}; }
    BodyId someone() {
        const auto bodies = bench_.document().world().bodies();
        return bodies.empty() ? BodyId{} : bodies[random_() % bodies.size()];
    }
    void chooseSome() {
        std::vector<BodyId> bodies;
        for (auto left = 1 + random_() % 4; left > 0; --left)
            if (const BodyId body = someone()) bodies.push_back(body);
        bench_.select(bodies);
    }
    Pointer pointer(const Point& at) {
        return {.position = at,
                .shift = random_() % 4 == 0,
                .control = random_() % 4 == 0,
                .alt = random_() % 4 == 0};
    }
    void drag(const Point& from, const Point& to) {
        Pointer keys = pointer(from);
        bench_.press(keys);
        for (const double share : {0.3, 0.6, 1.0}) {
            keys.position = from + share * (to - from);
            bench_.move(keys);
        }
        bench_.release(keys);
    }
    // A drag, or some clicks, with any of all tools.
    void useAnyTool() {
        chooseSome();
        bench_.setTool(allTools()[random_() % allTools().size()]);
        if (random_() % 3 == 0) bench_.setSnapping({0.25, true, true, true});
        if (random_() % 2 == 0) {
            drag(point(), point());
        } else {
            // Round about a place, as one draws a polygon.
            const Point middle = point();
            for (int i = 0; i < 4; ++i)
                drag(middle + Point(i % 3 == 0 ? -1 : 1, i < 2 ? -0.5 : 0.5),
                     middle + Point(i % 3 == 0 ? -1 : 1, i < 2 ? -0.5 : 0.5));
            bench_.finish();
        }
        bench_.cancel();
        bench_.setSnapping({});
        bench_.setTool(ToolKind::select);
    }
    void moveSomeone() {
        bench_.document().pause();
        bench_.setTool(ToolKind::select);
        const BodyId body = someone();
        if (!body) return;
        const Point at = bench_.document().world().centreOfMass(body);
        drag(at, at + Point(number(-1, 1), number(0, 1)));
    }
    void dragAHandle() {
        bench_.setTool(ToolKind::select);
        chooseSome();
        const auto frame = selectionFrame(bench_);
        if (!frame) return;
        const Handle handle = handlesOf(*frame, 0.1).at(random_() % 9);
        drag(handle.at, handle.at + Point(number(-0.4, 0.6), number(-0.4, 0.6)));
    }
    void transform() {
        chooseSome();
        switch (random_() % 4) {
            case 0:
                bench_.nudge({number(-1, 1), number(0, 1)});
                break;
            case 1:
                bench_.turn(number(-2, 2));
                break;
            case 2:
                bench_.scale(number(0.7, 1.4));
                break;
            default:
                bench_.mirror();
                break;
        }
    }
    void changeAProperty() {
        chooseSome();
        Document& document = bench_.document();
        const auto bodies = bench_.selection();
        const auto& property = numberProperties()[random_() % numberProperties().size()];
        const auto& place = placeProperties()[random_() % placeProperties().size()];
        const auto& toggled = switchProperties()[random_() % switchProperties().size()];
        const auto& preset = materialPresets()[random_() % materialPresets().size()];
        const int layer = static_cast<int>(random_() % layerCount);
        document.edit("Change", [&] {
            switch (random_() % 8) {
                case 0:
                    setPlace(bench_, place, number(0.2, 3));
                    break;
                case 1:
                    setSwitch(document, bodies, toggled, random_() % 2 == 0);
                    break;
                case 2:
                    applyPreset(document, bodies, preset);
                    break;
                case 3:
                    setInLayer(document, bodies, layer, random_() % 2 == 0);
                    break;
                case 4:
                    setColour(document, bodies, random_() % 2 == 0 ? "#1188ff" : "");
                    break;
                case 5:
                    holdInPlace(document, bodies, random_() % 2 == 0);
                    break;
                case 6:
                    setSkin(document, bodies, random_() % 2 == 0 ? "skins/crate.png" : "");
                    break;
                default:
                    setProperty(document, bodies, property,
                                std::clamp(number(0.3, 12), property.low, property.high));
                    break;
            }
        });
    }
    void arrange() {
        chooseSome();
        switch (random_() % 9) {
            case 0:
            case 1:
                groupSelection(bench_);
                break;
            case 2:
                ungroupSelection(bench_);
                break;
            case 3:
                setLocked(bench_, bench_.selection(), random_() % 2 == 0);
                break;
            case 4:
                setHidden(bench_, bench_.selection(), random_() % 2 == 0);
                break;
            case 5:
                orderSelection(bench_, random_() % 2 == 0);
                break;
            case 6:
                alignSelection(bench_, static_cast<Alignment>(random_() % 6));
                break;
            case 7:
                distributeSelection(bench_, random_() % 2 == 0);
                break;
            default:
                if (random_() % 2 == 0)
                    unlockAll(bench_);
                else
                    showAll(bench_);
                break;
        }
    }
    void changeConstants() {
        Constants constants = bench_.document().constants();
        constants.gravity = number(-30, 30);
        if (random_() % 2 == 0) constants.elasticity = number(0.1, 3);
        bench_.document().setConstants(constants);
    }

    Workbench& bench_;
    std::mt19937& random_;
};

/// The same, but that more than so many particles are deleted.
void actOrClear(Workbench& bench, std::mt19937& random, std::size_t most) {
    if (bench.document().plan().particles() > most) {
        const auto bodies = bench.document().world().bodies();
        bench.select({bodies.begin(), bodies.end()});
        bench.deleteSelection();
        return;
    }
    try {
        RandomHand(bench, random).act();
    } catch (const std::exception&) {  // what the program would tell in a sentence
        bench.cancel();
    }
}

/// What the plan was after so many steps: known where a command ended, since some make several.
class Texts {
public:
    explicit Texts(const Document& document) : document_(document), known_{document.text()} {}

    /// After a command that had found so many steps done.
    void note(std::size_t before) {
        const std::size_t place = document_.historyPlace();
        if (place <= before) return;
        known_.resize(before + 1);  // what could be redone is gone
        known_.resize(place);
        known_.emplace_back(document_.text());
    }
    /// Of the present place; true where it is not known.
    bool isSame() const {
        const auto& text = known_.at(document_.historyPlace());
        if (text) ++compared_;
        return !text || *text == document_.text();
    }
    std::size_t steps() const { return known_.size() - 1; }
    int compared() const { return compared_; }

private:
    const Document& document_;
    std::vector<std::optional<std::string>> known_;
    mutable int compared_ = 0;
};

TEST(History, AThousandRandomCommandsUndoneAndRedoneGiveIdenticalBytes) {
    std::mt19937 random(11);
    Workbench bench;
    Document& document = bench.document();
    std::uint64_t hash = 0;  // where the first step began
    Texts texts(document);
    for (int i = 0; i < 1000; ++i) {
        const std::size_t before = document.historyPlace();
        if (before == 0) hash = document.world().hash();
        actOrClear(bench, random, 200);
        texts.note(before);
        // The world goes on between steps; what undo restores is where the step began.
    }
    ASSERT_GT(texts.steps(), 400u);
    for (;; document.undo()) {
        ASSERT_TRUE(texts.isSame()) << document.historyPlace() << " " << document.undoLabel();
        if (!document.canUndo()) break;
    }
    EXPECT_EQ(document.historyPlace(), 0u);
    EXPECT_EQ(document.world().hash(), hash);
    while (document.canRedo()) {
        document.redo();
        ASSERT_TRUE(texts.isSame()) << document.historyPlace() << " " << document.undoLabel();
    }
    EXPECT_EQ(document.historyPlace(), texts.steps());
    EXPECT_GT(texts.compared(), 600);
}

// Rewinding is no command: the plan stays what it is, and so do all steps. What was recorded comes
// back to the bit, whatever was done and undone in between.
TEST(History, StaysWholeWhileOneRewindsAndBranches) {
    std::mt19937 random(23);
    Workbench bench;
    Document& document = bench.document();
    const Timeline& timeline = document.timeline();
    Texts texts(document);
    std::map<std::pair<std::uint32_t, std::uint64_t>, std::uint64_t> recorded;
    int compared = 0;
    int branches = 0;
    const auto rewind = [&] {
        const auto others = timeline.others();
        Moment wanted{timeline.line(), 0};
        if (!others.empty() && random() % 3 == 0)
            wanted.branch = others[random() % others.size()].branch;
        const std::uint64_t first = timeline.first(wanted.branch);
        wanted.tick = first + random() % (timeline.last(wanted.branch) - first + 1);
        const std::string before = document.text();
        const std::size_t place = document.historyPlace();
        ASSERT_TRUE(document.goTo(wanted));
        ASSERT_EQ(document.world().ticks(), wanted.tick);
        ASSERT_EQ(document.text(), before);
        ASSERT_EQ(document.historyPlace(), place);
        const auto known = recorded.find({wanted.branch, wanted.tick});
        if (known != recorded.end()) {
            ASSERT_EQ(document.world().hash(), known->second)
                << wanted.branch << " " << wanted.tick;
            ++compared;
        }
        recorded[{wanted.branch, wanted.tick}] = document.world().hash();
    };
    for (int i = 0; i < 1000; ++i) {
        const std::size_t before = document.historyPlace();
        const std::uint32_t line = timeline.line();
        if (!timeline.empty() && random() % 4 == 0) {
            rewind();
            if (HasFatalFailure()) return;
        } else if (random() % 12 == 0 && document.canUndo()) {
            document.undo();
            ASSERT_TRUE(texts.isSame()) << document.historyPlace();
        } else if (random() % 12 == 0 && document.canRedo()) {
            document.redo();
            ASSERT_TRUE(texts.isSame()) << document.historyPlace();
        } else {
            actOrClear(bench, random, 150);
            texts.note(before);
        }
        bench.documentChanged();
        if (timeline.line() != line) ++branches;
        if (timeline.place().exact)
            recorded[{timeline.now()->branch, timeline.now()->tick}] = document.world().hash();
        ASSERT_LE(timeline.bytes(), TimelineLimits{}.bytes);
    }
    EXPECT_GT(compared, 20);
    EXPECT_GT(branches, 50);
    while (document.canRedo()) document.redo();
    ASSERT_EQ(document.historyPlace(), texts.steps());
    for (;; document.undo()) {
        ASSERT_TRUE(texts.isSame()) << document.historyPlace() << " " << document.undoLabel();
        if (!document.canUndo()) break;
    }
    while (document.canRedo()) {
        document.redo();
        ASSERT_TRUE(texts.isSame()) << document.historyPlace() << " " << document.undoLabel();
    }
}

TEST(History, KeepsWhatIsSelectedAsFarAsItIsThere) {
    Workbench bench;
    const Document& document = bench.document();
    const auto names = [&] {
        std::vector<std::string> found;
        for (const sulfur::BodyId body : bench.selection()) found.push_back(document.idOf(body));
        std::sort(found.begin(), found.end());
        return found;
    };
    using Names = std::vector<std::string>;
    const auto click = [&](ToolKind tool, const sulfur::Point& from, const sulfur::Point& to) {
        bench.setTool(tool);
        bench.press({.position = from, .reach = 0.05});
        bench.move({.position = to, .reach = 0.05});
        bench.release({.position = to, .reach = 0.05});
    };
    click(ToolKind::box, {-3, 3}, {-2, 4});
    click(ToolKind::particle, {0, 2}, {0, 2});
    click(ToolKind::particle, {1, 2}, {1, 2});
    click(ToolKind::joint, {0, 2}, {1, 2});
    const std::string pair = document.scene().bodies.back().id;
    click(ToolKind::particle, {2, 2}, {2, 2});
    click(ToolKind::joint, {1, 2}, {2, 2});
    ASSERT_EQ(document.plan().blueprint(pair).particles.size(), 3u);
    bench.select({document.bodyOf("box"), document.bodyOf(pair)});
    bench.undo();  // the joint: the body has a particle less
    EXPECT_EQ(names(), (Names{"box", pair}));
    bench.redo();
    EXPECT_EQ(names(), (Names{"box", pair}));
    // Another name is no other body.
    bench.select({document.bodyOf("box")});
    bench.document().edit("Rename",
                          [&] { bench.document().rename(bench.selection()[0], "crate"); });
    EXPECT_EQ(names(), Names{"crate"});
    bench.undo();
    EXPECT_EQ(names(), Names{"box"});
    bench.redo();
    EXPECT_EQ(names(), Names{"crate"});
    // In a moment, over many steps, and where only one of two is there.
    bench.select({document.bodyOf("crate"), document.bodyOf(pair)});
    for (int i = 0; i < 50; ++i) bench.tick();
    bench.nudge({0, 1});
    const std::size_t steps = document.historyPlace();
    bench.goToStep(steps - 1);
    EXPECT_EQ(names(), (Names{"crate", pair}));
    bench.goToStep(1);
    EXPECT_EQ(names(), Names{"box"});
    bench.goToStep(1000);
    EXPECT_EQ(document.historyPlace(), steps);
    EXPECT_EQ(names(), Names{"crate"});
    bench.goToStep(0);
    EXPECT_TRUE(names().empty());
}

TEST(History, HasNoEnd) {
    Document document;
    document.edit("Add wall", [&] {
        document.add("wall", sulfur::shapes::WallOptions{.columns = 20, .rows = 10}, {});
    });
    const std::string before = document.text();
    // Steps in a moment keep its state: all together far more than memory is given for.
    document.tick();
    constexpr int steps = 1500;
    for (int i = 0; i < steps; ++i) {
        Constants constants = document.constants();
        constants.gravity = 0.01 * (i + 1);
        document.setConstants(constants);
    }
    EXPECT_EQ(document.history().size(), steps + 1u);
    for (int i = 0; i < steps; ++i) document.undo();
    EXPECT_EQ(document.text(), before);
    EXPECT_EQ(document.undoLabel(), "Add wall");
}

TEST(History, AStepThatChangesNothingIsNone) {
    Document document;
    document.setConstants(document.constants());
    EXPECT_FALSE(document.canUndo());
    EXPECT_FALSE(document.modified());
}

}  // namespace
}  // namespace sulfurchamber
