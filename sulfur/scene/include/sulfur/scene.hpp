/// \file
/// All of sulfur::scene.
#pragma once

#include <sulfur/scene/document.hpp>
#include <sulfur/scene/extra.hpp>
#include <sulfur/scene/file.hpp>
#include <sulfur/scene/instance.hpp>
#include <sulfur/scene/prefab.hpp>
#include <sulfur/scene/scene.hpp>
