// SPDX-License-Identifier: MIT
// Tables and sentences of instruments: Spotter's dashboard, AWAC, Octopus and Obscape. Texts of our own with every
// liberty that their writers take, and files of others where they lie beside the sources, against the numbers that
// they tell themselves.

#include "support/cmocka_setup.h"
#include "support/text_file.h"
#include "support/sea_states.h"
#include "support/messages.h"
#include "support/counting_host.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "seaway/math.h"
#include "seaway/measured.h"

#define DATA SW_SOURCE_DIR "/../shared/data/spectra"
#define DEGREE (SW_PI / 180.0)

static swResult Parse(const char* text, swMeasuredSea** sea)
{
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    s_messages[0] = '\0';
    return swParseMeasuredSea(&host, text, strlen(text), "x", sea);
}

static swMeasuredSea* ParseFine(const char* text, int count)
{
    swMeasuredSea* sea = NULL;
    if (Parse(text, &sea) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    assert_int_equal(swMeasuredSea_GetCount(sea), count);
    return sea;
}

static bool IsBearing(float direction, double bearing, double tolerance)
{
    double error = fabs(remainder(GetBearing(direction) - bearing, 360.0));
    if (!(error <= tolerance))
    {
        print_message("from %.3f degrees, not %.3f\n", GetBearing(direction), bearing);
    }
    return error <= tolerance;
}

static int FindPeak(const swMeasuredRecord* record)
{
    int peak = 0;
    for (int i = 1; i < record->table.frequencyCount; ++i)
    {
        peak = record->energy[i] > record->energy[peak] ? i : peak;
    }
    return peak;
}

static double GetHeight(const swMeasuredRecord* record)
{
    double variance = 0.0;
    for (int i = 0; i < record->table.frequencyCount; ++i)
    {
        variance += (double)record->energy[i] * (double)record->table.bandwidths[i];
    }
    return 4.0 * sqrt(variance);
}

// ---- Spotter's table ----

#define SPOTTER_HEADING                                                                                                \
    "varianceDensity_1 ,varianceDensity_0 ,Epoch Time ,f_0 ,f_1 ,df_0 ,df_1 ,a1_0 ,a1_1 ,b1_0 ,b1_1 ,direction_0 "     \
    ",direction_1 ,directionalSpread_0 ,directionalSpread_1 ,Latitude (deg) ,Longitude (deg) ,Wind Speed (m/s)\n"

static void SpottersTableIsRead(void** state)
{
    (void)state;
    swMeasuredSea* sea =
        ParseFine(SPOTTER_HEADING "2.0,1.0,1632838321,.1,.2,.02,.03,0.0,0.0,0.8,0.8,0,0,0,0,36.2,-121.9,5\n"
                                  " 3.0 , 1.0 ,1632834721.5,.1,.2,.02,.03,-,nan,,-,90,270,20,-,36.1,-121.8,\n"
                                  "-,-,1632841921,.1,.2,.02,.03,-,-,-,-,-,-,-,-,36.3,-121.7,5\n",
                  2);
    assert_non_null(strstr(s_messages, "x:4: the record has no spectrum. It is left out (line 4)."));
    swMeasuredRecord first = swMeasuredSea_GetRecord(sea, 0), second = swMeasuredSea_GetRecord(sea, 1);
    assert_string_equal(first.time, "2021-09-28 13:12");
    assert_true(fabs(first.seconds - 1632834721.5) < 1e-6);
    assert_true(second.energy[0] == 1.0f && second.energy[1] == 2.0f && second.table.bandwidths[1] == 0.03f);
    assert_true(IsBearing(second.meanDirection[0], 180.0, 1e-3)); // b1: goes north
    assert_true(fabsf(second.measuredR1[0] - 0.8f) < 1e-6f);
    // Where there are no moments: direction and spread, each if it is there.
    assert_true(IsBearing(first.meanDirection[0], 90.0, 1e-3) && IsBearing(first.meanDirection[1], 270.0, 1e-3));
    assert_true(fabs((double)first.measuredR1[0] - (1.0 - 0.5 * 20.0 * 20.0 * DEGREE * DEGREE)) < 1e-5);
    assert_true(IsBearing(first.measuredDirection[1], 270.0, 1e-3) && isnan(first.measuredR1[1]));
    // One place, where the buoy was first.
    assert_int_equal(swMeasuredSea_GetLocationCount(sea), 1);
    assert_true(swMeasuredSea_GetLocation(sea, 0).latitude == 36.1);
    assert_true(swMeasuredSea_GetLocation(sea, 0).longitude == -121.8);
    swDestroyMeasuredSea(sea);
}

static void SpottersTableWithoutSpectraIsRefused(void** state)
{
    (void)state;
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse("Epoch Time ,Significant Wave Height (m) ,Peak Period (s)\n1632838321,1.2,8.0\n", &sea),
                     SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "x:1: the table holds no spectra"));
    assert_null(sea);
}

// The field of a name in line `row` of a table, the heading being row 0; NAN if there is none.
static double GetField(const char* text, int row, const char* name)
{
    static char heading[1 << 16], line[1 << 16];
    const char* at = text;
    int column = 0;
    sscanf(at, "%65535[^\n]", heading);
    for (int i = 0; i < row; ++i)
    {
        at = strchr(at, '\n') + 1;
    }
    sscanf(at, "%65535[^\n]", line);
    const char* found = strstr(heading, name);
    for (const char* c = heading; found != NULL && c < found; ++c)
    {
        column += *c == ',' ? 1 : 0;
    }
    char* field = line;
    for (int i = 0; i < column && field != NULL; ++i)
    {
        field = strchr(field, ',');
        field += field != NULL ? 1 : 0;
    }
    return found != NULL && field != NULL ? atof(field) : (double)NAN;
}

static void MontereysSpotterIsReadAsItTells(void** state)
{
    (void)state;
    char* text = ReadTextFile(DATA "/spotter_csv_2021-09/spotter_20210929.csv", &(size_t){0});
    if (text == NULL)
    {
        return;
    }
    swMeasuredSea* sea = ParseFine(text, 13);
    double worst[5] = {0};
    for (int i = 0; i < 13; ++i)
    {
        int row = 13 - i; // the newest comes first
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, i);
        swSeaState seaState = GetSeaState(sea, i, false);
        int peak = FindPeak(&record);
        assert_true(fabs(record.seconds - GetField(text, row, "Epoch Time")) < 0.5);
        double errors[5] = {
            fabs(GetHeight(&record) / GetField(text, row, "Significant Wave Height (m)") - 1.0),
            fabs(1.0 / (double)record.table.frequencies[peak] / GetField(text, row, "Peak Period (s)") - 1.0),
            fabs(
                remainder(GetBearing(record.meanDirection[peak]) - GetField(text, row, "Peak Direction (deg)"), 360.0)),
            fabs(remainder(GetBearing(seaState.meanDirection) - GetField(text, row, "Mean Direction (deg)"), 360.0)),
            fabs((double)seaState.spread / DEGREE - GetField(text, row, "Mean Directional Spread (deg)")),
        };
        for (int j = 0; j < 5; ++j)
        {
            worst[j] = fmax(worst[j], errors[j]);
        }
    }
    print_message("13 records, worst: Hs %.3f %%, Tp %.3f %%, peak direction %.3f, mean %.2f, spread %.2f degrees\n",
                  100.0 * worst[0], 100.0 * worst[1], worst[2], worst[3], worst[4]);
    assert_true(worst[0] < 0.001 && worst[1] < 0.001 && worst[2] < 0.01 && worst[3] < 1.0 && worst[4] < 1.0);
    free(text);
    swDestroyMeasuredSea(sea);
}

// ---- AWAC ----

// Sentences, with their sums behind where they have none.
static void AddSentence(char* text, size_t room, const char* words)
{
    unsigned sum = 0;
    for (const char* c = words; *c != '\0'; ++c)
    {
        sum ^= (unsigned char)*c;
    }
    size_t used = strlen(text);
    snprintf(text + used, room - used, "$%s*%02X\r\n", words, sum);
}

static swMeasuredSea* ParseSentences(const char* const* sentences, int sentenceCount, int count)
{
    char text[8192] = "";
    for (int i = 0; i < sentenceCount; ++i)
    {
        AddSentence(text, sizeof(text), sentences[i]);
    }
    return ParseFine(text, count);
}

static void AwacsSentencesAreRead(void** state)
{
    (void)state;
    static const char* const sentences[] = {
        "PNORI,3,WAV0001,3,18,0.41,1.00,0",
        "PNORW,061224,003000,3,4,0.57,1.71",
        "PNORF,A1,061224,003000,3,0.10,0.01,3,-0.2907,-0.2907,-9.0000", // from 250 degrees
        "PNORF,B1,061224,003000,3,0.10,0.01,3,-0.7987,-0.7987,-9.0000",
        "PNORF,A2,061224,003000,3,0.10,0.01,3,-0.3830,-0.3830,-9.0000",
        "PNORF,B2,061224,003000,3,0.10,0.01,3,0.3214,0.3214,-9.0000",
        "PNORE,061224,003000,3,0.10,0.01,4,0.500,1.000,0.500,0.000", // more frequencies than moments
        "PNORS,061224,003000,00,30,14.6,1513.0",
    };
    swMeasuredSea* sea = ParseSentences(sentences, 8, 1);
    assert_string_equal(s_messages, "");
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_string_equal(record.time, "2024-06-12 00:30");
    assert_int_equal(record.table.frequencyCount, 4);
    assert_true(fabsf(record.table.frequencies[1] - 0.11f) < 1e-6f && record.energy[1] == 1.0f);
    assert_true(IsBearing(record.measuredDirection[0], 250.0, 0.01) &&
                IsBearing(record.measuredDirection[1], 250.0, 0.01));
    assert_true(fabsf(record.measuredR1[0] - 0.85f) < 1e-3f);
    assert_true(isnan(record.measuredDirection[2]) && isnan(record.measuredR1[3]));
    assert_true(IsBearing(record.meanDirection[2], 250.0, 0.01)); // filled in
    assert_true(fabsf(record.r2[0] - 0.5f) < 1e-3f);
    assert_true(IsBearing(GetSeaState(sea, 0, false).meanDirection, 250.0, 0.1));
    swDestroyMeasuredSea(sea);
}

static void AwacsHeightTellsTheUnit(void** state)
{
    (void)state;
    static const char* const sentences[] = {
        "PNORW,061224,000000,3,4,0.57,1.71", "PNORE,061224,000000,3,0.10,0.01,3,5000.0,10000.0,5000.0", // cm2/Hz
        "PNORW,061224,010000,3,4,0.57,1.71", "PNORE,061224,010000,3,0.10,0.01,3,0.50,1.00,0.50",        // m2/Hz
    };
    swMeasuredSea* sea = ParseSentences(sentences, 4, 2);
    swMeasuredRecord first = swMeasuredSea_GetRecord(sea, 0), second = swMeasuredSea_GetRecord(sea, 1);
    assert_true(fabs(GetHeight(&first) - 0.566) < 1e-3 && fabs(GetHeight(&second) - 0.566) < 1e-3);
    assert_string_equal(s_messages, "");
    swDestroyMeasuredSea(sea);

    static const char* const alone[] = {"PNORE,061224,000000,3,0.10,0.01,3,0.50,1.00,0.50"};
    sea = ParseSentences(alone, 1, 1);
    assert_non_null(strstr(s_messages, "no PNORW tells a height: densities are taken to be in m2/Hz"));
    swDestroyMeasuredSea(sea);

    static const char* const strange[] = {"PNORW,061224,000000,3,4,3.0,1.71",
                                          "PNORE,061224,000000,3,0.10,0.01,3,0.50,1.00,0.50"};
    sea = ParseSentences(strange, 2, 1);
    assert_non_null(strstr(s_messages, "in 1 bursts the densities (PNORE) do not add up to the height in PNORW"));
    swDestroyMeasuredSea(sea);
}

static void AwacsMeanDirectionsAndSpreadsAreRead(void** state)
{
    (void)state;
    static const char* const sentences[] = {
        "PNORW,061224,000000,3,4,0.57,1.71",
        "PNORE,061224,000000,3,0.10,0.01,3,0.50,1.00,0.50",
        "PNORWD,MD,061224,000000,3,0.10,0.01,3,10.0,350.0,-9.0000",
        "PNORWD,DS,061224,000000,3,0.10,0.01,3,20.0,-9.0000,-9.0000",
    };
    swMeasuredSea* sea = ParseSentences(sentences, 4, 1);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
    assert_true(IsBearing(record.measuredDirection[0], 10.0, 0.01) &&
                IsBearing(record.measuredDirection[1], 350.0, 0.01));
    assert_true(isnan(record.measuredDirection[2]) && isnan(record.measuredR1[1]));
    assert_true(fabs((double)record.measuredR1[0] - (1.0 - 0.5 * 20.0 * 20.0 * DEGREE * DEGREE)) < 1e-4);
    swDestroyMeasuredSea(sea);
}

static void WrongSumsAreLeftOut(void** state)
{
    (void)state;
    char text[4096] = "2024-06-12T00:00:05Z "; // a logger's time before the sentence
    AddSentence(text, sizeof(text), "PNORW,061224,000000,3,4,0.57,1.71");
    AddSentence(text, sizeof(text), "PNORE,061224,000000,3,0.10,0.01,3,0.50,1.00,0.50");
    AddSentence(text, sizeof(text), "PNORE,061224,010000,3,0.10,0.01,3,0.50,1.00,0.50");
    char* wrong = strstr(text, "010000,3,0.10,0.01,3,0.50,1.00");
    wrong[24] = '9'; // 1.00 becomes 9.00 on its way
    size_t used = strlen(text);
    snprintf(text + used, sizeof(text) - used, "$PNORE,061224,020000,3,0.10,0.01,3,0.50,1.00,0.50\n"); // without a sum
    swMeasuredSea* sea = ParseFine(text, 2);
    assert_non_null(strstr(s_messages, "x:3: the sentence's sum is"));
    assert_string_equal(swMeasuredSea_GetRecord(sea, 1).time, "2024-06-12 02:00");
    swDestroyMeasuredSea(sea);
}

static void AwacsSampleIsReadAsItTells(void** state)
{
    (void)state;
    char* text = ReadTextFile(DATA "/awac_nmea_ours/awac.nmea", &(size_t){0});
    if (text == NULL)
    {
        return;
    }
    swMeasuredSea* sea = ParseFine(text, 3);
    int index = 0;
    for (const char* line = text; (line = strstr(line, "$PNORW,")) != NULL; ++line, ++index)
    {
        double told[6];
        assert_int_equal(sscanf(line, "$PNORW,%*d,%*d,%*d,%*d,%lf,%*f,%*f,%*f,%lf,%lf,%*f,%lf,%lf,%lf", &told[0],
                                &told[1], &told[2], &told[3], &told[4], &told[5]),
                         6);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, index);
        swSeaState seaState = GetSeaState(sea, index, false);
        int peak = FindPeak(&record);
        print_message("%s: Hs %.3f of %.2f m, Tm02 %.2f of %.2f s, Tp %.2f of %.2f s, from %.1f of %.0f degrees\n",
                      record.time, GetHeight(&record), told[0], (double)seaState.periodTm02, told[1],
                      1.0 / (double)record.table.frequencies[peak], told[2], GetBearing(seaState.meanDirection),
                      told[5]);
        assert_true(fabs(GetHeight(&record) / told[0] - 1.0) < 0.01);
        assert_true(fabs((double)seaState.periodTm02 / told[1] - 1.0) < 0.01);
        assert_true(fabs(1.0 / told[2] - (double)record.table.frequencies[peak]) < 0.01); // a bin
        assert_true(IsBearing(record.meanDirection[peak], told[3], 1.0) &&
                    IsBearing(seaState.meanDirection, told[5], 1.0));
        assert_true(fabs(sqrt(2.0 * (1.0 - (double)record.r1[peak])) / DEGREE - told[4]) < 1.0);
    }
    assert_int_equal(index, 3);
    free(text);
    swDestroyMeasuredSea(sea);
}

// ---- Octopus ----

static void OctopusIsReadAsItTells(void** state)
{
    (void)state;
    char* text = ReadTextFile(DATA "/octopus_2014-12/octopusfile.oct", &(size_t){0});
    if (text == NULL)
    {
        return;
    }
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(text, &sea), SW_SUCCESS);
    assert_string_equal(s_messages, "");
    assert_int_equal(swMeasuredSea_GetLocationCount(sea), 2);
    assert_true(fabs(swMeasuredSea_GetLocation(sea, 0).latitude - 19.950001) < 1e-9);
    assert_true(fabs(swMeasuredSea_GetLocation(sea, 1).longitude - 92.0) < 1e-9);
    double worst[4] = {0};
    int index = 0;
    for (const char* line = text; (line = strstr(line, "Tau\n")) != NULL; ++line)
    {
        int month = 0, clock = 0;
        double height = 0.0, dominant = 0.0, spread = 0.0;
        assert_int_equal(sscanf(line + 4,
                                "%d,'%d,%*[^,],%*f,%*f,%*f,%*f,%*f,%*f,%*f,%*f,%*f,%*f,%*f,%*f,%*f,%lf,%lf,%lf", &month,
                                &clock, &height, &dominant, &spread),
                         5);
        char time[40];
        snprintf(time, sizeof(time), "%d-%02d-%02d %02d:%02d", month / 100, month % 100, clock / 10000,
                 clock / 100 % 100, clock % 100);
        int found = swMeasuredSea_FindRecord(sea, index < 9 ? 0 : 1, time);
        assert_true(found >= 0);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, found);
        assert_string_equal(record.time, time);
        // The file's densities, and its height, which counts a tail of f^-5 behind the last frequency.
        const char* densities = strstr(line, "\nden,") + 5;
        int last = record.table.frequencyCount - 1;
        for (int i = 0; i <= last; ++i)
        {
            double density = strtod(densities, (char**)&densities);
            ++densities;
            worst[0] = fmax(worst[0], fabs(density - (double)record.energy[i]));
        }
        double tail = (double)record.energy[last] * (double)record.table.frequencies[last] / 4.0;
        double ours = 4.0 * sqrt(pow(GetHeight(&record) / 4.0, 2.0) + tail);
        worst[1] = fmax(worst[1], fabs(ours / height - 1.0));
        swSeaState seaState = GetSeaState(sea, found, false);
        worst[2] = fmax(worst[2], fabs(remainder(GetBearing(seaState.peakDirection) - dominant, 360.0)));
        worst[3] = fmax(worst[3], fabs((double)seaState.spread / DEGREE - spread));
        ++index;
    }
    print_message("%d records, worst: density %.1e m2/Hz, Hs with its tail %.2f %%, at the peak %.1f, spread %.1f "
                  "degrees\n",
                  index, worst[0], 100.0 * worst[1], worst[2], worst[3]);
    assert_true(index == 18 && worst[0] < 2e-4 && worst[1] < 0.001 && worst[2] < 1.0 && worst[3] < 1.5);
    free(text);
    swDestroyMeasuredSea(sea);
}

// ---- Obscape ----

// One swell from 250 degrees, cos^20 of half the angle, over 24 directions, in the unit's radians or degrees.
static void WriteObscape(char* text, size_t room, bool isShort, double scale, const char* unit)
{
    size_t used = (size_t)snprintf(text, room,
                                   "# Station name = North Bank \n# Latitude [deg] = 52.5\n# Longitude [deg] = "
                                   "3.25\n# Timestamp = 1712136600\n# Timezone = Mars\n# Directions = True "
                                   "North\n#\n# Columns [deg] = ");
    for (int j = 0; j < 24 && !isShort; ++j)
    {
        used += (size_t)snprintf(text + used, room - used, "%s%d", j > 0 ? "," : "", 15 * j);
    }
    used +=
        (size_t)snprintf(text + used, room - used, "%s\n# Rows [Hz] = 0.08,0.09,0.10,0.11\n# Variance-density [%s]\n",
                         isShort ? "0,15,30,... 345" : "", unit);
    for (int i = 0; i < 4; ++i)
    {
        for (int j = 0; j < 24; ++j)
        {
            double density = (i == 1 ? 2.0 : 0.5) * pow(cos(0.5 * (15.0 * j - 250.0) * DEGREE), 20.0) * scale;
            used += (size_t)snprintf(text + used, room - used, "%s%.6f", j > 0 ? "," : "", density);
        }
        used += (size_t)snprintf(text + used, room - used, "\n");
    }
}

static void ObscapesSpectrumIsRead(void** state)
{
    (void)state;
    char text[8192];
    double height = 0.0;
    for (int variant = 0; variant < 3; ++variant)
    {
        WriteObscape(text, sizeof(text), variant > 0, variant == 2 ? DEGREE : 1.0,
                     variant == 2 ? "m2/Hz/deg" : "m2/Hz/rad");
        swMeasuredSea* sea = ParseFine(text, 1);
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        swSeaState seaState = GetSeaState(sea, 0, false);
        assert_string_equal(record.time, "2024-04-03 09:30");
        assert_string_equal(swMeasuredSea_GetLocation(sea, 0).name, "North Bank");
        assert_true(swMeasuredSea_GetLocation(sea, 0).longitude == 3.25);
        assert_int_equal(record.table.directionCount, 24);
        // The integral of cos^20 of half the angle is 2 pi 20! / (2^20 10!^2) = 1.10709.
        assert_true(fabs((double)record.energy[1] / (2.0 * 1.107085) - 1.0) < 1e-4);
        assert_true(IsBearing(seaState.meanDirection, 250.0, 0.05) && FindPeak(&record) == 1);
        assert_string_equal(s_messages, "");
        height = variant == 0 ? GetHeight(&record) : height;
        assert_true(fabs(GetHeight(&record) / height - 1.0) < 1e-3);
        swDestroyMeasuredSea(sea);
    }
}

static void WrongObscapeIsNamed(void** state)
{
    (void)state;
#define OBSCAPE "# Timestamp = 1712136600\n# Columns [deg] = 0,90,... 270\n# Rows [Hz] = 0.1,0.2\n"
    static const struct
    {
        const char *text, *words;
    } cases[] = {
        {OBSCAPE "1,2,3,4\n", "x:4: the file ends where a line of densities should follow"},
        {OBSCAPE "1,2,3\n1,2,3,4\n", "x:4: the line has 3 densities for the 4 directions in Columns"},
        {OBSCAPE "1,2,3,4\n1,2,x,4\n", "x:5: a density is 'x'"},
        {OBSCAPE "1,2,3,4\n1,2,3,4\n1,2,3,4\n", "x:6: there are more lines than the 2 frequencies in Rows"},
        {"# Columns [deg] = 0,90,80\n# Rows [Hz] = 0.1,0.2\n1,2,3\n", "x:1: '80' stands where the next"},
        {"# Columns [deg] = 0,... 270\n# Rows [Hz] = 0.1,0.2\n1,2,3\n", "x:1: '... 270' stands where the next"},
        {"# Columns [deg] = 0,90\n# Rows [Hz] = 0.1,0.2\n1,2\n1,2\n", "x:3: the heading must name at least"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swMeasuredSea* sea = NULL;
        assert_int_equal(Parse(cases[i].text, &sea), SW_ERROR_FORMAT);
        assert_null(sea);
        if (strstr(s_messages, cases[i].words) == NULL)
        {
            fail_msg("\"%s\" does not say \"%s\"", s_messages, cases[i].words);
        }
    }
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse("# Directions = Magnetic North\n" OBSCAPE "1,2,3,4\n1,2,3,4\n", &sea), SW_SUCCESS);
    assert_non_null(strstr(s_messages, "directions are clockwise from 'Magnetic North'"));
    swDestroyMeasuredSea(sea);
}

// ---- memory ----

static void FailingMemoryLeavesNothingBehind(void** state)
{
    (void)state;
    char awac[1024] = "", obscape[8192];
    AddSentence(awac, sizeof(awac), "PNORE,061224,000000,3,0.10,0.01,3,0.50,1.00,0.50");
    WriteObscape(obscape, sizeof(obscape), true, 1.0, "m2/Hz/rad");
    const char* const texts[] = {
        SPOTTER_HEADING "2.0,1.0,1632838321,.1,.2,.02,.03,0.0,0.0,0.8,0.8,0,0,0,0,36.2,-121.9,5\n", awac, obscape,
        "nfreqs,2\nndir,4\nCCYYMM,DDHHmm\n201412,'010000\nfreq,0.1,0.2\n0,1,1\n90,1,1\n180,1,1\n270,1,1\n"};
    for (size_t i = 0; i < sizeof(texts) / sizeof(texts[0]); ++i)
    {
        CountingMemory memory;
        swHost host = MakeCountingHost(&memory);
        swMeasuredSea* sea = NULL;
        assert_int_equal(swParseMeasuredSea(&host, texts[i], strlen(texts[i]), "x", &sea), SW_SUCCESS);
        swDestroyMeasuredSea(sea);
        assert_int_equal(atomic_load(&memory.bytes), 0);
        long long allocations = atomic_load(&memory.allocations);
        for (long long j = 0; j < allocations; ++j)
        {
            atomic_store(&memory.allocations, 0);
            atomic_store(&memory.failAt, j);
            assert_int_equal(swParseMeasuredSea(&host, texts[i], strlen(texts[i]), "x", &sea), SW_ERROR_NO_MEMORY);
            assert_null(sea);
            assert_int_equal(atomic_load(&memory.bytes), 0);
        }
        print_message("%lld allocations, each failed once\n", allocations);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SpottersTableIsRead),
        cmocka_unit_test(SpottersTableWithoutSpectraIsRefused),
        cmocka_unit_test(MontereysSpotterIsReadAsItTells),
        cmocka_unit_test(AwacsSentencesAreRead),
        cmocka_unit_test(AwacsHeightTellsTheUnit),
        cmocka_unit_test(AwacsMeanDirectionsAndSpreadsAreRead),
        cmocka_unit_test(WrongSumsAreLeftOut),
        cmocka_unit_test(AwacsSampleIsReadAsItTells),
        cmocka_unit_test(OctopusIsReadAsItTells),
        cmocka_unit_test(ObscapesSpectrumIsRead),
        cmocka_unit_test(WrongObscapeIsNamed),
        cmocka_unit_test(FailingMemoryLeavesNothingBehind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
