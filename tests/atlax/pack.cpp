#include <gtest/gtest.h>

#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/pack.hpp>
#include <random>

#include "pack_samples.hpp"
#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace atlax;

Pack packOf(const std::vector<PackedFile>& files, const PackLimits& limits = {}) {
    return Pack::fromBytes(asBytes(packBytes(files)), "test.zip", limits);
}

/// What a refused pack says; empty when it was accepted.
std::string refusal(const std::vector<PackedFile>& files, const PackLimits& limits = {}) {
    try {
        packOf(files, limits).verify();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

testing::AssertionResult saysOf(const std::string& message, const std::string& part) {
    if (message.find("test.zip") == std::string::npos || message.find(part) == std::string::npos)
        return testing::AssertionFailure() << "\"" << message << "\" lacks \"" << part << "\"";
    return testing::AssertionSuccess();
}

TEST(Pack, storedAndDeflatedFilesAreRead) {
    const std::string large(300'000, 'x');
    const Pack pack = packOf({{.name = "b/deep/large", .content = large, .deflated = true},
                              {.name = "a.txt", .content = "hello"},
                              {.name = "empty", .content = ""},
                              {.name = "b/", .content = "", .mode = 040755}});
    pack.verify();
    ASSERT_EQ(pack.entries().size(), 3u);
    EXPECT_EQ(pack.entries()[0].name, "a.txt");
    EXPECT_EQ(asText(pack.read("a.txt", 5)), "hello");
    EXPECT_EQ(asText(pack.read("b/deep/large", large.size())), large);
    EXPECT_TRUE(pack.read("empty", 0).empty());
    EXPECT_THROW(pack.read("a.txt", 4), Error) << "reads are bounded";
    EXPECT_THROW(pack.read("b", 100), Error);
}

TEST(Pack, namesThatClimbOutAreRefused) {
    for (const char* name : {"../x", "a/../../x", "/etc/x", "a//b", "./a", "a/.", "..", "a\\..\\b",
                             "C:x", "a\nb", "\xff"})
        EXPECT_TRUE(saysOf(refusal({{.name = name, .content = "x"}}), "leads out")) << name;
    EXPECT_FALSE(isPlainName(".."));
    EXPECT_FALSE(isPlainName("../x"));
    EXPECT_FALSE(isPlainName("a/../x"));
    EXPECT_FALSE(isPlainName("/x"));
    EXPECT_FALSE(isPlainName(""));
    EXPECT_FALSE(isPlainName("a/"));
    EXPECT_FALSE(isPlainName("\xff"));
    EXPECT_FALSE(isPlainName(std::string(256, 'a')));
    EXPECT_TRUE(isPlainName("..a/b..c/\xc3\xa4"));
}

TEST(Pack, linksAndOtherThingsAreRefused) {
    EXPECT_TRUE(saysOf(refusal({{.name = "l", .content = "/etc", .mode = 0120777}}), "link"));
    EXPECT_TRUE(saysOf(refusal({{.name = "d", .content = "", .mode = 0020644}}), "neither"));
    EXPECT_TRUE(saysOf(refusal({{.name = "f", .content = "", .mode = 0040755}}), "folder"));
    EXPECT_TRUE(saysOf(refusal({{.name = "e", .content = "x", .flags = 1}}), "encrypted"));
    EXPECT_TRUE(saysOf(refusal({{.name = "s", .content = "x", .flags = 8}}), "feature"));
    EXPECT_TRUE(saysOf(refusal({{.name = "m", .content = "x", .method = 12}}), "method"));
    EXPECT_TRUE(saysOf(refusal({{.name = "\xc3\xa4", .content = "x"}}), "UTF-8"));
    EXPECT_EQ(refusal({{.name = "\xc3\xa4", .content = "x", .flags = 1u << 11}}), "");
}

TEST(Pack, liesAboutSizesAreRefused) {
    const std::string zeros(100'000, '\0');
    const auto lie = [&](std::int64_t size) {
        return refusal({{.name = "z", .content = zeros, .deflated = true, .claimedSize = size}});
    };
    EXPECT_EQ(lie(100'000), "");
    EXPECT_TRUE(saysOf(lie(10), "more bytes than it says"));
    EXPECT_TRUE(saysOf(lie(99'999), "more bytes than it says"));
    EXPECT_TRUE(saysOf(lie(100'001), "fewer bytes"));
    EXPECT_TRUE(saysOf(refusal({{.name = "s", .content = "abc", .claimedSize = 5}}), "lies"));
    EXPECT_TRUE(saysOf(refusal({{.name = "s", .content = "abc", .localClaimedSize = 2}}), "lies"));
    EXPECT_TRUE(saysOf(refusal({{.name = "s", .content = "abc", .claimedCrc = 7}}), "checksum"));
    EXPECT_TRUE(saysOf(lie(0xffffffff), "allowed"));
}

TEST(Pack, limitsHold) {
    const std::vector<PackedFile> files{{.name = "a", .content = "0123456789"},
                                        {.name = "b", .content = "0123456789"}};
    EXPECT_EQ(refusal(files, {.totalBytes = 20, .fileBytes = 10, .entries = 2}), "");
    EXPECT_TRUE(saysOf(refusal(files, {.totalBytes = 19}), "19"));
    EXPECT_TRUE(saysOf(refusal(files, {.fileBytes = 9}), "9 are allowed"));
    EXPECT_TRUE(saysOf(refusal(files, {.entries = 1}), "entries"));
    EXPECT_TRUE(saysOf(refusal(files, {.packBytes = 50}), "50"));
}

TEST(Pack, entriesThatShareNamesOrBytesAreRefused) {
    EXPECT_TRUE(
        saysOf(refusal({{.name = "a", .content = "1"}, {.name = "a", .content = "2"}}), "twice"));
    EXPECT_TRUE(saysOf(refusal({{.name = "a", .content = "1"}, {.name = "a/b", .content = "2"}}),
                       "below something that is a file"));
    EXPECT_TRUE(
        saysOf(refusal({{.name = "a", .content = "1"}, {.name = "b", .content = "1", .offset = 0}}),
               "not where"));
    EXPECT_TRUE(saysOf(refusal({{.name = "b/", .content = "", .mode = 040755},
                                {.name = "b/", .content = "", .mode = 040755}}),
                       "twice"))
        << "PhysicsFS would refuse to mount it";
    // The same header twice, as in a bomb whose entries overlap.
    std::string bytes = packBytes({{.name = "a", .content = "1"}});
    EXPECT_NO_THROW(Pack::fromBytes(asBytes(bytes), "test.zip"));
    EXPECT_THROW(Pack::fromBytes(asBytes("x" + bytes), "test.zip"), Error);
}

TEST(Pack, whatIsCutShortOrLongerIsRefused) {
    const std::string bytes = packBytes(
        {{.name = "a", .content = "hello", .deflated = true}, {.name = "b", .content = "world"}});
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_THROW(Pack::fromBytes(asBytes(bytes.substr(0, length)), "test.zip"), Error)
            << length;
    EXPECT_THROW(Pack::fromBytes(asBytes(bytes + "x"), "test.zip"), Error);
    EXPECT_THROW(
        Pack::fromBytes(asBytes(packBytes({{.name = "a", .content = "x"}}, "note")), "test.zip"),
        Error);
}

/// Any single change is refused, or harms only what nobody reads (dates and versions).
TEST(Pack, noDamageGoesUnnoticed) {
    const std::string good =
        packBytes({{.name = "a", .content = std::string(500, 'a') + "b", .deflated = true},
                   {.name = "b/c", .content = "some stored text"}});
    const Pack original = Pack::fromBytes(asBytes(good), "test.zip");
    std::mt19937 random(5);
    int refused = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string bad = good;
        bad[random() % bad.size()] ^= static_cast<char>(1u << random() % 8);
        try {
            const Pack pack = Pack::fromBytes(asBytes(bad), "test.zip");
            pack.verify();
            ASSERT_EQ(pack.entries().size(), original.entries().size());
            for (const PackEntry& entry : pack.entries())
                if (original.find(entry.name) != nullptr) {
                    ASSERT_EQ(pack.read(entry.name, 1000), original.read(entry.name, 1000));
                }
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 2000);
}

TEST(Pack, aFolderGoesThereAndBack) {
    const TemporaryFolder folder;
    writeFileAtomic(folder / "in/a.txt", "hello");
    writeFileAtomic(folder / "in/sub/b", std::string(100'000, 'b'));
    writeFileAtomic(folder / "in/empty", "");
    EXPECT_EQ(makePack(folder / "in", folder / "one.zip"), 3u);
    makePack(folder / "in", folder / "two.zip");
    EXPECT_EQ(readBytes(folder / "one.zip", 10'000), readBytes(folder / "two.zip", 10'000))
        << "the same files give the same bytes";
    const Pack pack = Pack::open(folder / "one.zip");
    EXPECT_EQ(unpack(pack, folder / "out"), 3u);
    EXPECT_EQ(readFile(folder / "out/a.txt", 10), "hello");
    EXPECT_EQ(readFile(folder / "out/sub/b", 100'000), std::string(100'000, 'b'));
    EXPECT_EQ(readFile(folder / "out/empty", 10), "");
}

TEST(Pack, linksAreNeitherPackedNorUnpackedThrough) {
    const TemporaryFolder folder;
    writeFileAtomic(folder / "in/sub/a", "new");
    makePack(folder / "in", folder / "good.zip");
    fs::create_directories(folder / "out");
    fs::create_directories(folder / "elsewhere");
    fs::create_directory_symlink(folder / "elsewhere", folder / "out/sub");
    EXPECT_THROW(unpack(Pack::open(folder / "good.zip"), folder / "out"), Error);
    EXPECT_TRUE(fs::is_empty(folder / "elsewhere"));
    fs::create_symlink("/etc/hostname", folder / "in/link");
    EXPECT_THROW(makePack(folder / "in", folder / "bad.zip"), Error);
    EXPECT_FALSE(fs::exists(folder / "bad.zip"));
    EXPECT_THROW(makePack(folder / "nothing", folder / "bad.zip"), Error);
    EXPECT_THROW(makePack(folder / "elsewhere", folder / "bad.zip"), Error) << "it is empty";
}

TEST(Pack, aBadPackUnpacksNothing) {
    const TemporaryFolder folder;
    const Pack pack = packOf(
        {{.name = "a", .content = "good"}, {.name = "b", .content = "bad", .claimedCrc = 1}});
    EXPECT_THROW(unpack(pack, folder / "out"), Error);
    EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace
