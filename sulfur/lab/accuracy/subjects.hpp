// The methods that the work-precision diagrams compare.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "accuracy/scene.hpp"

namespace sulfur::lab {

/// A scene under way in one method at one rate.
class Run {
public:
    virtual ~Run() = default;
    virtual void advance(long ticks) = 0;
    virtual Vec position(std::size_t particle) const = 0;
};

struct Subject {
    std::string key, title;
    bool ours = false;       ///< the library, not one of the laboratory's integrators
    std::vector<int> rates;  ///< Hz, rising
    std::function<std::unique_ptr<Run>(const AccuracyScene&, int rate)> start;
    std::function<bool(const AccuracyScene&)> plays = {};  ///< empty: every scene
    std::string colour = {};                               ///< in pictures; empty: by its key
};

/// World with 1, 4 and 16 sweeps at 60 Hz to 10 kHz, and every integrator of the laboratory up to
/// 200 kHz (where stiff springs that stand for rigid joints ask for it), and the other engines that
/// `bench` found, which play what is a chain of rigid links, a net of springs or a stack of
/// squares. `quick` leaves rates out.
std::vector<Subject> accuracySubjects(bool quick);

}  // namespace sulfur::lab
