// SPDX-License-Identifier: MIT
// Air: Rayleigh and Mie scattering and ozone around a spherical earth, after [Bruneton 2008] and [Hillaire 2020].
// Kilometres from the earth's centre; mu is the cosine of the angle to the zenith. Coefficients are per kilometre at
// 680, 550 and 440 nm and stand for the three linear sRGB primaries.
#ifndef SW_LIB_ATMOSPHERE
#define SW_LIB_ATMOSPHERE
#include "shared/picture.h"

const float earthBottom = 6360.0;
const float earthTop = 6460.0;
const vec3 rayleighScattering = vec3(5.802e-3, 13.558e-3, 33.1e-3);
const float rayleighHeight = 8.0;
// Sea salt in clear maritime air: an optical depth of 0.025 over all, a visibility of 120 km at the surface.
const float mieScattering = 20e-3;
const float mieExtinction = 20.7e-3;
const float mieHeight = 1.2;
const float mieForward = 0.8;
const vec3 ozoneAbsorption = vec3(0.650e-3, 1.881e-3, 0.085e-3);
const vec3 seaAlbedo = vec3(0.05, 0.06, 0.07);
const float pi = 3.14159265;

struct Air
{
    vec3 rayleigh;   // scattering
    float mie;       // scattering
    vec3 extinction; // of both, and ozone
};

Air airAt(float radius, float haze)
{
    float height = max(radius - earthBottom, 0.0);
    float rayleigh = exp(-height / rayleighHeight);
    float mie = exp(-height / mieHeight) * haze;
    float ozone = max(0.0, 1.0 - abs(height - 25.0) / 15.0);
    Air air;
    air.rayleigh = rayleighScattering * rayleigh;
    air.mie = mieScattering * mie;
    air.extinction = air.rayleigh + vec3(mieExtinction * mie) + ozoneAbsorption * ozone;
    return air;
}

float rayleighPhase(float cosine)
{
    return 3.0 / (16.0 * pi) * (1.0 + cosine * cosine);
}

// [Cornette and Shanks 1992].
float miePhase(float cosine)
{
    float g2 = mieForward * mieForward;
    float base = max(1.0 + g2 - 2.0 * mieForward * cosine, 1e-4);
    return 3.0 / (8.0 * pi) * (1.0 - g2) * (1.0 + cosine * cosine) / ((2.0 + g2) * base * sqrt(base));
}

// Distance to a sphere from inside, or to the far side.
float distanceToSphere(float radius, float mu, float sphere)
{
    float discriminant = radius * radius * (mu * mu - 1.0) + sphere * sphere;
    return max(0.0, -radius * mu + sqrt(max(discriminant, 0.0)));
}

bool hitsEarth(float radius, float mu)
{
    return mu < 0.0 && radius * radius * (mu * mu - 1.0) + earthBottom * earthBottom >= 0.0;
}

float distanceToEarth(float radius, float mu)
{
    float discriminant = radius * radius * (mu * mu - 1.0) + earthBottom * earthBottom;
    return max(0.0, -radius * mu - sqrt(max(discriminant, 0.0)));
}

// Zenith cosine of the horizon.
float horizonCosine(float radius)
{
    float ratio = earthBottom / radius;
    return -sqrt(max(0.0, 1.0 - ratio * ratio));
}

// Transmittance table: u runs with the distance to the top of the air, v with the distance to the horizon
// [Bruneton 2008].
vec2 transmittanceUv(float radius, float mu)
{
    float toHorizonMax = sqrt(earthTop * earthTop - earthBottom * earthBottom);
    float toHorizon = sqrt(max(radius * radius - earthBottom * earthBottom, 0.0));
    float distance = distanceToSphere(radius, mu, earthTop);
    float nearest = earthTop - radius;
    float farthest = toHorizon + toHorizonMax;
    vec2 x = vec2((distance - nearest) / (farthest - nearest), toHorizon / toHorizonMax);
    vec2 size = vec2(SW_SKY_TRANSMITTANCE_WIDTH, SW_SKY_TRANSMITTANCE_HEIGHT);
    return (x * (size - 1.0) + 0.5) / size;
}

void transmittanceOf(vec2 x, out float radius, out float mu)
{
    float toHorizonMax = sqrt(earthTop * earthTop - earthBottom * earthBottom);
    float toHorizon = toHorizonMax * x.y;
    radius = sqrt(toHorizon * toHorizon + earthBottom * earthBottom);
    float nearest = earthTop - radius;
    float distance = nearest + x.x * (toHorizon + toHorizonMax - nearest);
    mu = distance <= 0.0
             ? 1.0
             : (toHorizonMax * toHorizonMax - toHorizon * toHorizon - distance * distance) / (2.0 * radius * distance);
    mu = clamp(mu, -1.0, 1.0);
}

// Sunlight that reaches a point: the air's transmittance and the part of the disc above the horizon.
vec3 sunTransmittance(sampler2D transmittance, float radius, float muSun)
{
    const float sunRadius = 0.00465;
    float horizon = horizonCosine(radius);
    float above = smoothstep(-sunRadius, sunRadius, muSun - horizon);
    return above * textureLod(transmittance, transmittanceUv(radius, max(muSun, horizon)), 0.0).rgb;
}

vec3 multipleScattering(sampler2D multiple, float radius, float muSun)
{
    vec2 x = vec2(0.5 + 0.5 * muSun, (radius - earthBottom) / (earthTop - earthBottom));
    float size = float(SW_SKY_MULTIPLE_SIDE);
    return textureLod(multiple, (clamp(x, 0.0, 1.0) * (size - 1.0) + 0.5) / size, 0.0).rgb;
}

// Light scattered into a ray. What haze scatters once comes without its phase function, which is too sharp around the
// sun for a table: a pixel multiplies it in, see withHaze().
struct Scattered
{
    vec3 light;  // by the air, and by both more than once
    vec3 haze;   // once by haze, over its phase function
    vec3 passed; // transmittance of the ray
};

vec3 withHaze(vec3 light, vec3 haze, vec3 direction, vec3 sun)
{
    return light + haze * miePhase(dot(direction, sun));
}

// Over `length` km, for unit illuminance of the sun. Steps grow with the distance because the air nearby is the
// densest.
Scattered scatteredLight(sampler2D transmittance, sampler2D multiple, float radius, vec3 direction, vec3 sun,
                         float length, float haze, int steps)
{
    float phaseR = rayleighPhase(dot(direction, sun));
    Scattered sum = Scattered(vec3(0.0), vec3(0.0), vec3(1.0));
    float begin = 0.0;
    for (int i = 0; i < steps; ++i)
    {
        float x = float(i + 1) / float(steps);
        float end = length * x * x;
        float t = mix(begin, end, 0.5);
        float stepLength = end - begin;
        begin = end;
        vec3 position = vec3(0.0, radius, 0.0) + direction * t;
        float r = sqrt(dot(position, position));
        float muSun = dot(position, sun) / r;
        Air air = airAt(r, haze);
        vec3 fromSun = sunTransmittance(transmittance, r, muSun);
        vec3 through = exp(-air.extinction * stepLength);
        vec3 seen = sum.passed * (1.0 - through) / max(air.extinction, vec3(1e-7));
        sum.light += seen * (fromSun * air.rayleigh * phaseR +
                             multipleScattering(multiple, r, muSun) * (air.rayleigh + air.mie));
        sum.haze += seen * fromSun * air.mie;
        sum.passed *= through;
    }
    return sum;
}

// The view tables hold the sky above the horizon: u is the azimuth from north over east, v the root of the angle above
// the horizon, so that the horizon's steep colours get most texels.
vec2 skyViewUv(vec3 direction, float horizonElevation)
{
    float azimuth = atan(direction.x, -direction.z);
    float elevation = asin(clamp(direction.y, -1.0, 1.0));
    float above = max(elevation - horizonElevation, 0.0) / (0.5 * pi - horizonElevation);
    float height = float(SW_SKY_VIEW_HEIGHT);
    return vec2(azimuth / (2.0 * pi), (sqrt(above) * (height - 1.0) + 0.5) / height);
}

vec3 skyViewDirection(ivec2 texel, float horizonElevation)
{
    float azimuth = (float(texel.x) + 0.5) / float(SW_SKY_VIEW_WIDTH) * 2.0 * pi;
    float x = float(texel.y) / float(SW_SKY_VIEW_HEIGHT - 1);
    float elevation = horizonElevation + x * x * (0.5 * pi - horizonElevation);
    return vec3(sin(azimuth) * cos(elevation), sin(elevation), -cos(azimuth) * cos(elevation));
}

// Table of the air between camera and sea: u is the angle from the sun's azimuth, v the root of the distance beyond the
// nearest water, which lies straight below, over that to the horizon. Below the viewer all azimuths are one row.
float airDistance(float cameraHeightKm)
{
    float h = max(cameraHeightKm, 1e-3);
    return 1.15 * sqrt(h * (2.0 * earthBottom + h)) + 2.0;
}

vec2 airUv(vec3 direction, vec3 sun, float distanceKm, float cameraHeightKm)
{
    vec2 a = normalize(direction.xz + vec2(1e-6, 0.0));
    vec2 b = normalize(sun.xz + vec2(1e-6, 0.0));
    float angle = acos(clamp(dot(a, b), -1.0, 1.0)) / pi;
    float beyond = distanceKm - max(cameraHeightKm, 1e-3);
    float x = sqrt(clamp(beyond / airDistance(cameraHeightKm), 0.0, 1.0));
    float size = float(SW_SKY_AIR_SIDE);
    return (vec2(angle, x) * (size - 1.0) + 0.5) / size;
}

// What is seen of `radiance` at the end of a line of sight over `distanceKm`, through the table of the air.
vec3 behindAir(sampler2DArray air, vec3 radiance, vec3 direction, vec3 sun, float distanceKm, float cameraHeightKm)
{
    vec2 uv = airUv(direction, sun, distanceKm, cameraHeightKm);
    vec3 added =
        withHaze(textureLod(air, vec3(uv, 0.0), 0.0).rgb, textureLod(air, vec3(uv, 2.0), 0.0).rgb, direction, sun);
    vec3 passed = textureLod(air, vec3(uv, 1.0), 0.0).rgb;
    return radiance * passed + added;
}
#endif
