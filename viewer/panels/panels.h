// SPDX-License-Identifier: MIT
#pragma once

// The parts of the panel, each with the settings of one subject.

#include "app.h"

void DrawPanels(App* app);

void DrawTimePanel(App* app);
void DrawSeaPanel(App* app);
void DrawSkyPanel(App* app);
void DrawViewPanel(App* app);
void DrawTimingPanel(App* app);
void DrawMessagePanel(App* app);
void DrawKeyPanel(void);

// What all spectra share, and the equaliser. Return whether something changed.
bool DrawFormula(swSpectrumDef* spectrum);
bool DrawEqualiser(swSpectrumDef* spectrum);

// How the waves are made, and waves by hand.
bool DrawMethod(swWaveSystemDef* def);
bool DrawComponents(SeaWaves* waves);

// Where waves come from, degrees clockwise from north, of a direction they go.
float ToBearing(float direction);

// "YYYY-MM-DD hh:mm" of seconds since 1970, UTC.
void WriteUtc(double seconds, char text[20]);

// Angles in the panel are whole degrees of a compass.
float ToDegrees(float radians);
float ToRadians(float degrees);
