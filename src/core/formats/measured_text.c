// SPDX-License-Identifier: MIT
// Which format a text of measured seas has, by its first lines; and the readers by format.

#include <string.h>

#include "core/base/misuse.h"
#include "core/base/text.h"
#include "core/formats/measured_readers.h"

static swText openText(const char* text, size_t size)
{
    return swOpenText(NULL, text, size, "");
}

// ---- what a text looks like ----

static bool isNdbcDate(swText* line)
{
    double date[4];
    for (int i = 0; i < 4; ++i)
    {
        if (!swParseToken(swNextToken(line), &date[i]))
        {
            return false;
        }
    }
    return date[0] >= 0.0 && date[0] < 2200.0 && date[1] >= 1.0 && date[1] <= 12.0 && date[2] >= 1.0 &&
           date[2] <= 31.0 && date[3] >= 0.0 && date[3] < 24.0;
}

// NDBC: a heading of dates, or a line that begins with one, be the first few broken. It is the last that is tried.
static bool isNdbcSpectrum(const char* text, size_t size)
{
    swText lines = openText(text, size);
    for (int others = 0; others < 4 && swNextLine(&lines);)
    {
        bool isComment = swPeekChar(&lines) == '#';
        lines.at += isComment ? 1 : 0;
        if (swHasPrefix(&lines, "YY") || (!isComment && isNdbcDate(&lines)))
        {
            return true;
        }
        others += isComment ? 0 : 1;
    }
    return false;
}

static const struct
{
    const char* name;
    bool (*isOf)(const char* text, size_t size);
    swMeasuredParser parse;
} s_formats[SW_MEASURED_FORMAT_COUNT] = {
    [SW_MEASURED_UNKNOWN] = {"unknown", NULL, NULL},
    [SW_MEASURED_NDBC_SUMMARY] = {"NDBC summary", swIsNdbcSummary, swParseNdbcSummary},
    [SW_MEASURED_NDBC_SPECTRUM] = {"NDBC spectra", isNdbcSpectrum, swParseNdbcEnergy},
    [SW_MEASURED_SWAN] = {"SWAN spectra", swIsSwan, swParseSwan},
    [SW_MEASURED_WAVEWATCH] = {"WAVEWATCH III spectra", swIsWavewatch, swParseWavewatch},
    [SW_MEASURED_WAVEWATCH_PARTITIONS] = {"WAVEWATCH III partitions", swIsWavewatchPartitions,
                                          swParseWavewatchPartitions},
    [SW_MEASURED_PARTITION_TABLE] = {"table of partitions", swIsPartitionTable, swParsePartitionTable},
    [SW_MEASURED_TRIAXYS] = {"TriAxys spectrum", swIsTriaxys, swParseTriaxys},
    [SW_MEASURED_DATAWELL] = {"Datawell spectrum", swIsDatawell, swParseDatawell},
    [SW_MEASURED_SPOTTER_CSV] = {"Spotter table", swIsSpotterCsv, swParseSpotterCsv},
    [SW_MEASURED_AWAC] = {"AWAC sentences", swIsAwac, swParseAwac},
    [SW_MEASURED_OCTOPUS] = {"Octopus spectra", swIsOctopus, swParseOctopus},
    [SW_MEASURED_OBSCAPE] = {"Obscape spectrum", swIsObscape, swParseObscape},
};

swMeasuredFormat swFindMeasuredFormat(const char* text, size_t size)
{
    // A summary looks like a spectrum file that says more.
    for (int i = SW_MEASURED_FORMAT_COUNT - 1; i > SW_MEASURED_UNKNOWN; --i)
    {
        if (text != NULL && s_formats[i].isOf != NULL && s_formats[i].isOf(text, size))
        {
            return (swMeasuredFormat)i;
        }
    }
    return SW_MEASURED_UNKNOWN;
}

const char* swGetMeasuredFormatName(swMeasuredFormat format)
{
    bool isKnown = (int)format >= 0 && format < SW_MEASURED_FORMAT_COUNT && s_formats[format].name != NULL;
    return isKnown ? s_formats[format].name : s_formats[SW_MEASURED_UNKNOWN].name;
}

swResult swParseNdbcEnergy(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    swNdbcTexts texts = {.energy = text, .energySize = size, .energyName = name};
    return swParseNdbc(host, &texts, sea);
}

swResult swParseMeasuredSea(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    SW_REQUIRE_PLACE(host, sea, "swParseMeasuredSea()");
    swMeasuredFormat format = swFindMeasuredFormat(text, size);
    bool isWide = text != NULL && size >= 2 && (memcmp(text, "\xFF\xFE", 2) == 0 || memcmp(text, "\xFE\xFF", 2) == 0);
    if (isWide)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:1: the text is UTF-16; save it as UTF-8.",
                      name != NULL ? name : "text");
    }
    if (format == SW_MEASURED_UNKNOWN)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:1: the format is not known. Read are %s.",
                      name != NULL ? name : "text", swGetMeasuredFormatList());
    }
    return s_formats[format].parse(host, text, size, name, sea);
}

const char* swGetMeasuredFormatList(void)
{
    return "spectra and summaries of NDBC; spectra of SWAN, of WAVEWATCH III and Octopus (text), of TriAxys, Datawell "
           "(.spt), Spotter (table) and Obscape buoys, of AWAC profilers (NMEA); "
           "partitions of WAVEWATCH III and tables of them (time,hs_m,tp_s,direction_from_deg,spread_deg,gamma)";
}
