#include <sulfur/shapes.hpp>
