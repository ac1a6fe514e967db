// SPDX-License-Identifier: MIT
#pragma once

// Reading on after a fault. What may fail gets a host that keeps the first error instead of telling it; then the
// error is either told as a warning, because only one record of many is lost, or passed on.

#include <stdbool.h>

#include "core/base/host.h"
#include "core/base/seam.h"

#define SW_TRIAL_MESSAGE 1024

typedef struct swTrial
{
    swHost host; // for what may fail; other messages than errors go straight through
    const swHost* outer;
    int leftOutCount;
    char message[SW_TRIAL_MESSAGE]; // the first error since the last verdict; empty: none
    char first[SW_TRIAL_MESSAGE];   // that of what was left out first
} swTrial;

SW_SEAM_BEGIN

// The trial must stay where it is as long as its host is in use.
void swBeginTrial(swTrial* trial, const swHost* outer);

// After each record. One that is no data (SW_ERROR_FORMAT) is left out with a warning that names its place, such as
// "line" 7, and SW_SUCCESS is returned; other results are passed on with their error. Of many that are left out, the
// first few are told.
swResult swJudgeTrial(swTrial* trial, swResult result, const char* place, int number);

// After all records: tells the error that is kept, or how many records were left out in silence. The result is passed
// on.
swResult swEndTrial(swTrial* trial, swResult result);

SW_SEAM_END
