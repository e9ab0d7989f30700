# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page about performance says what was measured, where and beside what, and a second run what has moved."""

import copy
import json
import sys
import unittest

import camaron_testing

sys.path.insert(0, str(camaron_testing.ROOT / "Testing" / "Benchmarks"))

from benchmark_records import OURS
from report import as_json
from report_page import compare, page, readme
from report_rows import RUNS, TABLE


def record(work, mesh, by, cells, times, **more):
    return {
        "work": work,
        "mesh": mesh,
        "by": by,
        "cells": cells,
        "threads": 2,
        "backend": "STDThread",
        "vtk": "9.3.1",
        "times": [[time, time] for time in times],
        **more,
    }


FILE = ("open a file", "triangles, binary PLY")
PICTURE = ("first picture, with reading", "polyhedra")
RUN = {
    "plugin": "camaron 0.1.0+abc for ParaView 5.13.2, built by GNU 14",
    "date": "2026-11-28",
    "load": 0.12,
    "quiet": True,
    "quick": False,
    "machine": {"processor": "Foo 3000", "cores": 2, "memory": "8 GiB"},
    "records": [
        record(*FILE, OURS, 1000, [0.01, 0.01, 0.01, 0.012, 0.01], peak=13e6, size=10e6),
        record(*FILE, "vtkPLYReader", 1000, [0.2, 0.21, 0.19, 0.2, 0.2], peak=40e6),
        record(*FILE, OURS, 5000, [0.1] * 5),
        record(*FILE, "vtkPLYReader", 5000, [0.5] * 5),
        record(*PICTURE, OURS, 1_000_000, [2.5] * 5, renderer="llvmpipe", driver="4.5 Mesa"),
        record(
            *PICTURE,
            "Surface With Edges",
            100_000,
            [30, 31],
            renderer="llvmpipe",
            driver="4.5 Mesa",
        ),
        record("copy memory", "machine", "machine", 2e9, [0.1] * 5),
    ],
}


NOT_OPTIMIZED = {**RUN, "is_peer_optimized": False}


def changed(factor, by, **more):
    run = {**copy.deepcopy(RUN), **more}
    for row in run["records"]:
        if row["by"] == by:
            row["times"] = [[factor * wall, core] for wall, core in row["times"]]
    return run


class TestBenchmarks(unittest.TestCase):
    def rows(self, text, work):
        lines = [line.split(" | ") for line in text.splitlines() if line.startswith("| ")]
        found = next(i for i, line in enumerate(lines) if line[0] == f"| {work}")
        return lines[found]

    def test_row(self):
        """A ratio upside down, or a target that is met by being missed, would be believed."""
        row = self.rows(page({"5.13.2": RUN}), "open a file")
        self.assertEqual(row[1], "1,000 triangles, binary PLY")
        self.assertEqual(row[2], "10.0 ms ±10 %")
        self.assertEqual(row[3:6], ["vtkPLYReader", "200 ms ±5 %", "20.0 ×"])
        self.assertEqual(row[6], "15 times as fast: met")
        self.assertEqual(row[7], "13.0 MB, mesh 10.0 MB / 40.0 MB |")

    def test_sizes_are_not_mixed(self):
        """The same work on two meshes is compared on each, and only one of them meets the target."""
        text = page({"5.13.2": RUN})
        self.assertEqual(text.count("15 times as fast: met"), 1)
        self.assertEqual(text.count("15 times as fast: **missed**"), 1)
        self.assertIn("| 5,000 triangles, binary PLY | 100 ms ±0 % | vtkPLYReader |", text)

    def test_slow_peer(self):
        """A peer with fewer cells and runs is compared for each cell, and the page says how many."""
        text = page({"5.13.2": RUN})
        (line,) = [l for l in text.splitlines() if "1,000,000 polyhedra" in l]
        self.assertIn("2.50 s ±0 %, 2.50 µs per cell", line)
        self.assertIn("Surface With Edges, 100,000 cells | 310 µs per cell ±2 %, of 2 |", line)
        self.assertIn("| 124 × | 3 s: met |", line)

    def test_section(self):
        """A figure without its machine and versions is a figure of nothing."""
        text = page({"5.13.2": RUN, "6.1.1": RUN, "10.0.0": RUN})
        heads = [line for line in text.splitlines() if line.startswith("## ")]
        runs = [f"## ParaView {v}" for v in ("10.0.0", "6.1.1", "5.13.2")]
        self.assertEqual(heads, [*runs, "## On a graphics card"])
        for words in ("Foo 3000, 2 cores, 8 GiB", "VTK 9.3.1, 2 threads", "backend STDThread"):
            self.assertIn(words, text)
        self.assertIn("pictures by llvmpipe, OpenGL 4.5 Mesa; camaron 0.1.0+abc", text)
        self.assertIn("copy memory 20.0 GB/s", text)
        self.assertIn("| unique faces and neighbors | tetrahedra | not measured |", text)
        self.assertNotIn("do not quote", text)

    def test_warnings(self):
        """Figures of a busy machine or of tiny meshes must not pass for results."""
        self.assertIn("do not quote", page({"5.13.2": {**RUN, "quiet": False}}))
        self.assertIn("tiny meshes", page({"5.13.2": {**RUN, "quick": True}}))
        self.assertIn("do not quote", page({"5.13.2": NOT_OPTIMIZED}))

    def test_compare(self):
        """A second run names what moved by more than the spread, and nothing else."""
        self.assertEqual(compare(RUN, RUN), [])
        self.assertEqual(compare(RUN, changed(1.04, "vtkPLYReader"))[1:], [])
        lines = compare(RUN, changed(1.3, OURS))
        self.assertIn(
            "open a file, 1,000 triangles, binary PLY, Camarón: 10.0 ms -> 13.0 ms (+30 %)", lines
        )
        self.assertEqual(len(lines), 3)

    def test_compare_machines(self):
        """On another machine times differ, and ratios should not."""
        other = {"machine": {**RUN["machine"], "processor": "Bar"}}
        twice = changed(2, OURS, **other)
        self.assertIn(
            "open a file, 1,000 triangles, binary PLY, beside vtkPLYReader: 20.00 × -> 10.00 ×",
            compare(RUN, twice),
        )
        for row in twice["records"]:
            if row["by"] != OURS:
                row["times"] = [[2 * wall, core] for wall, core in row["times"]]
        self.assertEqual(compare(RUN, twice), [])

    def test_readme(self):
        """The README has the rows of the newest ParaView that was compiled fairly, and the rest of it stays."""
        text = (camaron_testing.ROOT / "README.md").read_text(encoding="utf-8")
        once = readme(text, {"5.13.2": RUN, "6.1.1": changed(2, "vtkPLYReader")})
        self.assertIn("beside ParaView 6.1.1", once)
        self.assertIn("| vtkPLYReader: 400 ms ±5 % | 40.0 × |", once)
        self.assertEqual(readme(once, {"5.13.2": RUN}), readme(text, {"5.13.2": RUN}))
        self.assertIn("## In Python", once)
        fair = readme(text, {"5.13.2": RUN, "6.1.1": NOT_OPTIMIZED})
        self.assertIn("beside ParaView 5.13.2", fair)
        self.assertEqual(len([row for row in TABLE if row.is_in_readme]), 3)

    def test_stored(self):
        """What is stored is what the next run compares with."""
        results = {"5.13.2": RUN, "6.1.1": RUN}
        text = as_json(results)
        self.assertEqual(json.loads(text), results)
        self.assertEqual(text.count('\n{"work"'), 2 * len(RUN["records"]))

    def test_programs(self):
        """A benchmark that was renamed would fail the report after an hour."""
        folder = camaron_testing.ROOT / "Testing" / "Benchmarks"
        for name, _, _ in RUNS:
            self.assertTrue(list(folder.glob(f"Benchmark{name}.*")), name)
        keys = [(row.work, row.mesh) for row in TABLE]
        self.assertEqual(len(keys), len(set(keys)))


if __name__ == "__main__":
    camaron_testing.main()
