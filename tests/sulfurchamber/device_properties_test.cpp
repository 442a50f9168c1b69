// The numbers of mechanisms, zones and thrusters: each is shown, set, refused and undone.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "model/fitting_marks.hpp"
#include "model/fitting_properties.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

const std::string fitted = R"({"format": "sulfur-scene", "version": 1, "blueprints": {
  "post": {"kind": "fixed", "particles": [{"position": [0, 0]}, {"position": [0, 1]}],
           "joints": [{"a": 0, "b": 1}]},
  "beam": {"shape": "box", "size": [1, 0.2]}, "wheel": {"shape": "wheel", "radius": 0.3}},
  "bodies": [{"id": "post", "blueprint": "post"},
             {"id": "door", "blueprint": "beam", "position": [0.5, 0]},
             {"id": "wagon", "blueprint": "beam", "position": [3, 2]},
             {"id": "tail", "blueprint": "beam", "position": [3.9, 2]},
             {"id": "wheel", "blueprint": "wheel", "position": [3, 1.6]},
             {"id": "lamp", "blueprint": "beam", "position": [6, 2]},
             {"id": "left", "blueprint": "beam", "position": [8, 2]},
             {"id": "right", "blueprint": "beam", "position": [10, 2]}],
  "mechanisms": [
    {"type": "hinge", "id": "swing", "a": "post", "b": "door", "at": [0, 0],
     "drive": {"lower": -2, "upper": 1, "motorSpeed": 1, "motorMax": 5},
     "keys": {"forward": "R", "back": "L"}},
    {"type": "slider", "id": "rail", "a": "post", "b": "wagon", "at": [3, 2], "axis": [1, 0],
     "drive": {"lower": -1, "upper": 1}},
    {"type": "weld", "id": "weld", "a": "wagon", "b": "tail", "at": [3.5, 2]},
    {"type": "wheel", "id": "axle", "a": "wagon", "b": "wheel", "at": [3, 1.6], "axis": [0, 1],
     "spring": {"stiffness": 100, "damping": 3}, "motor": {"motorSpeed": -3, "motorMax": 10}},
    {"type": "distance", "id": "spring", "a": "post", "b": "lamp", "atA": [0, 1], "atB": [6, 2],
     "drive": {"stiffness": 50, "rest": 3}},
    {"type": "distance", "id": "cable", "a": "post", "b": "lamp", "atA": [0, 1], "atB": [6, 2],
     "drive": {"upper": 7}},
    {"type": "pulley", "id": "rope", "a": "left", "b": "right", "frame": "post", "atA": [8, 2],
     "atB": [10, 2], "overA": [0, 0.9], "overB": [0, 1]},
    {"type": "gear", "id": "gear", "first": "swing", "second": "rail", "ratio": 0.5}],
  "fields": [{"type": "wind", "zone": {"low": [0, 0], "high": [2, 3]}, "velocity": [3, 4]},
             {"type": "uniform", "zone": {"low": [4, 0], "high": [6, 3]}, "acceleration": [0, 5]}],
  "devices": [{"type": "thruster", "body": "lamp", "at": [0, 0], "force": [3, 4]}]})";

struct Fitted {
    Fitted() {
        const auto file = std::filesystem::path(testing::TempDir()) / "device_properties.json";
        std::ofstream(file) << fitted;
        document().open(file);
    }
    Document& document() { return bench.document(); }
    const FittingProperty& property(const char* key, const FittingRef& ref) {
        const auto* found = fittingProperty(key, document().fitting(ref));
        if (found == nullptr) throw std::runtime_error(std::string("no property ") + key);
        return *found;
    }
    double get(const FittingProperty& property, const FittingRef& ref) {
        return *property.get(document().fitting(ref));
    }
    void set(const FittingProperty& property, const FittingRef& ref, double value) {
        document().edit("Change", [&] { setFittingProperty(document(), ref, property, value); });
    }
    Workbench bench;
};

// A value in the range that differs from what it is and is allowed beside the others.
double otherValue(const FittingProperty& property, double now) {
    if (property.whole) return now > 0.5 ? 0 : 1;
    if (property.key == "turn-back" || property.key == "turn-on") return 90;
    if (property.key == "slide-back" || property.key == "slide-on") return 2.5;
    const double low = std::max(property.low, 0.02), high = std::min(property.high, 8.0);
    const double value = std::sqrt(low * high);
    return std::abs(value - now) < 1e-3 ? value * 1.5 : value;
}

TEST(DeviceProperties, EachIsShownSetRefusedAndUndoneBeforeAndWhileTimeRuns) {
    std::set<const FittingProperty*> seen;
    for (const bool moved : {false, true}) {
        Fitted shop;
        if (moved)
            for (int i = 0; i < 20; ++i) shop.bench.tick();
        auto all = shop.document().fittings();
        all.push_back({FittingRef::Kind::particle, 0, "door"});
        all.push_back({FittingRef::Kind::joint, 0, "door"});
        for (const FittingRef& ref : all)
            for (const FittingProperty& property : fittingProperties()) {
                const bool place = property.key == "particle-x" || property.key == "particle-y";
                if (place && moved) continue;  // particles are moved before time runs
                const auto now = property.get(shop.document().fitting(ref));
                if (!now) continue;
                seen.insert(&property);
                const std::string before = shop.document().text();
                const double wanted = otherValue(property, *now);
                shop.set(property, ref, wanted);
                EXPECT_NEAR(shop.get(property, ref), wanted, 2e-3 * std::abs(wanted) + 1e-4)
                    << property.key << ' ' << ref.index;
                EXPECT_EQ(shop.document().world().validate(), "");
                EXPECT_THROW(shop.set(property, ref, property.high * 2 + 1), std::runtime_error)
                    << property.key;
                shop.document().undo();
                EXPECT_EQ(shop.document().text(), before) << property.key;
            }
    }
    for (const FittingProperty& property : fittingProperties())
        EXPECT_TRUE(seen.contains(&property) || property.key == "target") << property.key;
}

TEST(DeviceProperties, TheRunningWorldTakesThemAtOnce) {
    Fitted shop;
    for (int i = 0; i < 20; ++i) shop.bench.tick();
    const auto info = [&](std::size_t i) {
        return shop.document().world().info(shop.document().made()[i].id);
    };
    const FittingRef swing{FittingRef::Kind::mechanism, 0}, rope{FittingRef::Kind::mechanism, 5};
    shop.set(shop.property("torque", swing), swing, 7);
    EXPECT_EQ(info(0).drive.motorMax, 7);
    const std::string plan = shop.document().scene().bodies[1].id;
    EXPECT_NEAR(shop.document().plan().body(plan).pose.position.x(), 0.5, 1e-9)
        << "what drives it leaves the plan where it is";
    shop.set(shop.property("strength", rope), rope, 55);
    EXPECT_EQ(info(5).drive.strength, 55);
    const FittingRef gear{FittingRef::Kind::mechanism, 7};
    shop.set(shop.property("ratio", gear), gear, 2);
    EXPECT_EQ(info(7).ratio, 2);
    const FittingRef wind{FittingRef::Kind::zone, 0};
    shop.set(shop.property("direction", wind), wind, 90);
    const auto field = shop.document().fieldOf(0);
    ASSERT_TRUE(field);
    const auto& now = std::get<sulfur::WindField>(shop.document().world().field(field));
    EXPECT_NEAR(static_cast<double>(now.velocity.y()), 5, 1e-5) << "5 m/s, now upwards";
}

TEST(DeviceProperties, EachHasAMarkWhereItIs) {
    Fitted shop;
    const auto marks = fittingMarks(shop.document());
    EXPECT_EQ(marks.size(), shop.document().fittings().size());
    std::map<FittingMark::Shape, int> shapes;
    for (const FittingMark& mark : marks) ++shapes[mark.shape];
    using Shape = FittingMark::Shape;
    for (const Shape shape :
         {Shape::motor, Shape::slider, Shape::weld, Shape::axle, Shape::spring, Shape::cable,
          Shape::pulley, Shape::gear, Shape::wind, Shape::zone, Shape::thruster})
        EXPECT_EQ(shapes[shape], 1);
    EXPECT_EQ(fittingAt(shop.document(), {3.02, 1.6}, 0.1),
              (FittingRef{FittingRef::Kind::mechanism, 3}));
    EXPECT_EQ(fittingAt(shop.document(), {2.02, 2.5}, 0.1),
              (FittingRef{FittingRef::Kind::zone, 0}));
}

TEST(DeviceProperties, WhatIsSelectedIsFollowedWhenOthersGo) {
    Fitted shop;
    shop.bench.chooseFitting(FittingRef{FittingRef::Kind::mechanism, 4});
    shop.document().edit("Delete", [&] {
        shop.document().unfit({FittingRef::Kind::mechanism, 0});
    });
    ASSERT_TRUE(shop.bench.fitting());
    EXPECT_EQ(shop.bench.fitting()->index, 3u) << "the gear went too, but stood behind";
    shop.bench.deleteSelection();
    EXPECT_FALSE(shop.bench.fitting());
    EXPECT_EQ(shop.document().scene().mechanisms.size(), 5u);
    shop.document().undo();
    EXPECT_EQ(shop.document().scene().mechanisms.size(), 6u);
}

TEST(DeviceProperties, EveryPropertyHasWordsAndARange) {
    for (const FittingProperty& property : fittingProperties()) {
        EXPECT_FALSE(property.name.empty());
        EXPECT_FALSE(property.help.empty()) << property.key;
        EXPECT_LT(property.low, property.high) << property.key;
    }
}

}  // namespace
}  // namespace sulfurchamber
