// SPDX-License-Identifier: MIT
#pragma once

// The host's log: warnings and errors go to stderr at once, and the latest messages stay for the panel. Any thread.

#include <pthread.h>

#include "seaway/base.h"

#define MAX_MESSAGES 64
#define MAX_MESSAGE_LENGTH 400

typedef struct Message
{
    swLogLevel level;
    char text[MAX_MESSAGE_LENGTH];
} Message;

typedef struct Messages
{
    pthread_mutex_t mutex;
    int count; // ever written; message i lies at i % MAX_MESSAGES
    Message lines[MAX_MESSAGES];
} Messages;

void OpenMessages(Messages* messages);
void CloseMessages(Messages* messages);

// Fits swHost::log; the context is a Messages.
void WriteMessage(void* context, swLogLevel level, const char* text);

// How many were ever written.
int CountMessages(Messages* messages);

// Copy the latest messages, oldest first. Returns how many.
int ReadMessages(Messages* messages, Message* lines, int capacity);
