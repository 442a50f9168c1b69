#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <csignal>
#include <cstdlib>

#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace atlax;

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Files, writeAndReadBack) {
    const TemporaryFolder folder;
    const fs::path file = folder / "deep/er/text";
    writeFileAtomic(file, "hello\n");
    EXPECT_EQ(readFile(file, 100), "hello\n");
    EXPECT_EQ(filesIn(file.parent_path()), 1u) << "nothing temporary stays";
    writeFileAtomic(file, "");
    EXPECT_EQ(readFile(file, 100), "");
}

TEST(Files, oneBackupIsKept) {
    const TemporaryFolder folder;
    const fs::path file = folder / "settings";
    writeFileAtomic(file, "one", Backup::KeepOne);
    EXPECT_FALSE(fs::exists(folder / "settings.bak"));
    writeFileAtomic(file, "two", Backup::KeepOne);
    writeFileAtomic(file, "three", Backup::KeepOne);
    EXPECT_EQ(readFile(file, 100), "three");
    EXPECT_EQ(readFile(folder / "settings.bak", 100), "two");
    EXPECT_EQ(filesIn(folder.path()), 2u);
}

TEST(Files, aWriterKilledWhileItBacksUpLeavesNothingForGood) {
    const TemporaryFolder folder;
    const fs::path file = folder / "settings";
    for (const char* left : {"settings.bak.new", "settings.bak"}) {
        writeFileAtomic(file, "one");
        fs::remove(folder / "settings.bak");
        fs::create_hard_link(file, folder / left);  // where it was killed
        writeFileAtomic(file, "two", Backup::KeepOne);
        EXPECT_EQ(readFile(file, 100), "two") << left;
        EXPECT_EQ(readFile(folder / "settings.bak", 100), "one") << left;
        EXPECT_EQ(filesIn(folder.path()), 2u) << left;
    }
}

TEST(Files, readingIsBounded) {
    const TemporaryFolder folder;
    writeFileAtomic(folder / "ten", "0123456789");
    EXPECT_EQ(readFile(folder / "ten", 10).size(), 10u);
    EXPECT_THROW(readFile(folder / "ten", 9), Error);
    EXPECT_EQ(readBytes(folder / "ten", 10).size(), 10u);
}

TEST(Files, onlyRegularFilesAreRead) {
    const TemporaryFolder folder;
    EXPECT_THROW(readFile(folder / "missing", 10), Error);
    EXPECT_THROW(readFile(folder.path(), 10), Error);
    EXPECT_THROW(readFile("/dev/zero", 10), Error);
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_THROW(readFile(folder / "pipe", 10), Error) << "and it must not hang";
}

TEST(Files, aFailedWriteLeavesEverythingAsItWas) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "target");
    EXPECT_THROW(writeFileAtomic(folder / "target", "x"), Error);
    writeFileAtomic(folder / "file", "old");
    EXPECT_THROW(writeFileAtomic(folder / "file/below", "x"), Error);
    EXPECT_EQ(readFile(folder / "file", 10), "old");
    EXPECT_EQ(filesIn(folder.path()), 2u);
    EXPECT_THROW(writeFileAtomic("/dev/full/x", "x"), Error);
}

TEST(Files, behindALinkIsWrittenNotTheLink) {
    const TemporaryFolder folder;
    fs::create_symlink(folder / "real", folder / "link");
    writeFileAtomic(folder / "link", "one");
    writeFileAtomic(folder / "link", "two", Backup::KeepOne);
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(readFile(folder / "real", 10), "two");
    EXPECT_EQ(readFile(folder / "real.bak", 10), "one");
    fs::create_symlink(folder / "round", folder / "round");
    EXPECT_THROW(writeFileAtomic(folder / "round", "x"), Error);
    EXPECT_EQ(filesIn(folder.path()), 4u);
}

TEST(Files, pipesAndDevicesAreNotReplaced) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink("/dev/null", folder / "link");
    EXPECT_THROW(writeFileAtomic(folder / "pipe", "x"), Error);
    EXPECT_THROW(writeFileAtomic(folder / "link", "x"), Error);
    EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_EQ(filesIn(folder.path()), 2u);
}

TEST(Files, whatKilledWritersLeftIsClearedAway) {
    const TemporaryFolder folder;
    for (const char* name : {"file.new-abcdef", "file.new-notes.txt", "file.backup"})
        writeFileAtomic(folder / name, "x");
    const fs::path held = folder / "file.new-ghijkl";
    writeFileAtomic(held, "of a writer that lives");
    const int writer = ::open(held.c_str(), O_RDONLY);
    ASSERT_EQ(::flock(writer, LOCK_EX), 0);
    writeFileAtomic(folder / "file", "new");
    EXPECT_FALSE(fs::exists(folder / "file.new-abcdef"));
    EXPECT_TRUE(fs::exists(held));
    EXPECT_EQ(filesIn(folder.path()), 4u);
    ::close(writer);
}

/// What a process does that is ended by `signal`.
template <class Write>
[[noreturn]] void writeForEver(int signal, const Write& write) noexcept {
    std::signal(signal, SIG_DFL);  // whoever runs the tests may ignore it
    for (;;) write();
}

TEST(Files, anInterruptedWriterLeavesNothing) {
    const TemporaryFolder folder;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        writeFileAtomic(folder / "file", "text", Backup::KeepOne);
        const pid_t writer = ::fork();
        if (writer == 0)
            writeForEver(signal,
                         [&] { writeFileAtomic(folder / "file", "text", Backup::KeepOne); });
        ::usleep(20'000);
        ::kill(writer, signal);
        int status = 0;
        ASSERT_EQ(::waitpid(writer, &status, 0), writer);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
        EXPECT_EQ(readFile(folder / "file", 100), "text");
        EXPECT_EQ(filesIn(folder.path()), 2u) << "the file and its backup";
    }
}

TEST(Files, messagesNameTheFile) {
    try {
        readFile("/no/such/file", 1);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("/no/such/file"), std::string::npos);
    }
}

TEST(Files, xdgFolders) {
    ::setenv("XDG_CONFIG_HOME", "/tmp/config", 1);
    EXPECT_EQ(configFolder("quaoar"), "/tmp/config/quaoar");
    ::setenv("XDG_CONFIG_HOME", "relative/is/ignored", 1);
    ::setenv("HOME", "/home/someone", 1);
    EXPECT_EQ(configFolder("quaoar"), "/home/someone/.config/quaoar");
    ::unsetenv("XDG_DATA_HOME");
    EXPECT_EQ(dataFolder("quaoar"), "/home/someone/.local/share/quaoar");
}

TEST(Assets, areFoundInTheOrderOfFolders) {
    const TemporaryFolder first;
    const TemporaryFolder second;
    writeFileAtomic(first / "art/hero.svg", "first");
    writeFileAtomic(second / "art/hero.svg", "second");
    writeFileAtomic(second / "only", "second");
    ::setenv("ATLAX_TEST_ASSETS", first.path().c_str(), 1);
    const Assets assets({.application = "atlax-test",
                         .environmentVariable = "ATLAX_TEST_ASSETS",
                         .sourceFolder = second.path()});
    EXPECT_EQ(readFile(assets.find("art/hero.svg"), 10), "first");
    EXPECT_EQ(readFile(assets.find("only"), 10), "second");
    EXPECT_FALSE(assets.exists("nothing"));
    EXPECT_THROW(assets.find("nothing"), Error);
    ::unsetenv("ATLAX_TEST_ASSETS");
}

TEST(Assets, namesMayNotClimbOut) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "inside");
    writeFileAtomic(folder / "secret", "x");
    const Assets assets(
        {.application = "", .environmentVariable = "", .sourceFolder = folder / "inside"});
    EXPECT_THROW(assets.find("../secret"), Error);
    EXPECT_THROW(assets.find((folder / "secret").string()), Error);
    EXPECT_THROW(assets.find(""), Error);
    EXPECT_FALSE(assets.exists("../secret"));
}

}  // namespace
