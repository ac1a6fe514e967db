// SPDX-License-Identifier: MIT
// Tables of density by frequency and direction, read so that every cell of the table keeps its own energy.
//
// A line through the densities of neighbouring bins would take a quarter of its energy from a bin that stands out.
// Instead the running integral over frequency is interpolated, for each direction by itself: a cubic through its values
// at the bins' edges that never falls [Fritsch and Carlson 1980], with the slopes of [Fritsch and Butland 1984]. Its
// derivative is the density, a parabola in each bin. It is continuous, nowhere negative, has the bin's mean m, and at
// the edges the values d0 and d1, harmonic means of both sides, so that the highest bin stays the highest:
//   S(t) = 6 t (1 - t) m + (1 - t) (1 - 3 t) d0 + t (3 t - 2) d1, t from 0 to 1 through the bin.
// As that holds for each direction, each bin keeps all moments of its directions. S(f) is the sum over directions, and
// as S is linear in m, d0 and d1, it has the same form with their sums.
// Around the circle the same is done with the densities that the directions have at one frequency.
//
// The first and the last bin go on to their outer edges as a line would, but rise no further.
// Above the last bin the density may go on as f^-5 [Phillips 1958], at the level and with the directions of the last
// few.

#include "core/spectra/compiled.h"

#include <math.h>

#include "core/base/assert.h"
#include "core/math/scalar.h"

// Bins whose level and directions the tail takes over.
#define TAIL_BINS 4

// ---- bins ----

static double clamp(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

// The end of bin i. Its begin and width say where that is, unless it is beyond all that may be meant: half-way to the
// next frequency, where this bin ends around its frequency, and where the next one begins around its own.
static double findEdge(const swSpectrumTable* table, int i, double begin)
{
    double here = (double)table->frequencies[i], width = (double)table->bandwidths[i];
    double wanted = begin + width, end = here + 0.5 * width;
    if (i + 1 == table->frequencyCount)
    {
        return wanted > here + 0.25 * width ? wanted : end;
    }
    double next = (double)table->frequencies[i + 1], gap = next - here;
    double middle = here + 0.5 * gap, start = next - 0.5 * (double)table->bandwidths[i + 1];
    double low = fmin(middle, fmin(end, start)), high = fmax(middle, fmax(end, start));
    return clamp(clamp(wanted, low, high), here + 0.05 * gap, next - 0.05 * gap);
}

void swSpectrumTable_GetEdges(const swSpectrumTable* table, double* edges)
{
    bool isValid = table != NULL && edges != NULL && table->frequencyCount > 0 && table->frequencies != NULL &&
                   table->bandwidths != NULL;
    SW_ASSERT(isValid);
    if (!isValid)
    {
        return;
    }
    edges[0] = fmax((double)table->frequencies[0] - 0.5 * (double)table->bandwidths[0], 0.0);
    for (int i = 0; i < table->frequencyCount; ++i)
    {
        edges[i + 1] = findEdge(table, i, edges[i]);
    }
}

int swFindTableBin(const swCompiledSpectrum* spectrum, double frequency)
{
    int low = 0, high = spectrum->table.frequencyCount; // of edges
    if (!(frequency >= spectrum->lowEdge))
    {
        return -1;
    }
    if (frequency > spectrum->highEdge)
    {
        return high;
    }
    while (high - low > 1)
    {
        int middle = (low + high) / 2;
        if (spectrum->edges[middle] <= frequency)
        {
            low = middle;
        }
        else
        {
            high = middle;
        }
    }
    return low;
}

double swGetBinFactor(const swCompiledSpectrum* spectrum, int bin)
{
    return (double)spectrum->table.bandwidths[bin] / (spectrum->edges[bin + 1] - spectrum->edges[bin]);
}

void swGetBinVector(const swCompiledSpectrum* spectrum, int bin, double* x, double* z)
{
    int count = spectrum->table.directionCount;
    const float* density = spectrum->table.density + (size_t)bin * (size_t)count;
    double scale = SW_TURN / count * swGetBinFactor(spectrum, bin);
    *x = *z = 0.0;
    for (int i = 0; i < count; ++i)
    {
        double angle = SW_TURN / count * i + (double)spectrum->table.firstDirection + spectrum->direction;
        *x += scale * (double)density[i] * swCos(angle);
        *z += scale * (double)density[i] * swSin(angle);
    }
}

int swGetTailBins(const swSpectrumTable* table)
{
    return table->frequencyCount < TAIL_BINS ? table->frequencyCount : TAIL_BINS;
}

// ---- parabolas ----

// A bin, or a cell of the circle: its mean and what it has at both edges.
typedef struct Piece
{
    double mean, first, last;
} Piece;

static double getPiece(const Piece* piece, double t)
{
    double value = 6.0 * t * (1.0 - t) * piece->mean + (1.0 - t) * (1.0 - 3.0 * t) * piece->first +
                   t * (3.0 * t - 2.0) * piece->last;
    return value > 0.0 ? value : 0.0; // but for rounding it is
}

// At the edge between bins of means a and b and those widths.
static double joinMeans(double a, double b, double widthA, double widthB)
{
    double share = (widthA + 2.0 * widthB) / (3.0 * (widthA + widthB));
    double sum = share * b + (1.0 - share) * a;
    return sum > 0.0 ? a * b / sum : 0.0;
}

// At the outer edge of a bin at the end.
static double endMean(double mean, double inner)
{
    return clamp(2.0 * mean - inner, 0.0, mean);
}

// Bin `bin` of one direction; not scaled.
static Piece makePiece(const swCompiledSpectrum* spectrum, int bin, int column)
{
    const swSpectrumTable* table = &spectrum->table;
    const double* edges = spectrum->edges + bin;
    const float* density = table->density + (size_t)bin * (size_t)table->directionCount + column;
    bool isFirst = bin == 0, isLast = bin + 1 == table->frequencyCount;
    double width = edges[1] - edges[0];
    Piece piece = {.mean = swGetBinFactor(spectrum, bin) * (double)density[0]};
    if (!isFirst)
    {
        double before = swGetBinFactor(spectrum, bin - 1) * (double)density[-table->directionCount];
        piece.first = joinMeans(before, piece.mean, edges[0] - edges[-1], width);
    }
    if (!isLast)
    {
        double behind = swGetBinFactor(spectrum, bin + 1) * (double)density[table->directionCount];
        piece.last = joinMeans(piece.mean, behind, width, edges[2] - edges[1]);
    }
    piece.first = isFirst ? endMean(piece.mean, piece.last) : piece.first;
    piece.last = isLast ? endMean(piece.mean, piece.first) : piece.last;
    return piece;
}

static Piece sumPieces(const swCompiledSpectrum* spectrum, int bin)
{
    return (Piece){spectrum->energy[bin], spectrum->edgeEnergy[bin], spectrum->edgeEnergy[bin + 1]};
}

// Where in its bin a frequency lies.
static double findPart(const swCompiledSpectrum* spectrum, int bin, double frequency)
{
    const double* edges = spectrum->edges + bin;
    return clamp((frequency - edges[0]) / (edges[1] - edges[0]), 0.0, 1.0);
}

double swGetBinPart(const swCompiledSpectrum* spectrum, int bin, double frequency0, double frequency1)
{
    Piece piece = sumPieces(spectrum, bin);
    double sums[2], ends[2] = {findPart(spectrum, bin, frequency0), findPart(spectrum, bin, frequency1)};
    for (int i = 0; i < 2; ++i)
    {
        double t = ends[i];
        sums[i] = t * t * (3.0 - 2.0 * t) * piece.mean + t * (1.0 - t) * (1.0 - t) * piece.first +
                  t * t * (t - 1.0) * piece.last;
    }
    return piece.mean > 0.0 && ends[1] > ends[0] ? (sums[1] - sums[0]) / piece.mean : 0.0;
}

// ---- densities ----

double swGetTableDensity(const swCompiledSpectrum* spectrum, double omega)
{
    double frequency = omega / SW_TURN;
    int bin = swFindTableBin(spectrum, frequency);
    if (bin < 0)
    {
        return 0.0;
    }
    if (bin == spectrum->table.frequencyCount)
    {
        double square = frequency * frequency;
        return spectrum->tailLevel / (square * square * frequency * SW_TURN);
    }
    Piece piece = sumPieces(spectrum, bin);
    return spectrum->scale * getPiece(&piece, findPart(spectrum, bin, frequency)) / SW_TURN;
}

// One direction's density at a frequency; above the last bin that of the tail's bins together. Not scaled.
static double getColumn(const swCompiledSpectrum* spectrum, int bin, double part, int column)
{
    const swSpectrumTable* table = &spectrum->table;
    int count = table->directionCount;
    column = column < 0 ? column + count : column < count ? column : column - count;
    if (bin < table->frequencyCount)
    {
        Piece piece = makePiece(spectrum, bin, column);
        return getPiece(&piece, part);
    }
    double sum = 0.0;
    for (int i = table->frequencyCount - swGetTailBins(table); i < table->frequencyCount; ++i)
    {
        sum += swGetBinFactor(spectrum, i) * (double)table->density[(size_t)i * (size_t)count + (size_t)column];
    }
    return sum;
}

// What the tail's columns have to be multiplied by.
static double getTailScale(const swCompiledSpectrum* spectrum, double omega)
{
    int count = spectrum->table.frequencyCount;
    double sum = 0.0;
    for (int i = count - swGetTailBins(&spectrum->table); i < count; ++i)
    {
        sum += spectrum->energy[i];
    }
    return sum > 0.0 ? swGetTableDensity(spectrum, omega) / sum : 0.0;
}

double swGetTableDensity2(const swCompiledSpectrum* spectrum, double omega, double theta)
{
    const swSpectrumTable* table = &spectrum->table;
    double frequency = omega / SW_TURN;
    int bin = swFindTableBin(spectrum, frequency);
    bool isTail = bin == table->frequencyCount;
    if (bin < 0 || (isTail && !(spectrum->tailLevel > 0.0)))
    {
        return 0.0;
    }
    double turns = (theta - spectrum->direction - (double)table->firstDirection) / SW_TURN;
    double place = (turns - floor(turns)) * table->directionCount + 0.5; // cells reach half a step to either side
    int column = (int)place;
    double part = isTail ? 0.0 : findPart(spectrum, bin, frequency);
    double before = getColumn(spectrum, bin, part, column - 1);
    double here = getColumn(spectrum, bin, part, column);
    double behind = getColumn(spectrum, bin, part, column + 1);
    Piece cell = {here, joinMeans(before, here, 1.0, 1.0), joinMeans(here, behind, 1.0, 1.0)};
    double scale = isTail ? getTailScale(spectrum, omega) : spectrum->scale / SW_TURN;
    return scale * getPiece(&cell, place - column);
}

// Exact for variance: the density is a parabola in each piece.
void swIntegrateTable(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments)
{
    double begin = omega0 / SW_TURN;
    begin = begin > spectrum->lowEdge ? begin : spectrum->lowEdge;
    double last = omega1 / SW_TURN;
    double lastInside = last < spectrum->highEdge ? last : spectrum->highEdge;
    for (int i = 1; i <= spectrum->table.frequencyCount && begin < lastInside; ++i)
    {
        double end = spectrum->edges[i] < lastInside ? spectrum->edges[i] : lastInside;
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

// ---- preparing ----

// Sums over all directions of each bin's mean and edges.
static void sumDirections(swCompiledSpectrum* spectrum)
{
    int count = spectrum->table.directionCount;
    double cell = SW_TURN / count;
    for (int i = 0; i < spectrum->table.frequencyCount; ++i)
    {
        Piece sum = {0};
        for (int j = 0; j < count; ++j)
        {
            Piece piece = makePiece(spectrum, i, j);
            sum.mean += piece.mean;
            sum.first += piece.first;
            sum.last += piece.last;
        }
        spectrum->energy[i] = sum.mean * cell;
        spectrum->edgeEnergy[i] = sum.first * cell;
        spectrum->edgeEnergy[i + 1] = sum.last * cell; // what the next bin has at its first edge
    }
}

static double sumVariance(const swCompiledSpectrum* spectrum)
{
    double variance = 0.0;
    for (int i = 0; i < spectrum->table.frequencyCount; ++i)
    {
        variance += spectrum->energy[i] * (spectrum->edges[i + 1] - spectrum->edges[i]);
    }
    return variance;
}

bool swPrepareTable(swCompiledSpectrum* spectrum, const swSpectrumDef* def, swComplaint* complaint)
{
    const swSpectrumTable* table = def->table;
    int count = table->frequencyCount;
    spectrum->table = *table;
    swSpectrumTable_GetEdges(table, spectrum->edges);
    spectrum->lowEdge = spectrum->edges[0];
    spectrum->highEdge = spectrum->edges[count];
    sumDirections(spectrum);
    double variance = sumVariance(spectrum);
    if (!(variance > 1e-20))
    {
        return swComplain(complaint, "The spectrum table has no energy: its variance is %g m^2.", variance);
    }
    double height = (double)def->significantHeight;
    spectrum->scale = height > 0.0 ? height * height / (16.0 * variance) : 1.0;

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
