#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Make scenes/data/harbour_storm.*: a buoy that never was, in the real-time layouts of the US National Data Buoy Center.

Three hours of a south-westerly wind sea that grows to 2.4 m and 8.3 s, over a north-westerly swell of 12 s. Each system
is a JONSWAP peak spread as cos^2s; at each frequency the energies and circular moments add up, as a buoy would see them,
with the scatter of an estimate of 100 degrees of freedom and a little noise that shortens them. Every number is worked out here; none was measured.

Usage: generators/make_sample_buoy.py [FOLDER]     default: scenes/data
"""
import cmath
import math
import os
import sys

# The frequencies of NDBC's 3 m buoys, Hz, and how it prints them.
FREQUENCIES = ([0.0325 + 0.005 * i for i in range(13)] + [0.10 + 0.01 * i for i in range(26)] +
               [0.365 + 0.02 * i for i in range(7)])
WIDTHS = [0.005] * 13 + [0.01] * 26 + [0.02] * 7

# Per record: time, then wind sea and swell as (Hs m, Tp s, bearing it comes from, gamma, spreading exponent at the peak).
RECORDS = [
    ("2024 11 16 04 50", (1.6, 6.9, 221.0, 3.3, 9.0), (1.0, 11.8, 301.0, 4.5, 40.0)),
    ("2024 11 16 05 50", (2.0, 7.6, 226.0, 3.3, 9.5), (1.1, 12.0, 299.0, 4.5, 42.0)),
    ("2024 11 16 06 50", (2.4, 8.3, 231.0, 3.3, 10.0), (1.1, 12.1, 298.0, 4.5, 42.0)),
]


def make_random(seed):
    """Sums of twelve uniform numbers, minus six: nearly normal, the same on every machine."""
    state = [seed]

    def uniform():
        state[0] = (state[0] * 6364136223846793005 + 1442695040888963407) % 2**64
        return (state[0] >> 11) / 2**53

    return lambda: sum(uniform() for _ in range(12)) - 6.0


def jonswap(f, peak, gamma):
    sigma = 0.07 if f <= peak else 0.09
    rise = math.exp(-0.5 * ((f - peak) / (sigma * peak)) ** 2)
    return f**-5 * math.exp(-1.25 * (peak / f) ** 4) * gamma**rise


def band_energy(index, peak, gamma):
    """Mean density in a band: narrow peaks need more than its centre."""
    low = FREQUENCIES[index] - 0.5 * WIDTHS[index]
    return sum(jonswap(low + (i + 0.5) / 20 * WIDTHS[index], peak, gamma) for i in range(20)) / 20


def make_record(wind_sea, swell, random):
    """Rows of E, alpha1, alpha2, r1, r2."""
    totals = [[0.0, 0j, 0j] for _ in FREQUENCIES]
    for height, period, bearing, gamma, exponent in (wind_sea, swell):
        energies = [band_energy(i, 1.0 / period, gamma) for i in range(len(FREQUENCIES))]
        scale = height**2 / 16.0 / sum(e * w for e, w in zip(energies, WIDTHS))
        for i, f in enumerate(FREQUENCIES):
            # Spreading is narrowest at the peak.
            away = f * period if f * period < 1.0 else 1.0 / (f * period)
            s = 1.0 + (exponent - 1.0) * away**2.0
            r1, r2 = s / (s + 1.0), s * (s - 1.0) / ((s + 1.0) * (s + 2.0))
            energy = energies[i] * scale
            totals[i][0] += energy
            totals[i][1] += energy * r1 * cmath.exp(1j * math.radians(bearing))
            totals[i][2] += energy * r2 * cmath.exp(2j * math.radians(bearing))
    rows = []
    for energy, first, second in totals:
        # 100 degrees of freedom: the estimate scatters by sqrt(2 / 100); directions by a degree or two.
        measured = energy * max(0.2, 1.0 + math.sqrt(2.0 / 100.0) * random())
        if round(measured, 3) == 0.0:
            rows.append((0.0, None, None, None, None))
            continue
        shift = 2.0 * random()
        alpha1 = math.degrees(cmath.phase(first)) + shift
        alpha2 = math.degrees(cmath.phase(second)) / 2.0 + shift + 0.6 * random()
        r1, r2 = 0.96 * abs(first) / energy, 0.9 * abs(second) / energy
        rows.append((measured, alpha1 % 360.0, alpha2 % 360.0, r1, r2))
    return rows


def write(path, heading, records, column, form, missing):
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(heading + "\n")
        for time, rows in reversed(records):  # newest first
            separation = " 0.117" if column == 0 else ""
            values = [(form % row[column] if row[column] is not None else missing) for row in rows]
            pairs = " ".join("%s (%.3f)" % (v, f + 1e-9) for v, f in zip(values, FREQUENCIES))
            file.write("%s%s %s\n" % (time, separation, pairs))


def summarize(time, rows, wind_sea, swell):
    """The line of a spectral wave summary: the whole sea by its spectrum, swell and wind sea by what they are made of."""
    zero = sum(row[0] * w for row, w in zip(rows, WIDTHS))
    two = sum(row[0] * w * f * f for row, w, f in zip(rows, WIDTHS, FREQUENCIES))
    peak = max(rows, key=lambda row: row[0])
    points = "N NNE NE ENE E ESE SE SSE S SSW SW WSW W WNW NW NNW".split()
    names = [points[round(bearing / 22.5) % 16] for bearing in (swell[2], wind_sea[2])]
    return "%s %4.1f %4.1f %4.1f %4.1f %4.1f %3s %3s %10s %4.1f %3.0f\n" % (
        time, 4.0 * math.sqrt(zero), swell[0], swell[1], wind_sea[0], wind_sea[1], *names, "N/A",
        math.sqrt(zero / two), peak[1])


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "..", "scenes", "data")
    random = make_random(20241116)
    records = [(time, make_record(wind_sea, swell, random)) for time, wind_sea, swell in RECORDS]
    stem = os.path.join(folder, "harbour_storm.")
    write(stem + "data_spec", "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) spec_3 (freq_3) ... >",
          records, 0, "%.3f", "999.000")
    names = {"swdir": ("alpha1", 1, "%.1f", "999.0"), "swdir2": ("alpha2", 2, "%.1f", "999.0"),
             "swr1": ("r1", 3, "%.2f", "999.00"), "swr2": ("r2", 4, "%.2f", "999.00")}
    for ending, (name, column, form, missing) in names.items():
        heading = "#YY  MM DD hh mm " + " ".join("%s_%d (freq_%d)" % (name, i, i) for i in (1, 2, 3)) + " ... >"
        write(stem + ending, heading, records, column, form, missing)
    with open(stem + "spec", "w", encoding="ascii", newline="\n") as file:
        file.write("#YY  MM DD hh mm WVHT  SwH  SwP  WWH  WWP SwD WWD  STEEPNESS  APD MWD\n"
                   "#yr  mo dy hr mn    m    m  sec    m  sec  -  degT     -      sec degT\n")
        for (time, rows), (_, wind_sea, swell) in zip(reversed(records), reversed(RECORDS)):
            file.write(summarize(time, rows, wind_sea, swell))


if __name__ == "__main__":
    main()
