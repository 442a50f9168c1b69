#include <gtest/gtest.h>

#include <atlax/error.hpp>
#include <atlax/translation.hpp>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace atlax;

Translation catalogs() {
    return {"atlax-test", ATLAX_TEST_CATALOGS};
}

TEST(Translation, theLanguageIsSwitchedWhileRunning) {
    Translation texts = catalogs();
    texts.setLanguage("en");
    EXPECT_EQ(texts.translate("Rope"), "Rope");
    texts.setLanguage("de");
    EXPECT_EQ(texts.translate("Rope"), "Seil");
    EXPECT_EQ(texts.language(), "de");
    texts.setLanguage("pl");
    EXPECT_EQ(texts.translate("Rope"), "Lina");
    texts.setLanguage("de_AT");
    EXPECT_EQ(texts.translate("Rope"), "Seil") << "German will do";
    texts.setLanguage("xx");
    EXPECT_EQ(texts.translate("Rope"), "Rope");
}

TEST(Translation, pluralsFollowTheRulesOfTheirLanguage) {
    Translation texts = catalogs();
    const auto crates = [&](unsigned long n) { return texts.plural("%d crate", "%d crates", n); };
    texts.setLanguage("en");
    EXPECT_EQ(crates(1), "%d crate");
    EXPECT_EQ(crates(2), "%d crates");
    texts.setLanguage("de");
    EXPECT_EQ(crates(0), "%d Kisten");
    EXPECT_EQ(crates(1), "%d Kiste");
    texts.setLanguage("pl");
    EXPECT_EQ(crates(1), "%d skrzynia");
    EXPECT_EQ(crates(3), "%d skrzynie");
    EXPECT_EQ(crates(5), "%d skrzy\xc5\x84");
    EXPECT_EQ(crates(22), "%d skrzynie");
}

TEST(Translation, contextsTellMeaningsApart) {
    Translation texts = catalogs();
    texts.setLanguage("de");
    EXPECT_EQ(texts.translate("Play"), "Spielen");
    EXPECT_EQ(texts.translate("theatre", "Play"),
              "St\xc3\xbc"
              "ck");
    EXPECT_EQ(texts.translate("nowhere", "Play"), "Play");
    EXPECT_EQ(texts.plural("editor", "%d joint", "%d joints", 1), "%d Gelenk");
    EXPECT_EQ(texts.plural("editor", "%d joint", "%d joints", 4), "%d Gelenke");
    EXPECT_EQ(texts.plural("nowhere", "%d joint", "%d joints", 1), "%d joint");
    EXPECT_EQ(texts.plural("nowhere", "%d joint", "%d joints", 4), "%d joints");
}

TEST(Translation, whatIsMissingIsShownAsInTheSource) {
    Translation texts = catalogs();
    texts.setLanguage("de");
    EXPECT_EQ(texts.translate("no such text"), "no such text");
    EXPECT_EQ(texts.translate(""), "") << "and not the catalog's header";
    Translation none("atlax-test", "/no/such/folder");
    EXPECT_EQ(none.translate("Rope"), "Rope");
    EXPECT_TRUE(none.languages().empty());
}

TEST(Translation, languagesAreListed) {
    EXPECT_EQ(catalogs().languages(), (std::vector<std::string>{"de", "pl"}));
}

TEST(Translation, badNamesOfLanguagesAreRefused) {
    Translation texts = catalogs();
    texts.setLanguage("de");
    for (const char* name : {"../de", "d", "de/x", "a very long name of a language", "d e", "..x"})
        EXPECT_THROW(texts.setLanguage(name), Error) << name;
    EXPECT_EQ(texts.translate("Rope"), "Seil") << "and nothing changes";
}

TEST(Translation, numbersStayAsTheyAre) {
    ::setenv("LC_ALL", "de_DE.UTF-8", 1);
    catalogs().setLanguage("de");
    EXPECT_EQ(std::strtod("1.5", nullptr), 1.5);
    ::unsetenv("LC_ALL");
}

TEST(Translation, valuesFillTheGapsOfATextInTurn) {
    EXPECT_EQ(fill("{} of {} joints", {"2", "7"}), "2 of 7 joints");
    EXPECT_EQ(fill("{} of {}", {"{}", "7"}), "{} of 7") << "a value is put in as it is";
    EXPECT_EQ(fill("{} of {}", {"2"}), "2 of {}");
    EXPECT_EQ(fill("nothing", {"2"}), "nothing");
    EXPECT_EQ(fill("", {}), "");
}

TEST(Translation, catalogsAreFoundWhereTheirVariableSaysFirst) {
    ASSERT_EQ(setenv("ATLAX_TEST_LOCALE", ATLAX_TEST_CATALOGS, 1), 0);
    EXPECT_EQ(catalogFolder("atlax-test", "ATLAX_TEST_LOCALE", "/nowhere"), ATLAX_TEST_CATALOGS);
    EXPECT_EQ(catalogFolder("no-such-domain", "ATLAX_TEST_LOCALE", "/nowhere"), "/nowhere");
    ASSERT_EQ(unsetenv("ATLAX_TEST_LOCALE"), 0);
    EXPECT_EQ(catalogFolder("atlax-test", "ATLAX_TEST_LOCALE", ATLAX_TEST_CATALOGS),
              ATLAX_TEST_CATALOGS);
}

}  // namespace
