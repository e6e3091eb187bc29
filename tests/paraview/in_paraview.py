# SPDX-License-Identifier: GPL-3.0-or-later
# What the tests in pvpython share: the plugin, runs of the program, tables as columns of numbers, messages of filters.
import csv
import os
import pathlib
import subprocess
import tempfile

import vtk.util.numpy_support as numpy_support
from paraview import simple, servermanager
from vtkmodules.vtkCommonCore import vtkObject

build = pathlib.Path(os.environ["BIRDSTRIKE_BUILD"])
program = os.environ["BIRDSTRIKE_PROGRAM"]


def load_plugin(namespace):
    """Load the plugin; its filters become functions of the namespace, like those of paraview.simple."""
    plugin = next((build / "paraview").rglob("BirdStrike.so"))
    simple.LoadPlugin(str(plugin), remote=False, ns=namespace)


def birdstrike(*arguments):
    """Run the program, which must succeed."""
    environment = {**os.environ, "OMP_WAIT_POLICY": "passive"}
    environment.pop("PYTHONPATH", None)
    subprocess.run([program, *map(str, arguments)], check=True, env=environment, stdout=subprocess.DEVNULL)


def rows_of(path):
    """Columns of a table of the program: {title: [numbers]}."""
    with open(path, newline="") as file:
        lines = list(csv.reader(file))
    return {title: [float(line[k]) for line in lines[1:]] for k, title in enumerate(lines[0])}


def open_series(path):
    """A series with its first time step read, as it is after Apply."""
    series = simple.PVDReader(FileName=str(path))
    series.UpdatePipeline()
    return series


def table(source, port=0):
    """Columns of a filter's output table: {title: [values]}; empty if there is none."""
    source.UpdatePipeline()
    data = servermanager.Fetch(source, idx=port)
    columns = {}
    for k in range(data.GetNumberOfColumns()):
        column = data.GetColumn(k)
        columns[data.GetColumnName(k)] = [column.GetValue(row) for row in range(column.GetNumberOfValues())]
    return columns


def data_at(source, time):
    """The output at a time, on the client's side."""
    source.UpdatePipeline(time)
    return source.GetClientSideObject().GetOutputDataObject(0)


def leaves(data):
    """Leaf datasets of what data_at gives."""
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    iterator = data.NewIterator()
    found = []
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def numbers(array):
    """A VTK array as a numpy array."""
    return numpy_support.vtk_to_numpy(array)


class Messages:
    """What a filter's algorithm complains about while this is open: with Messages(filter) as said: ..."""

    def __init__(self, source):
        self.algorithm = source.GetClientSideObject()
        self.texts = []

    def __enter__(self):
        def hear(caller, event, text):
            self.texts.append(text)

        hear.CallDataType = "string0"
        self.tags = [self.algorithm.AddObserver(kind, hear) for kind in ("ErrorEvent", "WarningEvent")]
        return self

    def __exit__(self, *_):
        for tag in self.tags:
            self.algorithm.RemoveObserver(tag)

    def __str__(self):
        return " ".join(self.texts)


def folder():
    """A folder that is gone at the end of the test."""
    return tempfile.TemporaryDirectory(prefix="birdstrike-paraview-")
