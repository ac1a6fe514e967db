// SPDX-License-Identifier: MIT
// Seas by one knob. Under a wind U over a fetch F, x = g F / U^2, a sea has [Hasselmann 1973]
//   Hs = 0.0016 sqrt(x) U^2 / g,   omega_p = 2 pi 3.5 x^-0.33 g / U,
// and stops where it meets the fully developed sea [Pierson 1964], Hs = 0.2202 U^2 / g and omega_p = 0.855 g / U: the
// two laws get there at x = 18,900 and 18,800. These are what the waves were measured to be; the integral of the
// JONSWAP spectrum with the parameters of the same paper is a quarter higher and never stops, so height and period are
// given to the spectrum here. A wind that has blown for D hours makes the sea of the fetch that it has had time for, X
// km with D = 1.167 X^0.7 / U^0.4 [Carter 1982]. The peak's enhancement grows with how young the sea
// is, as the waves' measured peaks do, 6 log10 of the peak's frequency [Donelan 1985], from 1 at full development to
// 3.3.

#include <math.h>

#include "core/math/scalar.h"
#include "core/spectra/compiled.h"

#define GRAVITY SW_STANDARD_GRAVITY

// Hs g / U^2 and omega_p U / g of the fully developed sea; 1.026 is the wind at 19.5 m over that at 10 m.
#define DEVELOPED_HEIGHT (0.2092457 * 1.026 * 1.026)
#define DEVELOPED_OMEGA 0.8549349

// Significant steepness 2 pi Hs / (g Tp^2) that a wind sea does not exceed.
#define STEEPEST 0.04

#define LN_10 2.302585092994046

// A sea of nothing still is a spectrum: waves of a millimetre.
#define LEAST_HEIGHT 1e-3

static double limitTo(double value, double low, double high)
{
    return value > low ? (value < high ? value : high) : low; // NaN becomes `low`
}

// JONSWAP of this height, with that peak unless waves would be too steep to stand.
static swSpectrumDef makeWindSea(double wind, double height, double omega, double direction)
{
    double young = omega * wind / GRAVITY / DEVELOPED_OMEGA;
    double steepestOmega = sqrt(STEEPEST * SW_TURN * GRAVITY / height);
    omega = omega < steepestOmega ? omega : steepestOmega;
    double period = SW_TURN / omega;
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_JONSWAP;
    def.windSpeed = (float)wind;
    def.hasWind = true;
    def.significantHeight = (float)height;
    def.peakPeriod = (float)(period < 60.0 ? period : 60.0);
    def.gamma = (float)limitTo(young > 1.0 ? 1.0 + 6.0 / LN_10 * swLn(young) : 1.0, 1.0, 3.3);
    def.direction = (float)direction;
    def.spreading = SW_SPREADING_HASSELMANN;
    return def;
}

swSpectrumDef swMakeWindSeaSpectrum(float windSpeed, float fetch, float duration, float direction)
{
    double wind = limitTo((double)windSpeed, 0.1, 100.0);
    double hours = limitTo((double)duration, 1.0, 1e9) / 3600.0;
    double grown = 1e3 * swPow(hours * swPow(wind, 0.4) / 1.167, 1.0 / 0.7);
    double reach = limitTo((double)fetch, 1.0, 1e9);
    reach = grown < reach ? grown : reach;
    double x = GRAVITY * reach / (wind * wind);
    double height = limitTo(0.0016 * sqrt(x), 0.0, DEVELOPED_HEIGHT) * wind * wind / GRAVITY;
    double omega = limitTo(swGetGrownOmega(SW_GROWTH_HASSELMANN, x), DEVELOPED_OMEGA, 1e6) * GRAVITY / wind;
    height = limitTo(height, LEAST_HEIGHT, 40.0);
    swSpectrumDef def = makeWindSea(wind, height, omega, (double)direction);
    def.fetch = (float)limitTo(reach, 1e3, 1e7);
    return def;
}

// A sea that has grown to a height under a wind. Beyond what the wind can do it is what is left of a stronger wind's:
// the fully developed sea of that height, no steeper than any other.
static swSpectrumDef makeSeaOfHeight(double wind, double height, double direction)
{
    double root = height * GRAVITY / (wind * wind) / 0.0016;
    double x = root * root;
    double grower = sqrt(height * GRAVITY / DEVELOPED_HEIGHT);
    double omega = wind < grower
                       ? DEVELOPED_OMEGA * GRAVITY / grower
                       : limitTo(swGetGrownOmega(SW_GROWTH_HASSELMANN, x), DEVELOPED_OMEGA, 1e6) * GRAVITY / wind;
    swSpectrumDef def = makeWindSea(wind, height, omega, direction);
    def.fetch = (float)limitTo(x * wind * wind / GRAVITY, 1e3, 1e7);
    return def;
}

// Probable heights in the open sea, m, by Beaufort's number [WMO 2019]; one more so that the state of the sea can go
// on.
#define BEAUFORT_COUNT 14
static const double beaufortHeights[BEAUFORT_COUNT] = {0.0, 0.1, 0.2, 0.6, 1.0,  2.0,  3.0,
                                                       4.0, 5.5, 7.0, 9.0, 11.5, 14.0, 17.0};

static double getBeaufortWind(double number)
{
    return limitTo(0.836 * number * sqrt(number), 0.1, 100.0);
}

static double interpolate(const double* values, int count, double place)
{
    int index = (int)place;
    index = index < count - 1 ? index : count - 2;
    return values[index] + (place - index) * (values[index + 1] - values[index]);
}

swSpectrumDef swMakeBeaufortSpectrum(float number, float direction)
{
    double place = limitTo((double)number, 0.0, 12.0);
    double height = limitTo(interpolate(beaufortHeights, BEAUFORT_COUNT, place), LEAST_HEIGHT, 40.0);
    return makeSeaOfHeight(getBeaufortWind(place), height, (double)direction);
}

swSpectrumDef swMakeSeaStateSpectrum(float state, float direction)
{
    // The middle of each range of code table 3700; the last has no end.
    static const double heights[10] = {0.0, 0.05, 0.3, 0.875, 1.875, 3.25, 5.0, 7.5, 11.5, 16.0};
    double height = interpolate(heights, 10, limitTo((double)state, 0.0, 9.0));
    height = limitTo(height, LEAST_HEIGHT, 40.0);
    // The wind whose probable height this is.
    int index = 0;
    while (index < BEAUFORT_COUNT - 2 && beaufortHeights[index + 1] < height)
    {
        index += 1;
    }
    double step = beaufortHeights[index + 1] - beaufortHeights[index];
    double number = index + (height - beaufortHeights[index]) / step;
    return makeSeaOfHeight(getBeaufortWind(number), height, (double)direction);
}

swSpectrumDef swMakeSwellSpectrum(float significantHeight, float peakPeriod, float direction, float spread)
{
    double width = limitTo((double)spread, 0.1, 1.41);
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_JONSWAP;
    def.windSpeed = 1.0f; // it has left its wind behind
    def.hasWind = true;
    def.significantHeight = (float)limitTo((double)significantHeight, LEAST_HEIGHT, 40.0);
    def.peakPeriod = (float)limitTo((double)peakPeriod, 0.1, 60.0);
    def.gamma = 7.0f; // dispersion has sorted it; coastal engineers take 3 to 10 [Goda 1985]
    def.direction = direction;
    def.spreading = SW_SPREADING_COSINE_2S;
    def.spreadExponent = (float)limitTo(2.0 / (width * width) - 1.0, 0.0, 200.0);
    return def;
}
