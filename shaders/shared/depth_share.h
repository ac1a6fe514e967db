// SPDX-License-Identifier: MIT
// The share of its amplitude that a wave keeps over a floor, by its wave number k and the depth of still water. It is
// tanh(k depth), the ratio of a wave's height to its orbits' width at the surface, up to a depth of a quarter of the
// wavelength. From there it is blended so that it is 1, to the bit, from half a wavelength on: deeper water costs
// nothing. It is 0 where the depth is 0 or less. It never falls with depth, and its derivative is continuous but for
// the water's edge, where the wave ends. All three parts of a wave's displacement take the same share, so that sideways
// motion ends at the edge too, by whatever factor of 1 / tanh(k depth) it was widened for the sea's own depth.
//
// An octave of waves takes one share, that of the geometric mean of its ends: k = 2 pi / sqrt(shortest longest). Where
// the depth is a tenth of the wavelength, its longest waves then keep 0.15 more than they would by themselves, and its
// shortest as much less; elsewhere it is not as much.
#ifndef SW_SHARED_DEPTH_SHARE_H
#define SW_SHARED_DEPTH_SHARE_H
#include "types.h"

#ifdef __STDC__
#include "core/math/scalar.h"
#define SW_DEPTH_EXP swExpF
#else
#define SW_DEPTH_EXP exp
#endif

// k depth from which on a wave is left alone: half a wavelength. And where the blend begins.
#define SW_DEEP_KD 3.1415927f
#define SW_BLEND_KD 1.5707964f

// What a host may do to the law. In nature it is (1, 0).
SW_PARAMS(swAttenuation)
{
    float strength;     // 1: waves end at the water's edge; 0: waves that do not care for the floor
    float perFreeDepth; // 1/m: from the inverse of it on no wave is attenuated, however long; 0: by its length alone
};
SW_PARAMS_SIZE(swAttenuation, 8);

SW_PARAMS(swDepthShare)
{
    float share;
    float slope; // the share's derivative: by k depth or by depth, as the function says
};
SW_PARAMS_SIZE(swDepthShare, 8);

SW_FORMULA swDepthShare swMakeDepthShare(float share, float slope)
{
    swDepthShare made;
    made.share = share;
    made.slope = slope;
    return made;
}

// By k depth, as nature has it; the slope is by k depth.
SW_FORMULA swDepthShare swFindNaturalShare(float kd)
{
    if (!(kd > 0.0f))
    {
        return swMakeDepthShare(0.0f, 0.0f);
    }
    if (kd >= SW_DEEP_KD)
    {
        return swMakeDepthShare(1.0f, 0.0f);
    }
    float e = SW_DEPTH_EXP(-2.0f * kd);
    float t = (1.0f - e) / (1.0f + e);
    float slope = 1.0f - t * t;
    if (kd <= SW_BLEND_KD)
    {
        return swMakeDepthShare(t, slope);
    }
    float part = (kd - SW_BLEND_KD) / (SW_DEEP_KD - SW_BLEND_KD);
    float blend = part * part * (3.0f - 2.0f * part);
    float blendSlope = 6.0f * part * (1.0f - part) / (SW_DEEP_KD - SW_BLEND_KD);
    return swMakeDepthShare(t + (1.0f - t) * blend, slope * (1.0f - blend) + (1.0f - t) * blendSlope);
}

// Whether a wave of wave number k, rad/m, is left alone in water of some depth, m: then so are all shorter waves, and
// the wave wherever it is deeper.
SW_FORMULA bool swIsDeepFor(swAttenuation attenuation, float k, float depth)
{
    return !(attenuation.strength > 0.0f) || depth * attenuation.perFreeDepth >= 1.0f || k * depth >= SW_DEEP_KD;
}

// The share and its slope per metre of depth. The depth may be negative (land) or infinite (no floor). Exactly 1 with
// slope 0 where the wave is left alone.
SW_FORMULA swDepthShare swFindDepthShare(swAttenuation attenuation, float k, float depth)
{
    if (swIsDeepFor(attenuation, k, depth))
    {
        return swMakeDepthShare(1.0f, 0.0f);
    }
    swDepthShare found = swFindNaturalShare(k * depth);
    found.slope = found.slope * k;
    float part = depth * attenuation.perFreeDepth;
    if (part > 0.0f)
    {
        float blend = part * part * (3.0f - 2.0f * part);
        float blendSlope = 6.0f * part * (1.0f - part) * attenuation.perFreeDepth;
        found.slope = found.slope * (1.0f - blend) + (1.0f - found.share) * blendSlope;
        found.share = found.share + (1.0f - found.share) * blend;
    }
    found.slope = attenuation.strength * found.slope;
    found.share = 1.0f - attenuation.strength * (1.0f - found.share);
    return found;
}
#endif
