// Every text that somebody sees is in the catalogs of all languages.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <sulfur/scene.hpp>

#include "model/fitting_properties.hpp"
#include "model/level_fields.hpp"
#include "model/measurement.hpp"
#include "model/properties.hpp"
#include "model/refusals.hpp"
#include "model/stage_times.hpp"
#include "model/templates.hpp"
#include "model/words.hpp"
#include "visible_texts.hpp"

namespace sulfurchamber::test {
namespace {

namespace fs = std::filesystem;

/// Names, and words that are the same in another language.
const std::set<std::string> sameWords{"SulfurChamber",
                                      "Alt",
                                      "English",
                                      "Deutsch",
                                      "Italiano",
                                      "names inside of a sentence",
                                      "Name",
                                      "null",
                                      "Material",
                                      "&Simulation",
                                      "N m s/rad",
                                      "x",
                                      "y",
                                      "a = 2/3 g sin α",
                                      "t = (√(v² + 2 g h) − v) / g",
                                      "√(v² + 2 g h)"};
const std::set<std::string> sameInGerman{
    "Radius",  "Radius {}, {}", "Pol&ygon", "{} particle", "Esc",    "Motor",     "&Motor",
    "Wind",    "&Wind",         "&Level",   "Level",       "Bronze", "Countdown", "Gold",
    "Monster", "Signal",        "Text",     "Zone",        "Sensor"};
const std::set<std::string> sameInItalian{"Home", "Ctrl", "Camera", "Esc", "&File", "fast", "Ins"};

/// Leaves English behind, whatever a test has done.
class Catalogs : public testing::Test {
protected:
    void TearDown() override { setLanguage("en"); }
};

std::vector<VisibleText> everything() {
    std::vector<VisibleText> all = visibleTexts(SULFURCHAMBER_SOURCES);
    const auto add = [&](std::string_view text, const char* where) {
        if (!text.empty()) all.push_back({std::string(text), "", where});
    };
    for (const Quantity& one : quantities()) {
        add(one.name, "quantities()");
        add(one.help, "quantities()");
    }
    for (const NumberProperty& one : numberProperties()) {
        add(one.name, "numberProperties()");
        add(one.help, "numberProperties()");
        add(one.endless, "numberProperties()");
    }
    for (const FittingProperty& one : fittingProperties()) {
        add(one.name, "fittingProperties()");
        add(one.help, "fittingProperties()");
        add(one.endless, "fittingProperties()");
    }
    for (const LevelField& one : levelFields()) {
        add(one.name, "levelFields()");
        add(one.help, "levelFields()");
        for (const std::string& word : choicesOf(one)) add(word, "a choice of levelFields()");
    }
    for (std::size_t i = 0; i < StageTimes::stages; ++i)
        add(stageTitle(static_cast<sulfur::Stage>(i)), "the stages of a tick");
    for (const std::string_view one : refusalPatterns()) add(one, "refusalPatterns()");
    for (const MaterialPreset& one : materialPresets()) add(one.name, "materialPresets()");
    for (const auto& entry : fs::recursive_directory_iterator(SULFURCHAMBER_SCENES)) {
        if (entry.path().extension() != ".json") continue;
        const auto scene = sulfur::scene::read(entry.path());
        add(scene.title, "a scene");
        add(scene.description, "a scene");
    }
    for (const auto& entry : fs::directory_iterator(SULFURCHAMBER_TEMPLATES)) {
        if (entry.path().extension() != ".json") continue;
        const Template made = readTemplate(sulfur::scene::read(entry.path()));
        add(made.name(), "a template");
        add(made.category, "a template");
        add(made.scene.description, "a template");
    }
    return all;
}

std::size_t gapsOf(const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}", at + 2))
        ++count;
    return count;
}

TEST_F(Catalogs, noTextIsLeftUntranslated) {
    const auto all = everything();
    EXPECT_GT(all.size(), 400u);
    EXPECT_EQ(languages(), (std::vector<std::string>{"en", "de", "it"}));
    for (const std::string language : {"de", "it"}) {
        setLanguage(language);
        const auto& same = language == "de" ? sameInGerman : sameInItalian;
        std::set<std::string> told;
        for (const VisibleText& one : all) {
            if (sameWords.contains(one.text) || same.contains(one.text)) continue;
            // Of two forms the catalog has one entry, which knows both.
            const bool lacks = one.plural.empty() ? tr(one.text) == one.text
                                                  : trCount(one.text.c_str(), one.plural.c_str(),
                                                            2) == tr(one.plural, {"2"}) ||
                                                        tr(one.plural) != one.plural;
            if (lacks && told.insert(one.text).second)
                ADD_FAILURE() << language << ".po lacks \"" << one.text << "\" of " << one.where;
        }
    }
}

TEST_F(Catalogs, gapsAreKept) {
    for (const char* language : {"de", "it"}) {
        setLanguage(language);
        for (const VisibleText& one : everything())
            EXPECT_EQ(gapsOf(tr(one.text)), gapsOf(one.text)) << one.text << " in " << language;
    }
}

TEST_F(Catalogs, sentencesAreNotPutTogetherOfPieces) {
    for (const VisibleText& one : visibleTexts(SULFURCHAMBER_SOURCES)) {
        EXPECT_TRUE(one.text.empty() || (one.text.front() != ' ' && one.text.back() != ' '))
            << "\"" << one.text << "\" of " << one.where
            << " is a piece of a sentence: write it as one, with {} for values, in tr()";
    }
}

TEST_F(Catalogs, theLanguageIsThatOfTheUser) {
    EXPECT_EQ(tr("Stiffness"), "Stiffness");
    setLanguage("de");
    EXPECT_EQ(tr("Stiffness"), "Steifigkeit");
    EXPECT_EQ(tr("Change {}", {trInside("Stiffness")}), "Steifigkeit ändern");
    EXPECT_EQ(trCount("{} joint", "{} joints", 1), "1 Verbindung");
    EXPECT_EQ(trCount("{} joint", "{} joints", 2), "2 Verbindungen");
    EXPECT_EQ(tr("what no catalog has"), "what no catalog has");
    setLanguage("it");
    EXPECT_EQ(tr("Change {}", {trInside("Stiffness")}), "Cambia rigidezza");
    EXPECT_EQ(trCount("{} joint", "{} joints", 2), "2 giunti");
    setLanguage("en");
    EXPECT_EQ(tr("Change {}", {trInside("Stiffness")}), "Change stiffness");
    EXPECT_EQ(trCount("{} joint", "{} joints", 1), "1 joint");
    EXPECT_EQ(nameOfLanguage("it"), "Italiano");
    EXPECT_EQ(nameOfLanguage("xx"), "xx");
    EXPECT_ANY_THROW(setLanguage("../de"));
}

TEST_F(Catalogs, numbersHaveAPoint) {
    EXPECT_EQ(fixed(1.256, 2), "1.26");
    EXPECT_EQ(fixed(-0.5, 1), "-0.5");
    EXPECT_EQ(fixed(3, 0), "3");
    EXPECT_EQ(fixed(1e300, 2).size(), 304u);
}

TEST_F(Catalogs, namesAreSortedAsInADictionary) {
    std::vector<std::string> names{"Öl",      "Zug",    "Ohr",     "über",    "Ast",
                                   "ähnlich", "Straße", "Strasse", "Straßen", "città",
                                   "Citta",   "Éclair", "Dach"};
    std::sort(names.begin(), names.end(), standsBefore);
    EXPECT_EQ(names,
              (std::vector<std::string>{"ähnlich", "Ast", "Citta", "città", "Dach", "Éclair", "Ohr",
                                        "Öl", "Strasse", "Straße", "Straßen", "über", "Zug"}));
    EXPECT_EQ(alphabetKey("ÆÐ×ß÷ÿ \xC3"), "aed×ss÷y \xC3");
    EXPECT_FALSE(standsBefore("a", "a"));
}

// A menu's key that two entries have works for one of them only.
TEST(VisibleTexts, everyKeyIsGivenOnce) {
    std::map<std::string, std::string> entryOf;
    for (const auto& entry : fs::directory_iterator(fs::path(SULFURCHAMBER_SOURCES) / "app")) {
        if (entry.path().extension() != ".cpp") continue;
        std::ostringstream source;
        source << std::ifstream(entry.path()).rdbuf();
        for (const Literal& one : literalsOf(source.str())) {
            const std::size_t tab = one.text.find('\t');
            if (tab == std::string::npos || !looksVisible(one.text)) continue;
            const auto [first, isNew] =
                entryOf.emplace(one.text.substr(tab + 1), one.text.substr(0, tab));
            EXPECT_TRUE(isNew) << first->first << " is the key of \"" << first->second
                               << "\" and of \"" << one.text.substr(0, tab) << "\"";
        }
    }
    EXPECT_GT(entryOf.size(), 50u);
}

TEST(VisibleTexts, areFoundInSource) {
    const auto found = literalsOf(R"(// "no"
        add({"open", "&Open\xE2\x80\xA6\tCtrl+O", '"', 1'000, "Open a scene "
             "or a level"}); /* "no" */ tr("mixed"))");
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found[1].text, "&Open…\tCtrl+O");
    EXPECT_EQ(found[2].text, "Open a scene or a level");
    EXPECT_EQ(found[3].text, "mixed");
    EXPECT_EQ(found[2].line, 2);
    EXPECT_FALSE(looksVisible("open"));
    EXPECT_FALSE(looksVisible("%.2f"));
    EXPECT_TRUE(looksVisible("&Open"));
    EXPECT_TRUE(looksVisible("a piece has no name"));
}

}  // namespace
}  // namespace sulfurchamber::test
