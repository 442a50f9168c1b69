#include <gtest/gtest.h>

#include <atlax/error.hpp>
#include <atlax/file_system.hpp>
#include <atlax/files.hpp>
#include <thread>

#include "pack_samples.hpp"
#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace atlax;

TEST(FileSystem, foldersAndPacksAreOneTree) {
    const TemporaryFolder folder;
    writeFileAtomic(folder / "base/art/hero", "plain hero");
    writeFileAtomic(folder / "base/art/rope", "rope");
    writeFileAtomic(folder / "mod/art/hero", "packed hero");
    makePack(folder / "mod", folder / "mod.zip");
    FileSystem files(folder / "home");
    files.mountFolder(folder / "base");
    EXPECT_EQ(files.readText("art/hero", 100), "plain hero");
    files.mountPack(folder / "mod.zip");
    EXPECT_EQ(files.readText("art/hero", 100), "packed hero") << "the last one comes first";
    EXPECT_EQ(files.readText("art/rope", 100), "rope");
    EXPECT_EQ(files.list("art"), (std::vector<std::string>{"hero", "rope"}));
    EXPECT_EQ(files.mounted().size(), 2u);
    files.unmount(folder / "mod.zip");
    EXPECT_EQ(files.readText("art/hero", 100), "plain hero");
    EXPECT_THROW(files.unmount(folder / "mod.zip"), Error);
}

TEST(FileSystem, mountsMayHaveAPlace) {
    const TemporaryFolder folder;
    writeFileAtomic(folder / "in/a", "text");
    makePack(folder / "in", folder / "in.zip");
    FileSystem files(folder / "home");
    files.mountPack(folder / "in.zip", "some/place");
    EXPECT_EQ(files.readText("some/place/a", 10), "text");
    EXPECT_FALSE(files.exists("a"));
    EXPECT_FALSE(files.exists("some/place")) << "a folder is no file";
    EXPECT_THROW(files.mountFolder(folder / "in", "../up"), Error);
}

TEST(FileSystem, whatIsWrittenComesFirst) {
    const TemporaryFolder folder;
    writeFileAtomic(folder / "base/level", "shipped");
    FileSystem files(folder / "home/of/user");
    files.mountFolder(folder / "base");
    EXPECT_FALSE(fs::exists(folder / "home")) << "made by the first write only";
    files.write("level", "saved");
    EXPECT_EQ(files.readText("level", 100), "saved");
    EXPECT_EQ(readFile(folder / "home/of/user/level", 100), "saved");
    writeFileAtomic(folder / "other/level", "other");
    files.mountFolder(folder / "other");
    EXPECT_EQ(files.readText("level", 100), "saved");
}

TEST(FileSystem, theWriteFolderFollowsXdg) {
    const TemporaryFolder folder;
    ::setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
    {
        FileSystem files(dataFolder("atlax-test"));
        EXPECT_EQ(files.writeFolder(), folder / "atlax-test");
        files.write("x/y", "z");
        EXPECT_EQ(readFile(folder / "atlax-test/x/y", 10), "z");
    }
    ::unsetenv("XDG_DATA_HOME");
}

TEST(FileSystem, readsAreBounded) {
    const TemporaryFolder folder;
    writeFileAtomic(folder / "base/ten", "0123456789");
    FileSystem files(folder / "home");
    files.mountFolder(folder / "base");
    EXPECT_EQ(files.read("ten", 10).size(), 10u);
    EXPECT_THROW(files.read("ten", 9), Error);
    EXPECT_THROW(files.read("missing", 9), Error);
    EXPECT_THROW(files.read("", 9), Error);
}

TEST(FileSystem, nothingLeadsOut) {
    const TemporaryFolder folder;
    writeFileAtomic(folder / "secret", "x");
    writeFileAtomic(folder / "base/inside", "y");
    fs::create_symlink(folder / "secret", folder / "base/link");
    fs::create_directory_symlink(folder.path(), folder / "base/up");
    FileSystem files(folder / "home");
    files.mountFolder(folder / "base");
    for (const char* name : {"../secret", "link", "up/secret", "/etc/hostname", "a/../inside"}) {
        EXPECT_FALSE(files.exists(name)) << name;
        EXPECT_THROW(files.read(name, 100), Error) << name;
    }
    EXPECT_THROW(files.write("../out", "x"), Error);
    fs::create_directories(folder / "home");
    fs::create_directory_symlink(folder.path(), folder / "home/link");
    EXPECT_THROW(files.write("link/out", "x"), Error);
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(FileSystem, aBadPackIsRefusedAndNothingIsMounted) {
    const TemporaryFolder folder;
    const std::string zeros(100'000, '\0');
    const std::vector<std::pair<std::string, std::string>> bad{
        {packBytes({{.name = "../out", .content = "x"}}), "leads out"},
        {packBytes({{.name = "/abs", .content = "x"}}), "leads out"},
        {packBytes({{.name = "good", .content = "x"},
                    {.name = "link", .content = "/etc", .mode = 0120777}}),
         "link"},
        {packBytes({{.name = "good", .content = "x"},
                    {.name = "z", .content = zeros, .deflated = true, .claimedSize = 10}}),
         "lies about its size"},
        {"no pack at all, but long enough", "no zip"}};
    FileSystem files(folder / "home");
    for (const auto& [bytes, reason] : bad) {
        writeFileAtomic(folder / "bad.zip", bytes);
        try {
            files.mountPack(folder / "bad.zip");
            ADD_FAILURE() << "mounted although: " << reason;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
        EXPECT_TRUE(files.mounted().empty());
        EXPECT_TRUE(files.list("").empty());
    }
    EXPECT_THROW(files.mountPack(folder / "missing.zip"), Error);
    EXPECT_THROW(files.mountFolder(folder / "bad.zip"), Error);
}

TEST(FileSystem, thereIsOnlyOne) {
    const TemporaryFolder folder;
    FileSystem files(folder / "home");
    EXPECT_THROW(FileSystem(folder / "other"), Error);
}

TEST(FileSystem, severalThreadsMayRead) {
    const TemporaryFolder folder;
    for (int i = 0; i < 8; ++i)
        writeFileAtomic(folder / ("in/" + std::to_string(i)), std::string(20'000, char('a' + i)));
    makePack(folder / "in", folder / "in.zip");
    FileSystem files(folder / "home");
    files.mountPack(folder / "in.zip");
    std::vector<std::thread> threads;
    std::vector<int> wrong(4);
    for (std::size_t t = 0; t < wrong.size(); ++t)
        threads.emplace_back([&, t] {
            for (int i = 0; i < 40; ++i)
                if (files.readText(std::to_string(i % 8), 20'000) !=
                    std::string(20'000, char('a' + i % 8)))
                    ++wrong[t];
        });
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4));
}

}  // namespace
