// Files on the disk: whole or not at all.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include "samples.hpp"

namespace {

using namespace sulfur::scene;
using namespace sulfur::scene::testing;
namespace fs = std::filesystem;

class File : public ::testing::Test {
protected:
    File() : folder_(fs::temp_directory_path() / ("sulfur_scene_test_" + unique())) {
        fs::create_directories(folder_);
    }
    ~File() override { fs::remove_all(folder_); }

    static std::string unique() {
        return std::to_string(::getpid()) +
               ::testing::UnitTest::GetInstance()->current_test_info()->name();
    }
    static std::string content(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        std::stringstream text;
        text << stream.rdbuf();
        return text.str();
    }
    std::size_t count() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
};

TEST_F(File, IsWrittenAndReadBack) {
    const Scene scene = parse(fullScene, "a");
    const auto file = folder_ / "scene.json";
    write(scene, file);
    EXPECT_EQ(content(file), format(scene));
    EXPECT_EQ(format(read(file)), format(scene));
    EXPECT_EQ(read(file).file, file.string());
    EXPECT_EQ(count(), 1u);
}

TEST_F(File, KeepsOneBackup) {
    const auto file = folder_ / "scene.json";
    Scene scene;
    for (const char* title : {"one", "two", "three"}) {
        scene.title = title;
        write(scene, file);
    }
    EXPECT_EQ(read(file).title, "three");
    EXPECT_EQ(read(file.string() + ".bak").title, "two");
    EXPECT_EQ(count(), 2u);
}

TEST_F(File, IsUntouchedWhenTheSceneCannotBeRead) {
    const auto file = folder_ / "scene.json";
    Scene scene = parse(fullScene, "a");
    write(scene, file);
    const std::string before = content(file);
    scene.bodies[1].pose.position.x() = std::numeric_limits<double>::quiet_NaN();
    const auto error = errorOf([&] { write(scene, file); });
    EXPECT_EQ(error.object(), "lift");
    EXPECT_EQ(content(file), before);
    EXPECT_EQ(count(), 1u);
}

TEST_F(File, NamesWhatCannotBeReadOrWritten) {
    const auto missing = errorOf([&] { read(folder_ / "none.json"); });
    EXPECT_EQ(missing.line(), 0);
    EXPECT_NE(missing.message().find("not there"), std::string::npos);
    EXPECT_NE(errorOf([&] { read(folder_); }).message().find("folder"), std::string::npos);
    EXPECT_THROW(write(Scene{}, folder_ / "no" / "such.json"), WriteError);
    EXPECT_THROW(write(Scene{}, folder_), WriteError);
    EXPECT_EQ(count(), 0u);
}

TEST_F(File, OfFortyMegabytesOfNothingIsRefused) {
    const auto file = folder_ / "big.json";
    std::ofstream(file) << std::string(40'000'000, '\0');
    const auto error = errorOf([&] { read(file); });
    EXPECT_EQ(error.line(), 1);
    EXPECT_NE(error.message().find("33554432"), std::string::npos);
}

TEST_F(File, BehindALinkIsReplacedNotTheLink) {
    const auto file = folder_ / "scene.json", link = folder_ / "link.json";
    writeFile("{}", file);
    fs::create_symlink(file, link);
    writeFile("[]", link);
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(content(file), "[]");
}

TEST_F(File, BehindALinkNeedNotBeThere) {
    fs::create_symlink(folder_ / "real.json", folder_ / "link.json");
    writeFile("x", folder_ / "link.json");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.json"));
    EXPECT_EQ(content(folder_ / "real.json"), "x");
    fs::create_symlink(folder_ / "round", folder_ / "round");
    EXPECT_THROW(writeFile("x", folder_ / "round"), WriteError);
}

TEST_F(File, IsNoPipe) {
    const auto pipe = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(writeFile("x", pipe), WriteError);
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_EQ(count(), 1u);
}

TEST_F(File, ClearsAwayWhatKilledWritersLeft) {
    const auto file = folder_ / "scene.json";
    for (const char* name : {"scene.json.new-abcdef", "scene.json.new-notes", "scene.json.backup"})
        std::ofstream(folder_ / name) << "x";
    writeFile("new", file);
    EXPECT_FALSE(fs::exists(folder_ / "scene.json.new-abcdef"));
    EXPECT_EQ(count(), 3u);
}

/// What a process does that is ended by `signal`.
template <class Write>
[[noreturn]] void writeForEver(int signal, const Write& write) noexcept {
    std::signal(signal, SIG_DFL);  // whoever runs the tests may ignore it
    for (;;) write();
}

TEST_F(File, IsWholeAndAloneWhenItsWriterIsInterrupted) {
    const auto file = folder_ / "scene.json";
    const std::string text = format(parse(fullScene, "a"));
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        writeFile(text, file);
        const pid_t writer = ::fork();
        if (writer == 0) writeForEver(signal, [&] { writeFile(text, file); });
        ::usleep(20'000);
        ::kill(writer, signal);
        int status = 0;
        ASSERT_EQ(::waitpid(writer, &status, 0), writer);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
        EXPECT_EQ(content(file), text);
        EXPECT_EQ(count(), 2u) << "the scene and its backup";
    }
}

TEST_F(File, OfABlueprint) {
    const Prefab crate = makePrefab("crate", sulfur::shapes::BoxOptions{.mass = 3}, "crate.png");
    writeBlueprint(crate, folder_ / "crate.json");
    const Prefab back = readBlueprint(folder_ / "crate.json");
    EXPECT_EQ(back.blueprint.name, "crate");
    EXPECT_EQ(back.blueprint.mass(), crate.blueprint.mass());
    EXPECT_EQ(back.blueprint.skin->triangles.size(), 4u);
}

}  // namespace
