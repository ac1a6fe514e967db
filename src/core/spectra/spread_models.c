// SPDX-License-Identifier: MIT
// Published distributions of direction. With w = omega / omega_p and U / c_p the age of the sea, wind over the phase
// speed g / omega_p of the peak:
//
//   Mitsuyasu        cos^2s(a / 2), s = 11.5 (U / c_p)^-2.5 w^5 below the peak and w^-2.5 above
//   Hasselmann       cos^2s(a / 2), s = 6.97 w^4.06 up to the peak, 9.77 w^(-2.33 - 1.45 (U / c_p - 1.17)) above
//   Donelan-Banner   sech^2(beta a), beta = 2.61 w^1.3 below 0.95, 2.28 w^-1.3 up to 1.6, and above
//                    10^(-0.4 + 0.8393 exp(-0.567 ln w^2))
//   Elfouhaily       1 + Delta cos 2a, Delta = tanh(a0 + 4 (c / c_p)^2.5 + am (c_m / c)^2.5), a0 = ln 2 / 4,
//                    am = 0.13 u* / c_m, c_m = 0.23 m/s
//
// Swell multiplies by cos^2s(a / 2), s = 16 tanh(1 / w) swell^2 [Horvath 2015]; two such cosines are one whose exponent
// is their sum. Turbulence blends with the even distribution.
//
// Normalisers are closed: of cos^2s Gamma(s + 1) / (2 sqrt(pi) Gamma(s + 1/2)), of sech^2 beta / (2 tanh(pi beta)), and
// 1 + Delta cos 2a times cos^2s adds Delta times its second moment. Only sech^2 times cos^2s has none; it is
// integrated, and tabulated for builders of seas, who ask for hundreds of thousands.

#include "core/spectra/spread_models.h"

#include <math.h>

#include "core/math/scalar.h"
#include "core/spectra/spreading.h"
#include "seaway/math.h"

#define TURN (2.0 * SW_PI)

// Six degrees of spread. Mitsuyasu's law gives more to a swell much faster than the wind.
#define MAX_EXPONENT 200.0

// ---- the laws ----

double swGetDragCoefficient(double windSpeed)
{
    return 1e-3 * (0.8 + 0.065 * windSpeed);
}

static double power2p5(double x)
{
    return x * x * sqrt(x);
}

double swGetElfouhailyDelta(double phaseSpeed, double peakSpeed, double friction)
{
    const double rippleSpeed = 0.23;
    double am = 0.13 * friction / rippleSpeed;
    return swTanh(0.25 * 0.6931471805599453 + 4.0 * power2p5(phaseSpeed / peakSpeed) +
                  am * power2p5(rippleSpeed / phaseSpeed));
}

static double getMitsuyasuExponent(const swSpreadModel* model, double ratio)
{
    double peak = 11.5 / power2p5(model->windRatio);
    double s = peak * (ratio < 1.0 ? ratio * ratio * ratio * ratio * ratio : 1.0 / power2p5(ratio));
    return s < MAX_EXPONENT ? s : MAX_EXPONENT;
}

static double getHasselmannExponent(const swSpreadModel* model, double ratio)
{
    double slope = -2.33 - 1.45 * (model->windRatio - 1.17);
    double s = ratio <= 1.0 ? 6.97 * swPow(ratio, 4.06) : 9.77 * swPow(ratio, slope);
    return s < MAX_EXPONENT ? s : MAX_EXPONENT;
}

static double getDonelanBeta(double ratio)
{
    if (ratio < 0.95)
    {
        return 2.61 * swPow(ratio, 1.3);
    }
    if (ratio <= 1.6)
    {
        return 2.28 * swPow(ratio, -1.3);
    }
    return swPow(10.0, -0.4 + 0.8393 * swPow(ratio, -2.0 * 0.567));
}

int swGetSpreadJumps(const swSpreadModel* model, double* ratios)
{
    switch (model->kind)
    {
    case SW_SPREADING_MITSUYASU: // a kink
    case SW_SPREADING_HASSELMANN:
        ratios[0] = 1.0;
        return 1;
    case SW_SPREADING_DONELAN_BANNER:
        ratios[0] = 0.95;
        ratios[1] = 1.6;
        return 2;
    default:
        return 0;
    }
}

// ---- integrals of sech^2 times cos^2s ----

#define NODE_COUNT 8
#define PANELS 3 // of each half

// Integrals over the circle of the shape times 1, cos a, cos 2a, by Gauss-Legendre of order 8 in equal panels: from 0
// to pi / 2 over a, and from there over t with a = pi - pi / 2 t^4, as cos^2s with a small s ends in a cusp. Good to
// 1e-9.
static void integrateShape(const swSpread* spread, double* sums)
{
    static const double nodes[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    static const double weights[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    sums[0] = sums[1] = sums[2] = 0.0;
    for (int i = 0; i < 2 * PANELS * NODE_COUNT; ++i)
    {
        bool isBack = i >= PANELS * NODE_COUNT;
        int panel = i / NODE_COUNT % PANELS, node = i % NODE_COUNT;
        double offset = node < 4 ? -nodes[node] : nodes[node - 4];
        double t = (panel + 0.5 + 0.5 * offset) / PANELS;
        double angle = 0.5 * SW_PI * (isBack ? 2.0 - t * t * t * t : t);
        double rate = 0.5 * SW_PI * (isBack ? 4.0 * t * t * t : 1.0);
        double value = rate * weights[node % 4] / PANELS * swGetSpread(spread, angle); // both sides
        double cosine = swCos(angle);
        sums[0] += value;
        sums[1] += value * cosine;
        sums[2] += value * (2.0 * cosine * cosine - 1.0);
    }
}

// ---- one frequency ----

static swSpread findShape(const swSpreadModel* model, double omega)
{
    double ratio = omega / model->peakOmega;
    swSpread spread = {.turbulence = model->turbulence};
    switch (model->kind)
    {
    case SW_SPREADING_COSINE_2S:
        spread.exponent = model->exponent;
        break;
    case SW_SPREADING_MITSUYASU:
        spread.exponent = getMitsuyasuExponent(model, ratio);
        break;
    case SW_SPREADING_HASSELMANN:
        spread.exponent = getHasselmannExponent(model, ratio);
        break;
    case SW_SPREADING_DONELAN_BANNER:
        spread.beta = getDonelanBeta(ratio);
        break;
    case SW_SPREADING_ELFOUHAILY:
        spread.delta = swGetElfouhailyDelta(omega / swGetWaveNumber(&model->deep, omega),
                                            model->deep.gravity / model->peakOmega, model->friction);
        break;
    default:
        break;
    }
    if (model->swell > 0.0)
    {
        spread.exponent += 16.0 * swTanh(1.0 / ratio) * model->swell * model->swell;
    }
    return spread;
}

static double integrateScale(swSpread spread)
{
    double sums[3];
    spread.turbulence = 0.0;
    spread.scale = 1.0;
    integrateShape(&spread, sums);
    return 1.0 / sums[0];
}

// Where the table of normalisers has its pieces, as logarithms of omega / omega_p: the model jumps between them.
static const double pieceBegins[3] = {-1.7, -0.05129329438755058, 0.47000362924573563}; // ln 0.95, ln 1.6
static const double pieceEnds[3] = {-0.05129329438755058, 0.47000362924573563, 6.2};

#define PIECE_NODES SW_SPREAD_NODES

void swTabulateSpreadScales(swSpreadModel* model)
{
    model->hasScales = model->kind == SW_SPREADING_DONELAN_BANNER && model->swell > 0.0;
    for (int piece = 0; model->hasScales && piece < 3; ++piece)
    {
        for (int i = 0; i < PIECE_NODES; ++i)
        {
            // A hair inside, so that the ends belong to their own piece.
            double part = 1e-12 + (1.0 - 2e-12) * i / (PIECE_NODES - 1.0);
            double place = pieceBegins[piece] + part * (pieceEnds[piece] - pieceBegins[piece]);
            model->scales[piece][i] = integrateScale(findShape(model, model->peakOmega * swExp(place)));
        }
    }
}

// The polynomial through six nodes.
static double readScale(const swSpreadModel* model, double ratio, bool* isInside)
{
    double place = swLn(ratio);
    int piece = ratio < 0.95 ? 0 : ratio <= 1.6 ? 1 : 2;
    double x = (place - pieceBegins[piece]) / (pieceEnds[piece] - pieceBegins[piece]) * (PIECE_NODES - 1.0);
    *isInside = x >= 0.0 && x <= PIECE_NODES - 1.0;
    if (!*isInside)
    {
        return 0.0;
    }
    int first = (int)x - 2;
    first = first < 0 ? 0 : first > PIECE_NODES - 6 ? PIECE_NODES - 6 : first;
    double t = x - first, sum = 0.0;
    for (int i = 0; i < 6; ++i)
    {
        double part = model->scales[piece][first + i];
        for (int j = 0; j < 6; ++j)
        {
            part *= i == j ? 1.0 : (t - j) / (i - j);
        }
        sum += part;
    }
    return sum;
}

static double findScale(const swSpreadModel* model, const swSpread* spread, double omega)
{
    if (spread->beta == 0.0)
    {
        double scale = swGetCosineSpreadScale(spread->exponent);
        if (spread->delta != 0.0)
        {
            double r1, r2;
            swGetCosineMoments(spread->exponent, &r1, &r2);
            scale /= 1.0 + spread->delta * r2;
        }
        return scale;
    }
    if (spread->exponent == 0.0)
    {
        return 0.5 * spread->beta / swTanh(SW_PI * spread->beta);
    }
    bool isInside = false;
    double scale = model->hasScales ? readScale(model, omega / model->peakOmega, &isInside) : 0.0;
    return isInside ? scale : integrateScale(*spread);
}

swSpread swFindSpread(const swSpreadModel* model, double omega)
{
    if (!(omega > 0.0))
    {
        return (swSpread){.turbulence = 1.0};
    }
    swSpread spread = findShape(model, omega);
    spread.scale = findScale(model, &spread, omega);
    return spread;
}

double swGetSpread(const swSpread* spread, double angle)
{
    double value = spread->scale;
    double cosine = swCos(angle);
    if (spread->exponent > 0.0)
    {
        double square = 0.5 + 0.5 * cosine;
        value *= square > 1e-30 ? swExp(spread->exponent * swLn(square)) : 0.0;
    }
    if (spread->delta != 0.0)
    {
        value *= 1.0 + spread->delta * (2.0 * cosine * cosine - 1.0);
    }
    if (spread->beta > 0.0)
    {
        double turns = angle / TURN;
        double near = TURN * (turns - floor(turns + 0.5)); // within half a turn
        double t = swTanh(spread->beta * near);
        value *= 1.0 - t * t;
    }
    return spread->turbulence / TURN + (1.0 - spread->turbulence) * value;
}

// Moment n of cos^2s: Gamma(s + 1)^2 / (Gamma(s + 1 + n) Gamma(s + 1 - n)).
static double getCosineMoment(double s, int n)
{
    double moment = 1.0;
    for (int i = 0; i < n; ++i)
    {
        moment *= (s - i) / (s + 1.0 + i);
    }
    return moment;
}

void swGetSpreadMoments(const swSpread* spread, double* r1, double* r2)
{
    if (spread->beta > 0.0)
    {
        double sums[3];
        integrateShape(spread, sums);
        *r1 = sums[1];
        *r2 = sums[2];
        return;
    }
    double s = spread->exponent, half = 0.5 * spread->delta;
    double norm = 1.0 + spread->delta * getCosineMoment(s, 2);
    double keep = (1.0 - spread->turbulence) / norm;
    *r1 = keep * (getCosineMoment(s, 1) * (1.0 + half) + half * getCosineMoment(s, 3));
    *r2 = keep * (getCosineMoment(s, 2) + half * (1.0 + getCosineMoment(s, 4)));
}

swSpreadModel swMakeSpreadModel(const swSpectrumDef* def, double gravity, double surfaceTension, double peakOmega)
{
    double wind = (double)def->windSpeed;
    return (swSpreadModel){
        .kind = def->spreading,
        .exponent = (double)def->spreadExponent,
        .turbulence = (double)def->turbulence,
        .swell = (double)def->swell,
        .peakOmega = peakOmega,
        .windRatio = wind * peakOmega / gravity,
        .friction = sqrt(swGetDragCoefficient(wind)) * wind,
        .deep = {gravity, surfaceTension, (double)INFINITY},
    };
}
