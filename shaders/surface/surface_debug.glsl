// SPDX-License-Identifier: MIT
// What swDebugMode shows instead of the water. `deviations` is the height above sea level in the sea's deviations.

#define SW_DEBUG_MODE(name, number, word) const uint name = number;
#include "shared/debug_modes.inl"
#undef SW_DEBUG_MODE

// Neighbouring slices differ by a part of the circle of hues that no small number of them closes.
vec3 sliceHue(uint slice)
{
    return 0.5 + 0.5 * cos(6.2831853 * (float(slice) * 0.381966 + vec3(0.0, 0.33, 0.67)));
}

vec3 debugColor(uint mode, Slopes slopes, float foam, uint ring, float blend, float deviations)
{
    vec3 normal = facetNormal(slopes.mean);
    switch (mode)
    {
    case SW_DEBUG_SLICES: // their colours, blending
        return mix(sliceHue(ring), sliceHue(ring + 1), blend) * (0.35 + 0.65 * normal.y * normal.y);
    case SW_DEBUG_WIREFRAME:
        return sliceHue(ring);
    case SW_DEBUG_NORMALS:
        return 0.5 + 0.5 * normal.xzy;
    case SW_DEBUG_HEIGHT: // two deviations from black to white
        return vec3(0.5 + 0.25 * deviations);
    case SW_DEBUG_JACOBIAN: // grey 1, red below 0
        return slopes.jacobian < 0.0 ? vec3(1.0, 0.1, 0.0) : vec3(0.5 * slopes.jacobian);
    case SW_DEBUG_FOAM:
        return vec3(foam);
    case SW_DEBUG_ROUGHNESS:
        return vec3(sqrt(slopes.variance) * 4.0, 0.0);
    default: // none has no colour of its own
        return vec3(0.0);
    }
}
