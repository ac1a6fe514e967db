// SPDX-License-Identifier: MIT
// Directional wave spectra. Inside, densities are over angular frequency, S(omega) = S(f) / (2 pi).
//
// JONSWAP [Hasselmann 1973]:
//   S = alpha g^2 omega^-5 exp(-5/4 (omega_p / omega)^4) gamma^exp(-(omega - omega_p)^2 / (2 sigma^2 omega_p^2)),
//   sigma = 0.07 up to omega_p and 0.09 above, alpha = 0.076 (U^2 / (F g))^0.22, omega_p = 22 (g^2 / (U F))^(1/3).
// Pierson-Moskowitz [Pierson 1964]:
//   S = 0.0081 g^2 omega^-5 exp(-0.74 (g / (U19.5 omega))^4), with the wind at 19.5 m taken as 1.026 U10: the same shape
//   with gamma = 1 and omega_p = (0.8 * 0.74)^(1/4) g / U19.5.
// Table: runs linearly between the centres of its frequency bins and between its directions, is constant in the outer
// halves of the first and last bin, and is scaled so that its variance is exactly the sum of density times bandwidth.
// Above the last bin it may go on as f^-5 [Phillips 1958], at the level and with the directions of the last few bins.

#include "core/waves/spectrum.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/assert.h"
#include "core/base/host.h"
#include "core/math/scalar.h"
#include "core/waves/spreading.h"

#define SPECTRUM_COOKIE 0x5350

#define MIN_FREQUENCIES 2
#define MAX_FREQUENCIES 1024
#define MIN_DIRECTIONS 4
#define MAX_DIRECTIONS 720

// Bins whose level and directions the tail takes over.
#define TAIL_BINS 4

// Formulas are integrated up to this where no limit is asked for: waves of 6 cm, the shortest band.
#define MAX_FORMULA_FREQUENCY 5.0

#define STANDARD_GRAVITY 9.81

#define TURN (2.0 * SW_PI)

struct swCompiledSpectrum
{
    swSpectrumKind kind;
    double direction; // mean direction of a formula; what a table turns by

    // Formulas.
    double level; // alpha g^2, rescaled to the significant height
    double peakOmega;
    double gamma;
    double spreadExponent;
    double spreadScale;

    // Tables; frequencies in Hz.
    swSpectrumTable table;
    double scale;                   // from the table's density to calibrated density
    double binScale;                // the same where bins are summed by their widths instead of integrated
    double lowEdge;                 // of the first bin
    double highEdge;                // of the last bin, where the tail begins
    double tailLevel;               // S(f) = tailLevel f^-5, calibrated; 0 without tail
    double energy[MAX_FREQUENCIES]; // of each bin, all directions, not yet scaled

    // Owned copy of the table, if any.
    void* memory;
    size_t memorySize;
};

swSpectrumDef swDefaultSpectrumDef(void)
{
    swSpectrumDef def = {0};
    def.kind = SW_SPECTRUM_JONSWAP;
    def.windSpeed = 10.0f;
    def.fetch = 300e3f;
    def.gamma = 3.3f;
    def.spreadExponent = 8.0f;
    def.extendTail = true;
    def.internalValue = SPECTRUM_COOKIE;
    return def;
}

// ---- checks ----

typedef struct Complaint
{
    char text[256];
} Complaint;

SW_PRINTF(2, 3) static bool complain(Complaint* complaint, const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(complaint->text, sizeof(complaint->text), format, arguments);
    va_end(arguments);
    return false;
}

static bool checkRange(Complaint* complaint, const char* field, float value, double low, double high, bool openLow)
{
    double x = (double)value;
    if ((openLow ? x > low : x >= low) && x <= high)
    {
        return true; // false for NaN
    }
    return complain(complaint, "The spectrum's %s is %g; its range is %s%g, %g].", field, x, openLow ? "(" : "[", low,
                    high);
}

static bool checkFrequencies(Complaint* complaint, const swSpectrumTable* table)
{
    for (int i = 0; i < table->frequencyCount; ++i)
    {
        double frequency = (double)table->frequencies[i];
        double before = i > 0 ? (double)table->frequencies[i - 1] : 0.0;
        if (!(frequency > before && frequency <= 1000.0))
        {
            return complain(complaint,
                            "The spectrum table's frequency %d is %g Hz; it must be above %g and at most 1000.", i,
                            frequency, before);
        }
        double width = (double)table->bandwidths[i];
        double widest = i == 0 ? 2.0 * frequency : 1000.0; // the first bin begins at 0 or above
        if (!(width > 0.0 && width <= widest))
        {
            return complain(complaint, "The spectrum table's bandwidth %d is %g Hz; its range is (0, %g].", i, width,
                            widest);
        }
    }
    return true;
}

static bool checkTable(Complaint* complaint, const swSpectrumTable* table)
{
    if (table == NULL || table->frequencies == NULL || table->bandwidths == NULL || table->density == NULL)
    {
        return complain(complaint, "The spectrum is a table, but its table or one of the table's arrays is NULL.");
    }
    if (table->frequencyCount < MIN_FREQUENCIES || table->frequencyCount > MAX_FREQUENCIES)
    {
        return complain(complaint, "The spectrum table has %d frequencies; its range is [%d, %d].",
                        table->frequencyCount, MIN_FREQUENCIES, MAX_FREQUENCIES);
    }
    if (table->directionCount < MIN_DIRECTIONS || table->directionCount > MAX_DIRECTIONS)
    {
        return complain(complaint, "The spectrum table has %d directions; its range is [%d, %d].",
                        table->directionCount, MIN_DIRECTIONS, MAX_DIRECTIONS);
    }
    if (!checkFrequencies(complaint, table))
    {
        return false;
    }
    int count = table->frequencyCount * table->directionCount;
    for (int i = 0; i < count; ++i)
    {
        if (!(table->density[i] >= 0.0f && table->density[i] <= 1e6f))
        {
            return complain(complaint,
                            "The spectrum table's density at frequency %d, direction %d is %g m^2/Hz/rad; its range is "
                            "[0, 1e6].",
                            i / table->directionCount, i % table->directionCount, (double)table->density[i]);
        }
    }
    return true;
}

static bool checkDef(Complaint* complaint, const swSpectrumDef* def)
{
    if ((int)def->kind < 0 || def->kind >= SW_SPECTRUM_KIND_COUNT)
    {
        return complain(complaint, "The spectrum's kind is %d; its range is [0, %d].", (int)def->kind,
                        SW_SPECTRUM_KIND_COUNT - 1);
    }
    if (!checkRange(complaint, "significantHeight", def->significantHeight, 0.0, 40.0, false) ||
        !checkRange(complaint, "direction", def->direction, -1000.0, 1000.0, false))
    {
        return false;
    }
    if (def->kind == SW_SPECTRUM_TABLE)
    {
        return checkTable(complaint, def->table);
    }
    if (!checkRange(complaint, "windSpeed", def->windSpeed, 0.0, 100.0, true) ||
        !checkRange(complaint, "peakPeriod", def->peakPeriod, 0.0, 60.0, false) ||
        !checkRange(complaint, "spreadExponent", def->spreadExponent, 0.0, 200.0, false))
    {
        return false;
    }
    return def->kind != SW_SPECTRUM_JONSWAP || (checkRange(complaint, "fetch", def->fetch, 1e3, 1e7, false) &&
                                                checkRange(complaint, "gamma", def->gamma, 1.0, 10.0, false));
}

// ---- quadrature ----

// Nodes and weights of Gauss-Legendre on [-1, 1], order 8, the positive half.
static const double gaussNodes[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
static const double gaussWeights[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

// What is integrated together over omega: S times 1/omega, 1, omega, omega^2, omega^4.
enum
{
    MOMENT_MINUS_ONE,
    MOMENT_ZERO,
    MOMENT_ONE,
    MOMENT_TWO,
    MOMENT_FOUR,
    MOMENT_COUNT
};

static void addMoments(double moments[MOMENT_COUNT], double omega, double variance)
{
    moments[MOMENT_MINUS_ONE] += variance / omega;
    moments[MOMENT_ZERO] += variance;
    moments[MOMENT_ONE] += variance * omega;
    moments[MOMENT_TWO] += variance * omega * omega;
    moments[MOMENT_FOUR] += variance * omega * omega * omega * omega;
}

// ---- formulas ----

static double getFormulaDensity(const swCompiledSpectrum* spectrum, double omega)
{
    double ratio = spectrum->peakOmega / omega;
    if (!(omega > 0.0) || ratio > 5.0)
    {
        return 0.0; // exp(-781)
    }
    double ratio4 = ratio * ratio * ratio * ratio;
    double exponent = -1.25 * ratio4;
    if (spectrum->gamma > 1.0)
    {
        double sigma = omega <= spectrum->peakOmega ? 0.07 : 0.09;
        double distance = (omega - spectrum->peakOmega) / (sigma * spectrum->peakOmega);
        exponent += swLn(spectrum->gamma) * swExp(-0.5 * distance * distance);
    }
    double omega2 = omega * omega;
    return spectrum->level / (omega2 * omega2 * omega) * swExp(exponent);
}

// Where the panel that starts at omega ends: narrow where the density climbs by exp(-5/4 x^-4), 0.05 of the peak's
// frequency around the peak, then growing with omega. Order 8 on these is good to 1e-9.
static double getPanelEnd(const swCompiledSpectrum* spectrum, double omega)
{
    double x = omega / spectrum->peakOmega;
    double step = 0.05;
    if (x < 0.7)
    {
        step = 0.3 * x * x * x * x * x;
    }
    else if (x > 1.5)
    {
        step = 0.15 * x;
    }
    double end = x + step;
    if (x < 1.0 && end > 1.0)
    {
        end = 1.0; // sigma changes here
    }
    return end * spectrum->peakOmega;
}

static void integrateFormula(const swCompiledSpectrum* spectrum, double omega0, double omega1,
                             double moments[MOMENT_COUNT])
{
    double begin = omega0 > 0.2 * spectrum->peakOmega ? omega0 : 0.2 * spectrum->peakOmega;
    while (begin < omega1)
    {
        double end = getPanelEnd(spectrum, begin);
        end = end < omega1 ? end : omega1;
        double middle = 0.5 * (begin + end);
        double half = 0.5 * (end - begin);
        for (int i = 0; i < 4; ++i)
        {
            double low = middle - half * gaussNodes[i];
            double high = middle + half * gaussNodes[i];
            addMoments(moments, low, half * gaussWeights[i] * getFormulaDensity(spectrum, low));
            addMoments(moments, high, half * gaussWeights[i] * getFormulaDensity(spectrum, high));
        }
        begin = end;
    }
}

static double getFormulaVariance(const swCompiledSpectrum* spectrum)
{
    // From 20 peak frequencies on the density is level omega^-5 within 1e-5, and holds 1e-5 of the variance.
    double end = 20.0 * spectrum->peakOmega;
    double moments[MOMENT_COUNT] = {0};
    integrateFormula(spectrum, 0.0, end, moments);
    return moments[MOMENT_ZERO] + 0.25 * spectrum->level / (end * end * end * end);
}

static void prepareFormula(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity)
{
    double wind = (double)def->windSpeed;
    double alpha = 0.0081;
    spectrum->gamma = 1.0;
    if (def->kind == SW_SPECTRUM_JONSWAP)
    {
        double fetch = (double)def->fetch;
        alpha = 0.076 * swPow(wind * wind / (fetch * gravity), 0.22);
        spectrum->peakOmega = 22.0 * swPow(gravity * gravity / (wind * fetch), 1.0 / 3.0);
        spectrum->gamma = (double)def->gamma;
    }
    else
    {
        spectrum->peakOmega = sqrt(sqrt(0.8 * 0.74)) * gravity / (1.026 * wind);
    }
    if (def->peakPeriod > 0.0f)
    {
        spectrum->peakOmega = TURN / (double)def->peakPeriod;
    }
    spectrum->level = alpha * gravity * gravity;
    if (def->significantHeight > 0.0f)
    {
        double height = (double)def->significantHeight;
        spectrum->level *= height * height / (16.0 * getFormulaVariance(spectrum));
    }
    spectrum->spreadExponent = (double)def->spreadExponent;
    spectrum->spreadScale = swGetCosineSpreadScale(spectrum->spreadExponent);
}

// ---- tables ----

// A frequency between the centres of bins `index` and `index` + 1, a fraction of the way. Outside: the nearest centre.
typedef struct Place
{
    int index;
    double fraction;
} Place;

static Place findPlace(const swSpectrumTable* table, double frequency)
{
    int low = 0;
    int high = table->frequencyCount - 1;
    if (frequency <= (double)table->frequencies[0])
    {
        return (Place){0, 0.0};
    }
    if (frequency >= (double)table->frequencies[high])
    {
        return (Place){high - 1, 1.0};
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
    return (Place){low, (frequency - (double)table->frequencies[low]) / width};
}

static int getTailBins(const swSpectrumTable* table)
{
    return table->frequencyCount < TAIL_BINS ? table->frequencyCount : TAIL_BINS;
}

// S(f), calibrated.
static double getTableDensity(const swCompiledSpectrum* spectrum, double frequency)
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
    Place place = findPlace(&spectrum->table, frequency);
    const double* energy = spectrum->energy + place.index;
    return spectrum->scale * (energy[0] + place.fraction * (energy[1] - energy[0]));
}

// The table's density in one bin at a direction, not scaled.
static double getRowDensity(const swSpectrumTable* table, int row, double theta)
{
    const float* density = table->density + (size_t)row * (size_t)table->directionCount;
    double turns = theta / TURN;
    double position = (turns - floor(turns)) * table->directionCount;
    int first = (int)position;
    double fraction = position - first;
    first = first < table->directionCount ? first : 0; // turns rounded up to one
    int second = first + 1 < table->directionCount ? first + 1 : 0;
    return (double)density[first] + fraction * ((double)density[second] - (double)density[first]);
}

// D(f, theta) of the table: what S(f, theta) is there over its integral. 0 where there is no energy.
static double getTableSpreading(const swCompiledSpectrum* spectrum, double frequency, double theta)
{
    const swSpectrumTable* table = &spectrum->table;
    double turned = theta - spectrum->direction;
    double density = 0.0;
    double total = 0.0;
    if (frequency > spectrum->highEdge)
    {
        for (int i = table->frequencyCount - getTailBins(table); i < table->frequencyCount; ++i)
        {
            density += getRowDensity(table, i, turned);
            total += spectrum->energy[i];
        }
    }
    else
    {
        Place place = findPlace(table, frequency);
        double keep = 1.0 - place.fraction;
        density = keep * getRowDensity(table, place.index, turned) +
                  place.fraction * getRowDensity(table, place.index + 1, turned);
        total = keep * spectrum->energy[place.index] + place.fraction * spectrum->energy[place.index + 1];
    }
    return total > 0.0 ? density / total : 0.0;
}

// Exact for variance: the density is linear in each piece.
static void integrateTable(const swCompiledSpectrum* spectrum, double omega0, double omega1,
                           double moments[MOMENT_COUNT])
{
    const swSpectrumTable* table = &spectrum->table;
    double begin = omega0 / TURN;
    begin = begin > spectrum->lowEdge ? begin : spectrum->lowEdge;
    double last = omega1 / TURN;
    double lastInside = last < spectrum->highEdge ? last : spectrum->highEdge;
    // Pieces: the outer half of the first bin, between the centres, the outer half of the last bin.
    for (int i = 0; i <= table->frequencyCount && begin < lastInside; ++i)
    {
        double end = i < table->frequencyCount ? (double)table->frequencies[i] : spectrum->highEdge;
        end = end < lastInside ? end : lastInside;
        double half = 0.5 * (end - begin);
        for (int j = 0; j < 8 && half > 0.0; ++j)
        {
            double node = j < 4 ? -gaussNodes[3 - j] : gaussNodes[j - 4];
            double frequency = begin + half + half * node;
            double weight = gaussWeights[j < 4 ? 3 - j : j - 4];
            addMoments(moments, TURN * frequency, half * weight * getTableDensity(spectrum, frequency));
        }
        begin = end > begin ? end : begin;
    }
    double tailBegin = omega0 / TURN > spectrum->highEdge ? omega0 / TURN : spectrum->highEdge;
    if (last > tailBegin && spectrum->tailLevel > 0.0)
    {
        // Integrals of c f^-5 f^n, and powers of 2 pi as the moments are over omega.
        double a = tailBegin;
        double b = last;
        double level = spectrum->tailLevel;
        moments[MOMENT_MINUS_ONE] += level / 5.0 * (1.0 / (a * a * a * a * a) - 1.0 / (b * b * b * b * b)) / TURN;
        moments[MOMENT_ZERO] += level / 4.0 * (1.0 / (a * a * a * a) - 1.0 / (b * b * b * b));
        moments[MOMENT_ONE] += level / 3.0 * (1.0 / (a * a * a) - 1.0 / (b * b * b)) * TURN;
        moments[MOMENT_TWO] += level / 2.0 * (1.0 / (a * a) - 1.0 / (b * b)) * TURN * TURN;
        moments[MOMENT_FOUR] += level * swLn(b / a) * TURN * TURN * TURN * TURN;
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

static bool prepareTable(swCompiledSpectrum* spectrum, const swSpectrumDef* def, Complaint* complaint)
{
    const swSpectrumTable* table = def->table;
    int count = table->frequencyCount;
    spectrum->table = *table;
    spectrum->lowEdge = (double)table->frequencies[0] - 0.5 * (double)table->bandwidths[0];
    spectrum->highEdge = (double)table->frequencies[count - 1] + 0.5 * (double)table->bandwidths[count - 1];
    spectrum->scale = 1.0;
    double cell = TURN / table->directionCount;
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
    double moments[MOMENT_COUNT] = {0};
    integrateTable(spectrum, 0.0, TURN * spectrum->highEdge, moments);
    if (!(variance > 1e-20 && moments[MOMENT_ZERO] > 1e-20))
    {
        return complain(complaint, "The spectrum table has no energy: its variance is %g m^2.", variance);
    }
    double height = (double)def->significantHeight;
    double wanted = height > 0.0 ? height * height / 16.0 : variance;
    spectrum->scale = wanted / moments[MOMENT_ZERO];
    spectrum->binScale = wanted / variance;

    if (def->extendTail)
    {
        int bins = getTailBins(table);
        for (int i = count - bins; i < count; ++i)
        {
            double frequency = (double)table->frequencies[i];
            double square = frequency * frequency;
            spectrum->tailLevel += spectrum->scale * spectrum->energy[i] * square * square * frequency / bins;
        }
    }
    return true;
}

// Everything but copying: a table stays the caller's.
static bool prepare(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity, Complaint* complaint)
{
    SW_ASSERT(def->internalValue == SPECTRUM_COOKIE);
    memset(spectrum, 0, sizeof(*spectrum));
    if (def->internalValue != SPECTRUM_COOKIE)
    {
        return complain(complaint, "The spectrum was not initialized with swDefaultSpectrumDef().");
    }
    if (!checkDef(complaint, def))
    {
        return false;
    }
    spectrum->kind = def->kind;
    spectrum->direction = (double)def->direction;
    if (def->kind == SW_SPECTRUM_TABLE)
    {
        return prepareTable(spectrum, def, complaint);
    }
    prepareFormula(spectrum, def, gravity);
    return true;
}

// ---- compiled spectra ----

static swResult copyTable(const swHost* host, swCompiledSpectrum* spectrum)
{
    swSpectrumTable* table = &spectrum->table;
    size_t frequencyCount = (size_t)table->frequencyCount;
    size_t densityCount = frequencyCount * (size_t)table->directionCount;
    spectrum->memorySize = (2 * frequencyCount + densityCount) * sizeof(float);
    float* memory = swAllocate(host, spectrum->memorySize);
    if (memory == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for a spectrum table of %zu bytes.", spectrum->memorySize);
    }
    memcpy(memory, table->frequencies, frequencyCount * sizeof(float));
    memcpy(memory + frequencyCount, table->bandwidths, frequencyCount * sizeof(float));
    memcpy(memory + 2 * frequencyCount, table->density, densityCount * sizeof(float));
    table->frequencies = memory;
    table->bandwidths = memory + frequencyCount;
    table->density = memory + 2 * frequencyCount;
    spectrum->memory = memory;
    return SW_SUCCESS;
}

swResult swCompileSpectrum(const swHost* host, const swSpectrumDef* def, double gravity, swCompiledSpectrum** spectrum)
{
    *spectrum = NULL;
    swCompiledSpectrum* compiled = swAllocate(host, sizeof(*compiled));
    if (compiled == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for a spectrum of %zu bytes.", sizeof(*compiled));
    }
    Complaint complaint;
    swResult result = SW_SUCCESS;
    if (!prepare(compiled, def, gravity, &complaint))
    {
        result = swFail(host, SW_ERROR_INVALID, "%s", complaint.text);
    }
    else if (compiled->kind == SW_SPECTRUM_TABLE)
    {
        result = copyTable(host, compiled);
    }
    if (result != SW_SUCCESS)
    {
        swFree(host, compiled, sizeof(*compiled));
        return result;
    }
    *spectrum = compiled;
    return SW_SUCCESS;
}

void swFreeCompiledSpectrum(const swHost* host, swCompiledSpectrum* spectrum)
{
    if (spectrum != NULL)
    {
        swFree(host, spectrum->memory, spectrum->memorySize);
        swFree(host, spectrum, sizeof(*spectrum));
    }
}

double swGetCompiledDensity(const swCompiledSpectrum* spectrum, double omega)
{
    if (spectrum->kind == SW_SPECTRUM_TABLE)
    {
        return getTableDensity(spectrum, omega / TURN) / TURN;
    }
    return getFormulaDensity(spectrum, omega);
}

static double getSpreading(const swCompiledSpectrum* spectrum, double frequency, double theta)
{
    if (spectrum->kind == SW_SPECTRUM_TABLE)
    {
        return getTableSpreading(spectrum, frequency, theta);
    }
    return swGetCosineSpread(spectrum->spreadScale, spectrum->spreadExponent, theta - spectrum->direction);
}

double swGetCompiledDensity2(const swCompiledSpectrum* spectrum, double omega, double theta)
{
    double density = swGetCompiledDensity(spectrum, omega);
    return density > 0.0 ? density * getSpreading(spectrum, omega / TURN, theta) : 0.0;
}

static void integrate(const swCompiledSpectrum* spectrum, double omega0, double omega1, double moments[MOMENT_COUNT])
{
    if (spectrum->kind == SW_SPECTRUM_TABLE)
    {
        integrateTable(spectrum, omega0, omega1, moments);
    }
    else
    {
        integrateFormula(spectrum, omega0, omega1, moments);
    }
}

double swIntegrateCompiled(const swCompiledSpectrum* spectrum, double omega0, double omega1)
{
    double moments[MOMENT_COUNT] = {0};
    integrate(spectrum, omega0, omega1, moments);
    return moments[MOMENT_ZERO];
}

// ---- public ----

float swSpectrum_GetDensity(const swSpectrumDef* def, float frequency)
{
    swCompiledSpectrum spectrum;
    Complaint complaint;
    if (!prepare(&spectrum, def, STANDARD_GRAVITY, &complaint))
    {
        return 0.0f;
    }
    return (float)(swGetCompiledDensity(&spectrum, TURN * (double)frequency) * TURN);
}

float swSpectrum_GetSpreading(const swSpectrumDef* def, float frequency, float direction)
{
    swCompiledSpectrum spectrum;
    Complaint complaint;
    if (!prepare(&spectrum, def, STANDARD_GRAVITY, &complaint))
    {
        return 0.0f;
    }
    return (float)getSpreading(&spectrum, (double)frequency, (double)direction);
}

// First circular moments of energy: integrals of S cos and S sin.
typedef struct Vector
{
    double x, y;
} Vector;

// Of one bin of a table, not scaled. Linear interpolation between directions keeps sinc^2(half a step) of the sums.
static Vector getRowVector(const swCompiledSpectrum* spectrum, int row)
{
    int count = spectrum->table.directionCount;
    const float* density = spectrum->table.density + (size_t)row * (size_t)count;
    double half = SW_PI / count;
    double sinc = swSin(half) / half;
    Vector sum = {0.0, 0.0};
    for (int i = 0; i < count; ++i)
    {
        double angle = 2.0 * half * i + spectrum->direction;
        sum.x += (double)density[i] * swCos(angle);
        sum.y += (double)density[i] * swSin(angle);
    }
    double scale = 2.0 * half * sinc * sinc;
    return (Vector){sum.x * scale, sum.y * scale};
}

// Of a table over a range of frequencies, calibrated. Linear between bins as the density is.
static Vector integrateVector(const swCompiledSpectrum* spectrum, double frequency0, double frequency1)
{
    const swSpectrumTable* table = &spectrum->table;
    Vector total = {0.0, 0.0};
    Vector tail = {0.0, 0.0};
    double tailEnergy = 0.0;
    for (int i = 0; i < table->frequencyCount; ++i)
    {
        Vector row = getRowVector(spectrum, i);
        if (i >= table->frequencyCount - getTailBins(table))
        {
            tail.x += row.x;
            tail.y += row.y;
            tailEnergy += spectrum->energy[i];
        }
        // The bin's share is the integral of its hat: 1 at its centre, 0 at its neighbours', 1 outside of the ends.
        double left = i > 0 ? (double)table->frequencies[i - 1] : spectrum->lowEdge;
        double centre = (double)table->frequencies[i];
        double right = i + 1 < table->frequencyCount ? (double)table->frequencies[i + 1] : spectrum->highEdge;
        double share = 0.0;
        double a = left > frequency0 ? left : frequency0;
        double b = centre < frequency1 ? centre : frequency1;
        if (b > a)
        {
            double climb = i > 0 ? (0.5 * (a + b) - left) / (centre - left) : 1.0;
            share += (b - a) * climb;
        }
        a = centre > frequency0 ? centre : frequency0;
        b = right < frequency1 ? right : frequency1;
        if (b > a)
        {
            double fall = i + 1 < table->frequencyCount ? (right - 0.5 * (a + b)) / (right - centre) : 1.0;
            share += (b - a) * fall;
        }
        total.x += spectrum->scale * share * row.x;
        total.y += spectrum->scale * share * row.y;
    }
    double begin = frequency0 > spectrum->highEdge ? frequency0 : spectrum->highEdge;
    if (frequency1 > begin && tailEnergy > 0.0)
    {
        double variance = swIntegrateCompiled(spectrum, TURN * begin, TURN * frequency1);
        total.x += variance * tail.x / tailEnergy;
        total.y += variance * tail.y / tailEnergy;
    }
    return total;
}

// Where in [frequency0, frequency1] the density is largest. Formulas have one peak; a table is linear between its bins
// and falls beyond them. Bins that are equal but for rounding tie, and the lowest frequency wins.
static double findPeak(const swCompiledSpectrum* spectrum, double frequency0, double frequency1)
{
    if (spectrum->kind != SW_SPECTRUM_TABLE)
    {
        double peak = spectrum->peakOmega / TURN;
        return peak < frequency0 ? frequency0 : peak > frequency1 ? frequency1 : peak;
    }
    double best = frequency0;
    double largest = getTableDensity(spectrum, frequency0);
    for (int i = 0; i < spectrum->table.frequencyCount; ++i)
    {
        double frequency = (double)spectrum->table.frequencies[i];
        double density = getTableDensity(spectrum, frequency);
        if (frequency >= frequency0 && frequency <= frequency1 && density > largest * (1.0 + 1e-6))
        {
            best = frequency;
            largest = density;
        }
    }
    return getTableDensity(spectrum, frequency1) > largest ? frequency1 : best;
}

static Vector getPeakVector(const swCompiledSpectrum* spectrum, double frequency)
{
    Place place = findPlace(&spectrum->table, frequency);
    Vector a = getRowVector(spectrum, place.index);
    Vector b = getRowVector(spectrum, place.index + 1);
    double keep = 1.0 - place.fraction;
    return (Vector){keep * a.x + place.fraction * b.x, keep * a.y + place.fraction * b.y};
}

static void sumBins(const swCompiledSpectrum* spectrum, double moments[MOMENT_COUNT], Vector* vector)
{
    for (int i = 0; i < spectrum->table.frequencyCount; ++i)
    {
        double width = spectrum->binScale * (double)spectrum->table.bandwidths[i];
        Vector row = getRowVector(spectrum, i);
        addMoments(moments, TURN * (double)spectrum->table.frequencies[i], width * spectrum->energy[i]);
        vector->x += width * row.x;
        vector->y += width * row.y;
    }
}

swResult swSpectrum_GetSeaState(const swSpectrumDef* def, float minFrequency, float maxFrequency, swSeaState* seaState)
{
    memset(seaState, 0, sizeof(*seaState));
    swCompiledSpectrum spectrum;
    Complaint complaint;
    if (!(minFrequency >= 0.0f && maxFrequency >= minFrequency && maxFrequency <= 1000.0f) ||
        !prepare(&spectrum, def, STANDARD_GRAVITY, &complaint))
    {
        return SW_ERROR_INVALID;
    }

    bool isTable = def->kind == SW_SPECTRUM_TABLE;
    bool isWhole = maxFrequency == 0.0f;
    double low = (double)minFrequency;
    double high = isWhole ? (isTable ? spectrum.highEdge : MAX_FORMULA_FREQUENCY) : (double)maxFrequency;
    double moments[MOMENT_COUNT] = {0};
    Vector vector = {0.0, 0.0};
    if (isTable && isWhole)
    {
        sumBins(&spectrum, moments, &vector);
    }
    else
    {
        integrate(&spectrum, TURN * low, TURN * high, moments);
        vector = isTable ? integrateVector(&spectrum, low, high) : vector;
    }
    double m0 = moments[MOMENT_ZERO];
    if (!(m0 > 1e-20))
    {
        return SW_ERROR_INVALID;
    }

    double r1 = 0.0;
    double r2 = 0.0;
    swGetCosineMoments(spectrum.spreadExponent, &r1, &r2);
    double peak = findPeak(&spectrum, low, high);
    double meanDirection = spectrum.direction;
    double peakDirection = spectrum.direction;
    if (isTable)
    {
        Vector peakVector = getPeakVector(&spectrum, peak);
        r1 = sqrt(vector.x * vector.x + vector.y * vector.y) / m0;
        meanDirection = swAtan2(vector.y, vector.x);
        peakDirection = swAtan2(peakVector.y, peakVector.x);
    }
    seaState->significantHeight = (float)(4.0 * sqrt(m0));
    seaState->peakPeriod = (float)(1.0 / peak);
    seaState->periodTm01 = (float)(TURN * m0 / moments[MOMENT_ONE]);
    seaState->periodTm02 = (float)(TURN * sqrt(m0 / moments[MOMENT_TWO]));
    seaState->energyPeriod = (float)(TURN * moments[MOMENT_MINUS_ONE] / m0);
    seaState->meanDirection = (float)meanDirection;
    seaState->peakDirection = (float)peakDirection;
    seaState->spread = (float)sqrt(2.0 * (r1 < 1.0 ? 1.0 - r1 : 0.0));
    seaState->meanSquareSlope = (float)(moments[MOMENT_FOUR] / (STANDARD_GRAVITY * STANDARD_GRAVITY));
    return SW_SUCCESS;
}
