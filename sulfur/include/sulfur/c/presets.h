/// \file
/// The constants of the paper; sulfur/presets.hpp.
#ifndef SULFUR_C_PRESETS_H
#define SULFUR_C_PRESETS_H

#include <sulfur/c/shapes.h>
#include <sulfur/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A world with the paper's tick rate and the air friction of its rope.
SULFUR_API SulfurWorldSettings sulfur_preset_world(void);
/// The paper's rope, of 40 particles; `stiffness` in N/m.
SULFUR_API SulfurRopeOptions sulfur_preset_rope(double stiffness);
/// The paper's box of Table 4; `size` in metres, `mass` in kilograms.
SULFUR_API SulfurBoxOptions sulfur_preset_plain_box(SulfurVec size, double mass);

#ifdef __cplusplus
}
#endif

#endif
