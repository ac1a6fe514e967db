// SPDX-License-Identifier: MIT
// A thin layer of high ice and water cloud, a sheet without thickness: streaks of cirrus and, where the cover is dense,
// ripples of altocumulus. Needs noise.glsl and atmosphere.glsl, shared/picture.h.

const float cloudHeight = 8.0; // km

// Optical thickness at a place of the sheet, km; `footprint` is what a pixel covers there, km.
float cloudThickness(vec2 place, float cover, float footprint)
{
    vec2 warp = vec2(fractalNoise(place * 0.021 + 3.7, 3, footprint * 0.021),
                     fractalNoise(place * 0.021 - 8.2, 3, footprint * 0.021));
    vec2 bent = place + 22.0 * warp;
    // Where the layer is at all: patches of some 60 km.
    float patches = fractalNoise(bent * 0.016, 4, footprint * 0.016) * 1.7 + 0.5;
    float dense = smoothstep(0.88 - cover, 1.55 - cover, patches);
    // Streaks along the wind aloft, drawn out ten to one.
    vec2 along = vec2(bent.x * 0.035 + bent.y * 0.012, bent.y * 0.21 - bent.x * 0.07);
    float streaks = fractalNoise(along + 2.5 * warp.yx, 6, footprint * 0.2) + 0.42;
    // Ripples: short cells that only dense parts have.
    float cells = fractalNoise(bent * vec2(0.46, 0.62) + 3.0 * warp, 5, footprint * 0.6) + 0.35;
    float fibre = clamp(streaks, 0.0, 1.0) * (0.35 + 0.65 * clamp(mix(1.0, 2.2 * cells, dense), 0.0, 1.0));
    return 2.2 * dense * fibre * fibre;
}

// Mostly forward, as ice scatters, with a weak backward lobe.
float cloudPhase(float cosine)
{
    float forward = 0.32 / pow(1.64 - 1.6 * cosine, 1.5);
    float backward = 0.84 / pow(1.16 + 0.8 * cosine, 1.5);
    return (0.65 * 0.36 / 0.32 * forward * 0.9 + 0.35 * backward) / (4.0 * pi);
}

// Where the camera is in the clouds' plane: km, and which way the plane runs there, see swMirrorClouds().
struct CloudOrigin
{
    vec2 place;
    vec2 way;
};

// Radiance (premultiplied) and opacity of the clouds along a ray from `radius` km.
vec4 cloudsAlong(vec3 direction, float radius, CloudOrigin origin, vec3 sun, swSkyLight light, float cover,
                 float pixelAngle)
{
    float mu = direction.y;
    float shell = earthBottom + cloudHeight;
    if (cover <= 0.0 || radius >= shell || mu <= -0.02)
    {
        return vec4(0.0);
    }
    float distance = distanceToSphere(radius, mu, shell);
    vec2 place = origin.place + origin.way * direction.xz * distance;
    place = vec2(swMirrorClouds(place.x), swMirrorClouds(place.y));
    float slant = 1.0 / max(direction.y, 0.12);
    float footprint = max(distance * pixelAngle * slant, 0.02);
    float thickness = cloudThickness(place, cover, footprint) * min(slant, 3.0) * 0.6;
    // Air in between hides what is far away.
    float near = exp(-distance / 95.0) * smoothstep(-0.02, 0.05, mu);
    float opacity = (1.0 - exp(-thickness)) * near;
    float through = exp(-0.5 * thickness);
    vec3 lit = light.high.rgb * (cloudPhase(dot(direction, sun)) * through + 0.075) + light.sky.rgb * (0.55 / pi);
    return vec4(lit * opacity, opacity);
}
