#include <atlax/log.hpp>
