// SPDX-License-Identifier: MIT
#pragma once

#include "world.h"

/// @file
/// The water at one time, which is what queries ask (query.h). A world has a moment of its own, the water of its last
/// step. A host makes others: of any time, past or future, in memory of their own, so that any thread may ask them
/// while the world steps on, and another process that maps their memory. docs/queries.md says what they cost.

typedef struct swMoment swMoment;

/// The water of the world's last step. The pointer stays the same for the world's life; what it shows changes with each
/// step, so while one thread steps, sets or destroys, no other may ask it.
SW_API const swMoment* swWorld_GetMoment(const swWorld* world);

/// Must be initialized with swDefaultMomentDef().
typedef struct swMomentDef
{
    /// Time of the water, s, past or future. Range [-2.7e11, 2.7e11]. Default 0.
    double time;

    /// Where the water is to lie, 64-byte aligned, such as memory that processes share; it must outlive the moment.
    /// Default NULL: the moment gets memory from the world's host, and more of it when the world has grown.
    void* memory;

    /// Bytes at `memory`, at least swWorld_GetMomentSize(). Default 0.
    size_t memorySize;

    /// Set by swDefaultMomentDef().
    int internalValue;
} swMomentDef;

SW_API swMomentDef swDefaultMomentDef(void);

/// Bytes that the water of the world takes at whatever time, with the wave systems that it has and the changes that are
/// under way: 4.4 MB of a default sea, 3.8 MB more each for velocities and for accelerations.
SW_API size_t swWorld_GetMomentSize(const swWorld* world);

/// Make a moment of a world. It is, to the bit, what the world would have after swWorld_StepTo() to that time, and
/// keeps nothing of the world, which may step on or be destroyed. Changes that are under way are as far as they are at
/// that time. What the world cannot know of another time: changes that were or will be made at once, the records of a
/// replay beyond the present pair (see swMoment_IsHeld()), and foam, which has a past and is of views.
/// Places are from the world's origin as it was when the moment was made.
/// Costs a step's transforms, on the calling thread: half a millisecond to one for a default sea. Several threads may
/// make moments of a `const swWorld*` at once.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT if the def's memory is too small
SW_API swResult swCreateMoment(const swWorld* world, const swMomentDef* def, swMoment** moment);

/// Make it the water of another time, or of another world. Allocates nothing if the water fits into the memory that it
/// has. Nobody may ask it meanwhile.
/// @return as swCreateMoment(); the moment then stays as it was
SW_API swResult swMoment_Set(swMoment* moment, const swWorld* world, double time);

/// NULL is allowed.
SW_API void swDestroyMoment(swMoment* moment);

/// The memory of a moment: one block with offsets and no addresses, which may be copied, written to a file or mapped by
/// another process. `size` gets the bytes of it that count. NULL of the moment that a world has of its own.
SW_API const void* swMoment_GetMemory(const swMoment* moment, size_t* size);

/// A moment of memory that was made by another, in this process or another one of the same build and kind of machine.
/// The memory is 64-byte aligned, is read, never written, must outlive the moment and stay as it is. A head that is
/// damaged, or leads beyond `size`, is refused. A moment in shared memory that its maker sets anew must be mapped anew.
/// @return SW_ERROR_FORMAT, SW_ERROR_NO_MEMORY
SW_API swResult swMapMoment(const swHost* host, const void* memory, size_t size, swMoment** moment);

/// Time of the water, s.
SW_API double swMoment_GetTime(const swMoment* moment);

/// Whether a replay's records that count at the moment's time were not the world's present pair: the sea is then that
/// of the nearer record of the pair. Advance the replay to that time (swSeaReplay_Advance()) and make the moment again.
/// Also true of a sea that stands still between two records, its replay being stopped or not taken up again.
SW_API bool swMoment_IsHeld(const swMoment* moment);
