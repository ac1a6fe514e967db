// SPDX-License-Identifier: MIT
#include "core/query/answers.h"

#include "core/frame/asked.h"

bool swPlacePoint(const swQuery* query, double x, double z, swPosXZ* place)
{
    *place = (swPosXZ){x + query->origin.x, z + query->origin.z};
    return swIsNear(x) && swIsNear(z);
}

void swRefuseStats(int count, swQueryStats* stats)
{
    if (stats != NULL)
    {
        *stats = (swQueryStats){.badCount = count > 0 ? count : 0};
    }
}

void swCountFound(swQueryStats* stats, const swFound* found, int count, float tolerance)
{
    stats->iterationCount += found->evaluations;
    for (int i = 0; i < count; ++i)
    {
        float residual = found->residual[i];
        stats->convergedCount += residual <= tolerance ? 1 : 0;
        stats->worstResidual = residual > stats->worstResidual ? residual : stats->worstResidual;
    }
}
