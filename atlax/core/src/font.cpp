#include <atlax/font.hpp>
