// A group of rows of mechanisms in a sweep: what each of them does, and all together.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "core/settings.hpp"
#include "model/state.hpp"
#include "solver/mechanisms.hpp"

namespace sulfur::detail {

/// What a row does where its coordinate is: spring, motor and limits. They hold each other, so that
/// the place where it settles is sought first, as if nothing but itself moved it; then what each of
/// them gives there.
class RowLaw {
public:
    /// `now`: rad or m, its coordinate.
    RowLaw(MechanismRow& row, double now) : row_(row), now_(now), before_(row.sum()) {}

    void run() {
        if (!(row_.mobility > 0)) return;
        if (row_.rigid) return hold(row_.rest);
        const double goal = row_.start + row_.way;
        const double motor = needed(goal) - springAt(goal);
        row_.motor = std::clamp(motor, -row_.most, row_.most);
        const double place = row_.motor == motor ? goal : settled();
        const double at = std::clamp(place, row_.lower, row_.upper);
        if (at < goal && at != place) row_.motor = row_.most;
        if (at > goal && at != place) row_.motor = -row_.most;
        row_.spring = springAt(at);
        const double left = at != place ? needed(at) - row_.spring - row_.motor : 0;
        row_.low = at > place ? std::clamp(left, 0.0, row_.bound) : 0;
        row_.high = at < place ? std::clamp(left, -row_.bound, 0.0) : 0;
    }

    /// How much of a change leaves what holds the row able to hold it. Beyond, it obeys another
    /// law: all of the change would lead farther away, and back again, in turns.
    double shareInside(double change) const {
        const auto [least, most] = reach();
        const double now = row_.*row_.hold.multiplier;
        if (now < least || now > most) return 1;
        if (now + change > most) return (most - now) / change;
        return now + change < least ? (least - now) / change : 1;
    }

private:
    /// The least and the largest of the multiplier that holds the row.
    std::pair<double, double> reach() const {
        if (row_.hold.multiplier == &MechanismRow::low) return {0, row_.bound};
        if (row_.hold.multiplier == &MechanismRow::high) return {-row_.bound, 0};
        if (row_.hold.multiplier == &MechanismRow::motor) return {-row_.most, row_.most};
        if (row_.rigid) return {-row_.bound, row_.bound};
        const double goal = row_.start + row_.way;
        const double first = row_.motor < 0 ? goal : row_.lower;
        const double last = row_.motor > 0 ? goal : row_.upper;
        return {std::isfinite(last) ? springAt(last) : -row_.bound,
                std::isfinite(first) ? springAt(first) : row_.bound};
    }
    /// A rigid spring leaves nothing to the others.
    void hold(double place) {
        row_.motor = row_.low = row_.high = 0;
        row_.spring = std::clamp(needed(place), -row_.bound, row_.bound);
    }
    /// Multiplier of all together that leads there.
    double needed(double place) const { return before_ + (place - now_) / row_.mobility; }
    double springAt(double place) const {
        const double pull = row_.hk * (place - row_.rest) + row_.hb * (place - row_.start);
        return std::clamp(-pull, -row_.bound, row_.bound);
    }
    /// Where the spring and what the motor gives lead.
    double settled() const {
        const double wanted = -(row_.hk * (now_ - row_.rest) + row_.hb * (now_ - row_.start));
        const double steep = 1 + (row_.hk + row_.hb) * row_.mobility;
        const double own = before_ - row_.motor;
        const double spring = std::clamp(own + (wanted - own) / steep, -row_.bound, row_.bound);
        return now_ + row_.mobility * (spring - own);
    }

    MechanismRow& row_;
    double now_, before_;
};

/// Rows in the space of their multipliers. What is held is solved at once; then each row does what
/// its law says. What that holds or lets go is solved anew, until nothing changes any more.
class GroupSweep {
public:
    /// More rows in a group than that are solved one part after the other.
    static constexpr std::uint32_t mostRows = 64;
    /// Of a push, that trees or other rows leave: less than that is rounding, and nothing can move.
    static constexpr double blocked = 1e-6;

    GroupSweep(State& state, const MechanismGroup& group)
        : rows_(std::span(state.mechanisms.rows).subspan(group.first, group.last - group.first)),
          matrix_(state.mechanisms.numbers.data() + group.matrix),
          factor_(state.mechanisms.numbers.data() + group.factor) {
        for (std::size_t k = 0; k < rows_.size(); ++k) now_[k] = rows_[k].now;
    }

    /// Notes what holds each row, and eliminates those that are held: a row of the factor is how
    /// it moves the later ones when the earlier ones keep their goals.
    void factorise() {
        const std::size_t n = rows_.size();
        for (MechanismRow& row : rows_) row.hold = holdOf(row);
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t j = k; j < n; ++j) {
                const bool both = rows_[k].hold.multiplier && rows_[j].hold.multiplier;
                factor(k, j) = both ? matrix(k, j) + (j == k ? rows_[k].hold.compliance : 0) : 0;
            }
        for (std::size_t i = 0; i < n; ++i) {
            double* own = &factor(i, 0);
            if (!(own[i] > blocked * matrix(i, i))) {
                std::fill(own + i, own + n, 0.0);
                continue;
            }
            for (std::size_t k = i + 1; k < n; ++k) {
                if (own[k] == 0) continue;
                const double share = own[k] / own[i];
                double* later = &factor(k, 0);
                for (std::size_t j = k; j < n; ++j) later[j] -= share * own[j];
            }
            for (std::size_t k = i + 1; k < n; ++k) own[k] /= own[i];
        }
    }

    /// `farthest`: rad or m, that a coordinate may go in a sweep. What asks for more asks for what
    /// cannot be.
    void run(double farthest) {
        std::array<std::array<double, 4>, mostRows> before;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const MechanismRow& row = rows_[k];
            before[k] = {row.spring, row.motor, row.low, row.high};
        }
        settle();
        double way = 0;
        for (std::size_t k = 0; k < rows_.size(); ++k)
            way = std::max(way, std::abs(now_[k] - rows_[k].now));
        const double share = std::min(1.0, farthest / std::max(way, 1e-300));
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            MechanismRow& row = rows_[k];
            const auto led = [&](double& multiplier, double was) {
                if (share < 1) multiplier = was + share * (multiplier - was);
            };
            led(row.spring, before[k][0]);
            led(row.motor, before[k][1]);
            led(row.low, before[k][2]);
            led(row.high, before[k][3]);
            row.change = row.sum() - (before[k][0] + before[k][1] + before[k][2] + before[k][3]);
        }
    }

    /// `row.now`: how far each coordinate is to be moved. Finds what does that, as `row.change`.
    void lead() {
        for (MechanismRow& row : rows_) row.change = 0;
        bool changed = true;
        for (int i = 0; i < tuned::mostRowPasses && changed; ++i) {
            changed = false;
            for (std::size_t k = 0; k < rows_.size(); ++k) {
                if (!(rows_[k].mobility > 0)) continue;
                const double more = now_[k] / rows_[k].mobility;
                rows_[k].change += more;
                shift(k, -more);
                changed |= std::abs(more) > tuned::settledRow * std::abs(rows_[k].change);
            }
            changed &= rows_.size() > 1;
        }
    }

private:
    double& matrix(std::size_t k, std::size_t j) const { return matrix_[k * rows_.size() + j]; }
    double& factor(std::size_t k, std::size_t j) const { return factor_[k * rows_.size() + j]; }

    void settle() {
        if (rows_.size() == 1) return static_cast<void>(pass());
        for (int i = 0; i < tuned::mostRowPasses; ++i) {
            if (i < tuned::mostHolds) {
                if (holdsOthers()) factorise();
                solveHeld();
            }
            if (!pass()) return;
        }
    }

    /// Whether rows are held by other multipliers than those that have been eliminated.
    bool holdsOthers() const {
        return std::any_of(rows_.begin(), rows_.end(), [](const MechanismRow& row) {
            return holdOf(row).multiplier != row.hold.multiplier;
        });
    }

    void solveHeld() {
        const std::size_t n = rows_.size();
        std::array<double, mostRows> x;
        for (std::size_t k = 0; k < n; ++k) {
            const MechanismRow& row = rows_[k];
            x[k] = row.hold.multiplier
                       ? row.hold.goal - now_[k] - row.hold.compliance * row.*row.hold.multiplier
                       : 0;
        }
        for (std::size_t k = 0; k < n; ++k) {
            if (!(factor(k, k) > 0)) continue;
            for (std::size_t j = k + 1; j < n; ++j) x[j] -= factor(k, j) * x[k];
        }
        for (std::size_t k = n; k-- > 0;) {
            if (!(factor(k, k) > 0)) {
                x[k] = 0;
                continue;
            }
            double own = x[k] / factor(k, k);  // not in x: it would be stored in each turn
            for (std::size_t j = k + 1; j < n; ++j) own -= factor(k, j) * x[j];
            x[k] = own;
        }
        double share = 1;
        for (std::size_t k = 0; k < n; ++k)
            if (x[k] != 0) share = std::min(share, RowLaw(rows_[k], now_[k]).shareInside(x[k]));
        for (std::size_t k = 0; k < n; ++k) {
            if (x[k] == 0) continue;
            rows_[k].*rows_[k].hold.multiplier += share * x[k];
            shift(k, share * x[k]);
        }
    }

    /// Returns whether that has changed anything worth another one.
    bool pass() {
        double most = 0, largest = 0;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            MechanismRow& row = rows_[k];
            const double before = row.sum();
            RowLaw(row, now_[k]).run();
            const double change = row.sum() - before;
            if (change != 0) shift(k, change);
            // Times the root of a mobility a force is comparable with a torque.
            most = std::max(most, change * change * row.mobility);
            largest = std::max(largest, row.sum() * row.sum() * row.mobility);
        }
        return most > tuned::settledRow * tuned::settledRow * largest;
    }

    /// Moves all coordinates by a change of a row's multipliers.
    void shift(std::size_t k, double change) {
        const double* row = &matrix(k, 0);
        for (std::size_t j = 0; j < rows_.size(); ++j) now_[j] += row[j] * change;
    }

    std::span<MechanismRow> rows_;
    double* matrix_;
    double* factor_;
    std::array<double, mostRows> now_;  // rad or m, the coordinates
};

}  // namespace sulfur::detail
