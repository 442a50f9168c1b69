#include "write_whole.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace {

namespace fs = std::filesystem;
using sulfur::lab::writeWhole;

class WriteWhole : public testing::Test {
protected:
    WriteWhole() { fs::create_directories(folder_); }
    ~WriteWhole() override { fs::remove_all(folder_); }
    static std::string textOf(const fs::path& file) {
        std::stringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }

    const fs::path folder_ =
        fs::temp_directory_path() / ("sulfur_lab_write_" + std::to_string(::getpid()));
};

TEST_F(WriteWhole, ReplacesAFileAndKeepsWhoMayReadIt) {
    const fs::path file = folder_ / "a.csv";
    writeWhole(file, "one");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    std::ofstream(folder_ / "a.csv.new") << "what somebody has left who was killed";
    writeWhole(file, "two");
    EXPECT_EQ(textOf(file), "two");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(files(), 1);
}

TEST_F(WriteWhole, GoesThroughLinks) {
    writeWhole(folder_ / "behind", "one");
    fs::create_symlink("behind", folder_ / "link");
    writeWhole(folder_ / "link", "two");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(textOf(folder_ / "behind"), "two");
    EXPECT_EQ(files(), 2);
}

TEST_F(WriteWhole, ReplacesNoPipeNoFolderAndNoLinkToNowhere) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    fs::create_directory(folder_ / "folder");
    fs::create_symlink("nowhere", folder_ / "link");
    for (const char* name : {"pipe", "folder", "link", "pipe/a.csv", "none/a.csv"})
        EXPECT_THROW(writeWhole(folder_ / name, "text"), std::runtime_error) << name;
    EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(files(), 3);
}

}  // namespace
