#include <atlax/audio.hpp>
