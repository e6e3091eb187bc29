# SPDX-License-Identifier: BSD-3-Clause
"""Bird and target as they are drawn."""
import math

from paraview import simple as pv

from .colouring import colour_by_number, colour_by_parts, largest_over
from .colours import PLAIN_TARGET, part_colour
from .files import fail, in_window
from .pieces import scaled

BALL = 0.62  # radius of a ball of a particle's volume, in spacings


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
        item.SurfacePerPart = 1 if args.organs else 0
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
    if not in_window:  # with samples, software rendering shows nothing see-through
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
    # Bright, also where the light does not fall on it: every part of a bird is darker, grey wings by 2 : 1.
    display.DiffuseColor = display.AmbientColor = PLAIN_TARGET
    display.Ambient, display.Diffuse = 0.85, 0.15
    display.EdgeColor = [0.78, 0.80, 0.83]
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
