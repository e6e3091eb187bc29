# SPDX-License-Identifier: GPL-3.0-or-later
# The plugin's histories and peaks over a run of the program, against the program's own numbers.
import json
import math
import pathlib
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUAD, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

import in_paraview as pv

pv.load_plugin(globals())

CASE = """
title = "A bird of 50 g on a sheet"
[bird]
shape = "capsule"
mass = "0.05 kg"
spacing = "7 mm"
velocity = "150 m/s"
[bird.parts]
front = { porosity = 0.4, share = 0.6 }
back = { porosity = 0.5, share = 0.4 }
[target]
rigid = false
plate = { size = ["0.3 m", "0.3 m"], thickness = "1 mm", elements = [20, 20] }
material = "al-2024-t3"
[deflections]
middle = { at = ["0 mm", "0 mm", "0 mm"] }
[run]
end = "0.6 ms"
frames = 12
[series]
precision = "double" # compared with the run to rounding
"""

RIGID_CASE = """
title = "A bird of 100 g on a transducer"
[bird]
shape = "cylinder"
mass = "0.1 kg"
spacing = "6 mm"
velocity = "150 m/s"
[bird.parts]
body = { porosity = 0.4 }
[target]
plate = { size = ["0.2 m", "0.2 m"], thickness = "10 mm", elements = [40, 40] }
[transducers]
face = { diameter = "50 mm", rise_time = "20 us" }
[run]
end = "0.7 ms"
frames = 120
"""


def setUpModule():
    global keep, run, series, steps, frames
    keep = pv.folder()
    base = pathlib.Path(keep.name)
    (base / "sheet.toml").write_text(CASE)
    run = base / "run"
    pv.birdstrike("run", base / "sheet.toml", "-o", run, "--threads", 1)
    pv.birdstrike("histories", run / "run.pvd", "-o", base / "frames.csv", "--deflection-at", "0=0,0,0",
                  "--deflection-along", "1,0,0", "--quiet")
    steps = pv.rows_of(run / "histories.csv")  # of every time step of the solver
    frames = pv.rows_of(base / "frames.csv")  # of the frames, by the filters in the program
    series = pv.open_series(run / "run.pvd")


def tearDownModule():
    keep.cleanup()


def at_frames(column):
    """A column of histories.csv at the times of the frames."""
    times = numpy.array(steps["time[s]"])
    rows = [int(numpy.argmin(abs(times - time))) for time in frames["time[s]"]]
    assert all(abs(times[row] - time) < 1e-12 for row, time in zip(rows, frames["time[s]"]))
    return [steps[column][row] for row in rows]


def foreign_series():
    """Four nodes with a cell at two times, as another solver might write them."""
    base = pathlib.Path(keep.name)
    lines = []
    for step in (0, 1):
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        cell = vtkIdList()
        for place in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)):
            cell.InsertNextId(points.InsertNextPoint(place))
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_QUAD, cell)
        for name, values in (("Mass", [2, 2, 2, 2]), ("Stress", [0, 1, 2, 3]), ("Deflection", [(7, 0, 0)] * 4),
                             ("Load", [(5, 0, 0)] * 4)):
            array = numpy_to_vtk(numpy.array(values, float), deep=1)
            array.SetName(name)
            grid.GetPointData().AddArray(array)
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(base / f"foreign{step}.vtu"))
        writer.SetInputData(grid)
        writer.Write()
        lines.append(f'<DataSet timestep="{step}" file="foreign{step}.vtu"/>')
    (base / "foreign.pvd").write_text('<?xml version="1.0"?><VTKFile type="Collection" version="0.1"><Collection>' +
                                      "".join(lines) + "</Collection></VTKFile>")
    return pv.open_series(base / "foreign.pvd")


class Histories(unittest.TestCase):
    def check_close(self, values, expected, relative=1e-12):
        self.assertEqual(len(values), len(expected))
        largest = max(abs(value) for value in expected)
        for value, other in zip(values, expected):
            self.assertLessEqual(abs(value - other), relative * largest)

    def test_maximum_pressure(self):
        history = MaximumPressureHistory(Input=series)
        columns = pv.table(history)
        for name in ("all", "front", "back"):
            title = f"max_pressure_{name}[Pa]"
            self.check_close(columns[title], frames[title])
            self.check_close(columns[title], at_frames(title))
        peaks = pv.table(history, 1)
        self.assertEqual(peaks["part"], ["all", "front", "back"])
        for name, peak, time in zip(peaks["part"], peaks["peak_pressure[Pa]"], peaks["time[s]"]):
            column = columns[f"max_pressure_{name}[Pa]"]
            self.assertEqual(peak, max(column))
            self.assertEqual(time, columns["Time"][column.index(peak)])
        # The particle is where the peak says, and has that pressure.
        for leaf in pv.leaves(pv.data_at(series, peaks["time[s]"][0])):
            ids = leaf.GetPointData().GetArray("id")
            if ids:
                row = pv.numbers(ids).tolist().index(peaks["id"][0])
                self.assertEqual(leaf.GetPoint(row), tuple(peaks[f"{axis}[m]"][0] for axis in "xyz"))
                self.assertEqual(leaf.GetPointData().GetArray("pressure").GetValue(row), peaks["peak_pressure[Pa]"][0])

    def test_pressure_in_regions(self):
        history = MaximumPressureHistory(Input=series, Region="Sphere", Center=[0, 0, 0], Radius=10)
        self.assertEqual(pv.table(history)["max_pressure_all[Pa]"], frames["max_pressure_all[Pa]"])
        history.Region = "Box"
        history.Center = [0.5, 0, 0]  # behind the sheet: no particle gets there
        self.assertTrue(all(math.isnan(value) for value in pv.table(history)["max_pressure_all[Pa]"]))
        history.Radius = 0
        history.Region = "Sphere"
        with pv.Messages(history) as said:
            self.assertEqual(pv.table(history), {})
        self.assertIn("Radius is 0 m", str(said))

    def test_deflection(self):
        history = TargetDeflectionHistory(Input=series, Points=[0, 0, 0], Direction=[1, 0, 0], Details=1, UseLine=1,
                                          LineStart=[0, -0.15, 0], LineEnd=[0, 0.15, 0], LinePoints=41)
        columns = pv.table(history)
        expected = {"Time" if title == "time[s]" else title for title in frames if "max_pressure" not in title}
        self.assertEqual(set(columns), expected)
        for title in columns:
            for value, expected in zip(columns[title], frames["time[s]" if title == "Time" else title]):
                self.assertTrue(value == expected or (math.isnan(value) and math.isnan(expected)), title)
        self.check_close(columns["max_deflection[m]"], at_frames("max_deflection[m]"))
        self.check_close(columns["deflection_along_at_0[m]"], at_frames("deflection_middle[m]"))
        line = pv.table(history, 1)
        profiles = [title for title in line if title.startswith("deflection_at_")]
        self.assertEqual(len(profiles), len(frames["time[s]"]))
        self.assertEqual(line["arc_length"][20], 0.15)
        for k, title in enumerate(profiles):
            self.assertAlmostEqual(line[title][20], columns["deflection_along_at_0[m]"][k], delta=1e-12)
            self.assertLess(max(abs(line[title][0]), abs(line[title][40])), 1e-15)  # the sheet is clamped there
        self.assertLess(max(line["off_target[m]"]), 1e-12)

    def test_contact_force(self):
        history = ContactForceandImpulseHistory(Input=series, PerPart=1)
        columns = pv.table(history)
        for axis in "xyz":
            for title in (f"contact_force_{axis}[N]", f"impulse_{axis}[N s]"):
                self.check_close(columns[title], at_frames(title), 1e-9)
        self.check_close(columns["contact_force_part_0[N]"], columns["contact_force[N]"])
        summary = json.loads((run / "summary.json").read_text())
        self.assertAlmostEqual(columns["impulse_x[N s]"][-1] / summary["impulse"], 1, delta=1e-9)
        # The filter has no frames between; over all of them the sheet is as large as it was cut.
        self.assertAlmostEqual(pv.table(history, 1)["area[m2]"][0], 0.09, delta=1e-12)
        # Halves add up.
        sums = [0] * len(columns["Time"])
        for side in (-0.5, 0.5):
            half = ContactForceandImpulseHistory(Input=series, Region="Box", Center=[0, side, 0], BoxSize=[1, 1, 1])
            sums = [a + b for a, b in zip(sums, pv.table(half)["contact_force_x[N]"])]
        self.check_close(sums, columns["contact_force_x[N]"])

    def test_transducer(self):
        # The solver gives a face the share of a particle's footprint, a disc of 6.7 mm radius, the filter that of elements of
        # 5 mm: on a face of 50 mm the two are nearly the same.
        base = pathlib.Path(keep.name)
        (base / "plate.toml").write_text(RIGID_CASE)
        pv.birdstrike("run", base / "plate.toml", "-o", base / "plate", "--threads", 1, "--no-figures")
        expected = json.loads((base / "plate/summary.json").read_text())["transducers"]["face"]
        history = ContactForceandImpulseHistory(Input=pv.open_series(base / "plate/run.pvd"), Region="Cylinder",
                                                Radius=0.025, RiseTime=20e-6)
        impulse = pv.table(history)["impulse_x[N s]"][-1]
        pressure = pv.table(history, 1)
        area = pressure["area[m2]"][-1]
        self.assertAlmostEqual(area / (math.pi * 0.025**2), 1, delta=1e-3)
        self.assertAlmostEqual(impulse / area / expected["impulse"], 1, delta=0.02)
        self.assertAlmostEqual(max(pressure["mean_pressure_filtered[Pa]"]) / expected["peak"], 1, delta=0.03)

    def test_peak_over_time(self):
        times = list(series.TimestepValues)
        exact, so_far = None, None
        for k, time in enumerate(times):
            target = [leaf for leaf in pv.leaves(pv.data_at(series, time)) if leaf.GetCellData().GetArray("contact_force")]
            force = numpy.linalg.norm(pv.numbers(target[0].GetCellData().GetArray("contact_force")), axis=1)
            exact = force if k == 0 else numpy.maximum(exact, force)
            so_far = exact if k == 6 else so_far
        peaks = PeakOverTime(Input=series, Array="contact_force")

        def found(time, name="peak_contact_force"):
            return next(pv.numbers(leaf.GetCellData().GetArray(name)) for leaf in pv.leaves(pv.data_at(peaks, time))
                        if leaf.GetCellData().HasArray(name))

        for time in (times[0], times[-1]):
            numpy.testing.assert_allclose(found(time), exact, rtol=1e-14)
        self.assertTrue(set(found(times[0], "time_of_peak_contact_force")) <= set(times))
        peaks.UpToCurrentTime = 1
        for time, expected in ((times[6], so_far), (times[-1], exact), (times[6], so_far)):
            numpy.testing.assert_allclose(found(time), expected, rtol=1e-14)
        # What the solver sampled at every step is never less than what the frames show.
        peaks.Array = "contact_pressure"
        self.assertTrue((found(times[-1], "peak_contact_pressure") >=
                         found(times[-1], "peak_contact_pressure_of_frames")).all())
        # Particles, by their number.
        peaks.Array = "pressure"
        largest = max(pv.numbers(leaf.GetPointData().GetArray("peak_pressure")).max()
                      for leaf in pv.leaves(pv.data_at(peaks, times[-1])) if leaf.GetPointData().HasArray("peak_pressure"))
        self.assertEqual(largest, max(frames["max_pressure_all[Pa]"]))

    def test_range_of_time(self):
        wanted = [time for time in frames["time[s]"] if 1.9e-4 < time < 4.1e-4]
        for make in (MaximumPressureHistory, TargetDeflectionHistory, ContactForceandImpulseHistory):
            history = make(Input=series, LimitTime=1, StartTime=2e-4, EndTime=4e-4)
            self.assertEqual(pv.table(history)["Time"], wanted)
            history.StartTime = history.EndTime = 1
            with pv.Messages(history) as said:
                self.assertEqual(pv.table(history), {})
            self.assertIn("No time step lies between Start Time 1 s and End Time 1 s; the series has 13 from 0 s",
                          str(said))
        peaks = PeakOverTime(Input=series, Array="contact_force", LimitTime=1, StartTime=0, EndTime=0)
        for leaf in pv.leaves(pv.data_at(peaks, 6e-4)):
            if leaf.GetCellData().HasArray("peak_contact_force"):
                self.assertEqual(pv.numbers(leaf.GetCellData().GetArray("peak_contact_force")).max(), 0)

    def test_abort(self):
        for make in (MaximumPressureHistory, PeakOverTime):
            source = make(Input=series)
            algorithm = source.GetClientSideObject()
            seen = []

            def stop(caller, event):
                seen.append(caller.GetProgressText() or "")
                if "5 of 13" in seen[-1]:
                    caller.SetAbortExecute(1)

            tag = algorithm.AddObserver("ProgressEvent", stop)
            algorithm.Update()
            self.assertIn("time step 1 of 13, 0 s", seen)
            self.assertFalse(any("6 of 13" in text for text in seen))
            output = algorithm.GetOutputDataObject(0)
            self.assertEqual(output.GetNumberOfElements(6 if make is MaximumPressureHistory else 0), 0)
            algorithm.RemoveObserver(tag)
            algorithm.SetAbortExecute(0)  # from VTK 9.2 on whoever has set it takes it back
            algorithm.Modified()
            algorithm.Update()
            output = algorithm.GetOutputDataObject(0)
            self.assertGreater(output.GetNumberOfElements(6 if make is MaximumPressureHistory else 0), 0)

    def test_names_in_python(self):
        # ParaView makes them of the panels' labels: those are words alone, the property's own ones.
        for make in (MaximumPressureHistory, TargetDeflectionHistory, ContactForceandImpulseHistory, PeakOverTime,
                     BirdSurface, Fragments):
            source = make(Input=series)
            for name in source.ListProperties():
                own = source.GetProperty(name).SMProperty.GetXMLName()
                own = own[:-len("Name")] if own.endswith("ArrayName") else own
                self.assertEqual(name, {"Density": "TargetDensity"}.get(own, own))

    def test_array_that_is_not_there(self):
        # Another solver's series has arrays of the right kind under other names. None but the user may choose one of them.
        foreign = foreign_series()
        for make, name, array in ((MaximumPressureHistory, "PressureArray", "pressure"),
                                  (TargetDeflectionHistory, "DisplacementArray", "displacement"),
                                  (ContactForceandImpulseHistory, "ForceArray", "contact_force")):
            for chosen in (array, "nothing"):
                history = make(Input=foreign)
                if chosen != array:
                    setattr(history, name, chosen)
                with pv.Messages(history) as said:
                    self.assertEqual(pv.table(history), {})
                    self.assertEqual(pv.table(history, 1), {})
                self.assertIn(f"'{chosen}' at any of its 2 time steps", str(said))
                self.assertEqual(getattr(history, name), chosen)
        peaks = PeakOverTime(Input=foreign)
        with pv.Messages(peaks) as said:
            self.assertEqual([leaf.GetNumberOfPoints() for leaf in pv.leaves(pv.data_at(peaks, 0))], [0])
        self.assertIn("'contact_pressure' at any of the 2 time steps", str(said))

    def test_arrays_that_may_be_missing(self):
        # Deflection is a vector like an impulse, Mass a number like an id, a part or a pressure: neither is taken for one.
        foreign = foreign_series()
        force = ContactForceandImpulseHistory(Input=foreign, ForceArray="Load")
        columns = pv.table(force)
        self.assertEqual(columns["contact_force_x[N]"], [20, 20])  # of four nodes
        self.assertEqual(columns["impulse_x[N s]"], [0, 20])
        pressure = MaximumPressureHistory(Input=foreign, PressureArray="Stress", Details=1)
        columns = pv.table(pressure)
        self.assertEqual(columns["max_pressure_all[Pa]"], [3, 3])
        self.assertEqual([title for title in columns if title.startswith("max_pressure_")], ["max_pressure_all[Pa]"])
        self.assertEqual(columns["id_of_max_pressure"], [3, 3])  # its row

    def test_changed_number_of_points(self):
        index = run / "changed.pvd"
        index.write_text('<?xml version="1.0"?><VTKFile type="Collection" version="0.1"><Collection>'
                         '<DataSet timestep="0" file="frames/target_0000.vtu"/>'
                         '<DataSet timestep="1" file="frames/bird_0000.vtu"/>'
                         '<DataSet timestep="2" file="frames/target_0000.vtu"/></Collection></VTKFile>')
        changed = pv.open_series(index)
        deflection = pv.table(TargetDeflectionHistory(Input=changed))["max_deflection[m]"]
        self.assertEqual([math.isnan(value) for value in deflection], [False, True, False])
        # Points of the target, then particles whose numbers are not looked at.
        peaks = PeakOverTime(Input=changed, Array="velocity", IdArray="nothing")
        with pv.Messages(peaks) as said:
            pv.data_at(peaks, 0)
        self.assertIn("cannot be followed and have no peak", str(said))


unittest.main()
