# SPDX-License-Identifier: BSD-3-Clause
"""Bird and target of a run as pipeline items, with what is known of them."""
import functools

import numpy
from paraview import servermanager
from paraview import simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy

from .boxes import common, grown, union
from .files import fail


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


def target_box(target, bird, times):
    """Bounds of the target at some times; of one that is far larger than the bird, only what is near to the bird."""
    boxes = []
    for time in times:
        target.source.UpdatePipeline(time)
        boxes.append(target.bounds())
    length = max(bird[2 * k + 1] - bird[2 * k] for k in range(3))
    near = [bird[k] + (-2 * length, 2 * length)[k % 2] for k in range(6)]
    return common(functools.reduce(union, boxes), near)


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
