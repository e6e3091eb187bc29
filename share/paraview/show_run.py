# SPDX-License-Identifier: BSD-3-Clause
"""A run of BirdStrike in ParaView: the bird, the target and the histories side by side.

In ParaView: open run.pvd and press Apply, then File > Load State, this file. Or say which run in the next line, or in the
environment variable BIRDSTRIKE_RUN. Without ParaView's window, for pictures and films:

    share/paraview/pvbatch share/paraview/show_run.py RUN --save picture.png      (RUN: the folder of a run, or its run.pvd)
"""
RUN = ""

import argparse
import csv
import glob
import math
import os
import sys
from builtins import abs, all, any, max, min, sum  # a chart's script leaves numpy's in their places, see main

import numpy
import paraview
from paraview import servermanager
from paraview import simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy

# Colours of parts and the map of pressures, as in vtkio/palette.cpp: people with colour-blindness can tell them apart.
PART_COLOURS = [("head", "0072b2"), ("neck", "56b4e9"), ("torso", "cf8f3c"), ("body", "cf8f3c"), ("bone", "009e73"),
                ("spine", "009e73"), ("wing", "8a8a8a"), ("lung", "c8281e"), ("leg", "cc79a7"), ("beak", "f0e442")]
OTHER_COLOURS = ["e69f00", "cc79a7", "f0e442", "56b4e9", "009e73", "0072b2"]
MAP = ["440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80", "5ec962", "addc30", "fde725"]
LINES = ["0072b2", "d55e00", "009e73", "e69f00", "cc79a7", "56b4e9"]
BALL = 0.62  # radius of a ball of a particle's volume, in spacings
DARK = [0.15, 0.15, 0.15]
scale = 1  # of texts: 1 for a picture 1080 pixels high


def rgb(code):
    return [int(code[k:k + 2], 16) / 255 for k in (0, 2, 4)]


def part_colour(name, number):
    for role, code in PART_COLOURS:
        if role in name:
            return rgb(code)
    return rgb(OTHER_COLOURS[number % len(OTHER_COLOURS)])


def points(size):
    size = int(scale * size + 0.5)
    return size if size > 6 else 6  # max may be numpy's here, see main


def written(what, file):
    """ParaView says nothing in the exit status if a file cannot be written."""
    stem, ending = os.path.splitext(file)  # a film of pictures has their numbers between the two
    if not [one for one in glob.glob(glob.escape(stem) + "*" + ending) if os.path.getsize(one)]:
        fail(f"{file} could not be written; is its folder there, and may you write in it?")
    print(what, file)


def fail(text):
    if paraview.fromGUI:
        raise RuntimeError(text)
    sys.exit("show_run.py: " + text)


# ---- what to show ----------------------------------------------------------------------------------------------------


def options():
    parser = argparse.ArgumentParser(prog="show_run.py", description="A run of BirdStrike in ParaView: bird, target and "
                                     "histories side by side.", allow_abbrev=False)
    parser.add_argument("run", nargs="?", default=RUN or os.environ.get("BIRDSTRIKE_RUN", ""),
                        help="folder of a run, or its run.pvd or run.bss")
    parser.add_argument("--colour", default="part", help="array of the bird: part (default), pressure, mean_pressure, "
                        "velocity ...")
    parser.add_argument("--target", default="", help="array of the target: contact_pressure (default of a rigid one), "
                        "displacement (default of the others), plastic_strain ...")
    parser.add_argument("--skin", action="store_true", help="the bird's skin in place of balls; needs the plugin")
    parser.add_argument("--organs", action="store_true", help="a skin for each part, see-through but for bones and lungs; "
                        "needs the plugin")
    parser.add_argument("--whole", action="store_true", help="the whole bird; otherwise only the half behind its middle is "
                        "shown where it is coloured by numbers, since the pressure at a free surface is zero")
    parser.add_argument("--plugin", default="", help="BirdStrike.so to load first, see share/paraview/build-plugin")
    parser.add_argument("--time", type=float, help="seconds; default: the middle of the impact")
    parser.add_argument("--save", default="", metavar="FILE.png", help="save a picture")
    parser.add_argument("--film", default="", metavar="FILE", help="save a film: .avi, .ogv, or .png for single pictures")
    parser.add_argument("--size", default="1920x1080", help="of picture and film, default 1920x1080")
    if paraview.fromGUI:
        return parser.parse_args([])
    return parser.parse_args()


def find_series(run):
    """The series of what the user said, run.pvd or run.bss; None if nothing was said."""
    if not run:
        return None
    names = [os.path.join(run, name) for name in ("run.pvd", "run.bss")] if os.path.isdir(run) else [run]
    for file in names:
        if os.path.isfile(file):
            return os.path.abspath(file)
    fail(f"{' and '.join(names)} do{'' if len(names) > 1 else 'es'} not exist; name the folder of a run, or its run.pvd")


def open_run(run):
    """The reader of the run, and the folder that it lies in."""
    file = find_series(run)
    if file:
        name = os.path.basename(os.path.dirname(file)) or "run"
        if file.endswith(".bss"):
            read = getattr(pv, "BirdStrikePackedSeries", None)
            if read is None:
                fail(f"{file} needs the plugin: share/paraview/build-plugin builds it, --plugin names it; or "
                     "'birdstrike series' makes a run.pvd of it")
            reader = read(registrationName=name, FileName=file)
        else:
            reader = pv.PVDReader(registrationName=name, FileName=file)
    else:
        candidates = [pv.GetActiveSource()] + list(pv.GetSources().values())
        readers = [one for one in candidates
                   if one is not None and one.GetXMLName() in ("PVDReader", "BirdStrikePackedSeries")]
        if not readers:
            fail("which run? Open its run.pvd first, write its folder into the line RUN of this file, or set the "
                 "environment variable BIRDSTRIKE_RUN" if paraview.fromGUI else
                 "which run? Name its folder, or its run.pvd")
        reader = readers[0]
        file = str(reader.FileName)
    reader.UpdatePipelineInformation()
    return reader, os.path.dirname(file)


def table(folder, name):
    """Columns of a CSV file as lists of numbers; {} if there is none."""
    try:
        with open(os.path.join(folder, name), newline="") as file:
            rows = list(csv.reader(file))
    except OSError:
        return {}
    columns = {}
    for k, title in enumerate(rows[0] if rows else []):
        try:
            columns[title] = [float(row[k]) if row[k] else math.nan for row in rows[1:] if len(row) > k]
        except ValueError:
            pass  # a column of words
    return columns


def time_of_interest(times, histories, share):
    """The frame nearest to when a share of the impulse has been given; the middle one of a run without."""
    impulse = [abs(value) for value in histories.get("impulse_x[N s]", [])]
    if not impulse or max(impulse) == 0:
        return times[len(times) // 2]
    enough = share * max(impulse)
    row = next(k for k, value in enumerate(impulse) if value >= enough)
    return min(times, key=lambda t: abs(t - histories["time[s]"][row]))


# ---- bird and target -------------------------------------------------------------------------------------------------


class Piece:
    """A block of the run as a pipeline item, with what is known of it."""

    def __init__(self, source, time):
        self.source = source
        source.UpdatePipeline(time)
        self.information = source.GetDataInformation().DataInformation

    def arrays(self, association):
        attributes = self.information.GetAttributeInformation(association)
        return [attributes.GetArrayInformation(k) for k in range(attributes.GetNumberOfArrays())]

    def find(self, name):
        """('POINTS' or 'CELLS', components) of an array, or None."""
        for association, word in ((0, "POINTS"), (1, "CELLS")):
            for array in self.arrays(association):
                if array.GetName() == name:
                    return word, array.GetNumberOfComponents()
        return None

    def field(self, name, default):
        array = self.information.GetFieldDataInformation().GetArrayInformation(name)
        return array.GetComponentRange(0)[0] if array else default

    def bounds(self):
        return self.source.GetDataInformation().GetBounds()

    def most(self):
        """Bounds without the few points that have flown far."""
        clouds = [vtk_to_numpy(leaf.GetPoints().GetData()) for leaf in leaves(servermanager.Fetch(self.source))
                  if leaf.GetNumberOfPoints() > 0]
        if not clouds:
            return self.bounds()
        ends = numpy.nanquantile(numpy.concatenate(clouds), [0.01, 0.99], axis=0)
        return common(self.bounds(), grown(ends.T.ravel().tolist(), 0.25))


def pieces(reader, time):
    """Bird and target; the target may be None."""
    reader.UpdatePipeline(time)
    if not reader.GetDataInformation().GetCompositeDataClassName():
        return Piece(reader, time), None
    assembly = reader.GetDataInformation().GetHierarchy()
    names = [assembly.GetAttributeOrDefault(node, "label", assembly.GetNodeName(node))
             for node in assembly.GetChildNodes(assembly.GetRootNode(), False)]

    def block(name):
        if name not in names:
            return None
        return Piece(pv.ExtractBlock(registrationName=name, Input=reader, Selectors=["//" + name]), time)

    bird = block("bird")
    if bird is None:
        fail("the run has no block 'bird'; was it written by BirdStrike?")
    return bird, block("target")


def part_names(bird):
    for leaf in leaves(servermanager.Fetch(bird.source)):
        names = leaf.GetFieldData().GetAbstractArray("part_names")
        if names:
            return [names.GetValue(k) for k in range(names.GetNumberOfValues())]
    return []


UNITS = {"pressure": ("MPa", 1e-6), "mean_pressure": ("MPa", 1e-6), "contact_pressure": ("MPa", 1e-6),
         "peak_contact_pressure": ("MPa", 1e-6), "von_mises": ("MPa", 1e-6), "displacement": ("mm", 1e3),
         "velocity": ("m/s", 1), "density": ("kg/m3", 1), "internal_energy": ("J/kg", 1), "contact_impulse": ("N s", 1)}
NAMES = {"displacement": "deflection", "plastic_strain": "plastic strain"}


def scaled(piece, name):
    """A pipeline item with the array in a handy unit: it, the array's new name, association, components."""
    found = piece.find(name)
    if not found:
        fail(f"there is no array '{name}' to colour by; there are " +
             ", ".join(sorted({a.GetName() for k in (0, 1) for a in piece.arrays(k)})))
    unit, factor = UNITS.get(name, ("", 1))
    title = NAMES.get(name, name.replace("_", " ")) + (f" [{unit}]" if unit else "")
    if factor == 1 and title == name:
        return piece.source, name, found[0]
    item = pv.Calculator(registrationName=title, Input=piece.source, ResultArrayName=title,
                         AttributeType="Cell Data" if found[0] == "CELLS" else "Point Data",
                         Function=("mag(%s)*%g" if found[1] == 3 else "%s*%g") % (name, factor))
    return item, title, found[0]


def colour_by_parts(display, view, names):
    pv.ColorBy(display, ("POINTS", "part"))
    lut = pv.GetColorTransferFunction("part")
    lut.InterpretValuesAsCategories = 1
    lut.AnnotationsInitialized = 1
    lut.Annotations = [text for k, name in enumerate(names) for text in (str(k), name)]
    lut.IndexedColors = [c for k, name in enumerate(names) for c in part_colour(name, k)]
    show_bar(lut, view, "", display, len(names) > 1)


def colour_by_number(display, view, association, title, largest):
    pv.ColorBy(display, (association, title))
    lut = pv.GetColorTransferFunction(title)
    lut.AutomaticRescaleRangeMode = "Never"
    lut.ColorSpace = "RGB"
    lut.RGBPoints = [x for k, code in enumerate(MAP) for x in [largest * k / (len(MAP) - 1)] + rgb(code)]
    show_bar(lut, view, title, display, True)
    bar = pv.GetScalarBar(lut, view)
    bar.UseCustomLabels = 1
    bar.CustomLabels = [largest * k / 5 for k in range(6)]
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
    """What a share of the values in some frames does not exceed, rounded up to a number that reads well."""
    values = [0.0]
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
    return round_up(max(values)) if max(values) > 0 else 1


def leaves(data):
    if data is None or not data.IsA("vtkCompositeDataSet"):
        return [] if data is None else [data]
    iterator = data.NewIterator()
    found = []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def round_up(value):
    power = 10.0 ** math.floor(math.log10(value))
    return next(step for step in (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 20) if step * power >= 0.9999 * value) * power


def show_bird(bird, view, args, names, times):
    item, title, association = bird.source, "part", "POINTS"
    if args.colour != "part":
        item, title, association = scaled(bird, args.colour)
    if args.colour != "part" and not args.whole:
        middle = (bird.bounds()[2] + bird.bounds()[3]) / 2
        item = pv.Clip(registrationName="cut", Input=item, ClipType="Plane", Invert=0)
        item.ClipType.Origin, item.ClipType.Normal = [0, middle, 0], [0, 1, 0]
        item.UpdatePipeline(times[0])
    skin = args.skin or args.organs
    if skin:
        make = getattr(pv, "BirdSurface", None)
        if make is None:
            fail("the skin needs the plugin: share/paraview/build-plugin builds it, --plugin names it")
        item = make(registrationName="skin", Input=item)
        item.SMProxy.GetProperty("SurfacePerPart").SetElement(0, 1 if args.organs else 0)
        item.SMProxy.UpdateVTKObjects()
        item.UpdatePipeline(times[0])
    display = pv.Show(item, view)
    if skin:
        display.Representation = "Surface"
        display.Specular = 0.2
    else:
        display.Representation = "Point Gaussian"
        display.ShaderPreset = "Sphere"
        display.GaussianRadius = BALL * bird.field("spacing", guessed_spacing(bird))
    if args.organs:
        see_through(display, item, view)
    if args.colour == "part" and bird.find("part") and names:
        colour_by_parts(display, view, names)
    elif args.colour != "part":
        # Single particles have far higher pressures than the others: they share the brightest colour.
        colour_by_number(display, view, association, title, largest_over(item, association, title, times, 0.995))
    else:
        display.ColorArrayName = ["POINTS", ""]
        display.DiffuseColor = display.AmbientColor = part_colour("body", 0)


def see_through(display, skin, view):
    """Of the blocks of a skin all but the inner parts."""
    blocks = skin.GetDataInformation().GetHierarchy()
    for node in blocks.GetChildNodes(blocks.GetRootNode(), False):
        name = blocks.GetAttributeOrDefault(node, "label", blocks.GetNodeName(node))
        if not any(role in name for role in ("bone", "spine", "rib", "lung")):
            display.BlockOpacities = list(display.BlockOpacities) + ["/Root/" + blocks.GetNodeName(node), "0.25"]
    if not paraview.fromGUI:  # with samples, software rendering shows nothing see-through
        view.SMProxy.GetClientSideObject().GetRenderWindow().SetMultiSamples(0)
        view.UseFXAA = 1


def guessed_spacing(bird):
    low, high = bird.bounds()[0::2], bird.bounds()[1::2]
    count = max(1, bird.source.GetDataInformation().GetNumberOfPoints())
    return (math.prod(max(b - a, 1e-6) for a, b in zip(low, high)) / count) ** (1 / 3)


def show_target_plain(target, view):
    display = pv.Show(target.source, view)
    display.Representation = "Surface With Edges"
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = [0.84, 0.87, 0.90]
    display.Ambient, display.Diffuse = 0.35, 0.65
    display.EdgeColor = [0.74, 0.77, 0.80]
    display.LineWidth = 0.3


def default_target_array(target, bends):
    for name in (["displacement"] if bends else []) + ["contact_pressure", "displacement"]:
        if target.find(name):
            return name
    fail("the target has neither 'contact_pressure' nor 'displacement'")


def show_target(target, view, args, times, bends):
    item, title, association = scaled(target, args.target or default_target_array(target, bends))
    display = pv.Show(item, view)
    display.Representation = "Surface With Edges"
    display.EdgeColor = [0.45, 0.45, 0.45]
    display.LineWidth = 0.3
    display.Ambient, display.Diffuse = 1, 0  # unlit: the colours are those of the bar
    colour_by_number(display, view, association, title, largest_over(item, association, title, times, 1))
    return title


# ---- views -----------------------------------------------------------------------------------------------------------


def render_view(title, reader, time):
    view = pv.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesLabelColor = DARK
    view.CenterAxesVisibility = 0
    view.ViewTime = time
    words = pv.Text(registrationName=title, Text=title)
    style(pv.Show(words, view), 20, "Upper Center")
    return view


def style(text, size, place):
    text.Color = DARK
    text.FontSize = points(size)
    text.WindowLocation = place
    text.FontFamily = "Arial"


def show_time(reader, view):
    stamp = pv.AnnotateTimeFilter(registrationName="time", Input=reader)
    stamp.Scale = 1000
    stamp.Format = "t = {time:.2f} ms"
    style(pv.Show(stamp, view), 18, "Lower Center")


def look(view, bounds, direction, up, aspect, margin=1.15, room=0.2):
    """Parallel view along a direction that just holds a box, beside some room for the colour bar."""
    def unit(v):
        length = math.sqrt(sum(x * x for x in v))
        return [x / length for x in v]

    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    forward = unit(direction)
    right = unit(cross(forward, up))
    upward = cross(right, forward)
    middle = [(bounds[2 * k] + bounds[2 * k + 1]) / 2 for k in range(3)]
    half = [(bounds[2 * k + 1] - bounds[2 * k]) / 2 for k in range(3)]

    def reach(axis):
        return sum(abs(axis[k]) * half[k] for k in range(3))

    distance = 4 * math.sqrt(sum(h * h for h in half)) + 1e-6
    view.CameraParallelProjection = 1
    view.CameraViewUp = upward
    scale = margin * max(reach(upward), reach(right) / (aspect * (1 - room)), 1e-6)
    aside = [room * scale * aspect * right[k] for k in range(3)]
    view.CameraParallelScale = scale
    view.CameraFocalPoint = [middle[k] - aside[k] for k in range(3)]
    view.CameraPosition = [middle[k] - aside[k] - distance * forward[k] for k in range(3)]


def union(a, b):
    return [f(a[k], b[k]) for k, f in zip(range(6), (min, max) * 3)]


def grown(bounds, share):
    result = list(bounds)
    for k in range(3):
        extra = share * (bounds[2 * k + 1] - bounds[2 * k])
        result[2 * k] -= extra
        result[2 * k + 1] += extra
    return result


def common(a, b):
    """Where two boxes overlap; the first one where they do not."""
    box = [f(a[k], b[k]) for k, f in zip(range(6), (max, min) * 3)]
    return [box[k] if box[2 * (k // 2)] <= box[2 * (k // 2) + 1] else a[k] for k in range(6)]


# ---- charts ----------------------------------------------------------------------------------------------------------

SCRIPT = """
import csv, math
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
with open({file!r}, newline="") as file:
    rows = list(csv.reader(file))
titles = rows[0]
for source, title, factor in {columns!r}:
    k = titles.index(source)
    values = numpy.array([float(row[k]) if row[k] else math.nan for row in rows[1:] if len(row) > k])
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
    source.Script = SCRIPT.format(file=file, columns=columns)
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


# ---- all of it -------------------------------------------------------------------------------------------------------


def main():
    args = options()
    try:
        width, height = (int(x) for x in args.size.split("x"))
    except ValueError:
        fail(f"--size {args.size}: it must look like 1920x1080")
    global scale
    scale = 1 if paraview.fromGUI else min(width / 1920, height / 1080)
    if args.plugin:
        pv.LoadPlugin(os.path.abspath(args.plugin), remote=False, ns=vars(pv))
    reader, folder = open_run(args.run)
    times = list(reader.TimestepValues)
    if not times:
        fail(f"{reader.FileName} has no frames yet")
    histories = table(folder, "histories.csv")
    bird, target = pieces(reader, times[0])
    bends = target is not None and (target.find("velocity") is not None or any(histories.get("max_deflection[m]", [])))
    time = (min(times, key=lambda t: abs(t - args.time)) if args.time is not None else
            time_of_interest(times, histories, 0.8 if bends else 0.5))
    names = part_names(bird) if bird.find("part") else []

    start = bird.most()
    bird.source.UpdatePipeline(time)
    shown = bird.most()
    if paraview.fromGUI or args.film:
        shown = union(start, shown)  # room for all that comes
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = time

    title = os.path.basename(folder) or folder
    side = render_view(title, reader, time)
    show_bird(bird, side, args, names, times)
    show_time(reader, side)
    views, front = [side], None
    if target:
        target.source.UpdatePipeline(time)
        show_target_plain(target, side)
        front = render_view("Target, as the bird sees it", reader, time)
        show_target(target, front, args, times, bends)
        show_time(reader, front)
        views.append(front)

    aspect = (width / len(views)) / (height * (0.6 if histories else 1))
    box = union(shown, common(target.bounds(), grown(shown, 0.1))) if target else shown
    bar = args.colour != "part" or len(names) > 1
    look(side, box, [0.35, 1, -0.15], [0, 0, 1], aspect, room=0.15 if bar else 0)
    if front:
        area = common(target.bounds(), grown(shown, 0.2))
        if bends:
            area = target.bounds()
        look(front, area, [1, 0, 0], [0, 0, 1], aspect, 1.25)

    plots = charts(folder, histories, names, times)  # nothing is computed after this
    layout = pv.CreateLayout(name="BirdStrike")
    top = 0
    if plots:
        top = layout.SplitVertical(0, 0.6)
        side_by_side(layout, top + 1, plots)
    side_by_side(layout, top, views)
    if not paraview.fromGUI:
        layout.SetSize(width, height)

    pv.SetActiveView(side)
    pv.SetActiveSource(bird.source)
    if not paraview.fromGUI:
        for plot in plots:  # with samples, software rendering smears the far side of each text over its near side
            plot.SMProxy.GetClientSideObject().GetRenderWindow().SetMultiSamples(0)
    pv.RenderAllViews()
    if args.save:
        pv.SaveScreenshot(os.path.abspath(args.save), layout, ImageResolution=[width, height])
        written("picture", args.save)
    if args.film:
        pv.SaveAnimation(os.path.abspath(args.film), layout, ImageResolution=[width, height], FrameRate=12)
        written("film", args.film)


main()
