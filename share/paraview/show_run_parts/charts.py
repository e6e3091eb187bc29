# SPDX-License-Identifier: BSD-3-Clause
"""Charts of a run's histories.csv, with the time that the other views show."""
import inspect
import math
import os

from paraview import simple as pv

from .colours import LINES, part_colour, rgb
from .files import whole_rows
from .views import points

SCRIPT = """
import math
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk

{whole_rows}
with open({file!r}, newline="") as file:
    rows = whole_rows(file.read())
titles = rows[0]
for source, title, factor in {columns!r}:
    k = titles.index(source)
    values = numpy.array([float(row[k]) if row[k] else math.nan for row in rows[1:]])
    array = numpy_to_vtk(values * factor, deep=1)
    array.SetName(title)
    self.GetOutput().GetRowData().AddArray(array)
"""


NOW_STEPS = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
information = self.GetOutputInformation(0)
times = {times!r}
information.Set(Pipeline.TIME_STEPS(), times, len(times))
information.Set(Pipeline.TIME_RANGE(), [times[0], times[-1]], 2)
"""
NOW = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
information = self.GetOutputInformation(0)
now = information.Get(Pipeline.UPDATE_TIME_STEP()) if information.Has(Pipeline.UPDATE_TIME_STEP()) else {first!r}
for name, values in (("time", [1e3 * now, 1e3 * now]), ("now", {ends!r})):
    array = vtkDoubleArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    self.GetOutput().GetRowData().AddArray(array)
"""


def mark_time(view, times, lowest, highest):
    """A vertical line at the time that the other views show."""
    source = pv.ProgrammableSource(registrationName="now", OutputDataSetType="vtkTable")
    source.ScriptRequestInformation = NOW_STEPS.format(times=times)
    source.Script = NOW.format(first=times[0], ends=[lowest, highest])
    pv.SetActiveSource(None)
    display = pv.Show(source, view)
    display.UseIndexForXAxis = 0
    display.XArrayName = "time"
    display.SeriesVisibility = ["now"]
    display.SeriesLabel = ["now", "now"]
    display.SeriesColor = ["now", "0.5", "0.5", "0.5"]
    display.SeriesLineStyle = ["now", "2"]


def chart(file, title, y_title, lines):
    """A line chart; lines are (column, factor, label, colour)."""
    columns = [("time[s]", "time", 1e3)] + [(column, label, factor) for column, factor, label, _ in lines]
    source = pv.ProgrammableSource(registrationName=title, OutputDataSetType="vtkTable")
    source.Script = SCRIPT.format(whole_rows=inspect.getsource(whole_rows), file=file, columns=columns)
    pv.SetActiveSource(None)  # else ParaView's panel of it sets the lines that are shown
    view = pv.CreateView("XYChartView")
    view.ChartTitle = title
    view.ChartTitleFontSize = points(16)
    view.ChartTitleBold = 0
    view.LeftAxisTitle, view.BottomAxisTitle = y_title, "time [ms]"
    for axis in ("Left", "Bottom"):
        setattr(view, axis + "AxisTitleFontSize", points(15))
        setattr(view, axis + "AxisTitleBold", 0)
        setattr(view, axis + "AxisLabelFontSize", points(13))
    view.LegendFontSize = points(13)
    view.LegendLocation = "TopRight"
    view.ShowLegend = 1 if len(lines) > 1 else 0
    display = pv.Show(source, view)
    display.UseIndexForXAxis = 0
    display.XArrayName = "time"
    labels = [label for _, _, label, _ in lines]
    display.SeriesVisibility = labels
    display.SeriesLabel = [x for label in labels for x in (label, label)]
    display.SeriesColor = [x for _, _, label, colour in lines for x in [label] + [str(c) for c in colour]]
    display.SeriesLineThickness = [x for label in labels for x in (label, "2")]
    return view


def pressure_lines(histories, names):
    lines = []
    for column in histories:
        if column.startswith("max_pressure_") and column.endswith("[Pa]"):
            name = column[len("max_pressure_"):-len("[Pa]")]
            if name == "all" and len(names) > 0:
                continue  # the largest of the others
            number = names.index(name) if name in names else len(lines)
            lines.append((column, 1e-6, name, part_colour(name, number)))
    return lines


def charts(folder, histories, names, times):
    file = os.path.join(folder, "histories.csv")
    wanted = []  # title, title of y, lines
    lines = pressure_lines(histories, names)
    if lines:
        wanted.append(("Largest pressure of each part", "pressure [MPa]", lines))
    moves = [c for c in histories if c == "max_deflection[m]" or c.startswith("deflection_")]
    moves = [c for c in moves if any(v != 0 for v in histories[c])]
    if moves:
        wanted.append(("Deflection of the target", "deflection [mm]",
                       [(c, 1e3, c.split("[")[0].replace("max_deflection", "largest").replace("deflection_", ""),
                         rgb(LINES[k % len(LINES)])) for k, c in enumerate(moves)]))
    if "contact_force_x[N]" in histories:
        wanted.append(("Contact force along the flight", "force [kN]",
                       [("contact_force_x[N]", 1e-3, "force", rgb(LINES[0]))]))
    ends = []
    for _, _, lines in wanted:
        values = [factor * v for column, factor, _, _ in lines for v in histories[column] if math.isfinite(v)]
        ends.append((min([0.0] + values), max([0.0] + values)))
    made = []
    for (title, y_title, lines), (lowest, highest) in zip(wanted, ends):
        view = chart(file, title, y_title, lines)
        mark_time(view, times, lowest, highest)
        made.append(view)
    return made


def side_by_side(layout, place, views):
    """Puts views into a cell of a layout, each as wide as the others."""
    for k, view in enumerate(views[:-1]):
        left = layout.SplitHorizontal(place, 1 / (len(views) - k))
        layout.AssignView(left, view)
        place = left + 1
    layout.AssignView(place, views[-1])
