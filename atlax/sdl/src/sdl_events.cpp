#include <atlax/application.hpp>
