# SPDX-License-Identifier: BSD-3-Clause
"""A run of BirdStrike in ParaView: the bird, the target and the histories side by side.

In ParaView: open run.pvd and press Apply, then File > Load State, this file. Or say which run in the next line, or in the
environment variable BIRDSTRIKE_RUN. Without ParaView's window, for pictures and films:

    share/paraview/pvbatch share/paraview/show_run.py RUN --save picture.png      (RUN: the folder of a run, or its run.pvd)

The folder show_run_parts beside this file has all that it does.
"""
RUN = ""

import os
import sys

if "__file__" not in globals():
    raise RuntimeError("ParaView's option --script does not tell this file where it lies: use File > Load State, or --state")
beside = os.path.dirname(os.path.abspath(__file__))
if beside not in sys.path:
    sys.path.insert(0, beside)
writes, sys.dont_write_bytecode = sys.dont_write_bytecode, True  # leave nothing behind in the folder
from show_run_parts import command
sys.dont_write_bytecode = writes

command.main(RUN)
