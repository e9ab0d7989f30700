# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finite-volume criteria against OpenFOAM's checkMesh, where it is installed."""

import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import camaron_testing
import mesh_parts
import numpy
from camaron import tables
from camaron_testing import EXAMPLES
from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import VTK_WEDGE
from vtkmodules.util.numpy_support import vtk_to_numpy

CHECK_MESH = shutil.which("checkMesh")
CRITERIA = [
    "Volume",
    "CellAspectRatio",
    "MaxNonOrthogonality",
    "MaxFaceSkewness",
    "MinFaceWeight",
    "MinVolumeRatio",
    "CellDeterminant",
    "MinFaceFlatness",
    "Openness",
]
HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
#: What checkMesh prints, by criterion: which end of it, and the text before the number.
PRINTED = {
    "MaxNonOrthogonality": (max, r"non-orthogonality Max: "),
    "MaxFaceSkewness": (max, r"Max skewness = "),
    "CellAspectRatio": (max, r"Max aspect ratio = "),
    "MinFaceWeight": (min, r"Face interpolation weight : minimum: "),
    "MinVolumeRatio": (min, r"Face volume ratio : minimum: "),
    "CellDeterminant": (min, r"Cell determinant \(wellposedness\) : minimum: "),
    "MinFaceFlatness": (min, r"Face flatness \(1 = flat, 0 = butterfly\) : min = "),
    "Volume": (min, r"Min volume = "),
}

#: Entries of OpenFOAM's dictionary of limits by criterion.
LIMITS = {
    "MaxFaceSkewness": "maxInternalSkewness",
    "MaxFaceConcavity": "maxConcave",
    "MinTetQuality": "minTetQuality",
    "MinFaceWeight": "minFaceWeight",
    "MinVolumeRatio": "minVolRatio",
    "CellDeterminant": "minDeterminant",
}
DICTIONARY = Path("/usr/share/openfoam/etc/caseDicts/meshQualityDict")


def write_case(folder, faces):
    """An OpenFOAM case of faces as MeshElements gives them."""
    points = vtk_to_numpy(faces.GetPoints().GetData())
    data = faces.GetCellData()
    owner = vtk_to_numpy(data.GetArray("OwnerCell"))
    neighbor = vtk_to_numpy(data.GetArray("NeighborCell"))
    polygons = faces.GetPolys()
    offsets = vtk_to_numpy(polygons.GetOffsetsArray())
    ids = vtk_to_numpy(polygons.GetConnectivityArray())
    inner = numpy.flatnonzero(neighbor >= 0)
    inner = inner[numpy.lexsort((neighbor[inner], owner[inner]))]
    order = numpy.concatenate([inner, numpy.flatnonzero(neighbor < 0)])
    mesh = folder / "constant" / "polyMesh"
    mesh.mkdir(parents=True)
    (folder / "system").mkdir()

    def write(name, kind, rows):
        text = "\n".join([str(len(rows)), "(", *rows, ")", ""])
        (mesh / name).write_text(HEADER.format(kind, name) + text)

    write("points", "vectorField", [f"({x!r} {y!r} {z!r})" for x, y, z in points.tolist()])
    rows = [ids[offsets[f] : offsets[f + 1]] for f in order]
    write("faces", "faceList", [f"{len(r)}({' '.join(map(str, r))})" for r in rows])
    write("owner", "labelList", [str(o) for o in owner[order]])
    write("neighbour", "labelList", [str(n) for n in neighbor[inner]])
    walls = f"walls {{ type wall; nFaces {len(order) - len(inner)}; startFace {len(inner)}; }}"
    write("boundary", "polyBoundaryMesh", [walls])
    for name in ("fvSchemes", "fvSolution"):
        entries = "gradSchemes {} divSchemes {} laplacianSchemes {}\n" * (name == "fvSchemes")
        (folder / "system" / name).write_text(HEADER.format("dictionary", name) + entries)
    (folder / "system" / "controlDict").write_text(
        HEADER.format("dictionary", "controlDict")
        + "application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;"
        " writeControl timeStep; writeInterval 1; writePrecision 12;\n"
    )


class TestCheckMesh(camaron_testing.TestCase):
    def compare(self, source, tolerance):
        """Worst values of all cells are those that checkMesh prints, to the digits it prints."""
        faces = servermanager.Fetch(simple.MeshElements(Input=source, FaceArrays=["OwnerCell", "NeighborCell"]), idx=0)
        case = self.folder / "case"
        write_case(case, faces)
        run = subprocess.run(
            [CHECK_MESH, "-allGeometry", "-allTopology", "-noFunctionObjects", "-case", str(case)],
            capture_output=True,
            text=True,
            timeout=120,
            env={"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ, "FOAM_SIGFPE": "false"},
        )
        printed = run.stdout
        self.assertIn("Mesh stats", printed, run.stderr)
        cells = self.fetch(simple.ElementQuality(Input=source, Criteria=CRITERIA)).GetCellData()
        values = {name: vtk_to_numpy(cells.GetArray(name)) for name in CRITERIA}
        for name, (worst, before) in PRINTED.items():
            found = re.search(before + r"([-+.0-9e]+?)[.]?[\s,]", printed)
            self.assertIsNotNone(found, f"{name}\n{printed}")
            theirs = float(found.group(1))
            ours = float(worst(values[name][~numpy.isnan(values[name])]))
            delta = tolerance * abs(theirs) + 1e-12
            self.assertAlmostEqual(ours, theirs, delta=delta, msg=name)
        total = float(re.search(r"Total volume = ([-+.0-9e]+?)\.\s", printed).group(1))
        self.assertAlmostEqual(values["Volume"].sum() / total, 1.0, delta=tolerance)
        self.assertLess(values["Openness"].max(), 1e-6)

    @unittest.skipUnless(DICTIONARY.exists(), "OpenFOAM's dictionaries are elsewhere")
    def test_limits_are_openfoams(self):
        """The preset and the registry have the limits of the dictionary that comes with OpenFOAM."""
        entries = dict(re.findall(r"^(\w+)\s+(\S+);", DICTIONARY.read_text(), re.MULTILINE))
        rules = tables.known_presets()["Finite volume"]["rules"]
        known = tables.known_criteria()
        for name, entry in LIMITS.items():
            limit = float(entries[entry])
            self.assertIn(limit, rules[name], name)
            self.assertIn(limit, known[name]["acceptable"], name)
        limit = float(entries["maxNonOrtho"])
        self.assertIn(limit, known["MaxNonOrthogonality"]["acceptable"])

    def test_voronoi(self):
        self.compare(simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf")), 1e-4)

    def test_mixed(self):
        """Hexahedra, wedges and tetrahedra with planar faces; checkMesh treats warped ones otherwise."""
        mesh = mesh_parts.make_mesh()
        offsets = vtk_to_numpy(mesh.GetCells().GetOffsetsArray())[:-1]
        ids = vtk_to_numpy(mesh.GetCells().GetConnectivityArray())
        wedges = offsets[vtk_to_numpy(mesh.GetCellTypesArray()) == VTK_WEDGE]
        for a, b in ((1, 2), (4, 5)):  # extrusions, which are inside out for VTK
            ids[wedges + a], ids[wedges + b] = ids[wedges + b], ids[wedges + a]
        x = vtk_to_numpy(mesh.GetPoints().GetData())
        x += 0.03 * x**2  # planes of an axis stay planes
        x[:, 0] += 0.4 * x[:, 1] - 0.2 * x[:, 2]
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(mesh)
        self.compare(source, 1e-4)


if __name__ == "__main__":
    if not CHECK_MESH:
        print("skipped: OpenFOAM's checkMesh is not installed")
        sys.exit(camaron_testing.SKIPPED)
    camaron_testing.main()
