#include <atlax/image.hpp>
