// SPDX-License-Identifier: MIT
#pragma once

#include "measured.h"
#include "waves.h"

/// @file
/// A series of measured or computed spectra as a sea that changes all the time: between two records each wave keeps its
/// phase and its height runs from one to the other, the energy of each octave evenly. What the sea is at a time depends
/// on that time alone.

/// Must be initialized with swDefaultSeaReplayDef().
typedef struct swSeaReplayDef
{
    /// The records. Must outlive the replay. Default NULL.
    const swMeasuredSea* sea;

    /// Place whose records are played, see swMeasuredSea_GetLocation(). Range [0, INT32_MAX]. Default 0.
    int location;

    /// Everything but the table: seed, tiles, chop, weight, depth, what tables turn by. Its method must be
    /// SW_WAVES_FFT. Default swDefaultWaveSystemDef().
    swWaveSystemDef waves;

    /// The world's time at which the sea is that of `startSeconds`, s. Range [-SW_LARGEST_TIME, SW_LARGEST_TIME].
    /// Default 0.
    double startTime;

    /// Seconds since 1970, UTC. Range [-1e15, 1e15]. Default NAN: the first record's.
    double startSeconds;

    /// Seconds of records a second of the world. Range [-1e6, 1e6]. Default 1.
    double speed;

    /// A wave system that is there already, such as that of a replay in a world that was saved. Default null: a new
    /// one.
    swWaveSystemId system;

    /// Set by swDefaultSeaReplayDef().
    int internalValue;
} swSeaReplayDef;

SW_API swSeaReplayDef swDefaultSeaReplayDef(void);

/// A replay drives one wave system of one world.
typedef struct swSeaReplay swSeaReplay;

/// Make the wave system, or take over the one that is given, and set it to the world's present time.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT (systems or tiles)
SW_API swResult swCreateSeaReplay(swWorld* world, const swSeaReplayDef* def, swSeaReplay** replay);

/// Stop driving. The wave system stays as it is; destroy it by itself. NULL is allowed; the world must be there.
SW_API void swDestroySeaReplay(swSeaReplay* replay);

SW_API swWaveSystemId swSeaReplay_GetSystem(const swSeaReplay* replay);

/// Set the sea to what it is at a time of the world, past or future; call it before the step to that time. Before the
/// first record and after the last the sea is theirs; over a gap in the records it changes as slowly as the gap is
/// long. Costs nothing between two records; where a time passes into the next pair, a fresh initial spectrum (12 to 50
/// ms on one thread).
/// @return SW_ERROR_NO_MEMORY, SW_ERROR_INVALID if the wave system is gone or a record has no energy; the sea stays as
/// it was
SW_API swResult swSeaReplay_Advance(swSeaReplay* replay, double time);

/// The records of now: indices of the two around the time that was asked for last, and how far it is from the first to
/// the second.
SW_API void swSeaReplay_GetRecords(const swSeaReplay* replay, int* before, int* after, double* fraction);
