// Small pictures of scenes: drawn once, kept in a folder, drawn anew when a file changes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atlax/files.hpp>
#include <atlax/offscreen.hpp>
#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <thread>

#include "view/skin_textures.hpp"
#include "view/thumbnails.hpp"

namespace sulfurchamber {
namespace {

namespace fs = std::filesystem;

class ThumbnailsTest : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("sulfur-thumbnails-test-" + std::to_string(getpid()));
        fs::remove_all(folder);
        fs::create_directories(folder);
        write("a.json", 1);
    }
    void TearDown() override { fs::remove_all(folder); }

    void write(const std::string& name, int boxes) {
        Document document;
        document.edit("Build", [&] {
            for (int i = 0; i < boxes; ++i)
                document.add("box", sulfur::shapes::BoxOptions{}, {.position = {1.5 * i, 1}});
        });
        document.save(folder / name);
    }
    /// Works until all has come; false when that takes too long.
    bool finish(Thumbnails& thumbnails) {
        offscreen.begin();
        for (int i = 0; i < 2000 && thumbnails.working(); ++i) {
            thumbnails.work(offscreen.canvas());
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        offscreen.finish();
        return !thumbnails.working();
    }
    static std::size_t colours(const atlax::Image& image) {
        std::set<std::array<std::uint8_t, 4>> found;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) found.insert(image.pixel(x, y));
        return found.size();
    }

    fs::path folder;
    atlax::OffscreenCanvas offscreen{{64, 64}};
};

TEST_F(ThumbnailsTest, AreDrawnOnceAndKept) {
    {
        Thumbnails thumbnails(folder / "cache", nullptr, {96, 72});
        EXPECT_EQ(thumbnails.of(folder / "a.json"), nullptr);
        ASSERT_TRUE(finish(thumbnails));
        const atlax::Image* picture = thumbnails.of(folder / "a.json");
        ASSERT_NE(picture, nullptr);
        EXPECT_EQ(picture->width(), 96);
        EXPECT_GT(colours(*picture), 20u) << "one sees a box";
        EXPECT_EQ(thumbnails.drawn(), 1u);
        EXPECT_FALSE(thumbnails.working());
    }
    Thumbnails again(folder / "cache", nullptr, {96, 72});
    again.of(folder / "a.json");
    ASSERT_TRUE(finish(again));
    EXPECT_NE(again.of(folder / "a.json"), nullptr);
    EXPECT_EQ(again.drawn(), 0u) << "it comes from the folder";
}

TEST_F(ThumbnailsTest, FollowTheirFiles) {
    Thumbnails thumbnails(folder / "cache", nullptr, {96, 72});
    thumbnails.of(folder / "a.json");
    ASSERT_TRUE(finish(thumbnails));
    const auto bytes = thumbnails.of(folder / "a.json")->bytes();
    const std::vector<std::uint8_t> before(bytes.begin(), bytes.end());
    write("a.json", 4);
    EXPECT_NE(thumbnails.of(folder / "a.json"), nullptr) << "the old one until the new one comes";
    ASSERT_TRUE(finish(thumbnails));
    const auto after = thumbnails.of(folder / "a.json")->bytes();
    EXPECT_FALSE(std::equal(before.begin(), before.end(), after.begin(), after.end()));
    EXPECT_EQ(thumbnails.drawn(), 2u);
}

TEST_F(ThumbnailsTest, WhatCannotBeReadHasNone) {
    Thumbnails thumbnails(folder / "cache", nullptr, {96, 72});
    atlax::writeFileAtomic(folder / "bad.json", std::string_view("{"));
    EXPECT_EQ(thumbnails.of(folder / "bad.json"), nullptr);
    EXPECT_EQ(thumbnails.of(folder / "none.json"), nullptr);
    ASSERT_TRUE(finish(thumbnails));
    EXPECT_EQ(thumbnails.of(folder / "bad.json"), nullptr);
    EXPECT_FALSE(thumbnails.working()) << "it is not tried again and again";
}

}  // namespace
}  // namespace sulfurchamber
