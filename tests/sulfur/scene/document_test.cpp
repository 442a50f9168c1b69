// The reading of JSON: lines, names of objects, bounds, limits.
#include <gtest/gtest.h>

#include "samples.hpp"

namespace {

using namespace sulfur::scene;
using sulfur::scene::testing::errorOf;

Document documentOf(std::string text, DocumentLimits limits = {}) {
    return Document::parse(std::move(text), {.file = "t.json", .firstLine = 1, .object = {}},
                           limits);
}

ReadError parseError(const std::string& text, DocumentLimits limits = {}) {
    return errorOf([&] { documentOf(text, limits); });
}

TEST(Document, KnowsTheLineOfEveryValue) {
    const auto document = documentOf(
        "{\n\"a\": 1\n,\n\"b\"\n:\n[2,\n\n3\n]\r\n, \"c\": {\"d\"\n: \"x\\ny\"}, \"e\": -1.5e3\n}");
    const Node root = document.root();
    EXPECT_EQ(root.line(), 1);
    EXPECT_EQ(root.at("a").line(), 2);
    EXPECT_EQ(root.at("b").line(), 6);
    EXPECT_EQ(root.at("b").array(2, 2)[0].line(), 6);
    EXPECT_EQ(root.at("b").array(2, 2)[1].line(), 8);
    EXPECT_EQ(root.at("c").line(), 10);
    EXPECT_EQ(root.at("c").at("d").line(), 11);
    EXPECT_EQ(root.at("e").line(), 11);
    EXPECT_EQ(root.at("e").number(-2000, 0), -1500);
}

TEST(Document, KeepsTheTextOfEveryValue) {
    const auto document = documentOf(
        "\xEF\xBB\xBF {\"n\": 1.50 ,\"s\":\"a\\u00e9\" , \"o\": { \"x\" : [ 1 ] }, \"t\":true, "
        "\"z\": null}");
    const Node root = document.root();
    EXPECT_EQ(root.at("n").text(), "1.50");
    EXPECT_EQ(root.at("s").text(), "\"a\\u00e9\"");
    EXPECT_EQ(root.at("s").string(0, 10), "a\xC3\xA9");
    EXPECT_EQ(root.at("o").text(), "{ \"x\" : [ 1 ] }");
    EXPECT_EQ(root.at("t").text(), "true");
    EXPECT_EQ(root.at("z").text(), "null");
    EXPECT_TRUE(root.at("t").boolean());
    EXPECT_EQ(root.members().size(), 5u);
}

TEST(Document, RefusesWhatIsNotJsonWithItsLine) {
    const struct {
        const char* text;
        int line;
    } cases[] = {
        {"", 1},
        {"   \n  \n", 1},
        {"{\n\"a\": NaN}", 2},
        {"{\n\n\"a\": Infinity}", 3},
        {"{\"a\":\n-Infinity}", 2},
        {"[1,\n2,]", 2},
        {"{\"a\": 1\n", 1},
        {"{\"a\": \"no end\n\"}", 1},
        {"[1]\n\n[2]", 3},
        {"[01]", 1},
        {"[\n'a']", 2},
        {"[// comment\n1]", 1},
        {"{\n\"a\": 1e999}", 2},
        {"{\n\"a\" 1}", 2},
        {"\xff\xfe\x01\x02 garbage", 1},
        {"[\"\xc3\x28\"]", 1},
    };
    for (const auto& [text, line] : cases) {
        const auto error = parseError(text);
        EXPECT_EQ(error.line(), line) << text << ": " << error.what();
        EXPECT_EQ(error.file(), "t.json") << text;
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
    EXPECT_NE(parseError("{\"a\": 1").message().find("cut off"), std::string::npos);
    EXPECT_EQ(parseError(std::string("[1]\n\0[2]", 8)).line(), 2);
}

TEST(Document, RefusesDuplicateKeys) {
    const auto error = parseError("{\"a\": 1,\n\"b\": {\"k\": 1,\n\"j\": 2,\n\"k\": 3}}");
    EXPECT_EQ(error.line(), 4);
    EXPECT_NE(error.message().find("\"k\""), std::string::npos);
    EXPECT_NE(error.message().find("line 2"), std::string::npos);
    EXPECT_EQ(parseError("{\"a\": 1, \"\\u0061\": 2}").line(), 1);
}

TEST(Document, KeepsItsLimits) {
    EXPECT_NE(parseError(std::string(33 << 20, ' ')).message().find("bytes"), std::string::npos);
    EXPECT_NE(parseError(std::string(1000, '[')).message().find("deep"), std::string::npos);
    const std::string deep(32, '[');
    EXPECT_NO_THROW(documentOf(deep + std::string(32, ']')));
    EXPECT_NE(parseError("[" + deep + std::string(33, ']')).message().find("deep"),
              std::string::npos);
    EXPECT_NE(parseError("[1,2,3]", {.values = 3}).message().find("values"), std::string::npos);
    EXPECT_NO_THROW(documentOf("[1,2,3]", {.values = 4}));
}

TEST(Document, NamesTheObjectOfAnError) {
    const auto document = documentOf(R"({
      "list": [{"id": "first", "deep": {"n": [1, "x"]}}, {"n": 5}],
      "things": {"lamp": {"n": 1, "more": {"n": 2}}, "n": 3}
    })");
    const Node root = document.root();
    const auto items = root.at("list").array(2, 2);
    const auto failure = [](const Node& node) { return errorOf([&] { node.fail("is bad"); }); };
    const auto deep = failure(items[0].at("deep").at("n").array(2, 2)[1]);
    EXPECT_STREQ(deep.what(), "t.json:2: object \"first\": deep.n[1]: is bad");
    EXPECT_EQ(deep.object(), "first");
    EXPECT_STREQ(failure(items[1].at("n")).what(), "t.json:2: object \"list[1]\": n: is bad");
    EXPECT_STREQ(failure(root.at("things").at("lamp").at("more").at("n")).what(),
                 "t.json:3: object \"lamp\": more.n: is bad");
    EXPECT_STREQ(failure(root.at("things").at("n")).what(),
                 "t.json:3: object \"things\": n: is bad");
    EXPECT_STREQ(failure(root.at("list")).what(), "t.json:2: list: is bad");
    EXPECT_STREQ(failure(root).what(), "t.json:1: is bad");
}

TEST(Document, PartOfAFileSpeaksOfTheFile) {
    const auto part = Document::parse("{\n\"spawn\": [0, 1],\n\"exit\": {\"at\": 3}}",
                                      {.file = "level.json", .firstLine = 40, .object = "level"});
    const auto spawn = errorOf([&] { part.root().at("spawn").point(0.5); });
    EXPECT_STREQ(spawn.what(),
                 "level.json:41: object \"level\": spawn[1]: is 1; allowed is -0.5 to 0.5");
    const auto exit = errorOf([&] { part.root().at("exit").at("at").string(0, 9); });
    EXPECT_EQ(exit.object(), "exit");
    EXPECT_EQ(exit.line(), 42);
    EXPECT_EQ(errorOf([&] { part.root().at("none"); }).object(), "level");
}

TEST(Node, ChecksTypesAndBounds) {
    const auto document = documentOf(
        R"({"n": 1.5, "i": 7, "s": "word", "b": true, "a": [1, 2, 3], "o": {}, "z": null,
            "tiny": 1e-320, "small": 1e-60, "big": 1e300, "neg": -3, "ctrl": "a\u0007b"})");
    const Node root = document.root();
    const auto at = [&](const char* key) { return root.at(key); };
    EXPECT_EQ(at("n").number(1.5, 1.5), 1.5);
    EXPECT_EQ(at("i").integer(7, 7), 7);
    EXPECT_EQ(at("neg").integer(-3, 0), -3);
    EXPECT_EQ(at("s").choice({"other", "word"}), 1u);
    EXPECT_EQ(at("small").real(0, 1), static_cast<sulfur::Real>(1e-60));
    EXPECT_THROW(at("n").number(1.6, 2), ReadError);
    EXPECT_THROW(at("n").integer(0, 9), ReadError);
    EXPECT_THROW(at("big").integer(0, 9), ReadError);
    EXPECT_THROW(at("i").integer(0, 6), ReadError);
    EXPECT_THROW(at("i").integer(8, 9), ReadError);
    EXPECT_THROW(at("s").choice({"wor", "words"}), ReadError);
    EXPECT_THROW(at("i").choice({"7"}), ReadError);
    EXPECT_THROW(at("s").string(5, 9), ReadError);
    EXPECT_THROW(at("s").string(0, 3), ReadError);
    EXPECT_THROW(at("ctrl").string(0, 9), ReadError);
    EXPECT_THROW(at("i").string(0, 9), ReadError);
    EXPECT_THROW(at("i").boolean(), ReadError);
    EXPECT_THROW(at("z").number(0, 1), ReadError);
    EXPECT_THROW(at("a").vec2(9), ReadError);
    EXPECT_THROW(at("a").array(0, 2), ReadError);
    EXPECT_THROW(at("a").array(4, 9), ReadError);
    EXPECT_THROW(at("o").array(0, 9), ReadError);
    EXPECT_THROW(at("a").members(), ReadError);
    EXPECT_THROW(at("neg").positive(9), ReadError);
    EXPECT_THROW(at("big").positive(9), ReadError);
    EXPECT_THROW(at("i").find("x"), ReadError);
    EXPECT_FALSE(root.find("x"));
}

TEST(AssetName, MustStayInsideThePack) {
    for (const char* good : {"a.png", "art/b.png", "a/b/c", "..a/b..", "\xC3\xA9.png"})
        EXPECT_TRUE(safeAssetName(good)) << good;
    for (const char* bad : {"", "/etc/passwd", "..", "../a", "a/../b", "a/..", "./a", "a//b", "a/",
                            "a\\b", "C:a", "a\nb"})
        EXPECT_FALSE(safeAssetName(bad)) << bad;
    EXPECT_FALSE(safeAssetName(std::string(201, 'a')));
}

}  // namespace
