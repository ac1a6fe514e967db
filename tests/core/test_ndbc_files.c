// SPDX-License-Identifier: MIT
// The files of an NDBC set lie beside each other under names that follow from one another: all are found, plain or
// gzip, and a file of directions alone is refused with the name of the file that is wanted.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

#include "seaway/math.h"
#include "seaway/files.h"

static char s_folder[] = "/tmp/seaway_ndbc_XXXXXX";

// ---- files ----

#define FILE_COUNT 5

// What each file of a set holds: energy, alpha1, alpha2, r1, r2. Waves come from 200 degrees.
static const char* const s_archive[FILE_COUNT] = {
    "#YY MM DD hh mm .10 .11 .12\n2019 01 01 00 40 1.0 2.0 1.0\n",
    "#YY MM DD hh mm .10 .11 .12\n2019 01 01 00 40 200 200 200\n",
    "#YY MM DD hh mm .10 .11 .12\n2019 01 01 00 40 200 200 200\n",
    "#YY MM DD hh mm .10 .11 .12\n2019 01 01 00 40 90 90 90\n",
    "#YY MM DD hh mm .10 .11 .12\n2019 01 01 00 40 70 70 70\n",
};
static const char* const s_realTime[FILE_COUNT] = {
    "#YY MM DD hh mm Sep_Freq < spec_1 (freq_1) ... >\n2019 01 01 00 40 9.999 1.0 (0.10) 2.0 (0.11) 1.0 (0.12)\n",
    "#YY MM DD hh mm alpha1_1 (freq_1) ... >\n2019 01 01 00 40 200 (0.10) 200 (0.11) 200 (0.12)\n",
    "#YY MM DD hh mm alpha2_1 (freq_1) ... >\n2019 01 01 00 40 200 (0.10) 200 (0.11) 200 (0.12)\n",
    "#YY MM DD hh mm r1_1 (freq_1) ... >\n2019 01 01 00 40 0.9 (0.10) 0.9 (0.11) 0.9 (0.12)\n",
    "#YY MM DD hh mm r2_1 (freq_1) ... >\n2019 01 01 00 40 0.7 (0.10) 0.7 (0.11) 0.7 (0.12)\n",
};

static const char* MakePath(const char* name)
{
    static char path[256];
    snprintf(path, sizeof(path), "%s/%s", s_folder, name);
    return path;
}

static void WriteFile(const char* name, const char* text)
{
    size_t length = strlen(name);
    const char* mode = length > 3 && strcmp(name + length - 3, ".gz") == 0 ? "wb" : "wbT"; // T: as it is
    gzFile file = gzopen(MakePath(name), mode);
    assert_non_null(file);
    assert_int_equal(gzwrite(file, text, (unsigned)strlen(text)), (int)strlen(text));
    assert_int_equal(gzclose(file), Z_OK);
}

static swResult Read(const char* name, swMeasuredSea** sea)
{
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    s_messages[0] = '\0';
    *sea = NULL;
    return swReadMeasuredSea(&host, MakePath(name), sea);
}

static void WriteSet(const char* const names[FILE_COUNT], const char* const texts[FILE_COUNT])
{
    for (int i = 0; i < FILE_COUNT; ++i)
    {
        WriteFile(names[i], texts[i]);
    }
}

static void RemoveSet(const char* const names[FILE_COUNT])
{
    for (int i = 0; i < FILE_COUNT; ++i)
    {
        remove(MakePath(names[i]));
    }
}

// ---- sets ----

typedef struct Set
{
    bool isArchive;
    const char* names[FILE_COUNT];
} Set;

static const Set s_sets[] = {
    {true, {"41010w2019.txt", "41010d2019.txt", "41010i2019.txt", "41010j2019.txt", "41010k2019.txt"}},
    {true,
     {"41010w2019part.txt.gz", "41010d2019part.txt.gz", "41010i2019part.txt.gz", "41010j2019part.txt.gz",
      "41010k2019part.txt.gz"}},
    {true,
     {"fpsn7w2019.dat", "fpsn7d2019.dat.gz", "fpsn7i2019.dat", "fpsn7j2019.dat.gz", "fpsn7k2019.dat"}}, // some packed
    {true, {"46026w2019.gz", "46026d2019", "46026i2019", "46026j2019", "46026k2019"}},
    {true, {"4wdikw2019-a", "4wdikd2019-a", "4wdiki2019-a", "4wdikj2019-a", "4wdikk2019-a"}}, // letters in the station
    {false, {"44013.data_spec", "44013.swdir", "44013.swdir2", "44013.swr1", "44013.swr2"}},
    {false, {"44013.data_spec.gz", "44013.swdir.gz", "44013.swdir2", "44013.swr1.gz", "44013.swr2"}},
    {false, {"44013.swden", "44013.swdir", "44013.swdir2", "44013.swr1", "44013.swr2"}},
    {false,
     {"may.data_spec.txt", "may.swdir.txt", "may.swdir2.txt", "may.swr1.txt.gz", "may.swr2.txt"}}, // a suffix behind
};
#define SET_COUNT (sizeof(s_sets) / sizeof(s_sets[0]))

static void DirectionFilesAreFoundBesideTheEnergies(void** state)
{
    (void)state;
    for (size_t i = 0; i < SET_COUNT; ++i)
    {
        const char* const* names = s_sets[i].names;
        swMeasuredSea* sea = NULL;
        WriteSet(names, s_sets[i].isArchive ? s_archive : s_realTime);
        if (Read(names[0], &sea) != SW_SUCCESS)
        {
            fail_msg("%s: %s", names[0], s_messages);
        }
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, 0);
        if (record.meanDirection == NULL || s_messages[0] != '\0')
        {
            fail_msg("%s: no directions, or a message: %s", names[0], s_messages);
        }
        double bearing = (double)record.meanDirection[0] * 180.0 / SW_PI - 90.0;
        assert_true(fabs(remainder(bearing - 200.0, 360.0)) < 0.01);
        assert_true(fabsf(record.r1[0] - 0.9f) < 1e-5f && fabsf(record.r2[0] - 0.7f) < 1e-5f);
        swDestroyMeasuredSea(sea);
        RemoveSet(names);
    }
}

static void MissingDirectionFilesAreTold(void** state)
{
    (void)state;
    for (size_t i = 0; i < SET_COUNT; ++i)
    {
        const char* const* names = s_sets[i].names;
        const char* const* texts = s_sets[i].isArchive ? s_archive : s_realTime;
        swMeasuredSea* sea = NULL;
        WriteFile(names[0], texts[0]);
        assert_int_equal(Read(names[0], &sea), SW_SUCCESS);
        assert_null(swMeasuredSea_GetRecord(sea, 0).meanDirection);
        assert_non_null(strstr(s_messages, "warning: "));
        assert_non_null(strstr(s_messages, "has no file of directions"));
        swDestroyMeasuredSea(sea);

        WriteFile(names[1], texts[1]);
        WriteFile(names[2], texts[2]);
        WriteFile(names[4], texts[4]);
        assert_int_equal(Read(names[0], &sea), SW_SUCCESS);
        assert_non_null(swMeasuredSea_GetRecord(sea, 0).meanDirection);
        assert_non_null(strstr(s_messages, "has no file of r1 beside it"));
        swDestroyMeasuredSea(sea);
        RemoveSet(names);
    }
}

// A name that follows no pattern cannot lead to others, which is said.
static void StrangeNamesAreTold(void** state)
{
    (void)state;
    static const char* const names[] = {"energies.txt", "buoy_2019.txt", "grid2019.txt", "d2019.txt"};
    for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); ++i)
    {
        swMeasuredSea* sea = NULL;
        WriteFile(names[i], s_archive[0]);
        if (Read(names[i], &sea) != SW_SUCCESS)
        {
            fail_msg("%s: %s", names[i], s_messages);
        }
        assert_non_null(strstr(s_messages, "is not named as NDBC names a set"));
        swDestroyMeasuredSea(sea);
        remove(MakePath(names[i]));
    }
}

static void DirectionsAloneAreRefusedAndTheEnergiesNamed(void** state)
{
    (void)state;
    for (size_t i = 0; i < SET_COUNT; ++i)
    {
        const char* const* names = s_sets[i].names;
        const char* const* texts = s_sets[i].isArchive ? s_archive : s_realTime;
        for (int alone = 0; alone < 2; ++alone)
        {
            WriteSet(names, texts);
            if (alone != 0)
            {
                remove(MakePath(names[0]));
            }
            for (int j = 1; j < FILE_COUNT; ++j)
            {
                swMeasuredSea* sea = NULL;
                assert_int_equal(Read(names[j], &sea), SW_ERROR_FORMAT);
                assert_null(sea);
                const char* wanted = alone == 0 ? names[0] : s_sets[i].isArchive ? "w2019" : ".data_spec";
                if (strstr(s_messages, "not energies: name the file of energies") == NULL ||
                    strstr(s_messages, wanted) == NULL)
                {
                    fail_msg("%s: %s", names[j], s_messages);
                }
            }
            RemoveSet(names);
        }
    }
}

static int MakeFolder(void** state)
{
    (void)state;
    return mkdtemp(s_folder) != NULL ? 0 : -1;
}

static int RemoveFolder(void** state)
{
    (void)state;
    return rmdir(s_folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(DirectionFilesAreFoundBesideTheEnergies),
        cmocka_unit_test(MissingDirectionFilesAreTold),
        cmocka_unit_test(StrangeNamesAreTold),
        cmocka_unit_test(DirectionsAloneAreRefusedAndTheEnergiesNamed),
    };
    return cmocka_run_group_tests(tests, MakeFolder, RemoveFolder);
}
