#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Make scenes/data/whirlpool_east.asc and whirlpool_south.asc: the flow of a whirlpool, m/s, as two Esri ASCII grids.

It runs round and, away from the eye, more and more inwards: with d the distance from the middle over the radius, e the
eye's share of it, P the unit vector to the middle, T the one along the circle and c = 1 - (d - e) / (1 - e), the
velocity is SPEED c along 0.6 c T + 0.4 (1 - c) P. There is none in the eye and outside. Any flow map can be made like
this: write the numbers of a grid, row by row from the north, once for each direction.

Usage: generators/make_flow_maps.py [FOLDER]     default: scenes/data
"""
import math
import os
import sys

RADIUS = 40.0  # m
EYE = 1.0  # m
SPEED = 10.0  # m/s
SPACING = 2.0  # m
SIDE = 43  # cells; the outermost lie beyond the radius


def find_flow(x, z):
    """East and south, m/s, at metres from the middle."""
    distance = math.hypot(x, z)
    if distance <= EYE or distance >= RADIUS:
        return 0.0, 0.0
    inwards = (-x / distance, -z / distance)
    around = (-inwards[1], inwards[0])
    share = EYE / RADIUS
    c = 1.0 - (distance / RADIUS - share) / (1.0 - share)
    flow = [0.6 * c * around[i] + 0.4 * (1.0 - c) * inwards[i] for i in range(2)]
    length = math.hypot(*flow)
    return tuple(SPEED * c * part / length for part in flow)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "..", "scenes", "data")
    edge = -SPACING * (SIDE - 1) / 2
    for part, name in enumerate(("east", "south")):
        with open(os.path.join(folder, f"whirlpool_{name}.asc"), "w", encoding="ascii") as file:
            file.write(f"ncols {SIDE}\nnrows {SIDE}\nxllcenter {edge:g}\nyllcenter {edge:g}\ncellsize {SPACING:g}\n")
            for row in range(SIDE):
                flows = [find_flow(edge + SPACING * i, edge + SPACING * row)[part] for i in range(SIDE)]
                file.write(" ".join(f"{flow:.2f}" if abs(flow) >= 0.005 else "0" for flow in flows) + "\n")


if __name__ == "__main__":
    main()
