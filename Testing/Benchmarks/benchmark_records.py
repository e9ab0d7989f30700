# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What benchmarks in Python tell report.py; BenchmarkCost.h is the same for those in C++."""

import json
import os
import time

#: Our name in records; every other name is that of a peer.
OURS = "Camarón"
REPETITIONS = 5
ENOUGH = 60
#: Cells of meshes for peers that take minutes for a million.
CELLS_FOR_SLOW_PEERS = 100_000


def repeat(work):
    """Wall and processor time of work(part) for five parts up to 1; of fewer once they have taken a minute."""
    times = []
    while len(times) < REPETITIONS and sum(wall for wall, _ in times) < ENOUGH:
        wall, processor = time.perf_counter(), time.process_time()
        work((len(times) + 1) / REPETITIONS)
        times.append((time.perf_counter() - wall, time.process_time() - processor))
    return sorted(times)


def median(times):
    """The median wall time."""
    return times[len(times) // 2][0]


def record(work, mesh, by, cells, times, **more):
    """Adds a measurement to the file that CAMARON_BENCHMARK_RECORDS names, if it does."""
    path = os.environ.get("CAMARON_BENCHMARK_RECORDS")
    if not path:
        return
    from vtkmodules.vtkCommonCore import vtkSMPTools, vtkVersion

    row = {
        "work": work,
        "mesh": mesh,
        "by": by,
        "cells": cells,
        "threads": vtkSMPTools.GetEstimatedNumberOfThreads(),
        "backend": vtkSMPTools.GetBackend(),
        "vtk": vtkVersion.GetVTKVersion(),
        "times": [[float(f"{wall:.4g}"), float(f"{core:.4g}")] for wall, core in times],
        **more,
    }
    with open(path, "a", encoding="utf-8") as file:
        file.write(json.dumps(row, ensure_ascii=False) + "\n")
