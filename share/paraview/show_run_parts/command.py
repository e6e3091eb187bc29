# SPDX-License-Identifier: BSD-3-Clause
"""The whole of show_run.py: what the user wants, and the views of it side by side."""
import argparse
import os

from paraview import simple as pv

from . import views
from .boxes import union
from .charts import charts, side_by_side
from .files import fail, in_window, open_run, quiet_about, table, time_of_interest, written
from .pieces import part_names, pieces, target_box
from .shapes import show_bird, show_target, show_target_plain
from .views import look, render_view, show_time


def options(run):
    parser = argparse.ArgumentParser(prog="show_run.py", description="A run of BirdStrike in ParaView: bird, target and "
                                     "histories side by side.", allow_abbrev=False)
    parser.add_argument("run", nargs="?", default=run or os.environ.get("BIRDSTRIKE_RUN", ""),
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
    if in_window:
        return parser.parse_args([])
    return parser.parse_args()


def main(run):
    """Show a run; the name of one that the user has written into show_run.py, or nothing."""
    args = options(run)
    try:
        width, height = (int(x) for x in args.size.split("x"))
    except ValueError:
        fail(f"--size {args.size}: it must look like 1920x1080")
    views.scale = 1 if in_window else min(width / 1920, height / 1080)
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
    moving = in_window or args.film  # then there is room for all that comes
    if moving:
        shown = union(start, shown)
    seen = target_box(target, shown, [time] + times[::max(1, len(times) // 4)] if moving else [time]) if target else None
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = time

    title = os.path.basename(folder) or folder
    side = render_view(title, time)
    show_bird(bird, side, args, names, times)
    show_time(reader, side)
    shown_views, front = [side], None
    if target:
        target.source.UpdatePipeline(time)
        show_target_plain(target, side)
        front = render_view("Target, as the bird sees it", time)
        show_target(target, front, args, times, bends)
        show_time(reader, front)
        shown_views.append(front)

    aspect = (width / len(shown_views)) / (height * (0.6 if histories else 1))
    if in_window:
        aspect *= 0.8  # its size is not known yet, and panels take a part of the width
    bar = args.colour != "part" or len(names) > 1
    look(side, union(shown, seen) if seen else shown, [0.35, 1, -0.15], [0, 0, 1], aspect, room=0.15 if bar else 0)
    if front:
        look(front, seen, [1, 0, 0], [0, 0, 1], aspect, room=0.2)

    plots = charts(folder, histories, names, times)  # nothing is computed after this
    layout = pv.CreateLayout(name="BirdStrike")
    top = 0
    if plots:
        top = layout.SplitVertical(0, 0.6)
        side_by_side(layout, top + 1, plots)
    side_by_side(layout, top, shown_views)
    if not in_window:
        layout.SetSize(width, height)

    pv.SetActiveView(side)
    pv.SetActiveSource(bird.source)
    if not in_window:
        for plot in plots:  # with samples, software rendering smears the far side of each text over its near side
            plot.SMProxy.GetClientSideObject().GetRenderWindow().SetMultiSamples(0)
    pv.RenderAllViews()
    if args.save:
        pv.SaveScreenshot(os.path.abspath(args.save), layout, ImageResolution=[width, height])
        written("picture", args.save)
    if args.film:
        with quiet_about("[swscaler"):
            pv.SaveAnimation(os.path.abspath(args.film), layout, ImageResolution=[width, height], FrameRate=12)
        written("film", args.film)
