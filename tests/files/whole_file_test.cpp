#include "whole_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using files::writeWhole;

class WholeFile : public testing::Test {
protected:
    WholeFile() { fs::create_directories(folder_); }
    ~WholeFile() override { fs::remove_all(folder_); }
    static std::string textOf(const fs::path& file) {
        std::stringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    std::ptrdiff_t count() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }

    const fs::path folder_ =
        fs::temp_directory_path() / ("sulfur_files_" + std::to_string(::getpid()));
};

TEST_F(WholeFile, ReplacesAFileAndKeepsWhoMayReadIt) {
    const fs::path file = folder_ / "a.csv";
    writeWhole(file, "one");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    std::ofstream(folder_ / "a.csv.new-abcdef") << "what somebody has left who was killed";
    writeWhole(file, "two");
    EXPECT_EQ(textOf(file), "two");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(count(), 1);
}

TEST_F(WholeFile, ThatIsNewObeysTheMask) {
    const mode_t before = ::umask(027);
    writeWhole(folder_ / "a.csv", "one");
    ::umask(before);
    EXPECT_EQ(fs::status(folder_ / "a.csv").permissions(), fs::perms{0640});
}

TEST_F(WholeFile, KeepsOneBackup) {
    for (const char* text : {"one", "two", "three"})
        writeWhole(folder_ / "a", text, files::Backup::one);
    EXPECT_EQ(textOf(folder_ / "a"), "three");
    EXPECT_EQ(textOf(folder_ / "a.bak"), "two");
    EXPECT_EQ(count(), 2);
}

TEST_F(WholeFile, GoesThroughLinks) {
    writeWhole(folder_ / "behind", "one");
    fs::create_symlink("behind", folder_ / "link");
    fs::create_symlink("free", folder_ / "early");
    for (const char* name : {"link", "early"}) writeWhole(folder_ / name, "two");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "early"));
    EXPECT_EQ(textOf(folder_ / "behind"), "two");
    EXPECT_EQ(textOf(folder_ / "free"), "two");
    EXPECT_EQ(count(), 4);
}

TEST_F(WholeFile, ReplacesNoPipeNoFolderAndNoLinkToNowhere) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    fs::create_directory(folder_ / "folder");
    fs::create_symlink("link", folder_ / "link");
    fs::create_symlink("none/a.csv", folder_ / "astray");
    for (const char* name : {"pipe", "folder", "link", "astray", "pipe/a.csv", "none/a.csv"}) {
        try {
            writeWhole(folder_ / name, "text");
            ADD_FAILURE() << name;
        } catch (const files::NotWritten& problem) {
            EXPECT_NE(std::string(problem.what()).find(folder_.string()), std::string::npos);
        }
    }
    EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(count(), 4);
}

}  // namespace
