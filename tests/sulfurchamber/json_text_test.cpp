// JSON edited as text: what is not touched keeps its bytes.
#include <gtest/gtest.h>

#include "model/json_text.hpp"

namespace sulfurchamber {
namespace {

const char* const sample = R"({
    "name": "Caf\u00e9 \"one\"",
    "spawn": [0.4, 0.20],
    "hints": [
      {"position": [3.1, 1.3], "text": "a"},
      {"position": [10.2, 1.35], "text": "b"}
    ],
    "movers": [{"body": "gate"}],
    "empty": []
  })";

TEST(JsonText, ReadsValuesByTheirWay) {
    const JsonText text{sample};
    EXPECT_EQ(text.string({"name"}), "Caf\xC3\xA9 \"one\"");
    EXPECT_EQ(text.number({"spawn", std::size_t{1}}), 0.2);
    EXPECT_EQ(text.get({"spawn", std::size_t{1}}), "0.20");
    EXPECT_EQ(text.string(pathOf({"hints"}, "1.text")), "b");
    EXPECT_EQ(text.size({"hints"}), 2u);
    EXPECT_EQ(text.keys({}).size(), 5u);
    EXPECT_FALSE(text.has({"hints", std::size_t{2}}));
    EXPECT_FALSE(text.has({"spawn", "x"}));
    EXPECT_FALSE(text.number({"name"}));
}

TEST(JsonText, ReplacesAValueAndNothingElse) {
    JsonText text{sample};
    text.set({"spawn", std::size_t{0}}, "7");
    std::string wanted = sample;
    wanted.replace(wanted.find("0.4"), 3, "7");
    EXPECT_EQ(text.text(), wanted);
}

TEST(JsonText, WhatIsAddedFollowsTheLayout) {
    JsonText text{sample};
    text.append({"hints"}, R"({"text": "c"})");
    EXPECT_NE(text.text().find("\"b\"},\n      {\"text\": \"c\"}\n    ],"), std::string::npos);
    text.set({"killDepth"}, "-3");
    EXPECT_TRUE(text.text().ends_with("\"empty\": [],\n    \"killDepth\": -3\n  }"));
    text.append({"movers"}, R"({"body": "lift"})");
    EXPECT_NE(text.text().find(R"([{"body": "gate"}, {"body": "lift"}])"), std::string::npos);
    text.append({"empty"}, "1");
    EXPECT_EQ(text.get({"empty"}), "[1]");
    text.set({"movers", std::size_t{0}, "spin"}, "1");
    EXPECT_EQ(text.get({"movers", std::size_t{0}}), R"({"body": "gate", "spin": 1})");
}

TEST(JsonText, ALineThatGrowsTooLongIsSpread) {
    JsonText text{sample};
    const std::string item = R"({"body": "a body with a long name", "path": [[23.75, 2.7]]})";
    text.append({"movers"}, item);
    text.append({"movers"}, item);
    EXPECT_EQ(text.get({"movers"}),
              "[\n      {\"body\": \"gate\"},\n      " + item + ",\n      " + item + "\n    ]");
}

TEST(JsonText, WhatIsTakenOutTakesItsCommaAlong) {
    JsonText text{sample};
    JsonText again{sample};
    text.append({"hints"}, "1");
    text.erase({"hints", std::size_t{2}});
    EXPECT_EQ(text.text(), sample);
    text.erase({"hints", std::size_t{0}});
    EXPECT_EQ(text.size({"hints"}), 1u);
    EXPECT_EQ(text.string({"hints", std::size_t{0}, "text"}), "b");
    text.erase({"hints", std::size_t{0}});
    EXPECT_EQ(text.get({"hints"}), "[]");
    text.erase({"empty"});
    text.erase({"nothing"});
    EXPECT_TRUE(text.text().ends_with("\"movers\": [{\"body\": \"gate\"}]\n  }"));
    again.rename({"movers", std::size_t{0}, "body"}, "corps");
    EXPECT_EQ(again.get({"movers"}), R"([{"corps": "gate"}])");
}

TEST(JsonText, WhatCannotBeThrowsAndChangesNothing) {
    JsonText text{sample};
    EXPECT_THROW(text.set({"nothing", "more"}, "1"), std::runtime_error);
    EXPECT_THROW(text.append({"name"}, "1"), std::runtime_error);
    EXPECT_THROW(text.append({"nothing"}, "1"), std::runtime_error);
    EXPECT_THROW(text.rename({"hints", std::size_t{0}}, "x"), std::runtime_error);
    EXPECT_EQ(text.text(), sample);
    EXPECT_THROW(JsonText("{\"a\": ").has({"a"}), std::runtime_error);
}

TEST(JsonText, NumbersAndTextsAreShortAndExact) {
    EXPECT_EQ(jsonOf(0.1 + 0.2), "0.3");
    EXPECT_EQ(jsonOf(-1e-9), "0");
    EXPECT_EQ(jsonOf(12.34567), "12.3457");
    EXPECT_EQ(jsonOf(1, -2.5), "[1, -2.5]");
    EXPECT_EQ(jsonOf(std::string_view("a\"b\\c\nd\x01")), "\"a\\\"b\\\\c\\nd\\u0001\"");
}

}  // namespace
}  // namespace sulfurchamber
