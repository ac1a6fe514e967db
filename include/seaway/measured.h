// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "math.h"
#include "spectrum.h"

/// @file
/// Measured and computed seas: what a wave buoy reported or a wave model wrote, as records of directional spectra by
/// place and time. docs/spectra.md says which formats are read and what is assumed where a file is silent.
/// swReadMeasuredSea() in files.h reads files; here are the texts, and a way to bring data of one's own.

typedef struct swMeasuredSea swMeasuredSea;

/// One record of a measured sea.
typedef struct swMeasuredRecord
{
    /// UTC, "YYYY-MM-DD hh:mm"; empty if the file tells no time.
    char time[20];

    /// The same in seconds since 1970, not rounded to minutes; 0 if the file tells no time.
    double seconds;

    /// Index of the place, see swMeasuredSea_GetLocation().
    int location;

    /// The record as a directional spectrum; points into the swMeasuredSea.
    swSpectrumTable table;

    /// [frequencyCount] m^2/Hz.
    const float* energy;

    /// First circular moments: mean direction where waves go (radians) and r1, by frequency; r2 and its direction.
    /// Of a buoy's moments gaps are filled from the nearest frequency, impossible moments corrected: what the table was
    /// made from. Of a spectrum by direction they are the table's, of a summary those of all its systems together.
    /// NULL if the file holds no directions (the table is then spread as cos^2s with s = 8 around east).
    /// [frequencyCount]
    const float* meanDirection;
    const float* r1;
    const float* direction2;
    const float* r2;

    /// meanDirection and r1 where the file tells them, NAN where they were filled in: a gap, a direction without r1, a
    /// frequency without energy in a spectrum by direction. NULL if the file holds no directions. [frequencyCount]
    const float *measuredDirection, *measuredR1;

    /// How many frequencies had moments that no distribution can have and were corrected.
    int correctedCount;

    /// How many densities the file lacks between others that have energy. They count as none, so that the record is
    /// lower than the sea was. Where the neighbours have less than a hundredth of the largest density none is counted.
    int missingCount;

    /// How many densities were negative, as noise and smoothing leave them in files. They count as none, and the others
    /// of their frequency are scaled down so that the frequency keeps its energy. A frequency whose sum is negative,
    /// or a negative energy without directions, becomes nothing. A negative number larger than every density of the
    /// record marks what is missing, and nothing is scaled for it.
    int negativeCount;

    /// The variance that the negative densities took away, as a part of the record's variance; and the part by which
    /// the record has more than the file, for frequencies that could not keep their energy.
    float negativePart, addedPart;

    /// 0 if the file holds spectra. Of a summary or of partitions: of how many systems of waves the table was built up;
    /// then its shape is that of a formula and only heights, periods and directions are measured.
    int partitionCount;

    /// Of a summary: the average period that the buoy told, s, 0 if it did not; and of the record's largest system
    /// what was assumed, which gives the record that period where a shape can: the enhancement gamma of JONSWAP's
    /// peak, and the exponent n of its tail f^-n, which is 5 where gamma suffices. 0 of other files.
    float averagePeriod, gamma, tailExponent;
} swMeasuredRecord;

/// A place of a measured sea.
typedef struct swMeasuredLocation
{
    /// As the file has it, cut to 63 bytes; empty if it has none.
    char name[64];

    /// Degrees east and north; NAN if the file does not tell.
    double longitude, latitude;

    /// Its records, ascending in time: indices for swMeasuredSea_GetRecord().
    int firstRecord, recordCount;
} swMeasuredLocation;

/// What the directions in a file mean.
typedef enum swDirectionMeaning
{
    SW_DIRECTIONS_BY_FORMAT,   ///< what the format lays down; the file has no say in it
    SW_DIRECTIONS_FROM,        ///< degrees clockwise from north, where waves come from
    SW_DIRECTIONS_TO,          ///< degrees clockwise from north, where waves go
    SW_DIRECTIONS_TO_FROM_EAST ///< degrees counterclockwise from east, where waves go
} swDirectionMeaning;

/// How a file's directions were read, and why so.
typedef struct swMeasuredDirections
{
    swDirectionMeaning meaning;

    /// Nothing in the file tells what its directions mean, so that what others who write such files mean was taken.
    bool isAssumed;

    /// What told it, such as "standard_name", "as asked" or "WAVEWATCH III"; empty for SW_DIRECTIONS_BY_FORMAT.
    char basis[48];
} swMeasuredDirections;

/// ---- Texts ----

/// Formats of text, as swFindMeasuredFormat() tells them apart.
typedef enum swMeasuredFormat
{
    SW_MEASURED_UNKNOWN,
    SW_MEASURED_NDBC_SPECTRUM,        ///< energies by frequency; directions are in files of their own: swParseNdbc()
    SW_MEASURED_NDBC_SUMMARY,         ///< a line of heights, periods and directions a record
    SW_MEASURED_SWAN,                 ///< SWAN's spectral file, 2-D or 1-D
    SW_MEASURED_WAVEWATCH,            ///< WAVEWATCH III's point spectra
    SW_MEASURED_WAVEWATCH_PARTITIONS, ///< WAVEWATCH III's partitions
    SW_MEASURED_TRIAXYS,              ///< TriAxys directional and non-directional spectra
    SW_MEASURED_DATAWELL,             ///< Datawell's .spt
    SW_MEASURED_PARTITION_TABLE,      ///< time,hs_m,tp_s,direction_from_deg,spread_deg,gamma
    SW_MEASURED_SPOTTER_CSV,          ///< what the dashboard of Sofar's Spotter buoys exports
    SW_MEASURED_AWAC,                 ///< NMEA sentences of Nortek's AWAC profilers
    SW_MEASURED_OCTOPUS,              ///< forecasts of spectra for Octopus
    SW_MEASURED_OBSCAPE,              ///< directional spectra of Obscape's buoys
    SW_MEASURED_FORMAT_COUNT
} swMeasuredFormat;

/// The formats that swParseMeasuredSea() reads, as the end of a sentence.
SW_API const char* swGetMeasuredFormatList(void);

/// What a text looks like. Reads the first lines only; swParseMeasuredSea() may still find it wrong.
SW_API swMeasuredFormat swFindMeasuredFormat(const char* text, size_t size);

/// Name for people, such as "SWAN spectra".
SW_API const char* swGetMeasuredFormatName(swMeasuredFormat format);

/// Parse a text of any of the formats above. One of NDBC's energies gets no directions this way: see swParseNdbc().
/// At most 1024 frequencies, 720 directions and 134,217,728 values (512 MiB) are read.
/// @param name file name for messages, may be NULL; a Datawell file has its time from it
/// @return SW_ERROR_FORMAT with file, line and reason in the host's log, SW_ERROR_NO_MEMORY
SW_API swResult swParseMeasuredSea(const swHost* host, const char* text, size_t size, const char* name,
                                   swMeasuredSea** sea);

/// Texts of one NDBC directional set, as the buoy centre publishes them; only `energy` is required.
/// Real-time (data_spec, swdir, swdir2, swr1, swr2) and archived yearly files (swden, swdir, ...) are both read.
typedef struct swNdbcTexts
{
    const char* energy;
    const char* alpha1;
    const char* alpha2;
    const char* r1;
    const char* r2;
    size_t energySize, alpha1Size, alpha2Size, r1Size, r2Size;

    /// File names for messages. May be NULL.
    const char *energyName, *alpha1Name, *alpha2Name, *r1Name, *r2Name;
} swNdbcTexts;

/// Parse NDBC texts. The directional distribution is the maximum-entropy one of the four moments
/// [Lygre and Krogstad 1986], which is never negative. Records come in ascending time.
/// A file may have 1024 frequencies, 1,000,000 records and 1,048,576 values: two years of hourly records.
/// @return SW_ERROR_FORMAT with file, line and reason in the host's log, SW_ERROR_NO_MEMORY
SW_API swResult swParseNdbc(const swHost* host, const swNdbcTexts* texts, swMeasuredSea** sea);

/// Whether a text names NDBC columns and WVHT among them: a summary, where swParseNdbc() wants spectra.
SW_API bool swIsNdbcSummary(const char* text, size_t size);

/// Parse an NDBC spectral wave summary (STATION.spec): heights, periods and directions of swell and wind sea. Each
/// becomes a peaked spectrum spread as cos^2s and the record their sum, scaled to the height of the whole sea, of
/// shapes that give it the average period that the line tells; docs/spectra.md says which. A line that does not tell
/// them apart, as those of standard meteorological files, becomes one system by height, dominant or average period,
/// and mean direction. Prefer swParseNdbc() where spectra are at hand. Lines without height or period are left out.
/// Records come in ascending time, at most 16,384. @param name file name for messages, may be NULL @return
/// SW_ERROR_FORMAT with file, line and reason in the host's log, SW_ERROR_NO_MEMORY
SW_API swResult swParseNdbcSummary(const swHost* host, const char* text, size_t size, const char* name,
                                   swMeasuredSea** sea);

/// "YYYY-MM-DD", "YYYY-MM-DD hh:mm" or "YYYY-MM-DDThh:mm:ss.sss", perhaps with Z or UTC behind, to seconds since 1970.
/// @return false if the text is no such time or not of the years 1900 to 2199
SW_API bool swParseMeasuredTime(const char* text, double* seconds);

/// ---- Data of one's own ----

/// One spectrum to make a record of: densities by frequency and direction, or energies and circular moments by
/// frequency. Arrays belong to the caller. Must be initialized with swDefaultMeasuredSpectrumDef().
typedef struct swMeasuredSpectrumDef
{
    /// Index that swMeasuredSea_AddLocation() gave. Default 0.
    int location;

    /// Since 1970, UTC. Range years 1900 to 2199. Default NAN: the time is not known.
    double seconds;

    /// Hz, no two alike, in any order; one of 0 Hz is left out. Range [2, 1024] of them. [frequencyCount]
    int frequencyCount;
    const double* frequencies;

    /// Hz. Default NULL: half-way to the neighbours. [frequencyCount]
    const double* bandwidths;

    /// Radians, where waves go, in any order and unequally spaced if need be. Directions that differ by whole turns are
    /// one: the mean of their densities counts. Range [4, 720] of them, or 0 for moments. [directionCount]
    int directionCount;
    const double* directions;

    /// m^2/Hz/rad, at most 1e6. NAN counts as none, negative ones as swMeasuredRecord::negativeCount says.
    /// [frequencyCount][directionCount]
    const double* density;

    /// Instead of directions: m^2/Hz, at most 5e4; negative ones and NAN count as none. [frequencyCount]
    const double* energy;

    /// Means of cos, sin of the direction where waves go, and of twice it; NAN where missing. Default NULL: not known.
    /// [frequencyCount]
    const double *a1, *b1, *a2, *b2;

    /// The same by their angles and lengths instead, where a1 or b1 is missing: radians where waves go, r1 and r2 in
    /// [0, 1], NAN where missing. Without r1 the spread is that of cos^2s with s = 8. Default NULL. [frequencyCount]
    const double *meanDirection, *r1, *direction2, *r2;

    /// A spectrum that cannot be used is told as a warning, not as an error: for readers that go on without it.
    /// The result is the same. Default false.
    bool warnOnly;

    /// Set by swDefaultMeasuredSpectrumDef().
    int internalValue;
} swMeasuredSpectrumDef;

SW_API swMeasuredSpectrumDef swDefaultMeasuredSpectrumDef(void);

/// An empty sea to fill. Only swMeasuredSea_AddLocation(), swMeasuredSea_AddSpectrum() and swDestroyMeasuredSea() may
/// be called until swMeasuredSea_Finish() has said SW_SUCCESS. @param name for messages, may be NULL
SW_API swResult swCreateMeasuredSea(const swHost* host, const char* name, swMeasuredSea** sea);

/// Add a place. A sea without any gets one that has no name.
/// @param longitude, latitude degrees, NAN if not known
/// @param location its index; may be NULL
SW_API swResult swMeasuredSea_AddLocation(swMeasuredSea* sea, const char* name, double longitude, double latitude,
                                          int* location);

/// Add a record. Equally spaced directions stay as they are; others are shared out to a grid of 360 or 720, keeping the
/// energy and the mean direction of the function that runs linearly between them.
/// @return SW_ERROR_FORMAT with the reason in the host's log, SW_ERROR_NO_MEMORY
SW_API swResult swMeasuredSea_AddSpectrum(swMeasuredSea* sea, const swMeasuredSpectrumDef* def);

/// Put the records in order: by place, then by time. Of two of one place and time the first stays, with a warning.
/// @return SW_ERROR_FORMAT if there are none
SW_API swResult swMeasuredSea_Finish(swMeasuredSea* sea);

/// ---- Records ----

/// Number of records of all places, at least 1.
SW_API int swMeasuredSea_GetCount(const swMeasuredSea* sea);

/// Record by index: place by place, each oldest first. The pointers stay valid as long as the sea.
SW_API swMeasuredRecord swMeasuredSea_GetRecord(const swMeasuredSea* sea, int index);

/// Number of places, at least 1.
SW_API int swMeasuredSea_GetLocationCount(const swMeasuredSea* sea);

/// Place by index; all zero if there is none.
SW_API swMeasuredLocation swMeasuredSea_GetLocation(const swMeasuredSea* sea, int location);

/// Index of the place of this name; -1 if there is none.
SW_API int swMeasuredSea_FindLocation(const swMeasuredSea* sea, const char* name);

/// How the directions of the file were read. Of a sea of one's own what swMeasuredSea_SetDirections() was given.
SW_API swMeasuredDirections swMeasuredSea_GetDirections(const swMeasuredSea* sea);

/// Keep how directions were read; changes no record. Readers of files call it.
SW_API void swMeasuredSea_SetDirections(swMeasuredSea* sea, const swMeasuredDirections* directions);

/// Index of the place with records that lies nearest to a point of the globe, degrees east and north; longitudes may be
/// -180 to 180 or 0 to 360, here and in the file. -1 if no place tells where it is, or if the point is none.
/// @param distance metres along the globe, may be NULL
SW_API int swMeasuredSea_FindNearest(const swMeasuredSea* sea, double longitude, double latitude, double* distance);

/// Farthest place that swMeasuredSea_ChooseNearest() takes, in metres: what a grid of one degree needs.
#define SW_MEASURED_REACH 100000.0

/// The same, with a sentence in the host's log that names the place and its distance.
/// @return SW_ERROR_INVALID if there is no such place within SW_MEASURED_REACH; the log names the nearest one
SW_API swResult swMeasuredSea_ChooseNearest(const swMeasuredSea* sea, double longitude, double latitude, int* location,
                                            double* distance);

/// Index of the record with the largest Hs, of all places; -1 if there is none.
SW_API int swMeasuredSea_FindLargest(const swMeasuredSea* sea);

/// Index of the record nearest to a time "YYYY-MM-DD hh:mm" (UTC), of all places; -1 if the text is no time, if the
/// records have none, or if the time lies before the first or after the last record by more than half of what usually
/// lies between two of them (by more than half an hour, where that is more or there is only one).
SW_API int swMeasuredSea_FindTime(const swMeasuredSea* sea, const char* time);

/// Both of the above at one place; location -1: at all of them. time NULL: the largest Hs.
SW_API int swMeasuredSea_FindRecord(const swMeasuredSea* sea, int location, const char* time);

/// The same, with a sentence in the host's log: why there is no such record and which times there are, or a warning
/// where the nearest record is farther away than half of what usually lies between two of them, or lies not around
/// the time. @return SW_ERROR_INVALID if there is none
SW_API swResult swMeasuredSea_ChooseRecord(const swMeasuredSea* sea, int location, const char* time, int* record);

/// The two records of a place between which a time lies, to replay a sea: *before and *after are their indices and
/// *fraction in [0, 1] says how far the time is on the way from one to the other. Before the first record and after the
/// last one both are that record, and the fraction is 0. A gap is bridged however long it is: compare the two records'
/// seconds with the gap that you would bridge (a buoy that reports each hour may have been silent for weeks).
/// @param seconds since 1970, UTC
/// @return false if there is no such place or `seconds` is NAN
SW_API bool swMeasuredSea_Bracket(const swMeasuredSea* sea, int location, double seconds, int* before, int* after,
                                  double* fraction);

/// NULL is allowed.
SW_API void swDestroyMeasuredSea(swMeasuredSea* sea);
