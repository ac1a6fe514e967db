// SPDX-License-Identifier: MIT
#include "csv_numbers.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "args.h"
#include "common.h"

// Where a file is read and what its columns hold.
typedef struct Reader
{
    const char* name;
    int lineNumber;
    int fieldCount;               // of a line; 0: not known yet
    int fields[MAX_CSV_COLUMNS];  // of each column of the format; -1: none
    char* words[MAX_CSV_COLUMNS]; // of the line
    CsvNumbers* numbers;
} Reader;

// Cut a line at its commas, blanks around the fields removed. Returns the number of fields.
static int SplitLine(char* line, char** words)
{
    int count = 0;
    line[strcspn(line, "\r\n")] = 0;
    for (char* part = line; part != NULL; ++count)
    {
        char* comma = strchr(part, ',');
        if (comma != NULL)
        {
            *comma = 0;
        }
        part += strspn(part, " \t");
        for (size_t end = strlen(part); end > 0 && strchr(" \t", part[end - 1]) != NULL; --end)
        {
            part[end - 1] = 0;
        }
        if (count < MAX_CSV_COLUMNS)
        {
            words[count] = part;
        }
        part = comma != NULL ? comma + 1 : NULL;
    }
    return count;
}

// "x,y,z", or without the optional column.
static void JoinNames(const CsvFormat* format, bool withOptional, char* text, size_t size)
{
    size_t used = 0;
    for (int i = 0; i < format->columnCount && used < size; ++i)
    {
        if (withOptional || !format->columns[i].isOptional)
        {
            used += (size_t)snprintf(text + used, size - used, "%s%s", used > 0 ? "," : "", format->columns[i].name);
        }
    }
}

// The columns of a file without a header.
static bool CountColumns(Reader* reader, int fieldCount)
{
    const CsvFormat* format = reader->numbers->format;
    int required = 0, next = 0;
    for (int i = 0; i < format->columnCount; ++i)
    {
        required += format->columns[i].isOptional ? 0 : 1;
    }
    if (fieldCount != required && fieldCount != format->columnCount)
    {
        char few[128], many[128];
        JoinNames(format, false, few, sizeof(few));
        JoinNames(format, true, many, sizeof(many));
        Complain("%s:%d: a line without a header has %d columns (%s) or %d (%s), not %d", reader->name,
                 reader->lineNumber, required, few, format->columnCount, many, fieldCount);
        return false;
    }
    for (int i = 0; i < format->columnCount; ++i)
    {
        bool isThere = fieldCount == format->columnCount || !format->columns[i].isOptional;
        reader->fields[i] = isThere ? next++ : -1;
    }
    return true;
}

// A field, which may say that its number is not known: NAN.
static bool ParseField(const char* word, double* value)
{
    bool isUnknown = strcasecmp(word, "nan") == 0;
    *value = isUnknown ? (double)NAN : 0.0;
    return isUnknown || ParseNumber(word, value);
}

// -1: there is none; -2: there are several.
static int FindField(const CsvColumn* column, int fieldCount, char* const* words)
{
    int found = -1;
    for (int i = 0; i < fieldCount; ++i)
    {
        if (strcmp(words[i], column->name) == 0 ||
            (column->nameWithUnit != NULL && strcmp(words[i], column->nameWithUnit) == 0))
        {
            found = found == -1 ? i : -2;
        }
    }
    return found;
}

static bool NameColumns(Reader* reader, int fieldCount)
{
    const CsvFormat* format = reader->numbers->format;
    for (int i = 0; i < format->columnCount; ++i)
    {
        reader->fields[i] = FindField(format->columns + i, fieldCount, reader->words);
        if (reader->fields[i] == -2)
        {
            Complain("%s:%d: the header names several columns %s; keep one", reader->name, reader->lineNumber,
                     format->columns[i].name);
            return false;
        }
        if (reader->fields[i] < 0 && !format->columns[i].isOptional)
        {
            Complain("%s:%d: the header names no column %s", reader->name, reader->lineNumber, format->columns[i].name);
            return false;
        }
    }
    return true;
}

// From the first line. Sets whether it is a header.
static bool FindColumns(Reader* reader, int fieldCount, bool* isHeader)
{
    const CsvFormat* format = reader->numbers->format;
    double number = 0.0;
    *isHeader = !ParseField(reader->words[0], &number);
    if (!(*isHeader ? NameColumns(reader, fieldCount) : CountColumns(reader, fieldCount)))
    {
        return false;
    }
    reader->fieldCount = fieldCount;
    for (int i = 0; i < format->columnCount; ++i)
    {
        reader->numbers->hasOptional |= format->columns[i].isOptional && reader->fields[i] >= 0;
    }
    return true;
}

static bool ReadField(const Reader* reader, const CsvColumn* column, const char* word, double* value)
{
    if (!ParseField(word, value))
    {
        Complain("%s:%d: \"%s\" is no number", reader->name, reader->lineNumber, word);
        return false;
    }
    if (column->min < column->max && !isnan(*value) && !(*value >= column->min && *value <= column->max))
    {
        Complain("%s:%d: %s %s is outside its range of %.10g to %.10g", reader->name, reader->lineNumber, column->name,
                 word, column->min, column->max);
        return false;
    }
    return true;
}

static bool AppendRow(CsvNumbers* numbers, const double* row)
{
    size_t rowSize = (size_t)numbers->format->columnCount * sizeof(double);
    if (numbers->count == numbers->capacity)
    {
        int capacity = numbers->capacity > 0 ? 2 * numbers->capacity : 1024;
        double* values = realloc(numbers->values, (size_t)capacity * rowSize);
        if (values == NULL)
        {
            Complain("no memory for %d %s", capacity, numbers->format->rows);
            return false;
        }
        numbers->values = values;
        numbers->capacity = capacity;
    }
    memcpy(numbers->values + (size_t)numbers->count * (size_t)numbers->format->columnCount, row, rowSize);
    numbers->count += 1;
    return true;
}

static bool ReadRow(Reader* reader)
{
    const CsvFormat* format = reader->numbers->format;
    double row[MAX_CSV_COLUMNS] = {0.0};
    bool isKnown = true;
    for (int i = 0; i < format->columnCount; ++i)
    {
        int field = reader->fields[i];
        if (field >= 0 && !ReadField(reader, format->columns + i, reader->words[field], row + i))
        {
            return false;
        }
        isKnown &= !isnan(row[i]);
    }
    reader->numbers->unknownCount += !isKnown;
    const char* problem = format->check != NULL ? format->check(row) : NULL;
    if (problem != NULL)
    {
        Complain("%s:%d: %s", reader->name, reader->lineNumber, problem);
        return false;
    }
    return AppendRow(reader->numbers, row);
}

static bool ReadLine(Reader* reader, char* line)
{
    int fieldCount = SplitLine(line, reader->words);
    if (fieldCount == 1 && reader->words[0][0] == 0)
    {
        return true; // an empty line
    }
    if (fieldCount > MAX_CSV_COLUMNS)
    {
        Complain("%s:%d: %d columns are more than %d", reader->name, reader->lineNumber, fieldCount, MAX_CSV_COLUMNS);
        return false;
    }
    if (reader->fieldCount == 0)
    {
        bool isHeader = false;
        bool isKnown = FindColumns(reader, fieldCount, &isHeader);
        if (!isKnown || isHeader)
        {
            return isKnown;
        }
    }
    if (fieldCount != reader->fieldCount)
    {
        Complain("%s:%d: %d columns where the lines before have %d", reader->name, reader->lineNumber, fieldCount,
                 reader->fieldCount);
        return false;
    }
    return ReadRow(reader);
}

// The next line without its end, which is LF, CR LF or CR; false at the end of the file. One that is too long is cut,
// and `line` full.
static bool NextLine(FILE* file, char* line, size_t size)
{
    size_t used = 0;
    int c = getc(file);
    bool isMore = c != EOF;
    while (c != EOF && c != '\n' && c != '\r' && used + 1 < size)
    {
        line[used++] = (char)c;
        c = used + 1 < size ? getc(file) : '\n';
    }
    line[used] = 0;
    if (c == '\r')
    {
        c = getc(file);
        ungetc(c == '\n' ? EOF : c, file); // EOF puts nothing back
    }
    return isMore;
}

static bool ReadLines(Reader* reader, FILE* file)
{
    char line[1024];
    while (NextLine(file, line, sizeof(line)))
    {
        reader->lineNumber += 1;
        if (reader->lineNumber == 1 && strncmp(line, "\xef\xbb\xbf", 3) == 0)
        {
            memmove(line, line + 3, strlen(line + 3) + 1); // the mark that some programs put before UTF-8
        }
        if (strlen(line) + 1 == sizeof(line))
        {
            Complain("%s:%d: the line is longer than %d characters", reader->name, reader->lineNumber,
                     (int)sizeof(line) - 2);
            return false;
        }
        if (!ReadLine(reader, line))
        {
            return false;
        }
    }
    if (ferror(file))
    {
        Complain("cannot read %s: %s", reader->name, strerror(errno));
        return false;
    }
    return true;
}

bool ReadCsvNumbers(const char* path, const CsvFormat* format, CsvNumbers* numbers)
{
    bool isInput = strcmp(path, "-") == 0;
    FILE* file = isInput ? stdin : fopen(path, "r");
    if (file == NULL)
    {
        Complain("cannot read %s: %s", path, strerror(errno));
        return false;
    }
    numbers->format = format;
    Reader reader = {.name = isInput ? "standard input" : path, .numbers = numbers};
    bool isFine = ReadLines(&reader, file);
    if (!isInput)
    {
        fclose(file);
    }
    if (isFine && numbers->unknownCount > 0)
    {
        Complain("warning: %s: %d of %d %s have a \"nan\" for a place; they are answered with nan", reader.name,
                 numbers->unknownCount, numbers->count, format->rows);
    }
    if (isFine && numbers->count == 0)
    {
        Complain("%s holds no %s", reader.name, format->rows);
        return false;
    }
    return isFine;
}

const double* GetCsvRow(const CsvNumbers* numbers, int row)
{
    return numbers->values + (size_t)row * (size_t)numbers->format->columnCount;
}

void FreeCsvNumbers(CsvNumbers* numbers)
{
    free(numbers->values);
    *numbers = (CsvNumbers){0};
}
