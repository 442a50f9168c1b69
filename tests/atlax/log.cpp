#include <gtest/gtest.h>

#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <thread>

#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace atlax;

class LogTest : public testing::Test {
protected:
    LogTest() { setLogToConsole(false); }
    ~LogTest() override {
        stopLogFile();
        setLogToConsole(true);
        setLogLevel(LogLevel::Info);
    }
    const TemporaryFolder folder;
};

TEST_F(LogTest, linesGoToTheFileWithTheirLevel) {
    const fs::path file = folder / "deep/quaoar.log";
    logToFile({.file = file});
    log(LogLevel::Debug, "too quiet");
    log(LogLevel::Info, "first");
    log(LogLevel::Error, "second {} %s");
    const std::string text = readFile(file, 10'000);
    EXPECT_EQ(text.find("too quiet"), std::string::npos);
    EXPECT_NE(text.find(" info: first\n"), std::string::npos) << text;
    EXPECT_NE(text.find(" error: second {} %s\n"), std::string::npos) << text;
    setLogLevel(LogLevel::Debug);
    log(LogLevel::Debug, "now heard");
    stopLogFile();
    log(LogLevel::Error, "not in the file");
    const std::string later = readFile(file, 10'000);
    EXPECT_NE(later.find("now heard"), std::string::npos);
    EXPECT_EQ(later.find("not in the file"), std::string::npos);
}

TEST_F(LogTest, filesRotateAndAreBounded) {
    logToFile({.file = folder / "a.log", .maxBytes = 1000, .keep = 2});
    for (int i = 0; i < 300; ++i) log(LogLevel::Info, "line " + std::to_string(i));
    log(LogLevel::Warning, "the last one");
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        ++files;
        EXPECT_LE(entry.file_size(), 1000u);
    }
    EXPECT_EQ(files, 3u);
    EXPECT_NE(readFile(folder / "a.log", 1000).find("the last one"), std::string::npos);
}

TEST_F(LogTest, aFileThatCannotBeOpenedIsAnError) {
    EXPECT_THROW(logToFile({.file = folder.path()}), Error);
    EXPECT_THROW(logToFile({.file = folder / "a", .maxBytes = 1}), Error);
    EXPECT_THROW(logToFile({.file = folder / "a", .keep = 0}), Error);
    log(LogLevel::Info, "and the log goes on");
    EXPECT_EQ(recentLog().back(), "info: and the log goes on");
}

TEST_F(LogTest, aFullDiskLosesOnlyLines) {
    logToFile({.file = "/dev/full"});
    for (int i = 0; i < 5; ++i) log(LogLevel::Error, "lost " + std::to_string(i));
    EXPECT_EQ(recentLog().back(), "error: lost 4");
}

TEST_F(LogTest, theLastLinesAreInMemory) {
    for (std::size_t i = 0; i < recentLogLines + 10; ++i)
        log(LogLevel::Info, "line " + std::to_string(i));
    const auto lines = recentLog();
    ASSERT_EQ(lines.size(), recentLogLines);
    EXPECT_EQ(lines.front(), "info: line 10");
    EXPECT_EQ(lines.back(), "info: line " + std::to_string(recentLogLines + 9));
    log(LogLevel::Warning, "two\nlines " + std::string(1000, 'x'));
    EXPECT_EQ(recentLog().back().size(), recentLogBytes);
    EXPECT_EQ(recentLog().back().find("warning: two lines x"), 0u);
}

TEST_F(LogTest, anyThreadMayWriteWhileOthersReadAndChangeFiles) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 3; ++t)
        threads.emplace_back([t] {
            for (int i = 0; i < 300; ++i)
                log(LogLevel::Info, std::string(40, static_cast<char>('a' + t)));
        });
    for (int i = 0; i < 50; ++i) {
        logToFile({.file = folder / ("f" + std::to_string(i % 2)), .maxBytes = 1000});
        for (const std::string& line : recentLog()) {
            if (line.size() != 46 || line.find("info: ") != 0) continue;
            EXPECT_EQ(line.find_first_not_of(line[6], 6), std::string::npos)
                << "no line is mixed of two: " << line;
        }
    }
    for (auto& thread : threads) thread.join();
}

}  // namespace
