// SPDX-License-Identifier: MIT
// Messages come from many threads while a bar is drawn: each arrives whole, on a line of its own, with the bar wiped
// before it. And what others wrote reaches the terminal as text only.

#include "support/cmocka_setup.h"

#include <fcntl.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "progress.h"
#include "seconds.h"
#include "text.h"
#include "verbs.h"

#define THREADS 8
#define MESSAGES 200
#define LETTERS 60

// The bar's clock, which runs fast enough to draw at every update.
double GetSeconds(void)
{
    static double seconds;
    return seconds += 10.0;
}

static void* Talk(void* context)
{
    char line[LETTERS + 1];
    memset(line, *(const char*)context, LETTERS);
    line[LETTERS] = 0;
    for (int i = 0; i < MESSAGES; ++i)
    {
        WriteTerminalLine(line);
    }
    return NULL;
}

static void* ReadAll(void* context)
{
    static char text[4 << 20];
    size_t used = 0;
    ssize_t count = 0;
    while ((count = read(*(const int*)context, text + used, sizeof(text) - 1 - used)) > 0)
    {
        used += (size_t)count;
    }
    text[used] = 0;
    return text;
}

// What a terminal gets of talking threads and a bar.
static const char* RecordTerminal(void)
{
    int master = posix_openpt(O_RDWR | O_NOCTTY);
    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0)
    {
        return NULL;
    }
    int terminal = open(ptsname(master), O_RDWR | O_NOCTTY), old = dup(STDERR_FILENO);
    assert_true(terminal >= 0 && dup2(terminal, STDERR_FILENO) >= 0);
    close(terminal);

    pthread_t reader, talkers[THREADS];
    static const char letters[THREADS + 1] = "abcdefgh";
    assert_int_equal(pthread_create(&reader, NULL, ReadAll, &master), 0);
    BeginProgress("frames", 1000);
    for (int i = 0; i < THREADS; ++i)
    {
        assert_int_equal(pthread_create(&talkers[i], NULL, Talk, (void*)(letters + i)), 0);
    }
    for (int i = 0; i < 1000; ++i)
    {
        UpdateProgress(i);
    }
    for (int i = 0; i < THREADS; ++i)
    {
        pthread_join(talkers[i], NULL);
    }
    EndProgress();
    dup2(old, STDERR_FILENO); // the last hold on the terminal: the reader's end
    close(old);
    void* text = NULL;
    pthread_join(reader, &text);
    close(master);
    return text;
}

static void MessagesOfManyThreadsArriveWhole(void** state)
{
    (void)state;
    const char* text = RecordTerminal();
    if (text == NULL)
    {
        print_message("skipped: this system gives no terminal\n");
        skip();
    }
    int counts[THREADS] = {0};
    for (const char* line = text; *line != 0;)
    {
        const char* end = strstr(line, "\r\n");
        if (end == NULL)
        {
            break;
        }
        // Bars are wiped by what follows them.
        const char* last = line;
        for (const char* wipe = line; (wipe = strstr(wipe, "\033[K")) != NULL && wipe < end; wipe += 3)
        {
            last = wipe + 3;
        }
        size_t size = (size_t)(end - last);
        if (size != LETTERS || strspn(last, (const char[]){*last, 0}) != LETTERS || *last < 'a' || *last > 'h')
        {
            fail_msg("\"%.*s\" is no whole message", (int)size, last);
        }
        counts[*last - 'a'] += 1;
        line = end + 2;
    }
    for (int i = 0; i < THREADS; ++i)
    {
        assert_int_equal(counts[i], MESSAGES);
    }
}

static void OnlyTextReachesTheTerminal(void** state)
{
    (void)state;
    static const char* const cases[][2] = {
        {"plain", "plain"},
        {"\033[31mred\007", "\\x1b[31mred\\x07"},
        {"two\nlines\r", "two\\x0alines\\x0d"},
        {"H\xc3\xb6he \xe2\x89\xa4 5 \xf0\x9f\x8c\x8a", "H\xc3\xb6he \xe2\x89\xa4 5 \xf0\x9f\x8c\x8a"},
        {"\xc2\x9b"
         "31m",
         "\\xc2\\x9b31m"}, // a control sequence in one character
        {"\xff\xc3", "\\xff\\xc3"},
        {"\xc0\xaf \xed\xa0\x80 \xf4\x90\x80\x80", "\\xc0\\xaf \\xed\\xa0\\x80 \\xf4\\x90\\x80\\x80"},
        {"\x7f", "\\x7f"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        char copy[100];
        assert_string_equal(CopyPrintable(copy, sizeof(copy), cases[i][0]), cases[i][1]);
    }
    char small[12];
    assert_string_equal(CopyPrintable(small, sizeof(small), "0123456789abc"), "01234567...");
    assert_string_equal(CopyPrintable(small, sizeof(small), "abcdef\033\033"), "abcdef...");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(MessagesOfManyThreadsArriveWhole),
        cmocka_unit_test(OnlyTextReachesTheTerminal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
