// SPDX-License-Identifier: MIT
#pragma once

// The parts of the panel, each with the settings of one subject.

#include "app.h"
#include "tuned.h"

void DrawPanels(App* app);

void DrawTimePanel(App* app);
void DrawSeaPanel(App* app);
void DrawSkyPanel(App* app);
void DrawViewPanel(App* app);
void DrawInputPanel(App* app);
void DrawLayerPanel(App* app);
void DrawTimingPanel(App* app);
void DrawMessagePanel(App* app);
void DrawKeyPanel(void);

// Of one wave system; each returns whether its def has changed. `filed` is the file's, NULL if the file has none.
bool DrawFormula(swSpectrumDef* spectrum, const swSpectrumDef* filed);
bool DrawEqualiser(swSpectrumDef* spectrum, const swSpectrumDef* filed);
bool DrawMethod(swWaveSystemDef* def, const swWaveSystemDef* filed);
bool DrawMeasured(Sea* sea, int index);
bool DrawHandWaves(App* app, int index);

const char* GetKindName(void* context, int index);

// "YYYY-MM-DD hh:mm" of seconds since 1970, UTC.
void WriteUtc(double seconds, char text[20]);
