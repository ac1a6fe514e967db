// SPDX-License-Identifier: MIT
#pragma once

// A host that keeps its messages, one a line; warnings begin with "warning: ".

#include <stdio.h>
#include <string.h>

#include <seaway/base.h>

static char s_messages[1 << 16];

static inline void KeepMessages(void* context, swLogLevel level, const char* message)
{
    (void)context;
    size_t used = strlen(s_messages);
    snprintf(s_messages + used, sizeof(s_messages) - used, "%s%s\n", level == SW_LOG_WARNING ? "warning: " : "",
             message);
}

static inline swHost MakeHost(void)
{
    swHost host = swDefaultHost();
    host.log = KeepMessages;
    s_messages[0] = '\0';
    return host;
}
