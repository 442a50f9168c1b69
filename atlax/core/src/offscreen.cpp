#include <atlax/offscreen.hpp>
