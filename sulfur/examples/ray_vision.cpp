// What does an eye in the middle of a room see? It sends out rays in all directions; the first
// surfaces that these meet bound what is in view. A filter lets the rays pass through glass, so
// that the ball behind the pane is seen, the one behind a pillar is not.
#include <cmath>
#include <cstdio>
#include <set>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-5.04, -3.04}, {5.04, 3.04});

    World world({.gravity = {0, 0}});
    world.add(shapes::ground({.points = {{-5, -3}, {5, -3}, {5, 3}, {-5, 3}}, .closed = true}));
    const auto block = [&](Point place, Vec2 size, double angle, std::uint32_t category) {
        Blueprint plan = shapes::box({.size = size});
        plan.kind = BodyKind::fixed;
        plan.filter.category = category;
        return world.add(plan, {.position = place, .angle = angle});
    };
    constexpr std::uint32_t stone = 1, glass = 2;  // bits of Filter::category
    block({-2.2, -1}, {0.7, 0.7}, 0.4, stone);
    block({-1.6, 1.6}, {0.9, 0.9}, 0.8, stone);
    block({1.6, 0.4}, {1, 1}, 0.4, stone);
    const Body pane = block({0, -1.2}, {2.4, 0.1}, 0, glass);
    picture.paint(pane, "teal");
    const Body seen = world.add(shapes::ball({.radius = 0.25}), {.position = {0.4, -2.2}});
    const Body hidden = world.add(shapes::ball({.radius = 0.25}), {.position = {3.6, 0.9}});

    const Point eye(-0.4, 0.2);
    constexpr int rays = 720;
    std::set<BodyId> met;
    std::vector<Point> outline;
    for (int i = 0; i < rays; ++i) {
        const double angle = 2 * 3.14159265358979 * i / rays;
        const Vec2 direction(static_cast<Real>(std::cos(angle)),
                             static_cast<Real>(std::sin(angle)));
        const auto hit = world.castRay(eye, direction, 20, {.mask = ~glass});
        if (!hit) continue;
        met.insert(hit->body);
        outline.push_back(hit->point);
        if (i % 4 == 0) picture.line(eye, hit->point, 0.35);
    }
    picture.take(world);

    double area = 0;  // m^2 in view
    for (std::size_t i = 0; i < outline.size(); ++i)
        area += cross(outline[i] - eye, outline[(i + 1) % outline.size()] - eye) / 2;
    const bool sees = met.count(seen) == 1, overlooks = met.count(hidden) == 0;
    std::printf(
        "%.1f m^2 of 60 are in view; the ball behind glass is %s, the one behind a pillar %s\n",
        area, sees ? "seen" : "not seen", overlooks ? "is not" : "too");
    return sees && overlooks && area > 20 && area < 55 ? 0 : 1;
}
