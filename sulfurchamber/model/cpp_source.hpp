// A scene as C++ source.
#pragma once

#include <string>
#include <sulfur/scene.hpp>

namespace sulfurchamber {

/// The source of a program that builds a scene with libsulfur, lets it run, and prints where each
/// body is and the hash of its world: the same as that of the world which instantiate() makes of
/// the scene, for the same kind of Real. Its functions settings() and build() are of use in other
/// programs. Skins, and what a scene has for other programs, such as a level, are
/// left out. Recipes stay recipes.
std::string cppSource(const sulfur::scene::Scene& scene);

}  // namespace sulfurchamber
