// Scenes of S9 that drive: cars on a level road, and one on Box2D's course.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/mechanisms.hpp"
#include "bench/spread.hpp"

namespace sulfur::lab::bench {

namespace {

using std::numbers::pi;

constexpr double driveTorque = 5;  // N m, of each wheel

/// The largest gap of axles, m.
double axleGap(const EngineWorld& world, const Workshop& workshop, const Car& car) {
    double largest = 0;
    for (const std::size_t axle : car.axles)
        largest = worse(largest, workshop.anchors(axle).opening(world));
    return largest;
}

/// Cars that accelerate as their motors can, then drive on as fast as these turn.
class Cars final : public Contraption {
public:
    Cars(int count, double seconds) : count_(count), seconds_(seconds) {}

protected:
    void build(Workshop& workshop) override {
        workshop.add(road({{-20, 0}, {8.0 * count_ + 20 * seconds_, 0}}, 1.5));
        for (int i = 0; i < count_; ++i)
            cars_.push_back(
                addCar(workshop, Point(8.0 * i, 0), i + 1, 5, driveTorque, -Car::speed));
    }

    Figures more(const EngineWorld& world) override {
        const double a = carAcceleration(workshop(), cars_[0], driveTorque);
        const double speed = Car::speed * Car::wheelRadius, until = speed / a;
        const double way =
            seconds_ < until ? a * seconds_ * seconds_ / 2 : speed * (seconds_ - until / 2);
        double error = 0, covered = 0;
        for (const Car& car : cars_) {
            covered = world.body(car.chassis).place.x() - workshop().plan(car.chassis).place.x();
            error = worse(error, std::abs(covered / way - 1));
        }
        return {{"way", "m", covered}, {"error of the way", "%", 100 * error}};
    }

private:
    int count_;
    double seconds_;
    std::vector<Car> cars_;
};

/// Hills, a seesaw, a bridge of 20 planks, a stack of boxes, a jump and a wall.
class Course final : public Contraption {
protected:
    void build(Workshop& workshop) override {
        addGround(workshop);
        addSeesaw(workshop);
        addBridge(workshop);
        for (int i = 0; i < 5; ++i)
            workshop.add({.parts = {rectangle(Point(0.5, 0.5))},
                          .place = {230, 0.5 + i},
                          .density = 0.25,
                          .friction = 0.25,
                          .restitution = 0.25});
        car_ = addCar(workshop, Point(0, 0), 1, 5, driveTorque, -Car::speed);
    }

    void note(const EngineWorld& world, double) override {
        gap_ = worse(gap_, axleGap(world, workshop(), car_));
    }

    Figures more(const EngineWorld& world) override {
        return {{"way", "m", world.body(car_.chassis).place.x()},
                {"gap of the axles", "mm", gap_ * millimetres}};
    }

private:
    void addGround(Workshop& workshop) {
        std::vector<Point> hills{{-20, 20}, {-20, 0}, {20, 0}};
        constexpr double heights[] = {0.25, 1, 4, 0, 0, -1, -2, -2, -1.25, 0};  // m
        for (int i = 0; i < 20; ++i) hills.emplace_back(25 + 5.0 * i, heights[i % 10]);
        hills.emplace_back(160, 0);
        hills.emplace_back(160, -20);
        near_ = workshop.add(road(hills, surface));
        far_ = workshop.add(road({{200, -20}, {200, 0}, {240, 0}, {250, 5}}, surface));
        workshop.add(road({{260, 0}, {300, 0}, {300, 20}}, surface));
    }

    void addSeesaw(Workshop& workshop) {
        const Point pivot(140, 1);
        const std::size_t plank = workshop.add(
            {.parts = {rectangle(Point(10, 0.25))}, .place = pivot, .friction = surface});
        workshop.join(
            {.a = near_, .b = plank, .at = pivot, .lower = -8 * pi / 180, .upper = 8 * pi / 180});
    }

    void addBridge(Workshop& workshop) {
        constexpr double thickness = 0.125;  // m, half of it
        std::size_t before = near_;
        for (int i = 0; i <= 20; ++i) {
            const Point at(160 + 2.0 * i, -thickness);
            const std::size_t next =
                i == 20 ? far_
                        : workshop.add({.parts = {capsule(Point(-1, 0), Point(1, 0), thickness)},
                                        .place = at + Point(1, 0),
                                        .friction = surface});
            workshop.join({.a = before, .b = next, .at = at, .motorMax = i == 20 ? 50.0 : 0});
            before = next;
        }
    }

    static constexpr double surface = 0.6;
    std::size_t near_ = 0, far_ = 0;
    Car car_;
    double gap_ = 0;
};

}  // namespace

Car addCar(Workshop& workshop, const Point& foot, int group, double hertz, double torque,
           double speed) {
    std::vector<Point> corners{{-1.5, -0.5}, {1.5, -0.5},  {1.5, 0},
                               {0, 0.9},     {-1.15, 0.9}, {-1.5, 0.2}};
    const Point middle = centre(corners);
    Car car;
    car.chassis = workshop.add({.parts = {Outline{corners, 0}},
                                .place = foot + Point(0, 1) + middle,
                                .friction = 0.2,
                                .group = group});
    for (const double x : {-1.0, 1.0}) {
        const Point axle = foot + Point(x, Car::wheelRadius);
        car.wheels.push_back(workshop.add({.parts = {disc(Car::wheelRadius)},
                                           .place = axle,
                                           .density = 2,
                                           .friction = 1.5,
                                           .group = group}));
        car.axles.push_back(workshop.join({.kind = JointPlan::Kind::wheel,
                                           .a = car.chassis,
                                           .b = car.wheels.back(),
                                           .at = axle,
                                           .axis = {0, 1},
                                           .lower = -0.25,
                                           .upper = 0.25,
                                           .motorSpeed = speed,
                                           .motorMax = torque,
                                           .hertz = hertz,
                                           .dampingRatio = 0.7}));
    }
    return car;
}

double carAcceleration(const Workshop& workshop, const Car& car, double torque) {
    double inertia = workshop.plan(car.chassis).mass();  // kg, with that of what turns
    for (const std::size_t wheel : car.wheels) {
        const BodyPlan& plan = workshop.plan(wheel);
        inertia += plan.mass() + plan.inertia() / (Car::wheelRadius * Car::wheelRadius);
    }
    return static_cast<double>(car.wheels.size()) * torque / Car::wheelRadius / inertia;
}

VariantScene cars(Extent extent) {
    const int count = extent == Extent::quick ? 4 : 20;
    constexpr double seconds = 10;
    return {.title = fmt::format("{} cars on a level road, {:g} s", count, seconds),
            .seconds = seconds,
            .bodies = 3.0 * count,
            .error = "error of the way",
            .play = [=] { return std::make_unique<Cars>(count, seconds); }};
}

VariantScene driving(Extent extent) {
    const double seconds = extent == Extent::quick ? 10 : 30;
    return {
        .title = fmt::format("a car over hills, a seesaw, a bridge and a jump, {:g} s", seconds),
        .seconds = seconds,
        .bodies = 29,
        .error = "gap of the axles",
        .play = [] { return std::make_unique<Course>(); }};
}

}  // namespace sulfur::lab::bench
