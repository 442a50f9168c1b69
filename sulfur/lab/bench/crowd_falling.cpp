// Scenes of S8 in which a crowd falls: rain on ground with obstacles, barrels, compounds.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/crowd.hpp"

namespace sulfur::lab::bench {

namespace {

/// Groups of bodies that fall onto storeys 45 m apart, of tiles of half a metre with a turned block
/// every six metres. When every place has had its group, the oldest groups go and new ones come.
/// (Box2D lets people with joints that have limits and motors fall, which not every engine has:
/// here a group is 25 loose bodies of the same sizes.)
class Rain final : public Crowd {
public:
    Rain(int storeys, int columns, int tiles, double interval, double seconds)
        : Crowd(seconds),
          storeys_(storeys),
          columns_(columns),
          span_(tiles * tile),
          interval_(interval),
          groups_(static_cast<std::size_t>(columns)) {}

    void begin(EngineWorld& world) override {
        for (int storey = 0; storey < storeys_; ++storey) {
            const double y = storey * height;
            for (double x = -span_ / 2; x <= span_ / 2; x += tile)
                addWall(world, Point(x, y), Point(tile / 2, tile / 2));
            for (double x = -span_ / 2 + 3; x < span_ / 2; x += 6) {
                BodyPlan block{.parts = {rectangle(Point(0.75, 0.75))}};
                block.mover = Mover::nobody;
                block.place = Point(x, y + 2);
                block.angle = std::numbers::pi / 4;
                add(world, std::move(block));
            }
        }
    }

    void before(EngineWorld& world, double time) override {
        // Ticks of some rates begin a rounding error before the moment that is meant.
        for (; time + 1e-9 >= made_ * interval_; ++made_) {
            const auto column = static_cast<std::size_t>(made_ % columns_);
            for (const std::size_t body : groups_[column]) remove(world, body);
            groups_[column].clear();
            for (int storey = 0; storey < storeys_; ++storey) addGroup(world, storey, column);
        }
    }

protected:
    /// Through its storey; beyond the sides of the storeys everything may fall.
    bool lost(const BodyPlan& plan, const Motion& motion, double) const override {
        const double storey = height * std::floor((plan.place.y() - drop) / height);
        return std::abs(motion.place.x()) <= span_ / 2 && motion.place.y() < storey - 1;
    }

private:
    static constexpr double tile = 0.5, height = 45, drop = 40;  // m

    void addGroup(EngineWorld& world, int storey, std::size_t column) {
        const Outline kinds[] = {capsule(Point(0, -0.135), Point(0, 0.135), 0.09),
                                 capsule(Point(0, -0.125), Point(0, 0.125), 0.06), disc(0.1),
                                 rectangle(Point(0.1, 0.1)),
                                 capsule(Point(0, -0.14), Point(0, 0.14), 0.045)};
        const double distance = span_ / columns_;
        const Point corner(-span_ / 2 + distance * (static_cast<double>(column) + 0.5),
                           height * storey + drop);
        for (int i = 0; i < 25; ++i) {
            BodyPlan body{.parts = {kinds[i % 5]}};
            body.place = corner + Point(0.5 * (i / 5) + 0.02 * (i % 5), 0.4 * (i % 5));
            body.friction = 0.2;
            groups_[column].push_back(add(world, std::move(body)));
        }
    }

    int storeys_, columns_;
    double span_, interval_;
    int made_ = 0;
    std::vector<std::vector<std::size_t>> groups_;
};

/// Columns of bodies that fall into a container 79 m wide and 100 m high.
class Container final : public Crowd {
public:
    enum class Content { barrels, compounds };

    Container(Content content, int columns, int rows, double seconds)
        : Crowd(seconds), content_(content), columns_(columns), rows_(rows) {}

    void begin(EngineWorld& world) override {
        for (int i = -40; i <= 40; ++i) addWall(world, Point(i, 0), Point(0.55, 0.5));
        for (const double side : {-40.0, 40.0})
            for (int i = 1; i <= 100; ++i) addWall(world, Point(side, i), Point(0.5, 0.55));
        if (content_ == Content::barrels)
            addBarrels(world);
        else
            addCompounds(world);
    }

protected:
    bool lost(const BodyPlan&, const Motion& motion, double) const override {
        return std::abs(motion.place.x()) > 40 || motion.place.y() < 0;
    }

private:
    /// Discs, capsules and boxes of any size, one after the other.
    void addBarrels(EngineWorld& world) {
        constexpr double step = 1.15;
        for (int column = 0; column < columns_; ++column) {
            for (int row = 0; row < rows_; ++row) {
                const double side = row % 2 == 0 ? -0.1 : 0.1;
                BodyPlan body{.parts = {barrel(column * rows_ + row)}};
                body.place = Point((column - columns_ / 2.0) * step + side,
                                   row * (step + 0.5) + step / 2 + clearance);
                add(world, std::move(body));
            }
        }
    }

    Outline barrel(int i) {
        const double a = random_.next(), b = random_.next();
        if (i % 3 == 0) return disc(0.25 + 0.5 * a);
        if (i % 3 == 1) {
            const double half = 0.125 + 0.375 * b;
            return capsule(Point(0, -half), Point(0, half), 0.25 + 0.25 * a);
        }
        return rectangle(Point(0.1 + 0.4 * a, 0.5 + 0.25 * b));
    }

    /// Darts: concave, each of two triangles.
    void addCompounds(EngineWorld& world) {
        constexpr double step = 2, middle = 8.0 / 9;  // m; of mass, above the tips
        const Point left(-1, -middle), right(1, -middle), notch(0, 2.0 / 3 - middle),
            top(0, 2 - middle);
        for (int column = 0; column < columns_; ++column) {
            for (int row = 0; row < rows_; ++row) {
                const double side = row % 2 == 0 ? 0.25 : -0.25;
                BodyPlan body{.parts = {{{left, notch, top}}, {{notch, right, top}}}};
                body.contour = {left, notch, right, top};
                body.place = Point((column - columns_ / 2.0) * step + 1 + side,
                                   row * (step + 0.25) + middle + 5.6);
                add(world, std::move(body));
            }
        }
    }

    static constexpr double clearance = 5;  // m
    Content content_;
    int columns_, rows_;
    Lcg random_{12345};
};

}  // namespace

VariantScene rain(Extent extent) {
    const bool quick = extent == Extent::quick;
    const int storeys = quick ? 2 : 5, columns = quick ? 10 : 40, tiles = quick ? 120 : 500;
    const double interval = 8.0 / 60, seconds = quick ? 8 : 1000.0 / 60;
    const int bodies = 25 * storeys * columns;
    return {
        .title = fmt::format("{} bodies that fall on {} storeys with obstacles, and are made "
                             "and removed, {:.3g} s",
                             bodies, storeys, seconds),
        .seconds = seconds,
        .bodies = static_cast<double>(bodies),
        .play = [=] { return std::make_unique<Rain>(storeys, columns, tiles, interval, seconds); }};
}

VariantScene barrels(Extent extent) {
    const bool quick = extent == Extent::quick;
    const int columns = quick ? 10 : 26, rows = quick ? 40 : 150;
    const double seconds = quick ? 4 : 500.0 / 60;
    return {
        .title = fmt::format("{} discs, capsules and boxes that fall into a container, {:.3g} s",
                             columns * rows, seconds),
        .seconds = seconds,
        .bodies = static_cast<double>(columns * rows),
        .play = [=] {
            return std::make_unique<Container>(Container::Content::barrels, columns, rows, seconds);
        }};
}

VariantScene compounds(Extent extent) {
    const bool quick = extent == Extent::quick;
    const int columns = quick ? 10 : 20, rows = quick ? 40 : 150;
    const double seconds = quick ? 4 : 500.0 / 60;
    return {.title = fmt::format("{} concave darts that fall into a container, {:.3g} s",
                                 columns * rows, seconds),
            .seconds = seconds,
            .bodies = static_cast<double>(columns * rows),
            .play = [=] {
                return std::make_unique<Container>(Container::Content::compounds, columns, rows,
                                                   seconds);
            }};
}

}  // namespace sulfur::lab::bench
