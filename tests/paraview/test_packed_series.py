# SPDX-License-Identifier: GPL-3.0-or-later
"""A packed series in ParaView: opened by its ending, whole and cut short, and read by the filters as run.pvd is."""
import bisect
import pathlib
import struct
import unittest

import in_paraview as pv
from paraview import simple

pv.load_plugin(globals())

CASE = """
title = "a ball on a plate"
[bird]
shape = "sphere"
mass = "0.1 kg"
spacing = "6 mm"
velocity = "200 m/s"
[bird.parts]
body = { porosity = 0.2 }
[target]
plate = { size = ["0.2 m", "0.2 m"], thickness = "5 mm", elements = [10, 10] }
[run]
end = "0.4 ms"
frames = 80
[series]
format = "both"
accuracy = 1e-4
"""


def setUpModule():
    global keep, run
    keep = pv.folder()
    base = pathlib.Path(keep.name)
    (base / "ball.toml").write_text(CASE)
    run = base / "run"
    pv.birdstrike("run", base / "ball.toml", "-o", run, "--threads", 1, "--no-figures")


def tearDownModule():
    keep.cleanup()


def ends_of_frames(series):
    """Where each frame of a packed series ends: 16 bytes, then each frame has 40 bytes, which tell how many follow."""
    place, ends = 16, []
    while place < len(series):
        place += 40 + struct.unpack_from("<QQ", series, place)[1]
        ends.append(place)
    return ends


def times_and_pressures(path):
    packed = simple.OpenDataFile(str(path))
    packed.UpdatePipeline()
    return list(packed.TimestepValues), pv.table(MaximumPressureHistory(Input=packed))["max_pressure_all[Pa]"]


class PackedSeries(unittest.TestCase):
    def test_the_filters_see_the_same_run(self):
        packed, series = simple.OpenDataFile(str(run / "run.bss")), pv.open_series(run / "run.pvd")
        packed.UpdatePipeline()
        self.assertEqual(packed.GetXMLName(), "BirdStrikePackedSeries")
        self.assertEqual(list(packed.TimestepValues), list(series.TimestepValues))
        found, expected = (pv.table(MaximumPressureHistory(Input=source)) for source in (packed, series))
        name = "max_pressure_body[Pa]"
        largest = max(expected[name])
        self.assertEqual(len(found[name]), 81)
        for value, other in zip(found[name], expected[name]):
            self.assertLessEqual(abs(value - other), 1.0001e-4 * largest)
        # Back and forth in time.
        for frame in (70, 3, 66, 0, 80):
            time = packed.TimestepValues[frame]
            here, there = (next(leaf for leaf in pv.leaves(pv.data_at(source, time)) if leaf.GetPointData().HasArray("id"))
                           for source in (packed, series))
            for place in (range(3)):
                difference = abs(pv.numbers(here.GetPoints().GetData())[:, place] -
                                 pv.numbers(there.GetPoints().GetData())[:, place]).max()
                self.assertLessEqual(difference, 1.01e-4 * 0.006)

    def test_a_run_that_was_killed(self):
        whole = (run / "run.bss").read_bytes()
        ends = ends_of_frames(whole)
        self.assertEqual((len(ends), ends[-1]), (81, len(whole)))
        times = list(pv.open_series(run / "run.pvd").TimestepValues)
        pressures = times_and_pressures(run / "run.bss")[1]
        # Cut in a frame, at a frame's end, a byte before it, and within the next frame's header.
        half = bisect.bisect_right(ends, len(whole) // 2)
        cuts = ((len(whole) // 2, half), (ends[29], 30), (ends[29] - 1, 29), (ends[29] + 9, 30))
        for k, (size, frames) in enumerate(cuts):
            cut = run / f"cut{k}.bss"
            cut.write_bytes(whole[:size])
            self.assertEqual(times_and_pressures(cut), (times[:frames], pressures[:frames]))


unittest.main(argv=["test_packed_series"])
