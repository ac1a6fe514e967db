// SPDX-License-Identifier: MIT
// What files of wave models and buoys hold now and then, beside what their manuals show: names with apostrophes, points
// of grids that are no globe, months by name, numbers that no wave has. Each is read, or refused with its line.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "seaway/measured.h"

static swResult Parse(const char* text, swMeasuredSea** sea)
{
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    s_messages[0] = '\0';
    return swParseMeasuredSea(&host, text, strlen(text), "file", sea);
}

// ---- WAVEWATCH III ----

#define WAVEWATCH                                                                                                      \
    "'WAVEWATCH III SPECTRA'      2     4     1 'It''s a grid'\n"                                                      \
    "  0.500E-01 0.100E+00\n"                                                                                          \
    "   0.000E+00  0.157E+01  0.314E+01  0.471E+01\n"                                                                  \
    "20220912 060000\n"
#define WAVEWATCH_DENSITIES                                                                                            \
    "  0.100E+01  0.200E-01  0.200E+01  0.000E+00  0.000E+00  0.000E+00  0.000E+00\n"                                  \
    "  0.261-101\n"

static void PointNamesMayHoldApostrophes(void** state)
{
    (void)state;
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(WAVEWATCH "'St John''s'  47.50-152.71     176.0   1.45 225.6   0.18  94.1\n" //
                           WAVEWATCH_DENSITIES,
                           &sea),
                     SW_SUCCESS);
    swMeasuredLocation location = swMeasuredSea_GetLocation(sea, 0);
    assert_string_equal(location.name, "St John''s");
    assert_true(fabs(location.latitude - 47.5) < 1e-9);
    assert_true(fabs(location.longitude + 152.71) < 1e-9); // the columns touch
    swDestroyMeasuredSea(sea);
}

static void KilometresAreNoDegrees(void** state)
{
    (void)state;
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse(WAVEWATCH "'P1        ' 120.00 350.00      46.6   1.45 225.6   0.18  94.1\n" //
                           WAVEWATCH_DENSITIES,
                           &sea),
                     SW_SUCCESS);
    swMeasuredLocation location = swMeasuredSea_GetLocation(sea, 0);
    assert_true(isnan(location.latitude) && isnan(location.longitude));
    swDestroyMeasuredSea(sea);
}

// ---- TriAxys ----

#define TRIAXYS_REST                                                                                                   \
    "NUMBER OF FREQUENCIES              =   3\n"                                                                       \
    "INITIAL FREQUENCY (Hz)             =   0.050\n"                                                                   \
    "FREQUENCY SPACING (Hz)             =   0.050\n"                                                                   \
    "COLUMN 1 = FREQUENCY (Hz)\n"                                                                                      \
    "COLUMN 2 = SPECTRAL DENSITY (M^2/Hz)\n"                                                                           \
    "0.050  1.0000000E-01\n0.100  2.0000000E+00\n0.150  5.0000000E-01\n"

static void TriaxysMonthsMayBeNames(void** state)
{
    (void)state;
    static const struct
    {
        const char* date;
        const char* time;
    } dates[] = {
        {"2018 Feb 09 04:00(UTC)", "2018-02-09 04:00"},
        {"2018-February-09 04:00(UTC)", "2018-02-09 04:00"},
        {"2018-01-31 21:00(UTC)", "2018-01-31 21:00"},
        {"2019 DEC 31 23:59", "2019-12-31 23:59"},
    };
    for (size_t i = 0; i < sizeof(dates) / sizeof(dates[0]); ++i)
    {
        char text[1024];
        snprintf(text, sizeof(text),
                 "TRIAXYS BUOY %sREPORT - TAS04811\r\nVERSION = 5b.02.08\r\nTYPE    = NON-DIRECTIONAL SPECTRUM\r\n"
                 "DATE    = %s\r\n" TRIAXYS_REST,
                 i == 3 ? "" : "DATA ", dates[i].date);
        swMeasuredSea* sea = NULL;
        assert_int_equal(Parse(text, &sea), SW_SUCCESS);
        assert_string_equal(swMeasuredSea_GetRecord(sea, 0).time, dates[i].time);
        swDestroyMeasuredSea(sea);
    }
    swMeasuredSea* sea = NULL;
    assert_int_equal(Parse("TRIAXYS BUOY DATA REPORT\nTYPE = NON-DIRECTIONAL SPECTRUM\nDATE = 2018 Foo 09 04:00\n" //
                           TRIAXYS_REST,
                           &sea),
                     SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "file:3: DATE"));
}

// ---- SWAN ----

static swResult ParseSwanLine(const char* line, swMeasuredSea** sea)
{
    char text[1024];
    snprintf(text, sizeof(text),
             "SWAN   1\nLONLAT\n1\n1.0 2.0\nAFREQ\n2\n0.1\n0.2\nQUANT\n3\n"
             "VaDens\nm2/Hz\n-0.9900E+02\nCDIR\ndegr\n-0.9990E+03\nDSPRDEGR\ndegr\n-0.9000E+01\nLOCATION     1\n"
             "0.1 90.0 20.0\n%s\n",
             line);
    return Parse(text, sea);
}

static void DirectionsOfAThousandTurnsAreRefused(void** state)
{
    (void)state;
    swMeasuredSea* sea = NULL;
    assert_int_equal(ParseSwanLine("0.2 1e30 20.0", &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "file:22: a direction"));
    assert_int_equal(ParseSwanLine("0.2 90.0 -12.0", &sea), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "file:22: a spread"));
    assert_int_equal(ParseSwanLine("-99 -999 -9", &sea), SW_SUCCESS); // missing
    swDestroyMeasuredSea(sea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(PointNamesMayHoldApostrophes),
        cmocka_unit_test(KilometresAreNoDegrees),
        cmocka_unit_test(TriaxysMonthsMayBeNames),
        cmocka_unit_test(DirectionsOfAThousandTurnsAreRefused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
