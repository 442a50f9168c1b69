// Where the program's own files lie, and the user's.
#pragma once

#include "../model/library.hpp"
#include "../model/skins.hpp"

namespace sulfurchamber {

/// Templates of the program and of the user.
Library templateLibrary();
/// Pictures of the user, of the program's templates and scenes, and of the game.
SkinStore skinStore();

}  // namespace sulfurchamber
