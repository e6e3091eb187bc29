# SPDX-License-Identifier: GPL-3.0-or-later
"""bench_peers as a user meets it: test_program.py PROGRAM"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)
QUICK = ["--sizes", "6", "--steps", "10", "--repeats", "1", "--threads", "1"]
KEYS = {"solver", "spacing_mm", "threads", "particles", "steps", "updates_per_second", "updates_per_second_median",
        "updates_per_second_of_repeats", "pairs_per_second", "mean_neighbours_start", "mean_neighbours",
        "kinetic_energy_start_J", "kinetic_energy_J", "time_reached_s", "list_rebuilds", "bytes_per_particle",
        "peak_memory_bytes", "ratio_to_pysph", "rejected"}


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60)


class Program(unittest.TestCase):
    def test_json_has_all_that_was_measured(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "found.json")
            done = run("--sizes", "6,8", "--steps", "10,20", "--repeats", "2", "--threads", "1,2", "--no-peer",
                       "--json", path)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with open(path, encoding="utf-8") as file:
                found = json.load(file)
        self.assertEqual(set(found), {"processors", "load_before", "repeats", "pysph", "runs", "speed_up", "flatness"})
        self.assertEqual([(r["spacing_mm"], r["threads"], r["steps"]) for r in found["runs"]],
                         [(6, 1, 10), (6, 2, 10), (8, 1, 20), (8, 2, 20)])
        self.assertEqual(len(found["speed_up"]), 2)
        self.assertEqual(len(found["flatness"]), 2)
        for row in found["runs"]:
            self.assertEqual(set(row), KEYS)
            self.assertIsNone(row["rejected"])
            self.assertIsNone(row["ratio_to_pysph"])
            self.assertEqual(len(row["updates_per_second_of_repeats"]), 2)
            self.assertEqual(row["updates_per_second"], max(row["updates_per_second_of_repeats"]))
            self.assertAlmostEqual(row["pairs_per_second"]/row["updates_per_second"], row["mean_neighbours"])
            self.assertTrue(40 < row["mean_neighbours"] < 80)  # 80 in the bulk, fewer at the surface
            self.assertTrue(0.5*row["kinetic_energy_start_J"] < row["kinetic_energy_J"] < row["kinetic_energy_start_J"])
            # 0.55 kg at 200 m/s, less or more the cells that the surface cuts
            self.assertTrue(0.95 < row["kinetic_energy_start_J"]/11000 < 1.05)
        one, two = found["runs"][:2]  # the number of threads changes no bit
        self.assertEqual(one["kinetic_energy_J"], two["kinetic_energy_J"])

    def test_without_pysph_it_says_so_and_goes_on(self):
        done = run(*QUICK, "--pysph", "/nowhere/python")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("/nowhere/python cannot import pysph", done.stdout)
        self.assertIn("apt install python3-pysph", done.stdout)
        self.assertIn("birdstrike", done.stdout)

    def test_a_peer_whose_bird_flies_apart_is_rejected(self):
        with tempfile.TemporaryDirectory() as folder:
            peer = os.path.join(folder, "python")
            found = {"solver": "pysph", "spacing": 6e-3, "particles": 2856, "steps": 10, "wall": 1e-3, "time": 1e-5,
                     "neighbours_start": 66.0, "neighbours_end": 8.0, "kinetic_start": 11000.0,
                     "kinetic_end": 10000.0, "rebuilds": None, "peak_memory": 1e8}
            with open(peer, "w", encoding="utf-8") as file:
                file.write("#!/bin/sh\necho '%s'\n" % json.dumps(found))
            os.chmod(peer, 0o755)
            path = os.path.join(folder, "found.json")
            done = run(*QUICK, "--pysph", peer, "--json", path)
            with open(path, encoding="utf-8") as file:
                rows = json.load(file)["runs"]
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("rejected: of 66.0 neighbours a particle at the start 8.0 are left", done.stdout)
        self.assertIsNone(rows[0]["ratio_to_pysph"])
        self.assertIsNone(rows[1]["updates_per_second"])
        self.assertIn("flown apart", rows[1]["rejected"])

    def test_a_peer_that_fails_is_said_to(self):
        with tempfile.TemporaryDirectory() as folder:
            peer = os.path.join(folder, "python")
            with open(peer, "w", encoding="utf-8") as file:
                file.write("#!/bin/sh\n[ \"$1\" = -c ] && echo 1.0 && exit\necho 'no compiler' >&2\nexit 3\n")
            os.chmod(peer, 0o755)
            done = run(*QUICK, "--pysph", peer)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("rejected: it ended with status 3: no compiler", done.stdout)

    def test_options_that_do_not_fit(self):
        done = run("--sizes", "6,8,10", "--steps", "10,20", "--no-peer")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--steps has 2 numbers for 3 of --sizes", done.stderr)
        self.assertNotEqual(run("--sizes", "0").returncode, 0)
        done = run(*QUICK, "--no-peer", "--json", "/nowhere/found.json")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/nowhere/found.json: cannot be written", done.stderr)


if __name__ == "__main__":
    unittest.main()
