// The history: texts that differ, bytes on the disk, and steps that restore all to the byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "model/shelf.hpp"
#include "model/text_change.hpp"
#include "model/workbench.hpp"

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

// One thing that a person may do.
void actAtRandom(Workbench& bench, std::mt19937& random) {
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto point = [&] { return Point(number(-4, 4), number(0.5, 5)); };
    const auto drag = [&](ToolKind tool, Point from, Point to) {
        bench.setTool(tool);
        bench.press({.position = from});
        bench.move({.position = (from + to) / 2});
        bench.release({.position = to});
    };
    const auto someone = [&] {
        const auto bodies = bench.document().world().bodies();
        return bodies.empty() ? BodyId{} : bodies[random() % bodies.size()];
    };
    const auto dice = random() % 16;
    if (dice < 5) {
        static constexpr std::array tools{ToolKind::box, ToolKind::ball, ToolKind::jelly,
                                          ToolKind::rope, ToolKind::ground};
        drag(tools[dice], point(), point());
    } else if (dice < 7) {
        if (const BodyId body = someone()) {
            bench.select({body});
            bench.deleteSelection();
        }
    } else if (dice < 9) {
        bench.document().pause();
        if (const BodyId body = someone()) {
            const Point at = bench.document().world().centreOfMass(body);
            drag(ToolKind::select, at, at + Point(number(-1, 1), number(0, 1)));
        }
    } else if (dice == 9) {
        drag(ToolKind::cut, point(), point());
    } else if (dice == 10) {
        const Point at = point();
        drag(ToolKind::pin, at, at);
    } else if (dice == 11) {
        Constants constants = bench.document().constants();
        constants.gravity = number(-30, 30);
        if (random() % 2 == 0) constants.elasticity = number(0.1, 3);
        bench.document().setConstants(constants);
    } else if (dice == 12) {
        if (const BodyId body = someone()) bench.select({body});
        bench.duplicate();
    } else if (dice == 13) {
        bench.document().reset();
    } else {
        for (int i = 0; i < 20; ++i) bench.tick();
    }
    bench.cancel();
}

/// The same, but that more than so many particles are deleted.
void actOrClear(Workbench& bench, std::mt19937& random, std::size_t most) {
    if (bench.document().plan().particles() > most) {
        bench.selectAll();
        bench.deleteSelection();
        return;
    }
    try {
        actAtRandom(bench, random);
    } catch (const std::exception&) {  // what the program would tell in a sentence
        bench.cancel();
    }
}

TEST(History, AThousandRandomCommandsUndoneAndRedoneGiveIdenticalBytes) {
    std::mt19937 random(11);
    Workbench bench;
    Document& document = bench.document();
    std::vector<std::string> texts{document.text()};
    std::vector<std::uint64_t> hashes{document.world().hash()};
    const auto note = [&] {
        texts.resize(document.historyPlace());
        hashes.resize(document.historyPlace());
        texts.push_back(document.text());
        hashes.push_back(document.world().hash());
    };
    for (int i = 0; i < 1000; ++i) {
        const std::size_t before = document.historyPlace();
        actOrClear(bench, random, 200);
        if (document.historyPlace() == before) continue;
        if (document.historyPlace() == texts.size()) note();
        // The world goes on between steps; what undo restores is where the step began.
    }
    ASSERT_GT(texts.size(), 400u);
    for (std::size_t place = texts.size() - 1; place > 0; --place) {
        ASSERT_EQ(document.historyPlace(), place);
        ASSERT_EQ(document.text(), texts[place]) << place << " " << document.undoLabel();
        document.undo();
    }
    EXPECT_EQ(document.text(), texts[0]);
    EXPECT_EQ(document.world().hash(), hashes[0]);
    EXPECT_FALSE(document.canUndo());
    while (document.canRedo()) {
        document.redo();
        ASSERT_EQ(document.text(), texts[document.historyPlace()]) << document.undoLabel();
    }
    EXPECT_EQ(document.text(), texts.back());
}

// Rewinding is no command: the plan stays what it is, and so do all steps. What was recorded comes
// back to the bit, whatever was done and undone in between.
TEST(History, StaysWholeWhileOneRewindsAndBranches) {
    std::mt19937 random(23);
    Workbench bench;
    Document& document = bench.document();
    const Timeline& timeline = document.timeline();
    std::vector<std::string> texts{document.text()};
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
            ASSERT_EQ(document.text(), texts[document.historyPlace()]);
        } else if (random() % 12 == 0 && document.canRedo()) {
            document.redo();
            ASSERT_EQ(document.text(), texts[document.historyPlace()]);
        } else {
            actOrClear(bench, random, 150);
        }
        bench.documentChanged();
        if (timeline.line() != line) ++branches;
        if (timeline.place().exact)
            recorded[{timeline.now()->branch, timeline.now()->tick}] = document.world().hash();
        if (document.historyPlace() > before) {
            texts.resize(before + 1);
            texts.push_back(document.text());
        }
        ASSERT_LE(timeline.bytes(), TimelineLimits{}.bytes);
    }
    EXPECT_GT(compared, 20);
    EXPECT_GT(branches, 50);
    while (document.canRedo()) document.redo();
    ASSERT_EQ(document.historyPlace() + 1, texts.size());
    while (document.canUndo()) {
        ASSERT_EQ(document.text(), texts[document.historyPlace()]) << document.undoLabel();
        document.undo();
    }
    EXPECT_EQ(document.text(), texts[0]);
    while (document.canRedo()) {
        document.redo();
        ASSERT_EQ(document.text(), texts[document.historyPlace()]) << document.undoLabel();
    }
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
