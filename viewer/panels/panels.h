// SPDX-License-Identifier: MIT
#pragma once

// The parts of the panel, each with the settings of one subject.

#include "app.h"

void DrawPanels(App* app);

void DrawSeaPanel(App* app);
void DrawSkyPanel(App* app);
void DrawViewPanel(App* app);
void DrawTimingPanel(App* app);
void DrawMessagePanel(App* app);
void DrawKeyPanel(void);

// Angles in the panel are whole degrees of a compass.
float ToDegrees(float radians);
float ToRadians(float degrees);
