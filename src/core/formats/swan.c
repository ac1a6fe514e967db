// SPDX-License-Identifier: MIT
// Reads SWAN's spectral files [SWAN 2024], 2-D and 1-D:
//
//   SWAN   1                    then comment lines that begin with $, and keywords, each with a remark behind:
//   TIME  / coding              absent from stationary files
//   LONLAT | LOCATIONS / n / x y ...
//   AFREQ | RFREQ / n / Hz ...  absolute, or relative to a current
//   NDIR | CDIR / n / degrees   nautical: where waves come from, clockwise from north; Cartesian: where they go,
//                               counterclockwise from the x-axis, which is taken to point east. Absent from 1-D files.
//   QUANT / n / for each: name, unit, exception value
//
// then for each time a line with it, and for each place FACTOR with a factor and a line of integers for each frequency,
// or ZERO, or NODATA; in 1-D files LOCATION with a number and a line of the quantities for each frequency.
//
// VaDens is in m2/Hz/degr (1-D: m2/Hz). EnDens is rho g times that, with SWAN's rho = 1025 kg/m3 and g = 9.81 m/s2.

#include <math.h>
#include <string.h>

#include "core/base/date.h"
#include "core/base/host.h"
#include "core/base/text.h"
#include "core/formats/measured_readers.h"

#define MAX_LOCATIONS 100000
#define MAX_QUANTITIES 16
#define WEIGHT (1025.0 * 9.81)
#define DEGREE (SW_PI / 180.0)

typedef enum Quantity
{
    OTHER,
    VARIANCE,
    ENERGY,
    NAUTICAL,
    CARTESIAN,
    SPREAD
} Quantity;

// Too large for a stack.
typedef struct Reader
{
    swSeaReader file;
    int timeCoding; // 0: stationary
    int locationCount;
    int frequencyCount;
    int directionCount; // 0: 1-D
    int quantityCount;
    Quantity quantities[MAX_QUANTITIES];
    double exceptions[MAX_QUANTITIES];
    double frequencies[SW_SEA_MAX_FREQUENCIES];
    double directions[SW_SEA_MAX_DIRECTIONS];
    double energy[SW_SEA_MAX_FREQUENCIES];
    double moments[2][SW_SEA_MAX_FREQUENCIES]; // mean direction and r1
    double* density;
    int quantitiesLeft; // keywords to pass over, of a spectrum that is left out
    bool isHeld;        // the line at hand is still to be read
} Reader;

bool swIsSwan(const char* text, size_t size)
{
    swText lines = swOpenText(NULL, text, size, "");
    return swNextLine(&lines) && swIsToken(swNextToken(&lines), "SWAN");
}

// ---- lines ----

// To the next line that is no comment.
static swResult nextLine(Reader* reader, const char* what)
{
    swResult result = swNeedLine(&reader->file.text, what);
    while (result == SW_SUCCESS && swPeekChar(&reader->file.text) == '$')
    {
        result = swNeedLine(&reader->file.text, what);
    }
    return result;
}

// A number at the beginning of a line; what follows it is a remark.
static swResult readLeading(Reader* reader, const char* what, double low, double high, double* value)
{
    swResult result = nextLine(reader, what);
    return result == SW_SUCCESS ? swReadRange(&reader->file.text, what, low, high, value) : result;
}

static swResult readCount(Reader* reader, const char* what, int low, int high, int* value)
{
    double number = 0.0;
    swResult result = readLeading(reader, what, low, high, &number);
    *value = result == SW_SUCCESS ? (int)number : low;
    return result;
}

static swResult fail(const Reader* reader, const char* sentence)
{
    return swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: %s", reader->file.text.name, reader->file.text.line,
                  sentence);
}

// ---- heading ----

static swResult readLocations(Reader* reader, bool isSpherical)
{
    swResult result = readCount(reader, "the number of locations", 1, MAX_LOCATIONS, &reader->locationCount);
    for (int i = 0; i < reader->locationCount && result == SW_SUCCESS; ++i)
    {
        double x = 0.0, y = 0.0;
        result = readLeading(reader, "a location's x", -1e12, 1e12, &x);
        if (result == SW_SUCCESS)
        {
            result = swReadRange(&reader->file.text, "a location's y", -1e12, 1e12, &y);
        }
        if (result == SW_SUCCESS)
        {
            result = swMeasuredSea_AddLocation(reader->file.sea, NULL, isSpherical ? x : (double)NAN,
                                               isSpherical ? y : (double)NAN, NULL);
        }
    }
    return result;
}

static swResult readFrequencies(Reader* reader)
{
    swResult result =
        readCount(reader, "the number of frequencies", 2, SW_SEA_MAX_FREQUENCIES, &reader->frequencyCount);
    for (int i = 0; i < reader->frequencyCount && result == SW_SUCCESS; ++i)
    {
        result = readLeading(reader, "a frequency", 0.0, 100.0, &reader->frequencies[i]);
    }
    return result;
}

// Along (cos, sin) = (x, z), and z points south.
static swResult readDirections(Reader* reader, bool isNautical)
{
    swResult result = readCount(reader, "the number of directions", 4, SW_SEA_MAX_DIRECTIONS, &reader->directionCount);
    for (int i = 0; i < reader->directionCount && result == SW_SUCCESS; ++i)
    {
        double degrees = 0.0;
        result = readLeading(reader, "a direction", -720.0, 720.0, &degrees);
        reader->directions[i] = isNautical ? (degrees + 90.0) * DEGREE : -degrees * DEGREE;
    }
    return result;
}

static Quantity findQuantity(swToken name)
{
    static const struct
    {
        const char* name;
        Quantity quantity;
    } names[] = {{"VaDens", VARIANCE}, {"EnDens", ENERGY},   {"NDIR", NAUTICAL},
                 {"CDIR", CARTESIAN},  {"DSPRDEGR", SPREAD}, {"DSPR", SPREAD}};
    for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); ++i)
    {
        if (swIsToken(name, names[i].name))
        {
            return names[i].quantity;
        }
    }
    return OTHER;
}

static swResult readQuantities(Reader* reader)
{
    swResult result = readCount(reader, "the number of quantities", 1, MAX_QUANTITIES, &reader->quantityCount);
    int energyCount = 0;
    for (int i = 0; i < reader->quantityCount && result == SW_SUCCESS; ++i)
    {
        result = nextLine(reader, "a quantity's name");
        if (result == SW_SUCCESS)
        {
            reader->quantities[i] = findQuantity(swNextToken(&reader->file.text));
            energyCount += reader->quantities[i] == VARIANCE || reader->quantities[i] == ENERGY ? 1 : 0;
            result = nextLine(reader, "a quantity's unit");
        }
        if (result == SW_SUCCESS)
        {
            result = readLeading(reader, "a quantity's exception value", -1e60, 1e60, &reader->exceptions[i]);
        }
    }
    if (result == SW_SUCCESS && energyCount != 1)
    {
        result = fail(reader, "among the quantities there must be one VaDens or EnDens.");
    }
    return result;
}

// One keyword with what belongs to it. *isLast: QUANT, behind which spectra begin.
static swResult readPart(Reader* reader, bool* isLast)
{
    swResult result = nextLine(reader, "QUANT");
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swToken key = swNextToken(&reader->file.text);
    if (swIsToken(key, "TIME"))
    {
        return readCount(reader, "the time coding option", 1, 6, &reader->timeCoding);
    }
    if (swIsToken(key, "LONLAT") || swIsToken(key, "LOCATIONS"))
    {
        return reader->locationCount > 0 ? fail(reader, "the locations stand there twice.")
                                         : readLocations(reader, swIsToken(key, "LONLAT"));
    }
    if (swIsToken(key, "AFREQ") || swIsToken(key, "RFREQ"))
    {
        return readFrequencies(reader);
    }
    if (swIsToken(key, "NDIR") || swIsToken(key, "CDIR"))
    {
        return readDirections(reader, swIsToken(key, "NDIR"));
    }
    if (swIsToken(key, "QUANT"))
    {
        *isLast = true;
        return readQuantities(reader);
    }
    return swFail(reader->file.text.host, SW_ERROR_FORMAT,
                  "%s:%d: '%.*s' is not understood; TIME, LONLAT, LOCATIONS, AFREQ, RFREQ, NDIR, CDIR or QUANT should "
                  "stand there.",
                  reader->file.text.name, reader->file.text.line, key.size, key.text);
}

static swResult readHead(Reader* reader)
{
    swResult result = nextLine(reader, "SWAN");
    bool isLast = false;
    while (result == SW_SUCCESS && !isLast)
    {
        result = readPart(reader, &isLast);
    }
    if (result == SW_SUCCESS && (reader->frequencyCount == 0 || reader->locationCount == 0))
    {
        result = fail(reader, "before QUANT there must be frequencies (AFREQ or RFREQ) and LONLAT or LOCATIONS.");
    }
    if (result == SW_SUCCESS && reader->directionCount > 0)
    {
        size_t count = (size_t)reader->frequencyCount * (size_t)reader->directionCount;
        reader->density = swAllocate(reader->file.text.host, count * sizeof(double));
        result = reader->density != NULL ? SW_SUCCESS
                                         : swFail(reader->file.text.host, SW_ERROR_NO_MEMORY,
                                                  "No memory for a spectrum of %s.", reader->file.text.name);
    }
    return result;
}

// ---- times ----

// Digits of a token as numbers, whatever parts them. Returns how many.
static int splitDate(const char* text, int size, int parts[6], int digits[6])
{
    int count = 0;
    for (int i = 0; i < size && count < 6; ++i)
    {
        parts[count] = 0;
        digits[count] = 0;
        for (; i < size && text[i] >= '0' && text[i] <= '9' && digits[count] < 9; ++i)
        {
            parts[count] = 10 * parts[count] + (text[i] - '0');
            ++digits[count];
        }
        count += digits[count] > 0 ? 1 : 0;
    }
    return count;
}

static int fullYear(int year)
{
    return year < 50 ? 2000 + year : year < 100 ? 1900 + year : year;
}

// The codings: 1 19870830.153000, 2 30-Aug-87 15:30:00, 3 08/30/87 15:30:00, 5 87/08/30 15:30:00, 6 8708301530.
static bool parseDate(int coding, const char* text, int size, double* seconds)
{
    int p[6] = {0}, digits[6] = {0};
    int count = splitDate(text, size, p, digits);
    if (coding == 1 && count >= 1 && digits[0] == 8)
    {
        for (int i = count > 1 ? digits[1] : 6; i < 6; ++i)
        {
            p[1] *= 10;
        }
        return digits[1] <= 6 && swMakePackedSeconds(p[0], count > 1 ? p[1] : 0, seconds);
    }
    if (coding == 2 && count == 5)
    {
        return swMakeSeconds(fullYear(p[1]), swFindMonth(text, size), p[0], p[2], p[3], p[4], seconds);
    }
    if (coding == 3 && count == 6)
    {
        return swMakeSeconds(fullYear(p[2]), p[0], p[1], p[3], p[4], p[5], seconds);
    }
    if (coding == 5 && count == 6)
    {
        return swMakeSeconds(fullYear(p[0]), p[1], p[2], p[3], p[4], p[5], seconds);
    }
    if (coding == 6 && size >= 10)
    {
        int digit[10];
        for (int i = 0; i < 10; ++i)
        {
            digit[i] = text[i] - '0';
            if (digit[i] < 0 || digit[i] > 9)
            {
                return false;
            }
        }
        return swMakeSeconds(fullYear(10 * digit[0] + digit[1]), 10 * digit[2] + digit[3], 10 * digit[4] + digit[5],
                             10 * digit[6] + digit[7], 10 * digit[8] + digit[9], 0.0, seconds);
    }
    return false;
}

// How many characters of a line are its time.
static int measureTime(const Reader* reader, const char* text)
{
    int left = (int)(reader->file.text.lineEnd - text < 40 ? reader->file.text.lineEnd - text : 40);
    int words = reader->timeCoding == 1 || reader->timeCoding == 6 ? 1 : 2;
    int size = 0;
    for (; size < left; ++size)
    {
        bool isGap = text[size] == ' ' || text[size] == '\t';
        bool isWordEnd = isGap && size > 0 && text[size - 1] != ' ' && text[size - 1] != '\t';
        words -= isWordEnd ? 1 : 0;
        if (words == 0)
        {
            break;
        }
    }
    return size;
}

static bool isTime(Reader* reader)
{
    double ignored = 0.0;
    swPeekChar(&reader->file.text);
    const char* text = reader->file.text.at;
    return reader->timeCoding > 0 && parseDate(reader->timeCoding, text, measureTime(reader, text), &ignored);
}

static swResult readTime(Reader* reader, double* seconds)
{
    swPeekChar(&reader->file.text);
    const char* text = reader->file.text.at;
    int size = measureTime(reader, text);
    if (!parseDate(reader->timeCoding, text, size, seconds))
    {
        return swFail(reader->file.text.host, SW_ERROR_FORMAT,
                      "%s:%d: '%.*s' is no time of SWAN's coding %d; codings 1, 2, 3, 5 and 6 are read.",
                      reader->file.text.name, reader->file.text.line, size, text, reader->timeCoding);
    }
    return SW_SUCCESS;
}

// ---- spectra ----

static bool isEnergy(Quantity quantity)
{
    return quantity == VARIANCE || quantity == ENERGY;
}

// What is behind FACTOR, of one quantity.
static swResult readMatrix(Reader* reader, int quantity)
{
    double factor = 0.0;
    swResult result = readLeading(reader, "the factor", 0.0, 1e30, &factor);
    bool isKept = isEnergy(reader->quantities[quantity]);
    double scale = factor / DEGREE / (reader->quantities[quantity] == ENERGY ? WEIGHT : 1.0);
    int count = reader->frequencyCount * reader->directionCount;
    reader->file.text.at = reader->file.text.lineEnd; // a remark
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        double value = 0.0;
        result = swReadNumber(&reader->file.text, "a density", true, &value);
        if (result == SW_SUCCESS && isKept)
        {
            reader->density[i] = value == reader->exceptions[quantity] ? 0.0 : value * scale;
            if (!(reader->density[i] <= SW_SEA_MAX_DENSITY))
            {
                result = swFail(reader->file.text.host, SW_ERROR_FORMAT,
                                "%s:%d: a density is %g m2/Hz/rad; at most %g is read.", reader->file.text.name,
                                reader->file.text.line, reader->density[i], SW_SEA_MAX_DENSITY);
            }
        }
    }
    if (result == SW_SUCCESS && swPeekChar(&reader->file.text) != '\0')
    {
        result = fail(reader, "the spectrum has more numbers than frequencies times directions.");
    }
    return result;
}

// Directions and spreads go into sines, which want them in range.
static swResult checkDegrees(const Reader* reader, int quantity, double value)
{
    bool isSpread = reader->quantities[quantity] == SPREAD;
    bool isDegrees = isSpread || reader->quantities[quantity] == NAUTICAL || reader->quantities[quantity] == CARTESIAN;
    double low = isSpread ? 0.0 : -720.0, high = isSpread ? 180.0 : 720.0;
    if (!isDegrees || value == reader->exceptions[quantity] || (value >= low && value <= high))
    {
        return SW_SUCCESS;
    }
    return swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: a %s is %g degrees; it must be from %g to %g.",
                  reader->file.text.name, reader->file.text.line, isSpread ? "spread" : "direction", value, low, high);
}

static void keepValue(Reader* reader, int quantity, int row, double value, double direction[1], double spread[1])
{
    double number = value == reader->exceptions[quantity] ? (double)NAN : value;
    switch (reader->quantities[quantity])
    {
    case VARIANCE:
        reader->energy[row] = number;
        break;
    case ENERGY:
        reader->energy[row] = number / WEIGHT;
        break;
    case NAUTICAL:
        *direction = (number + 90.0) * DEGREE;
        break;
    case CARTESIAN:
        *direction = -number * DEGREE;
        break;
    case SPREAD:
        *spread = number * DEGREE;
        break;
    default:
        break;
    }
}

// What is behind LOCATION: a line of the quantities for each frequency.
static swResult readLines(Reader* reader)
{
    swResult result = SW_SUCCESS;
    reader->file.text.at = reader->file.text.lineEnd;
    for (int i = 0; i < reader->frequencyCount && result == SW_SUCCESS; ++i)
    {
        double direction = (double)NAN, spread = (double)NAN;
        for (int j = 0; j < reader->quantityCount && result == SW_SUCCESS; ++j)
        {
            double value = 0.0;
            result = swReadNumber(&reader->file.text, "a value", true, &value);
            result = result == SW_SUCCESS ? checkDegrees(reader, j, value) : result;
            if (result == SW_SUCCESS)
            {
                keepValue(reader, j, i, value, &direction, &spread);
            }
        }
        if (result == SW_SUCCESS && reader->energy[i] > SW_SEA_MAX_ENERGY)
        {
            result = fail(reader, "an energy is above 5e4 m2/Hz, the most that is read.");
        }
        double r1 = 1.0 - 0.5 * spread * spread;
        reader->moments[0][i] = direction;
        reader->moments[1][i] = r1 < 0.0 ? 0.0 : r1; // NAN without a spread
    }
    return result;
}

static void clear(Reader* reader)
{
    size_t count = (size_t)reader->frequencyCount * (size_t)reader->directionCount;
    for (size_t i = 0; i < count; ++i)
    {
        reader->density[i] = 0.0;
    }
    for (int i = 0; i < reader->frequencyCount; ++i)
    {
        reader->energy[i] = 0.0;
        reader->moments[0][i] = reader->moments[1][i] = (double)NAN;
    }
}

static swResult addSpectrum(Reader* reader, int location, double seconds)
{
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.location = location;
    def.seconds = seconds;
    def.frequencyCount = reader->frequencyCount;
    def.frequencies = reader->frequencies;
    def.directionCount = reader->directionCount;
    def.directions = reader->directions;
    def.density = reader->density;
    def.energy = reader->energy;
    def.meanDirection = reader->moments[0];
    def.r1 = reader->moments[1];
    return swMeasuredSea_AddSpectrum(reader->file.sea, &def);
}

// Whether the line begins a spectrum, or a quantity of one.
static bool isKeyword(swText* text)
{
    return swHasPrefix(text, "FACTOR") || swHasPrefix(text, "ZERO") || swHasPrefix(text, "NODATA") ||
           swHasPrefix(text, "LOCATION");
}

// From the line of the first quantity's keyword on. What was not read for a fault is counted in quantitiesLeft.
static swResult readSpectrum(Reader* reader, int location, double seconds)
{
    bool hasData = true;
    int count = reader->directionCount > 0 ? reader->quantityCount : 1;
    swResult result = SW_SUCCESS;
    clear(reader);
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        reader->quantitiesLeft = count - i - 1;
        result = i > 0 ? nextLine(reader, "FACTOR, ZERO, NODATA or LOCATION") : SW_SUCCESS;
        swToken key = result == SW_SUCCESS ? swNextToken(&reader->file.text) : (swToken){"", 0};
        bool isNothing = swIsToken(key, "NODATA");
        if (isNothing || swIsToken(key, "ZERO"))
        {
            hasData = !isNothing;
            break;
        }
        if (swIsToken(key, "FACTOR") && reader->directionCount > 0)
        {
            result = readMatrix(reader, i);
        }
        else if (swIsToken(key, "LOCATION") && reader->directionCount == 0)
        {
            result = readLines(reader);
        }
        else if (result == SW_SUCCESS)
        {
            result =
                swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: %s, ZERO or NODATA should follow, not '%.*s'.",
                       reader->file.text.name, reader->file.text.line,
                       reader->directionCount > 0 ? "FACTOR" : "LOCATION", key.size, key.text);
        }
    }
    reader->quantitiesLeft = result == SW_SUCCESS ? 0 : reader->quantitiesLeft;
    return result == SW_SUCCESS && hasData ? addSpectrum(reader, location, seconds) : result;
}

// To the line at hand or the next one where a spectrum or a time begins; beyond line `line` in any case.
static void skipBroken(Reader* reader, int line)
{
    swText* text = &reader->file.text;
    bool isMore = text->line > line || swNextLine(text);
    text->at = text->lineBegin;
    while (isMore && !isKeyword(text) && !isTime(reader))
    {
        isMore = swNextLine(text);
    }
    reader->isHeld = isMore;
}

// To the next line that is no comment; false at the end of the text.
static bool nextPart(Reader* reader)
{
    bool isMore = reader->isHeld || swNextLine(&reader->file.text);
    reader->isHeld = false;
    while (isMore && swPeekChar(&reader->file.text) == '$')
    {
        isMore = swNextLine(&reader->file.text);
    }
    return isMore;
}

// Which spectrum comes next.
typedef struct Place
{
    bool hasTime; // or needs none
    int location;
    double seconds;
} Place;

// Before a time, and at the end: each place must have had its spectrum.
static swResult checkWhole(Reader* reader, const Place* place)
{
    if (!place->hasTime || place->location >= reader->locationCount)
    {
        return SW_SUCCESS;
    }
    swResult result = swFail(reader->file.text.host, SW_ERROR_FORMAT,
                             "%s:%d: only %d of %d locations have a spectrum before this line; is the file cut off?",
                             reader->file.text.name, reader->file.text.line, place->location, reader->locationCount);
    return swJudgeRecord(&reader->file, result, reader->file.text.line);
}

// A line where a time should stand. Without it the spectra behind it are of no use.
static swResult readMoment(Reader* reader, Place* place)
{
    swResult result = checkWhole(reader, place);
    if (result == SW_SUCCESS)
    {
        result = readTime(reader, &place->seconds);
        place->hasTime = result == SW_SUCCESS;
        place->location = 0;
    }
    return result;
}

static swResult readPlace(Reader* reader, Place* place)
{
    if (!place->hasTime)
    {
        skipBroken(reader, reader->file.text.line);
        return SW_SUCCESS;
    }
    if (place->location >= reader->locationCount)
    {
        return fail(reader, "there are more spectra than locations.");
    }
    return readSpectrum(reader, place->location++, place->seconds);
}

static swResult readSpectra(Reader* reader)
{
    bool isTimeless = reader->timeCoding == 0;
    Place place = {isTimeless, isTimeless ? 0 : reader->locationCount, (double)NAN};
    swResult result = SW_SUCCESS;
    while (result == SW_SUCCESS && nextPart(reader))
    {
        int line = reader->file.text.line;
        if (isKeyword(&reader->file.text) && reader->quantitiesLeft > 0)
        {
            --reader->quantitiesLeft; // of a spectrum that is left out
            skipBroken(reader, reader->file.text.line);
            continue;
        }
        bool isSpectrum = isKeyword(&reader->file.text) ||
                          (!isTime(reader) && place.hasTime && place.location < reader->locationCount);
        swResult part = isSpectrum || isTimeless ? readPlace(reader, &place) : readMoment(reader, &place);
        reader->quantitiesLeft = isSpectrum ? reader->quantitiesLeft : 0;
        result = swJudgeRecord(&reader->file, part, line);
        if (part != SW_SUCCESS && result == SW_SUCCESS)
        {
            skipBroken(reader, line);
        }
    }
    return result == SW_SUCCESS ? checkWhole(reader, &place) : result;
}

static swResult read(void* context)
{
    Reader* reader = context;
    swResult result = readHead(reader);
    if (result == SW_SUCCESS)
    {
        result = readSpectra(reader);
    }
    swFree(reader->file.text.host, reader->density,
           (size_t)reader->frequencyCount * (size_t)reader->directionCount * sizeof(double));
    return result;
}

swResult swParseSwan(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "SWAN file", sizeof(Reader), read, sea);
}
