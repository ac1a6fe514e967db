// SPDX-License-Identifier: MIT
#pragma once

// The readers of texts, one a format. Each wants the whole text and gives a finished sea, or a sentence in the log.

#include "core/waves/measured.h"

typedef swResult (*swMeasuredParser)(const swHost* host, const char* text, size_t size, const char* name,
                                     swMeasuredSea** sea);

swResult swParseNdbcEnergy(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);
