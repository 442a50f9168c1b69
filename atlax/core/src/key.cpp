#include <atlax/key.hpp>
