// Hours of work in minutes: random commands and play. Nothing breaks, and memory ceases to grow.
// PLAY=200000 in the environment does that many things, SEED=N others.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

int asked(const char* name, int otherwise) {
    const char* value = std::getenv(name);
    return value == nullptr ? otherwise : std::atoi(value);
}

// MiB that are in use, without what is recorded to be rewound: that has a limit of its own, which
// it reaches in its own time.
double inUse(const Workbench& bench) {
    const struct mallinfo2 info = ::mallinfo2();
    const double bytes = static_cast<double>(info.uordblks + info.hblkhd) -
                         static_cast<double>(bench.document().timeline().bytes());
    return bytes / (1 << 20);
}

class TirelessHand {
public:
    TirelessHand(Workbench& bench, unsigned seed) : bench_(bench), random_(seed) {}

    void act() {
        try {
            doSomething();
        } catch (const std::exception& error) {
            // A refusal, such as a polygon that crosses itself: one sentence, and nothing changed.
            EXPECT_NE(std::string(error.what()), "");
            bench_.cancel();
        }
    }

private:
    double share() { return std::uniform_real_distribution(0.0, 1.0)(random_); }
    Point somewhere() { return {12 * share() - 6, 6 * share() + 0.2}; }

    void useATool() {
        bench_.setTool(
            allTools()[static_cast<std::size_t>(share() * static_cast<double>(allTools().size()))]);
        const Point from = somewhere();
        const Point to = from + Point(4 * share() - 2, 3 * share() - 1.5);
        const bool shift = share() < 0.1;
        bench_.press({.position = from, .shift = shift});
        for (int i = 1; i <= 3; ++i)
            bench_.move({.position = from + (to - from) * i / 3, .shift = shift});
        if (bench_.document().playing()) play(20);
        bench_.release({.position = to, .shift = shift});
        if (share() < 0.1) bench_.finish();
    }
    void play(int ticks) {
        for (int i = 0; i < ticks; ++i) bench_.tick();
    }
    void rewind() {
        const Timeline& timeline = bench_.document().timeline();
        if (timeline.empty()) return;
        const std::uint32_t line = timeline.line();
        const auto span = static_cast<double>(timeline.last(line) - timeline.first(line));
        bench_.document().goTo(
            {line, timeline.first(line) + static_cast<std::uint64_t>(share() * span)});
        bench_.documentChanged();
    }
    void editTheSelection() {
        const double dice = share();
        if (dice < 0.2)
            bench_.nudge({0.1, 0});
        else if (dice < 0.3)
            bench_.turn(0.3);
        else if (dice < 0.4)
            bench_.scale(share() < 0.5 ? 1.1 : 1 / 1.1);
        else if (dice < 0.5)
            bench_.mirror();
        else if (dice < 0.7)
            bench_.duplicate();
        else if (dice < 0.8)
            bench_.paste(bench_.copy(), {0.3, 0.3});
        else
            bench_.deleteSelection();
    }
    void doSomething() {
        const double dice = share();
        Document& document = bench_.document();
        if (dice < 0.35)
            useATool();
        else if (dice < 0.5)
            play(25);
        else if (dice < 0.55)
            document.playing() ? document.pause() : document.play();
        else if (dice < 0.6)
            rewind();
        else if (dice < 0.75)
            document.undo();
        else if (dice < 0.8)
            document.redo();
        else if (dice < 0.83)
            bench_.dropBoxes(5);
        else if (dice < 0.84)
            document.reset();
        else if (dice < 0.87)
            bench_.selectAll();
        else if (dice < 0.98) {
            if (!bench_.selection().empty()) editTheSelection();
        } else
            document.setConstants({.gravity = 20 * share() - 5});
        bench_.documentChanged();
    }

    Workbench& bench_;
    std::mt19937 random_;
};

// From time to time everything is removed; what is left then is what has been gathered.
TEST(Endurance, MemoryCeasesToGrow) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer has its own memory";
#endif
    const int things = asked("PLAY", 1200);
    Workbench bench;
    TirelessHand hand(bench, static_cast<unsigned>(asked("SEED", 1)));
    const int rounds = 6;
    double first = 0;
    for (int round = 1; round <= rounds; ++round) {
        for (int i = 0; i < things / rounds; ++i) {
            hand.act();
            if (bench.document().world().bodies().size() < 150) continue;
            bench.document().reset();
            bench.selectAll();
            bench.deleteSelection();
        }
        bench.document().reset();
        bench.selectAll();
        bench.deleteSelection();
        const double now = inUse(bench);
        std::printf("  after %d things: %.1f MiB in use, %.1f MiB recorded, %zu steps\n",
                    round * (things / rounds), now,
                    static_cast<double>(bench.document().timeline().bytes()) / (1 << 20),
                    bench.document().historyPlace());
        if (round == 2) first = now;
        if (round > 2) {
            EXPECT_LT(now, 1.1 * first + 1);
        }
    }
}

}  // namespace
}  // namespace sulfurchamber
