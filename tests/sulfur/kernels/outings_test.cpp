// How far particles are from where they were drawn, with and without wide registers.
#include "kernels/outings.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

using detail::OutingKernels;
using detail::OutingView;
using detail::SkinBound;

/// Particles anywhere near where they were drawn.
struct Strays {
    explicit Strays(std::size_t count) : outings(count), drawnFor(count), reach(count) {
        std::mt19937 random(static_cast<unsigned>(count));
        std::uniform_real_distribution<double> anywhere(-1, 1);
        for (std::size_t i = 0; i < 2 * count; ++i) {
            reference.push_back(1e4 * anywhere(random));
            position.push_back(reference.back() + 0.05 * anywhere(random));
            displacement.push_back(static_cast<Real>(0.01 * anywhere(random)));
        }
        for (std::size_t i = 0; i < count; ++i) {
            drawnFor[i] = Real(0.02);
            reach[i] = i % 3 == 1 ? Real(0) : Real(0.1);
        }
    }

    OutingView view() const { return {position.data(), reference.data(), displacement.data()}; }
    Real wayX(std::size_t i) const { return static_cast<Real>(position[2 * i] - reference[2 * i]); }
    Real wayY(std::size_t i) const {
        return static_cast<Real>(position[2 * i + 1] - reference[2 * i + 1]);
    }
    bool anyBeyond(const OutingKernels& kernels, std::size_t first, std::size_t last) const {
        const SkinBound bound{drawnFor.data(), reach.data(), base, cell, 1, Real(0.5)};
        return kernels.anyBeyond(view(), bound, first, last);
    }

    std::vector<double> position, reference;
    static constexpr Real base = Real(0.1), cell = Real(0.1);
    std::vector<Real> displacement, outings, drawnFor, reach;
};

class Outings : public testing::TestWithParam<const OutingKernels*> {};

TEST_P(Outings, AreThoseOfEachParticle) {
    for (const std::size_t count : {1u, 2u, 7u, 8u, 9u, 31u, 40u}) {
        Strays s(count);
        const std::size_t first = count / 3;
        GetParam()->measure(s.view(), s.outings.data(), first, count);
        for (std::size_t i = 0; i < count; ++i) {
            const Real x = s.wayX(i), y = s.wayY(i);
            const Real dx = s.displacement[2 * i], dy = s.displacement[2 * i + 1];
            const Real far = std::sqrt(x * x + y * y) + std::sqrt(dx * dx + dy * dy);
            EXPECT_EQ(s.outings[i], i < first ? Real(0) : far) << i << " of " << count;
        }
    }
}

TEST_P(Outings, TellWhetherAnySurfaceIsBeyondItsShare) {
    for (const std::size_t count : {1u, 8u, 13u, 40u})
        for (std::size_t stray = 0; stray < count; ++stray) {
            Strays s(count);
            EXPECT_FALSE(s.anyBeyond(*GetParam(), 0, count));
            // With what is ahead it is 0.11 m away, and half of 0.206 is allowed.
            s.position[2 * stray] = s.reference[2 * stray] + 0.1;
            s.position[2 * stray + 1] = s.reference[2 * stray + 1];
            s.displacement[2 * stray] = Real(0.01);
            EXPECT_EQ(s.anyBeyond(*GetParam(), 0, count), s.reach[stray] > 0) << stray;
            EXPECT_FALSE(s.anyBeyond(*GetParam(), 0, stray));
            EXPECT_FALSE(s.anyBeyond(*GetParam(), stray + 1, count));
        }
}

TEST_P(Outings, TellWhetherAnySurfaceStartsBeyondItsShareOrGoesTooFar) {
    for (const std::size_t count : {1u, 8u, 13u})
        for (std::size_t stray = 0; stray < count; ++stray) {
            Strays s(count);
            // It comes back from 0.11 m.
            s.position[2 * stray] = s.reference[2 * stray] + 0.11;
            s.position[2 * stray + 1] = s.reference[2 * stray + 1];
            s.displacement[2 * stray] = Real(-0.01);
            s.displacement[2 * stray + 1] = 0;
            EXPECT_EQ(s.anyBeyond(*GetParam(), 0, count), s.reach[stray] > 0) << stray;
            // It stays near, but goes further in a tick than 0.047 m.
            s.position[2 * stray] = s.reference[2 * stray] - 0.02;
            s.displacement[2 * stray] = Real(0.046);
            EXPECT_FALSE(s.anyBeyond(*GetParam(), 0, count)) << stray;
            s.displacement[2 * stray] = Real(0.048);
            EXPECT_EQ(s.anyBeyond(*GetParam(), 0, count), s.reach[stray] > 0) << stray;
        }
}

TEST_P(Outings, TellWhichCandidatesHaveComeNear) {
    std::mt19937 random(5);
    std::uniform_real_distribution<Real> off(0, 1);
    constexpr std::uint32_t particles = 20;
    std::vector<Real> outings(particles);
    for (Real& outing : outings) outing = off(random);
    for (const std::size_t count : {1u, 4u, 8u, 9u, 40u, 256u}) {
        std::vector<std::uint32_t> p(count), a(count), b(count), near(count), expected;
        std::vector<Real> spare(count);
        const std::size_t first = count / 4;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (auto* list : {&p, &a, &b}) (*list)[i] = random() % particles;
            const Real both = outings[p[i]] + std::max(outings[a[i]], outings[b[i]]);
            // Some may just be off so far.
            spare[i] = i % 5 == 0 ? both : 2 * off(random);
            if (i >= first && both >= spare[i]) expected.push_back(i);
        }
        near.resize(GetParam()->findNear({p.data(), a.data(), b.data(), spare.data()},
                                         outings.data(), near.data(), first, count));
        EXPECT_EQ(near, expected) << count;
    }
}

const std::vector<const OutingKernels*>& runnable() {
    static const std::vector<const OutingKernels*> kernels = [] {
        std::vector<const OutingKernels*> all{&detail::baselineOutings};
        if (&detail::outingKernels() != all[0]) all.push_back(&detail::outingKernels());
        return all;
    }();
    return kernels;
}

INSTANTIATE_TEST_SUITE_P(Widths, Outings, testing::ValuesIn(runnable()));

}  // namespace
}  // namespace sulfur
