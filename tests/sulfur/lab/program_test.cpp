// The program as a user runs it.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Outcome {
    int status = -1;
    std::string output;  ///< standard output and error
};

Outcome lab(const std::string& arguments) {
    const std::string command = std::string("'") + SULFUR_LAB + "' " + arguments + " 2>&1";
    Outcome outcome;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return outcome;
    char buffer[4096];
    while (const auto count = std::fread(buffer, 1, sizeof buffer, pipe))
        outcome.output.append(buffer, count);
    const int status = ::pclose(pipe);
    if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
    return outcome;
}

/// Quick enough for a test, also with sanitizers: short runs, and the search ends early.
const char* const quick = " --highest 200 --resolution 1 --seconds 2 --only-explosions";

TEST(Program, ListsItsExperiments) {
    const auto outcome = lab("--list");
    EXPECT_EQ(outcome.status, 0);
    for (const char* name : {"table2", "table3", "table4", "accuracy", "stability", "broadphase",
                             "bench", "scaling", "skip", "memory"})
        EXPECT_NE(outcome.output.find(name), std::string::npos) << name;
}

TEST(Program, HasHelpAndVersion) {
    EXPECT_EQ(lab("--help").status, 0);
    EXPECT_NE(lab("--help").output.find("--plot"), std::string::npos);
    EXPECT_EQ(lab("--version").status, 0);
    EXPECT_EQ(lab("--version").output.rfind("sulfur_lab ", 0), 0u);
}

TEST(Program, RefusesAWrongNameInOneSentence) {
    for (const char* arguments :
         {"table9", "", "table3 --damper sideways", "table3 --seconds -1",
          "accuracy --scene nowhere", "bench --scene S6", "bench --engine none", "bench --rounds 0",
          "bench --core 4000 --scene S4", "bench --date 2026-01-01", "bench --quick --large",
          "skip --bodies 1", "stability --battery --group nothing", "--csv --json table3",
          "table2 table3"}) {
        const auto outcome = lab(arguments);
        EXPECT_NE(outcome.status, 0) << arguments;
        EXPECT_EQ(outcome.output.rfind("sulfur_lab: ", 0), 0u) << outcome.output;
        EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1)
            << outcome.output;
    }
}

TEST(Program, TakesNumbersFromTheirRangeOnly) {
    for (const char* option :
         {"table3 --seconds",  "table3 --resolution",   "table3 --highest",    "table4 --rounds",
          "table4 --most",     "accuracy --load",       "bench --limit",       "bench --rounds",
          "bench --core",      "broadphase --capsules", "broadphase --grains", "memory --particles",
          "skip --bodies",     "skip --rounds",         "stability --sweeps",  "stability --rate",
          "stability --shots", "stability --shot",      "stability --seed",    "stability --seeds"})
        for (const char* number : {"nan", "-nan", "inf", "-1e300", "1e300", "1,nan", "2x", "''"}) {
            const auto outcome = lab(std::string(option) + '=' + number);
            EXPECT_EQ(outcome.status, 1) << option << ' ' << number;
            EXPECT_EQ(outcome.output.rfind("sulfur_lab: ", 0), 0u) << outcome.output;
        }
    for (const char* none : {"--seeds 0", "--seeds 60-51", "--seed 18446744073709551615"})
        EXPECT_EQ(lab(std::string("stability --battery --group random ") + none).status, 1) << none;
    EXPECT_NE(lab("table3 --seconds nan").output.find("\"nan\" is no number from 2 to 1000"),
              std::string::npos);
}

TEST(Program, PrintsTheCriterionWithTheTable) {
    const auto outcome = lab(std::string("table3") + quick);
    EXPECT_EQ(outcome.status, 0);
    for (const char* part : {"Exploded means", "not finite", "2 s simulated", "no limit found",
                             "implicit Euler", ">200", "47500", "What differs"})
        EXPECT_NE(outcome.output.find(part), std::string::npos) << part;
}

TEST(Program, WritesDataAndPicture) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("sulfur_lab_test_" + std::to_string(::getpid()));
    const auto csv = lab(std::string("table3 --csv --plot '") + folder.string() + "'" + quick);
    EXPECT_EQ(csv.status, 0);
    // A line of names, then 9 integrators at 5 rates with 2 dampers.
    EXPECT_EQ(std::count(csv.output.begin(), csv.output.end(), '\n'), 1 + 9 * 5 * 2);
    const auto one = lab(std::string("table3 --csv --damper axial --highest 100") +
                         " --resolution 1 --seconds 2");
    EXPECT_EQ(std::count(one.output.begin(), one.output.end(), '\n'), 1 + 9 * 5);
    EXPECT_EQ(one.output.find(",paper,"), std::string::npos);
    std::ifstream stream(folder / "table3.svg");
    std::stringstream svg;
    svg << stream.rdbuf();
    EXPECT_NE(svg.str().find("</svg>"), std::string::npos);
    EXPECT_NE(svg.str().find("paper: NSV/IE"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "table3.svg.new"));
    std::filesystem::remove_all(folder);
    const auto json = lab(std::string("table2 --json --damper paper") + quick);
    EXPECT_EQ(json.status, 0);
    EXPECT_EQ(json.output.front(), '{');
    EXPECT_NE(json.output.find("\"integrator\": \"rk4-held\""), std::string::npos);
}

TEST(Program, RunsTheBatteryRowByRow) {
    const auto text = lab("stability --battery --group fall");
    EXPECT_EQ(text.status, 0) << text.output;
    EXPECT_NE(text.output.find("rows pass."), std::string::npos);
    const auto json = lab("stability --battery --group nonsense --json");
    EXPECT_EQ(json.output.front(), '{');
    EXPECT_NE(json.output.find("\"bound\": "), std::string::npos);
}

TEST(Program, DrawsTheScenesWithContacts) {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("sulfur_lab_scenes_" + std::to_string(::getpid()));
    const std::string plot = " --plot '" + folder.string() + "'";
    const auto rows = lab("stability --battery --group contacts-impulses --csv" + plot);
    EXPECT_EQ(rows.output.rfind("group,row,measured,bound,passed\n", 0), 0u) << rows.output;
    EXPECT_TRUE(std::filesystem::exists(folder / "scene_projectile-crate-0.svg"));
    const auto shot = lab("stability --shot 12 --csv" + plot);
    EXPECT_EQ(shot.status, 0) << shot.output;
    // Names, and 0.2 s of ticks.
    EXPECT_EQ(std::count(shot.output.begin(), shot.output.end(), '\n'), 1 + 100);
    EXPECT_TRUE(std::filesystem::exists(folder / "scene_shot-12.svg"));
    EXPECT_EQ(lab("stability --shot 12 --json").output.front(), '{');
    std::filesystem::remove_all(folder);
}

TEST(Program, DrawsErrorAgainstRunTime) {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("sulfur_lab_accuracy_" + std::to_string(::getpid()));
    const auto csv = lab("accuracy --quick --scene fall --csv --plot '" + folder.string() + "'");
    EXPECT_EQ(csv.status, 0) << csv.output;
    // Names, 3 settings of the library at 3 rates, 9 integrators at 4.
    EXPECT_EQ(std::count(csv.output.begin(), csv.output.end(), '\n'), 1 + 3 * 3 + 9 * 4);
    EXPECT_TRUE(std::filesystem::exists(folder / "accuracy_fall.svg"));
    std::filesystem::remove_all(folder);
}

TEST(Program, CountsWhatTheBroadPhaseMisses) {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("sulfur_lab_broadphase_" + std::to_string(::getpid()));
    const std::string quickly = "broadphase --quick --capsules 200 --grains 100";
    const auto csv = lab(quickly + " --csv --plot '" + folder.string() + "'");
    EXPECT_EQ(csv.status, 0) << csv.output;
    // Names, 4 ways in 4 cases, 8 worlds.
    EXPECT_EQ(std::count(csv.output.begin(), csv.output.end(), '\n'), 1 + 4 * 4 + 8);
    EXPECT_TRUE(std::filesystem::exists(folder / "broadphase_misses.svg"));
    EXPECT_TRUE(std::filesystem::exists(folder / "broadphase_times.svg"));
    std::filesystem::remove_all(folder);
    std::istringstream lines(csv.output);
    std::size_t literal = 0;
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> fields;
        std::istringstream parts(line);
        for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
        ASSERT_GE(fields.size(), 8u) << line;
        if (fields[1] == "bresenham") literal += std::stoul(fields[6]);
        if (fields[1] == "covering" || fields[1] == "boxes") {
            EXPECT_EQ(fields[6], "0") << line;
        }
    }
    EXPECT_GT(literal, 0u);
    EXPECT_EQ(lab(quickly + " --json").output.front(), '{');
    EXPECT_NE(lab(quickly).output.find("heaps 8e+08 m apart"), std::string::npos);
}

TEST(Program, ComparesAndWritesWhatItFoundIntoFiles) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("sulfur_lab_bench_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const std::string at = "'" + folder.string();
    const auto outcome =
        lab("bench --quick --scene S4 --engine sulfur --rounds 1 --no-stages --csv " + at +
            "/bench.csv' --json " + at + "/bench.json' --plot " + at + "' --history " + at +
            "/history.csv' --date 2026-01-01");
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("S4 swing 1:1000"), std::string::npos) << outcome.output;
    for (const char* file : {"bench.csv", "bench.json", "history.csv", "bench_S4_hang-1-1.svg"})
        EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
    std::filesystem::remove_all(folder);
}

TEST(Program, RefusesAPlaceForPicturesThatIsNone) {
    const auto outcome = lab(std::string("table3 --plot /dev/null/here") + quick);
    EXPECT_NE(outcome.status, 0);
    EXPECT_NE(outcome.output.find("/dev/null/here"), std::string::npos);
}

}  // namespace
