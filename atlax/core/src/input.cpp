#include <atlax/input.hpp>
