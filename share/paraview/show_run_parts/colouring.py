# SPDX-License-Identifier: BSD-3-Clause
"""Colours of bird and target by parts or by numbers, and their bars."""
import math

import numpy
from paraview import servermanager
from paraview import simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy

from .colours import DARK, MAP, part_colour, rgb
from .files import tell
from .pieces import leaves
from .views import points


def colour_by_parts(display, view, names):
    pv.ColorBy(display, ("POINTS", "part"))
    lut = pv.GetColorTransferFunction("part")
    lut.InterpretValuesAsCategories = 1
    lut.AnnotationsInitialized = 1
    lut.Annotations = [text for k, name in enumerate(names) for text in (str(k), name)]
    lut.IndexedColors = [c for k, name in enumerate(names) for c in part_colour(name, k)]
    show_bar(lut, view, "", display, len(names) > 1)


def colour_by_number(display, view, association, title, largest):
    if largest == 0:
        tell(f"{title.split(' [')[0]} is 0 in all frames")
    pv.ColorBy(display, (association, title))
    lut = pv.GetColorTransferFunction(title)
    lut.AutomaticRescaleRangeMode = "Never"
    lut.ColorSpace = "RGB"
    lut.RGBPoints = [x for k, code in enumerate(MAP) for x in [(largest or 1) * k / (len(MAP) - 1)] + rgb(code)]
    show_bar(lut, view, title if largest > 0 else title + ": 0 everywhere", display, True)
    bar = pv.GetScalarBar(lut, view)
    bar.UseCustomLabels = 1
    bar.CustomLabels = [largest * k / 5 for k in range(6)] if largest > 0 else [0]
    bar.AddRangeLabels = 0


def show_bar(lut, view, title, display, visible):
    bar = pv.GetScalarBar(lut, view)
    bar.Title = title
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = DARK
    bar.TitleFontSize, bar.LabelFontSize = points(16), points(14)
    bar.HorizontalTitle = 1
    bar.ScalarBarThickness = points(18)
    bar.ScalarBarLength = 0.4
    bar.TextPosition = "Ticks right/top, annotations left/bottom" if title else "Ticks left/bottom, annotations right/top"
    if title:
        bar.AutomaticLabelFormat = 0
        bar.LabelFormat = bar.RangeLabelFormat = "%.4g"
    bar.WindowLocation = "Any Location"
    bar.Position = [max(0.03, 0.0047 * len(title)), 0.53]
    display.SetScalarBarVisibility(view, visible)


def largest_over(source, association, title, times, share):
    """What a share of the values in some frames does not exceed, rounded up to a number that reads well; 0 if all are 0."""
    values, peaks = [0.0], [0.0]
    for time in times[::max(1, len(times) // 12)] + times[-1:]:
        source.UpdatePipeline(time)
        for leaf in leaves(servermanager.Fetch(source)):
            array = (leaf.GetPointData() if association == "POINTS" else leaf.GetCellData()).GetArray(title)
            if array and array.GetNumberOfTuples() > 0:
                numbers = vtk_to_numpy(array)
                numbers = numbers if numbers.ndim == 1 else numpy.linalg.norm(numbers, axis=1)
                numbers = numbers[numpy.isfinite(numbers)]
                if numbers.size > 0:
                    values.append(float(numpy.quantile(numbers, share)))
                    peaks.append(float(numbers.max()))
    largest = max(values) or max(peaks)
    return round_up(largest) if largest > 0 else 0


def round_up(value):
    power = 10.0 ** math.floor(math.log10(value))
    return next(step for step in (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 20) if step * power >= 0.9999 * value) * power
