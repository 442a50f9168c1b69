// Makes a scene that breaks a law smaller.
#include <algorithm>
#include <cmath>
#include <functional>

#include "battery/random/laws.hpp"

namespace sulfur::lab {

namespace {

/// A scene without one of its things and what was tied to it.
Scene without(const Scene& scene, std::size_t thing) {
    Scene less = scene;
    less.things.erase(less.things.begin() + static_cast<std::ptrdiff_t>(thing));
    std::erase_if(less.ties, [&](const Tie& tie) {
        const bool single = tie.kind == Tie::Kind::grab;
        return tie.a == thing || (!single && tie.b == thing);
    });
    for (Tie& tie : less.ties) {
        if (tie.a > thing) --tie.a;
        if (tie.b > thing) --tie.b;
    }
    return less;
}

/// To two decimal places of its own.
double rounded(double x) {
    if (x == 0 || !std::isfinite(x)) return x;
    const double unit = std::pow(10, std::floor(std::log10(std::abs(x))) - 1);
    return std::round(x / unit) * unit;
}

class Shrinker {
public:
    Shrinker(const Scene& scene, Law law) : best_(scene), laws_{law} {}

    Scene run() {
        if (!breaks(best_)) return best_;
        bool smaller = true;
        for (int round = 0; smaller && round < 8; ++round) {
            smaller = dropThings();
            smaller = dropTies() || smaller;
            smaller = simplifyWorld() || smaller;
            // Only what has weight, friction and corners has to come to rest.
            if (laws_[0] != Law::rest) smaller = simplifyThings() || smaller;
        }
        return best_;
    }

private:
    /// Whether it breaks the law; remembers when.
    bool breaks(const Scene& scene) {
        try {
            const std::vector<Breach> found = judge(scene, laws_);
            if (found.empty()) return false;
            tick_ = found.front().tick;
            return true;
        } catch (const Error&) {
            return false;  // a rounded thing may be one that cannot be made
        }
    }
    bool take(Scene scene) {
        if (!breaks(scene)) return false;
        best_ = std::move(scene);
        return true;
    }
    bool dropThings() {
        bool any = false;
        for (std::size_t i = best_.things.size(); i-- > 0;)
            if (best_.things.size() > 1) any = take(without(best_, i)) || any;
        return any;
    }
    bool dropTies() {
        bool any = false;
        for (std::size_t i = best_.ties.size(); i-- > 0;) {
            Scene less = best_;
            less.ties.erase(less.ties.begin() + static_cast<std::ptrdiff_t>(i));
            any = take(std::move(less)) || any;
        }
        for (std::size_t i = best_.influences.size(); i-- > 0;) {
            Scene less = best_;
            less.influences.erase(less.influences.begin() + static_cast<std::ptrdiff_t>(i));
            any = take(std::move(less)) || any;
        }
        return any;
    }
    /// Tries `change` on a copy, which must differ.
    bool attempt(const std::function<bool(Scene&)>& change) {
        Scene less = best_;
        return change(less) && take(std::move(less));
    }
    static bool put(double& value, double to) {
        if (value == to) return false;
        value = to;
        return true;
    }
    bool simplifyWorld() {
        bool any = attempt([&](Scene& s) {
            const int ticks = static_cast<int>(tick_) + 1;
            // What is looked at in the middle or at the end is not shortened.
            if (laws_[0] == Law::restore || s.restsAfter > 0 || ticks >= s.ticks) return false;
            s.ticks = ticks;
            return true;
        });
        any = attempt([](Scene& s) { return s.sleeping && !(s.sleeping = false); }) || any;
        any = attempt([](Scene& s) { return put(s.calm, 0); }) || any;
        if (laws_[0] == Law::rest) return any;
        any = attempt([](Scene& s) { return put(s.gravity, 0); }) || any;
        any = attempt([](Scene& s) { return put(s.airFriction, 0); }) || any;
        any = attempt([](Scene& s) { return put(s.room, rounded(s.room)); }) || any;
        return attempt([](Scene& s) { return s.rate != 500 && (s.rate = 500); }) || any;
    }
    bool simplifyThings() {
        bool any = false;
        for (std::size_t i = 0; i < best_.things.size(); ++i) {
            const auto on = [&](auto&& change) {
                any = attempt([&](Scene& s) { return change(s.things[i]); }) || any;
            };
            on([](Thing& t) { return put(t.strength, 0); });
            on([](Thing& t) { return put(t.friction, 0); });
            on([](Thing& t) { return put(t.restitution, 0); });
            on([](Thing& t) { return put(t.spin, 0); });
            on([](Thing& t) { return put(t.angle, 0); });
            on([](Thing& t) { return put(t.velocity.x(), 0) || put(t.velocity.y(), 0); });
            on([](Thing& t) { return t.role == Role::sensor && (t.role = Role::free, true); });
            on([](Thing& t) {
                return t.kind != Kind::ball && t.role == Role::free && (t.kind = Kind::ball, true);
            });
            on([](Thing& t) {
                return t.kind != Kind::ball && t.kind != Kind::crate &&
                       (t.kind = Kind::crate, true);
            });
            on([](Thing& t) { return put(t.variant, rounded(t.variant)); });
            on([](Thing& t) { return put(t.mass, 1); });
            on([](Thing& t) { return put(t.mass, rounded(t.mass)); });
            on([](Thing& t) { return put(t.size, rounded(t.size)); });
            on([](Thing& t) {
                const Eigen::Vector2d before = t.velocity;
                t.velocity = before.unaryExpr(&rounded);
                return t.velocity != before;
            });
        }
        return any;
    }

    Scene best_;
    std::vector<Law> laws_;
    long tick_ = 0;
};

}  // namespace

Scene shrink(const Scene& scene, Law law) {
    return Shrinker(scene, law).run();
}

}  // namespace sulfur::lab
