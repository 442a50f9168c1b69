#pragma once

#include <SDL.h>

#include <atlax/event.hpp>
#include <optional>

namespace atlax::sdl {

Key toKey(SDL_Scancode code);

/// What SDL's event means to an application; nothing for those that are of no interest or that need
/// the window (resizing). `scale` is pixels of the drawable area per unit of the window. Frees what
/// the event owns.
std::optional<Event> translate(const SDL_Event& event, float scale);

}  // namespace atlax::sdl
