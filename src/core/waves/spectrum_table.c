// SPDX-License-Identifier: MIT
// Tables of density by frequency and direction; how they are read between their nodes stands in spectrum.c.

#include "core/waves/compiled.h"

#include <math.h>

// Bins whose level and directions the tail takes over.
#define TAIL_BINS 4

swTablePlace swFindTablePlace(const swSpectrumTable* table, double frequency)
{
    int low = 0;
    int high = table->frequencyCount - 1;
    if (frequency <= (double)table->frequencies[0])
    {
        return (swTablePlace){0, 0.0};
    }
    if (frequency >= (double)table->frequencies[high])
    {
        return (swTablePlace){high - 1, 1.0};
    }
    while (high - low > 1)
    {
        int middle = (low + high) / 2;
        if ((double)table->frequencies[middle] <= frequency)
        {
            low = middle;
        }
        else
        {
            high = middle;
        }
    }
    double width = (double)table->frequencies[low + 1] - (double)table->frequencies[low];
    return (swTablePlace){low, (frequency - (double)table->frequencies[low]) / width};
}

int swGetTailBins(const swSpectrumTable* table)
{
    return table->frequencyCount < TAIL_BINS ? table->frequencyCount : TAIL_BINS;
}

// S(f), calibrated.
static double getFrequencyDensity(const swCompiledSpectrum* spectrum, double frequency)
{
    if (!(frequency >= spectrum->lowEdge))
    {
        return 0.0;
    }
    if (frequency > spectrum->highEdge)
    {
        double square = frequency * frequency;
        return spectrum->tailLevel / (square * square * frequency);
    }
    swTablePlace place = swFindTablePlace(&spectrum->table, frequency);
    const double* energy = spectrum->energy + place.index;
    return spectrum->scale * (energy[0] + place.fraction * (energy[1] - energy[0]));
}

double swGetTableDensity(const swCompiledSpectrum* spectrum, double omega)
{
    return getFrequencyDensity(spectrum, omega / SW_TURN) / SW_TURN;
}

// The table's density in one bin at a direction, not scaled.
static double getRowDensity(const swSpectrumTable* table, int row, double theta)
{
    const float* density = table->density + (size_t)row * (size_t)table->directionCount;
    double turns = (theta - (double)table->firstDirection) / SW_TURN;
    double position = (turns - floor(turns)) * table->directionCount;
    int first = (int)position;
    double fraction = position - first;
    first = first < table->directionCount ? first : 0; // turns rounded up to one
    int second = first + 1 < table->directionCount ? first + 1 : 0;
    return (double)density[first] + fraction * ((double)density[second] - (double)density[first]);
}

// D(f, theta) of the table: what S(f, theta) is there over its integral. 0 where there is no energy.
double swGetTableSpreading(const swCompiledSpectrum* spectrum, double frequency, double theta)
{
    const swSpectrumTable* table = &spectrum->table;
    double turned = theta - spectrum->direction;
    double density = 0.0;
    double total = 0.0;
    if (frequency > spectrum->highEdge)
    {
        for (int i = table->frequencyCount - swGetTailBins(table); i < table->frequencyCount; ++i)
        {
            density += getRowDensity(table, i, turned);
            total += spectrum->energy[i];
        }
    }
    else
    {
        swTablePlace place = swFindTablePlace(table, frequency);
        double keep = 1.0 - place.fraction;
        density = keep * getRowDensity(table, place.index, turned) +
                  place.fraction * getRowDensity(table, place.index + 1, turned);
        total = keep * spectrum->energy[place.index] + place.fraction * spectrum->energy[place.index + 1];
    }
    return total > 0.0 ? density / total : 0.0;
}

// Exact for variance: the density is linear in each piece.
void swIntegrateTable(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments)
{
    const swSpectrumTable* table = &spectrum->table;
    double begin = omega0 / SW_TURN;
    begin = begin > spectrum->lowEdge ? begin : spectrum->lowEdge;
    double last = omega1 / SW_TURN;
    double lastInside = last < spectrum->highEdge ? last : spectrum->highEdge;
    // Pieces: the outer half of the first bin, between the centres, the outer half of the last bin.
    for (int i = 0; i <= table->frequencyCount && begin < lastInside; ++i)
    {
        double end = i < table->frequencyCount ? (double)table->frequencies[i] : spectrum->highEdge;
        end = end < lastInside ? end : lastInside;
        if (end > begin)
        {
            swAddSpectrumPanel(moments, swGetTableDensity, spectrum, SW_TURN * begin, SW_TURN * end);
            begin = end;
        }
    }
    // The tail, in steps of a seventh.
    begin = omega0 / SW_TURN > spectrum->highEdge ? omega0 / SW_TURN : spectrum->highEdge;
    while (begin < last && spectrum->tailLevel > 0.0)
    {
        double end = 1.15 * begin < last ? 1.15 * begin : last;
        swAddSpectrumPanel(moments, swGetTableDensity, spectrum, SW_TURN * begin, SW_TURN * end);
        begin = end;
    }
}

// Variance of bins times widths.
static double getBinVariance(const swCompiledSpectrum* spectrum)
{
    double variance = 0.0;
    for (int i = 0; i < spectrum->table.frequencyCount; ++i)
    {
        variance += spectrum->energy[i] * (double)spectrum->table.bandwidths[i];
    }
    return variance;
}

bool swPrepareTable(swCompiledSpectrum* spectrum, const swSpectrumDef* def, swComplaint* complaint)
{
    const swSpectrumTable* table = def->table;
    int count = table->frequencyCount;
    spectrum->table = *table;
    spectrum->lowEdge = (double)table->frequencies[0] - 0.5 * (double)table->bandwidths[0];
    spectrum->highEdge = (double)table->frequencies[count - 1] + 0.5 * (double)table->bandwidths[count - 1];
    spectrum->scale = 1.0;
    double cell = SW_TURN / table->directionCount;
    for (int i = 0; i < count; ++i)
    {
        const float* row = table->density + (size_t)i * (size_t)table->directionCount;
        double sum = 0.0;
        for (int j = 0; j < table->directionCount; ++j)
        {
            sum += (double)row[j];
        }
        spectrum->energy[i] = sum * cell;
    }

    double variance = getBinVariance(spectrum);
    swSpectrumMoments moments = {0};
    swIntegrateTable(spectrum, 0.0, SW_TURN * spectrum->highEdge, &moments);
    if (!(variance > 1e-20 && moments.zero > 1e-20))
    {
        return swComplain(complaint, "The spectrum table has no energy: its variance is %g m^2.", variance);
    }
    double height = (double)def->significantHeight;
    double wanted = height > 0.0 ? height * height / 16.0 : variance;
    spectrum->scale = wanted / moments.zero;
    spectrum->binScale = wanted / variance;

    if (def->extendTail)
    {
        int bins = swGetTailBins(table);
        for (int i = count - bins; i < count; ++i)
        {
            double frequency = (double)table->frequencies[i];
            double square = frequency * frequency;
            spectrum->tailLevel += spectrum->scale * spectrum->energy[i] * square * square * frequency / bins;
        }
    }
    return true;
}
