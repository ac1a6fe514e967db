// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "field.h"

/// @file
/// Tides as sums of constituents, harmonics with the speeds of the moon's and the sun's motions [Schureman 1958]. An
/// input of the level or of the flow may have them, see swInputDef::tide: a level that rises and falls, or tidal
/// streams, whose velocity goes around an ellipse for each constituent. They are a function of the world's time.
/// Tables of levels are read by swGetTideOfTable().
///
///     swInputDef tide = swDefaultInputDef(); // everywhere
///     tide.field = SW_INPUT_LEVEL;
///     tide.blend = SW_BLEND_ADD;
///     swSetTideConstituent("M2", 2.1f, 1.2f, &tide.tide[0]);
///     swSetTideConstituent("S2", 0.7f, 1.9f, &tide.tide[1]);

/// Constituents that an input can have.
#define SW_MAX_TIDE 12

/// amplitude * cos(speed * time - phase), and for a flow's z likewise with the other two.
typedef struct swTideConstituent
{
    /// rad/s. Range [0, 1]. Default 0: none.
    float speed;

    /// Of a level, m, or of a flow along x, m/s. Range [-100, 100]. Default 0.
    float amplitude;

    /// By which it lags behind the world's time 0, radians. Range [-1000, 1000]. Default 0.
    float phase;

    /// Of a flow along z, m/s: with a phase a quarter turn away an ellipse, with the same one to and fro along a line.
    /// Range [-100, 100]. Default 0.
    float amplitudeAcross;

    /// Likewise, radians. Range [-1000, 1000]. Default 0.
    float phaseAcross;
} swTideConstituent;

SW_API const swFields* swGetTideFields(void);

/// Speed of a constituent by its name, such as "M2" or "K1", rad/s; 0 for a name that is not known. A tidal day's and
/// half day's, the shallow water's and those of long periods are there: Q1 O1 P1 S1 K1 J1 OO1, 2N2 MU2 N2 NU2 M2 L2 T2
/// S2 K2, M3 MN4 M4 MS4 S4 M6 M8, MF MM SSA SA.
SW_API float swGetTideSpeed(const char* name);

/// Names of all that are known, in ascending speeds within each kind; NULL beyond the last.
SW_API const char* swGetTideName(int index);

/// Make a constituent of a level, or of a flow along x, by name.
/// @return false for a name that is not known; the constituent is 0 then
SW_API bool swSetTideConstituent(const char* name, float amplitude, float phase, swTideConstituent* constituent);

/// What constituents add up to at a time, s: of a level x, of a flow x and z. Without constituents both are 0.
SW_API void swGetTide(int count, const swTideConstituent* constituents, double time, float* x, float* z);

/// A height of the water at a time: a line of a tide table, or of what a gauge measured.
typedef struct swTideLevel
{
    double time; ///< s
    float level; ///< m, or whatever the host's table has
} swTideLevel;

/// What a table says at a time, for swInput_SetValue() or swWaterBody_SetLevel() before each step. Between two lines
/// the level runs along a cubic that neither leaves their range nor bends at them [Steffen 1990], so that the high and
/// low waters of a table stay its highest and lowest. Between a high and a low water that is within 0.01 of their
/// difference of the half cosine by which tide tables are read. Before the first and after the last line the level
/// stands, and it sets out from there and arrives there gently: give a line more at either end.
/// @param table [count] at least one line; times ascend
/// @return NaN where a line or the time is not finite, or the two lines around the time do not ascend
SW_API float swGetTideOfTable(int count, const swTideLevel* table, double time);
