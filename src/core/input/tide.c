// SPDX-License-Identifier: MIT
#include "core/input/tide.h"

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "core/frame/frame.h"
#include "core/math/scalar.h"

#define SW_DEF swTideConstituent
static const swField tideFields[] = {
    SW_NUMBER(speed, "rad/s", SW_WITHIN(0.0, 1.0), 0.0, .key = "speed_rad_s", .label = "speed", .zero = "none",
              SW_LOG_KNOB(1e-7, 1e-3)),
    SW_NUMBER(amplitude, "", SW_WITHIN(-100.0, 100.0), 0.0, .key = "amplitude", .label = "amplitude",
              .tip = "Of a level, m, or of a flow along x, m/s", SW_KNOB(0.0, 5.0)),
    SW_NUMBER(phase, "deg", SW_WITHIN(-1000.0, 1000.0), 0.0, .key = "phase_deg", .label = "phase",
              .tip = "By which it lags behind time 0", .form = SW_FORM_DEGREES, SW_KNOB(-180.0, 180.0)),
    SW_NUMBER(amplitudeAcross, "m/s", SW_WITHIN(-100.0, 100.0), 0.0, .key = "amplitude_across_m_s",
              .label = "amplitude across", .tip = "Of a flow along z", SW_KNOB(0.0, 5.0)),
    SW_NUMBER(phaseAcross, "deg", SW_WITHIN(-1000.0, 1000.0), 0.0, .key = "phase_across_deg", .label = "phase across",
              .form = SW_FORM_DEGREES, SW_KNOB(-180.0, 180.0)),
};
#undef SW_DEF

const swFields swTideConstituentFields = SW_PART_FIELDS(swTideConstituent, "tide", "tidal constituent", tideFields);

const swFields* swGetTideFields(void)
{
    return &swTideConstituentFields;
}

// Speeds in degrees an hour, of mean solar time [Schureman 1958].
static const struct
{
    const char* name;
    double degreesAnHour;
} speeds[] = {
    {"Q1", 13.3986609},  {"O1", 13.9430356},  {"P1", 14.9589314},  {"S1", 15.0},        {"K1", 15.0410686},
    {"J1", 15.5854433},  {"OO1", 16.1391017}, {"2N2", 27.8953548}, {"MU2", 27.9682084}, {"N2", 28.4397295},
    {"NU2", 28.5125831}, {"M2", 28.9841042},  {"L2", 29.5284789},  {"T2", 29.9589333},  {"S2", 30.0},
    {"K2", 30.0821373},  {"M3", 43.4761563},  {"MN4", 57.4238337}, {"M4", 57.9682084},  {"MS4", 58.9841042},
    {"S4", 60.0},        {"M6", 86.9523127},  {"M8", 115.9364166}, {"MF", 1.0980331},   {"MM", 0.5443747},
    {"SSA", 0.0821373},  {"SA", 0.0410686},
};

float swGetTideSpeed(const char* name)
{
    for (size_t i = 0; name != NULL && i < sizeof speeds / sizeof speeds[0]; ++i)
    {
        if (strcmp(name, speeds[i].name) == 0)
        {
            return (float)(speeds[i].degreesAnHour * (3.14159265358979323846 / 180.0 / 3600.0));
        }
    }
    return 0.0f;
}

const char* swGetTideName(int index)
{
    return index >= 0 && (size_t)index < sizeof speeds / sizeof speeds[0] ? speeds[index].name : NULL;
}

bool swSetTideConstituent(const char* name, float amplitude, float phase, swTideConstituent* constituent)
{
    SW_REQUIRE(constituent != NULL, false, NULL, "swSetTideConstituent() needs a place for the constituent");
    float speed = swGetTideSpeed(name);
    *constituent = (swTideConstituent){0};
    if (speed > 0.0f)
    {
        *constituent = (swTideConstituent){.speed = speed, .amplitude = amplitude, .phase = phase};
    }
    return speed > 0.0f;
}

static double swing(double speed, double time, float phase)
{
    double turns = (speed * time - (double)phase) * 0.15915494309189535;
    float sine, cosine;
    swSinCosTurns(swGetFractionOfTurn(turns), &sine, &cosine);
    return (double)cosine;
}

void swGetTide(int count, const swTideConstituent* constituents, double time, float* x, float* z)
{
    SW_REQUIRE_VOID(x != NULL && z != NULL, NULL, "swGetTide() needs places for x and z");
    *x = 0.0f;
    *z = 0.0f;
    SW_REQUIRE_VOID(count >= 0 && (constituents != NULL || count == 0), NULL,
                    "swGetTide() needs as many constituents as it is told");
    double along = 0.0, across = 0.0;
    for (int i = 0; i < count; ++i)
    {
        const swTideConstituent* c = &constituents[i];
        along += c->amplitude != 0.0f ? (double)c->amplitude * swing((double)c->speed, time, c->phase) : 0.0;
        across += c->amplitudeAcross != 0.0f
                      ? (double)c->amplitudeAcross * swing((double)c->speed, time, c->phaseAcross)
                      : 0.0;
    }
    *x = (float)along;
    *z = (float)across;
}

// ---- tables ----

// Rise a second from line i to the next; 0 beyond the ends, where the level stands.
static double findRise(int count, const swTideLevel* table, int i)
{
    bool isWithin = i >= 0 && i + 1 < count;
    return isWithin ? ((double)table[i + 1].level - (double)table[i].level) / (table[i + 1].time - table[i].time) : 0.0;
}

// Slope of the cubics at line i: that of the parabola through it and its neighbours, held so that nothing overshoots.
static double findSlope(int count, const swTideLevel* table, int i)
{
    double before = findRise(count, table, i - 1), after = findRise(count, table, i);
    if (before * after <= 0.0)
    {
        return 0.0;
    }
    double lengthBefore = table[i].time - table[i - 1].time, lengthAfter = table[i + 1].time - table[i].time;
    double parabola = (before * lengthAfter + after * lengthBefore) / (lengthBefore + lengthAfter);
    double least = fmin(fabs(before), fabs(after));
    double size = fmin(2.0 * least, fabs(parabola));
    return before > 0.0 ? size : -size;
}

float swGetTideOfTable(int count, const swTideLevel* table, double time)
{
    SW_REQUIRE(count > 0 && table != NULL, NAN, NULL, "swGetTideOfTable() needs a table of at least one line");
    if (!isfinite(time) || time <= table[0].time || count == 1)
    {
        return isfinite(time) && isfinite(table[0].time) ? table[0].level : NAN;
    }
    int first = 0, end = count - 1; // the time is after the first, and will be no later than the end
    if (time >= table[end].time)
    {
        return table[end].level;
    }
    while (end - first > 1)
    {
        int middle = first + (end - first) / 2;
        first = time >= table[middle].time ? middle : first;
        end = time >= table[middle].time ? end : middle;
    }
    double length = table[end].time - table[first].time;
    if (!(length > 0.0))
    {
        return NAN;
    }
    double t = (time - table[first].time) / length;
    double rise = (double)table[end].level - (double)table[first].level;
    double slopeFirst = findSlope(count, table, first) * length, slopeEnd = findSlope(count, table, end) * length;
    double cubic = slopeFirst + slopeEnd - 2.0 * rise, square = 3.0 * rise - 2.0 * slopeFirst - slopeEnd;
    return (float)((double)table[first].level + t * (slopeFirst + t * (square + t * cubic)));
}
