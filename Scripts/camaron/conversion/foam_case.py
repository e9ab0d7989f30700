# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's OpenFOAM reader leaves out of the mesh of a case: the digits of the coordinates, cell and face zones,
and the types of patches."""

from __future__ import annotations

import gzip
import os
import re
import tempfile
from pathlib import Path
from typing import Any, Iterator, NamedTuple

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_POLYGON, VTK_QUAD, VTK_TRIANGLE, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

#: Fluent's types of zones, which vtkPolyMeshWriter writes as groups.
FLUENT_TYPES = set(
    "fluid solid interior wall pressure-inlet inlet-vent intake-fan pressure-outlet exhaust-fan outlet-vent symmetry "
    "shadow pressure-far-field velocity-inlet periodic porous-jump fan radiator mass-flow-inlet interface overset "
    "outflow axis".split()
)
#: Those that OpenFOAM's types of patches are.
OF_PATCHES = {"wall": "wall", "symmetry": "symmetry", "symmetryPlane": "symmetry"}
#: Before the first list of a file: blanks and comments; then its size.
SIZE = re.compile(rb"(?:\s|//[^\n]*\n|/\*.*?\*/)*(\d+)\s*([({])?", re.S)
#: A dictionary of a boundary, and one of a zone up to its labels.
PATCH = re.compile(rb'([^\s(){};"]+|"[^"]*")\s*\{([^{}]*)\}')
ZONE = re.compile(
    rb'([^\s(){};"]+|"[^"]*")\s*\{([^{}]*?)(?:cell|face)Labels\s+(?:List<label>)?\s*(\d*)\s*([({;])'
)
FLAGS = re.compile(rb"\)\s*;\s*flipMap\s+(?:List<bool>)?\s*(\d+)\s*\(")
GROUPS = re.compile(rb"\binGroups\s[^;(]*\(([^)]*)\)")
#: Bytes that numpy takes for blanks.
BLANKS = bytes.maketrans(b"()", b"  ")


class Zone(NamedTuple):
    """Some cells or faces of the mesh; a zone of faces without any is the one of all others between cells."""

    name: str
    type: str
    ids: numpy.ndarray


def restore(source: Any, beside: Path) -> Any:
    """A source with the mesh of an updated OpenFOAMReader: its cells with exact coordinates, their zones, and the faces of
    patches and of zones as 2D cells. It is read from a file, meanwhile in the folder `beside`, as only the first rank
    has the mesh. Raises an error if the files of the case are not as expected."""
    with tempfile.TemporaryDirectory(prefix=".camaron-", dir=beside) as folder:
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(os.path.join(folder, "mesh.vtu"))
        writer.SetInputData(_make_grid(source))
        writer.SetHeaderTypeToUInt64()
        writer.SetCompressorTypeToNone()
        writer.EncodeAppendedDataOff()
        if not writer.Write():
            raise OSError("its mesh cannot be copied")
        restored = simple.XMLUnstructuredGridReader(FileName=[writer.GetFileName()])
        restored.UpdatePipeline()
    return restored


def has_one_mesh(source: Any) -> bool:
    """Whether the case of an OpenFOAMReader has one mesh that does not change."""
    folder = Path(source.FileName).parent
    return (
        "Reconstructed" in str(source.CaseType)
        and "internalMesh" in source.GetProperty("MeshRegions").Available
        and not any(folder.glob("[0-9]*/polyMesh/*"))
    )


def _make_grid(source: Any) -> vtkUnstructuredGrid:
    """The cells of an OpenFOAMReader with what the files of the mesh have besides."""
    grid = vtkUnstructuredGrid()
    blocks = source.GetClientSideObject().GetOutputDataObject(0)
    grid.DeepCopy(blocks.GetBlock(0))
    mesh = _Mesh(Path(source.FileName).parent / "constant" / "polyMesh")
    points, cells = mesh.points(), mesh.count_cells()
    if (len(points), cells) != (grid.GetNumberOfPoints(), grid.GetNumberOfCells()):
        raise ValueError("ParaView's reader finds other numbers of points or cells")
    exact = vtkPoints()
    exact.SetData(numpy_to_vtk(points, deep=True))
    grid.SetPoints(exact)
    cell_zones, face_zones = list(mesh.zones("cellZones")), list(mesh.zones("faceZones"))
    face_zones += mesh.patches()
    zones = numpy.zeros(cells + sum(len(zone.ids) for zone in face_zones), numpy.int32)
    for number, zone in enumerate(cell_zones, 1):
        zones[:cells][zone.ids] = number
    begins, nodes = mesh.faces()
    is_taken = numpy.zeros(len(begins) - 1, bool)
    types = {3: VTK_TRIANGLE, 4: VTK_QUAD}
    named = [*enumerate(cell_zones + face_zones, 1)]
    # Patches first: a face that zones have as well is theirs.
    for number, zone in reversed(named[len(cell_zones) :]):
        free = zone.ids[~is_taken[zone.ids]]
        if len(zone.ids) > 0 and len(free) == 0:
            named = [one for one in named if one[0] != number]
        for face in free.tolist():
            ring = nodes[begins[face] : begins[face + 1]].tolist()
            cell = grid.InsertNextCell(types.get(len(ring), VTK_POLYGON), len(ring), ring)
            zones[cell] = number
        is_taken[zone.ids] = True
    zones = zones[: grid.GetNumberOfCells()]
    grid.GetFieldData().RemoveArray("CasePath")  # of the reader
    _extend(grid)
    _add(grid.GetCellData(), "Zone", zones)
    _add(grid.GetFieldData(), "ZoneIds", [number for number, _ in named])
    _add(grid.GetFieldData(), "ZoneNames", [zone.name for _, zone in named])
    _add(grid.GetFieldData(), "ZoneTypes", [zone.type for _, zone in named])
    return grid


def _extend(grid: Any) -> None:
    """Gives the arrays of the cells zeros for those that were added."""
    data = grid.GetCellData()
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        before = array.GetNumberOfTuples()
        array.Resize(grid.GetNumberOfCells())
        array.SetNumberOfTuples(grid.GetNumberOfCells())
        if array.IsNumeric():
            vtk_to_numpy(array)[before:] = 0


def _add(data: Any, name: str, values: Any) -> None:
    """Adds an array of integers or words."""
    if len(values) and isinstance(values[0], str):
        array = vtkStringArray()
        for value in values:
            array.InsertNextValue(value)
    else:
        array = numpy_to_vtk(numpy.array(values, numpy.int32), deep=True)
    array.SetName(name)
    data.AddArray(array)


class _Mesh:
    """The files in constant/polyMesh."""

    def __init__(self, folder: Path):
        self._folder = folder

    def points(self) -> numpy.ndarray:
        body, is_binary, _, real = self._open("points")
        return self._list(body, is_binary, real, 3)[0].astype(float).reshape(-1, 3)

    def count_cells(self) -> int:
        sides = (self._open(name) for name in ("owner", "neighbour"))
        lists = [self._list(body, is_binary, label)[0] for body, is_binary, label, _ in sides]
        return 1 + max(int(labels.max(initial=-1)) for labels in lists)

    def faces(self) -> tuple[numpy.ndarray, numpy.ndarray]:
        """Where the points of each face begin, and the end; and the points of all."""
        body, is_binary, label, _ = self._open("faces")
        if is_binary:
            begins, end = self._list(body, True, label)
            return begins, self._list(body[end:], True, label)[0]
        numbers = self._list(body, False, label)[0]  # of points of each face, then these
        starts = numpy.zeros(int(SIZE.match(body)[1]) + 1, int)
        for face in range(len(starts) - 1):
            starts[face + 1] = starts[face] + 1 + numbers[starts[face]]
        return starts - numpy.arange(len(starts)), numpy.delete(numbers, starts[:-1])

    def patches(self) -> list[Zone]:
        body = self._open("boundary")[0]
        found = []
        for name, entries in PATCH.findall(re.sub(rb"//[^\n]*|/\*.*?\*/", b"", body, flags=re.S)):
            entry = dict(re.findall(rb"(\w+)\s+([^;]*?)\s*;", entries))
            begin, count = int(entry[b"startFace"]), int(entry[b"nFaces"])
            usual = OF_PATCHES.get(entry[b"type"].decode(), "")
            ids = numpy.arange(begin, begin + count)
            found.append(Zone(_word(name), _type(entries, usual, name), ids))
        return found

    def zones(self, name: str) -> Iterator[Zone]:
        if not any((self._folder / file).exists() for file in (name, f"{name}.gz")):
            return
        body, is_binary, label, _ = self._open(name)
        at = 0
        while match := ZONE.search(body, at):
            end = at = match.end()
            ids = numpy.zeros(0, int)
            if is_binary and match[4] == b"(":
                ids = numpy.frombuffer(body, label, int(match[3]), end)
                at = end + ids.nbytes
                flags = FLAGS.match(body, at)  # of a byte each, which are no words
                at = flags.end() + int(flags[1]) if flags else at
            elif match[3] != b"0":
                at = body.index(b")" if match[4] == b"(" else b"}", end)
                ids = numpy.fromstring(body[end:at], int, sep=" ")
            usual = "fluid" if name == "cellZones" else "interior"
            yield Zone(_word(match[1]), _type(match[2], usual), ids)

    def _open(self, name: str) -> tuple[bytes, bool, str, str]:
        """What is behind the header of a file, whether it is binary, and numpy's types of its labels and reals."""
        path = self._folder / name
        content = path.read_bytes() if path.exists() else gzip.open(f"{path}.gz").read()
        header = re.search(rb"FoamFile\s*\{.*?\}", content, re.S)
        if not header:
            raise ValueError(f"{name}: expected FoamFile, found none")
        order = ">" if b"MSB" in header[0] else "<"
        label = "i8" if b"label=64" in header[0] else "i4"
        real = "f4" if b"scalar=32" in header[0] else "f8"
        is_binary = bool(re.search(rb"\bformat\s+binary\s*;", header[0]))
        return content[header.end() :], is_binary, order + label, order + real

    def _list(
        self, body: bytes, is_binary: bool, kind: str, columns: int = 1
    ) -> tuple[numpy.ndarray, int]:
        """The numbers of a list, and where it ends."""
        size = SIZE.match(body)
        count = int(size[1]) * columns if size else 0
        if not count or not size[2]:
            return numpy.zeros(0, kind), size.end() if size else 0
        if is_binary:
            return (
                numpy.frombuffer(body, kind, count, size.end()),
                size.end() + count * int(kind[2]) + 1,
            )
        is_uniform = size[2] == b"{"
        end = body.index(b"}") if is_uniform else body.rindex(b")")
        words = body[size.end() : end].translate(BLANKS)
        numbers = numpy.fromstring(words, float if "f" in kind else kind[1:], sep=" ")
        return numpy.full(count, numbers) if is_uniform else numbers, end + 1


def _word(name: bytes) -> str:
    return name.decode(errors="replace").strip('"')


def _type(entries: bytes, usual: str, name: bytes = b"") -> str:
    """Fluent's type of a zone or patch: the one among its groups, or its name, that is one; else the usual one of
    OpenFOAM's type."""
    groups = GROUPS.search(entries)
    words = [word.decode(errors="replace") for word in (groups[1].split() if groups else [])]
    own = [word for word in words if word in FLUENT_TYPES]
    return next(iter(own), usual or (_word(name) if _word(name) in FLUENT_TYPES else ""))
