# SPDX-License-Identifier: BSD-3-Clause
"""Colours of show_run.py: those of the program's pictures, which people with colour-blindness can tell apart."""

# Colours of parts and the map of pressures, as in vtkio/palette.cpp.
PART_COLOURS = [("head", "0072b2"), ("neck", "56b4e9"), ("torso", "cf8f3c"), ("body", "cf8f3c"), ("bone", "009e73"),
                ("spine", "009e73"), ("wing", "8a8a8a"), ("lung", "c8281e"), ("leg", "cc79a7"), ("beak", "c99700")]
OTHER_COLOURS = ["d55e00", "cc79a7", "c99700", "56b4e9", "009e73", "0072b2"]
MAP = ["440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80", "5ec962", "addc30", "fde725"]
LINES = ["0072b2", "d55e00", "009e73", "e69f00", "cc79a7", "56b4e9"]
PLAIN_TARGET = [0.93, 0.94, 0.96]
DARK = [0.15, 0.15, 0.15]


def rgb(code):
    return [int(code[k:k + 2], 16) / 255 for k in (0, 2, 4)]


def part_colour(name, number):
    for role, code in PART_COLOURS:
        if role in name:
            return rgb(code)
    return rgb(OTHER_COLOURS[number % len(OTHER_COLOURS)])
