// What the libraries refuse is told in the language of the user.
#include "model/refusals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <sulfur/scene.hpp>

#include "model/drawing.hpp"
#include "model/share_text.hpp"
#include "model/words.hpp"
#include "visible_texts.hpp"

namespace sulfurchamber::test {
namespace {

namespace fs = std::filesystem;

/// Leaves English behind, whatever a test has done.
class Refusals : public testing::Test {
protected:
    void TearDown() override { setLanguage("en"); }
};

std::string refusalOf(const std::function<void()>& body) {
    try {
        body();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

std::string trimmedAtEnds(const std::string& text) {
    const auto first = text.find_first_not_of(" \"");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \"") - first + 1);
}

// Mistakes of a program, which no file can be the reason of, and words by which the reader knows
// what its parser says.
const std::set<std::string> notShown{
    "sulfur::scene reads the key", "which its list of keys lacks", "; last read:", "; expected",
    "unexpected end of input",     "missing closing quote"};

bool isOfAPattern(const std::string& words) {
    for (const std::string_view pattern : refusalPatterns())
        if (pattern.find(words) != pattern.npos) return true;
    // A place and what is wrong there are translated one by one; names of one word stay.
    if (words.find(' ') == std::string::npos) return true;
    const auto colon = words.find(": ");
    return colon != std::string::npos && isOfAPattern(words.substr(0, colon)) &&
           isOfAPattern(words.substr(colon + 2));
}

// A sentence that a library puts together of pieces has each piece in a pattern.
TEST_F(Refusals, everySentenceOfTheReadersHasAPattern) {
    const fs::path root = fs::path(SULFURCHAMBER_SOURCES).parent_path();
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(root / "sulfur/scene/src"))
        if (entry.path().extension() == ".cpp") files.push_back(entry.path());
    for (const char* one :
         {"sulfur/src/core/error_checks.cpp", "sulfur/src/world/blueprint.cpp",
          "sulfur/src/world/make_mechanisms.cpp", "quaoar/game/rules/reading.cpp",
          "quaoar/game/rules/level_reader.cpp", "quaoar/game/rules/mechanics_reader.cpp",
          "quaoar/game/rules/level_check.cpp", "atlax/core/src/image.cpp", "atlax/core/src/svg.cpp",
          "atlax/core/src/files.cpp"})
        files.push_back(root / one);
    setLanguage("de");
    std::size_t sentences = 0;
    for (const fs::path& file : files) {
        std::ostringstream source;
        source << std::ifstream(file).rdbuf();
        ASSERT_FALSE(source.str().empty()) << file;
        for (const Literal& literal : literalsOf(source.str())) {
            const std::string words = trimmedAtEnds(literal.text);
            if (!looksVisible(words) || notShown.contains(words)) continue;
            ++sentences;
            EXPECT_TRUE(isOfAPattern(words) || trRefusal(literal.text) != literal.text)
                << "no pattern has \"" << words << "\" of " << file.filename() << ":"
                << literal.line;
        }
    }
    EXPECT_GT(sentences, 120u);
}

TEST_F(Refusals, filesAreRefusedInTheUsersLanguage) {
    const auto scene = [](const std::string& blueprint) {
        return refusalOf([&] {
            sulfur::scene::parse(
                "{\"format\": \"sulfur-scene\", \"version\": 1,\n\"blueprints\": {\"thing\": " +
                    blueprint + "},\n\"bodies\": [{\"id\": \"mass\", \"blueprint\": \"thing\"}]}",
                "a.json");
        });
    };
    const std::string number = scene("5"),
                      heavy = scene("{\"particles\": [{\"position\": [0, 0], \"mass\": -1}]}"),
                      cut = refusalOf([] { sulfur::scene::parse("{\"a\": [", "b: 1.json"); }),
                      gone = refusalOf([] { sulfur::scene::read("/nowhere/c.json"); });
    setLanguage("de");
    EXPECT_EQ(trRefusal(number),
              "a.json:2: Objekt „blueprints“: thing: ist eine Zahl; erlaubt ist ein Objekt, {...}");
    EXPECT_EQ(trRefusal(heavy),
              "a.json:2: Objekt „thing“: particles[0].mass: ist -1; erlaubt ist mehr "
              "als 0, höchstens 1e+09");
    EXPECT_EQ(trRefusal(cut),
              "b: 1.json:1: der Text endet mittendrin; er ist abgeschnitten, es braucht eine "
              "vollständige Kopie der Datei");
    EXPECT_EQ(trRefusal(gone), "/nowhere/c.json: ist nicht da; den Namen der Datei prüfen");
    setLanguage("it");
    EXPECT_EQ(trRefusal(number),
              "a.json:2: oggetto «blueprints»: thing: è un numero; è ammesso un oggetto, {...}");
    EXPECT_EQ(trRefusal(gone), "/nowhere/c.json: non c’è; si controlli il nome del file");
    setLanguage("en");
    for (const std::string& one : {number, heavy, cut, gone}) EXPECT_EQ(trRefusal(one), one);
}

TEST_F(Refusals, whatIsQuotedIsNotTranslated) {
    setLanguage("de");
    EXPECT_EQ(trRefusal("object \"mass\": is \"radius\"; allowed is a name from \"blueprints\""),
              "Objekt „mass“: ist „radius“; erlaubt ist ein Name aus „blueprints“");
    EXPECT_EQ(trRefusal("mass: is 5; allowed is one of \"a\", \"b\""),
              "mass: ist 5; erlaubt ist eines von \"a\", \"b\"");
    EXPECT_EQ(trRefusal("particle 3: mass is -1; allowed is more than 0"),
              "Teilchen 3: Masse ist -1; erlaubt ist mehr als 0");
    // Of another library, in a folder that is called as a sentence begins.
    EXPECT_EQ(trRefusal("is not JSON.png: libpng said no"), "is not JSON.png: libpng said no");
    EXPECT_EQ(trRefusal(""), "");
    EXPECT_EQ(trRefusal(": "), ": ");
}

TEST_F(Refusals, whatAParserSaysIsQuotedInItsOwnWords) {
    const std::string comma =
        refusalOf([] { sulfur::scene::parse("{\"format\":\n \"sulfur-scene\" 1}", "a.json"); });
    const std::string end = "; expected '}'";
    ASSERT_TRUE(comma.starts_with("a.json:2: is not JSON: unexpected ") && comma.ends_with(end));
    const std::string words = comma.substr(comma.find("unexpected"));
    const auto drawing = [] { readDrawing("<svg>\n<g></svg>", "d.svg", {}); };
    const std::string tag = refusalOf(drawing);
    const std::string before = "d.svg: is not well-formed, line 2: ";
    ASSERT_TRUE(tag.starts_with(before)) << tag;
    setLanguage("de");
    EXPECT_EQ(trRefusal(comma), "a.json:2: ist kein JSON (im Wortlaut: \u201E" + words + "\u201C)");
    EXPECT_EQ(trRefusal(refusalOf(drawing)),
              "d.svg: ist nicht wohlgeformt, Zeile 2 (im Wortlaut: \u201E" +
                  tag.substr(before.size()) + "\u201C)");
    setLanguage("it");
    EXPECT_EQ(trRefusal(comma),
              "a.json:2: non \u00E8 JSON (testualmente: \u00AB" + words + "\u00BB)");
}

TEST_F(Refusals, drawingsAndSharedTextsToo) {
    setLanguage("de");
    const auto drawing = [](const std::string& inside) {
        return trRefusal(refusalOf([&] {
            readDrawing("<svg xmlns=\"http://www.w3.org/2000/svg\">" + inside + "</svg>", "d.svg",
                        {});
        }));
    };
    EXPECT_EQ(drawing("<rect width=\"5 miles\" height=\"2\"/>"),
              "d.svg: enthält keinen geschlossenen Umriss (rect, Zeile 1: width ist „5 miles“; "
              "erlaubt ist eine Zahl, auch mit px, mm, cm, in, pt oder pc)");
    EXPECT_EQ(
        drawing("<path id=\"p\" d=\"M 1 K\"/>"),
        "d.svg: enthält keinen geschlossenen Umriss (p, Zeile 1: Zeichen 5: eine Zahl fehlt)");
    EXPECT_EQ(trRefusal(refusalOf([] { parseShareText("sulfur-scene-1:900:abcd"); })),
              "der Text enthält keine brauchbare Szene: er ist abgeschnitten: 3 von 900 Bytes sind "
              "da");
}

}  // namespace
}  // namespace sulfurchamber::test
