// What presses on networks that touch each other, in their sweeps: contacts with friction, solved
// together.
//
// A network answers a push at one contact at all the others. The answers of all of them, with those
// of the movers that press, are a small dense matrix (the Delassus operator); what presses and rubs
// is found on it by projected Gauss-Seidel (Jourdan, Alart and Jean 1998), with the law of the
// rows. The rows of these contacts are nobody else's in the sweeps: to a row, light nodes that
// carry much are free.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "contacts/touch_rows.hpp"
#include "trees/networks.hpp"

namespace sulfur::detail {

/// How far rows have pushed a mover in this step, without a velocity.
Freedoms pushOf(const State& state, std::uint32_t mover);
void placeBy(State& state, std::uint32_t mover, const Freedoms& push);

class NetworkContacts {
public:
    NetworkContacts(State& state, std::uint32_t group);

    /// Takes up the touches of the group, as they are now.
    void list();
    /// Notes how much a contact may press in this step: what stops all that is there, and some
    /// leverage. What is held between links that cannot give and what stands fast presses without
    /// end else.
    void bound();
    /// Rows for which no answers are known: those of another tick, or of other factors.
    void findAnswers();
    bool areKnown() const;

    /// Changes of what presses and rubs, from where the nodes would go without any.
    void solve();
    /// The same of pushes without a velocity, which part what overlaps.
    void solvePushes();
    /// Takes these changes from residuals, or adds all that the passes have given so far to the
    /// impulses on nodes.
    void takeChanges();
    void addPressed();
    /// So much of the changes is made.
    void advance(double share);
    void keepBest();
    /// m, by which a contact is open or closed at most, beyond what rows would leave alone as well.
    double error() const;

    /// Adds what nodes get to their impulses; the other side gets it here.
    void push();
    /// Whether there is anything to part.
    bool overlap() const;
    /// What bodies that press are pushed apart by; call it after solvePushes().
    void placeBodies();

    /// See detail::brake().
    void brake();

    std::size_t rows() const { return work_.contacts.size(); }

private:
    void addTouch(const NetworkTouch& held);
    void addRow(const NetworkTouch& held, const TouchView& t, const TouchDirection& d);
    std::uint32_t bodyOf(std::uint32_t mover, const Freedoms& inverseMass);
    using Vectors = std::vector<Freedoms> NetworkMember::*;
    double along(const PressedRow& row, Vectors of) const;
    void addTo(Vectors of, const PressedRow& row, double amount);
    double valueOf(const PressedRow& row) const;
    double ownAnswer(std::size_t i, std::size_t j) const;
    void moveBodies(const PressedRow& row, double amount);
    double allowed(const PressedRow& row, double total) const;
    template <class Total, class Law>
    void relax(std::span<double> values, Total&& totalOf, Law&& law);

    State& state_;
    std::uint32_t number_;
    NetworkGroup& group_;
    NetworkSweep& work_;
    double settled_;  // m, by which surfaces may part that do not
};

}  // namespace sulfur::detail
