// Scenes as C++ source: what it says. That it builds the same world is shown by cpp_source.cmake.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "model/cpp_source.hpp"
#include "model/cpp_values.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

TEST(CppSource, NumbersAreReadBackAsTheyAre) {
    EXPECT_EQ(cpp::text(0.1f), "0.1f");
    EXPECT_EQ(cpp::text(1.0f), "1.0f");
    EXPECT_EQ(cpp::text(-2.5), "-2.5");
    EXPECT_EQ(cpp::text(1e30), "1e+30");
    EXPECT_EQ(cpp::text(1.0 / 3), "0.3333333333333333");
    EXPECT_EQ(cpp::text(sulfur::infinite), "infinite");
    EXPECT_EQ(cpp::text(-sulfur::infinite), "-infinite");
    EXPECT_EQ(cpp::text(std::string("a\"b\\c\n\?\?/")), "\"a\\\"b\\\\c\\012\\077\\077/\"");
}

TEST(CppSource, OnlyWhatDiffersIsSaid) {
    EXPECT_EQ(cpp::text(sulfur::Material{}), "Material{}");
    sulfur::Material ice;
    ice.kineticFriction = sulfur::Real(0.25);
    EXPECT_EQ(cpp::text(ice), "Material{.kineticFriction = " + cpp::text(sulfur::Real(0.25)) + "}");
}

TEST(CppSource, ASelectionAloneIsExported) {
    Workbench bench;
    for (const auto& [tool, x] : {std::pair(ToolKind::box, 0.0), std::pair(ToolKind::ball, 2.0)}) {
        bench.setTool(tool);
        bench.press({.position = {x, 2}});
        bench.release({.position = {x, 2}});
    }
    bench.select({});
    const std::string all = bench.cppSource();
    EXPECT_NE(all.find("shapes::floor("), std::string::npos);
    EXPECT_NE(all.find("shapes::ball("), std::string::npos);
    bench.select({bench.document().bodyOf("ball")});
    const std::string ball = bench.cppSource();
    EXPECT_EQ(ball.find("shapes::floor("), std::string::npos);
    EXPECT_NE(ball.find("const BodyId ball = world.add(makeBall(), {Point(2.0, 2.0), 0.0}).id();"),
              std::string::npos)
        << ball;
}

TEST(CppSource, NamesBecomeIdentifiersOfCpp) {
    Document document;
    const auto box = sulfur::shapes::BoxOptions{};
    document.edit("Add", [&] {
        for (const char* name : {"float", "2nd wheel", "a-b", "a b", "\xC3\xA9"})
            document.add(sulfur::scene::makePrefab(name, box), {});
    });
    const std::string source = cppSource(document.scene());
    for (const char* part : {"const BodyId floatBody =", "const BodyId body2ndWheel =",
                             "const BodyId aB =", "const BodyId aB_2 =", "const BodyId body ="})
        EXPECT_NE(source.find(part), std::string::npos) << part << "\n" << source;
}

}  // namespace
}  // namespace sulfurchamber
