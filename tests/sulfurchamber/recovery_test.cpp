// Unsaved work outlives its program, and only that.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "model/recovery.hpp"

namespace sulfurchamber {
namespace {

namespace fs = std::filesystem;

class RecoveryTest : public testing::Test {
protected:
    void SetUp() override { fs::remove_all(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    static void addBox(Document& document, double x) {
        document.edit("Add", [&] {
            document.add("box", sulfur::shapes::BoxOptions{}, {.position = {x, 2}});
        });
    }
    const fs::path folder_ =
        fs::path(testing::TempDir()) / ("sulfurchamber_recovery-" + std::to_string(::getpid()));
};

TEST_F(RecoveryTest, KeepsWhatIsNotSavedUntilItIs) {
    Document document;
    Recovery recovery(folder_);
    EXPECT_EQ(recovery.keep(document), "");
    EXPECT_FALSE(fs::exists(folder_)) << "there is nothing to keep";
    addBox(document, 0);
    EXPECT_EQ(recovery.keep(document), "");
    EXPECT_FALSE(fs::is_empty(folder_));
    EXPECT_TRUE(Recovery::left(folder_).empty()) << "its program runs";
    const auto file = fs::path(testing::TempDir()) / "sulfurchamber_recovered.json";
    document.save(file);
    EXPECT_EQ(recovery.keep(document), "");
    EXPECT_TRUE(fs::is_empty(folder_));
    fs::remove(file);
}

TEST_F(RecoveryTest, WhatAKilledProgramKeptIsFoundAndOpens) {
    const auto child = ::fork();
    if (child == 0) {
        Document document;
        Recovery recovery(folder_);
        addBox(document, 0);
        recovery.keep(document);
        addBox(document, 3);
        recovery.keep(document);
        ::_exit(0);  // without destructors, as when it is killed
    }
    ::waitpid(child, nullptr, 0);
    const auto left = Recovery::left(folder_);
    ASSERT_EQ(left.size(), 1u);
    Document document;
    document.recover(left[0].kept, "/somewhere/scene.json");
    EXPECT_EQ(document.scene().bodies.size(), 3u);
    EXPECT_TRUE(document.modified());
    EXPECT_EQ(document.file(), "/somewhere/scene.json");
    Recovery::discard(left[0]);
    EXPECT_TRUE(Recovery::left(folder_).empty());
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(RecoveryTest, AFolderThatCannotBeMadeIsToldInASentence) {
    Document document;
    addBox(document, 0);
    Recovery recovery("/dev/null/recovery");
    EXPECT_NE(recovery.keep(document), "");
}

}  // namespace
}  // namespace sulfurchamber
