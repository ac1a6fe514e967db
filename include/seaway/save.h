// SPDX-License-Identifier: MIT
#pragma once

#include "input.h"
#include "view.h"
#include "world.h"

/// @file
/// The whole state of a world as bytes: to save, to send to a player who joins late, to go back to. A world that is
/// made of them goes on with the same bits, on any machine, also in the middle of changes.

/// Write the world's state: its def, time and origin, wave systems with their handles and changes under way, inputs
/// with their names and points, bodies of water with their handles, views with their slices and foam. Of rasters,
/// meshes, hulls, splines and functions it holds hashes. The bytes are the same on every machine. Any thread that may
/// use a `const swWorld*`.
///
/// A change that was ordered since the last step (of waves, inputs, bodies of water) is in the bytes as it was ordered;
/// the sea before it is not, which would be a second state. So a world that is restored or taken back shows such a
/// change at once, and the world that was saved with its next step; from that step on both have the same bits.
/// @param data room for `*size` bytes; NULL to ask for the size
/// @param size in: bytes of room; out: bytes needed
/// @return SW_ERROR_LIMIT if there is too little room, or the world holds a number that no saved world can; nothing
/// useful is written then
SW_API swResult swWorld_Save(const swWorld* world, void* data, size_t* size);

/// What inputs use that a saved world does not hold.
typedef enum swResourceKind
{
    SW_RESOURCE_RASTER,
    SW_RESOURCE_HULL,
    SW_RESOURCE_MESH,
    SW_RESOURCE_SPLINE,
    SW_RESOURCE_FUNCTION,
    SW_RESOURCE_KIND_COUNT
} swResourceKind;

/// Where a host puts what was asked for: the member that the kind names.
typedef struct swResource
{
    const swRaster* raster;
    const swHull* hull;
    const swMesh* mesh;
    const swSpline* spline;
    swInputFunctionFcn function;
    void* functionContext;
} swResource;

/// Give what has a hash (of a raster, a hull, a mesh or a spline, see their infos) or a fingerprint (of a function).
/// `name` is the input's.
/// @return false if there is no such thing
typedef bool (*swFindResourceFcn)(void* context, swResourceKind kind, uint64_t hash, const char* name,
                                  swResource* resource);

/// Must be initialized with swDefaultRestoreDef().
typedef struct swRestoreDef
{
    /// As in swWorldDef; any gives the same bits. Default SW_ISA_BEST.
    swIsa isa;

    /// Most bytes that the world may come to hold, see swWorld_GetMemory(): few bytes from elsewhere may ask for much.
    /// What would go beyond is refused before it is taken. Range [1, SIZE_MAX]. Default 2^30.
    size_t memoryBudget;

    /// Asked for the rasters, hulls, meshes, splines and functions of inputs. Default NULL: there are none, and a world
    /// that uses one is refused with a sentence that names it.
    swFindResourceFcn findResource;
    void* resourceContext;

    /// Set by swDefaultRestoreDef().
    int internalValue;
} swRestoreDef;

SW_API swRestoreDef swDefaultRestoreDef(void);

/// Make a world of saved bytes. Wave systems have the handles that they had; views are found by swWorld_GetView().
/// Damaged bytes, those of another version, and those that ask for more memory than they may, are refused with a
/// sentence in the log; nothing is left behind.
/// @return SW_ERROR_FORMAT, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT (the budget), SW_ERROR_UNSUPPORTED (the instruction set,
/// or a resource that was not given)
SW_API swResult swRestoreWorld(const swHost* host, const void* data, size_t size, const swRestoreDef* def,
                               swWorld** world);

/// Take a world back to a state of its own that was saved, as a game in lockstep does when a player's input comes late.
/// It goes on with the same bits as before. Handles and views stay what they were then; a wave system that was made
/// since is gone. Allocates nothing, and costs a step.
///
/// The world must still have all waves of that state, and the same views: it goes back over weights, fades, jumps in
/// time, and over systems that were made; not over a step after a system was destroyed, given other waves or another
/// current, nor over the end of such a change. That is refused with a sentence in the log; make another world by
/// swRestoreWorld() then. A refusal changes nothing. Likewise of inputs: it goes back over
/// those that were made, moved or given other points, not over those that were destroyed or given another raster; of
/// bodies of water over levels and those that were made, not over those that were destroyed or set anew.
/// @return SW_ERROR_FORMAT, SW_ERROR_UNSUPPORTED if the world has other waves, views or another def
SW_API swResult swWorld_Rewind(swWorld* world, const void* data, size_t size);

/// Views in the order of their making, for a world that was restored.
SW_API int swWorld_GetViewCount(const swWorld* world);
SW_API swView* swWorld_GetView(swWorld* world, int index);
