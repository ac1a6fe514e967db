// SPDX-License-Identifier: MIT
#pragma once

// A bar on the terminal for what takes longer than a second. Nothing is written where stderr is no terminal.

// `label` says what is counted: "frames". Only one bar at a time.
void BeginProgress(const char* label, int total);
void UpdateProgress(int done);
void EndProgress(void);

// Wipe the bar before a message; the next update draws it again.
void HideProgress(void);
