// SPDX-License-Identifier: MIT
#include "progress.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <unistd.h>

#include "seconds.h"

#define BAR_WIDTH 32
#define REDRAW_SECONDS 0.1

// Messages come from the library's threads too: the bar and what is on the terminal belong to who holds the lock.
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static struct
{
    const char* label;
    int total;
    double startTime, drawTime;
    bool isActive, isShown;
} bar;

void BeginProgress(const char* label, int total)
{
    pthread_mutex_lock(&lock);
    bar.label = label;
    bar.total = total > 0 ? total : 1;
    bar.startTime = GetSeconds();
    bar.drawTime = bar.startTime + 1.0 - REDRAW_SECONDS; // nothing before a second is over
    bar.isActive = isatty(STDERR_FILENO) != 0;
    bar.isShown = false;
    pthread_mutex_unlock(&lock);
}

static void DrawBar(int done)
{
    double now = GetSeconds();
    if (!bar.isActive || now < bar.drawTime + REDRAW_SECONDS)
    {
        return;
    }
    bar.drawTime = now;
    bar.isShown = true;
    int filled = (int)((long long)done * BAR_WIDTH / bar.total);
    char text[BAR_WIDTH + 1];
    for (int i = 0; i < BAR_WIDTH; ++i)
    {
        text[i] = i < filled ? '#' : '.';
    }
    text[BAR_WIDTH] = 0;
    double remaining = done > 0 ? (now - bar.startTime) / done * (bar.total - done) : 0.0;
    fprintf(stderr, "\r\033[K[%s] %d/%d %s, %.0f s left", text, done, bar.total, bar.label, remaining);
    fflush(stderr);
}

void UpdateProgress(int done)
{
    pthread_mutex_lock(&lock);
    DrawBar(done);
    pthread_mutex_unlock(&lock);
}

static void WipeBar(void)
{
    if (bar.isShown)
    {
        fputs("\r\033[K", stderr);
        fflush(stderr);
        bar.isShown = false;
    }
}

void WriteTerminalLine(const char* line)
{
    pthread_mutex_lock(&lock);
    WipeBar();
    fprintf(stderr, "%s\n", line);
    pthread_mutex_unlock(&lock);
}

void EndProgress(void)
{
    pthread_mutex_lock(&lock);
    WipeBar();
    bar.isActive = false;
    pthread_mutex_unlock(&lock);
}
