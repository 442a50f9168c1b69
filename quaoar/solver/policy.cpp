#include "policy.hpp"

#include <algorithm>
#include <cmath>

namespace quaoar {
namespace {

/// A way that takes a second longer is worth so much less.
constexpr double patienceOfASecond = 0.995;
constexpr int sweeps = 60;
/// What it is worth to fall behind a new checkpoint, where all lives begin anew. Of three lives two
/// are left; if each gets on half of the time, three of four players get on.
constexpr double fallBehindCheckpoint = 0.75;

/// How much of a place's value is believed of a situation that differs from it.
double trust(double unlike) {
    const double beyond = std::max(0.0, unlike - 0.6);
    return std::exp(-0.5 * beyond * beyond) * (beyond > 0 ? 0.97 : 1);
}

}  // namespace

Try tried(Session& session, Player& player, const Intention& intention, const Slip& slip) {
    const double began = player.seconds();
    const int reached = checkpointsReached(session);
    const Ending ending = player.carryOut(intention, slip);
    return {ending, situationOf(session), player.seconds() - began,
            checkpointsReached(session) > reached};
}

double unlikeness(const Situation& a, const Situation& b) {
    if (a.tied != b.tied) return 6 + (a.place - b.place).norm();
    // Who is at rest somewhere has time to go to the same spot in his mind.
    const double speed = std::max(a.velocity.norm(), b.velocity.norm());
    const double apart = (a.place - b.place).norm() / (0.25 + 0.02 * speed);
    const double differently = (a.velocity - b.velocity).norm() / (0.8 + 0.1 * speed);
    double sum = apart * apart + differently * differently;
    if (a.signals != b.signals) sum += 4;
    if (a.tied) {
        const double anchors = (a.anchor - b.anchor).norm() / 0.4;
        const double lengths = (a.length - b.length) / 0.3;
        sum += anchors * anchors + lengths * lengths;
    }
    return std::sqrt(sum);
}

Policy::Match Policy::match(const Situation& situation) const {
    Match best;
    double most = -1;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (places_[i].best < 0) continue;
        const double unlike = unlikeness(places_[i].here, situation);
        const double promise = trust(unlike) * (0.02 + places_[i].value) + 1e-6 / (1 + unlike);
        if (promise <= most) continue;
        most = promise;
        best = {static_cast<int>(i), unlike};
    }
    return best;
}

int Policy::add(Place place) {
    places_.push_back(std::move(place));
    const int index = static_cast<int>(places_.size()) - 1;
    for (Place& other : places_) {
        for (PolicyChoice& choice : other.choices) {
            for (Try& attempt : choice.tries) {
                const double unlike = unlikeness(places_.back().here, attempt.after);
                if (unlike >= attempt.unlike) continue;
                attempt.nearest = index;
                attempt.unlike = unlike;
            }
        }
    }
    return index;
}

Try Policy::known(Try attempt) const {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const double unlike = unlikeness(places_[i].here, attempt.after);
        if (unlike >= attempt.unlike) continue;
        attempt.nearest = static_cast<int>(i);
        attempt.unlike = unlike;
    }
    return attempt;
}

void Policy::addTry(int index, int choice, const Try& attempt) {
    place(index).choices[static_cast<std::size_t>(choice)].tries.push_back(known(attempt));
}

int Policy::addChoice(int index, const Intention& intention) {
    std::vector<PolicyChoice>& choices = place(index).choices;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (choices[i].intention == intention) return static_cast<int>(i);
    }
    choices.push_back({intention, {}, 0});
    return static_cast<int>(choices.size()) - 1;
}

double Policy::worth(const Try& attempt) const {
    const double later = std::pow(patienceOfASecond, attempt.seconds);
    if (attempt.ending == Ending::finished) return later;
    double after = 0;
    if (attempt.ending != Ending::died && attempt.nearest >= 0) {
        after = trust(attempt.unlike) * places_[static_cast<std::size_t>(attempt.nearest)].value;
    }
    if (attempt.checkpoint) after = fallBehindCheckpoint + (1 - fallBehindCheckpoint) * after;
    return later * after;
}

void Policy::weigh() {
    for (Place& place : places_) place.value = 0;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double changed = 0;
        for (auto place = places_.rbegin(); place != places_.rend(); ++place) {
            double best = 0;
            for (std::size_t i = 0; i < place->choices.size(); ++i) {
                PolicyChoice& choice = place->choices[i];
                double sum = 0;
                for (const Try& attempt : choice.tries) sum += worth(attempt);
                // What a file says is believed until it has been tried.
                if (choice.tries.empty()) sum = choice.value;
                choice.value = sum / std::max(1.0, static_cast<double>(choice.tries.size()));
                if (choice.value <= best) continue;
                best = choice.value;
                place->best = static_cast<int>(i);
            }
            changed = std::max(changed, std::abs(best - place->value));
            place->value = best;
        }
        if (changed < 1e-4) break;
    }
}

Policy Policy::reduced(const std::vector<bool>& keep) const {
    Policy policy;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (!keep[i] || places_[i].best < 0) continue;
        Place place;
        place.here = places_[i].here;
        place.value = places_[i].value;
        const PolicyChoice& best = places_[i].choices[static_cast<std::size_t>(places_[i].best)];
        place.choices.push_back({best.intention, {}, best.value});
        place.best = 0;
        policy.places_.push_back(std::move(place));
    }
    return policy;
}

}  // namespace quaoar
