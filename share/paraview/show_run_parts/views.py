# SPDX-License-Identifier: BSD-3-Clause
"""Views of bird and target: their texts, and from where one looks."""
import math

from paraview import simple as pv

from .colours import DARK

BAND = 0.09  # of a view's height, for its title above and the time below
scale = 1  # of texts: 1 for a picture 1080 pixels high


def points(size):
    return max(6, int(scale * size + 0.5))


def render_view(title, time):
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
    text.BackgroundColor = [1, 1, 1, 0.8]  # to be read on whatever lies behind, when the user has turned the view


def show_time(reader, view):
    stamp = pv.AnnotateTimeFilter(registrationName="time", Input=reader)
    stamp.Scale = 1000
    stamp.Format = "t = {time:.2f} ms"
    style(pv.Show(stamp, view), 18, "Lower Center")


def look(view, bounds, direction, up, aspect, room):
    """Parallel view along a direction that just holds a box, beside some room for the colour bar and between the texts."""
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
    half_height = max(reach(upward) / (1 - 2 * BAND), 1.05 * reach(right) / (aspect * (1 - room)), 1e-6)
    aside = [room * half_height * aspect * right[k] for k in range(3)]
    view.CameraParallelScale = half_height
    view.CameraFocalPoint = [middle[k] - aside[k] for k in range(3)]
    view.CameraPosition = [middle[k] - aside[k] - distance * forward[k] for k in range(3)]
