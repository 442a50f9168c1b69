// Templates: made, placed, followed, overridden, unlinked; and the library that holds them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "model/fitting.hpp"
#include "model/instances.hpp"
#include "model/library.hpp"
#include "model/properties.hpp"
#include "model/words.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;

// A cart: a box on two wheels.
void buildCart(Document& document) {
    document.edit("Build", [&] {
        document.add("bed", sulfur::shapes::BoxOptions{.size = {2, 0.4f}, .mass = 10},
                     {.position = {0, 1}});
        document.add("wheel", sulfur::shapes::WheelOptions{.radius = 0.3f, .mass = 2},
                     {.position = {-0.7, 0.5}});
        document.add("wheel", sulfur::shapes::WheelOptions{.radius = 0.3f, .mass = 2},
                     {.position = {0.7, 0.5}});
        auto& mechanisms = document.planForEditing().mechanisms;
        mechanisms.push_back(
            {.id = "", .spec = sulfur::scene::Hinge{"bed", "wheel", {-0.7, 0.5}, {}}, .extra = {}});
        mechanisms.push_back({.id = "front",
                              .spec = sulfur::scene::Hinge{"bed", "wheel2", {0.7, 0.5}, {}},
                              .extra = {}});
    });
}

std::vector<BodyId> cart(const Document& document) {
    return {document.bodyOf("bed"), document.bodyOf("wheel"), document.bodyOf("wheel2")};
}

/// A document with the cart as a template, and two more instances of it.
class Templates : public testing::Test {
protected:
    void SetUp() override {
        buildCart(document);
        document.edit("Make a template",
                      [&] { made = makeTemplate(document, cart(document), "Cart", "Vehicles"); });
        for (const double x : {5.0, -5.0})
            document.edit("Place", [&] {
                placed.push_back(placeTemplate(document, made, {x, 0}));
            });
    }
    std::string idOf(std::size_t instance, const std::string& part) const {
        return sulfurchamber::instancesOf(document.scene()).at(instance).ids.at(part);
    }
    double massOf(const std::string& id) const {
        return *numberProperty("mass")->get(document.plan().dressed(id));
    }
    void setMass(const std::string& id, double value) {
        document.edit("Mass", [&] {
            const BodyId body = document.bodyOf(id);
            setProperty(document, {&body, 1}, *numberProperty("mass"), value);
        });
    }

    Document document;
    Template made;
    std::vector<std::vector<BodyId>> placed;
};

TEST_F(Templates, AreMadeOfASelectionWithItsTies) {
    EXPECT_EQ(made.name(), "Cart");
    EXPECT_EQ(made.scene.bodies.size(), 3u);
    ASSERT_EQ(made.scene.mechanisms.size(), 2u);
    const Bounds bounds = boundsOf(made.scene);
    EXPECT_NEAR(bounds.low.y(), 0, 1e-5);
    EXPECT_NEAR(bounds.centre().x(), 0, 1e-5);
    const auto instances = sulfurchamber::instancesOf(document.scene());
    ASSERT_EQ(instances.size(), 3u);
    EXPECT_EQ(instances[0].ids.at("bed"), "bed");
    EXPECT_EQ(definitions(document.scene()), std::vector<std::string>{"Cart"});
    for (const auto& one : instances) EXPECT_EQ(overrideCount(document, one.instance), 0u);
    // The two others stand on the floor, on mechanisms of their own.
    EXPECT_EQ(document.scene().mechanisms.size(), 6u);
    EXPECT_EQ(document.world().mechanisms().size(), 6u);
    EXPECT_NEAR(document.world().bounds(document.bodyOf(idOf(1, "wheel"))).low.y(), 0.05, 0.01);
}

TEST_F(Templates, TextsAreReadBackAndTheSceneKeepsThem) {
    const Template again = readTemplate(sulfur::scene::parse(textOf(made), "test"));
    EXPECT_EQ(textOf(again), textOf(made));
    EXPECT_EQ(again.category, "Vehicles");
    const std::string text = document.text();
    Document other;
    other.adopt(sulfur::scene::parse(text, "test"));
    EXPECT_EQ(other.text(), text);
    EXPECT_EQ(sulfurchamber::instancesOf(other.scene()).size(), 3u);
}

TEST_F(Templates, InstancesFollowAChangeInOneStep) {
    const std::string before = document.text();
    setMass("bed", 25);
    document.edit("Update the template",
                  [&] { changeTemplate(document, templateFrom(document, "Cart")); });
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(massOf(idOf(i, "bed")), 25, 1e-4);
        EXPECT_NEAR(static_cast<double>(document.world().mass(document.bodyOf(idOf(i, "bed")))), 25,
                    1e-3);
    }
    EXPECT_NEAR(document.plan().body(idOf(1, "bed")).pose.position.x(), 5, 1e-6);
    const std::string after = document.text();
    document.undo();
    EXPECT_NEAR(massOf(idOf(1, "bed")), 10, 1e-4);
    document.undo();
    EXPECT_EQ(document.text(), before);
    document.redo();
    document.redo();
    EXPECT_EQ(document.text(), after);
}

TEST_F(Templates, OverridesStayAreToldAndCanBeReset) {
    const std::string own = idOf(2, "bed");
    setMass(own, 40);
    document.edit("Paint", [&] {
        const BodyId body = document.bodyOf(own);
        setColour(document, {&body, 1}, "#ff0000");
    });
    auto overrides = overridesOf(document, own);
    ASSERT_EQ(overrides.size(), 2u);
    EXPECT_EQ(overrides[0].key, "mass");
    EXPECT_EQ(overrides[1].key, "colour");
    EXPECT_TRUE(overridesOf(document, idOf(1, "bed")).empty());
    // What the template changes elsewhere comes, the mass stays.
    const BodyId first = document.bodyOf("bed");
    document.edit("Wider", [&] {
        setProperty(document, {&first, 1}, *numberProperty("width"), 3);
    });
    setMass("bed", 12);
    document.edit("Update", [&] { changeTemplate(document, templateFrom(document, "Cart")); });
    EXPECT_NEAR(massOf(own), 40, 1e-3);
    EXPECT_NEAR(*numberProperty("width")->get(document.plan().dressed(own)), 3, 1e-5);
    EXPECT_EQ(colourOf(document.plan().body(own)), "#ff0000");
    EXPECT_NEAR(massOf(idOf(1, "bed")), 12, 1e-3);
    document.edit("Reset", [&] { resetOverride(document, own, "mass"); });
    EXPECT_NEAR(massOf(own), 12, 1e-3);
    ASSERT_EQ(overridesOf(document, own).size(), 1u);
    document.edit("Reset all", [&] { resetOverride(document, own, ""); });
    EXPECT_TRUE(overridesOf(document, own).empty());
    EXPECT_EQ(colourOf(document.plan().body(own)), "");
}

TEST_F(Templates, AnOverrideAppliedGoesToAllOthers) {
    const std::string own = idOf(1, "wheel");
    const BodyId body = document.bodyOf(own);
    document.edit("Larger", [&] {
        setProperty(document, {&body, 1}, *numberProperty("radius"), 0.4);
    });
    setMass(idOf(2, "wheel"), 7);
    document.edit("Apply", [&] { applyOverride(document, own, "radius"); });
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(*numberProperty("radius")->get(document.plan().dressed(idOf(i, "wheel"))), 0.4,
                    1e-5);
        // The other wheel shared its blueprint.
        EXPECT_NEAR(*numberProperty("radius")->get(document.plan().dressed(idOf(i, "wheel2"))), 0.3,
                    1e-5);
    }
    EXPECT_NEAR(massOf(idOf(2, "wheel")), 7, 1e-4);
    EXPECT_TRUE(overridesOf(document, own).empty());
}

TEST_F(Templates, MovedAndTurnedInstancesKeepTheirPose) {
    const auto second = sulfurchamber::instancesOf(document.scene())[1];
    document.edit("Turn", [&] {
        const Point about = document.plan().body(second.ids.at("bed")).pose.position;
        for (const auto& [part, id] : second.ids) {
            const auto pose = document.plan().body(id).pose;
            const Point from = pose.position - about;
            document.place(document.bodyOf(id), {.position = about + Point(-from.y(), from.x()),
                                                 .angle = pose.angle + 1.5707963267948966});
        }
    });
    EXPECT_EQ(overrideCount(document, second.instance), 0u);
    const auto pose = document.plan().body(second.ids.at("wheel")).pose;
    // A box more in the template: it comes where it belongs, turned.
    Template next = templateFrom(document, "Cart");
    const Point bed = next.scene.body("bed")->pose.position;
    sulfur::scene::Scene load = next.scene;
    load.blueprints.push_back(
        sulfur::scene::makePrefab("load", sulfur::shapes::BoxOptions{.size = {0.5f, 0.5f}}));
    sulfur::scene::Placement body;
    body.id = body.blueprint = "load";
    body.pose.position = bed + Point(0, 0.6);
    load.bodies.push_back(body);
    next.scene = load;
    document.edit("Load", [&] { changeTemplate(document, next); });
    const auto now = sulfurchamber::instancesOf(document.scene())[1];
    EXPECT_EQ(document.plan().body(now.ids.at("wheel")).pose.position, pose.position);
    const Point at = document.plan().body(now.ids.at("load")).pose.position;
    const Point turnedBed = document.plan().body(now.ids.at("bed")).pose.position;
    EXPECT_NEAR(at.x(), turnedBed.x() - 0.6, 1e-5);
    EXPECT_NEAR(at.y(), turnedBed.y(), 1e-5);
    // And goes again where the template loses it.
    Template without = templateFrom(document, "Cart");
    std::erase_if(without.scene.bodies, [](const auto& one) { return one.id == "load"; });
    std::erase_if(without.scene.blueprints,
                  [](const auto& prefab) { return prefab.blueprint.name == "load"; });
    document.edit("Unload", [&] { changeTemplate(document, without); });
    EXPECT_EQ(document.scene().bodies.size(), 10u);
    EXPECT_EQ(document.world().validate(), "");
}

TEST_F(Templates, MechanismsFollowAndKeepWhatIsTheirOwn) {
    auto drive = [](sulfur::scene::SceneMechanism& mechanism) -> sulfur::Drive& {
        return std::get<sulfur::scene::Hinge>(mechanism.spec).options.drive;
    };
    document.edit("Motor", [&] {
        auto& mechanisms = document.planForEditing().mechanisms;
        drive(mechanisms[1]).motorSpeed = 3;  // of the first instance
        drive(mechanisms[1]).motorMax = 50;
        drive(mechanisms[4]).damping = 2;  // of the third
    });
    EXPECT_EQ(overrideCount(document, "Cart 3"), 1u);
    document.edit("Update", [&] { changeTemplate(document, templateFrom(document, "Cart")); });
    auto mechanisms = document.scene().mechanisms;
    ASSERT_EQ(mechanisms.size(), 6u);
    EXPECT_EQ(drive(mechanisms[1]).motorSpeed, 3);
    EXPECT_EQ(drive(mechanisms[3]).motorSpeed, 3);
    EXPECT_EQ(drive(mechanisms[5]).motorSpeed, 3);
    EXPECT_EQ(drive(mechanisms[4]).damping, 2);
    EXPECT_EQ(drive(mechanisms[2]).damping, 0);
    for (std::size_t i = 2; i < 6; ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_TRUE(mechanisms[i].id.empty() || mechanisms[i].id != mechanisms[k].id);
}

TEST_F(Templates, ThrustersBelongToTheTemplate) {
    document.edit("Thruster", [&] {
        setThrusters(document.planForEditing(), {{"bed", {0, 0}, {0, 20}, {}}});
    });
    EXPECT_EQ(overrideCount(document, "Cart"), 1u);
    document.edit("Update", [&] { changeTemplate(document, templateFrom(document, "Cart")); });
    EXPECT_EQ(thrustersOf(document.scene()).size(), 3u);
    document.edit("Place", [&] {
        placeTemplate(document, *definition(document.scene(), "Cart"), {9, 0});
    });
    EXPECT_EQ(thrustersOf(document.scene()).size(), 4u);
    EXPECT_EQ(overrideCount(document, "Cart 4"), 0u);
}

TEST_F(Templates, DeletedPartsStayDeletedAndUnlinkedOnesStayAsTheyAre) {
    document.edit("Delete", [&] {
        const BodyId wheel = document.bodyOf(idOf(1, "wheel"));
        document.remove({&wheel, 1});
    });
    document.edit("Unlink", [&] { unlink(document, {"Cart 3"}); });
    ASSERT_EQ(sulfurchamber::instancesOf(document.scene()).size(), 2u);
    setMass("wheel2", 9);
    document.edit("Update", [&] { changeTemplate(document, templateFrom(document, "Cart")); });
    EXPECT_EQ(sulfurchamber::instancesOf(document.scene())[1].ids.size(), 2u);
    EXPECT_NEAR(massOf(idOf(1, "wheel2")), 9, 1e-4);
    std::size_t light = 0;
    for (const auto& body : document.scene().bodies)
        if (std::abs(massOf(body.id) - 2) < 1e-3) ++light;
    EXPECT_EQ(light, 3u);  // of the unlinked one both wheels, of the first one the other
}

TEST_F(Templates, CopiesAreInstancesOfTheirOwnAlsoInAnotherWindow) {
    Workbench bench;
    bench.document().adopt(sulfur::scene::parse(document.text(), "test"));
    std::vector<BodyId> all;
    for (const char* id : {"bed", "wheel", "wheel2"}) all.push_back(bench.document().bodyOf(id));
    bench.select(all);
    bench.duplicate();
    const auto instances = sulfurchamber::instancesOf(bench.document().scene());
    ASSERT_EQ(instances.size(), 4u);
    EXPECT_EQ(instances[3].instance, "Cart 4");
    Workbench other;
    other.paste(bench.copy(), {0, 0});
    EXPECT_EQ(sulfurchamber::instancesOf(other.document().scene()).size(), 1u);
    EXPECT_EQ(definitions(other.document().scene()), std::vector<std::string>{"Cart"});
    EXPECT_EQ(overrideCount(other.document(), "Cart 4"), 0u);
}

TEST_F(Templates, ARunningSceneIsUpdatedByWayOfItsPlan) {
    document.play();
    for (int i = 0; i < 100; ++i) document.tick();
    const auto hash = document.world().hash();
    Template next = templateFrom(document, "Cart");
    next.scene.settings = document.scene().settings;
    for (auto& prefab : next.scene.blueprints)
        if (prefab.blueprint.name == "bed") numberProperty("mass")->set(prefab, 33);
    document.edit("Update", [&] { changeTemplate(document, next); });
    EXPECT_FALSE(document.canReset());
    EXPECT_NEAR(massOf(idOf(1, "bed")), 33, 1e-3);
    document.undo();
    EXPECT_TRUE(document.canReset());
    EXPECT_EQ(document.world().hash(), hash);
    EXPECT_NEAR(massOf(idOf(1, "bed")), 10, 1e-3);
}

TEST_F(Templates, BadNamesChangeNothing) {
    const std::string before = document.text();
    const auto attempt = [&](const std::string& name) {
        document.edit("Make", [&] { makeTemplate(document, cart(document), name, ""); });
    };
    EXPECT_THROW(attempt(""), std::runtime_error);
    EXPECT_THROW(attempt("a/b"), std::runtime_error);
    EXPECT_THROW(attempt("Cart"), std::runtime_error);
    EXPECT_THROW(document.edit("Make", [&] { makeTemplate(document, {}, "New", ""); }),
                 std::runtime_error);
    EXPECT_EQ(document.text(), before);
}

class LibraryTest : public testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() /
                 ("sulfur-library-test-" + std::to_string(getpid()));
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }
    std::filesystem::path folder;
};

TEST_F(LibraryTest, FindsSavesAndRemoves) {
    Library library({SULFURCHAMBER_TEMPLATES}, folder / "own");
    library.rescan();
    EXPECT_TRUE(library.problems().empty()) << library.problems().front();
    const std::size_t starters = library.entries().size();
    EXPECT_GE(starters, 25u);
    ASSERT_NE(library.find("Car"), nullptr);
    EXPECT_EQ(library.matching("CAR vehicles").front().name, "Car");
    EXPECT_TRUE(library.matching("no such thing").empty());
    EXPECT_THROW(library.remove("Car"), std::runtime_error);

    Template made = Library::load(*library.find("Car"));
    made.scene.description = "Mine.";
    EXPECT_THROW(library.save(made, true), std::runtime_error);
    library.save(made, false);
    EXPECT_EQ(library.entries().size(), starters);
    EXPECT_EQ(library.find("Car")->origin, LibraryEntry::Origin::own);
    library.setSceneFolder(folder);
    made.scene.description = "Of the scene.";
    EXPECT_EQ(library.save(made, true), folder / "templates" / "car.json");
    EXPECT_EQ(library.find("Car")->description, "Of the scene.");
    library.remove("Car");
    EXPECT_EQ(library.find("Car")->description, "Mine.");
    library.remove("Car");
    EXPECT_EQ(library.find("Car")->origin, LibraryEntry::Origin::starter);
}

TEST_F(LibraryTest, TellsWhatCannotBeReadAndWhatIsNewer) {
    Library library({}, folder);
    sulfur::scene::writeFile("{\"format\": 7}", folder / "broken.json");
    library.rescan();
    ASSERT_EQ(library.problems().size(), 1u);
    EXPECT_NE(library.problems()[0].find("broken.json"), std::string::npos);
    Document document;
    buildCart(document);
    Template made;
    document.edit("Make",
                  [&] { made = makeTemplate(document, cart(document), "Cart", "Vehicles"); });
    library.save(made, false);
    EXPECT_FALSE(differsFromLibrary(document.scene(), *library.find("Cart")));
    made.scene.description = "newer";
    library.save(made, false);
    EXPECT_TRUE(differsFromLibrary(document.scene(), *library.find("Cart")));
}

// German has other names, and an alphabet in which "Ä" is an "A".
TEST(Library, IsSortedAsItIsShown) {
    for (const std::string language : {"en", "de", "it"}) {
        setLanguage(language);
        Library library({SULFURCHAMBER_TEMPLATES}, {});
        library.rescan();
        std::vector<std::pair<std::string, std::string>> shown;
        for (const LibraryEntry& entry : library.entries())
            shown.emplace_back(alphabetKey(tr(entry.category)), alphabetKey(tr(entry.name)));
        EXPECT_GT(shown.size(), 25u);
        EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end())) << language;
        for (const char* bridge : {"BRÜCKE", "brücke", "brucke"})
            EXPECT_EQ(library.matching(bridge).empty(), language != "de") << bridge;
    }
    setLanguage("en");
}

}  // namespace
}  // namespace sulfurchamber
