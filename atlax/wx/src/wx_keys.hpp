// Keys and modifiers of wxWidgets in atlax's terms.
#pragma once

#include <wx/event.h>

#include <atlax/key.hpp>

namespace atlax::wx {

/// The key by its place on the keyboard; Key::Unknown when atlax has no name for it.
Key keyOf(const wxKeyEvent& event);

Modifiers modifiersOf(const wxKeyboardState& state);

}  // namespace atlax::wx
