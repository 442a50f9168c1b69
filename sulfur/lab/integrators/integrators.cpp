#include "integrators/integrator.hpp"

namespace sulfur::lab {

const std::vector<IntegratorEntry>& integrators() {
    static const std::vector<IntegratorEntry> all{
        {"euler", "explicit Euler", "Euler", "b/h", 1, true, makeEuler},
        {"suvat", "SUVAT", "SUVAT/RK2", "2b/h", 1, true, makeSuvat},
        {"rk2", "RK2 midpoint", "SUVAT/RK2", "", 2, true,
         [] { return makeMidpoint(Stages::coupled); }},
        {"rk2-held", "RK2, neighbours held", "SUVAT/RK2", "", 2, true,
         [] { return makeMidpoint(Stages::held); }},
        {"rk4", "RK4", "RK4", "", 4, true, [] { return makeRungeKutta4(Stages::coupled); }},
        {"rk4-held", "RK4, neighbours held", "RK4", "", 4, true,
         [] { return makeRungeKutta4(Stages::held); }},
        {"nsv", "NSV", "NSV/IE", "m/h^2 - 2b/h", 1, true, makeNsv},
        {"verlet", "position Verlet", "", "m/h^2 - 2b/h", 2, true, makeVerlet},
        {"implicit", "implicit Euler", "NSV/IE", "", 1, false, makeImplicitEuler},
    };
    return all;
}

}  // namespace sulfur::lab
