#include <atlax/gamepad.hpp>
