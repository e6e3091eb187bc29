# SPDX-License-Identifier: GPL-3.0-or-later
# Skin and fragments in ParaView, of a run that breaks its target, against the program's own numbers.
import json
import math

import in_paraview as t
import numpy

t.load_plugin(globals())
case = """
title = "A bird of 50 g goes through a sheet"
[bird]
shape    = "capsule"
mass     = "0.05 kg"
spacing  = "5 mm"
velocity = "250 m/s"
[bird.parts]
body = { porosity = 0.4 }
[target]
rigid    = false
plate    = { size = ["0.2 m", "0.2 m"], thickness = "0.3 mm", elements = [20, 20] }
material = "al-2024-t3"
[run]
end = "0.8 ms"
frames = 6
[series]
precision = "double" # compared with the run to rounding
"""

with t.folder() as folder:
    with open(folder + "/case.toml", "w") as file:
        file.write(case)
    t.birdstrike("run", folder + "/case.toml", "-o", folder + "/run", "--threads", "1")
    with open(folder + "/run/summary.json") as file:
        summary = json.load(file)
    series = t.open_series(folder + "/run/run.pvd")
    last = series.TimestepValues[-1]
    series.UpdatePipeline(last)

    # Fragments: names by default are those of our runs, also after Apply.
    fragments = Fragments(Input=series, TargetDensity=2780)
    for name, array in (("MassArray", "mass"), ("VelocityArray", "velocity"), ("ErodedArray", "eroded"),
                        ("ThicknessArray", "thickness"), ("SmoothingLengthArray", "smoothing_length")):
        assert getattr(fragments, name) == array, (name, getattr(fragments, name))
    fragments.UpdatePipeline(last)
    table = t.table(fragments, 1)
    bird = [k for k, name in enumerate(table["dataset"]) if name == "bird"]
    target = [k for k, name in enumerate(table["dataset"]) if name == "target"]
    assert bird and target
    assert math.isclose(sum(table["mass[kg]"][k] for k in bird), summary["bird"]["mass"], rel_tol=1e-9)
    momentum = sum(table["momentum_x[kg m/s]"][k] for k in bird)
    assert math.isclose(momentum, summary["bird"]["final_momentum"], rel_tol=1e-9), momentum
    energy = sum(table["kinetic_energy[J]"][k] for k in bird)
    history = t.rows_of(folder + "/run/histories.csv")
    assert math.isclose(energy, history["kinetic_energy[J]"][-1], rel_tol=1e-9), energy
    assert [table["fragment"][k] for k in bird] == list(range(len(bird)))
    masses = [table["mass[kg]"][k] for k in bird]
    assert masses == sorted(masses, reverse=True)
    # What has eroded is in no fragment.
    eroded = summary["target"]["eroded_elements"]
    assert eroded > 0, "the case no longer breaks its target"
    assert sum(table["count"][k] for k in target) == 400 - eroded
    standing = sum(table["mass[kg]"][k] for k in target) / summary["target"]["mass"]
    assert abs(standing - (400 - eroded) / 400) < 0.02, standing

    # The skin, of the whole and by parts.
    skin = BirdSurface(Input=series)
    skin.UpdatePipeline(0)
    surface, = t.leaves(t.data_at(skin, 0))
    particles = next(leaf for leaf in t.leaves(t.data_at(series, 0)) if leaf.GetPointData().GetArray("mass"))
    assert surface.GetNumberOfCells() > 1000
    velocity = t.numbers(surface.GetPointData().GetArray("velocity"))
    assert abs(velocity[:, 0] - 250).max() < 1e-9 and abs(velocity[:, 1:]).max() < 1e-9
    corners = t.numbers(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = t.numbers(surface.GetPoints().GetData())
    a, b, c = (points[corners[:, k]] for k in range(3))
    volume = numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6
    filled = particles.GetNumberOfPoints() * 0.005**3  # the radius is only some four spacings
    assert abs(volume / filled - 1) < 0.08, volume / filled
    skin.SurfacePerPart = 1
    parts = t.data_at(skin, last)
    assert parts.GetNumberOfBlocks() == 1 and parts.GetMetaData(0).Get(parts.NAME()) == "body"
