// Properties of bodies: what a panel shows of one and of many, and what a change does.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/properties.hpp"
#include "model/switches.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;
namespace shapes = sulfur::shapes;

constexpr double endless = std::numeric_limits<double>::infinity();

BodyId place(Document& document, const std::string& name, const sulfur::scene::Generator& recipe,
             Point at = {0, 3}) {
    document.edit("Add", [&] { document.add(name, recipe, {.position = at}); });
    return document.world().bodies().back();
}

void setNumber(Document& document, std::vector<BodyId> bodies, std::string_view key, double value) {
    document.edit("Set", [&] { setProperty(document, bodies, *numberProperty(key), value); });
}

std::optional<double> numberOf(const Document& document, std::vector<BodyId> bodies,
                               std::string_view key) {
    return common(document, bodies, *numberProperty(key)).value;
}

const std::vector<std::pair<std::string, sulfur::scene::Generator>> recipes{
    {"box", shapes::BoxOptions{}},
    {"ball", shapes::BallOptions{}},
    {"jelly", shapes::JellyOptions{}},
    {"rope", shapes::RopeOptions{.links = 10}},
    {"chain", shapes::ChainOptions{}},
    {"bridge", shapes::BridgeOptions{}},
    {"cloth", shapes::ClothOptions{}},
    {"wall", shapes::WallOptions{}},
    {"wheel", shapes::WheelOptions{}},
    {"blob", shapes::BlobOptions{}},
    {"polygon", shapes::PolygonOptions{.points = {{0, 0}, {2, 0}, {1, 2}}}},
};

/// Every property of every shape can be set to values of its range, is then what was set, also when
/// time has passed, and one undo leads back.
TEST(Properties, OfAllShapesAreWhatWasSet) {
    for (const auto& [name, recipe] : recipes)
        for (const NumberProperty& property : numberProperties())
            for (const bool running : {false, true}) {
                Document document;
                place(document, name, recipe);
                if (running)
                    for (int i = 0; i < 20; ++i) document.tick();
                const std::vector<BodyId> body{document.bodyOf(name)};
                const Common before = common(document, body, property);
                if (!before.applies) continue;
                const double unlike = before.value && *before.value < 0.7 ? 0.8 : 0.6;
                const double wanted = property.whole ? 5 : property.low >= 1 ? 300 : unlike;
                const std::string plan = document.text();
                SCOPED_TRACE(name + " " + std::string(property.key));
                try {
                    document.edit("Set", [&] { setProperty(document, body, property, wanted); });
                } catch (const sulfur::Error&) {  // such as a radius that does not fit
                    EXPECT_EQ(document.text(), plan);
                    continue;
                }
                const auto now = numberOf(document, {document.bodyOf(name)}, property.key);
                ASSERT_TRUE(now);
                EXPECT_NEAR(*now, wanted, 2e-3 * wanted);
                EXPECT_EQ(document.world().validate(), "");
                document.undo();
                EXPECT_EQ(document.text(), plan);
            }
}

TEST(Properties, OfSeveralAreMixedWhereTheyDiffer) {
    Document document;
    const BodyId a = place(document, "box", shapes::BoxOptions{.mass = 1});
    const BodyId b = place(document, "box", shapes::BoxOptions{.mass = 2}, {3, 3});
    const BodyId ball = place(document, "ball", shapes::BallOptions{}, {6, 3});
    const auto both = common(document, std::vector{a, b}, *numberProperty("mass"));
    EXPECT_TRUE(both.applies);
    EXPECT_FALSE(both.value);
    EXPECT_EQ(numberOf(document, {a, b}, "width"), 1);
    EXPECT_EQ(numberOf(document, {a, ball}, "width"), 1) << "a ball has no width";
    EXPECT_FALSE(common(document, std::vector{ball}, *numberProperty("width")).applies);
    setNumber(document, {a, b, ball}, "mass", 5);
    EXPECT_EQ(numberOf(document, {a, b, ball}, "mass"), 5);
    document.undo();
    EXPECT_FALSE(numberOf(document, {a, b}, "mass")) << "one step for all";
}

TEST(Properties, OneSliderGoesFromJellyToRigid) {
    Document document;
    place(document, "box", shapes::BoxOptions{}, {0, 1});
    const auto box = [&] { return std::vector{document.bodyOf("box")}; };
    EXPECT_EQ(numberOf(document, box(), "stiffness"), endless);
    setNumber(document, box(), "stiffness", 500);
    EXPECT_GT(*numberOf(document, box(), "damping"), 0) << "what is elastic comes to rest";
    for (int i = 0; i < 2000; ++i) document.tick();
    const auto height = [&] {
        const auto bounds = document.world().bounds(document.bodyOf("box"));
        return bounds.high.y() - bounds.low.y();
    };
    EXPECT_LT(height(), 0.999) << "it sags";
    // In the running world, in the same moment.
    setNumber(document, box(), "stiffness", endless);
    const auto joint = document.world().joints(document.bodyOf("box"))[0];
    EXPECT_FALSE(std::isfinite(document.world().info(joint).stiffness));
    EXPECT_EQ(numberOf(document, box(), "stiffness"), endless);
}

TEST(Properties, OutOfRangeIsRefusedAndChangesNothing) {
    Document document;
    const BodyId box = place(document, "box", shapes::BoxOptions{});
    const std::string before = document.text();
    for (const double value : {-1.0, 1e30, std::nan("")})
        EXPECT_THROW(setNumber(document, {box}, "mass", value), std::runtime_error) << value;
    EXPECT_THROW(setNumber(document, {box}, "sliding", endless), std::runtime_error);
    EXPECT_EQ(document.text(), before);
}

TEST(Properties, DensityFollowsTheArea) {
    Document document;
    const BodyId box = place(document, "box", shapes::BoxOptions{.size = {2, 1}, .mass = 8});
    EXPECT_NEAR(*numberOf(document, {box}, "density"), 4, 0.01);
    setNumber(document, {box}, "density", 10);
    EXPECT_NEAR(*numberOf(document, {document.bodyOf("box")}, "mass"), 20, 0.05);
    const BodyId rope = place(document, "rope", shapes::RopeOptions{});
    EXPECT_FALSE(common(document, std::vector{rope}, *numberProperty("density")).applies);
}

TEST(Properties, PresetsMakeTheStuff) {
    for (const MaterialPreset& preset : materialPresets()) {
        Document document;
        place(document, "box", shapes::BoxOptions{});
        place(document, "rope", shapes::RopeOptions{}, {4, 5});
        const std::vector<BodyId> both{document.bodyOf("box"), document.bodyOf("rope")};
        document.edit("Material", [&] { applyPreset(document, both, preset); });
        const std::vector<BodyId> box{document.bodyOf("box")};
        EXPECT_NEAR(*numberOf(document, box, "density"), preset.density, 0.01 * preset.density);
        EXPECT_NEAR(*numberOf(document, box, "sliding"), preset.kineticFriction, 1e-6);
        EXPECT_EQ(std::isinf(*numberOf(document, box, "stiffness")), std::isinf(preset.stiffness));
        for (int i = 0; i < 500; ++i) document.tick();
        EXPECT_EQ(document.world().validate(), "") << preset.name;
    }
}

TEST(Properties, HeldInPlaceItStaysAndLetGoItFalls) {
    Document document;
    place(document, "box", shapes::BoxOptions{});
    const auto box = [&] { return std::vector{document.bodyOf("box")}; };
    EXPECT_EQ(heldInPlace(document, box()), false);
    document.edit("Hold", [&] { holdInPlace(document, box(), true); });
    for (int i = 0; i < 100; ++i) document.tick();
    EXPECT_NEAR(document.world().centreOfMass(box()[0]).y(), 3, 1e-6);
    document.edit("Let go", [&] { holdInPlace(document, box(), false); });
    for (int i = 0; i < 100; ++i) document.tick();
    EXPECT_LT(document.world().centreOfMass(box()[0]).y(), 2.95);
}

TEST(Properties, LayersDecideWhoCollides) {
    Document document;
    const BodyId low = place(document, "box", shapes::BoxOptions{}, {0, 0.6});
    EXPECT_EQ(inLayer(document, std::vector{low}, 0), true);
    EXPECT_EQ(inLayer(document, std::vector{low}, 1), false);
    place(document, "ball", shapes::BallOptions{}, {0, 3});
    const auto put = [&](int layer, bool on) {
        document.edit("Layer", [&] {
            setInLayer(document, std::vector{document.bodyOf("ball")}, layer, on);
        });
    };
    put(1, true);
    put(0, false);
    const std::vector both{document.bodyOf("box"), document.bodyOf("ball")};
    EXPECT_EQ(inLayer(document, both, 0), std::nullopt) << "mixed";
    EXPECT_EQ(inLayer(document, both, 2), false);
    for (int i = 0; i < 1000; ++i) document.tick();
    EXPECT_LT(document.world().centreOfMass(document.bodyOf("ball")).y(), -1)
        << "it falls through box and floor";
    document.reset();
    put(0, true);
    EXPECT_EQ(inLayer(document, std::vector{document.bodyOf("ball")}, 1), true) << "others stay";
    for (int i = 0; i < 1000; ++i) document.tick();
    EXPECT_GT(document.world().centreOfMass(document.bodyOf("ball")).y(), 0.2);
}

TEST(Properties, SwitchesAreThoseOfTheRecipe) {
    Document document;
    const std::vector rope{place(document, "rope", shapes::RopeOptions{}, {0, 5})};
    const auto now = [&](const char* key) {
        return common(document, std::vector{document.bodyOf("rope")}, *switchProperty(key));
    };
    EXPECT_TRUE(now("pin-first").applies);
    EXPECT_FALSE(now("pin-corners").applies);
    EXPECT_EQ(now("pin-first").on, false);
    document.edit("Pin", [&] { setSwitch(document, rope, *switchProperty("pin-first"), true); });
    EXPECT_EQ(now("pin-first").on, true);
    for (int i = 0; i < 300; ++i) document.tick();
    EXPECT_NEAR(
        document.world().position(document.world().particles(document.bodyOf("rope")).front()).y(),
        5, 1e-6);
    const BodyId other = place(document, "rope", shapes::RopeOptions{}, {2, 5});
    const std::vector both{document.bodyOf("rope"), other};
    EXPECT_EQ(common(document, both, *switchProperty("pin-first")).on, std::nullopt) << "mixed";
    EXPECT_EQ(switchProperty("nothing"), nullptr);
}

TEST(Properties, ASkinIsKeptInFilesAndMixedIsMixed) {
    Document document;
    const BodyId box = place(document, "box", shapes::BoxOptions{});
    const BodyId ball = place(document, "ball", shapes::BallOptions{}, {3, 3});
    document.edit("Skin", [&] { setSkin(document, std::vector{box}, "skins/crate.png"); });
    EXPECT_EQ(skinOf(document, std::vector{document.bodyOf("box")}), "skins/crate.png");
    EXPECT_EQ(skinOf(document, std::vector{document.bodyOf("box"), ball}), std::nullopt);
    const std::string text = document.text();
    Document again;
    again.adopt(sulfur::scene::parse(text, "a test"));
    EXPECT_EQ(again.text(), text);
    EXPECT_EQ(skinOf(again, std::vector{again.bodyOf("box")}), "skins/crate.png");
    EXPECT_THROW(
        again.edit("Skin",
                   [&] { setSkin(again, std::vector{again.bodyOf("box")}, "/etc/passwd"); }),
        std::runtime_error);
    EXPECT_EQ(again.text(), text);
    again.edit("Skin", [&] { setSkin(again, std::vector{again.bodyOf("box")}, ""); });
    EXPECT_EQ(again.text().find("crate"), std::string::npos);
}

TEST(Properties, ColoursAreKeptInFiles) {
    Document document;
    const BodyId box = place(document, "box", shapes::BoxOptions{});
    EXPECT_EQ(colour(document, std::vector{box}), "");
    document.edit("Colour", [&] { setColour(document, std::vector{box}, "#ff8800"); });
    Document again;
    again.adopt(sulfur::scene::parse(document.text(), "a test"));
    EXPECT_EQ(colour(again, std::vector{again.bodyOf("box")}), "#ff8800");
    again.edit("Colour", [&] { setColour(again, std::vector{again.bodyOf("box")}, ""); });
    EXPECT_EQ(again.text().find("color"), std::string::npos);
}

TEST(Properties, ColoursThatDifferAreAllShown) {
    Document document;
    place(document, "box", shapes::BoxOptions{});
    place(document, "crate", shapes::BoxOptions{}, {0, 5});
    place(document, "jelly", shapes::JellyOptions{}, {0, 7});
    const auto shown = [&](std::initializer_list<const char*> names) {
        std::vector<BodyId> bodies;
        for (const char* name : names) bodies.push_back(document.bodyOf(name));
        return shownColours(document, bodies);
    };
    using Colours = std::vector<std::string>;
    EXPECT_EQ(shown({"box", "crate"}), Colours{"#6fa8dc"});
    EXPECT_EQ(shown({"box", "jelly"}), (Colours{"#6fa8dc", "#ffb347"}));
    document.edit("Colour",
                  [&] { setColour(document, std::vector{document.bodyOf("crate")}, "#cc2211"); });
    EXPECT_EQ(shown({"box", "crate", "jelly"}), (Colours{"#6fa8dc", "#cc2211", "#ffb347"}));
    EXPECT_EQ(shown({"crate"}), Colours{"#cc2211"});
}

TEST(Properties, ANameIsThePlansAndOnce) {
    Document document;
    place(document, "box", shapes::BoxOptions{});
    const BodyId rope = place(document, "rope", shapes::RopeOptions{}, {0, 6});
    document.edit("Tie", [&] {
        document.connect(document.world().particles(rope).back(),
                         document.world().particles(document.bodyOf("box"))[0]);
    });
    document.edit("Rename", [&] { document.rename(document.bodyOf("box"), "lid"); });
    EXPECT_TRUE(document.bodyOf("lid"));
    EXPECT_EQ(document.scene().connections[0].b.body, "lid");
    EXPECT_THROW(document.edit("Rename", [&] { document.rename(rope, "lid"); }),
                 std::runtime_error);
    EXPECT_THROW(document.edit("Rename", [&] { document.rename(rope, ""); }), std::runtime_error);
    document.undo();
    EXPECT_TRUE(document.bodyOf("box"));
}

}  // namespace
}  // namespace sulfurchamber
