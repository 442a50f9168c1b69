// Whoever calls World in any order, with good and bad arguments. Tests let it draw from seeds, the
// fuzz target from bytes.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <sulfur/sulfur.hpp>
#include <vector>

#include "calls/numbers.hpp"

namespace sulfur::test {

/// The library has broken a promise.
struct BrokenPromise : std::logic_error {
    using std::logic_error::logic_error;
};
inline void require(bool truth, const std::string& promise) {
    if (!truth) throw BrokenPromise("broken promise: " + promise);
}

/// What a callback throws.
struct Refusal : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What may be called: all of it, or only what gives nothing energy.
enum class Calls { all, harmless };

/// Pieces of work in the wrong order, by the caller's thread: whoever divides work pays nothing.
class DividedTasks final : public Tasks {
public:
    std::size_t threads() const override { return 3; }
    double overhead() const override { return 0.001; }
    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
        ++runs;
        for (std::size_t i = count; i-- > 0;) task(context, i);
    }
    std::size_t runs = 0;
};

/// Calls a world at random. Everything that it draws comes from its own numbers and from the state
/// of the world, so that the same numbers make the same calls.
class Caller {
public:
    /// Who `asks` also looks at the world, and draws the same numbers as who does not.
    Caller(std::unique_ptr<Numbers> numbers, bool asks, Calls calls = Calls::all);
    Caller(std::uint64_t seed, bool asks, Calls calls = Calls::all);

    /// Goes on as this one would, with a world restored from a snapshot of this one's.
    std::unique_ptr<Caller> twin(bool asks) const;

    World& world() { return *world_; }
    int refused() const { return refused_; }
    int accepted() const { return accepted_; }
    int broken() const { return broken_; }
    bool done() const { return numbers_->done(); }

    /// One call. Throws BrokenPromise if it is refused and changes something all the same.
    void call();
    /// A tick by itself, with what callbacks throw in it.
    void step();
    /// Throws BrokenPromise unless everything is finite and what was there still is.
    void check();

private:
    using Call = void (Caller::*)();
    double real();
    Real number() { return static_cast<Real>(real()); }
    Real positive() { return std::abs(number()); }
    double unit() { return numbers_->uniform(0, 1); }
    Real fraction() { return numbers_->below(20) == 0 ? number() : static_cast<Real>(unit()); }
    bool either() { return numbers_->below(2) == 0; }
    bool oneIn(std::size_t count) { return numbers_->below(count) == 0; }
    Vec2 vector();
    std::vector<Vec2> vectors(std::size_t fewerThan);
    Point place();
    template <class T>
    T oneOf(std::span<const T> list) {
        return list.empty() || oneIn(60) ? T{} : list[numbers_->below(list.size())];
    }
    template <class T>
    T oneOf(const std::vector<T>& list) {
        return oneOf(std::span<const T>(list));
    }
    BodyId body();  // now and then one that is gone
    ParticleId particle();
    JointId joint();
    Material material();
    Filter filter();
    Real strength() { return either() ? infinite : static_cast<Real>(numbers_->uniform(1, 400)); }
    Zone zone();
    Field field();
    WorldSettings settings();
    QueryFilter queryFilter();
    QueryShape queryShape();

    // plans.cpp
    Blueprint plan();
    Blueprint commonPlan(std::size_t kind, Real strength);
    Blueprint rarePlan(Real strength);
    Blueprint rawPlan();
    void disturb(Blueprint& plan);

    // caller.cpp
    void make();
    void removeBody();
    void removeSomething();
    void weaken();
    void bury(BodyId id);

    // answers.cpp
    void setCallbacks();
    void lendCallbacks();
    bool answerShouldCollide(BodyId a, BodyId b);
    bool answerPreSolve(const PreSolveContact& contact, Material& surface);
    void misbehave(std::uint64_t bits);
    void clone();

    // changes.cpp
    void tie();
    void changeBody();
    void changeJoint();
    void changeParticle();
    void push();
    void pushBody();
    void influence();
    void changeWorld();
    void drive();
    void saveOrRestore();
    void restore();
    void tick();
    void checkEvents();

    // questions.cpp
    void ask();
    void askWays();
    void askPlaces();
    void askThings();
    void lookAtAll();
    template <class Question>
    void answer(Question&& question);

    std::unique_ptr<World> world_;
    std::unique_ptr<Numbers> numbers_;
    bool asks_;
    Calls allowed_;
    DividedTasks tasks_;
    std::vector<Call> calls_;
    std::vector<BodyId> alive_, gone_;
    bool asksShouldCollide_ = false, asksPreSolve_ = false;
    std::uint64_t answers_ = 0;   // what answers depend on, beside what is asked
    bool misbehaves_ = false;     // a callback throws now and then
    bool hasMisbehaved_ = false;  // in this tick
    Snapshot saved_;
    std::vector<BodyId> savedAlive_;
    int refused_ = 0, accepted_ = 0, broken_ = 0;
};

/// Calls a world, looks at it and lends it threads beside a twin that makes the same calls alone,
/// and that is restored from a snapshot of it now and then: both stay equal to the bit. Ends with
/// the numbers or after `mostCalls`. Throws BrokenPromise if anything that must be true is not.
/// Returns how many calls were made.
int callBesideATwin(std::unique_ptr<Numbers> numbers, int mostCalls);

}  // namespace sulfur::test
