// Levels with the game's own rules: problems, proofs, publishing, the play-test.
#include <gtest/gtest.h>

#include <atlax/backend.hpp>
#include <atlax/files.hpp>
#include <atlax/offscreen.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <thread>

#include "level/level_stage.hpp"
#include "model/level_pieces.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

std::filesystem::path levelFile(const std::string& name) {
    return std::filesystem::path(QUAOAR_LEVELS) / (name + ".json");
}

struct Folder {
    Folder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        path = std::filesystem::temp_directory_path() /
               (std::string("sulfurchamber-") + test->test_suite_name() + "-" + test->name());
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path path;
};

// Lets the desk follow until something holds.
bool waitFor(LevelDesk& desk, const std::function<bool()>& holds, double seconds = 120) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < end) {
        desk.follow();
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
}

std::vector<LevelProblem> problemsOf(const Document& document) {
    return checkLevelText(document.text(), "level.json").problems;
}

// One room without a pit, which is soon solved.
void openRoom(Document& document) {
    document.adopt(newLevel());
    document.edit("x", [&] {
        JsonText text(document.levelText());
        text.set({"exit", "position"}, "[3.5, 0.4]");
        document.setLevelText(text.text());
    });
}

TEST(LevelProblems, TheGamesOwnLevelsHaveNoGraveOnes) {
    for (const char* name : {"01-cold-wake", "07-ammonia-bog", "20-clockwork"}) {
        Document document;
        document.open(levelFile(name));
        const auto report = checkLevelText(document.text(), levelFile(name));
        EXPECT_TRUE(report.playable()) << name;
        for (const auto& problem : report.problems) EXPECT_FALSE(problem.grave) << problem.text;
    }
}

TEST(LevelProblems, ANewLevelHasNone) {
    Document document;
    document.adopt(newLevel());
    for (const auto& problem : problemsOf(document)) ADD_FAILURE() << problem.text;
}

TEST(LevelProblems, SpawnAndExitInTheGroundAreFound) {
    Document document;
    document.adopt(newLevel());
    document.edit("x", [&] { moveThing(document, {LevelKind::exit, 0, {}}, {0, -1.2}); });
    auto problems = problemsOf(document);
    ASSERT_FALSE(problems.empty());
    EXPECT_TRUE(problems[0].grave);
    EXPECT_EQ(problems[0].thing->kind, LevelKind::exit);
    document.undo();
    document.edit("x", [&] { moveThing(document, {LevelKind::spawn, 0, {}}, {0, 3}); });
    problems = problemsOf(document);
    ASSERT_FALSE(problems.empty());
    EXPECT_EQ(problems[0].thing->kind, LevelKind::spawn);
    EXPECT_TRUE(problems[0].place);
}

TEST(LevelProblems, AnExitThatIsCutOffIsFound) {
    Document document;
    document.adopt(newLevel());
    document.edit("wall", [&] {
        placePiece(document, LevelPiece::ground, {8, -0.5}, {8.5, 4}, {});
    });
    const auto problems = problemsOf(document);
    ASSERT_FALSE(problems.empty());
    EXPECT_NE(problems[0].text.find("cut off"), std::string::npos);
    EXPECT_EQ(problems[0].thing->kind, LevelKind::exit);
}

TEST(LevelProblems, TextsOutsideAndBareFloorsAreAdvice) {
    Document document;
    document.adopt(newLevel());
    document.edit("x", [&] { moveThing(document, {LevelKind::hint, 0, {}}, {0, 20}); });
    auto problems = problemsOf(document);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_FALSE(problems[0].grave);
    EXPECT_EQ(problems[0].thing->kind, LevelKind::hint);
    document.undo();
    document.edit("x", [&] {
        const sulfur::BodyId ceiling = document.bodyOf("ceiling");
        document.translate({&ceiling, 1}, {0, 4});
        JsonText text(document.levelText());
        text.set({"bounds", "max"}, "[13, 6]");
        document.setLevelText(text.text());
    });
    problems = problemsOf(document);
    ASSERT_FALSE(problems.empty());
    EXPECT_NE(problems[0].text.find("Nothing that the rope holds on"), std::string::npos);
    EXPECT_FALSE(problems[0].grave);
}

// The reader stops at the first mistake; the list has all of them, each with its thing.
TEST(LevelProblems, AllRefusalsOfTheReaderAreTold) {
    Document document;
    document.adopt(newLevel());
    document.edit("x", [&] {
        addThing(document, LevelKind::zone, R"({"id": "a", "min": [0, 0], "max": [0, 1]})");
        addThing(document, LevelKind::zone,
                 R"({"id": "b", "min": [0, 0], "max": [1, 1], "deadly": true})");
        addThing(document, LevelKind::zone, R"({"id": "c", "min": [0, 0], "max": [1, 1]})");
        addThing(document, LevelKind::monster, R"({"body": "ground", "behaviour": "chase"})");
    });
    const auto problems = problemsOf(document);
    ASSERT_EQ(problems.size(), 3u);
    EXPECT_EQ(problems[0].thing, (LevelThing{LevelKind::zone, 0, {}}));
    EXPECT_EQ(problems[1].thing, (LevelThing{LevelKind::zone, 2, {}}));
    EXPECT_EQ(problems[2].thing, (LevelThing{LevelKind::monster, 0, {}}));
}

// --- the desk --------------------------------------------------------------------------------

TEST(LevelDesk, ChecksBesideTheEditing) {
    Document document;
    document.adopt(newLevel());
    LevelDesk desk(document);
    ASSERT_TRUE(waitFor(desk, [&] { return desk.checked(); }));
    EXPECT_TRUE(desk.playable());
    EXPECT_NE(desk.takeSession(), nullptr);
    EXPECT_EQ(desk.takeSession(), nullptr);
    document.edit("x", [&] { moveThing(document, {LevelKind::spawn, 0, {}}, {0, 3}); });
    desk.follow();
    EXPECT_FALSE(desk.checked());
    ASSERT_TRUE(waitFor(desk, [&] { return desk.checked(); }));
    EXPECT_FALSE(desk.playable());
    EXPECT_THROW(desk.search(), std::runtime_error);
    document.undo();
    ASSERT_TRUE(waitFor(desk, [&] { return desk.checked(); }));
    EXPECT_TRUE(desk.playable());
}

TEST(LevelDesk, AProofIsFoundSavedVoidAndTriedAgain) {
    const Folder folder;
    Document document;
    openRoom(document);
    LevelDesk desk(document);
    EXPECT_EQ(desk.proof(), LevelDesk::Proof::none);
    SearchJobOptions options;
    options.polish = 8;
    options.games = 0;
    desk.search(options);
    EXPECT_EQ(desk.proof(), LevelDesk::Proof::asked);
    ASSERT_TRUE(waitFor(desk, [&] { return desk.job()->progress().over(); }));
    desk.follow();
    ASSERT_EQ(desk.proof(), LevelDesk::Proof::holds) << desk.proofText();
    EXPECT_GT(desk.result()->way.size(), 2u);
    const auto file = folder.path / "room.json";
    document.save(file);
    desk.saved();
    const auto level = std::make_shared<const quaoar::Level>(quaoar::readLevel(file));
    const auto verdict = quaoar::verify(level, quaoar::Recording::read(quaoar::proofOf(file)));
    EXPECT_TRUE(verdict.finished && verdict.sameAsRecorded);

    // An edit makes it void; undo brings it back; what is known is tried first.
    document.edit("x", [&] { moveThing(document, {LevelKind::hint, 0, {}}, {0.5, 0}); });
    EXPECT_EQ(desk.proof(), LevelDesk::Proof::outdated);
    EXPECT_NE(desk.proofText().find("void"), std::string::npos);
    document.undo();
    EXPECT_EQ(desk.proof(), LevelDesk::Proof::holds);
    desk.takeMedals();
    ASSERT_TRUE(waitFor(desk, [&] { return desk.proof() == LevelDesk::Proof::holds; }));
    const double gold = *JsonText(document.levelText()).number({"medals", "gold"});
    EXPECT_NEAR(gold, 1.15 * quaoar::secondsOf(desk.result()->proof.ticks()), 0.11);

    const auto published = desk.publish(folder.path / "game");
    EXPECT_EQ(published.filename(), "new-level.json");
    const auto theirs = std::make_shared<const quaoar::Level>(quaoar::readLevel(published));
    EXPECT_TRUE(
        quaoar::verify(theirs, quaoar::Recording::read(quaoar::proofOf(published))).sameAsRecorded);
}

TEST(LevelDesk, TheProofBesideAFileIsReplayed) {
    Document document;
    document.open(levelFile("01-cold-wake"));
    LevelDesk desk(document);
    desk.opened();
    ASSERT_TRUE(waitFor(desk, [&] { return desk.proof() == LevelDesk::Proof::holds; }));
    std::ifstream proof(quaoar::proofOf(levelFile("01-cold-wake")));
    std::string word;
    while (proof >> word && word != "ticks") {
    }
    double ticks = 0;
    ASSERT_TRUE(proof >> ticks);
    std::ostringstream told;
    told << "It can be finished in " << std::fixed << std::setprecision(1)
         << ticks / quaoar::Session::tickRate << " s";
    EXPECT_NE(desk.proofText().find(told.str()), std::string::npos) << desk.proofText();
}

TEST(LevelDesk, WhatCannotBePlayedIsNotPublished) {
    const Folder folder;
    Document document;
    LevelDesk desk(document);
    EXPECT_THROW(desk.publish(folder.path), std::runtime_error);
    document.adopt(newLevel());
    document.edit("x", [&] { moveThing(document, {LevelKind::spawn, 0, {}}, {0, 3}); });
    EXPECT_THROW(desk.publish(folder.path), std::runtime_error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path));
    document.undo();
    const auto file = desk.publish(folder.path);
    EXPECT_EQ(atlax::readFile(file, 1 << 20), document.text());
    EXPECT_FALSE(std::filesystem::exists(quaoar::proofOf(file)));
}

// --- searching -------------------------------------------------------------------------------

TEST(SearchJob, TellsItsFrontierAndStopsAtOnce) {
    auto level =
        std::make_shared<const quaoar::Level>(quaoar::readLevel(levelFile("13-weywot-rising")));
    SearchJob job(level, {});
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (job.frontier().empty() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_FALSE(job.frontier().empty());
    EXPECT_GT(job.progress().nearest, 1);
    job.stop();
    const auto before = std::chrono::steady_clock::now();
    while (!job.progress().over() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(job.progress().stage, SearchProgress::Stage::stopped);
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(2));
}

TEST(SearchJob, WhatHasNoWayFailsWithItsReason) {
    Document document;
    document.adopt(newLevel());
    document.edit("wall", [&] {
        placePiece(document, LevelPiece::ground, {8, -0.5}, {8.5, 4}, {});
    });
    SearchJob job(
        std::make_shared<const quaoar::Level>(quaoar::parseLevel(document.text(), "level.json")),
        {});
    while (!job.progress().over()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    EXPECT_EQ(job.progress().stage, SearchProgress::Stage::failed);
    EXPECT_EQ(job.progress().problem, "no free space leads from the spawn to the exit");
}

TEST(SearchJob, TheRobustBotIsAsked) {
    Document document;
    openRoom(document);
    SearchJobOptions options;
    options.polish = 8;
    options.rounds = 1;
    options.games = 4;
    SearchJob job(
        std::make_shared<const quaoar::Level>(quaoar::parseLevel(document.text(), "level.json")),
        options);
    while (!job.progress().over()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ASSERT_EQ(job.progress().stage, SearchProgress::Stage::done) << job.progress().problem;
    EXPECT_EQ(job.result()->robust.survival.games, 4);
    EXPECT_GT(job.result()->robust.survival.share(), 0);
}

// --- the play-test ---------------------------------------------------------------------------

// The drawing area with a level, run without a window until `done`.
class Stage final : public atlax::Application {
public:
    explicit Stage(const std::filesystem::path& file) {
        bench.document().open(file);
        stage.opened();
    }
    void start(atlax::Platform& platform) override {
        platform_ = &platform;
        view.start(platform);
    }
    void event(const atlax::Event& event) override { view.event(event); }
    void tick() override { view.tick(); }
    void draw(atlax::Canvas& canvas, double alpha) override {
        view.draw(canvas, alpha);
        stage.follow();
        onFrame(*this, canvas);
    }
    void stop() override { view.stop(); }
    void quit() { platform_->quit(); }

    Workbench bench;
    SceneView view{bench};
    LevelStage stage{bench, view};
    std::function<void(Stage&, atlax::Canvas&)> onFrame;
    int frames = 0;

private:
    atlax::Platform* platform_ = nullptr;
};

TEST(PlayTest, RunsTheGameAndComesBackToWhereOneWas) {
    Stage app(levelFile("01-cold-wake"));
    const std::string before = app.bench.document().text();
    app.onFrame = [&](Stage& it, atlax::Canvas&) {
        ++it.frames;
        if (it.frames == 3) it.stage.play();
        if (it.frames == 10) {
            ASSERT_NE(it.stage.test(), nullptr);
            EXPECT_GT(it.stage.test()->session().ticks(), 20u);
            EXPECT_GT(it.stage.firstPicture(), 0);
            EXPECT_TRUE(it.view.hasGuest());
            it.stage.endPlay();
        }
        if (it.frames == 12) it.stage.play(Point(6, 1.2));
        if (it.frames == 14) {
            ASSERT_NE(it.stage.test(), nullptr);
            EXPECT_NEAR(it.stage.test()->session().heroPosition().x(), 6, 0.2);
            it.stage.endPlay();
            EXPECT_FALSE(it.view.hasGuest());
            it.quit();
        }
    };
    ASSERT_EQ(atlax::runOffscreen(app, {.size = {640, 400}}), 0);
    EXPECT_EQ(app.bench.document().text(), before);
    EXPECT_FALSE(app.bench.document().canUndo());
    EXPECT_DOUBLE_EQ(app.bench.document().world().time(), 0);
}

TEST(PlayTest, TheSecondPictureOfALevelTakesItsGroundsFromTheFirst) {
    Stage app(levelFile("01-cold-wake"));
    app.onFrame = [&](Stage& it, atlax::Canvas&) {
        // Once the editor has its picture, the play-test begins at once.
        if (it.frames == 0 && !it.stage.desk().checked()) return;
        ++it.frames;
        if (it.frames == 3) it.stage.play();
        if (it.frames < 6) return;
        EXPECT_LT(it.stage.firstPicture(), 3);  // 0.3 s on an idle machine
        it.quit();
    };
    ASSERT_EQ(atlax::runOffscreen(app, {.size = {640, 400}}), 0);
}

TEST(PlayTest, AFinishByHandIsAProof) {
    Document document;
    document.open(levelFile("01-cold-wake"));
    LevelDesk desk(document);
    const auto proof = quaoar::Recording::read(quaoar::proofOf(levelFile("01-cold-wake")));
    desk.offer(proof);
    ASSERT_TRUE(waitFor(desk, [&] { return desk.proof() == LevelDesk::Proof::holds; }));
}

}  // namespace
}  // namespace sulfurchamber
