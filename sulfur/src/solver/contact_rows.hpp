// The contacts of a tick, laid out for kernels that solve several at once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/contact_sweep.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

/// Contacts in colours: those of one colour share nothing that can be pushed, so that a kernel may
/// take them in any order. Colours are handed out greedily, in the order of the contacts. What
/// trees take part in, and what has friction of the paper's kind, is solved singly, as are those
/// for which no colour is left.
///
/// While it sweeps, the motion of what contacts push is here and not in the state. Holds scratch
/// memory only.
class ContactRows {
public:
    /// Hands colours to the contacts. Looks neither at multipliers nor at what is known of them
    /// from the last tick.
    void colour(const State& state);
    /// Lays them out with the multipliers that they have.
    void collect(const State& state);
    /// Pushes with these multipliers.
    void warmStart(State& state);
    /// Whether all contacts are in blocks.
    bool takesAll() const { return single_.empty(); }

    /// Fetches the motions from the state, or puts them back.
    void takeMotions(const State& state);
    void giveMotions(State& state);
    /// The same with the multipliers of the contacts.
    void takeMultipliers(const State& state);
    void giveMultipliers(State& state) const;

    /// Over the contacts in blocks in either direction, `backwards` or forwards last, between
    /// takeMotions() and giveMotions().
    void sweep(bool backwards);
    /// The same, and once over all others, on the motions in the state.
    void sweep(State& state, bool backwards);

    /// Leads apart what overlaps, and back what has crept from its place, by moving positions.
    void recover(State& state);

    /// Whether any contact is left with an error that is worth a sweep; by the motions that were
    /// fetched, for blocks, or those in the state.
    bool anyError(const State& state) const;
    /// The same, of contacts in blocks with errors that take more than one.
    bool anyLargeError(const State& state) const;
    /// The same, with errors that show: of contacts in blocks; of those that are solved singly.
    bool anyDeepError(const State& state) const;
    bool anyDeepErrorSingly(const State& state) const;

    /// Whether the sweeps have left any contact deeper than they may.
    bool anyTooDeep(const State& state) const;

private:
    using Blocks = std::vector<ContactBlock>;
    /// Blocks of one colour.
    struct Colour {
        std::uint32_t firstTwo = 0, lastTwo = 0, firstThree = 0, lastThree = 0;
    };
    /// Where a contact goes, and the movers of its particle and of the capsule's ends.
    struct Mark {
        std::uint8_t colour = 0;
        bool three = false;
        std::array<std::uint32_t, 3> movers{};
    };
    /// What can be pushed, and in which order its motion is in movers_.
    struct Owner {
        std::uint32_t cluster = none, particle = none;
    };

    bool anyErrorBeyond(Real most) const;
    bool anySingleBeyond(const State& state, Real most) const;
    void takeShifts(const State& state);
    void giveShifts(State& state);
    void applyShifts(State& state);
    template <class Function>
    void forEachMover(Function&& f);
    void sweepBlocks(ContactKernels::Sweep two, ContactKernels::Sweep three, bool backwards);
    std::uint32_t moverOf(const State& state, const Grip& grip);
    std::uint32_t addMover(const State& state, const Grip& grip);
    void colourContact(const State& state, const Contact& c, Mark& mark);
    void colourContacts(const State& state);
    void placeContacts(const State& state);
    void fillAll(const State& state, const std::vector<std::uint32_t>& contacts,
                 Blocks& blocks) const;
    void fill(const State& state, std::uint32_t contact, ContactBlock& block,
              std::size_t lane) const;
    Real couplingOf(const Contact& c, const Mark& mark) const;

    Tasks* tasks_ = nullptr;
    std::vector<Mover> movers_;  // the first one never moves
    std::vector<Owner> owners_;
    std::vector<std::uint64_t> taken_;  // colours, by mover
    std::vector<std::uint32_t> ofCluster_, ofParticle_;
    std::vector<Mark> marks_;
    Blocks two_, three_;
    std::vector<std::uint32_t> contactsOfTwo_, contactsOfThree_;  // by lanes of all blocks; or none
    std::vector<Colour> colours_;
    std::vector<std::uint32_t> single_;
};

}  // namespace sulfur::detail
