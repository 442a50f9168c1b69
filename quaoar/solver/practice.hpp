// How a policy is learned: by trying each step of a way with slips, and by playing and studying
// where that went wrong.
#pragma once

#include "bot.hpp"
#include "policy.hpp"

namespace quaoar {

struct PracticeOptions {
    Skill skill;
    std::uint64_t seed = 1;
    int games = 16;    ///< a round
    int studies = 16;  ///< most places looked at in a round
    int jobs = 1;
};

/// Adds the steps of a way and what they have led to when nothing slipped.
void learnWay(Policy& policy, Session& session, const Way& way);

class Practice {
public:
    Practice(const Ground& ground, Policy& policy, const PracticeOptions& options)
        : ground_(ground), policy_(policy), options_(options) {}

    /// Studies all places that have a snapshot.
    void studyAll();
    /// One round of games and of studies of what went wrong in them.
    Survival round();
    double simulated() const { return simulated_; }

private:
    /// A place that wants to be studied, and what has been learned there.
    struct Lesson {
        int place = -1;  ///< -1: a new one
        Situation here;
        std::shared_ptr<const Session::Snapshot> snapshot;
        std::vector<PolicyChoice> choices;
        std::vector<Place> wayOn;  ///< places of a way that was searched for
        double simulated = 0;
    };

    std::vector<Lesson> lessonsOf(const std::vector<PlayedGame>& games) const;
    void wish(std::vector<Lesson>& lessons, const Decision& decision, bool wentWrong) const;
    void learn(std::vector<Lesson>& lessons);
    void study(Lesson& lesson, Session& session, std::uint64_t seed) const;
    std::vector<Intention> ideasFor(const Lesson& lesson, Session& session,
                                    std::mt19937_64& random) const;
    PolicyChoice plainly(Lesson& lesson, Session& session, const Intention& idea) const;
    Try attempt(Lesson& lesson, Session& session, const Intention& idea, const Slip& slip) const;
    bool provesGood(Lesson& lesson, Session& session, Nerves& nerves) const;
    void keepBest(Lesson& lesson, std::size_t count) const;
    void tryAll(Lesson& lesson, Session& session, Nerves& nerves, int count) const;
    double promise(const PolicyChoice& choice) const;
    void searchOn(Lesson& lesson, Session& session, std::uint64_t seed) const;

    const Ground& ground_;
    Policy& policy_;
    PracticeOptions options_;
    double simulated_ = 0;
    std::uint64_t round_ = 0;
};

}  // namespace quaoar
