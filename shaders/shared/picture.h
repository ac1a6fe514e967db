// SPDX-License-Identifier: MIT
// What every shader of a picture reads: camera, sun and air, mesh, water. Written once a frame by draw/surface.c.
//
// Positions are metres from the camera, y up. Radiance is cd/m^2 in linear sRGB primaries, times SW_PRE_EXPOSURE, which
// brings the sun's disc and a moonless dusk alike into the range of half floats; exposure divides it out again.
#ifndef SW_SHARED_PICTURE_H
#define SW_SHARED_PICTURE_H
#include "limits.h"
#include "types.h"

#define SW_PRE_EXPOSURE (1.0f / 32768.0f)

// Sizes of the sky's tables, texels.
#define SW_SKY_TRANSMITTANCE_WIDTH 256
#define SW_SKY_TRANSMITTANCE_HEIGHT 64
#define SW_SKY_MULTIPLE_SIDE 32
#define SW_SKY_VIEW_WIDTH 256
#define SW_SKY_VIEW_HEIGHT 128
#define SW_SKY_MAP_MIPS 6
#define SW_SKY_AIR_SIDE 64

// Detail of foam: a square texture of four patterns.
#define SW_FOAM_TEXTURE_SIDE 256
#define SW_FOAM_TEXTURE_MIPS 8

SW_PARAMS(swPictureParams)
{
    sw_vec4 clip[4]; // columns: metres from the camera to clip space

    sw_vec3 rayX;       // world direction that one unit of clip x adds to a ray
    float pixel;        // m that a pixel covers at distance 1
    sw_vec3 rayY;       // the same for y
    float cameraHeight; // above sea level, m
    sw_vec3 forward;    // where the camera looks
    float seaY;         // sea level from the camera, m

    sw_vec3 sun;      // towards the sun
    float haze;       // aerosol relative to clear air
    sw_vec3 sunLight; // illuminance above the atmosphere, pre-exposed lux
    float clouds;     // cover, [0, 1]

    sw_vec3 absorption; // 1/m
    float index;        // of refraction
    sw_vec3 scattering; // 1/m
    float deviation;    // of the sea's height, m
    sw_vec3 foamAlbedo;
    float foamAtRest; // beyond the slices

    float anchorX; // the mesh's anchor from the camera, m
    float anchorZ;
    float viewX; // the viewer, finest steps from the anchor
    float viewZ;

    float step; // of the finest ring, m
    float fade;
    float quads; // d of mesh_rings
    float flatDistance;

    float earthRadius;  // m
    float horizonScale; // log2 of the horizon strip's outer over its inner edge
    sw_uint ringCount;
    sw_uint tileCount; // of the mesh

    sw_uint tileSide;
    sw_uint resolution; // texels along a slice
    sw_uint bandCount;  // tiles of waves
    sw_uint waveCount;  // free waves

    sw_uint debugMode;      // swDebugMode
    float finestWavelength; // shortest wave that slice 0 carries, m; doubles with each slice
    float rippleVariance;   // slope variance of each axis that no band holds
    float slopeVariance;    // of each axis, all waves

    float horizontalReach; // most that a vertex is displaced, m: bounds for culling
    float verticalReach;
    float foamX; // the anchor in the foam texture's period, m
    float foamZ;

    float foamPhase; // of the cross-fade between two foam patterns, [0, 1)
    float foamSeed;
    float cloudX; // where the camera is in the clouds, with their drift, km
    float cloudZ;

    float cloudWayX; // 1 or -1: which way the clouds run there, see swMirrorClouds()
    float cloudWayZ;
    sw_int anchorCellX; // of the sea, see shared/input.h, that the mesh's anchor is in
    sw_int anchorCellZ;

    float anchorRestX; // where in that cell, m
    float anchorRestZ;
    sw_uint bodyCount; // of water, that may be seen
    sw_uint firstHole; // record of the first input that cuts or leaves, of those that count

    float lowestLevel; // of still water above sea level, m
    float highestLevel;
    sw_uint isDry;   // 1: there is no water but where inputs from firstHole on leave some
    sw_uint systems; // bit k: bands or free waves are of wave system k

    float foamRenewal;  // s that a foam pattern lasts
    float foamCurrentX; // that carries foam beside the flow, m/s
    float foamCurrentZ;
    float unused0;
};
SW_PARAMS_SIZE(swPictureParams, 368);
SW_PARAMS_VEC3(swPictureParams, rayX);
SW_PARAMS_VEC3(swPictureParams, rayY);
SW_PARAMS_VEC3(swPictureParams, forward);
SW_PARAMS_VEC3(swPictureParams, sun);
SW_PARAMS_VEC3(swPictureParams, sunLight);
SW_PARAMS_VEC3(swPictureParams, absorption);
SW_PARAMS_VEC3(swPictureParams, scattering);
SW_PARAMS_VEC3(swPictureParams, foamAlbedo);

// The clouds' noise has no period of its own, and floats hold a metre of it within SW_CLOUD_EDGE of its middle, km.
// Beyond its edges it goes on as in a mirror, without a jump, and so repeats after four times as much.
#define SW_CLOUD_EDGE 8192.0f

// A place that may be beyond one edge.
SW_FORMULA float swMirrorClouds(float place)
{
    return place > SW_CLOUD_EDGE ? 2.0f * SW_CLOUD_EDGE - place
                                 : (place < -SW_CLOUD_EDGE ? -2.0f * SW_CLOUD_EDGE - place : place);
}

// One kind of water.
SW_PARAMS(swPictureLook)
{
    sw_vec3 absorption; // 1/m
    float index;        // of refraction
    sw_vec3 scattering; // 1/m
    float unused0;
    sw_vec3 foamAlbedo;
    float unused1;
};
SW_PARAMS_SIZE(swPictureLook, 48);
SW_PARAMS_VEC3(swPictureLook, absorption);
SW_PARAMS_VEC3(swPictureLook, scattering);
SW_PARAMS_VEC3(swPictureLook, foamAlbedo);

// A tile of waves as the fragment shader reads it: its layer of slopes, and where the mesh's anchor lies in it.
SW_PARAMS(swDetailParams)
{
    float offsetX, offsetZ; // texture coordinate of the anchor
    float perMetre;         // 1 / side
    float minWavelength;    // m
    float maxWavelength;    // m
    float slopeVarianceX, slopeVarianceZ;
    sw_uint system; // that its waves are of
};
SW_PARAMS_SIZE(swDetailParams, 32);

// A free wave as the fragment shader reads it, longest first: slopes by rest position from the mesh's anchor are
// -amplitude sin(kx x + kz z + phase) (kx, kz).
SW_PARAMS(swDetailWave)
{
    float kx, kz; // rad/m
    float phase;
    float amplitude;    // m
    float wavelength;   // m
    float restX, restZ; // slope variance of this wave and all that are shorter
    sw_uint system;     // that it is of
};
SW_PARAMS_SIZE(swDetailWave, 32);

// Light at sea level, pre-exposed. Written by sky_light.comp.
SW_PARAMS(swSkyLight)
{
    sw_vec4 sun;  // illuminance on a surface that faces the sun
    sw_vec4 sky;  // illuminance of the sky on a level surface
    sw_vec4 high; // the sun's at the clouds
};
SW_PARAMS_SIZE(swSkyLight, 48);

// Written by expose.comp. All zero before the first measurement.
SW_PARAMS(swExposure)
{
    float exposure; // factor on pre-exposed radiance that brings middle grey to 0.18
    float average;  // log2 of the measured luminance, cd/m^2
    float unused0, unused1;
};
SW_PARAMS_SIZE(swExposure, 16);
#endif
