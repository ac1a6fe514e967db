// SPDX-License-Identifier: MIT
#include "gpu/pass/hazards.h"

uint32_t swTakeStep(swHazards* hazards, swStepStage stage, swResources reads, swResources writes)
{
    uint32_t waits = 0;
    bool mustWait = false;
    for (int by = 0; by < SW_STAGE_COUNT; ++by)
    {
        swResources written = hazards->written[by][stage];
        swResources read = hazards->read[by][stage];
        mustWait = mustWait || ((reads | writes) & written) != 0 || (writes & read) != 0;
        waits |= (written | read) != 0 ? 1u << by : 0;
    }
    for (int by = 0; by < SW_STAGE_COUNT && mustWait; ++by)
    {
        hazards->written[by][stage] = 0; // one barrier is for everything
        hazards->read[by][stage] = 0;
    }
    for (int seenBy = 0; seenBy < SW_STAGE_COUNT; ++seenBy)
    {
        hazards->written[stage][seenBy] |= writes;
        hazards->read[stage][seenBy] |= reads;
    }
    return mustWait ? waits : 0;
}
