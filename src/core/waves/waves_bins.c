// SPDX-License-Identifier: MIT
// The cell of a wave reaches across the edges of bins, and some bins are no wider than a cell. Left as they are, waves
// would carry energy from a bin that stands out to its neighbours, with their directions, and few waves would miss
// their bin's mean direction by some degrees. So the waves of each bin are scaled to the energy of that bin, and those
// of a table's bin are turned: each is multiplied by exp(c . d), d its direction as a unit vector, with the c for which
// the mean of d, weighted by energy, is the bin's own. Among all ways to give them that mean this changes them least,
// in the sense of relative entropy [Csiszar 1975]. Newton's method finds c: C times its change is what the mean is off,
// with the covariance C of d.

#include "core/waves/waves_bins.h"

#include <math.h>

#include "core/base/host.h"
#include "core/math/scalar.h"
#include "seaway/math.h"

// The longest wave of the last band, m, and the part of a table's variance in longer ones that is worth a warning.
#define LONGEST 4096.0
#define LOST_PART 0.005

#define TURN (2.0 * SW_PI)
#define MAX_STEPS 6

// A mean direction is found when it is off by less than this, some thousandths of a degree.
#define LEAST_OFF 1e-4

// Largest c, and largest change of it at once: a mean that no waves of the bin can have is not chased.
#define LARGEST_TURN 6.0
#define LARGEST_STEP 2.0

typedef struct BinShare
{
    double wanted;
    double x, z;         // mean of d that is wanted
    bool isTurned;       // ... and still sought
    double turnX, turnZ; // c

    // Sums of the waves' energies, times d, and times its products.
    double energy, sumX, sumZ, sumXX, sumXZ, sumZZ;
} BinShare;

static void getDirection(int qx, int qz, double* x, double* z)
{
    double length = sqrt((double)(qx * qx + qz * qz));
    *x = qx / length;
    *z = qz / length;
}

static double getTurn(const BinShare* share, double x, double z)
{
    bool isTurned = share->turnX != 0.0 || share->turnZ != 0.0;
    return isTurned ? swExp(share->turnX * x + share->turnZ * z) : 1.0;
}

static void sumBins(const swBandCells* cells, int binCount, BinShare* shares)
{
    for (int bin = 0; bin < binCount; ++bin)
    {
        BinShare* share = shares + bin;
        share->energy = share->sumX = share->sumZ = share->sumXX = share->sumXZ = share->sumZZ = 0.0;
    }
    for (int qz = -cells->maxBin; qz <= cells->maxBin; ++qz)
    {
        for (int qx = -cells->maxBin; qx <= cells->maxBin; ++qx)
        {
            int i = swGetCellIndex(cells, qx, qz);
            double energy = cells->energy[i], x, z;
            if (energy > 0.0)
            {
                BinShare* share = shares + cells->bins[i];
                getDirection(qx, qz, &x, &z);
                energy *= getTurn(share, x, z);
                share->energy += energy;
                share->sumX += energy * x;
                share->sumZ += energy * z;
                share->sumXX += energy * x * x;
                share->sumXZ += energy * x * z;
                share->sumZZ += energy * z * z;
            }
        }
    }
}

// Bins without waves leave their energy to the next one that has some; the last ones to the last that has. False if
// none has.
static bool moveRests(int binCount, BinShare* shares)
{
    int last = -1;
    double rest = 0.0;
    for (int bin = 0; bin < binCount; ++bin)
    {
        rest += shares[bin].wanted;
        shares[bin].wanted = 0.0;
        if (shares[bin].energy > 0.0)
        {
            shares[bin].wanted = rest;
            rest = 0.0;
            last = bin;
        }
    }
    if (last >= 0)
    {
        shares[last].wanted += rest;
    }
    return last >= 0;
}

static double limit(double value, double largest)
{
    return fmin(fmax(value, -largest), largest);
}

// One step of Newton's method. False once the mean is there, or cannot be moved.
static bool stepTurn(BinShare* share)
{
    double meanX = share->sumX / share->energy, meanZ = share->sumZ / share->energy;
    double xx = share->sumXX / share->energy - meanX * meanX;
    double xz = share->sumXZ / share->energy - meanX * meanZ;
    double zz = share->sumZZ / share->energy - meanZ * meanZ;
    double offX = share->x - meanX, offZ = share->z - meanZ;
    double determinant = xx * zz - xz * xz, trace = xx + zz;
    if (fmax(fabs(offX), fabs(offZ)) < LEAST_OFF || !(determinant > 1e-9 * trace * trace))
    {
        return false;
    }
    double stepX = limit((zz * offX - xz * offZ) / determinant, LARGEST_STEP);
    double stepZ = limit((xx * offZ - xz * offX) / determinant, LARGEST_STEP);
    share->turnX = limit(share->turnX + stepX, LARGEST_TURN);
    share->turnZ = limit(share->turnZ + stepZ, LARGEST_TURN);
    return true;
}

static void turnBins(const swBandCells* cells, int binCount, BinShare* shares)
{
    bool isSought = true;
    for (int step = 0; step < MAX_STEPS && isSought; ++step)
    {
        isSought = false;
        for (int bin = 0; bin < binCount; ++bin)
        {
            shares[bin].isTurned = shares[bin].isTurned && stepTurn(shares + bin);
            isSought = isSought || shares[bin].isTurned;
        }
        if (isSought)
        {
            sumBins(cells, binCount, shares);
        }
    }
}

static void scaleCells(const BinShare* shares, swBandCells* cells)
{
    for (int qz = -cells->maxBin; qz <= cells->maxBin; ++qz)
    {
        for (int qx = -cells->maxBin; qx <= cells->maxBin; ++qx)
        {
            int i = swGetCellIndex(cells, qx, qz);
            const BinShare* share = shares + cells->bins[i];
            double x, z;
            if (cells->energy[i] > 0.0)
            {
                getDirection(qx, qz, &x, &z);
                cells->energy[i] *= share->wanted / share->energy * getTurn(share, x, z);
            }
        }
    }
}

swResult swShareBins(const swHost* host, const swCompiledSpectrum* spectrum, int binCount, const double* wanted,
                     swBandCells* cells)
{
    size_t size = (size_t)binCount * sizeof(BinShare);
    BinShare* shares = swAllocateZero(host, size);
    if (shares == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    for (int bin = 0; bin < binCount; ++bin)
    {
        shares[bin].wanted = wanted[bin];
    }
    sumBins(cells, binCount, shares);
    bool hasWaves = moveRests(binCount, shares);
    for (int bin = 0; bin < binCount && hasWaves; ++bin)
    {
        BinShare* share = shares + bin;
        share->isTurned = share->wanted > 0.0 && swGetCompiledBinMean(spectrum, bin, &share->x, &share->z);
    }
    if (hasWaves)
    {
        turnBins(cells, binCount, shares);
        scaleCells(shares, cells);
    }
    swFree(host, shares, size);
    return hasWaves ? SW_SUCCESS : SW_ERROR_INVALID;
}

void swWarnOfLongWaves(const swHost* host, const swWaveSystemDef* def, const swCompiledSpectrum* spectrum)
{
    if (def->spectrum.kind != SW_SPECTRUM_TABLE || (double)def->maxWavelength < LONGEST)
    {
        return;
    }
    swDispersion dispersion = swGetCompiledDispersion(spectrum);
    double omega = swGetOmega(&dispersion, TURN / LONGEST);
    double lost = swIntegrateCompiled(spectrum, 0.0, omega);
    double part = lost / (lost + swIntegrateCompiled(spectrum, omega, TURN * 1000.0));
    if (part > LOST_PART)
    {
        swLog(host, SW_LOG_WARNING,
              "%.2g %% of a measured sea's variance is in waves longer than %g m, below %.3g Hz; they are left out.",
              100.0 * part, LONGEST, omega / TURN);
    }
}
