#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/settings.hpp>
#include <cmath>
#include <csignal>
#include <random>

#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace atlax;
using Strings = std::vector<std::string>;

constexpr auto sampleText =
    R"({"version": 1, "settings": {"a": true, "b.c": 7, "d": 0.5, "e": "text", "f": ["x", "y"]}})";

/// Runs `body` in a process of its own, because it changes limits or the user; true when it
/// returned true.
template <class Body>
bool inChild(Body body) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(body() ? 0 : 1);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(Settings, everyKindGoesThereAndBack) {
    const TemporaryFolder folder;
    Settings out({.file = folder / "home/settings.json"});
    EXPECT_EQ(out.load(), Settings::Origin::Defaults);
    EXPECT_EQ(out.problem(), "") << "a first start is no problem";
    out.set("flag", true);
    out.set("count", 42);
    out.set("volume", 0.1);
    out.set("name", "J\xc3\xbcrgen \"x\"\n");
    out.set("list", Strings{"key:W", "pad:South"});
    EXPECT_TRUE(out.changed());
    out.save();
    EXPECT_FALSE(out.changed());

    Settings in({.file = folder / "home/settings.json"});
    EXPECT_EQ(in.load(), Settings::Origin::File);
    EXPECT_EQ(in.values(), out.values());
    EXPECT_TRUE(in.get("flag", false));
    EXPECT_EQ(in.get("count", std::int64_t{0}), 42);
    EXPECT_EQ(in.get("count", 7), 42);
    EXPECT_EQ(in.get("count", 7, 0, 10), 7);
    EXPECT_EQ(in.get("volume", 0.0, 0, 1), 0.1);
    EXPECT_EQ(in.get("name", ""), "J\xc3\xbcrgen \"x\"\n");
    EXPECT_EQ(in.get("list", Strings{}), (Strings{"key:W", "pad:South"}));
}

TEST(Settings, whatIsMissingOrOutOfRangeHasItsDefault) {
    Settings settings({.file = "/nowhere"});
    settings.set("n", 12);
    settings.set("d", 1.5);
    EXPECT_EQ(settings.get("n", std::int64_t{3}, 0, 10), 3);
    EXPECT_EQ(settings.get("n", 3.0, 0, 20), 12);
    EXPECT_EQ(settings.get("d", 0.25, 0, 1), 0.25);
    EXPECT_EQ(settings.get("d", std::int64_t{4}), 4) << "a fraction is no integer";
    EXPECT_EQ(settings.get("missing", "word"), "word");
    EXPECT_EQ(settings.get("n", "word"), "word");
    EXPECT_TRUE(settings.get("n", true));
    settings.erase("n");
    EXPECT_FALSE(settings.has("n"));
}

TEST(Settings, nonsenseIsNotTaken) {
    Settings settings({.file = "/nowhere"});
    for (const std::string key : {"", "Upper", "sp ace", "a/b", "\xc3\xa4"})
        EXPECT_THROW(settings.set(key, 1), Error) << key;
    EXPECT_THROW(settings.set(std::string(65, 'a'), 1), Error);
    EXPECT_THROW(settings.set("x", std::nan("")), Error);
    EXPECT_THROW(settings.set("x", "\xff"), Error);
    EXPECT_THROW(settings.set("x", Strings{"ok", "\xc0\x80"}), Error);
    EXPECT_TRUE(settings.values().empty());
    EXPECT_FALSE(settings.changed());
    EXPECT_THROW(Settings({.file = "/x", .version = 0}), Error);
}

TEST(Settings, badTextsAreRefusedWithAReason) {
    const std::vector<std::pair<std::string, std::string>> bad{
        {"", "JSON"},
        {"[]", "object"},
        {"{\"version\": 1}", "settings"},
        {R"({"version": 0, "settings": {}})", "version"},
        {R"({"version": 1.5, "settings": {}})", "version"},
        {R"({"version": 1, "settings": []})", "object"},
        {R"({"version": 1, "settings": {"A": 1}})", "no name"},
        {R"({"version": 1, "settings": {"a": null}})", "\"a\""},
        {R"({"version": 1, "settings": {"a": {}}})", "\"a\""},
        {R"({"version": 1, "settings": {"a": [1]}})", "texts"},
        {R"({"version": 1, "settings": {"a": 18446744073709551615}})", "too large"},
        {R"({"version": 1, "settings": {"a": 1e999}})", "JSON"},
        {R"({"version": 1, "settings": {"a": [[[[]]]]}})", "deep"},
        {std::string(maxSettingsBytes + 1, ' '), "long"}};
    for (const auto& [text, reason] : bad) {
        try {
            parseSettings(text, "file.json");
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find("file.json"), 0u) << message;
            EXPECT_NE(message.find(reason), std::string::npos) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos);
        }
    }
    EXPECT_EQ(parseSettings(sampleText, "x").values.size(), 5u);
}

TEST(Settings, mutatedTextsAreReadOrRefused) {
    std::mt19937 random(11);
    int good = 0, refused = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string text = sampleText;
        for (unsigned n = 1 + random() % 3; n > 0; --n) {
            const auto at = random() % text.size();
            if (random() % 3 == 0)
                text.erase(at, 1);
            else
                text[at] = static_cast<char>(random() % 2 ? '0' + random() % 10 : random());
        }
        try {
            const auto document = parseSettings(text, "fuzz");
            ++good;
            const std::string once = formatSettings(document);
            ASSERT_EQ(formatSettings(parseSettings(once, "again")), once);
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(good, 200);
    EXPECT_GT(refused, 1000);
}

TEST(Settings, aDamagedFileIsSetAsideAndTheBackupIsUsed) {
    const TemporaryFolder folder;
    const fs::path file = folder / "settings.json";
    Settings settings({.file = file});
    settings.set("n", 1);
    settings.save();
    settings.set("n", 2);
    settings.save();
    writeFileAtomic(file, "{\"version\": 1, \"sett");
    EXPECT_EQ(settings.load(), Settings::Origin::Backup);
    EXPECT_EQ(settings.get("n", std::int64_t{0}), 1);
    EXPECT_NE(settings.problem().find("settings.json.damaged-1"), std::string::npos);
    EXPECT_EQ(readFile(folder / "settings.json.damaged-1", 100), "{\"version\": 1, \"sett");
    EXPECT_FALSE(fs::exists(file));
    EXPECT_TRUE(settings.changed()) << "the next save brings the file back";
    settings.save();
    EXPECT_EQ(Settings({.file = file}).load(), Settings::Origin::File);
}

TEST(Settings, whenNothingCanBeReadTheDefaultsHold) {
    const TemporaryFolder folder;
    const fs::path file = folder / "settings.json";
    for (int i = 0; i < 12; ++i) {
        writeFileAtomic(file, "damage " + std::to_string(i));
        writeFileAtomic(folder / "settings.json.bak", "damage too");
        Settings settings({.file = file});
        EXPECT_EQ(settings.load(), Settings::Origin::Defaults);
        EXPECT_TRUE(settings.values().empty());
    }
    EXPECT_EQ(readFile(folder / "settings.json.damaged-8", 100), "damage 7");
    EXPECT_EQ(readFile(folder / "settings.json.damaged-9", 100), "damage 11") << "they end at 9";
}

TEST(Settings, aFileOfANewerProgramIsKept) {
    const TemporaryFolder folder;
    const fs::path file = folder / "settings.json";
    Settings newer({.file = file, .version = 3});
    newer.set("n", 1);
    newer.save();
    const std::string text = readFile(file, 1000);
    Settings settings({.file = file, .version = 2});
    EXPECT_EQ(settings.load(), Settings::Origin::Defaults);
    EXPECT_EQ(readFile(folder / "settings.json.newer-1", 1000), text);
}

TEST(Settings, anOlderFileIsBroughtUpToDate) {
    const TemporaryFolder folder;
    const fs::path file = folder / "settings.json";
    Settings older({.file = file, .version = 1});
    older.set("volume", 80);
    older.save();
    Settings settings({.file = file, .version = 2, .migrate = [](int from, SettingMap& values) {
                           EXPECT_EQ(from, 1);
                           values["audio.volume"] = 0.8;
                           values.erase("volume");
                       }});
    EXPECT_EQ(settings.load(), Settings::Origin::File);
    EXPECT_EQ(settings.get("audio.volume", 0.0, 0, 1), 0.8);
    EXPECT_TRUE(settings.changed());
    Settings failing({.file = file, .version = 2, .migrate = [](int, SettingMap&) {
                          throw Error("this cannot be brought up to date");
                      }});
    EXPECT_EQ(failing.load(), Settings::Origin::Defaults);
    EXPECT_TRUE(fs::exists(folder / "settings.json.damaged-1"));
}

/// What a failed save must leave: the old file, the values, nothing temporary, and a reason.
bool savesNothing(Settings& settings, const fs::path& file) {
    const auto before = settings.values();
    bool threw = false;
    try {
        settings.save();
    } catch (const Error&) {
        threw = true;
    }
    const bool told = !settings.trySave() && !settings.problem().empty();
    const auto files = std::distance(fs::directory_iterator(file.parent_path()), {});
    return threw && told && files == 1 && settings.values() == before && settings.changed() &&
           readFile(file, 100) == "{\"version\": 1, \"settings\": {\"old\": true}}";
}

TEST(Settings, aFileThatCannotGrowLosesNothing) {
    const TemporaryFolder folder;
    const fs::path file = folder / "settings.json";
    writeFileAtomic(file, "{\"version\": 1, \"settings\": {\"old\": true}}");
    EXPECT_TRUE(inChild([&] {
        Settings settings({.file = file});
        settings.load();
        settings.set("much", std::string(100'000, 'x'));
        ::signal(SIGXFSZ, SIG_IGN);
        const struct rlimit limit { 4096, 4096 };
        ::setrlimit(RLIMIT_FSIZE, &limit);
        return savesNothing(settings, file);
    }));
}

TEST(Settings, aFullDiskLosesNothing) {
    const TemporaryFolder folder;
    const fs::path disk = folder / "disk";
    fs::create_directory(disk);
    if (::mount("none", disk.c_str(), "tmpfs", 0, "size=16k") != 0)
        GTEST_SKIP() << "only root may mount a small disk";
    const fs::path file = disk / "settings.json";
    writeFileAtomic(file, "{\"version\": 1, \"settings\": {\"old\": true}}");
    Settings settings({.file = file});
    settings.load();
    settings.set("much", std::string(100'000, 'x'));
    EXPECT_TRUE(savesNothing(settings, file));
    settings.set("much", "little");
    EXPECT_TRUE(settings.trySave()) << settings.problem();
    ::umount(disk.c_str());
}

TEST(Settings, aReadOnlyHomeLosesNothing) {
    const TemporaryFolder folder;
    const fs::path file = folder / "home/settings.json";
    writeFileAtomic(file, "{\"version\": 1, \"settings\": {\"old\": true}}");
    ::chmod(folder.path().c_str(), 0755);
    ::chmod((folder / "home").c_str(), 0555);
    EXPECT_TRUE(inChild([&] {
        // Root may write anywhere, so this is done as nobody.
        if (::geteuid() == 0 && ::setuid(65534) != 0) return false;
        Settings settings({.file = file});
        if (settings.load() != Settings::Origin::File) return false;
        settings.set("much", 1);
        return savesNothing(settings, file);
    }));
    ::chmod((folder / "home").c_str(), 0755);
    writeFileAtomic(file, "damage");
    ::chmod((folder / "home").c_str(), 0555);
    EXPECT_TRUE(inChild([&] {
        if (::geteuid() == 0 && ::setuid(65534) != 0) return false;
        Settings settings({.file = file});
        const bool defaults = settings.load() == Settings::Origin::Defaults;
        return defaults && readFile(file, 100) == "damage" &&
               settings.problem().find("cannot be set aside") != std::string::npos;
    }));
    ::chmod((folder / "home").c_str(), 0755);
}

}  // namespace
