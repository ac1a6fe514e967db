// SPDX-License-Identifier: MIT
// A height, a peak and an average period Tm02 leave the shape of a spectrum open. Here it is, with x = f / f_peak,
//
//   E(f) ~ x^-n exp(-n/4 x^-4) gamma^b(x) + shelf p(x),
//
// which is JONSWAP's [Hasselmann 1973] for n = 5 and without a shelf, and has its peak at x = 1 whatever n and gamma
// are. On the way from the usual shape (0) to 1, gamma grows to 20: less energy away from the peak, and Tm02 comes
// near the peak's period. Beyond 1, longer waves stand beside the peak up to 0.85 of its density, and Tm02 grows
// beyond the peak's period. On the way to -1, gamma first falls to 1, then n to 1.5: short waves of a wind sea upon a
// swell, which one system does not tell apart, and Tm02 falls to less than half of the peak's period. Of two systems
// the shorter one's tail changes, then beyond -1 the longer one's, and gamma does not fall: two broad peaks would
// become one between them. Longer waves stand beside the longer one. Tm02 grows along the way, so that halving finds
// it.

#include "core/records/summary_shape.h"

#include <math.h>

#include "core/math/scalar.h"

#define MOST_GAMMA 20.0
#define USUAL_TAIL 5.0
#define LEAST_TAIL 1.5
#define TAIL_FROM (-0.25) // there gamma is 1, and the tail begins to change
#define MOST_SHELF 0.85

// Where the shelf begins, is whole, begins to end and ends, in parts of the peak's frequency.
static const double s_shelf[4] = {0.33, 0.45, 0.85, 1.0};

static double getPlateau(double ratio)
{
    if (ratio <= s_shelf[0] || ratio >= s_shelf[3])
    {
        return 0.0;
    }
    double rise = (ratio - s_shelf[0]) / (s_shelf[1] - s_shelf[0]);
    double fall = (s_shelf[3] - ratio) / (s_shelf[3] - s_shelf[2]);
    double part = rise < fall ? rise : fall;
    return part < 1.0 ? part * part * (3.0 - 2.0 * part) : 1.0;
}

void swPrepareShape(swShape* shape, const float* frequencies)
{
    for (int i = 0; i < SW_SHAPE_FREQUENCIES; ++i)
    {
        double ratio = (double)frequencies[i] / shape->peak;
        double offset = (ratio - 1.0) / (ratio > 1.0 ? 0.09 : 0.07);
        shape->logarithm[i] = swLn(ratio);
        shape->cut[i] = 0.25 / (ratio * ratio * ratio * ratio);
        shape->bump[i] = swExp(-0.5 * offset * offset);
        shape->plateau[i] = getPlateau(ratio);
    }
}

// Between two numbers as far as `way` is from `from` to `to`.
static double mix(double begin, double end, double way, double from, double to)
{
    double part = (way - from) / (to - from);
    return begin + (end - begin) * (part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part);
}

static void choose(swShape* shape, double way, bool isAlone, bool isLongest, bool isShortest)
{
    double usual = swLn(shape->usualGamma);
    double logarithm = way > 0.0 ? mix(usual, swLn(MOST_GAMMA), way, 0.0, 1.0)
                       : isAlone ? mix(usual, 0.0, way, 0.0, TAIL_FROM)
                                 : usual;
    shape->gamma = swExp(logarithm);
    shape->tail = isAlone      ? mix(USUAL_TAIL, LEAST_TAIL, way, TAIL_FROM, -1.0)
                  : isShortest ? mix(USUAL_TAIL, LEAST_TAIL, way, 0.0, -1.0)
                               : mix(USUAL_TAIL, LEAST_TAIL, way, -1.0, SW_SHAPE_LEAST);
    shape->shelf = isLongest ? mix(0.0, MOST_SHELF, way, 1.0, SW_SHAPE_MOST) : 0.0;
}

static void fillShape(swShape* shape, const float* widths)
{
    double logGamma = swLn(shape->gamma), variance = 0.0;
    double level = shape->shelf * swExp(logGamma - 0.25 * shape->tail);
    for (int i = 0; i < SW_SHAPE_FREQUENCIES; ++i)
    {
        shape->energy[i] = swExp(logGamma * shape->bump[i] - shape->tail * (shape->logarithm[i] + shape->cut[i])) +
                           level * shape->plateau[i];
        variance += shape->energy[i] * (double)widths[i];
    }
    double scale = shape->height * shape->height / (16.0 * variance);
    for (int i = 0; i < SW_SHAPE_FREQUENCIES; ++i)
    {
        shape->energy[i] *= scale;
    }
}

void swFillShapes(swShape* shapes, int count, double way, const float* widths)
{
    for (int i = 0; i < count; ++i)
    {
        bool isAlone = count == 1;
        bool isLongest = isAlone || shapes[i].peak <= shapes[1 - i].peak;
        choose(&shapes[i], way, isAlone, isLongest, isAlone || !isLongest);
        fillShape(&shapes[i], widths);
    }
}

double swGetAveragePeriod(const swShape* shapes, int count, const float* frequencies, const float* widths)
{
    double zero = 0.0, two = 0.0;
    for (int j = 0; j < count; ++j)
    {
        for (int i = 0; i < SW_SHAPE_FREQUENCIES; ++i)
        {
            double variance = shapes[j].energy[i] * (double)widths[i];
            zero += variance;
            two += variance * (double)frequencies[i] * (double)frequencies[i];
        }
    }
    return sqrt(zero / two);
}

double swFitShapes(swShape* shapes, int count, double period, double most, const float* frequencies,
                   const float* widths)
{
    double low = SW_SHAPE_LEAST, high = most, found = 0.0;
    for (int round = 0; round < 18; ++round)
    {
        double way = 0.5 * (low + high);
        swFillShapes(shapes, count, way, widths);
        found = swGetAveragePeriod(shapes, count, frequencies, widths);
        low = found < period ? way : low;
        high = found < period ? high : way;
    }
    return found;
}
