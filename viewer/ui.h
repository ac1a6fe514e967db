// SPDX-License-Identifier: MIT
#pragma once

// The widgets of the panel, in C. ui_imgui.cpp makes them with Dear ImGui, ui_draw.c draws what it leaves.
// Widgets that change a value return whether the user changed it just now.

#include <stdbool.h>
#include <stdint.h>

#include "seaway/math.h"

#if defined(__GNUC__)
#define UI_PRINTF(text, arguments) __attribute__((format(printf, text, arguments)))
#else
#define UI_PRINTF(text, arguments)
#endif

struct GLFWwindow;

// Takes no events by itself; FeedUi() brings them.
bool OpenUi(struct GLFWwindow* window);
void CloseUi(void);

// Size of letters and spaces from the next frame on, as ui_scale.h chooses it; the nearest that there are letters for.
void SetUiScale(float scale);

// The window's units in a pixel of an ordinary screen.
float GetUiDensity(struct GLFWwindow* window);

// What a frame's widgets shall see, before BeginUiFrame().
struct InputEvent;
void FeedUi(struct GLFWwindow* window, const struct InputEvent* event);
void FeedUiFocus(struct GLFWwindow* window, bool isFocused);
void FeedUiEntry(struct GLFWwindow* window, bool isInside);

// Letters and shapes as 8-bit coverage; one texture serves every command.
const uint8_t* GetUiAtlas(int* width, int* height);

// Whether mouse or keys belong to a widget now.
bool HasUiMouse(void);
bool HasUiKeyboard(void);

void BeginUiFrame(void);

// One vertex: position in window units, place in the atlas, colour as sRGB bytes r, g, b, a.
typedef struct UiVertex
{
    float position[2];
    float uv[2];
    uint8_t color[4];
} UiVertex;

typedef struct UiCommand
{
    float clip[4]; // left, top, right, bottom, pixels
    uint32_t indexCount;
    uint32_t firstIndex;
    int32_t vertexOffset;
} UiCommand;

#define MAX_UI_COMMANDS 256

// Everything to draw this frame, in order.
typedef struct UiMesh
{
    float width, height; // of the window, window units
    uint32_t vertexCount;
    uint32_t indexCount;
    int commandCount;
    UiCommand commands[MAX_UI_COMMANDS];
} UiMesh;

void EndUiFrame(UiMesh* mesh);

// Fill arrays of as many vertices and indices as the last EndUiFrame() counted.
void CopyUiMesh(UiVertex* vertices, uint16_t* indices);

// A window at the left edge; draw its widgets between the two, also when the user folded it away.
void BeginUiPanel(const char* title);
void EndUiPanel(void);

// How far the panel reaches from the left edge, window units; 0 while it is folded. Of the last frame.
float GetUiPanelRight(void);

// A line over the picture, at the bottom.
void ShowUiNote(const char* text);

// A question over the picture with two answers. Returns 1 for yes, -1 for no, 0 while there is none.
int AskUiQuestion(const char* text, const char* yes, const char* no);

// A part of the panel that folds; draw its widgets if it returns true.
bool BeginUiSection(const char* label, bool isOpen);

// The same inside a section.
bool BeginUiGroup(const char* label, bool isOpen);

// Widgets between the two may have the same labels as others elsewhere.
void PushUiScope(int id);
void PopUiScope(void);

void UiText(const char* format, ...) UI_PRINTF(1, 2);
void UiWrapped(const char* format, ...) UI_PRINTF(1, 2);
void UiFaint(const char* format, ...) UI_PRINTF(1, 2);   // for notes; wraps
void UiWarning(const char* format, ...) UI_PRINTF(1, 2); // wraps
void UiMarked(const char* format, ...) UI_PRINTF(1, 2);  // in the colour of what has changed
void UiTip(const char* text);                            // shown when the mouse rests on the last widget
void UiSpace(void);
void UiSameLine(void);
bool UiButton(const char* label);
bool UiSmallButton(const char* label); // no higher than a line of text

// Before a widget: its value can be set back to a file's. A slot for a mark is kept behind it; the mark is there if the
// value is changed, with the tip that is given, and whoever clicks on it wants the file's value: UiWasReset(), after
// the widget.
void UiMarkNext(bool isChanged, const char* format, ...) UI_PRINTF(2, 3);
bool UiWasReset(void);

bool UiCheckbox(const char* label, bool* value);
bool UiSlider(const char* label, float* value, float low, float high, const char* format);
bool UiLogSlider(const char* label, float* value, float low, float high, const char* format);
bool UiSliderInt(const char* label, int* value, int low, int high, const char* format);
bool UiDoubleSlider(const char* label, double* value, double low, double high, const char* format);
bool UiColor(const char* label, swVec3* rgb);

// Name of item `index` for lists too long to spell out.
typedef const char* (*UiItemFcn)(void* context, int index);
bool UiChoice(const char* label, int* index, int count, UiItemFcn getName, void* context);

// Values in a ring of `count`, the oldest at `offset`, from 0 to `high`.
void UiGraph(const float* values, int count, int offset, float high);

// A bar as long as `fraction`, with a text beside it.
void UiBar(float fraction, const char* text);

// Columns keep their widths whatever their cells hold: so many letters, or (0) an even part of the rest.
typedef struct UiColumn
{
    const char* title;
    float letters;
} UiColumn;

bool BeginUiTable(const char* label, int columnCount, const UiColumn* columns);
void UiCell(const char* format, ...) UI_PRINTF(1, 2);
void UiLabelCell(const char* format, ...) UI_PRINTF(1, 2); // at the height of the widgets beside it

// The next widget fills the next cell; it needs a label of its own, which is not shown if it begins with "##".
void UiNextCell(void);
void EndUiTable(void);

// Rows of a table that may be long: only those that are seen are asked for, part by part until it returns false.
void BeginUiRows(int count);
bool StepUiRows(int* first, int* end);
