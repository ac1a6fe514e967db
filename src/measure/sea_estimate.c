// SPDX-License-Identifier: MIT
// From sums of cross spectra to densities, moments of directions and sea states.

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "seaway/measure.h"

void swAddSeaSums(const swSeaSums* from, swSeaSums* to)
{
    SW_REQUIRE_VOID(from != NULL && to != NULL, NULL, "swAddSeaSums() needs two sums");
    to->weight += from->weight;
    for (int i = 0; i < SW_MAX_SEA_BINS; ++i)
    {
        to->h[i] += from->h[i];
        to->hx[i] += from->hx[i];
        to->hz[i] += from->hz[i];
        to->xx[i] += from->xx[i];
        to->zz[i] += from->zz[i];
        to->xz[i] += from->xz[i];
    }
}

double swEstimateDensity(const swSeaBins* bins, const swSeaSums* sums, int bin)
{
    SW_REQUIRE(bins != NULL && sums != NULL && bin >= 0 && bin < bins->count, (double)NAN, NULL,
               "swEstimateDensity() needs bins, sums, and one of the bins");
    double scale = sums->weight > 0.0 ? 1.0 / sums->weight : 0.0;
    return scale * sums->h[bin] / (bins->high[bin] - bins->low[bin]);
}

int swFindPeakBin(const swSeaBins* bins, const swSeaSums* sums)
{
    SW_REQUIRE(bins != NULL && sums != NULL, 0, NULL, "swFindPeakBin() needs bins and sums");
    int peak = 0;
    for (int i = 1; i < bins->count; ++i)
    {
        peak = swEstimateDensity(bins, sums, i) > swEstimateDensity(bins, sums, peak) ? i : peak;
    }
    return peak;
}

swDirectionMoments swEstimateMoments(const swSeaSums* sums, int bin)
{
    SW_REQUIRE(sums != NULL && bin >= 0 && bin < SW_MAX_SEA_BINS, (swDirectionMoments){0}, NULL,
               "swEstimateMoments() needs sums, and one of their bins");
    double slopes = sums->xx[bin] + sums->zz[bin], norm = sqrt(sums->h[bin] * slopes);
    if (!(norm > 0.0))
    {
        return (swDirectionMoments){0};
    }
    return (swDirectionMoments){sums->hx[bin] / norm, sums->hz[bin] / norm, (sums->xx[bin] - sums->zz[bin]) / slopes,
                                2.0 * sums->xz[bin] / slopes};
}

double swEstimateVariance(const swSeaBins* bins, const swSeaSums* sums, double low, double high)
{
    SW_REQUIRE(bins != NULL && sums != NULL, (double)NAN, NULL, "swEstimateVariance() needs bins and sums");
    if (isnan(low) || isnan(high))
    {
        return (double)NAN;
    }
    double variance = 0.0;
    for (int i = 0; i < bins->count; ++i)
    {
        double overlap = fmin(high, bins->high[i]) - fmax(low, bins->low[i]);
        variance += fmax(overlap, 0.0) * swEstimateDensity(bins, sums, i);
    }
    return variance;
}

void swEstimateSeaState(const swSeaBins* bins, const swSeaSums* sums, swSeaState* state)
{
    SW_REQUIRE_VOID(state != NULL, NULL, "swEstimateSeaState() needs a place for the sea state");
    memset(state, 0, sizeof(*state));
    SW_REQUIRE_VOID(bins != NULL && sums != NULL, NULL, "swEstimateSeaState() needs bins and sums");
    double before = 0.0, m0 = 0.0, m1 = 0.0, m2 = 0.0, slope = 0.0, a = 0.0, b = 0.0, peakA = 0.0, peakB = 0.0;
    double scale = sums->weight > 0.0 ? 1.0 / sums->weight : 0.0;
    int peak = swFindPeakBin(bins, sums);
    for (int i = 0; i < bins->count; ++i)
    {
        double variance = sums->h[i] * scale, f = bins->center[i];
        swDirectionMoments moments = swEstimateMoments(sums, i);
        before += variance / f;
        m0 += variance;
        m1 += variance * f;
        m2 += variance * f * f;
        slope += (sums->xx[i] + sums->zz[i]) * scale;
        a += variance * moments.a1;
        b += variance * moments.b1;
        peakA = i == peak ? sums->hx[i] : peakA;
        peakB = i == peak ? sums->hz[i] : peakB;
    }
    if (m0 <= 0.0)
    {
        return;
    }
    state->significantHeight = (float)(4.0 * sqrt(m0));
    state->peakPeriod = (float)(1.0 / bins->center[peak]);
    state->periodTm01 = (float)(m0 / m1);
    state->periodTm02 = (float)sqrt(m0 / m2);
    state->energyPeriod = (float)(before / m0);
    state->meanDirection = (float)atan2(b, a);
    state->peakDirection = (float)atan2(peakB, peakA);
    state->spread = (float)sqrt(fmax(2.0 * (1.0 - sqrt(a * a + b * b) / m0), 0.0));
    state->meanSquareSlope = (float)slope;
}

// The state's numbers as an array, to go through them.
#define STATE_NUMBERS 9
static void listState(const swSeaState* state, double numbers[STATE_NUMBERS])
{
    const float* fields[STATE_NUMBERS] = {&state->significantHeight, &state->peakPeriod,   &state->periodTm01,
                                          &state->periodTm02,        &state->energyPeriod, &state->meanDirection,
                                          &state->peakDirection,     &state->spread,       &state->meanSquareSlope};
    for (int i = 0; i < STATE_NUMBERS; ++i)
    {
        numbers[i] = (double)*fields[i];
    }
}

static void leaveOut(const swSeaSums* all, const swSeaSums* group, swSeaSums* rest)
{
    rest->weight = all->weight - group->weight;
    for (int i = 0; i < SW_MAX_SEA_BINS; ++i)
    {
        rest->h[i] = all->h[i] - group->h[i];
        rest->hx[i] = all->hx[i] - group->hx[i];
        rest->hz[i] = all->hz[i] - group->hz[i];
        rest->xx[i] = all->xx[i] - group->xx[i];
        rest->zz[i] = all->zz[i] - group->zz[i];
        rest->xz[i] = all->xz[i] - group->xz[i];
    }
}

swResult swEstimateSeaError(const swHost* host, const swSeaBins* bins, int groupCount, const swSeaSums* groups,
                            swSeaState* error)
{
    SW_REQUIRE(swIsHostValid(host), SW_ERROR_INVALID, host,
               "swEstimateSeaError() needs a host made by swDefaultHost()");
    SW_REQUIRE(bins != NULL && groups != NULL && error != NULL && groupCount > 0, SW_ERROR_INVALID, host,
               "swEstimateSeaError() needs bins, the sums of at least one group, and a place for the errors");
    swSeaSums* sums = swAllocateZero(host, 2 * sizeof(swSeaSums)); // of all, and of all but one
    if (sums == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the sums of a sea, %zu bytes.", 2 * sizeof(swSeaSums));
    }
    for (int i = 0; i < groupCount; ++i)
    {
        swAddSeaSums(groups + i, sums);
    }
    double whole[STATE_NUMBERS], shift[STATE_NUMBERS] = {0.0}, square[STATE_NUMBERS] = {0.0}, errors[STATE_NUMBERS];
    swSeaState state;
    swEstimateSeaState(bins, sums, &state);
    listState(&state, whole);
    for (int i = 0; i < groupCount; ++i)
    {
        double numbers[STATE_NUMBERS];
        leaveOut(sums, groups + i, sums + 1);
        swEstimateSeaState(bins, sums + 1, &state);
        listState(&state, numbers);
        for (int j = 0; j < STATE_NUMBERS; ++j)
        {
            double change = numbers[j] - whole[j];
            change = j == 5 || j == 6 ? remainder(change, 2.0 * SW_PI) : change;
            shift[j] += change / groupCount;
            square[j] += change * change / groupCount;
        }
    }
    for (int j = 0; j < STATE_NUMBERS; ++j)
    {
        double spread = fmax(square[j] - shift[j] * shift[j], 0.0);
        errors[j] = groupCount > 1 ? sqrt((groupCount - 1) * spread) : (double)NAN;
    }
    // The peak's place within its bin is not known: the deviation of what is evenly spread over the bin.
    int peak = swFindPeakBin(bins, sums);
    double within = (bins->high[peak] - bins->low[peak]) / (sqrt(12.0) * bins->center[peak] * bins->center[peak]);
    errors[1] = sqrt(errors[1] * errors[1] + within * within);
    *error = (swSeaState){.significantHeight = (float)errors[0],
                          .peakPeriod = (float)errors[1],
                          .periodTm01 = (float)errors[2],
                          .periodTm02 = (float)errors[3],
                          .energyPeriod = (float)errors[4],
                          .meanDirection = (float)errors[5],
                          .peakDirection = (float)errors[6],
                          .spread = (float)errors[7],
                          .meanSquareSlope = (float)errors[8]};
    swFree(host, sums, 2 * sizeof(swSeaSums));
    return SW_SUCCESS;
}
