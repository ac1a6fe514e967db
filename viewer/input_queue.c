// SPDX-License-Identifier: MIT
#include "input_queue.h"

#include <string.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

static bool IsModifier(const InputEvent* event)
{
    return event->code >= GLFW_KEY_LEFT_SHIFT && event->code <= GLFW_KEY_RIGHT_SUPER;
}

// Keys that act, such as Enter or Ctrl with a letter, instead of writing a letter.
static bool IsCommand(const InputEvent* event)
{
    bool isLetter = event->code < GLFW_KEY_ESCAPE;
    bool isHeld = (event->modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0;
    return event->kind == INPUT_KEY && !IsModifier(event) && (!isLetter || isHeld);
}

// Whether `next` would be lost or misunderstood in the same frame as `before`.
static bool MustWait(const InputEvent* before, const InputEvent* next)
{
    if (next->kind == INPUT_WHEEL || before->kind == INPUT_WHEEL)
    {
        return false;
    }
    bool isSame = before->kind == next->kind && before->code == next->code && next->kind != INPUT_LETTER;
    bool hasActed = IsCommand(before) && before->action == GLFW_PRESS;
    switch (next->kind)
    {
    case INPUT_BUTTON: // a click may end the writing
        return isSame || before->kind == INPUT_LETTER || hasActed;
    case INPUT_LETTER: // a click or a key may begin or end it
        return before->kind == INPUT_BUTTON || hasActed;
    default:
        if (isSame && (IsCommand(before) || IsModifier(before)))
        {
            return true;
        }
        if (next->action == GLFW_RELEASE && !IsModifier(next))
        {
            return false;
        }
        return before->kind == INPUT_BUTTON || hasActed;
    }
}

void PushInput(InputQueue* queue, InputEvent event)
{
    if (queue->count < MAX_INPUT_EVENTS)
    {
        queue->events[queue->count++] = event;
    }
}

int TakeInput(InputQueue* queue, InputEvent* batch)
{
    int count = 0;
    for (bool mustWait = false; count < queue->count && !mustWait; count += !mustWait)
    {
        for (int i = 0; i < count && !mustWait; i++)
        {
            mustWait = MustWait(&batch[i], &queue->events[count]);
        }
        batch[count] = queue->events[count];
    }
    queue->count -= count;
    memmove(queue->events, queue->events + count, (size_t)queue->count * sizeof(InputEvent));
    return count;
}
