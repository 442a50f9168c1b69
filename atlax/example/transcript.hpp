#pragma once

#include <atlax/event.hpp>
#include <string>

/// One line for an event, the same on every backend, such as "key W down" or "wheel 0 -1 at 20 30";
/// empty for what comes in any number: movements of the mouse and repeated keys.
std::string describe(const atlax::Event& event);
