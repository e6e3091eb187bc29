# SPDX-License-Identifier: GPL-3.0-or-later
# share/paraview/show_run.py makes pictures of runs with a rigid target and with one that bends, in which every view shows
# something; its mistakes are told.
import contextlib
import os
import pathlib
import shutil
import subprocess

import in_paraview as t
import numpy
from vtkmodules.vtkIOImage import vtkPNGReader

root = pathlib.Path(__file__).parents[2]
bird = """
title = "A small bird"
[bird]
shape    = "capsule"
mass     = "0.05 kg"
spacing  = "6 mm"
velocity = "150 m/s"
[bird.parts]
torso = { porosity = 0.4, share = 0.6 }
bones = { porosity = 0.2, share = 0.4 }
[target]
plate    = { size = ["0.3 m", "0.3 m"], thickness = "1 mm", elements = [20, 20] }
"""
soft = 'rigid = false\nmaterial = "al-2024-t3"\n'
end = '[run]\nend = "0.6 ms"\nframes = 5\n'


@contextlib.contextmanager
def screen():
    """A screen of our own, which nobody else has; its number."""
    number = ""
    while not number:  # another that starts in the same moment may take it away
        read_end, write_end = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1280x1024x24",
                                   "-nolisten", "tcp", "-noreset"], pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as answer:
            number = answer.readline().strip()
        if not number:
            server.wait()
    try:
        yield ":" + number
    finally:
        server.terminate()
        server.wait()


def show(*arguments):
    """Exit status and what was said."""
    environment = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "XAUTHORITY")}
    with screen() as environment["DISPLAY"]:
        done = subprocess.run([root / "share/paraview/pvbatch", root / "share/paraview/show_run.py",
                               *map(str, arguments)], env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=300)
    return done.returncode, done.stdout


def read(path):
    """Pixels of a picture as rows (from the top) x columns x 3."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    pixels = t.numbers(image.GetPointData().GetScalars()).reshape(rows, columns, -1)
    return pixels[::-1, :, :3].astype(int)


def share_of_colour(pixels):
    """Share of pixels that are neither white nor grey, and the number of different ones."""
    vivid = pixels.max(axis=2) - pixels.min(axis=2) > 40
    return vivid.mean(), len(numpy.unique(pixels.reshape(-1, 3), axis=0))


def luminance(pixels):
    """0 to 1, of colours in sRGB."""
    share = pixels / 255
    return numpy.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4) @ [0.2126, 0.7152, 0.0722]


def check_charts(view, share):
    """Lines, each in half of the width."""
    for half in (view[:, :600], view[:, 600:]):
        vivid, _ = share_of_colour(half)
        assert share < vivid < 0.2, vivid


with t.folder() as folder:
    for name, text in (("stiff", bird + end), ("soft", bird + soft + end)):
        with open(f"{folder}/{name}.toml", "w") as file:
            file.write(text)
        t.birdstrike("run", f"{folder}/{name}.toml", "-o", f"{folder}/{name}", "--threads", "1")

    status, said = show(f"{folder}/stiff", "--save", f"{folder}/stiff.png", "--size", "1200x800")
    assert status == 0, said
    pixels = read(f"{folder}/stiff.png")
    assert pixels.shape == (800, 1200, 3)
    top = int(0.6 * 800)
    for view in (pixels[:top, :600], pixels[:top, 600:]):  # bird, target
        vivid, colours = share_of_colour(view)
        assert vivid > 0.01 and colours > 200, (vivid, colours)
    check_charts(pixels[top:], 0.0005)
    # The plate is in the view as a whole, and stands out from grey wings.
    side = pixels[:top, :599]
    assert all(edge.min() == 255 for edge in (side[:4], side[-4:], side[:, :4], side[:, -4:]))
    plate = side[60:-60, 150:]
    plate = plate[(plate.max(axis=2) - plate.min(axis=2) < 25) & (plate.min(axis=2) > 128) & (plate.min(axis=2) < 245)]
    assert len(plate) > 2000, len(plate)
    wing = luminance(numpy.array([0x8A, 0x8A, 0x8A]))
    contrast = (numpy.quantile(luminance(plate), 0.1) + 0.05) / (wing + 0.05)
    assert contrast >= 2, contrast
    brown, green = [numpy.abs(pixels[:top, :120] - colour).max(axis=2).min() for colour in
                    ((0xcf, 0x8f, 0x3c), (0x00, 0x9e, 0x73))]
    assert brown <= 2 and green <= 2, "the legend of parts has its colours"

    status, said = show(f"{folder}/soft/run.pvd", "--colour", "pressure", "--target", "plastic_strain", "--save",
                        f"{folder}/soft.png", "--size", "1200x800", "--time", "0.0003")
    assert status == 0, said
    for view in (read(f"{folder}/soft.png")[:top, :600], read(f"{folder}/soft.png")[:top, 600:]):
        vivid, colours = share_of_colour(view)
        assert vivid > 0.01 and colours > 200, (vivid, colours)

    plugin = next((t.build / "paraview").rglob("BirdStrike.so"))
    status, said = show(f"{folder}/stiff", "--organs", "--plugin", plugin, "--save", f"{folder}/organs.png", "--size",
                        "800x600", "--time", "0")
    assert status == 0, said
    vivid, colours = share_of_colour(read(f"{folder}/organs.png")[:360, 100:400])  # beside the legend
    assert vivid > 0.01 and colours > 200, (vivid, colours)

    # A run that was killed while it wrote a line of its table.
    killed = shutil.copytree(f"{folder}/stiff", f"{folder}/killed")
    text = pathlib.Path(killed, "histories.csv").read_text()
    pathlib.Path(killed, "histories.csv").write_text(text[:text.index("\n", len(text) * 3 // 4) - 50])
    status, said = show(killed, "--save", f"{folder}/killed.png", "--size", "1200x800")
    assert status == 0, said
    check_charts(read(f"{folder}/killed.png")[top:], 0.0004)

    status, said = show(f"{folder}/stiff", "--target", "displacement", "--film", f"{folder}/film.avi", "--size", "400x300")
    assert status == 0, said
    lines = said.splitlines()
    assert lines == ["show_run.py: deflection is 0 in all frames", f"film {folder}/film.avi"], said

    status, said = show(f"{folder}/nowhere", "--save", f"{folder}/x.png")
    assert status != 0 and "nowhere does not exist" in said, said
    status, said = show(f"{folder}/stiff", "--colour", "temper", "--save", f"{folder}/x.png")
    assert status != 0 and "'temper'" in said and "mean_pressure" in said, said
