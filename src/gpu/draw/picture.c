// SPDX-License-Identifier: MIT
// World coordinates end here: positions are subtracted in double, and what shaders get is small.

#include "gpu/draw/picture.h"

#include <math.h>
#include <string.h>

#include "gpu/pass/gpu_inputs.h"
#include "shared/roughness.h"

#define SW_TURN (2.0 * SW_PI)
#define SW_EARTH_RADIUS 6360e3
// Colour of a 5800 K black body in linear sRGB, luminance 1.
#define SW_SUN_RED 1.047f
#define SW_SUN_GREEN 0.995f
#define SW_SUN_BLUE 0.915f
#define SW_FOAM_PERIOD 1024.0
#define SW_FOAM_RENEWAL 7.0  // s from one foam pattern to the next but one
#define USUAL_WIND 7.0f      // m/s on ripples where nothing names a wind
#define SW_CLOUD_DRIFT 0.015 // km/s

static double wrap(double x, double period)
{
    return x - floor(x / period) * period;
}

// Anywhere in the clouds, km, to a place between the edges of their noise, and which way it runs there.
static void placeInClouds(double x, float* place, float* way)
{
    const double edge = (double)SW_CLOUD_EDGE;
    double along = wrap(x + edge, 4.0 * edge) - edge; // the mirror image is from edge to 3 edge
    bool isMirrored = along > edge;
    *place = (float)(isMirrored ? 2.0 * edge - along : along);
    *way = isMirrored ? -1.0f : 1.0f;
}

// Projection times view, columns. Both are camera-relative, so the fourth column is the projection's own.
static void setCamera(const swCamera* camera, swPictureParams* p)
{
    const float* view = camera->view.m;
    const float* projection = camera->projection.m;
    float clip[16];
    for (int column = 0; column < 4; ++column)
    {
        for (int row = 0; row < 4; ++row)
        {
            float sum = 0.0f;
            for (int k = 0; k < 4; ++k)
            {
                sum += projection[4 * k + row] * view[4 * column + k];
            }
            clip[4 * column + row] = sum;
        }
    }
    memcpy(p->clip, clip, sizeof(clip));
    float perX = 1.0f / projection[0];
    float perY = 1.0f / projection[5];
    p->rayX = (swVec3){view[0] * perX, view[4] * perX, view[8] * perX};
    p->rayY = (swVec3){view[1] * perY, view[5] * perY, view[9] * perY};
    p->forward = (swVec3){-view[2], -view[6], -view[10]};
    p->pixel = 2.0f * fabsf(perY) / (float)camera->height;
}

static void setSky(const swSkyDef* sky, swPictureParams* p)
{
    double level = cos((double)sky->sunElevation);
    p->sun = (swVec3){(float)(sin((double)sky->sunAzimuth) * level), (float)sin((double)sky->sunElevation),
                      (float)(-cos((double)sky->sunAzimuth) * level)};
    float light = sky->sunIlluminance * SW_PRE_EXPOSURE;
    p->sunLight = (swVec3){light * SW_SUN_RED, light * SW_SUN_GREEN, light * SW_SUN_BLUE};
    p->haze = sky->haze;
    p->clouds = sky->clouds;
}

static void setWater(const swShot* shot, const swFrame* frame, swPictureFrame* built)
{
    const swWaterDef* water = &shot->water;
    swPictureParams* p = &built->params;
    float variance = 0.0f;
    float slopes = 0.0f;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        variance += frame->tiles[i].variance;
        slopes += frame->tiles[i].slopeVarianceX + frame->tiles[i].slopeVarianceZ;
    }
    for (int i = 0; i < frame->waveCount; ++i)
    {
        variance += 0.5f * frame->waves[i].amplitude * frame->waves[i].amplitude;
        slopes += swGetFreeWaveSlope(&frame->waves[i]);
    }
    float deviation = sqrtf(variance);
    p->absorption = water->absorption;
    p->scattering = water->scattering;
    p->index = water->refractiveIndex;
    p->deviation = deviation;
    p->foamAlbedo = water->foamAlbedo;
    float worldWind = frame->windField.isNamed ? frame->wind : USUAL_WIND;
    p->rippleVariance = swRippleVariance(water->windSpeed > 0.0f ? water->windSpeed : worldWind, slopes);
    p->slopeVariance = p->rippleVariance + 0.5f * slopes;
    // A Gaussian sea exceeds six deviations once in 10^9 places; chop moves water sideways by at most twice the height.
    p->verticalReach = 6.0f * deviation + 0.1f;
    p->horizontalReach = 12.0f * deviation + 0.1f;
}

static void setMesh(const swShot* shot, const swFrame* frame, const swViewFrame* view, swPictureFrame* built)
{
    swPictureParams* p = &built->params;
    const swMeshRings* rings = &built->rings;
    const swPos* camera = &shot->camera.position;
    p->cameraHeight = (float)(camera->y - frame->seaLevel);
    p->seaY = (float)(frame->seaLevel - camera->y);
    p->anchorX = (float)(rings->anchorX - camera->x);
    p->anchorZ = (float)(rings->anchorZ - camera->z);
    swSplitSeaPlace(rings->anchorX, &p->anchorCellX, &p->anchorRestX);
    swSplitSeaPlace(rings->anchorZ, &p->anchorCellZ, &p->anchorRestZ);
    p->viewX = rings->viewX;
    p->viewZ = rings->viewZ;
    p->step = (float)rings->step;
    p->fade = rings->fade;
    p->quads = (float)rings->quads;
    p->ringCount = (uint32_t)rings->ringCount;
    p->tileCount = (uint32_t)rings->tileCount;
    p->tileSide = (uint32_t)rings->tileSide;
    p->resolution = (uint32_t)view->stack.resolution;
    p->finestWavelength = view->stack.slices[0].minWavelength;

    // Flat where queries and hulls are looked at closely; bent from a quarter of the way to the horizon on.
    double height = fmax((double)p->cameraHeight, 1.0);
    double rim = swGetMeshRim(rings);
    double flat = fmin(rim, 0.25 * sqrt(2.0 * SW_EARTH_RADIUS * height));
    double horizon = sqrt(flat * flat + 2.0 * SW_EARTH_RADIUS * height);
    p->flatDistance = (float)flat;
    p->earthRadius = (float)SW_EARTH_RADIUS;
    p->horizonScale = (float)log2(fmax(1.2 * horizon / rim, 1.05));
}

static void setBands(const swFrame* frame, uint32_t detailSide, swPictureFrame* built)
{
    built->params.bandCount = (uint32_t)frame->tileCount;
    built->params.systems = 0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        double x = (built->rings.anchorX - tile->shiftX) / tile->side;
        double z = (built->rings.anchorZ - tile->shiftZ) / tile->side;
        built->bands[i] = (swDetailParams){
            .offsetX = (float)(x - floor(x) + 0.5 / detailSide),
            .offsetZ = (float)(z - floor(z) + 0.5 / detailSide),
            .perMetre = (float)(1.0 / tile->side),
            .minWavelength = tile->minWavelength,
            .maxWavelength = tile->maxWavelength,
            .slopeVarianceX = tile->slopeVarianceX,
            .slopeVarianceZ = tile->slopeVarianceZ,
            .system = (uint32_t)tile->system,
        };
        built->params.systems |= 1u << (unsigned)tile->system;
    }
}

static swDetailWave makeDetailWave(const swFreeWave* wave, int64_t ticks, const swMeshRings* rings)
{
    double turns = wave->turnsX * rings->anchorX + wave->turnsZ * rings->anchorZ +
                   (wave->phase - swGetPassedTurns(wave, ticks)) * 0x1p-32;
    return (swDetailWave){
        .kx = (float)(SW_TURN * wave->turnsX),
        .kz = (float)(SW_TURN * wave->turnsZ),
        .phase = (float)(SW_TURN * (turns - floor(turns))),
        .amplitude = wave->amplitude,
        .wavelength = wave->wavelength,
        .system = (uint32_t)wave->system,
    };
}

static void setFreeWaves(const swFrame* frame, swPictureFrame* built)
{
    built->params.waveCount = (uint32_t)frame->waveCount;
    float restX = 0.0f, restZ = 0.0f;
    for (int i = frame->waveCount - 1; i >= 0; --i)
    {
        swDetailWave wave = makeDetailWave(&frame->waves[i], frame->ticks, &built->rings);
        float steepX = wave.amplitude * wave.kx, steepZ = wave.amplitude * wave.kz;
        wave.restX = restX += 0.5f * steepX * steepX;
        wave.restZ = restZ += 0.5f * steepZ * steepZ;
        built->waves[i] = wave;
        built->params.systems |= 1u << wave.system;
    }
}

// Where the sea is dry but for what inputs leave, and between which heights its water stands. Of the inputs that hold
// everywhere the last one decides, and those before it do not count.
static void setHoles(const swInputSet* set, swPictureParams* p)
{
    if (set == NULL)
    {
        return;
    }
    p->lowestLevel = set->lowestLevel;
    p->highestLevel = set->highestLevel;
    swInputRange range = set->ranges[SW_INPUT_CLIP];
    p->firstHole = range.firstRecord;
    for (uint32_t i = range.firstRecord; i < range.firstRecord + range.recordCount; ++i)
    {
        const swInputRecord* record = &set->records[i];
        if (record->shape == SW_FORM_EVERYWHERE && record->weight > 0.5f)
        {
            p->isDry = record->value.x * record->weight > 0.5f ? 1 : 0;
            p->firstHole = i + 1;
        }
    }
}

static swPictureLook makeLook(const swWaterDef* water)
{
    return (swPictureLook){.absorption = water->absorption,
                           .index = water->refractiveIndex,
                           .scattering = water->scattering,
                           .foamAlbedo = water->foamAlbedo};
}

static void setBodies(const swShot* shot, const swFrame* frame, swPictureFrame* built)
{
    built->params.bodyCount = (uint32_t)frame->bodyCount;
    for (int i = 0; i < frame->bodyCount; ++i)
    {
        const swBodyFrame* body = &frame->bodies[i];
        built->bodies[i] = (swMeshBody){
            .lowX = (float)(body->low.x - built->rings.anchorX),
            .lowZ = (float)(body->low.z - built->rings.anchorZ),
            .highX = (float)(body->high.x - built->rings.anchorX),
            .highZ = (float)(body->high.z - built->rings.anchorZ),
            .level = body->level,
            .number = body->number,
            .look = (uint32_t)body->look,
            .setsLevel = body->setsLevel ? 1 : 0,
        };
    }
    built->lookCount = (uint32_t)shot->bodyWaterCount + 1;
    built->looks[0] = makeLook(&shot->water);
    for (int i = 0; i < shot->bodyWaterCount; ++i)
    {
        built->looks[i + 1] = makeLook(&shot->bodyWaters[i]);
    }
}

static void setTime(const swShot* shot, const swFrame* frame, swPictureFrame* built)
{
    swPictureParams* p = &built->params;
    double turn = shot->time / SW_FOAM_RENEWAL;
    p->foamX = (float)wrap(built->rings.anchorX, SW_FOAM_PERIOD);
    p->foamZ = (float)wrap(built->rings.anchorZ, SW_FOAM_PERIOD);
    p->foamPhase = (float)(turn - floor(turn));
    p->foamSeed = (float)wrap(2.0 * floor(turn), 512.0);
    p->foamRenewal = (float)SW_FOAM_RENEWAL;
    p->foamCurrentX = frame->foamLaw.currentX;
    p->foamCurrentZ = frame->foamLaw.currentZ;
    placeInClouds(shot->camera.position.x * 1e-3 + SW_CLOUD_DRIFT * shot->time, &p->cloudX, &p->cloudWayX);
    placeInClouds(shot->camera.position.z * 1e-3, &p->cloudZ, &p->cloudWayZ);
}

void swBuildPicture(const swShot* inHost, swPosXZ origin, const swFrame* frame, const swViewFrame* view,
                    uint32_t detailSide, swPictureFrame* built)
{
    swShot inSea = *inHost;
    inSea.camera.position.x += origin.x;
    inSea.camera.position.z += origin.z;
    const swShot* shot = &inSea;
    memset(&built->params, 0, sizeof(built->params));
    built->params.debugMode = (uint32_t)shot->debug;
    swBuildMeshRings(view, &built->rings);
    setCamera(&shot->camera, &built->params);
    setSky(&shot->sky, &built->params);
    setWater(shot, frame, built);
    setMesh(shot, frame, view, built);
    setBands(frame, detailSide, built);
    setFreeWaves(frame, built);
    setHoles(frame->inputs, &built->params);
    setBodies(shot, frame, built);
    setTime(shot, frame, built);
    built->params.foamAtRest = frame->foamLaw.cover;
}

swResult swUploadPicture(swGpu* gpu, swPictureFrame* built)
{
    swResult result = swUploadData(gpu, &built->params, sizeof(built->params), &built->paramsUpload);
    if (result == SW_SUCCESS)
    {
        result = swUploadData(gpu, built->rings.slices, sizeof(built->rings.slices), &built->slicesUpload);
    }
    if (result == SW_SUCCESS)
    {
        result = swUploadData(gpu, built->rings.tiles, sizeof(built->rings.tiles), &built->tilesUpload);
    }
    if (result == SW_SUCCESS)
    {
        result = swUploadData(gpu, built->bands, sizeof(built->bands), &built->bandsUpload);
    }
    if (result == SW_SUCCESS)
    {
        size_t count = built->params.waveCount > 0 ? built->params.waveCount : 1; // a buffer must hold something
        result = swUploadData(gpu, built->waves, count * sizeof(swDetailWave), &built->wavesUpload);
    }
    if (result == SW_SUCCESS)
    {
        size_t count = built->params.bodyCount > 0 ? built->params.bodyCount : 1;
        result = swUploadData(gpu, built->bodies, count * sizeof(swMeshBody), &built->bodiesUpload);
    }
    if (result == SW_SUCCESS)
    {
        result = swUploadData(gpu, built->looks, built->lookCount * sizeof(swPictureLook), &built->looksUpload);
    }
    return result;
}
