// SPDX-License-Identifier: MIT
#pragma once

// What the truth tests share: findings (what was asked, what was measured, how much they may differ), and seas of many
// seeds that run side by side on all processors.
//
// A finding is printed and asserted. Where the environment variable SEAWAY_TRUTH_OUT names a folder, it is also written
// there, a line each to <program>.tsv; scripts/make_validation makes docs/validation.md of them. So a finding has to be
// the same on every machine: it is rounded to the digits that are given, and seeds are summed up in order.

#include "support/cmocka_setup.h"

#include <stdbool.h>
#include <stdio.h>

#include "seaway/measure.h"
#include "seaway/seaway.h"

#define DEGREE (SW_PI / 180.0)
#define TURN (2.0 * SW_PI)

// What a finding is about.
typedef struct Finding
{
    const char* number; // of the target: "V1"
    const char* what;   // a few words: "Hs of JONSWAP, 64 seeds"
    const char* source; // formula or paper: "Hs = 4 sqrt(m0)"
    const char* unit;   // "m", or "" for plain numbers
    int digits;         // after the point
} Finding;

// The name of the program, once, before anything is found.
void BeginTruth(const char* program);

// |measured - target| <= tolerance.
void FindNear(const Finding* finding, double target, double measured, double tolerance);

// |measured / target - 1| <= part.
void FindWithin(const Finding* finding, double target, double measured, double part);

// low <= measured <= high: a band of the literature.
void FindBetween(const Finding* finding, double low, double high, double measured);

// An error that is at most `limit`.
void FindBelow(const Finding* finding, double limit, double measured);

// Findings of data that is not part of the project: a line that may be absent. Off until switched on.
void MarkOptional(bool isOptional);

// Sanitizers and counters of coverage are slow: with them an eighth of the seeds, and tolerances of statistics are
// wider by `Loosen()`. Findings of such builds are not written to the file.
int Seeds(int count);
double Loosen(double tolerance);

// Call job(context, i) for i in [0, count), side by side.
typedef void TruthJob(void* context, int index);
void RunJobs(TruthJob* job, void* context, int count);

// A world with one system of waves, on one thread; fails the test if there is none. Destroy it with swDestroyWorld().
swWorld* CreateTruthSea(const swWaveSystemDef* def);

// A def with the spectrum's waves between two wavelengths, m.
swWaveSystemDef MakeWaves(const swSpectrumDef* spectrum, double shortest, double longest, uint32_t seed);

// A JONSWAP or Pierson-Moskowitz spectrum of height and peak period, going to `direction`.
swSpectrumDef MakeSpectrum(swSpectrumKind kind, double height, double period, double direction, double spreadExponent);

// Significant heights, 4 times the deviation, of seas with the def's waves and other seeds, into heights[seedCount]: of
// particles' heave, or of the surface above fixed places. Each is of so many heights, far apart in place and time.
#define HEIGHT_POINTS 256
#define HEIGHT_TIMES 16
#define HEIGHT_SAMPLES (HEIGHT_POINTS * HEIGHT_TIMES)
void MeasureHeights(const swWaveSystemDef* def, bool isSurface, int seedCount, double* heights);

// Places spread over a square of that side by chance, other ones for each `index`.
void ScatterPoints(double side, int index, int count, swPosXZ* points);
