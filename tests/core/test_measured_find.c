// SPDX-License-Identifier: MIT
// Records by time and places by where they lie: what is near is found, what is far is refused and the log says why.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "seaway/math.h"
#include "seaway/measured.h"

#define HOUR 3600.0

static swMeasuredSea* CreateSea(void)
{
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    s_messages[0] = '\0';
    swMeasuredSea* sea = NULL;
    assert_int_equal(swCreateMeasuredSea(&host, "sea.nc", &sea), SW_SUCCESS);
    return sea;
}

static void AddRecord(swMeasuredSea* sea, int location, double seconds, double height)
{
    const double frequencies[3] = {0.1, 0.11, 0.12}, energy[3] = {0.0, height * height, 0.0};
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.location = location;
    def.seconds = seconds;
    def.frequencyCount = 3;
    def.frequencies = frequencies;
    def.energy = energy;
    assert_int_equal(swMeasuredSea_AddSpectrum(sea, &def), SW_SUCCESS);
}

// Hourly from 2020-03-01 00:00 to 05:00, and from 12:00 to 14:00.
static swMeasuredSea* CreateBuoy(void)
{
    swMeasuredSea* sea = CreateSea();
    double begin = 0.0;
    assert_true(swParseMeasuredTime("2020-03-01", &begin));
    for (int i = 0; i < 15; ++i)
    {
        if (i <= 5 || i >= 12)
        {
            AddRecord(sea, 0, begin + i * HOUR, 1.0 + i);
        }
    }
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    return sea;
}

static const char* FindAt(const swMeasuredSea* sea, const char* time, char found[20])
{
    int index = -2;
    s_messages[0] = '\0';
    swResult result = swMeasuredSea_ChooseRecord(sea, -1, time, &index);
    assert_int_equal(result, index >= 0 ? SW_SUCCESS : SW_ERROR_INVALID);
    assert_int_equal(swMeasuredSea_FindRecord(sea, -1, time), index);
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, index);
    snprintf(found, 20, "%s", index >= 0 ? record.time : "none");
    return found;
}

static void TimesNearRecordsAreFound(void** state)
{
    (void)state;
    swMeasuredSea* sea = CreateBuoy();
    char found[20];
    assert_string_equal(FindAt(sea, "2020-03-01 02:20", found), "2020-03-01 02:00");
    assert_string_equal(s_messages, "");
    assert_string_equal(FindAt(sea, NULL, found), "2020-03-01 14:00"); // the highest
    assert_string_equal(FindAt(sea, "2020-03-01 14:30", found), "2020-03-01 14:00");
    assert_non_null(strstr(s_messages, "sea.nc: 2020-03-01 14:30 lies outside its records"));
    assert_non_null(strstr(s_messages, "2020-03-01 14:00 (UTC), 30 minutes away, is taken"));
    assert_string_equal(FindAt(sea, "2020-02-29 23:30", found), "2020-03-01 00:00");
    assert_string_equal(FindAt(sea, "2020-03-01 08:00", found), "2020-03-01 05:00");
    assert_non_null(strstr(s_messages, "in a gap between its records"));
    assert_non_null(strstr(s_messages, "3 hours away"));
    swDestroyMeasuredSea(sea);
}

static void TimesOutsideAreRefusedWithTheRange(void** state)
{
    (void)state;
    static const char* const outside[] = {"2020-03-01 14:31", "2020-02-29 23:29", "2021-03-01 02:00", "1999-01-01",
                                          "2020-03-02"};
    swMeasuredSea* sea = CreateBuoy();
    char found[20];
    for (size_t i = 0; i < sizeof(outside) / sizeof(outside[0]); ++i)
    {
        assert_string_equal(FindAt(sea, outside[i], found), "none");
        assert_non_null(strstr(s_messages, "run from 2020-03-01 00:00 to 2020-03-01 14:00 (UTC)"));
        assert_int_equal(swMeasuredSea_FindTime(sea, outside[i]), -1);
    }
    assert_string_equal(FindAt(sea, "yesterday", found), "none");
    assert_non_null(strstr(s_messages, "'yesterday' is no time"));
    swDestroyMeasuredSea(sea);
}

static void OneRecordAnswersForHalfAnHour(void** state)
{
    (void)state;
    char found[20];
    swMeasuredSea* sea = CreateSea();
    AddRecord(sea, 0, 1583020800.0, 1.0); // 2020-03-01 00:00
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    assert_string_equal(FindAt(sea, "2020-03-01 00:30", found), "2020-03-01 00:00");
    assert_string_equal(FindAt(sea, "2020-03-01 00:31", found), "none");
    swDestroyMeasuredSea(sea);
}

static void DailyRecordsAnswerForHalfADay(void** state)
{
    (void)state;
    char found[20];
    swMeasuredSea* sea = CreateSea();
    for (int i = 0; i < 4; ++i)
    {
        AddRecord(sea, 0, 1583020800.0 + i * 24.0 * HOUR, 1.0);
    }
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    assert_string_equal(FindAt(sea, "2020-03-04 12:00", found), "2020-03-04 00:00");
    assert_string_equal(FindAt(sea, "2020-03-04 12:01", found), "none");
    swDestroyMeasuredSea(sea);
}

static void RecordsWithoutTimesAnswerNoTime(void** state)
{
    (void)state;
    char found[20];
    swMeasuredSea* sea = CreateSea();
    AddRecord(sea, 0, (double)NAN, 1.0);
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    assert_string_equal(FindAt(sea, "1970-01-01 00:00", found), "none");
    assert_non_null(strstr(s_messages, "no times"));
    int index = -1;
    assert_int_equal(swMeasuredSea_ChooseRecord(sea, -1, NULL, &index), SW_SUCCESS);
    assert_int_equal(index, 0);
    swDestroyMeasuredSea(sea);
}

// ---- places ----

static swMeasuredSea* CreatePlaces(void)
{
    static const struct
    {
        double longitude, latitude;
        bool hasRecord;
    } places[] = {{358.0, 50.0, true},  {(double)NAN, (double)NAN, true},
                  {179.9, -41.0, true}, {-2.3, 50.0, true},
                  {-2.05, 50.0, false}, {200.0, 89.9, true}};
    swMeasuredSea* sea = CreateSea();
    for (int i = 0; i < (int)(sizeof(places) / sizeof(places[0])); ++i)
    {
        int location = -1;
        char name[16];
        snprintf(name, sizeof(name), "P%d", i + 1);
        assert_int_equal(swMeasuredSea_AddLocation(sea, name, places[i].longitude, places[i].latitude, &location),
                         SW_SUCCESS);
        if (places[i].hasRecord)
        {
            AddRecord(sea, location, 0.0, 1.0);
        }
    }
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    return sea;
}

static void NearestPlaceIsFoundHoweverLongitudesAreCounted(void** state)
{
    (void)state;
    static const struct
    {
        double longitude, latitude;
        int place;
        double kilometres;
    } cases[] = {
        {-2.0, 50.0, 0, 0.0},  {358.0, 50.0, 0, 0.0},    {-2.06, 50.0, 0, 4.3}, // the place at -2.05 has no record
        {357.7, 50.0, 3, 0.0}, {-179.9, -41.0, 2, 16.8}, {180.1, -41.0, 2, 16.8},
        {20.0, 90.0, 5, 11.1}, {-1.9, 50.5, 0, 56.0},
    };
    swMeasuredSea* sea = CreatePlaces();
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        double distance = -1.0;
        int place = -1;
        s_messages[0] = '\0';
        assert_int_equal(swMeasuredSea_ChooseNearest(sea, cases[i].longitude, cases[i].latitude, &place, &distance),
                         SW_SUCCESS);
        assert_int_equal(place, cases[i].place);
        assert_true(fabs(distance / 1000.0 - cases[i].kilometres) < 0.05 + 0.002 * cases[i].kilometres);
        assert_non_null(strstr(s_messages, "km away"));
        assert_int_equal(strncmp(s_messages, "warning: ", 9) == 0, cases[i].kilometres > 25.0);
    }
    swDestroyMeasuredSea(sea);
}

static void FarPlacesAreRefused(void** state)
{
    (void)state;
    swMeasuredSea* sea = CreatePlaces();
    int place = 7;
    double distance = 0.0;
    s_messages[0] = '\0';
    assert_int_equal(swMeasuredSea_ChooseNearest(sea, 0.0, 50.0, &place, &distance), SW_ERROR_INVALID);
    assert_int_equal(place, -1);
    assert_non_null(strstr(s_messages, "number 1 at 50.0000, 358.0000, 143 km away; at most 100 km"));
    assert_int_equal(swMeasuredSea_FindNearest(sea, 0.0, 50.0, &distance), 0);
    assert_true(fabs(distance - 142.9e3) < 200.0);
    s_messages[0] = '\0';
    assert_int_equal(swMeasuredSea_ChooseNearest(sea, 0.0, 91.0, &place, NULL), SW_ERROR_INVALID);
    assert_int_equal(swMeasuredSea_ChooseNearest(sea, (double)NAN, 50.0, &place, NULL), SW_ERROR_INVALID);
    assert_non_null(strstr(s_messages, "latitude must be from -90 to 90"));
    swDestroyMeasuredSea(sea);

    sea = CreateSea();
    AddRecord(sea, 0, 0.0, 1.0);
    assert_int_equal(swMeasuredSea_Finish(sea), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_ChooseNearest(sea, 0.0, 0.0, &place, NULL), SW_ERROR_INVALID);
    assert_non_null(strstr(s_messages, "does not tell where its places lie"));
    swDestroyMeasuredSea(sea);
}

#if defined(NDEBUG) // with asserts misuse stops the program
static void NothingIsFoundInNoSea(void** state)
{
    (void)state;
    int index = 3;
    assert_int_equal(swMeasuredSea_ChooseRecord(NULL, 0, NULL, &index), SW_ERROR_INVALID);
    assert_int_equal(index, -1);
    assert_int_equal(swMeasuredSea_FindNearest(NULL, 0.0, 0.0, NULL), -1);
    assert_int_equal(swMeasuredSea_ChooseNearest(NULL, 0.0, 0.0, &index, NULL), SW_ERROR_INVALID);
    assert_int_equal(swMeasuredSea_GetDirections(NULL).meaning, SW_DIRECTIONS_BY_FORMAT);
    swMeasuredSea* sea = CreatePlaces();
    assert_int_equal(swMeasuredSea_ChooseRecord(sea, 0, NULL, NULL), SW_ERROR_INVALID);
    assert_int_equal(swMeasuredSea_ChooseNearest(sea, 0.0, 0.0, NULL, NULL), SW_ERROR_INVALID);
    swMeasuredDirections directions = {.meaning = (swDirectionMeaning)77};
    swMeasuredSea_SetDirections(sea, &directions);
    swMeasuredSea_SetDirections(sea, NULL);
    assert_int_equal(swMeasuredSea_GetDirections(sea).meaning, SW_DIRECTIONS_BY_FORMAT);
    swDestroyMeasuredSea(sea);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TimesNearRecordsAreFound),
        cmocka_unit_test(TimesOutsideAreRefusedWithTheRange),
        cmocka_unit_test(OneRecordAnswersForHalfAnHour),
        cmocka_unit_test(DailyRecordsAnswerForHalfADay),
        cmocka_unit_test(RecordsWithoutTimesAnswerNoTime),
        cmocka_unit_test(NearestPlaceIsFoundHoweverLongitudesAreCounted),
        cmocka_unit_test(FarPlacesAreRefused),
#if defined(NDEBUG)
        cmocka_unit_test(NothingIsFoundInNoSea),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
