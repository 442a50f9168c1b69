/// \file
/// The whole library.
#pragma once

#include <sulfur/blueprint.hpp>
#include <sulfur/body.hpp>
#include <sulfur/callbacks.hpp>
#include <sulfur/draw.hpp>
#include <sulfur/error.hpp>
#include <sulfur/events.hpp>
#include <sulfur/fields.hpp>
#include <sulfur/grab.hpp>
#include <sulfur/ids.hpp>
#include <sulfur/info.hpp>
#include <sulfur/material.hpp>
#include <sulfur/math.hpp>
#include <sulfur/mechanisms.hpp>
#include <sulfur/presets.hpp>
#include <sulfur/queries.hpp>
#include <sulfur/shapes.hpp>
#include <sulfur/statistics.hpp>
#include <sulfur/thread_pool.hpp>
#include <sulfur/version.hpp>
#include <sulfur/world.hpp>
#include <sulfur/world_settings.hpp>
