# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of benchmarks: what is measured, and what it should come to."""

import dataclasses
from typing import Callable, Tuple

#: Benchmarks with their arguments: sizes in millions of cells, as they are reported and for --quick.
RUNS = (
    ("Visf", (3.5, 1), (0.02, 0.0005)),
    ("Formats", (), (0.01, 0.02)),
    ("PolygonOFF", (1.65,), (0.01,)),
    ("Core", (3.5, 1), (0.02, 0.0005)),
    ("Statistics", (4,), (0.02,)),
    ("Selection", (3.5, 0.2), (0.02, 0.0005)),
    ("Scaling", (1,), (0.01,)),
    ("CheckMesh", (0.1,), (0.001,)),
    ("OtherPrograms", (0.1,), (0.001,)),
    ("Inspection", (1, 1), (0.005, 0.0005)),
)
#: The same for pictures on a graphics card.
PICTURE_RUNS = (
    ("Inspection", (1, 1), (0.005, 0.0005)),
    ("Inspection", (10, 0), (0.02, 0)),
)


@dataclasses.dataclass(frozen=True)
class Figures:
    """What one record says."""

    by: str
    cells: int
    runs: int
    wall: float  # seconds, the median
    spread: float  # from the shortest to the longest run, in seconds
    core: float  # seconds of all threads together, in the median run
    peak: float  # bytes of memory while it ran
    size: float  # bytes of the result

    @staticmethod
    def of(record):
        times = sorted(record["times"])
        wall, core = times[len(times) // 2]
        return Figures(
            by=record["by"],
            cells=record["cells"],
            runs=len(times),
            wall=wall,
            spread=times[-1][0] - times[0][0],
            core=core,
            peak=record.get("peak", 0),
            size=record.get("size", 0),
        )

    def per_cell(self):
        return self.wall / self.cells


@dataclasses.dataclass(frozen=True)
class Target:
    text: str
    #: Whether our figures meet it, beside those of a peer.
    is_met: Callable
    needs_peer: bool = False


def faster(times, text="{:g} times as fast"):
    return Target(
        text.format(times), lambda ours, peer: peer.per_cell() >= times * ours.per_cell(), True
    )


def takes_at_most(times, text):
    """Of the peer's time per cell."""
    return Target(text, lambda ours, peer: ours.per_cell() <= times * peer.per_cell(), True)


def seconds(limit):
    return Target(f"{limit:g} s", lambda ours, peer: ours.wall <= limit)


def core_time(nanoseconds):
    text = f"{nanoseconds:g} ns" if nanoseconds < 1000 else f"{nanoseconds / 1000:g} µs"
    return Target(
        f"{text} per cell and core", lambda ours, peer: 1e9 * ours.core <= nanoseconds * ours.cells
    )


def peak_of_meshes(limit):
    return Target(f"peak {limit:g} × the mesh", lambda ours, peer: ours.peak <= limit * ours.size)


def peak_per_cell(limit):
    return Target(
        f"peak {limit:,g} bytes per cell", lambda ours, peer: ours.peak <= limit * ours.cells
    )


def bytes_per_cell(limit):
    return Target(
        f"mesh of {limit:g} bytes per cell", lambda ours, peer: ours.size <= limit * ours.cells
    )


@dataclasses.dataclass(frozen=True)
class Row:
    """Records with this work and mesh: ours, and those of peers."""

    work: str
    mesh: str
    targets: Tuple[Target, ...] = ()
    is_per_cell: bool = False
    is_in_readme: bool = False


def per_cell(work, mesh, *targets, **more):
    return Row(work, mesh, targets, True, **more)


def whole(work, mesh, *targets, **more):
    return Row(work, mesh, targets, False, **more)


#: What the machine itself can do, in the words of BenchmarkScaling, whose cells are then bytes.
MACHINE = (
    "copy memory",
    "write to new memory",
    "write to new memory, huge pages",
    "read a mapped file",
)
VISF = "open a binary Visf file"
PICTURES = (
    whole("first picture, with reading", "tetrahedra"),
    whole("first picture, with reading", "polyhedra", seconds(3), is_in_readme=True),
    whole("first picture, without reading", "tetrahedra"),
    whole("first picture, without reading", "polyhedra"),
    whole("camera moves", "tetrahedra", faster(1, "as fast")),
    whole("camera moves", "polyhedra", faster(1, "as fast")),
    whole("camera moves, without edges", "tetrahedra", faster(1, "as fast")),
    whole("camera moves, without edges", "polyhedra", faster(1, "as fast")),
    whole("camera moves, ids of points and cells", "tetrahedra"),
    whole("camera moves, ids of points and cells", "polyhedra"),
    whole("cells in a rectangle are picked", "tetrahedra"),
    whole("cells in a rectangle are picked", "polyhedra"),
    whole("camera moves, glass", "tetrahedra"),
    whole("camera moves, glass", "polyhedra"),
    whole("sphere moves, whole cells by vertex", "tetrahedra", faster(1, "as fast")),
    whole("sphere moves, whole cells by vertex", "polyhedra", faster(1, "as fast")),
    whole("sphere moves, exact cut", "tetrahedra"),
    whole("sphere moves, exact cut", "polyhedra"),
    whole("3 isosurfaces, other values", "tetrahedra"),
    whole("3 isosurfaces, other values", "polyhedra", core_time(300)),
)
#: In the order of the page.
TABLE = (
    whole(VISF, "tetrahedra", takes_at_most(2, "2 × the .vtu"), peak_of_meshes(1.3)),
    whole(
        VISF,
        "polyhedra",
        takes_at_most(1 / 3, "1/3 of the .vtu"),
        peak_per_cell(1300),
        bytes_per_cell(900),
    ),
    whole("open a file", "triangles, binary PLY", faster(15), is_in_readme=True),
    whole("open a file", "triangles, text OFF", seconds(0.15)),
    whole("open a file", "triangles, TRI", seconds(0.15)),
    per_cell("open a file of 100,000 cells", "triangles, .ply"),
    per_cell("open a file of 100,000 cells", "triangles, .off"),
    per_cell("open a file of 100,000 cells", "tetrahedra, .ele"),
    per_cell("unique faces and neighbors", "tetrahedra", faster(8)),
    per_cell("boundary, faces not known", "polyhedra", core_time(2000)),
    per_cell("boundary, faces known", "polyhedra", core_time(300)),
    per_cell("EdgeLengthRatio", "tetrahedra", core_time(15)),
    per_cell("TetRadiusRatio", "tetrahedra", core_time(15)),
    per_cell("TetRadiusRatio of 100,000 cells", "tetrahedra"),
    per_cell("MinJacobian of 100,000 cells", "quadratic tetrahedra", core_time(1500)),
    per_cell("21 core criteria", "tetrahedra", core_time(600)),
    per_cell("Volume and SurfaceArea", "polyhedra", core_time(500)),
    per_cell("9 criteria of the paper", "polyhedra", core_time(4000)),
    per_cell("6 finite-volume criteria", "polyhedra", core_time(2000)),
    per_cell("what checkMesh checks", "polyhedra", core_time(2000), is_in_readme=True),
    per_cell("what checkMesh -allGeometry checks", "polyhedra"),
    per_cell("histogram of 50 bins, one thread", "normal values", core_time(2)),
    per_cell("9 quantiles, one thread", "normal values", core_time(20)),
    per_cell("Any vertex inside", "tetrahedra", core_time(100)),
    per_cell("Any vertex inside", "polyhedra", core_time(100)),
    *PICTURES,
    *(
        per_cell(f"{work}, {threads}", "polyhedra", *targets)
        for work in ("open a text Visf file", "find faces", "evaluate General")
        for threads, targets in (
            ("2 threads", [faster(1.8)]),
            ("1 thread", [takes_at_most(2, "2 × that of 1 % of the cells")]),
        )
    ),
)
