// SPDX-License-Identifier: MIT
// Numbers are parsed here because the C library's parsers follow the locale.

#include "core/base/text.h"

#include <math.h>
#include <string.h>

#include "core/base/host.h"

swText swOpenText(const swHost* host, const char* text, size_t size, const char* name)
{
    bool hasMark = size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0; // UTF-8's byte order mark
    const char* begin = hasMark ? text + 3 : text;
    return (swText){host, name, begin, text + size, 0, begin, begin, begin, ','};
}

static bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

static bool nextLine(swText* text)
{
    if (text->next >= text->end)
    {
        return false;
    }
    const char* end = text->next;
    while (end < text->end && *end != '\n' && *end != '\r')
    {
        ++end;
    }
    bool isPair = end + 1 < text->end && end[0] == '\r' && end[1] == '\n';
    text->lineBegin = text->at = text->next;
    text->lineEnd = end;
    text->next = end < text->end ? end + (isPair ? 2 : 1) : end;
    ++text->line;
    return true;
}

bool swNextLine(swText* text)
{
    while (nextLine(text))
    {
        swPeekChar(text);
        if (text->at < text->lineEnd)
        {
            return true;
        }
    }
    return false;
}

char swPeekChar(swText* text)
{
    while (text->at < text->lineEnd && isSpace(*text->at))
    {
        ++text->at;
    }
    return text->at < text->lineEnd ? *text->at : '\0';
}

static char toLower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c + ('a' - 'A')) : c;
}

// 9, 99, 999, ... whatever their decimals: 999.9 as well.
static bool isNines(double value)
{
    double nines = 9.0;
    while (nines < value && floor(value) != nines && nines < 1e6)
    {
        nines = 10.0 * nines + 9.0;
    }
    return floor(value) == nines;
}

swToken swNextToken(swText* text)
{
    swPeekChar(text);
    const char* begin = text->at;
    while (text->at < text->lineEnd && !isSpace(*text->at))
    {
        bool isParenthesis = *text->at == '(' || *text->at == ')';
        if (isParenthesis && text->at > begin)
        {
            break;
        }
        ++text->at;
        if (isParenthesis)
        {
            break;
        }
    }
    return (swToken){begin, (int)(text->at - begin < 80 ? text->at - begin : 80)};
}

bool swNextField(swText* text, swToken* field)
{
    if (text->at > text->lineEnd)
    {
        return false;
    }
    const char* end =
        text->at < text->lineEnd ? memchr(text->at, text->separator, (size_t)(text->lineEnd - text->at)) : NULL;
    end = end != NULL ? end : text->lineEnd;
    const char* begin = text->at;
    text->at = end + 1;
    while (begin < end && (isSpace(*begin) || *begin == '"'))
    {
        ++begin;
    }
    while (end > begin && (isSpace(end[-1]) || end[-1] == '"'))
    {
        --end;
    }
    *field = (swToken){begin, (int)(end - begin < 80 ? end - begin : 80)};
    return true;
}

bool swIsMissingField(swToken token)
{
    static const char* const words[] = {"", "nan", "na", "n/a", "null", "none", "mm", "-"};
    for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); ++i)
    {
        int same = 0;
        while (same < token.size && words[i][same] != '\0' && toLower(token.text[same]) == words[i][same])
        {
            ++same;
        }
        if (same == token.size && words[i][same] == '\0')
        {
            return true;
        }
    }
    double value = 0.0;
    return swParseToken(token, &value) && value <= -9.0 && isNines(-value);
}

bool swIsToken(swToken token, const char* word)
{
    return (size_t)token.size == strlen(word) && memcmp(token.text, word, (size_t)token.size) == 0;
}

bool swParseToken(swToken token, double* value)
{
    return swParseNumber(token.text, token.size, value);
}

bool swHasPrefix(swText* text, const char* word)
{
    swPeekChar(text);
    size_t size = strlen(word);
    return (size_t)(text->lineEnd - text->at) >= size && memcmp(text->at, word, size) == 0;
}

swResult swNeedLine(swText* text, const char* what)
{
    if (swNextLine(text))
    {
        return SW_SUCCESS;
    }
    return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the file ends where %s should follow; is it cut off?",
                  text->name, text->line > 0 ? text->line : 1, what);
}

static bool isNumberEnd(const char* begin, const char* at)
{
    bool isSign = *at == '-' || *at == '+';
    bool isExponent = at > begin && (at[-1] == 'e' || at[-1] == 'E');
    return isSpace(*at) || *at == ',' || *at == '\'' || (isSign && at > begin && !isExponent);
}

// What follows a number without exponent letter: a sign and three digits.
static bool isLostExponent(const swText* text, const char* begin)
{
    const char* at = text->at;
    bool isThree = text->lineEnd - at >= 4 && at > begin && (text->lineEnd - at == 4 || isNumberEnd(at, at + 4));
    for (int i = 1; i < 4 && isThree; ++i)
    {
        isThree = at[i] >= '0' && at[i] <= '9';
    }
    return isThree && (*at == '-' || *at == '+');
}

swResult swReadNumber(swText* text, const char* what, bool isWide, double* value)
{
    while (swPeekChar(text) == '\0' || *text->at == ',')
    {
        if (text->at < text->lineEnd)
        {
            ++text->at;
            continue;
        }
        swResult result = swNeedLine(text, what);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    const char* begin = text->at;
    while (text->at < text->lineEnd && !isNumberEnd(begin, text->at))
    {
        ++text->at;
    }
    int size = (int)(text->at - begin < 80 ? text->at - begin : 80);
    if (!swParseNumber(begin, size, value))
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s should be a number, not '%.*s'.", text->name, text->line,
                      what, size > 0 ? size : 1, begin);
    }
    if (isWide && isLostExponent(text, begin))
    {
        *value = *text->at == '-' ? 0.0 : 1e60;
        text->at += 4;
    }
    return SW_SUCCESS;
}

swResult swReadRange(swText* text, const char* what, double low, double high, double* value)
{
    swResult result = swReadNumber(text, what, false, value);
    if (result == SW_SUCCESS && !(*value >= low && *value <= high))
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s is %g; it must be from %g to %g.", text->name,
                        text->line, what, *value, low, high);
    }
    return result;
}

swResult swReadCount(swText* text, const char* what, int low, int high, int* value)
{
    double number = 0.0;
    swResult result = swReadRange(text, what, low, high, &number);
    if (result == SW_SUCCESS && number != (double)(int)number)
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s is %g; it must be a whole number.", text->name,
                        text->line, what, number);
    }
    *value = result == SW_SUCCESS ? (int)number : low;
    return result;
}
