// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"

/// @file
/// Where a world's time comes from: the host's frames, paused, scaled, in fixed steps, scrubbed on a timeline, or
/// following a server. A plain value: copy it, save it, have several. Feed each frame's time to swClock_Advance() and
/// step the world to what it returns with swWorld_StepTo(). Everything in a world hangs on its time, so a paused clock
/// pauses everything.

/// Must be initialized with swDefaultClock().
typedef struct swClock
{
    /// Time of the world now, s. Set it to jump. Default 0.
    double time;

    /// World seconds a host second. Range [-1000, 1000]; negative runs backwards. Default 1.
    double scale;

    /// Default false.
    bool isPaused;

    /// Length of fixed steps, s: time advances by whole steps of this and keeps the rest, so that every machine steps
    /// through the same times. Range [0, 1]. Default 0: by whatever the frames bring.
    double fixedStep;

    /// Most fixed steps that one advance takes; a longer halt is forgotten, not caught up with. Range [1, 1000].
    /// Default 8.
    int maxSteps;

    /// How fast time may run to meet a server's, beyond its own pace, as a part of it. Range [0, 0.9]. Default 0.05.
    double slewRate;

    /// A difference from a server's time beyond this is jumped, s. Range (0, inf]. Default 1.
    double jumpThreshold;

    /// What has not made a whole fixed step yet, s.
    double rest;

    /// What is still to be slewed, s: positive to catch up. Set by swClock_Follow().
    double behind;

    /// Set by swDefaultClock().
    int internalValue;
} swClock;

SW_API swClock swDefaultClock(void);

/// Take in `hostDt` seconds of the host's time (range [0, 3600]) and return the time to step the world to. With fixed
/// steps that may be the time of before: then no step is needed, and `rest` / `fixedStep` is how far the next one has
/// come.
SW_API double swClock_Advance(swClock* clock, double hostDt);

/// One fixed step on, also while paused; without fixed steps a sixtieth of a second. For stepping frame by frame.
SW_API double swClock_StepOnce(swClock* clock);

/// A server says that its time is now `serverTime`, as well as the host can tell with half the way there and back
/// added. The clock slews towards it at slewRate and never runs backwards while it does, or jumps beyond jumpThreshold.
/// A paused clock jumps: it stands where the server stands.
SW_API void swClock_Follow(swClock* clock, double serverTime);
