// SPDX-License-Identifier: MIT
#pragma once

// How the waves of a band share out the energy of a spectrum's bins.

#include "core/spectra/spectrum.h"
#include "seaway/waves.h"

// The waves of a band on their lattice, [2 maxBin + 1][2 maxBin + 1] by qz, qx.
typedef struct swBandCells
{
    int maxBin;
    double* energy; // m^2
    int* bins;      // swFindCompiledBin() of each wave
} swBandCells;

static inline int swGetCellIndex(const swBandCells* cells, int qx, int qz)
{
    return (qz + cells->maxBin) * (2 * cells->maxBin + 1) + qx + cells->maxBin;
}

// Scale the waves so that those in a bin have the energy that the bin has in this band, and, of a table, its mean
// direction and spread. `wanted` is what swGetCompiledBins() found. Does not find waves where the cells have no energy:
// a bin that is too narrow to hold one leaves its energy to the next.
// Returns SW_ERROR_NO_MEMORY, or SW_ERROR_INVALID if no cell has energy.
swResult swShareBins(const swHost* host, const swCompiledSpectrum* spectrum, int binCount, const double* wanted,
                     swBandCells* cells);

// Says in the log how much of a table is in waves that are too long for any band, unless the def leaves them out
// anyhow.
void swWarnOfLongWaves(const swHost* host, const swWaveSystemDef* def, const swCompiledSpectrum* spectrum);
