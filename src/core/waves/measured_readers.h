// SPDX-License-Identifier: MIT
#pragma once

// The readers of texts, one a format. Each wants the whole text and gives a finished sea, or a sentence in the log.

#include "core/waves/measured.h"

typedef swResult (*swMeasuredParser)(const swHost* host, const char* text, size_t size, const char* name,
                                     swMeasuredSea** sea);

swResult swParseNdbcEnergy(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);
swResult swParseSwan(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);
swResult swParseWavewatch(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);
swResult swParseTriaxys(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);
swResult swParseDatawell(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);
swResult swParseWavewatchPartitions(const swHost* host, const char* text, size_t size, const char* name,
                                    swMeasuredSea** sea);
swResult swParsePartitionTable(const swHost* host, const char* text, size_t size, const char* name,
                               swMeasuredSea** sea);

// Whether a text begins as theirs do.
bool swIsSwan(const char* text, size_t size);
bool swIsWavewatch(const char* text, size_t size);
bool swIsTriaxys(const char* text, size_t size);
bool swIsDatawell(const char* text, size_t size);
bool swIsWavewatchPartitions(const char* text, size_t size);
bool swIsPartitionTable(const char* text, size_t size);

// ---- what WAVEWATCH III's files share ----

// The place of a point by its name, looked for first where it stands in a block; a new one is added.
swResult swFindSeaPoint(swMeasuredSea* sea, bool isNew, int index, const char* name, double longitude, double latitude,
                        int* location);

// A name in quotes at the place in a line, without the spaces that fill it up.
swResult swReadSeaName(swSeaText* text, char name[64]);

// yyyymmdd hhmmss.
swResult swReadPackedTime(swSeaText* text, double* seconds);
