#include <atlax/timestep.hpp>
