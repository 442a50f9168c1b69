#include <atlax/canvas.hpp>
