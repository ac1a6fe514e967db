// SPDX-License-Identifier: MIT
#pragma once

// A bar on the terminal for what takes longer than a second. Nothing is written where stderr is no terminal.

// `label` says what is counted: "frames". Only one bar at a time.
void BeginProgress(const char* label, int total);
void UpdateProgress(int done);
void EndProgress(void);

// Write a line to stderr, in front of which the bar is wiped; the next update draws it again. Any thread.
void WriteTerminalLine(const char* line);
