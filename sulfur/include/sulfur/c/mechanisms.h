/// \file
/// Mechanisms: what turns, slides and pulls between two bodies; sulfur/mechanisms.hpp and
/// sulfur/world.hpp, which give the ranges.
#ifndef SULFUR_C_MECHANISMS_H
#define SULFUR_C_MECHANISMS_H

#include <sulfur/c/base.h>
#include <sulfur/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

// --- options ------------------------------------------------------------------------------------

/// What acts along the coordinate of a mechanism, in rad or m; sulfur::Drive.
typedef struct SulfurDrive {
    double lower;           ///< rad or m, the least value; -INFINITY is allowed
    double upper;           ///< rad or m, the largest one; INFINITY is allowed
    double stiffness;       ///< N m/rad or N/m of a spring towards `rest`; INFINITY is rigid
    double damping;         ///< N m s/rad or N s/m
    double rest;            ///< rad or m: where the spring is at rest
    double motor_speed;     ///< rad/s or m/s: what the motor wants
    double motor_max;       ///< N m or N: the most that it gives; 0: no motor
    bool has_motor_target;  ///< else the motor keeps its speed
    double motor_target;    ///< rad or m: where it goes, at most as fast as its speed, and stays
    double strength;        ///< N m or N at which the mechanism breaks; INFINITY: never
} SulfurDrive;
/// No limits, no spring, no motor, unbreakable.
SULFUR_API SulfurDrive sulfur_drive_default(void);

/// sulfur::HingeOptions.
typedef struct SulfurHingeOptions {
    SulfurDrive drive;  ///< radians
    bool collide;       ///< whether the two bodies touch each other
    bool pin;           ///< else only their angle is driven
    double strength;    ///< N, of the pin
    double value;       ///< rad: what the angle counts as when it is made
} SulfurHingeOptions;
/// A pin about which both turn freely.
SULFUR_API SulfurHingeOptions sulfur_hinge_options_default(void);

/// sulfur::WeldOptions.
typedef struct SulfurWeldOptions {
    double stiffness;        ///< N m/rad against bending; INFINITY is rigid
    double damping;          ///< N m s/rad
    bool collide;            ///< whether the two bodies touch each other
    double strength;         ///< N, of the pin
    double torque_strength;  ///< N m
    double value;            ///< rad: how far it counts as bent when it is made
} SulfurWeldOptions;
/// Rigid and unbreakable.
SULFUR_API SulfurWeldOptions sulfur_weld_options_default(void);

/// sulfur::SliderOptions.
typedef struct SulfurSliderOptions {
    SulfurDrive drive;  ///< metres along the axis or the rail
    bool collide;       ///< whether the two bodies touch each other
    bool turns;         ///< whether b turns freely; else it keeps its angle against a
    double value;       ///< m: what the place counts as when it is made, or the begin of a rail
} SulfurSliderOptions;
/// A line along which a body slides freely and turns.
SULFUR_API SulfurSliderOptions sulfur_slider_options_default(void);

/// sulfur::WheelOptions. SulfurWheelOptions, in shapes.h, is of a body that is a wheel.
typedef struct SulfurWheelMechanismOptions {
    SulfurDrive spring;  ///< metres along the axis; 0 is the place when it is made
    SulfurDrive motor;   ///< radians of the wheel against the body
    bool collide;        ///< whether the two bodies touch each other
} SulfurWheelMechanismOptions;
/// Neither a spring nor a motor.
SULFUR_API SulfurWheelMechanismOptions sulfur_wheel_mechanism_options_default(void);

/// sulfur::DistanceOptions.
typedef struct SulfurDistanceOptions {
    SulfurDrive drive;  ///< metres between both points
    bool collide;       ///< whether the two bodies touch each other
} SulfurDistanceOptions;
/// Any distance.
SULFUR_API SulfurDistanceOptions sulfur_distance_options_default(void);

/// sulfur::PulleyOptions.
typedef struct SulfurPulleyOptions {
    double ratio;     ///< how many times the far side counts, as with blocks
    bool has_length;  ///< else it is as it is when it is made
    double length;    ///< m, of both sides
    double strength;  ///< N
} SulfurPulleyOptions;
/// A rope of the ratio 1, tight when it is made.
SULFUR_API SulfurPulleyOptions sulfur_pulley_options_default(void);

// --- making -------------------------------------------------------------------------------------

/// Lets two bodies turn about a common point of the world; World::hinge.
SULFUR_API SulfurResult sulfur_world_hinge(SulfurWorld* world, SulfurBodyId a, SulfurBodyId b,
                                           SulfurVec at, const SulfurHingeOptions* options,
                                           SulfurMechanismId* mechanism);
/// The same with a drive that holds the angle; World::weld.
SULFUR_API SulfurResult sulfur_world_weld(SulfurWorld* world, SulfurBodyId a, SulfurBodyId b,
                                          SulfurVec at, const SulfurWeldOptions* options,
                                          SulfurMechanismId* mechanism);
/// Leads the point `at` of b along a line that moves with a; World::slider.
SULFUR_API SulfurResult sulfur_world_slider(SulfurWorld* world, SulfurBodyId a, SulfurBodyId b,
                                            SulfurVec at, SulfurVec axis,
                                            const SulfurSliderOptions* options,
                                            SulfurMechanismId* mechanism);
/// Leads the point `at` of b along `count` joints of a, in the order of a line; World::slider.
SULFUR_API SulfurResult sulfur_world_slider_on_rail(SulfurWorld* world, SulfurBodyId a,
                                                    SulfurBodyId b, SulfurVec at,
                                                    const SulfurJointId* rail, size_t count,
                                                    const SulfurSliderOptions* options,
                                                    SulfurMechanismId* mechanism);

/// The two mechanisms of a wheel; sulfur::WheelIds.
typedef struct SulfurWheelIds {
    SulfurMechanismId spring;  ///< the slider
    SulfurMechanismId motor;   ///< the hinge without a pin
} SulfurWheelIds;
/// Hangs a wheel on a body: a slider with a spring, and a motor that turns it; World::wheel.
SULFUR_API SulfurResult sulfur_world_wheel(SulfurWorld* world, SulfurBodyId body,
                                           SulfurBodyId wheel, SulfurVec at, SulfurVec axis,
                                           const SulfurWheelMechanismOptions* options,
                                           SulfurWheelIds* mechanisms);
/// Keeps the distance of two points in limits, or drives it; World::distance.
SULFUR_API SulfurResult sulfur_world_distance(SulfurWorld* world, SulfurBodyId a, SulfurVec at_a,
                                              SulfurBodyId b, SulfurVec at_b,
                                              const SulfurDistanceOptions* options,
                                              SulfurMechanismId* mechanism);
/// Hangs two bodies on the ends of one rope, which runs over two points of `frame`; World::pulley.
SULFUR_API SulfurResult sulfur_world_pulley(SulfurWorld* world, SulfurBodyId a, SulfurVec at_a,
                                            SulfurVec over_a, SulfurBodyId b, SulfurVec at_b,
                                            SulfurVec over_b, SulfurBodyId frame,
                                            const SulfurPulleyOptions* options,
                                            SulfurMechanismId* mechanism);
/// Keeps the value of `first` plus `ratio` times that of `second`; World::gear.
SULFUR_API SulfurResult sulfur_world_gear(SulfurWorld* world, SulfurMechanismId first,
                                          SulfurMechanismId second, double ratio,
                                          SulfurMechanismId* mechanism);

// --- looking and changing -----------------------------------------------------------------------

/// What a mechanism is; sulfur::MechanismKind, which says what its value is.
typedef int32_t SulfurMechanismKind;
/// Values of SulfurMechanismKind.
enum {
    SULFUR_HINGE = 0,     ///< sulfur_world_hinge()
    SULFUR_SLIDER = 1,    ///< sulfur_world_slider()
    SULFUR_DISTANCE = 2,  ///< sulfur_world_distance()
    SULFUR_PULLEY = 3,    ///< sulfur_world_pulley()
    SULFUR_GEAR = 4,      ///< sulfur_world_gear()
    SULFUR_WELD = 5       ///< sulfur_world_weld()
};

/// What a mechanism is at the moment; sulfur::MechanismInfo.
typedef struct SulfurMechanismInfo {
    SulfurMechanismKind kind;  ///< what it is
    SulfurBodyId a;            ///< one body
    SulfurBodyId b;            ///< the other body
    SulfurVec point_a;         ///< metres: where it takes hold of a
    SulfurVec point_b;         ///< metres: where it takes hold of b
    double value;              ///< rad or m; angles count whole turns
    double speed;              ///< rad/s or m/s
    double force;              ///< N m or N of its drive in the last tick
    SulfurVec holding;         ///< N on b in the last tick, of a pin or across a slider's line
    bool at_lower;             ///< whether the lower limit pushed in the last tick
    bool at_upper;             ///< the same of the upper one
    SulfurDrive drive;         ///< as it was set last
    double ratio;              ///< of a pulley or gear
    bool collide;              ///< whether it lets the two bodies touch each other
    bool vetoes;               ///< whether they touch again when it is gone
    bool pin;                  ///< of a hinge or weld: whether a pin holds both together
    double strength;           ///< N, of the pin
    bool turns;                ///< of a slider: whether b turns freely
    SulfurVec axis;            ///< of a slider: where its line points now, 1 long
    double rail_begin;         ///< m: what the begin of sulfur_mechanism_rail() counts as
    SulfurVec over_a;          ///< metres, of a pulley: where the rope of a turns
    SulfurVec over_b;          ///< metres, of a pulley: where that of b does
    SulfurBodyId frame;        ///< of a pulley
    SulfurMechanismId first;   ///< of a gear
    SulfurMechanismId second;  ///< of a gear
    SulfurAttachmentId pin_1;  ///< its own, which sulfur_world_attachments() lists too, or null
    SulfurAttachmentId pin_2;  ///< the same
    SulfurBodyId own_1;        ///< its own, of one particle, which is among the bodies, or null
    SulfurBodyId own_2;        ///< the same
} SulfurMechanismInfo;
/// What it is.
SULFUR_API SulfurResult sulfur_mechanism_info(const SulfurWorld* world, SulfurMechanismId mechanism,
                                              SulfurMechanismInfo* info);
/// What is left of the rail of a slider, in order; of other mechanisms nothing.
SULFUR_API SulfurResult sulfur_mechanism_rail(const SulfurWorld* world, SulfurMechanismId mechanism,
                                              SulfurJointId* out, size_t capacity, size_t* count);
/// Changes what acts along its coordinate; World::setDrive.
SULFUR_API SulfurResult sulfur_mechanism_set_drive(SulfurWorld* world, SulfurMechanismId mechanism,
                                                   const SulfurDrive* drive);
/// Lets both bodies go.
SULFUR_API SulfurResult sulfur_mechanism_remove(SulfurWorld* world, SulfurMechanismId mechanism);
/// Whether its handle is valid.
SULFUR_API SulfurResult sulfur_mechanism_exists(const SulfurWorld* world,
                                                SulfurMechanismId mechanism, bool* exists);
/// All of them, oldest first.
SULFUR_API SulfurResult sulfur_world_mechanisms(const SulfurWorld* world, SulfurMechanismId* out,
                                                size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

#endif
