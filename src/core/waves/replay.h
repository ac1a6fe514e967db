// SPDX-License-Identifier: MIT
#pragma once

// A wave system that plays the records of a measured sea. It has one part: the set of one record, or a mix of two
// whose share the replay sets. The two sets stay with the replay as long as their pair is current, so that a step
// forward makes one new set and not two.

#include "core/waves/waves.h"
#include "seaway/measured.h"

typedef struct swReplay
{
    const swMeasuredSea* sea;
    swWaveSystemDef waves; // all but the table
    int before, after;     // records; -1: none yet
    double fraction;
    uint32_t rewindCount; // of the waves, when the pair became current
    swWaveSet* sets[2];   // of both; the second may be the first
} swReplay;

// The system in `slot` becomes that of two records, `fraction` of the way from the first to the second. The clock says
// when the pair counts.
swResult swShowRecords(swWaves* waves, swReplay* replay, int slot, int before, int after, double fraction,
                       const swRecordClock* clock);
void swEndReplay(swWaves* waves, swReplay* replay);

// The def of a record's waves; `table` must live as long.
swWaveSystemDef swMakeRecordDef(const swWaveSystemDef* waves, const swSpectrumTable* table);
