#include <atlax/files.hpp>
