// SPDX-License-Identifier: MIT
#pragma once

// The readers of texts, one a format. Each wants the whole text and gives a finished sea, or a sentence in the log.

#include "core/base/text.h"
#include "core/base/trial.h"
#include "core/records/measured.h"

// What every reader of a text begins with. Messages go to text.host, which is the trial's: a record that fails is
// judged, left out with a warning, and the rest is read.
typedef struct swSeaReader
{
    swText text;
    swMeasuredSea* sea; // to fill
    swTrial trial;
} swSeaReader;

typedef swResult (*swReadSeaFcn)(void* reader);

// Runs a reader of one format on a text, all from opening it to a finished sea. The reader's struct begins with a
// swSeaReader; it is cleared, and too large for a stack.
swResult swRunReader(const swHost* host, const char* text, size_t size, const char* name, size_t readerSize,
                     swReadSeaFcn read, swMeasuredSea** sea);

// A sea that a function fills, finished; nothing if that fails. For formats that are read before it is known what they
// hold.
typedef swResult (*swFillSeaFcn)(const swHost* host, const void* file, swMeasuredSea* sea);
swResult swMakeFilledSea(const swHost* host, const char* name, swFillSeaFcn fill, const void* file,
                         swMeasuredSea** sea);

// After each record: leaves it out with its line if it failed, see swJudgeTrial().
swResult swJudgeRecord(swSeaReader* reader, swResult result, int line);

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
swResult swParseSpotterCsv(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);
swResult swParseAwac(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);
swResult swParseOctopus(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);
swResult swParseObscape(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);

// Whether a text begins as theirs do.
bool swIsSwan(const char* text, size_t size);
bool swIsWavewatch(const char* text, size_t size);
bool swIsTriaxys(const char* text, size_t size);
bool swIsDatawell(const char* text, size_t size);
bool swIsWavewatchPartitions(const char* text, size_t size);
bool swIsPartitionTable(const char* text, size_t size);
bool swIsSpotterCsv(const char* text, size_t size);
bool swIsAwac(const char* text, size_t size);
bool swIsOctopus(const char* text, size_t size);
bool swIsObscape(const char* text, size_t size);

// ---- what WAVEWATCH III's files share ----

// A name in quotes at the place in a line, without the spaces that fill it up.
swResult swReadSeaName(swText* text, char name[64]);

// Whether a line begins as a date and time of theirs.
bool swIsPackedTime(const swText* line);

// yyyymmdd hhmmss.
swResult swReadPackedTime(swText* text, double* seconds);
