#include <atlax/backend.hpp>
