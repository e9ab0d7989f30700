# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Memory and time of reading, evaluating and drawing large meshes on several ranks, as one table.

Usage: BenchmarkRanks [--ranks 1,2,4,8] [--size FACTOR] [--until STEP] [--folder FOLDER] [FILE...]

Without files it makes meshes: tetrahedra and triangles in random order, and polyhedra, in three formats. It keeps them in
FOLDER if given. Every run is a pvbatch on the ranks, one thread each. Memory is the peak of the rank that needs most, with
the pages of the file that it has touched; cells are counted with ghosts. The step glass draws the glass shell, which
ParaView takes long for.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SIZES = {"polyhedra": 1e6, "tetrahedra": 3.5e6, "triangles": 5e6}
FILES = (
    ("polyhedra", "visf"),
    ("polyhedra", "msh"),
    ("tetrahedra", "visf"),
    ("tetrahedra", "msh"),
    ("triangles", "ply"),
)
STEPS = ("read", "evaluate", "draw", "glass")
SIZE = [800, 600]


def peak():
    """The most memory this process has needed so far, in MB."""
    with open("/proc/self/status") as file:
        return next(int(line.split()[1]) // 1024 for line in file if line.startswith("VmHWM"))


def measure(path, out, *steps):
    """On every rank of pvbatch --sym: writes what it measures to the file OUT.RANK."""
    from paraview import simple
    from vtkmodules.vtkParallelCore import vtkMultiProcessController

    from camaron.common import pipeline

    pipeline.load_plugin()
    ranks = vtkMultiProcessController.GetGlobalController()
    found = {"idle MB": peak()}

    def step(name, work):
        ranks.Barrier()
        start = time.perf_counter()
        result = work()
        ranks.Barrier()
        found[f"{name} s"] = time.perf_counter() - start
        found[f"{name} MB"] = peak()
        return result

    def output(proxy):
        return proxy.GetClientSideObject().GetOutputDataObject(0)

    def read():
        reader = simple.OpenDataFile(path)
        reader.UpdatePipeline()
        return reader

    def evaluate():
        quality = simple.ElementQuality(Input=reader, Preset="General")
        quality.UpdatePipeline()
        return quality

    def draw():
        view = simple.CreateRenderView(ViewSize=SIZE, OrientationAxesVisibility=0)
        display = simple.Show(quality, view)
        display.SetRepresentationType("Mesh Inspection")
        view.ResetCamera()
        simple.Render(view)
        return view, display

    def glass():
        view, display = drawn
        display.GlassShell = 1
        simple.Render(view)

    reader = step("read", read)
    if "evaluate" in steps:
        quality = step("evaluate", evaluate)
    if "draw" in steps:
        drawn = step("draw", draw)
    if "glass" in steps:
        step("glass", glass)
    found["cells"] = output(reader).GetNumberOfCells()
    Path(f"{out}.{ranks.GetLocalProcessId()}").write_text(json.dumps(found))
    ranks.Barrier()
    sys.stdout.flush()
    os._exit(0)  # pvbatch can hang while it closes


def run(path, ranks, folder, steps):
    """What every rank has measured."""
    out = os.path.join(folder, "measured")
    environment = dict(os.environ, VTK_SMP_MAX_THREADS="1")
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    environment.update(OMPI_MCA_rmaps_base_oversubscribe="1")
    package = str(Path(__file__).resolve().parents[2] / "Scripts")
    environment["PYTHONPATH"] = os.pathsep.join(
        filter(None, (package, environment.get("PYTHONPATH")))
    )
    command = ["mpiexec", "-n", str(ranks), "pvbatch", "--sym", __file__, "--measure", path, out]
    command += steps
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    files = [Path(f"{out}.{rank}") for rank in range(ranks)]
    if not all(file.exists() for file in files):
        sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
    found = [json.loads(file.read_text()) for file in files]
    for file in files:
        file.unlink()
    return found


def make_meshes(make, size, folder):
    """Paths of the meshes; those that exist are not made again."""
    paths = []
    for kind, suffix in FILES:
        source, path = Path(folder, f"{kind}.visf"), Path(folder, f"{kind}.{suffix}")
        if not source.exists():
            subprocess.run([make, kind, str(int(SIZES[kind] * size)), source], check=True)
        if not path.exists():
            subprocess.run(["pvpython", __file__, "--convert", source, path], check=True)
        paths.append(path)
    return paths


def convert(source, path):
    from paraview import simple

    from camaron.common import pipeline

    pipeline.load_plugin()
    simple.SaveData(path, simple.OpenDataFile(source))
    sys.stdout.flush()
    os._exit(0)


def print_table(paths, counts, folder, steps):
    print(
        f"{'mesh':<18s} {'ranks':>5s} {'cells':>9s} {'largest':>9s} {'idle MB':>7s}"
        + "".join(f" {step + ' MB':>11s}" for step in steps)
        + "".join(f" {step + ' s':>10s}" for step in steps)
    )
    for path in paths:
        for ranks in counts:
            found = run(str(path), ranks, folder, steps)
            cells = [of["cells"] for of in found]
            most = {key: max(of[key] for of in found) for key in found[0]}
            print(
                f"{Path(path).name:<18s} {ranks:5d} {sum(cells):9d} {max(cells):9d}"
                f" {most['idle MB']:7d}"
                + "".join(f" {most[step + ' MB']:11d}" for step in steps)
                + "".join(f" {most[step + ' s']:10.2f}" for step in steps),
                flush=True,
            )


def main():
    if sys.argv[1:2] == ["--measure"]:
        measure(*sys.argv[2:])
    if sys.argv[1:2] == ["--convert"]:
        convert(*sys.argv[2:])
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("make", help="the program MakeMesh")
    parser.add_argument("files", nargs="*", help="meshes to read instead of those it makes")
    parser.add_argument("--ranks", default="1,2,4,8")
    parser.add_argument("--size", type=float, default=1, help="of the meshes, as a factor")
    parser.add_argument("--until", choices=STEPS, default="draw", help="the last step")
    parser.add_argument("--folder", help="where meshes are kept")
    options = parser.parse_args()
    counts = [int(count) for count in options.ranks.split(",")]
    with tempfile.TemporaryDirectory() as scratch:
        kept = options.folder or scratch
        os.makedirs(kept, exist_ok=True)
        paths = options.files or make_meshes(options.make, options.size, kept)
        print_table(paths, counts, scratch, STEPS[: STEPS.index(options.until) + 1])


main()
