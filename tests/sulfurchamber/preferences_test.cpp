// What the sandbox remembers between runs.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/preferences.hpp"

namespace sulfurchamber {
namespace {

class PreferencesTest : public testing::Test {
protected:
    void SetUp() override { std::filesystem::remove_all(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_ =
        std::filesystem::path(testing::TempDir()) / "sulfurchamber_preferences";
    std::filesystem::path file_ = folder_ / "settings.json";
};

TEST_F(PreferencesTest, KeepTheThemeAndTheStepOfTheGrid) {
    EXPECT_EQ(Preferences(file_).theme(), "dark");
    EXPECT_EQ(Preferences(file_).viewOptions().gridStep, 0);
    {
        Preferences preferences(file_);
        preferences.setTheme("light");
        ViewOptions options;
        options.gridStep = 0.25;
        preferences.setViewOptions(options);
        preferences.save();
    }
    EXPECT_EQ(Preferences(file_).theme(), "light");
    EXPECT_EQ(Preferences(file_).viewOptions().gridStep, 0.25);
}

TEST_F(PreferencesTest, TakeOnlyWhatOneCanChoose) {
    {
        Preferences preferences(file_);
        preferences.setTheme("purple");
        ViewOptions options;
        options.gridStep = 1e-9;
        preferences.setViewOptions(options);
        preferences.save();
    }
    EXPECT_EQ(Preferences(file_).theme(), "dark");
    EXPECT_EQ(Preferences(file_).viewOptions().gridStep, 0);
}

}  // namespace
}  // namespace sulfurchamber
