// SPDX-License-Identifier: MIT
#include "core/surface/displace.h"

#include <math.h>

#include "core/input/sample_inputs.h"

// Whether any input displaces the water near some points.
static bool isNear(const swQuery* query, int count, const swPosXZ* points, double reach)
{
    if (!swHasInputs(query->inputs, SW_INPUT_DISPLACEMENT))
    {
        return false;
    }
    double minX = points[0].x, maxX = points[0].x, minZ = points[0].z, maxZ = points[0].z;
    for (int i = 1; i < count; ++i)
    {
        minX = fmin(minX, points[i].x);
        maxX = fmax(maxX, points[i].x);
        minZ = fmin(minZ, points[i].z);
        maxZ = fmax(maxZ, points[i].z);
    }
    const swPosXZ middle = {0.5 * (minX + maxX), 0.5 * (minZ + maxZ)};
    swCellBox box;
    return !swFindCellBox(middle, fmax(maxX - middle.x, maxZ - middle.z) + reach, &box) ||
           swTouchesInputs(query->inputs, SW_FIELD_BIT(SW_INPUT_DISPLACEMENT), &box);
}

static swInputValue getWaves(const float* d, const float* g)
{
    swInputValue waves = {.value = {d[0], d[1], d[2], 0.0f}};
    if (g != NULL)
    {
        waves.alongX = (sw_vec4){g[0], g[4], g[2], 0.0f};
        waves.alongZ = (sw_vec4){g[1], g[5], g[3], 0.0f};
    }
    return waves;
}

static void putWaves(const swInputValue* waves, float* d, float* g)
{
    d[0] = waves->value.x;
    d[1] = waves->value.y;
    d[2] = waves->value.z;
    if (g != NULL)
    {
        g[0] = waves->alongX.x;
        g[1] = waves->alongZ.x;
        g[2] = waves->alongX.z;
        g[3] = waves->alongZ.z;
        g[4] = waves->alongX.y;
        g[5] = waves->alongZ.y;
        g[6] = g[1] - g[2];
    }
}

// Rates of displacement: inputs stand still, so only what scales the waves counts.
static void displaceRates(const swQuery* query, int count, const swPosXZ* rest, float (*rates)[4])
{
    // No record is of this part of the waves.
    const swDisplaceRange none = {query->def->minWavelength, INFINITY, 0.0f};
    for (int i = 0; i < count && rates != NULL; ++i)
    {
        swInputValue waves = getWaves(rates[i], NULL);
        swDisplaceAt(query->inputs, none, rest[i], &waves);
        putWaves(&waves, rates[i], NULL);
    }
}

void swDisplaceWaves(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    if (!isNear(query, count, rest, 0.0))
    {
        return;
    }
    const swDisplaceRange range = {query->def->minWavelength, out->shortest, out->longest};
    for (int i = 0; i < count && out->displacement != NULL; ++i)
    {
        float* g = out->gradients != NULL ? out->gradients[i] : NULL;
        swInputValue waves = getWaves(out->displacement[i], g);
        swDisplaceAt(query->inputs, range, rest[i], &waves);
        putWaves(&waves, out->displacement[i], g);
    }
    displaceRates(query, count, rest, out->velocity);
    displaceRates(query, count, rest, out->acceleration);
}

// From derivatives by where particles are to those by where they rest.
static void putHeight(const swInputChannel* before, const swInputChannel* after, float* g)
{
    float alongX = after->alongX - before->alongX, alongZ = after->alongZ - before->alongZ;
    g[4] += alongX * (1.0f + g[0]) + alongZ * g[2];
    g[5] += alongX * g[1] + alongZ * (1.0f + g[3]);
}

// Derivatives of the height by where particles are: the other way round. Where the surface folds they have none.
static swInputChannel getHeight(const float* d, const float* g)
{
    if (g == NULL)
    {
        return swKeepChannel(d[1]);
    }
    float jacobian = (1.0f + g[0]) * (1.0f + g[3]) - g[1] * g[2];
    float inverse = fabsf(jacobian) > 1e-3f ? 1.0f / jacobian : 0.0f;
    return swMakeChannel(d[1], ((1.0f + g[3]) * g[4] - g[2] * g[5]) * inverse,
                         ((1.0f + g[0]) * g[5] - g[1] * g[4]) * inverse);
}

void swDisplaceHeights(const swQuery* query, int count, const swPosXZ* rest, float (*displacement)[4],
                       float (*gradients)[8])
{
    double reach = 0.0;
    for (int i = 0; i < count && swHasInputs(query->inputs, SW_INPUT_DISPLACEMENT); ++i)
    {
        reach = fmax(reach, (double)fmaxf(fabsf(displacement[i][0]), fabsf(displacement[i][2])));
    }
    if (!isNear(query, count, rest, reach))
    {
        return;
    }
    const swDisplaceRange range = {.least = query->def->minWavelength};
    for (int i = 0; i < count; ++i)
    {
        const float* d = displacement[i];
        float* g = gradients != NULL ? gradients[i] : NULL;
        const swPosXZ place = {rest[i].x + (double)d[0], rest[i].z + (double)d[2]};
        swInputChannel before = getHeight(d, g), after = before;
        swDisplaceHeightAt(query->inputs, range, place, &after);
        displacement[i][1] = after.value;
        if (g != NULL)
        {
            putHeight(&before, &after, g);
        }
    }
}
