// What to do where: a way with all that was learned beside it.
//
// A place is a situation in which something was tried. Of each of its choices it is known where it
// has led, with slips and without; the value of a place is the share of attempts that come from
// there to the next checkpoint or to the exit if the best choice is made everywhere (value
// iteration over sampled outcomes, the nearest known place standing for where an attempt went on;
// Sutton and Barto, Reinforcement Learning, 2nd edition, 2018, chapters 4 and 9). Checkpoints are
// goals because all lives begin anew there: what may go wrong behind them says little about the way
// to them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "player.hpp"
#include "search.hpp"
#include "situation.hpp"

namespace quaoar {

/// What a choice has once led to.
struct Try {
    Ending ending = Ending::done;
    Situation after;
    double seconds = 0;
    bool checkpoint = false;  ///< one more was reached on the way there
    int nearest = -1;         ///< place that is most like `after`
    double unlike = 1e9;      ///< and how much it is not
};

/// Carries an intention out where the player is; what it leads to is not yet compared with places.
Try tried(Session& session, Player& player, const Intention& intention, const Slip& slip = {});

struct PolicyChoice {
    Intention intention;
    std::vector<Try> tries;
    double value = 0;
};

struct Place {
    Situation here;
    std::shared_ptr<const Session::Snapshot> snapshot;  ///< null when read from a file
    std::vector<PolicyChoice> choices;
    double value = 0;
    int best = -1;  ///< index of the best choice
    int studies = 0;
};

/// How unlike two situations are: up to 1 what works in one will do in the other.
double unlikeness(const Situation& a, const Situation& b);

class Policy {
public:
    struct Match {
        int place = -1;
        double unlike = 1e9;
    };

    const std::vector<Place>& places() const { return places_; }
    Place& place(int index) { return places_[static_cast<std::size_t>(index)]; }
    /// The place whose choice promises most from a situation like this.
    Match match(const Situation& situation) const;
    int add(Place place);
    void addTry(int place, int choice, const Try& attempt);
    /// Adds the choice if it is new; its index.
    int addChoice(int place, const Intention& intention);
    /// Works out all values anew.
    void weigh();
    /// Keeps the places of the list alone, and the best choice of each.
    Policy reduced(const std::vector<bool>& keep) const;
    /// The attempt with the place that is most like what it led to.
    Try known(Try attempt) const;
    /// What an attempt is worth that has led so far.
    double worth(const Try& attempt) const;

private:
    std::vector<Place> places_;
};

}  // namespace quaoar
