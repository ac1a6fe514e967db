// SPDX-License-Identifier: MIT
#pragma once

#include "field.h"
#include "hull.h"
#include "id.h"
#include "math.h"
#include "moment.h"
#include "raster.h"
#include "tide.h"

/// @file
/// Inputs: all that a host puts into the sea. An input is a shape (where), a field (what it says), and a blend (how it
/// joins what is below it). The inputs of a world are functions of place and time: a query, a slice and a pixel read
/// the same numbers, however far any camera is. An input that is made, moved or changed counts from the next step on.
/// docs/inputs.md says which shape makes sense for which field, and what it costs.
///
///     swInputDef shoal = swDefaultInputDef();
///     shoal.field = SW_INPUT_FLOOR;
///     shoal.shape = SW_SHAPE_CIRCLE;
///     shoal.size = (swVec3){400.0f, 0.0f, 400.0f};
///     shoal.feather = 150.0f;
///     shoal.value[0] = -3.0f;
///     swInputId id;
///     swCreateInput(world, &shoal, &id);

typedef struct swMesh swMesh;
typedef struct swSpline swSpline;

/// Inputs that a world can have, and points of one input.
#define SW_MAX_INPUTS 16384
#define SW_MAX_INPUT_POINTS 65536

/// Room for an input's name.
#define SW_MAX_INPUT_NAME 64

/// Fastest flow and wind that an input may give along each of its axes, m/s: what its shape brings times `gain`, plus
/// `value`, times a weight above 1.
#define SW_MAX_INPUT_SPEED 100.0f

/// What an input says. Each field has a value below all inputs, which stands where no input touches the water.
typedef enum swInputField
{
    SW_INPUT_FLOOR,        ///< height of the sea floor, m, absolute as positions are. Below: none, the water is deep
    SW_INPUT_LEVEL,        ///< height of still water above the world's sea level, m. Below: 0
    SW_INPUT_FLOW,         ///< velocity of the water along x and z, m/s, see docs/flow.md. Below: 0, 0
    SW_INPUT_WAVES,        ///< weight of the waves of one system, see swInputDef::system. Below: 1; 0 of a local system
    SW_INPUT_DISPLACEMENT, ///< added to where the water rests, along x, y, z, m. Below: 0, 0, 0
    SW_INPUT_CLIP,         ///< above 0.5 there is no water, else there is. Below: 0. See docs/clip.md
    SW_INPUT_FOAM,         ///< foam that is made, per second. Below: 0
    SW_INPUT_ALBEDO,       ///< colour on the water: red, green, blue (linear) and how much it covers. Below: 0, 0, 0, 0
    SW_INPUT_WIND,         ///< velocity of the wind 10 m above the water along x and z, m/s. Below: the world's
    SW_INPUT_SHADOW,       ///< light that is there, 0 dark to 1 light. Below: 1
    SW_INPUT_BODY,         ///< number of the body of water. Below: -1, none
    SW_INPUT_FIELD_COUNT
} swInputField;

/// Where an input is. Shapes lie in axes of their own: see swInputDef::position and rotation.
typedef enum swInputShape
{
    SW_SHAPE_EVERYWHERE, ///< the whole sea
    SW_SHAPE_CIRCLE,     ///< of the diameter size.x
    SW_SHAPE_RECTANGLE,  ///< size.x by size.z
    SW_SHAPE_POLYGON,    ///< inside of its points, which follow each other around it and do not cross
    SW_SHAPE_POLYLINE,   ///< along its points
    SW_SHAPE_SPLINE,     ///< along a spline
    SW_SHAPE_MESH,       ///< a mesh as seen from above
    SW_SHAPE_RASTER,     ///< numbers on a lattice
    SW_SHAPE_PARTICLES,  ///< a disc about each of its points
    SW_SHAPE_FUNCTION,   ///< whatever a function of the host's says
    SW_SHAPE_BOX,        ///< the last five have a height, too, and are for SW_INPUT_CLIP: size.x by size.y by size.z
    SW_SHAPE_ELLIPSOID,
    SW_SHAPE_CYLINDER,
    SW_SHAPE_CAPSULE, ///< upright, as wide as size.x and as long as size.y with its round ends
    SW_SHAPE_HULL,    ///< the inside of a closed mesh
    SW_SHAPE_COUNT
} swInputShape;

/// How an input joins what is below it. `share` is how much of the input counts at a place: its cover there, from 0 to
/// 1 within the feather, times its weight.
typedef enum swInputBlend
{
    SW_BLEND_ADD,      ///< below + share * value
    SW_BLEND_ALPHA,    ///< a mix of below and value by share
    SW_BLEND_MULTIPLY, ///< below times a mix of 1 and value by share
    SW_BLEND_MIN,      ///< a mix of below and the lesser of both
    SW_BLEND_MAX,      ///< a mix of below and the greater of both
    SW_BLEND_REPLACE,  ///< value wherever share is above 0, without a mix: a hard edge
    SW_BLEND_COUNT
} swInputBlend;

/// A point of a polygon, a polyline or particles, in the input's own axes.
typedef struct swInputPoint
{
    float x, z;     ///< m. Range [-1e6, 1e6]
    float radius;   ///< of a particle, or half the width of a polyline, m; 0: half of swInputDef::size.x
    float weight;   ///< factor on the share; of polygons not looked at. Range [0, 100]
    float value[4]; ///< added to swInputDef::value; of polygons not looked at
} swInputPoint;

/// What a function of the host's says about a point.
typedef struct swInputAnswer
{
    float value[4];                 ///< as many as the field has. Range [-1e6, 1e6]; see SW_MAX_INPUT_SPEED
    float valueAlongX[4];           ///< their derivatives by x and z, per metre
    float valueAlongZ[4];           ///< likewise
    float share;                    ///< how much of it counts. Range [0, 1]
    float shareAlongX, shareAlongZ; ///< its derivatives, per metre
} swInputAnswer;

/// Answer for points in the input's own axes (m from its position). Called on any thread, by many at once, for up to 16
/// points; the answers depend on nothing but the context, the time and the point. `answers` come cleared. One that is
/// out of range, or no number, covers nothing.
typedef void (*swInputFunctionFcn)(void* context, double time, int count, const swPosXZ* points,
                                   swInputAnswer* answers);

/// How a wave system that is made for one wind counts where the wind is another. The raster of the input then has two
/// channels, the wind along x and z in m/s, and the system's weight follows from that: a place mixes the systems of the
/// two nearest headings and of the two nearest speeds, by weights whose squares add up to the energy that is asked for.
/// swCreateWindSea() makes such systems and inputs; by hand it is a part of swInputDef.
typedef struct swWindWeight
{
    /// Default false: the raster has weights.
    bool isUsed;

    /// Where the system's wind blows to, radians from +x towards +z. Range [-1000, 1000]. Default 0.
    float heading;

    /// From this heading to those of the systems on either side, radians. Range [0.01, 1.5707964]. Default 0.5235988.
    float headingStep;

    /// Wind of the system, m/s. Range [0.1, 100]. Default 10.
    float speed;

    /// Winds of the systems of the same heading with the next weaker and the next stronger wind, m/s; 0 where there is
    /// none. Range [0, 100]. Default 0.
    float speedBelow, speedAbove;

    /// Deviation of the heights of those systems, over that of this one. Where there is none: how heights go on there,
    /// as (s / speed) (1 + b (s / speed - 1)) under a wind s: 0 grows with the wind, 1 with its square. Range
    /// [0, 1000]. Default 1.
    float heightBelow, heightAbove;
} swWindWeight;

/// Must be initialized with swDefaultInputDef().
typedef struct swInputDef
{
    /// For messages and editors. Default "".
    char name[SW_MAX_INPUT_NAME];

    /// Default SW_INPUT_FLOOR.
    swInputField field;

    /// Default SW_SHAPE_EVERYWHERE.
    swInputShape shape;

    /// Default SW_BLEND_ALPHA.
    swInputBlend blend;

    /// Inputs of a field join in ascending order; equal ones as they were made. Range [-1000000, 1000000]. Default 0.
    int order;

    /// Default true. False: as if it were not there.
    bool isEnabled;

    /// Factor on the share. Range [0, 100]; beyond 1 only to add. Default 1.
    float weight;

    /// What the input says, as many numbers as the field has. It is added to the values that a raster, points, a
    /// spline, a mesh or a function brings of its own. Vectors (flow, wind, displacement) lie along the input's own
    /// axes. Range [-1e6, 1e6]; flow and wind at most SW_MAX_INPUT_SPEED either way. Default 0, 0, 0, 0.
    float value[4];

    /// Factor on the values that a raster, a spline, a mesh or a function brings. Range [-1e6, 1e6]. Default 1.
    float gain;

    /// How far inwards from its edge the share grows from 0 to 1, m. Range [0, 1e6]. Default 0: a hard edge. A floor
    /// that ends where there is none fades into deep water within the feather.
    float feather;

    /// Where the shape's own axes begin, m, in the host's coordinates; the height is of shapes that have one. A raster
    /// lies where it says itself, moved by this. Range [-1e9, 1e9]. Default 0.
    swPos position;

    /// How the shape's axes are turned, radians: yaw first, from +x towards +z, then pitch about its own z (which
    /// lifts its x axis), then roll about its own x (which lowers its z axis). Shapes without a height take the yaw
    /// alone. Range [-1000, 1000]. Default 0.
    swAngles rotation;

    /// Full extents of circles, rectangles and shapes with a height along their own axes, m. Of polylines and particles
    /// x is the width where their points have none. Range [0, 1e6]. Default 100, 10, 100.
    swVec3 size;

    /// Of SW_INPUT_LEVEL and SW_INPUT_FLOW: a tide, whose level or stream is added to `value`, see tide.h. It is that
    /// of the step's time, or of a moment's. Default: none.
    swTideConstituent tide[SW_MAX_TIDE];

    /// Colour, foam and displacement only: the input is carried to and fro by the waves, instead of staying put.
    /// Default false.
    bool followsWaves;

    /// SW_INPUT_DISPLACEMENT knows two ways. Inputs that follow the waves join the waves' own displacement where
    /// particles rest: they add to it, mix it with their value, or scale it, all three numbers. Those that stay put
    /// change heights where particles are: SW_BLEND_ADD and SW_BLEND_MULTIPLY as counted from still water; all others
    /// by absolute heights, value[1] above position.y: to set the height of the water, or to press it down below the
    /// underside of a hull (SW_BLEND_MIN). A raster of one channel has heights. Queries and rays see all of it; how an
    /// input moves is no part of velocities.
    ///
    /// Of SW_INPUT_DISPLACEMENT: length of the waves that it is like, m. Queries and slices whose shortest wave is
    /// longer leave it out, as they leave out waves. Range [0, 1e6]. Default 0: it is never left out.
    float wavelength;

    /// Of circles and particles: the share falls from the middle to the edge as (1 - r^2)^2, r being 1 at the edge, and
    /// `feather` is not looked at: a wave particle. Default false.
    bool isBump;

    /// Of SW_INPUT_WAVES: the system whose waves it weighs. Default null: all systems.
    swWaveSystemId system;

    /// Of SW_INPUT_WAVES: the waves of all systems that are there below it go by the same share by which its own come.
    /// Of unrelated waves energies add up, not heights, so the two weights have squares whose sum is 1; `blend` is not
    /// looked at. Inputs that join later add to it. Default false.
    bool removesWaves;

    /// Of SW_INPUT_WAVES by a raster: see swWindWeight.
    swWindWeight windWeight;

    /// Of SW_SHAPE_RASTER, with at least as many channels as the field has numbers. Unknown cells are not covered.
    /// A raster with more than one frame is played, see swInputDef::framesPerSecond. The world holds it as long as an
    /// input uses it; the host may destroy its handle at once. Default NULL.
    const swRaster* raster;

    /// Frames of the raster a second of the world's time, the first at startTime, with a blend between two. Range [0,
    /// 1000]. Default 0: the first frame stands.
    float framesPerSecond;

    /// s. Range [-SW_LARGEST_TIME, SW_LARGEST_TIME]. Default 0.
    double startTime;

    /// Default true: the last frame blends into the first. False: the first stands before, the last after.
    bool loops;

    /// Of SW_SHAPE_MESH. Held as a raster is. Default NULL.
    const swMesh* mesh;

    /// Of SW_SHAPE_HULL, see hull.h. Held as a raster is. Default NULL.
    const swHull* hull;

    /// What a metre of the hull becomes along its own axes. Distances near its edge stay true. Range (0, 1e4]. Default
    /// 1, 1, 1.
    swVec3 scale;

    /// Radius of the edges of boxes and cylinders, which it takes from their size, m. Range [0, 1e6]. Default 0.
    float rounding;

    /// Of SW_SHAPE_SPLINE. Held as a raster is. The spline lies where it says itself, moved and turned by this; heights
    /// of its points count from position.y. Default NULL.
    const swSpline* spline;

    /// Of SW_INPUT_WAVES along a spline: the waves turn with the line. They are looked up by metres to its side and
    /// along it, so that their length is exact on the line and changes beside it as a bend asks for; towards the centre
    /// of a bend, and where a line comes near itself, they fade. Blend SW_BLEND_ALPHA takes the system's other waves
    /// away to the same share, SW_BLEND_ADD leaves them. Default false: the spline says how much of the waves there is.
    bool alongSpline;

    /// With alongSpline: where waves of the direction 0 go, radians from the way across the line from right to left,
    /// towards the way along it: 0 onto a shore that is on the left, pi/2 along the line. The direction of the system's
    /// spectrum adds to it. Range [-1000, 1000]. Default 0.
    float heading;

    /// Of SW_SHAPE_POLYGON (3 to 4096), SW_SHAPE_POLYLINE (2 or more) and SW_SHAPE_PARTICLES. Copied. Default NULL, 0.
    const swInputPoint* points;
    int pointCount;

    /// Points that swInput_SetPoints() may later give. Range [0, SW_MAX_INPUT_POINTS]. Default 0: as many as now.
    int pointCapacity;

    /// Of SW_SHAPE_FUNCTION: the function, its context, which must outlive the input, and a number that is another
    /// whenever the function says something else; digests hold it. `size` says where it may say anything. Saved worlds
    /// name the fingerprint. The GPU cannot call it: what pictures and GPU queries must know of it, give as a raster.
    /// Default NULL, NULL, 0.
    swInputFunctionFcn function;
    void* functionContext;
    uint64_t functionFingerprint;

    /// Set by swDefaultInputDef().
    int internalValue;
} swInputDef;

/// How many numbers a field has, 1 to 4: those of swInputDef::value that count.
SW_API int swInputField_CountNumbers(swInputField field);

SW_API swInputDef swDefaultInputDef(void);
SW_API const swFields* swGetInputFields(void);

/// Put an input into the sea, from the next step on.
/// @return SW_ERROR_INVALID (the host's log names the number and its range), SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT (more
/// than SW_MAX_INPUTS), SW_ERROR_UNSUPPORTED where a shape makes no sense for a field; then nothing is made
SW_API swResult swCreateInput(swWorld* world, const swInputDef* def, swInputId* id);

/// Most rasters of a nest.
#define SW_MAX_NEST 64

/// Put a nest of rasters into the sea, such as a coarse chart of a coast and finer ones of its harbours: an input for
/// each, which joins by SW_BLEND_ALPHA over the coarser ones, so that the finest counts. Each fades into what is below
/// it within a feather from its edge inwards: three cells of the next coarser one, at most a quarter of its own shorter
/// side. The coarsest fades into what is below all within `def`'s feather, or, where that is 0, within a sixteenth of
/// its shorter side. The other fields of `def` are those of each input; its shape and raster are not looked at, and the
/// order is that of the coarsest, which the others follow.
/// @param rasters in any order; of equal spacing the one that comes later counts
/// @param ids [count], in the order of the rasters
/// @return as swCreateInput(); then none is made
SW_API swResult swCreateNest(swWorld* world, const swInputDef* def, int count, const swRaster* const* rasters,
                             swInputId* ids);

/// Take an input away, from the next step on.
SW_API void swDestroyInput(swWorld* world, swInputId id);

SW_API bool swInput_IsValid(const swWorld* world, swInputId id);

/// Change anything about an input. It keeps its handle and its place among inputs of the same order.
/// @return as swCreateInput(); then nothing has changed
SW_API swResult swInput_Set(swWorld* world, swInputId id, const swInputDef* def);

/// The def as it was given last, with what was moved and set since. Its points are the world's, until the next change.
SW_API swInputDef swInput_Get(const swWorld* world, swInputId id);

/// @name Changes that allocate nothing, for each frame
/// A number out of its range is misuse: the input stays as it was.
/// @{
SW_API void swInput_Move(swWorld* world, swInputId id, swPos position, swAngles rotation);
SW_API void swInput_Enable(swWorld* world, swInputId id, bool isEnabled);
SW_API void swInput_SetValue(swWorld* world, swInputId id, const float value[4]);
SW_API void swInput_SetWeight(swWorld* world, swInputId id, float weight);
/// Other points, at most swInputDef::pointCapacity of them.
/// @return SW_ERROR_INVALID if they are more, or such as swCreateInput() refuses; the old ones then stay
SW_API swResult swInput_SetPoints(swWorld* world, swInputId id, int count, const swInputPoint* points);
/// @}

SW_API int swWorld_GetInputCount(const swWorld* world);

/// Handles in the order in which inputs join, of all fields.
SW_API swInputId swWorld_GetInput(const swWorld* world, int index);

/// Where answers about fields go: arrays of as many elements as points, or NULL to skip.
typedef struct swFieldSamples
{
    float* depth;  ///< of still water: level above floor, m; infinite without a floor, negative on land
    float* floor;  ///< height of the sea floor, m, absolute; -infinite where there is none
    float* level;  ///< of still water above the world's sea level, m
    swVec2* flow;  ///< m/s along x and z
    float* weight; ///< of the waves of `system`, by its inputs; without swWaveSystemDef::weight
    swWaveSystemId system;
    float* clip;    ///< above 0.5: no water. It rises from 0 to 1 within 1 m across the edge of still water
    float* foam;    ///< made by inputs, per second
    swVec4* albedo; ///< red, green, blue, each times the cover; and the cover
    swVec2* wind;   ///< m/s along x and z: the world's, with its gusts, and what inputs make of it
    float* shadow;
    swVec3* displacement; ///< by inputs alone, m
    int* body;            ///< -1 where there is none
} swFieldSamples;

/// The fields at `count` places. Fields are functions of place: waves are not searched for. Those that shape waves
/// (depth, weight, flow) count at the place where a particle rests, the others where it is.
/// A place that cannot be answered is NaN in all fields, -1 in `body`.
/// @return how many places could not be answered
SW_API int swMoment_QueryFields(const swMoment* moment, int count, const swPosXZ* points,
                                const swFieldSamples* samples);

/// Capture the sea floor of the world's last step on a lattice: a raster that stands for all floor inputs there, to be
/// kept in a file (see swWriteRaster()) or used anew, as often as the host likes. NaN where there is no floor.
/// @param def the lattice, in the host's coordinates; its values are not looked at
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY
SW_API swResult swBakeFloor(const swWorld* world, const swRasterDef* def, swRaster** raster);

/// A hash of all that decides what swBakeFloor() makes: the floor inputs as they are now, with the bits of their
/// rasters and meshes, and the lattice. A file that was made from another hash is stale. 0: a lattice of no use.
SW_API uint64_t swWorld_HashFloor(const swWorld* world, const swRasterDef* def);
