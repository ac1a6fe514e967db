// SPDX-License-Identifier: MIT
// The displaced surface's normal from the gradients of displacement (x, h, z) by rest position. The tangents are
// Tx = (1 + dDx/dx, dh/dx, dDz/dx) and Tz = (dDx/dz, dh/dz, 1 + dDz/dz); their cross product Tz x Tx is (-gx, J, -gz).
// It stays smooth where the surface folds (J = 0), which the slope (gx, gz) / J does not. Horizontal displacement is
// itself a gradient, so that dDx/dz is dDz/dx and need not be summed. Where places shape waves that is not so: there
// queries take dDx/dz in its places, which are the one in J and the one in gz; slices do not.
#ifndef SW_SHARED_SURFACE_NORMAL_H
#define SW_SHARED_SURFACE_NORMAL_H
#include "types.h"

// Determinant of the horizontal Jacobian: 1 on flat water, below 0 folded over. By three derivatives, and by all four.
SW_FORMULA float swSurfaceJacobian(float dxdx, float dzdx, float dzdz)
{
    return (1.0f + dxdx) * (1.0f + dzdz) - dzdx * dzdx;
}

SW_FORMULA float swSurfaceArea(float dxdx, float dxdz, float dzdx, float dzdz)
{
    return (1.0f + dxdx) * (1.0f + dzdz) - dxdz * dzdx;
}

SW_FORMULA float swSurfaceNormalX(float dzdx, float dzdz, float dhdx, float dhdz)
{
    return dhdx * (1.0f + dzdz) - dhdz * dzdx;
}

SW_FORMULA float swSurfaceNormalZ(float dxdx, float dzdx, float dhdx, float dhdz)
{
    return dhdz * (1.0f + dxdx) - dhdx * dzdx;
}
#endif
