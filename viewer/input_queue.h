// SPDX-License-Identifier: MIT
#pragma once

// What the user pressed since the last frame, in order, handed out so that a frame of any length sees all of it. The
// panel looks at keys and buttons once a frame: one that goes down and up between two slow frames would never have been
// pressed, and a typed value would wait for an Enter that was already given. So a release waits for the next frame, and
// so does everything that would be understood differently without what came before it.

#include <stdbool.h>

typedef enum InputKind
{
    INPUT_KEY,
    INPUT_LETTER,
    INPUT_BUTTON,
    INPUT_WHEEL
} InputKind;

// Codes, actions and modifiers are GLFW's.
typedef struct InputEvent
{
    InputKind kind;
    int code; // key, code point or mouse button
    int scancode;
    int action;
    int modifiers;
    double x, y; // of a button where the cursor was, of the wheel its clicks
} InputEvent;

// Nobody presses more between two frames; what comes beyond is dropped.
#define MAX_INPUT_EVENTS 256

typedef struct InputQueue
{
    InputEvent events[MAX_INPUT_EVENTS];
    int count;
} InputQueue;

void PushInput(InputQueue* queue, InputEvent event);

// Take the events of one frame out of the queue; `batch` has room for MAX_INPUT_EVENTS. Returns their number.
int TakeInput(InputQueue* queue, InputEvent* batch);
