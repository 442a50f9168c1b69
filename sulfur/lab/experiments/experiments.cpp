#include "experiments/experiment.hpp"

namespace sulfur::lab {

Experiments allExperiments() {
    Experiments all;
    for (const auto make : {makeTable2, makeTable3, makeTable4, makeAccuracy, makeStability,
                            makeBroadPhase, makeBench, makeScaling, makeSkip, makeMemory})
        all.push_back(make());
    return all;
}

}  // namespace sulfur::lab
