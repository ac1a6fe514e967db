// SPDX-License-Identifier: MIT
// What happens to texts on their way: a byte order mark, other line ends, tabs, a last line without its end, one
// record of many that is broken, empty partitions, directions taken for energies. Every reader of texts is tried
// alike.

#include "support/cmocka_setup.h"
#include "support/text_file.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "seaway/math.h"
#include "seaway/measured.h"

#define FAULTS SW_SOURCE_DIR "/../shared/data/faults"
#define MAX_TEXT 16384

static swResult Parse(const char* text, size_t size, swMeasuredSea** sea)
{
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    s_messages[0] = '\0';
    return swParseMeasuredSea(&host, text, size, "x", sea);
}

// ---- a text of each format ----

typedef struct Sample
{
    const char* name;
    bool hasTabs; // spaces may be tabs
    const char* head;
    const char* records[3]; // NULL: one record in all
} Sample;

#define SWAN_HEAD                                                                                                      \
    "SWAN 1\nTIME\n1\nLONLAT\n1\n1 2\nAFREQ\n2\n.1\n.2\nNDIR\n4\n0\n90\n180\n270\nQUANT\n1\nVaDens\nm2/Hz/degr\n-99\n"
#define SWAN_1D                                                                                                        \
    "SWAN 1\nTIME\n1\nLONLAT\n1\n1 2\nAFREQ\n2\n.1\n.2\nQUANT\n3\nVaDens\nm2/Hz\n-99\nNDIR\ndegr\n-999\nDSPRDEGR\n"    \
    "degr\n-9\n"
#define SPOTTER_HEAD                                                                                                   \
    "Humidity (%rel) ,Epoch Time ,Latitude (deg) ,Longitude (deg) ,f_0 ,f_1 ,f_2 ,df_0 ,df_1 ,df_2 ,a1_0 ,a1_1 "       \
    ",a1_2,b1_0 ,b1_1,b1_2,a2_0,a2_1,a2_2,b2_0,b2_1,b2_2,varianceDensity_0 ,varianceDensity_1 ,varianceDensity_2 \n"
#define OCTOPUS_HEAD                                                                                                   \
    "Forecast valid for 01-Dec-2014 00:00:00\nnfreqs,3\nndir,4\nnrecs,3\nLatitude,19.95\nLongitude,92.10\n"            \
    "Depth,106.59\n\n"
#define OCTOPUS_RECORD(time, scale)                                                                                    \
    "CCYYMM,DDHHmm,LPoint,WD,WS,HSig\n201412,'" time ",spec,25,5.10,0.7\nfreq,0.10,0.11,0.12,anspec\n"                 \
    "0,0.001,0.00" scale ",0.001,0.0,\n90,0.001,0.002,0.001,0.0,\n180,0.0,0.0,0.0,0.0,\n270,0.0,0.0,0.0,0.0,\n"        \
    "fSpec,0.002,0.004,0.002,\nden,0.2,0.4,0.2,\n\n"

static const Sample s_samples[] = {
    {"NDBC, real time",
     true,
     "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) ... >\n",
     {"2022 05 12 21 50 0.250 0.50 (0.100) 1.00 (0.110) 0.40 (0.120)\n",
      "2022 05 12 22 50 0.250 0.60 (0.100) 1.10 (0.110) 0.30 (0.120)\n",
      "2022 05 12 23 50 0.250 0.70 (0.100) 1.20 (0.110) 0.20 (0.120)\n"}},
    {"NDBC, archive",
     true,
     "#YY  MM DD hh mm .0900  .1000  .1100 .1200\n",
     {"2021 01 01 00 40   0.10   0.20   0.12 0.10\n", "2021 01 01 01 40   0.20   0.30   0.22 0.20\n",
      "2021 01 01 02 40   0.30   0.40   0.32 0.30\n"}},
    {"NDBC, summary",
     true,
     "#YY  MM DD hh mm WVHT  SwH  SwP  WWH  WWP SwD WWD  STEEPNESS  APD MWD\n",
     {"2022 05 10 10 40 2.0 1.5 8.0 1.3 5.0 W S SWELL 6.0 270\n",
      "2022 05 10 11 40 2.1 1.5 8.1 1.3 5.0 W S SWELL 6.0 270\n",
      "2022 05 10 12 40 2.2 1.5 8.2 1.3 5.0 W S SWELL 6.0 270\n"}},
    {"NDBC, meteorology",
     true,
     "#YY  MM DD hh mm WDIR WSPD GST  WVHT   DPD   APD MWD   PRES\n#yr  mo dy hr mn degT m/s  m/s     m   sec   sec "
     "degT   hPa\n",
     {"2022 05 12 21 50 170  3.0  4.0   1.0     9   6.7  81 1027.6\n",
      "2022 05 12 22 50 150  3.0  4.0   1.1    10   6.8  71 1027.8\n",
      "2022 05 12 23 40 140  2.0  3.0   1.2    MM   6.8  71 1027.8\n"}},
    {"SWAN, 2-D",
     true,
     SWAN_HEAD,
     {"20200101.000000\nFACTOR\n1e-3\n100 200 300 400\n500 600 700 800\n",
      "20200101.010000\nFACTOR\n1e-3\n110 210 310 410\n500 600 700 800\n",
      "20200101.020000\nFACTOR\n1e-3\n120 220 320 420\n500 600 700 800\n"}},
    {"SWAN, 1-D",
     true,
     SWAN_1D,
     {"20200101.000000\nLOCATION 1\n1.00 90 20\n0.50 100 30\n",
      "20200101.010000\nLOCATION 1\n1.10 90 20\n0.60 110 30\n",
      "20200101.020000\nLOCATION 1\n1.20 90 20\n0.70 120 30\n"}},
    {"WAVEWATCH III",
     true,
     "'WAVEWATCH III SPECTRA' 2 4 1 'x'\n.1 .2\n0 1.57 3.14 4.71\n",
     {"20200101 000000\n'a' 5.0 1.0 10\n1.10 2.10 3.10 4.10\n1.20 2.20 3.20 4.20\n",
      "20200101 010000\n'a' 5.0 1.0 10\n1.30 2.10 3.10 4.10\n1.40 2.20 3.20 4.20\n",
      "20200101 020000\n'a' 5.0 1.0 10\n1.50 2.10 3.10 4.10\n1.60 2.20 3.20 4.20\n"}},
    {"WAVEWATCH III, partitions",
     true,
     "WAVEWATCH III PARTITIONED DATA FILE III 1.01\nyyyymmdd hhmmss lat lon name\n",
     {"20200101 000000 50.0 1.0 'p' 2 10 5 250\n0 2.00 9.0 126 270 30 0.5\n1 1.80 9.0 126 270 20 0.1\n2 0.87 5.0 39 "
      "180 30 0.9\n",
      "20200101 010000 50.0 1.0 'p' 2 10 5 250\n0 2.10 9.0 126 270 30 0.5\n1 1.90 9.0 126 270 20 0.1\n2 0.87 5.0 39 "
      "180 30 0.9\n",
      "20200101 020000 50.0 1.0 'p' 2 10 5 250\n0 2.20 9.0 126 270 30 0.5\n1 2.00 9.0 126 270 20 0.1\n2 0.87 5.0 39 "
      "180 30 0.9\n"}},
    {"a table of partitions",
     false,
     "time,hs_m,tp_s,direction_from_deg\n",
     {"2024-03-01T00:00Z,1.5,8.0,240\n", "2024-03-01T01:00Z,1.6,8.1,241\n", "2024-03-01T02:00Z,1.7,8.2,242\n"}},
    {"Spotter's table",
     false,
     SPOTTER_HEAD,
     {"56.8 ,1632834721 ,36.7 ,-121.8 ,0.03 ,0.04 ,0.05 ,0.01 ,0.01 ,0.01 ,.8,.8,.8,.1,.1,.1,.5,.5,.5,.1,.1,.1,"
      "0.5,0.9,0.4\n",
      "56.8 ,1632838321 ,36.7 ,-121.8 ,0.03 ,0.04 ,0.05 ,0.01 ,0.01 ,0.01 ,.8,.8,.8,.1,.1,.1,.5,.5,.5,.1,.1,.1,"
      "0.6,1.1,0.4\n",
      "56.8 ,1632841921 ,36.7 ,-121.8 ,0.03 ,0.04 ,0.05 ,0.01 ,0.01 ,0.01 ,.8,.8,.8,.1,.1,.1,.5,.5,.5,.1,.1,.1,"
      "0.7,1.2,0.4\n"}},
    {"AWAC",
     false,
     "",
     {"$PNORW,061224,000000,3,4,0.57,1.71\n$PNORE,061224,000000,3,0.10,0.01,3,0.500,1.000,0.500\n",
      "$PNORW,061224,010000,3,4,0.60,1.71\n$PNORE,061224,010000,3,0.10,0.01,3,0.600,1.000,0.500\n",
      "$PNORW,061224,020000,3,4,0.62,1.71\n$PNORE,061224,020000,3,0.10,0.01,3,0.700,1.000,0.500\n"}},
    {"Octopus",
     false,
     OCTOPUS_HEAD,
     {OCTOPUS_RECORD("010000", "2"), OCTOPUS_RECORD("011200", "3"), OCTOPUS_RECORD("020000", "4")}},
    {"TriAxys",
     false,
     "TRIAXYS BUOY DATA REPORT - TAS01970 - 4857.6668S16631.6837W\nTYPE    = DIRECTIONAL SPECTRUM\nDATE    = "
     "2018-01-31 "
     "21:00(UTC)\nNUMBER OF FREQUENCIES = 2\nINITIAL FREQUENCY (Hz) = 0.10\nFREQUENCY SPACING (Hz) = 0.01\nNUMBER OF "
     "DIRECTIONS = 4\nDIRECTION SPACING (DEG) = 90.0\nCOLUMNS = 0.0 TO 270.0 DEG\nROWS = 0.10 TO 0.11 HZ\n",
     {"0.01 0.02 0.01 0.01\n0.02 0.03 0.01 0.01\n", NULL, NULL}},
    {"TriAxys, without directions",
     false,
     "TRIAXYS BUOY DATA REPORT - TAS01970\nTYPE    = NON-DIRECTIONAL SPECTRUM\nDATE    = 2018 Jan 31 "
     "21:00(UTC)\nNUMBER "
     "OF FREQUENCIES = 2\nINITIAL FREQUENCY (Hz) = 0.10\nFREQUENCY SPACING (Hz) = 0.01\n",
     {"0.10 0.5\n0.11 0.7\n", NULL, NULL}},
    {"Datawell",
     false,
     "1\n2\n3\n0.8\n5\n6\n7\n8\n9\n10\n11\n12\n",
     {"0.10,0.5,270,20,0.1,3.0\n0.11,1.0,271,21,0.1,3.0\n0.12,0.4,272,22,0.1,3.0\n", NULL, NULL}},
    {"Obscape",
     false,
     "# Downloaded at 2024-04-13 19:04:00 [UTC]\n# Station name = buoy\n# Latitude [deg] = 12.1\n# Longitude [deg] = "
     "1.2\n# Timestamp = 1712136600\n# Directions = True North\n#\n# Columns [deg] = 0,90,... 270\n# Rows [Hz] = "
     "0.10,0.11,0.12\n# Variance-density [m2/Hz/rad]\n",
     {"0.1,0.2,0.1,0.0\n0.1,0.4,0.1,0.0\n0.1,0.2,0.1,0.0\n", NULL, NULL}},
};
#define SAMPLE_COUNT ((int)(sizeof(s_samples) / sizeof(s_samples[0])))

static size_t Compose(const Sample* sample, const char* const records[3], char* text)
{
    size_t used = (size_t)snprintf(text, MAX_TEXT, "%s", sample->head);
    for (int i = 0; i < 3; ++i)
    {
        used += (size_t)snprintf(text + used, MAX_TEXT - used, "%s", records[i] != NULL ? records[i] : "");
    }
    assert_true(used < MAX_TEXT);
    return used;
}

static swMeasuredSea* ReadSample(const Sample* sample)
{
    char text[MAX_TEXT];
    swMeasuredSea* sea = NULL;
    size_t size = Compose(sample, sample->records, text);
    if (Parse(text, size, &sea) != SW_SUCCESS)
    {
        fail_msg("%s: %s", sample->name, s_messages);
    }
    assert_int_equal(swMeasuredSea_GetCount(sea), sample->records[1] != NULL ? 3 : 1);
    return sea;
}

static bool IsSameRecord(const swMeasuredSea* a, int i, const swMeasuredSea* b, int j)
{
    swMeasuredRecord one = swMeasuredSea_GetRecord(a, i), other = swMeasuredSea_GetRecord(b, j);
    size_t count = (size_t)one.table.frequencyCount;
    size_t cells = count * (size_t)one.table.directionCount;
    return strcmp(one.time, other.time) == 0 && one.table.frequencyCount == other.table.frequencyCount &&
           one.table.directionCount == other.table.directionCount &&
           memcmp(one.energy, other.energy, count * sizeof(float)) == 0 &&
           memcmp(one.table.density, other.table.density, cells * sizeof(float)) == 0;
}

// ---- on their way ----

typedef enum Change
{
    BYTE_ORDER_MARK,
    CARRIAGE_RETURN_LINE_FEED,
    CARRIAGE_RETURN,
    TABS,
    NO_LAST_END,
    EMPTY_LINES_BEHIND,
    CHANGE_COUNT
} Change;

static size_t ChangeText(Change change, const char* text, size_t size, char* changed)
{
    size_t used = 0;
    if (change == BYTE_ORDER_MARK)
    {
        memcpy(changed, "\xEF\xBB\xBF", 3);
        used = 3;
    }
    bool isTitle = false; // a line that begins with words, or a name in quotes: its spaces stay
    for (size_t i = 0; i < size; ++i)
    {
        bool isEnd = text[i] == '\n';
        isTitle = i == 0 || text[i - 1] == '\n' ? text[i] == 'W' || text[i] == '\'' : isTitle;
        if (isEnd && (change == CARRIAGE_RETURN_LINE_FEED || change == CARRIAGE_RETURN))
        {
            changed[used++] = '\r';
        }
        if (!(isEnd && change == CARRIAGE_RETURN))
        {
            changed[used++] = change == TABS && text[i] == ' ' && !isTitle ? '\t' : text[i];
        }
    }
    while (change == NO_LAST_END && changed[used - 1] == '\n')
    {
        --used;
    }
    if (change == EMPTY_LINES_BEHIND)
    {
        memcpy(changed + used, "\n  \n\n", 5);
        used += 5;
    }
    return used;
}

static void EveryReaderTakesMarksAndLineEnds(void** state)
{
    (void)state;
    static const char* const names[CHANGE_COUNT] = {"a byte order mark", "CR LF", "CR", "tabs", "no last end",
                                                    "empty lines behind"};
    int tried = 0;
    for (int i = 0; i < SAMPLE_COUNT; ++i)
    {
        const Sample* sample = &s_samples[i];
        swMeasuredSea* sea = ReadSample(sample);
        for (int change = 0; change < CHANGE_COUNT; ++change)
        {
            char text[MAX_TEXT], changed[2 * MAX_TEXT];
            swMeasuredSea* other = NULL;
            size_t size = Compose(sample, sample->records, text);
            size = ChangeText((Change)change, text, size, changed);
            if (change == TABS && !sample->hasTabs)
            {
                continue;
            }
            if (Parse(changed, size, &other) != SW_SUCCESS)
            {
                fail_msg("%s with %s: %s", sample->name, names[change], s_messages);
            }
            assert_int_equal(swMeasuredSea_GetCount(other), swMeasuredSea_GetCount(sea));
            for (int j = 0; j < swMeasuredSea_GetCount(sea); ++j)
            {
                assert_true(IsSameRecord(sea, j, other, j));
            }
            swDestroyMeasuredSea(other);
            ++tried;
        }
        swDestroyMeasuredSea(sea);
    }
    print_message("%d formats, %d changes read as without\n", SAMPLE_COUNT, tried);
}

// ---- one broken record ----

// 0 to 2: cut off after a fifth and more; 3: a line's digits are letters; 4: a line's end is lost, where lines are
// records.
#define BREAK_COUNT 5

static bool Break(const char* record, int how, char* broken)
{
    size_t size = strlen(record);
    memcpy(broken, record, size + 1);
    if (how < 3)
    {
        snprintf(broken + size * (size_t)(how + 1) / 5, 3, "\n");
        return true;
    }
    if (how == 3)
    {
        char* at = broken + size * 3 / 5;
        while (at > broken && at[-1] != '\n')
        {
            --at;
        }
        for (; *at != '\0' && *at != '\n'; ++at)
        {
            *at = *at >= '0' && *at <= '9' ? 'x' : *at;
        }
        return true;
    }
    broken[size - 1] = '\0';
    return strchr(broken, '\n') == NULL;
}

// The records of `other` that are not lost are those of the whole sea.
static void CheckOthers(const Sample* sample, const swMeasuredSea* sea, const swMeasuredSea* other, int broken, int how)
{
    int found = 0;
    for (int i = 0; i < 3; ++i)
    {
        bool isThere = false;
        for (int j = 0; j < swMeasuredSea_GetCount(other); ++j)
        {
            isThere = isThere || IsSameRecord(sea, i, other, j);
        }
        found += isThere ? 1 : 0;
        bool mayBeLost = i == broken || (how == 4 && i == broken + 1); // two lines in one
        if (!isThere && !mayBeLost)
        {
            fail_msg("%s, record %d broken (%d): record %d is not as it was: %s", sample->name, broken, how, i,
                     s_messages);
        }
    }
    if (found < 3 && (strstr(s_messages, "warning: x:") == NULL || strstr(s_messages, "left out (line ") == NULL))
    {
        fail_msg("%s, record %d broken (%d): no warning, but %s", sample->name, broken, how, s_messages);
    }
    if (found == 3)
    {
        fail_msg("%s, record %d broken (%d) is read as if it were whole", sample->name, broken, how);
    }
}

static void OneBrokenRecordIsLeftOutWithItsLine(void** state)
{
    (void)state;
    int tried = 0;
    for (int i = 0; i < SAMPLE_COUNT; ++i)
    {
        const Sample* sample = &s_samples[i];
        swMeasuredSea* sea = ReadSample(sample);
        for (int which = 0; which < 3 && sample->records[1] != NULL; ++which)
        {
            for (int how = 0; how < BREAK_COUNT; ++how)
            {
                char text[MAX_TEXT], broken[MAX_TEXT];
                const char* records[3] = {sample->records[0], sample->records[1], sample->records[2]};
                bool isBroken = Break(records[which], how, broken) && !(how == 4 && which == 2);
                if (!isBroken)
                {
                    continue;
                }
                records[which] = broken;
                swMeasuredSea* other = NULL;
                size_t size = Compose(sample, records, text);
                if (Parse(text, size, &other) != SW_SUCCESS)
                {
                    fail_msg("%s, record %d broken (%d): %s", sample->name, which, how, s_messages);
                }
                CheckOthers(sample, sea, other, which, how);
                swDestroyMeasuredSea(other);
                ++tried;
            }
        }
        swDestroyMeasuredSea(sea);
    }
    print_message("%d formats, %d broken records left out\n", SAMPLE_COUNT, tried);
}

static void AFileOfBrokenRecordsIsRefused(void** state)
{
    (void)state;
    for (int i = 0; i < SAMPLE_COUNT; ++i)
    {
        const Sample* sample = &s_samples[i];
        char text[MAX_TEXT], broken[3][MAX_TEXT];
        const char* records[3] = {NULL, NULL, NULL};
        for (int j = 0; j < 3 && sample->records[j] != NULL; ++j)
        {
            Break(sample->records[j], 0, broken[j]);
            records[j] = broken[j];
        }
        swMeasuredSea* sea = NULL;
        size_t size = Compose(sample, records, text);
        assert_int_equal(Parse(text, size, &sea), SW_ERROR_FORMAT);
        assert_null(sea);
        assert_non_null(strstr(s_messages, "x:"));
    }
}

static void ManyBrokenLinesAreCounted(void** state)
{
    (void)state;
    char text[MAX_TEXT];
    size_t used = (size_t)snprintf(text, sizeof(text), "time,hs_m,tp_s\n2024-03-01T00:00Z,1.5,8.0\n");
    for (int i = 0; i < 50; ++i)
    {
        used += (size_t)snprintf(text + used, sizeof(text) - used, "2024-03-01T01:00Z,high,8.0\n");
    }
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(text, used, &sea), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetCount(sea), 1);
    assert_non_null(strstr(s_messages, "warning: x:3: hs_m is 'high'"));
    assert_non_null(strstr(s_messages, "warning: 45 more were left out for such reasons, 50 in all"));
    swDestroyMeasuredSea(sea);
}

// A list of frequencies that is a beginning of the others' is a line cut off, wherever it stands.
static void CutLinesOfFrequenciesAreLeftOut(void** state)
{
    (void)state;
    static const char first[] = "2021 02 28 22 10 0.2 1 (0.1) 2 (0.2)\n2021 02 28 23 10 0.2 1 (0.1) 2 (0.2) 3 (0.3)\n";
    static const char last[] = "2021 02 28 23 10 0.2 1 (0.1) 2 (0.2) 3 (0.3)\n2021 02 28 22 10 0.2 1 (0.1) 2 (0.2)\n";
    const char* const texts[2] = {first, last};
    for (int i = 0; i < 2; ++i)
    {
        swMeasuredSea* sea = NULL;
        assert_int_equal(Parse(texts[i], strlen(texts[i]), &sea), SW_SUCCESS);
        assert_int_equal(swMeasuredSea_GetCount(sea), 1);
        assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, "2021-02-28 23:10");
        assert_non_null(strstr(s_messages, i == 0 ? "x:1: the line has 2 frequencies where others have more"
                                                  : "x:2: the line has 2 frequencies where others have 3"));
        swDestroyMeasuredSea(sea);
    }
}

// ---- partitions that are not there ----

static double GetHeight(const swMeasuredSea* sea, int index)
{
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, index);
    double variance = 0.0;
    for (int i = 0; i < record.table.frequencyCount; ++i)
    {
        variance += (double)record.energy[i] * (double)record.table.bandwidths[i];
    }
    return 4.0 * sqrt(variance);
}

static void EmptyPartitionsAreLeftOut(void** state)
{
    (void)state;
    static const char* const empties[] = {
        "0,0,,,",   ",,,,",     "NaN,NaN,NaN,NaN,NaN",  "-999,-999,-999,-999,-999", "MM,MM,MM,MM,MM",
        "nan,0,,,", "0,,270,,", "-99.9,-99.9,-999.9,,", "-9,-9,-9,-9,-9",           "null,null,null,null,null"};
    for (size_t i = 0; i < sizeof(empties) / sizeof(empties[0]); ++i)
    {
        char text[512];
        int size = snprintf(text, sizeof(text),
                            "time,hs_m,tp_s,direction_from_deg,spread_deg,gamma\n2024-03-01T00:00Z,1.5,8.0,240,,\n"
                            "2024-03-01T00:00Z,%s\n2024-03-01T01:00Z,1.2,8.0,240,,\n",
                            empties[i]);
        swMeasuredSea* sea = NULL;
        if (Parse(text, (size_t)size, &sea) != SW_SUCCESS)
        {
            fail_msg("%s: %s", empties[i], s_messages);
        }
        assert_int_equal(swMeasuredSea_GetCount(sea), 2);
        assert_true(fabs(GetHeight(sea, 0) - 1.5) < 1e-4 && fabs(GetHeight(sea, 1) - 1.2) < 1e-4);
        assert_int_equal(swMeasuredSea_GetRecord(sea, 0).partitionCount, 1);
        assert_non_null(strstr(s_messages, "warning: x:3: 1 partitions have no height or period"));
        swDestroyMeasuredSea(sea);
    }
}

static void EmptyPartitionsOfWavewatchAreLeftOut(void** state)
{
    (void)state;
    static const char text[] = "WAVEWATCH III PARTITIONED DATA FILE III 1.01\n"
                               "20200101 000000 50.0 1.0 'p' 3 10 5 250\n0 2.00 9.0 126 270 30 0.5\n"
                               "1 2.00 9.0 126 270 20 0.1\n2 -999.9 -999.9 -999.9 -999.9 -999.9 -9.9\n"
                               "3 NaN NaN ****** NaN NaN NaN\n";
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(text, sizeof(text) - 1, &sea), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetRecord(sea, 0).partitionCount, 1);
    assert_true(fabs(GetHeight(sea, 0) - 2.0) < 1e-4);
    assert_non_null(strstr(s_messages, "2 partitions have no height or period"));
    swDestroyMeasuredSea(sea);
}

// What a spreadsheet leaves when it saves a table.
static void TablesMayHaveTabsOrSemicolons(void** state)
{
    (void)state;
    static const char pattern[] = "time,hs_m,tp_s,direction_from_deg,location\n2024-03-01T00:00Z,1.5,8.0,240,a\n"
                                  "2024-03-01T01:00Z,1.2,8.0,,b\n,1.0,8.0,240,a\n";
    for (int i = 0; i < 3; ++i)
    {
        char text[sizeof(pattern)];
        memcpy(text, pattern, sizeof(pattern));
        for (char* c = text; *c != '\0'; ++c)
        {
            *c = *c == ',' ? ",\t;"[i] : *c;
        }
        swMeasuredSea* sea = NULL;
        assert_int_equal(Parse(text, sizeof(pattern) - 1, &sea), SW_SUCCESS);
        assert_int_equal(swMeasuredSea_GetCount(sea), 2);
        assert_true(fabs(GetHeight(sea, 0) - 1.5) < 1e-4 && fabs(GetHeight(sea, 1) - 1.2) < 1e-4);
        assert_non_null(swMeasuredSea_GetRecord(sea, 0).meanDirection);
        assert_null(swMeasuredSea_GetRecord(sea, 1).meanDirection);
        assert_non_null(strstr(s_messages, "x:4: time is ''"));
        swDestroyMeasuredSea(sea);
    }
}

static void BorrowedDirectionsAreTold(void** state)
{
    (void)state;
    static const char text[] = "time,hs_m,tp_s,direction_from_deg\n2024-03-01,1.5,8.0,240\n2024-03-01,0.5,12.0,\n";
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(text, sizeof(text) - 1, &sea), SW_SUCCESS);
    assert_non_null(strstr(s_messages, "1 partitions have no direction and take that of the largest"));
    swDestroyMeasuredSea(sea);
}

static void WideCharactersAreNamed(void** state)
{
    (void)state;
    static const char text[] = "\xFF\xFEt\0i\0m\0e\0";
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(text, sizeof(text) - 1, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "x:1: the text is UTF-16; save it as UTF-8"));
}

static void ABrokenFirstLineHidesNoFormat(void** state)
{
    (void)state;
    static const char text[] = "2022 05 12 x 0.2 1 (0.1) 1 (0.2)\n2022 05 12 23 50 0.2 1 (0.1) 1 (0.2)\n";
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(text, sizeof(text) - 1, &sea), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetCount(sea), 1);
    assert_non_null(strstr(s_messages, "x:1: the hour is 'x'"));
    swDestroyMeasuredSea(sea);
}

// ---- directions for energies ----

static void DirectionFilesAreKnownByTheirHeading(void** state)
{
    (void)state;
    static const char* const headings[] = {"alpha1_1 (freq_1) alpha1_2 (freq_2) ... >",
                                           "alpha2_1 (freq_1) ... >",
                                           "r1_1 (freq_1) ... >",
                                           "r2_1 (freq_1) ... >",
                                           "alpha1",
                                           "r1"};
    for (size_t i = 0; i < sizeof(headings) / sizeof(headings[0]); ++i)
    {
        char text[512];
        int size = snprintf(text, sizeof(text), "#YY  MM DD hh mm %s\n2022 01 01 00 00 0.5 (0.100) 0.6 (0.110)\n",
                            headings[i]);
        swMeasuredSea* sea = NULL;
        assert_int_equal(Parse(text, (size_t)size, &sea), SW_ERROR_FORMAT);
        assert_null(sea);
        assert_non_null(strstr(s_messages, "x:1: these are "));
        assert_non_null(strstr(s_messages, "not energies"));
        assert_non_null(strstr(s_messages, "Name the set by its file of energies"));
    }
}

// Archives name nothing: numbers that no waves have are refused.
static void DirectionArchivesAreKnownByTheirNumbers(void** state)
{
    (void)state;
    static const char directions[] = "#YY MM DD hh mm .10 .20 .30 .40\n2021 01 01 00 40 999 250 180 90\n"
                                     "2021 01 01 01 40 10 250 180 90\n";
    static const char percents[] = "#YY MM DD hh mm .10 .20 .30 .40\n2021 01 01 00 40 80 70 60 50\n";
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(directions, sizeof(directions) - 1, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "x:2: these can be no energies"));
    assert_int_equal(Parse(percents, sizeof(percents) - 1, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "x:2: these can be no energies"));
    assert_null(sea);
}

// A file of directions in the place of one of lengths is as wrong.
static void FilesOfASetMayNotChangePlaces(void** state)
{
    (void)state;
    static const char energy[] =
        "#YY MM DD hh mm Sep_Freq < spec_1 (freq_1) ... >\n2022 01 01 00 00 9.999 .5 (0.10) .6 "
        "(0.11)\n";
    static const char alpha[] = "#YY MM DD hh mm alpha1_1 (freq_1) ... >\n2022 01 01 00 00 90 (0.10) 100 (0.11)\n";
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    s_messages[0] = '\0';
    swNdbcTexts texts = {.energy = energy, .r1 = alpha, .energySize = sizeof(energy) - 1, .r1Size = sizeof(alpha) - 1};
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseNdbc(&host, &texts, &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "these are directions (alpha1), not lengths of moments (r1)"));
}

// ---- many places ----

#define PLACES 8000

static size_t WritePoints(char* text, size_t room)
{
    size_t used = (size_t)snprintf(text, room, "WAVEWATCH III PARTITIONED DATA FILE III 1.01\n");
    for (int time = 0; time < 2; ++time)
    {
        for (int i = 0; i < PLACES; ++i)
        {
            int j = time == 0 ? i : (int)((long long)i * 7919 % PLACES); // another order
            used += (size_t)snprintf(text + used, room - used,
                                     "20200101 %02d0000 %.2f %.2f 'grid' 1 9 9 9\n0 %.4f 9 9 9 9 0\n1 %.4f 9 9 9 9 0\n",
                                     time, 0.01 * (j % 300), 0.01 * (j / 300), 1.0 + 0.0001 * j, 1.0 + 0.0001 * j);
        }
    }
    return used;
}

static void PlacesOfAGridAreFoundInAnyOrder(void** state)
{
    (void)state;
    size_t room = (size_t)PLACES * 200;
    char* text = malloc(room);
    size_t size = WritePoints(text, room);
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(text, size, &sea), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetLocationCount(sea), PLACES);
    for (int i = 0; i < PLACES; ++i)
    {
        swMeasuredLocation place = swMeasuredSea_GetLocation(sea, i);
        assert_int_equal(place.recordCount, 2);
        assert_true(fabs(place.latitude - 0.01 * (i % 300)) < 1e-9 && fabs(place.longitude - 0.01 * (i / 300)) < 1e-9);
        assert_true(fabs(GetHeight(sea, place.firstRecord + 1) - 1.0 - 0.0001 * i) < 1e-4);
    }
    swDestroyMeasuredSea(sea);
    free(text);
}

// Each was sought from the first on: the square of their number.
static void PlacesAreFoundByNameInLinearTime(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swMeasuredSea* sea = NULL;
    double seconds[2];
    for (int round = 0; round < 2; ++round)
    {
        int count = round == 0 ? 50000 : 100000;
        clock_t begin = clock();
        assert_int_equal(swCreateMeasuredSea(&host, NULL, &sea), SW_SUCCESS);
        for (int i = 0; i < 2 * count; ++i)
        {
            char name[16];
            snprintf(name, sizeof(name), "P%d", i % count);
            assert_int_equal(swMeasuredSea_FindLocation(sea, name), i < count ? -1 : i - count);
            assert_int_equal(i < count ? swMeasuredSea_AddLocation(sea, name, 1.0, 2.0, NULL) : SW_SUCCESS, SW_SUCCESS);
        }
        seconds[round] = (double)(clock() - begin) / CLOCKS_PER_SEC;
        swDestroyMeasuredSea(sea);
    }
    print_message("50000 places: %.3f s, twice as many: %.1f times as long\n", seconds[0], seconds[1] / seconds[0]);
}

// ---- the files that showed these faults ----

static void FaultyFilesAreReadAsTheyShould(void** state)
{
    (void)state;
    static const struct
    {
        const char* name;
        int count; // 0: refused
        double heights[5];
    } files[] = {
        {"partitions_with_empty.csv", 5, {1.616, 1.4, 1.3, 1.2, 1.1}},
        {"joined_lines.txt", 8, {0.9, 1.0, 1.0, 1.0, 1.0}},
        {"with_bom.data_spec", 1, {0.833, 0, 0, 0, 0}},
        {"alone.swdir", 0, {0}},
    };
    for (size_t i = 0; i < sizeof(files) / sizeof(files[0]); ++i)
    {
        char path[512];
        size_t size = 0;
        snprintf(path, sizeof(path), "%s/%s", FAULTS, files[i].name);
        char* text = ReadTextFile(path, &size);
        if (text == NULL)
        {
            continue;
        }
        swMeasuredSea* sea = NULL;
        assert_int_equal(Parse(text, size, &sea), files[i].count > 0 ? SW_SUCCESS : SW_ERROR_FORMAT);
        assert_int_equal(sea != NULL ? swMeasuredSea_GetCount(sea) : 0, files[i].count);
        for (int j = 0; j < files[i].count && j < 5; ++j)
        {
            assert_true(fabs(GetHeight(sea, j) - files[i].heights[j]) < 2e-3);
        }
        swDestroyMeasuredSea(sea);
        free(text);
    }
}

// ---- what would be wrong without a word ----

#define TRIAXYS_HEAD(zone)                                                                                             \
    "TRIAXYS BUOY DATA REPORT - TAS1\nTYPE = DIRECTIONAL SPECTRUM\nDATE = 2018-01-31 21:00" zone                       \
    "\nNUMBER OF FREQUENCIES = 2\nINITIAL FREQUENCY (Hz) = 0.10\nFREQUENCY SPACING (Hz) = 0.01\nNUMBER OF "            \
    "DIRECTIONS = 4\nDIRECTION SPACING (DEG) = 90.0\nCOLUMNS = 0.0 TO 270.0 DEG\n"
#define OBSCAPE_HEAD(unit) "# Columns [deg] = 0,90,180,270\n# Rows [Hz] = 0.1,0.2\n" unit "1,2,3,4\n1,2,3,4\n"
#define METEOROLOGY(unit)                                                                                              \
    "#YY MM DD hh mm WVHT DPD APD MWD\n#yr mo dy hr mn " unit " sec sec degT\n2020 01 02 03 04 2 9 7 80\n"
#define PARTITION(column, value) "time,hs_m,tp_s," column "\n2020-01-02 03:04,2,9," value "\n"

static void DoubtsAreSaid(void** state)
{
    (void)state;
    static const struct
    {
        bool isRead;
        const char *text, *words; // no words: none are said
    } cases[] = {
        {true, TRIAXYS_HEAD("(UTC)") ".1 .2 .1 .1\n.1 .2 .1 .1\n", NULL},
        {true, TRIAXYS_HEAD("") ".1 .2 .1 .1\n.1 .2 .1 .1\n", NULL},
        {true, TRIAXYS_HEAD("(GMT-8)") ".1 .2 .1 .1\n.1 .2 .1 .1\n", "it is taken as UTC"},
        {true, TRIAXYS_HEAD("(PST)") ".1 .2 .1 .1\n.1 .2 .1 .1\n", "it is taken as UTC"},
        {false, TRIAXYS_HEAD("(UTC)") ".1 .2 .1 .1 7\n.1 .2 .1 .1\n", "more numbers than its heading tells"},
        {false, TRIAXYS_HEAD("(UTC)") "0,1 .2 .1 .1\n.1 .2 .1 .1\n", "x:"},
        {false, TRIAXYS_HEAD("(UTC)") ".1 .2 .1 .1\n.1 .2 .1 .1\n.1 .2 .1 .1\n", "more numbers than its heading tells"},
        {false,
         "TRIAXYS BUOY DATA REPORT\nTYPE = DIRECTIONAL SPECTRUM\nNUMBER OF FREQUENCIES = 2\nFREQUENCY SPACING (Hz) = "
         ".1\nNUMBER OF DIRECTIONS = 5\nDIRECTION SPACING (DEG) = 45\nCOLUMNS = 0.00 TO 360.00 DEG\n1 2 3 4 1\n1 2 3 4 "
         "1\n",
         "the heading contradicts itself"},
        {false,
         "TRIAXYS BUOY DATA REPORT\nTYPE = DIRECTIONAL SPECTRUM\nNUMBER OF FREQUENCIES = 2\nFREQUENCY SPACING (Hz) = "
         ".1\nNUMBER OF DIRECTIONS = 7\nDIRECTION SPACING (DEG) = 90\n1 2 3 4 1 2 3\n1 2 3 4 1 2 3\n",
         "the heading contradicts itself"},
        {true, OBSCAPE_HEAD("# Variance-density [m2/Hz/rad]\n"), NULL},
        {true, OBSCAPE_HEAD("# Variance-density [m^2/Hz/deg]\n"), NULL},
        {true, OBSCAPE_HEAD(""), "they are taken per radian"},
        {true, OBSCAPE_HEAD("# Variance-density\n"), "they are taken per radian"},
        {false, OBSCAPE_HEAD("# Variance-density [cm2/Hz/deg]\n"), "the unit of densities is 'cm2/Hz/deg'"},
        {true, METEOROLOGY("m"), NULL},
        {false, METEOROLOGY("ft"), "x:2: WVHT is in 'ft'; heights are read in m."},
        {true, PARTITION("direction_from_deg", "230"), NULL},
        {true, PARTITION("remark", "230"), NULL},
        {true, PARTITION("direction_to_deg", "230"), "x:1: the column 'direction_to_deg' is passed over"},
        {true, PARTITION("direction_from", "230"), "x:1: the column 'direction_from' is passed over"},
        {true, PARTITION("spread_deg", "2"), "1 partitions have a spread below 5.7 degrees"},
        {true, PARTITION("spread_deg", "12"), NULL},
        {false, OCTOPUS_HEAD "CCYYMM,DDHHmm,LPoint\n201412,'010000,spec\nfreq,0.10,0.11,0.12\n0,1e-3,1e-3,1e-3,7\n",
         "x:12: the line has more variances than the 3 frequencies"},
        {false,
         OCTOPUS_HEAD "CCYYMM,DDHHmm,LPoint\n201412,'010000,spec\nfreq,0.10,0.11,0.12\n0,1e-3,1e-3,1e-3\n0,1e-3,"
                      "1e-3,1e-3\n",
         "the direction 0 stands there twice"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swMeasuredSea* sea = NULL;
        swResult result = Parse(cases[i].text, strlen(cases[i].text), &sea);
        bool isSaid = cases[i].words != NULL ? strstr(s_messages, cases[i].words) != NULL : s_messages[0] == '\0';
        if ((result == SW_SUCCESS) != cases[i].isRead || !isSaid)
        {
            fail_msg("%s\nsays \"%s\" and not \"%s\"", cases[i].text, s_messages, cases[i].words);
        }
        swDestroyMeasuredSea(sea);
    }
}

// A density that is missing between others takes its energy from the record; at the rim, or where the sea has none, it
// takes nothing.
static void MissingDensitiesAreCounted(void** state)
{
    (void)state;
#define BUOY_HEAD "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n2022 05 12 21 50 0.250 "
#define WW3_HEAD "'WAVEWATCH III SPECTRA' 2 4 1 'x'\n.1 .2\n0 1.57 3.14 4.71\n20200101 000000\n'a' 5.0 1.0 10\n"
#define SPOTTER_ROW "5,1632834721,36.7,-121.8,.03,.04,.05,.01,.01,.01,.8,.8,.8,.1,.1,.1,.5,.5,.5,.1,.1,.1,"
    static const struct
    {
        int count;
        const char* text;
    } cases[] = {
        {0, BUOY_HEAD "0.5 (0.100) 1.0 (0.110) 0.4 (0.120)\n"},
        {1, BUOY_HEAD "0.5 (0.100) 999.0 (0.110) 0.4 (0.120)\n"},
        {2, BUOY_HEAD "0.5 (0.100) MM (0.110) 999.0 (0.120) 0.4 (0.130)\n"},
        {0, BUOY_HEAD "999.0 (0.090) 0.0 (0.100) 1.0 (0.110) 0.4 (0.120)\n"},
        {1, SPOTTER_HEAD SPOTTER_ROW "0.5,,0.4\n"},
        {0, SPOTTER_HEAD SPOTTER_ROW "0.5,0.9,0.4\n"},
        {1, "$PNORE,061224,000000,3,0.10,0.01,3,0.500,-9.000,0.500\n"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swMeasuredSea* sea = NULL;
        if (Parse(cases[i].text, strlen(cases[i].text), &sea) != SW_SUCCESS)
        {
            fail_msg("%s", s_messages);
        }
        if (swMeasuredSea_GetRecord(sea, 0).missingCount != cases[i].count ||
            (strstr(s_messages, "densities are missing between others") != NULL) != (cases[i].count > 0))
        {
            fail_msg("%s\n%s", cases[i].text, s_messages);
        }
        swDestroyMeasuredSea(sea);
    }
    // By direction: one cell beside the peak, a whole frequency, and one far from all waves.
    float nothing = (float)NAN;
    for (int i = 0; i < 3; ++i)
    {
        double frequencies[3] = {0.1, 0.11, 0.12}, directions[8];
        double density[3][8];
        for (int j = 0; j < 8; ++j)
        {
            directions[j] = 0.25 * SW_PI * j;
            density[0][j] = density[1][j] = density[2][j] = j == 4 ? 1.0 : j < 4 && j > 1 ? 0.2 : 0.0;
            density[1][j] = i == 1 ? (double)nothing : density[1][j];
        }
        density[1][3] = i == 0 ? (double)nothing : density[1][3];
        density[1][7] = i == 2 ? (double)nothing : density[1][7];
        swHost host = swDefaultHost();
        host.log = KeepMessages;
        s_messages[0] = '\0';
        swMeasuredSea* sea = NULL;
        assert_int_equal(swCreateMeasuredSea(&host, "x", &sea), SW_SUCCESS);
        swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
        def.frequencyCount = 3;
        def.frequencies = frequencies;
        def.directionCount = 8;
        def.directions = directions;
        def.density = &density[0][0];
        assert_int_equal(swMeasuredSea_AddSpectrum(sea, &def), SW_SUCCESS);
        assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
        assert_int_equal(swMeasuredSea_GetRecord(sea, 0).missingCount, i < 2 ? 1 : 0);
        swDestroyMeasuredSea(sea);
    }
}

// Direction files that are there but of another hour or other frequencies.
static void DirectionsThatFindNoRecordAreTold(void** state)
{
    (void)state;
    static const char* const alphas[] = {
        "#YY MM DD hh mm alpha1_1 (freq_1) ... >\n2022 05 12 21 50 90.0 (0.100) 91.0 (0.110)\n",
        "#YY MM DD hh mm alpha1_1 (freq_1) ... >\n2022 05 12 21 40 90.0 (0.100) 91.0 (0.110)\n",
        "#YY MM DD hh mm alpha1_1 (freq_1) ... >\n2022 05 12 21 50 90.0 (0.200) 91.0 (0.210)\n",
    };
    for (int i = 0; i < 3; ++i)
    {
        swHost host = swDefaultHost();
        host.log = KeepMessages;
        s_messages[0] = '\0';
        swNdbcTexts texts = {0};
        texts.energy = BUOY_HEAD "0.5 (0.100) 1.0 (0.110)\n";
        texts.energySize = strlen(texts.energy);
        texts.alpha1 = alphas[i];
        texts.alpha1Size = strlen(texts.alpha1);
        swMeasuredSea* sea = NULL;
        assert_int_equal(swParseNdbc(&host, &texts, &sea), SW_SUCCESS);
        bool isTold = strstr(s_messages, "1 of 1 records find no directions of their time and frequencies") != NULL;
        assert_true(isTold == (i > 0));
        swDestroyMeasuredSea(sea);
    }
}

// Two bins of the buoys' usual set that are not neighbours in it meet half-way, and keep their energy.
static void BandsWithGapsMeet(void** state)
{
    (void)state;
    const char* text = BUOY_HEAD "1.0 (0.100) 1.0 (0.120)\n";
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(text, strlen(text), &sea), SW_SUCCESS);
    assert_true(fabs(GetHeight(sea, 0) - 4.0 * sqrt(0.04)) < 1e-4);
    swDestroyMeasuredSea(sea);
}

// A needle's waves all run one way: what cannot be told so narrow becomes a little wider, not a sea from both sides.
static void NeedlesStayOnOneSide(void** state)
{
    (void)state;
    for (int i = 0; i < 3; ++i)
    {
        double r1 = 0.995 + 0.002 * i, r2 = r1 * r1 * r1 * r1;
        double frequencies[2] = {0.1, 0.11}, energy[2] = {1.0, 1.0};
        double a1[2] = {r1, r1}, a2[2] = {r2, r2}, b[2] = {0.0, 0.0};
        swHost host = swDefaultHost();
        swMeasuredSea* sea = NULL;
        assert_int_equal(swCreateMeasuredSea(&host, "x", &sea), SW_SUCCESS);
        swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
        def.frequencyCount = 2;
        def.frequencies = frequencies;
        def.energy = energy;
        def.a1 = a1;
        def.b1 = def.b2 = b;
        def.a2 = a2;
        assert_int_equal(swMeasuredSea_AddSpectrum(sea, &def), SW_SUCCESS);
        assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
        const swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        double cosine = 0.0, sum = 0.0;
        for (int j = 0; j < record.table.directionCount; ++j)
        {
            sum += (double)record.table.density[j];
            cosine += (double)record.table.density[j] * cos(2.0 * SW_PI * j / record.table.directionCount);
        }
        assert_true(cosine / sum > 0.985);
        swDestroyMeasuredSea(sea);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryReaderTakesMarksAndLineEnds),
        cmocka_unit_test(OneBrokenRecordIsLeftOutWithItsLine),
        cmocka_unit_test(AFileOfBrokenRecordsIsRefused),
        cmocka_unit_test(ManyBrokenLinesAreCounted),
        cmocka_unit_test(CutLinesOfFrequenciesAreLeftOut),
        cmocka_unit_test(EmptyPartitionsAreLeftOut),
        cmocka_unit_test(EmptyPartitionsOfWavewatchAreLeftOut),
        cmocka_unit_test(TablesMayHaveTabsOrSemicolons),
        cmocka_unit_test(BorrowedDirectionsAreTold),
        cmocka_unit_test(WideCharactersAreNamed),
        cmocka_unit_test(ABrokenFirstLineHidesNoFormat),
        cmocka_unit_test(DirectionFilesAreKnownByTheirHeading),
        cmocka_unit_test(DirectionArchivesAreKnownByTheirNumbers),
        cmocka_unit_test(FilesOfASetMayNotChangePlaces),
        cmocka_unit_test(PlacesOfAGridAreFoundInAnyOrder),
        cmocka_unit_test(PlacesAreFoundByNameInLinearTime),
        cmocka_unit_test(FaultyFilesAreReadAsTheyShould),
        cmocka_unit_test(DoubtsAreSaid),
        cmocka_unit_test(MissingDensitiesAreCounted),
        cmocka_unit_test(DirectionsThatFindNoRecordAreTold),
        cmocka_unit_test(BandsWithGapsMeet),
        cmocka_unit_test(NeedlesStayOnOneSide),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
