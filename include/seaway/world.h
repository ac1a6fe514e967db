// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "id.h"
#include "math.h"
#include "wind.h"

/// @file
/// A world: wave systems and simulations on one clock. Any number of threads may use a `const swWorld*`; a function
/// that takes `swWorld*` wants the world to itself.

/// Instruction sets of the wide kernels. All give the same bits.
typedef enum swIsa
{
    SW_ISA_BEST,
    SW_ISA_SCALAR,
    SW_ISA_SSE2,
    SW_ISA_AVX2,
    SW_ISA_NEON,
    SW_ISA_AVX512,
    SW_ISA_COUNT
} swIsa;

/// Foam is born where waves fold over and fades with time.
/// Must be initialized with swDefaultFoamDef().
typedef struct swFoamDef
{
    /// Foam fades as exp(-fadeRate t), per second. Range [0.01, 10]. Default 0.25.
    float fadeRate;

    /// Factor on the whitecap cover that the waves' wind gives, for an artist. Range [0, 100]. Default 1.
    float coverage;

    /// Wind at 10 m for the cover, m/s. Range [0, 100]. Default 0: the mean of the world's wind (see wind.h), or where
    /// it names none the wind that a spectrum knows (see swSpectrumDef::hasWind), or else the one that the waves
    /// themselves tell of, by the level of the equilibrium range above their peak [Phillips 1985]. Give a wind where it
    /// was measured, or where waves and weather disagree.
    float windSpeed;

    /// Waves shorter than this make no foam, m: foam then follows long crests. The finest slices know waves of 8 texels
    /// and more; a filter beyond that takes the folds of a coarser slice. Range [0, 1024]. Default 0: every wave
    /// counts.
    float minWavelength;

    /// Folding (determinant of the Jacobian) below which foam is born even without wind: 1 is flat water, 0 a surface
    /// that passes through itself. The waves' own threshold is used where it is higher. Range [-4, 1]. Default 0; -4 is
    /// never.
    float threshold;

    /// How far foam reaches from the water's edge, m, whatever the slope of the floor is there: by the depth over its
    /// gradient. Range [0, 1000]. Default 3; 0: shores make none.
    float shoreWidth;

    /// Foam that shores make at the water's edge, per second. Range [0, 100]. Default 0.6.
    float shoreRate;

    /// How fast the foam of shores fades, as fadeRate. Range [0.01, 10]. Default 0.3.
    float shoreFadeRate;

    /// How fast the foam of inputs (see SW_INPUT_FOAM) and of wakes fades, as fadeRate. Range [0.01, 10]. Default 0.1.
    float wakeFadeRate;

    /// Set by swDefaultFoamDef().
    int internalValue;
} swFoamDef;

/// Foam whose mean in the steady state is the whitecap cover at the waves' wind, the geometric mean of two laws
/// [Callaghan 2008] [Monahan and O'Muircheartaigh 1980], whatever the spectrum: none up to 3.7 m/s, 0.9 % at 10 m/s, 7
/// % at 20 m/s, 34 % at 35 m/s. Swell makes none. Waves without chop fold nowhere and make none.
SW_API swFoamDef swDefaultFoamDef(void);

/// Must be initialized with swDefaultWorldDef().
typedef struct swWorldDef
{
    /// m/s^2. Range (0, 100]. Default 9.81.
    float gravity;

    /// Surface tension over density, m^3/s^2, which makes ripples faster: a wave of 6 cm by 4 %. Range [0, 1e-3].
    /// Default 7.4e-5, clean water; 0 for none.
    float surfaceTension;

    /// Height of the resting water plane, m. Range [-1e6, 1e6]. Default 0.
    double seaLevel;

    /// Default true. False skips the surface on the CPU, for a host that only draws: queries then answer sea level.
    bool enableQueries;

    /// Keep velocities and accelerations of the surface beside its displacement, so that queries of them are as fast as
    /// those of heights. Each costs as much time in a step, and memory, as the displacement. Without them the same
    /// queries sum up waves one by one, some hundred times slower. Default false.
    bool enableVelocity;
    bool enableAcceleration;

    swFoamDef foam;

    /// See wind.h.
    swWindDef wind;

    /// Default SW_ISA_BEST: the widest that this machine has.
    swIsa isa;

    /// Set by swDefaultWorldDef().
    int internalValue;
} swWorldDef;

SW_API swWorldDef swDefaultWorldDef(void);

/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_UNSUPPORTED if this machine lacks the asked instruction set
SW_API swResult swCreateWorld(const swHost* host, const swWorldDef* def, swWorld** world);

/// Destroys everything in the world. NULL is allowed. Views and GPU worlds made from it go first.
SW_API void swDestroyWorld(swWorld* world);

/// Advance by dt seconds (0 is allowed and makes the surface of the present time). Range [0, 3600], and not to a time
/// beyond SW_LARGEST_TIME.
/// A warm step allocates nothing and takes no lock.
/// @return SW_ERROR_INVALID if dt is out of range, SW_ERROR_NO_MEMORY only on the first step after something was
/// created
SW_API swResult swWorld_Step(swWorld* world, double dt);

/// Jump to a time, s, past or future, within SW_LARGEST_TIME of 0; the surface follows with the next step. Waves are a
/// function of time alone. Foam has a past: when a step comes out earlier than the last one, or more than a second
/// later, it starts anew from the state that the present waves would sustain. For a still picture with trails, step
/// through some seconds before it.
SW_API void swWorld_SetTime(swWorld* world, double time);

/// Time of the last step's surface, s.
SW_API double swWorld_GetTime(const swWorld* world);

/// Step to a time, s, exactly: machines whose frames have other lengths have the same bits there. Going back, or more
/// than an hour on, is a jump as by swWorld_SetTime(). See clock.h for where the time may come from.
/// @return as swWorld_Step()
SW_API swResult swWorld_StepTo(swWorld* world, double time);

/// Where in the sea the host's coordinates begin, m. All places that the host gives or gets (queries, viewpoints,
/// cameras) are relative to it. A host that moves its coordinates along with the player, so that floats stay small,
/// moves this by as much: the sea stays where it is, to the bit where the sums of doubles are exact and to 1e-9 m
/// within 1,000 km elsewhere. Takes effect at once; viewpoints keep their place in the sea. Range [-1e9, 1e9]. Default
/// 0.
SW_API void swWorld_SetOrigin(swWorld* world, swPosXZ origin);
SW_API swPosXZ swWorld_GetOrigin(const swWorld* world);

/// What makes foam, as the last step found it.
typedef struct swFoamState
{
    float windSpeed; ///< m/s at 10 m, at most 100: the def's, the world's mean, the strongest that a spectrum knows, or
                     ///< what waves tell of
    float cover;     ///< mean foam of the steady state
    float threshold; ///< folding (determinant of the Jacobian) below which foam is born
} swFoamState;

SW_API swFoamState swWorld_GetFoamState(const swWorld* world);

/// Change how foam is born and fades, from the next step on. Foam that is there stays.
SW_API void swWorld_SetFoam(swWorld* world, const swFoamDef* foam);

SW_API double swWorld_GetSeaLevel(const swWorld* world);
SW_API float swWorld_GetGravity(const swWorld* world);

/// The instruction set in use.
SW_API swIsa swWorld_GetIsa(const swWorld* world);
SW_API const char* swIsa_GetName(swIsa isa);

/// 64 bits that are equal on two machines if their seas are and will be: a hash over all that decides the sea (def,
/// times, systems with their waves, changes that were ordered, begun or not) and the bits of the surface as the last
/// step left it. For machines whose worlds have the same enableQueries. Where the origin lies, views and their foam
/// have no part in it. A world that was just restored has the digest of the one that was saved; where changes were
/// ordered since its last step, for sure from the next step on (see swWorld_Save()). As costly as a third of a step.
SW_API uint64_t swWorld_GetDigest(const swWorld* world);

/// Bytes that the world holds.
SW_API size_t swWorld_GetMemory(const swWorld* world);
