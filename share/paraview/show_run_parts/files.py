# SPDX-License-Identifier: BSD-3-Clause
"""The files of a run that show_run.py shows, and what goes wrong with them."""
import contextlib
import glob
import math
import os
import sys
import tempfile

import paraview
from paraview import simple as pv

# ParaView says so itself only once its Python shell has been opened; pvpython and pvbatch name the script.
in_window = paraview.fromGUI or sys.argv[:1] in ([], [""])


def fail(text):
    if in_window:
        raise RuntimeError(text)
    sys.exit("show_run.py: " + text)


def tell(text):
    """What is no mistake but should be known."""
    print("show_run.py: " + text, file=sys.stderr)


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
                 "environment variable BIRDSTRIKE_RUN" if in_window else
                 "which run? Name its folder, or its run.pvd")
        reader = readers[0]
        file = str(reader.FileName)
    reader.UpdatePipelineInformation()
    return reader, os.path.dirname(file)


def whole_rows(text):
    """Rows of a table that may still be written, or whose run was killed: a last line that is cut short is left out."""
    import csv  # this is also part of a chart's script, which stands alone
    rows = list(csv.reader(text[:text.rfind("\n") + 1].splitlines()))
    return [row for row in rows if len(row) == len(rows[0])]


def table(folder, name):
    """Columns of a CSV file as lists of numbers; {} if there is none, or no row in it yet."""
    try:
        with open(os.path.join(folder, name), newline="") as file:
            rows = whole_rows(file.read())
    except OSError:
        return {}
    columns = {}
    for k, title in enumerate(rows[0] if len(rows) > 1 else []):
        try:
            columns[title] = [float(row[k]) if row[k] else math.nan for row in rows[1:]]
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


@contextlib.contextmanager
def quiet_about(start):
    """Keeps lines that a library writes from the user, if they start so; other lines come afterwards."""
    sys.stderr.flush()
    keep = os.dup(2)
    with tempfile.TemporaryFile("w+") as said:
        os.dup2(said.fileno(), 2)
        try:
            yield
        finally:
            sys.stderr.flush()
            os.dup2(keep, 2)
            os.close(keep)
            said.seek(0)
            sys.stderr.write("".join(line for line in said if not line.startswith(start)))


def written(what, file):
    """ParaView says nothing in the exit status if a file cannot be written."""
    stem, ending = os.path.splitext(file)  # a film of pictures has their numbers between the two
    if not [one for one in glob.glob(glob.escape(stem) + "*" + ending) if os.path.getsize(one)]:
        fail(f"{file} could not be written; is its folder there, and may you write in it?")
    print(what, file)
