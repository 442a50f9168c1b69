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
    /// m, where the scene's particles, squares or bodies are, in its order.
    virtual Vecs places() const = 0;
    /// The largest strain of a rigid joint, or opening of a pin in metres, now.
    virtual double strain(const AccuracyScene& scene) const {
        return scene.largestStrain(places());
    }
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
/// 200 kHz (where stiff springs that stand for rigid joints ask for it), XPBD with 1, 10 and 100
/// sweeps up to that rate, which plays what is held by rigid joints or pins alone, and the other
/// engines that `bench` found, which play what is a chain of rigid links, a net of springs or of
/// rigid links, a stack of squares or a grid of pinned ones. `quick` leaves rates out.
std::vector<Subject> accuracySubjects(bool quick);

}  // namespace sulfur::lab
