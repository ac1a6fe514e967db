// SPDX-License-Identifier: MIT
#include "core/base/trial.h"

#include <string.h>

// Of what is left out, told one by one.
#define MOST_TOLD 5

static void keepError(void* context, swLogLevel level, const char* message)
{
    swTrial* trial = context;
    if (level != SW_LOG_ERROR)
    {
        swLog(trial->outer, level, "%s", message);
    }
    else if (trial->message[0] == '\0')
    {
        size_t length = strlen(message);
        length = length < SW_TRIAL_MESSAGE ? length : SW_TRIAL_MESSAGE - 1;
        memcpy(trial->message, message, length);
        trial->message[length] = '\0';
    }
}

void swBeginTrial(swTrial* trial, const swHost* outer)
{
    memset(trial, 0, sizeof(*trial));
    trial->outer = outer;
    trial->host = *outer;
    trial->host.log = keepError;
    trial->host.logContext = trial;
}

swResult swJudgeTrial(swTrial* trial, swResult result, const char* place, int number)
{
    if (result == SW_ERROR_FORMAT)
    {
        if (trial->leftOutCount == 0)
        {
            memcpy(trial->first, trial->message, sizeof(trial->first));
        }
        if (trial->leftOutCount < MOST_TOLD)
        {
            swLog(trial->outer, SW_LOG_WARNING, "%s It is left out (%s %d).", trial->message, place, number);
        }
        ++trial->leftOutCount;
        trial->message[0] = '\0';
        return SW_SUCCESS;
    }
    return result;
}

swResult swEndTrial(swTrial* trial, swResult result)
{
    if (trial->message[0] != '\0' && result != SW_SUCCESS)
    {
        swLog(trial->outer, SW_LOG_ERROR, "%s", trial->message);
    }
    if (trial->leftOutCount > MOST_TOLD)
    {
        swLog(trial->outer, SW_LOG_WARNING, "%d more were left out for such reasons, %d in all.",
              trial->leftOutCount - MOST_TOLD, trial->leftOutCount);
    }
    trial->message[0] = '\0';
    return result;
}
