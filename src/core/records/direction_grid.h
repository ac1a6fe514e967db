// SPDX-License-Identifier: MIT
#pragma once

// Directions as a file has them, and the equally spaced ones of a table.

#include <stdbool.h>

#define SW_GRID_MAX_DIRECTIONS 720

typedef struct swDirectionNode
{
    double angle; // radians, in [0, 2 pi)
    int column;   // of the file
    int share;    // how many columns have this angle, this one and the following
} swDirectionNode;

typedef struct swDirectionGrid
{
    int columnCount; // of the file
    int nodeCount;   // different angles
    // The file's columns, by ascending angle.
    swDirectionNode nodes[SW_GRID_MAX_DIRECTIONS];

    // Of the table.
    int count;
    double first;   // radians
    bool isRegular; // then node i is the table's column i
    bool isSector;  // the file's directions do not go round: nothing comes from the gap behind the last node
    int lastNode;   // before the gap
} swDirectionGrid;

// `count` in [1, SW_GRID_MAX_DIRECTIONS]. False if fewer than three different directions remain.
bool swMakeDirectionGrid(const double* angles, int count, swDirectionGrid* grid);

// One frequency's densities, [columnCount] by the file's columns, to [grid->count] of the table.
void swSpreadOnGrid(const swDirectionGrid* grid, const double* density, double* table);
