// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "math.h"

/// @file
/// Directional wave spectra S(f, theta): formulas, and tables read from measurements.
/// Frequencies f in Hz, directions theta in radians where waves GO, from +x towards +z (see math.h),
/// densities in m^2/Hz/rad. Whatever the source, the surface's variance is the integral of the spectrum.

typedef enum swSpectrumKind
{
    /// [Hasselmann 1973]: a growing wind sea, given wind and fetch, or height and peak period.
    SW_SPECTRUM_JONSWAP,
    /// [Pierson 1964]: a fully developed wind sea, given wind, or height and peak period.
    SW_SPECTRUM_PIERSON_MOSKOWITZ,
    /// A table, such as a buoy's record.
    SW_SPECTRUM_TABLE,
    SW_SPECTRUM_KIND_COUNT
} swSpectrumKind;

/// A directional spectrum on a grid. Arrays belong to the caller; objects that take a table copy it.
typedef struct swSpectrumTable
{
    /// Number of frequencies, range [2, 1024], and of directions, range [4, 720].
    int frequencyCount;
    int directionCount;

    /// Hz, ascending. [frequencyCount]
    const float* frequencies;

    /// Bandwidth of each frequency bin, Hz. [frequencyCount]
    const float* bandwidths;

    /// m^2/Hz/rad at frequency i, direction 2 pi j / directionCount (where waves go).
    /// [frequencyCount][directionCount]
    const float* density;
} swSpectrumTable;

/// Must be initialized with swDefaultSpectrumDef().
typedef struct swSpectrumDef
{
    /// Default SW_SPECTRUM_JONSWAP.
    swSpectrumKind kind;

    /// Wind at 10 m above the water, m/s. Range (0, 100]. Default 10. Unused by tables.
    float windSpeed;

    /// Distance over which the wind has blown, m. Range [1e3, 1e7]. Default 300e3. JONSWAP only.
    float fetch;

    /// Peak enhancement. Range [1, 10]. Default 3.3. JONSWAP only.
    float gamma;

    /// Significant wave height 4 sqrt(m0), m; a table's without its tail. Range [0, 40]. Default 0: what wind and fetch
    /// (or the table) give.
    float significantHeight;

    /// Period of the spectral peak, s. Range [0, 60]. Default 0: what wind and fetch give. Unused by tables.
    float peakPeriod;

    /// Mean direction where waves go, radians from +x towards +z. Default 0 (eastward). Tables turn by it.
    float direction;

    /// Exponent s of the spreading cos^2s(theta / 2) [Longuet-Higgins 1963]. Range [0, 200]. Default 8; 0 is all
    /// directions alike, 75 a swell. Unused by tables.
    float spreadExponent;

    /// Depth of the water, m: for the waves' lengths and speeds, omega^2 = (g k + sigma k^3) tanh(k depth), with the
    /// world's gravity and surface tension. Range (0, inf]. Default infinite.
    float depth;

    /// For SW_SPECTRUM_TABLE. Read only during the call that takes the def. Default NULL.
    const swSpectrumTable* table;

    /// Continue a table beyond its highest frequency with an f^-5 tail, so that it has short waves.
    /// Default true. The tail's energy comes on top of the table's.
    bool extendTail;

    /// Set by swDefaultSpectrumDef().
    int internalValue;
} swSpectrumDef;

/// A JONSWAP sea under a 10 m/s wind blowing east over 300 km.
SW_API swSpectrumDef swDefaultSpectrumDef(void);

/// Integral parameters of a spectrum. Directions in radians where waves go.
typedef struct swSeaState
{
    float significantHeight; ///< Hs = 4 sqrt(m0), m
    float peakPeriod;        ///< Tp: 1 / frequency of the largest density, s
    float periodTm01;        ///< m0 / m1, s
    float periodTm02;        ///< sqrt(m0 / m2), s
    float energyPeriod;      ///< Te = m-1 / m0, s
    float meanDirection;     ///< energy-weighted over all frequencies
    float peakDirection;     ///< mean direction at the peak frequency
    float spread;            ///< sqrt(2 (1 - r1)) over all frequencies, radians
    float meanSquareSlope;   ///< integral of k^2 S of the frequencies integrated, k by depth and surface tension
} swSeaState;

/// One-dimensional density at f, m^2/Hz. Returns 0 outside the spectrum. Any thread.
SW_API float swSpectrum_GetDensity(const swSpectrumDef* def, float frequency);

/// Density of direction at f, 1/rad; integrates to 1 over the circle. Any thread.
SW_API float swSpectrum_GetSpreading(const swSpectrumDef* def, float frequency, float direction);

/// Integrate the spectrum over [minFrequency, maxFrequency] Hz, a table with its tail; or, with 0 and 0, over all of it:
/// a formula up to 5 Hz (waves of 6 cm), a table by its own bins and widths, without the tail.
/// @return SW_ERROR_INVALID if the def is outside its ranges or has no energy
SW_API swResult swSpectrum_GetSeaState(const swSpectrumDef* def, float minFrequency, float maxFrequency,
                                       swSeaState* seaState);

/// Measured records: what a wave buoy or a file of spectra held.
typedef struct swMeasuredSea swMeasuredSea;

/// One record of a measured sea.
typedef struct swMeasuredRecord
{
    /// UTC, "YYYY-MM-DD hh:mm".
    char time[20];

    /// The record as a directional spectrum; points into the swMeasuredSea.
    swSpectrumTable table;

    /// [frequencyCount] m^2/Hz.
    const float* energy;

    /// First circular moments: mean direction where waves go (radians) and r1, by frequency; r2 and its direction.
    /// Gaps are filled from the nearest frequency, impossible moments corrected: what the table was made from. A
    /// summary's are those of its swell and wind sea together.
    /// NULL if the file holds no directions (the table is then spread as cos^2s with s = 8 around east). [frequencyCount]
    const float* meanDirection;
    const float* r1;
    const float* direction2;
    const float* r2;

    /// How many frequencies had moments that no distribution can have and were corrected.
    int correctedCount;

    /// 0 if the file holds spectra. Of a summary: of how many systems of waves, swell and wind sea, the table was built
    /// up; then its shape is that of a formula and only heights, periods and directions are measured.
    int partitionCount;
} swMeasuredRecord;

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

/// Parse an NDBC spectral wave summary (STATION.spec): heights, periods and directions of swell and wind sea. Each becomes
/// a JONSWAP spectrum spread as cos^2s and the record their sum, scaled to the height of the whole sea; docs/spectra.md
/// says with which shapes. A line that does not tell them apart, as those of standard meteorological files, becomes one
/// system by height, dominant or average period, and mean direction. Prefer swParseNdbc() where spectra are at hand.
/// Lines without height or period are left out. Records come in ascending time, at most 16,384.
/// @param name file name for messages, may be NULL
/// @return SW_ERROR_FORMAT with file, line and reason in the host's log, SW_ERROR_NO_MEMORY
SW_API swResult swParseNdbcSummary(const swHost* host, const char* text, size_t size, const char* name,
                                   swMeasuredSea** sea);

/// Number of records, at least 1.
SW_API int swMeasuredSea_GetCount(const swMeasuredSea* sea);

/// Record by index, oldest first. The pointers stay valid as long as the sea.
SW_API swMeasuredRecord swMeasuredSea_GetRecord(const swMeasuredSea* sea, int index);

/// Index of the record with the largest Hs.
SW_API int swMeasuredSea_FindLargest(const swMeasuredSea* sea);

/// Index of the record nearest to a time "YYYY-MM-DD hh:mm" (UTC); -1 if the text is no time.
SW_API int swMeasuredSea_FindTime(const swMeasuredSea* sea, const char* time);

/// NULL is allowed.
SW_API void swDestroyMeasuredSea(swMeasuredSea* sea);
