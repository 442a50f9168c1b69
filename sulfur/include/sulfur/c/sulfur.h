/// \file
/// The whole library for C, and for languages that call C; base.h says how all of it works.
#ifndef SULFUR_C_SULFUR_H
#define SULFUR_C_SULFUR_H

#include <sulfur/c/base.h>
#include <sulfur/c/blueprint.h>
#include <sulfur/c/bodies.h>
#include <sulfur/c/callbacks.h>
#include <sulfur/c/draw.h>
#include <sulfur/c/events.h>
#include <sulfur/c/fields.h>
#include <sulfur/c/mechanisms.h>
#include <sulfur/c/parts.h>
#include <sulfur/c/presets.h>
#include <sulfur/c/queries.h>
#include <sulfur/c/shapes.h>
#include <sulfur/c/world.h>

#endif
