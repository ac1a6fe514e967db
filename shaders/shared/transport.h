// SPDX-License-Identifier: MIT
// How water carries what lies on it, such as foam: a texel takes what was upstream of it a step before
// [Staniforth and Cote 1991]. Steps are those of a layer's clock, so that nothing depends on the host's frames.
//
// What is between texels is the polynomial of degree five through six of them along either axis. Interpolation that is
// repeated thirty times a second blurs: over 1,000 texels of way a blob of deviation 4 becomes one of 30 if it is
// linear, one of 5.3 if it is cubic, one of 4.02 with degree five. The polynomial may run beyond its texels, and is
// kept within [0, 1].
#ifndef SW_SHARED_TRANSPORT_H
#define SW_SHARED_TRANSPORT_H
#include "types.h"

// Texels along an axis, of which the place is behind the third.
#define SW_TRANSPORT_TAPS 6

// No way of one step is longer, m.
#define SW_TRANSPORT_REACH 1e5f

// How far upstream, along one axis, a particle was `dt` before, m, in a flow that is steady for so long: to second
// order, so that what turns with an eddy keeps its distance from the eye. `change` is how the velocity along the axis
// changes on the particle's way, (u . grad) u; where a flow has an edge, that may turn back no more than the speed.
SW_FORMULA float swFindUpstream(float velocity, float change, float speed, float dt)
{
    float bend = 0.5f * dt * change;
    bend = bend > speed ? speed : bend < -speed ? -speed : bend;
    float way = dt * (velocity - bend);
    return way > SW_TRANSPORT_REACH ? SW_TRANSPORT_REACH : way < -SW_TRANSPORT_REACH ? -SW_TRANSPORT_REACH : way;
}

// Weight of texel `i` of six for a place that is `t` in [0, 1) behind the third.
SW_FORMULA float swTransportWeight(sw_int i, float t)
{
    float a = t + 2.0f, b = t + 1.0f, c = t - 1.0f, d = t - 2.0f, e = t - 3.0f;
    switch (i)
    {
    case 0:
        return b * t * c * d * e * (-1.0f / 120.0f);
    case 1:
        return a * t * c * d * e * (1.0f / 24.0f);
    case 2:
        return a * b * c * d * e * (-1.0f / 12.0f);
    case 3:
        return a * b * t * d * e * (1.0f / 12.0f);
    case 4:
        return a * b * t * c * e * (-1.0f / 24.0f);
    default:
        return a * b * t * c * d * (1.0f / 120.0f);
    }
}
#endif
