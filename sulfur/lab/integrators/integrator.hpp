// One way to advance a system by one tick.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "integrators/system.hpp"

namespace sulfur::lab {

class Integrator {
public:
    virtual ~Integrator() = default;
    /// Called once before the first step of a run.
    virtual void begin(const System&, const State&, double /*h*/) {}
    /// Advances `state` by `h` seconds.
    virtual void step(const System& system, State& state, double h) = 0;
};

/// An integrator that can be chosen by name.
struct IntegratorEntry {
    std::string key;       ///< for command lines and tables of data
    std::string title;     ///< for people
    std::string paperRow;  ///< the row of the paper's tables that it belongs to, or ""
    std::string law;       ///< closed form of its limit on the paper's rope, or ""
    int order;             ///< of convergence on a problem without velocity-dependent forces
    bool bounded;          ///< whether linear theory gives it any limit
    std::function<std::unique_ptr<Integrator>()> make;
};

/// All of them, in the order of the tables.
const std::vector<IntegratorEntry>& integrators();

std::unique_ptr<Integrator> makeEuler();
std::unique_ptr<Integrator> makeSuvat();
/// Whether the stages of a Runge-Kutta method move all particles together, as the method says, or
/// each particle alone with its neighbours held where they are at the start of the tick.
enum class Stages { coupled, held };
std::unique_ptr<Integrator> makeMidpoint(Stages stages);
std::unique_ptr<Integrator> makeRungeKutta4(Stages stages);
std::unique_ptr<Integrator> makeNsv();
std::unique_ptr<Integrator> makeVerlet();
std::unique_ptr<Integrator> makeImplicitEuler();

}  // namespace sulfur::lab
