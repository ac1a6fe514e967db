// SPDX-License-Identifier: MIT
// What swDebugMode shows instead of the water. `deviations` is the height above sea level in the sea's deviations.

vec3 debugColor(uint mode, Slopes slopes, float foam, uint ring, float blend, float deviations)
{
    vec3 hue = 0.5 + 0.5 * cos(6.2831853 * (float(ring) * 0.381966 + vec3(0.0, 0.33, 0.67)));
    switch (mode)
    {
    case 1: // slices: their colours, blending
    {
        vec3 next = 0.5 + 0.5 * cos(6.2831853 * (float(ring + 1) * 0.381966 + vec3(0.0, 0.33, 0.67)));
        return mix(hue, next, blend) * (0.35 + 0.65 * facetNormal(slopes.mean).y * facetNormal(slopes.mean).y);
    }
    case 2: // wireframe
        return hue;
    case 3: // normals
        return 0.5 + 0.5 * facetNormal(slopes.mean).xzy;
    case 4: // height: two deviations from black to white
        return vec3(0.5 + 0.25 * deviations);
    case 5: // Jacobian: grey 1, red below 0
        return slopes.jacobian < 0.0 ? vec3(1.0, 0.1, 0.0) : vec3(0.5 * slopes.jacobian);
    case 6: // foam
        return vec3(foam);
    default: // roughness
        return vec3(sqrt(slopes.variance) * 4.0, 0.0);
    }
}
