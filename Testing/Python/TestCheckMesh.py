# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finite-volume criteria against OpenFOAM's checkMesh, where it is installed."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

import camaron_testing
import mesh_parts
import numpy
import openfoam_case
from camaron.common import tables
from camaron_testing import EXAMPLES
from paraview import simple
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, VTK_WEDGE
from vtkmodules.util.numpy_support import vtk_to_numpy

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
#: What checkMesh prints: the criterion, which end of it, and the text before the number.
PRINTED = [
    ("MaxNonOrthogonality", max, r"non-orthogonality Max: "),
    ("MaxFaceSkewness", max, r"Max skewness = "),
    ("CellAspectRatio", max, r"Max aspect ratio = "),
    ("MinFaceWeight", min, r"Face interpolation weight : minimum: "),
    ("MinVolumeRatio", min, r"Face volume ratio : minimum: "),
    ("CellDeterminant", min, r"Cell determinant \(wellposedness\) : minimum: "),
    ("MinFaceFlatness", min, r"Face flatness \(1 = flat, 0 = butterfly\) : min = "),
    ("Volume", min, r"Min volume = "),
    ("Volume", max, r"Max volume = "),
    ("Openness", max, r"Max cell openness = "),
]
#: Of closed cells openness is what rounding leaves, and not the same in both programs.
ROUNDING = 1e-12

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


class TestCheckMesh(camaron_testing.TestCase):
    def compare(self, source, tolerance):
        """Worst values of all cells are those that checkMesh prints, to the case's 12 digits."""
        case = self.folder / "case"
        openfoam_case.write(case, source)
        run = subprocess.run(
            openfoam_case.check_mesh(case, "-allGeometry", "-allTopology"),
            capture_output=True,
            text=True,
            timeout=120,
            env=openfoam_case.environment(),
        )
        printed = run.stdout
        self.assertIn("Mesh stats", printed, run.stderr)
        cells = self.fetch(simple.ElementQuality(Input=source, Criteria=CRITERIA)).GetCellData()
        values = {name: vtk_to_numpy(cells.GetArray(name)) for name in CRITERIA}
        for name, worst, before in PRINTED:
            found = re.search(before + r"([-+.0-9e]+?)[.]?[\s,]", printed)
            self.assertIsNotNone(found, f"{before}\n{printed}")
            theirs = float(found.group(1))
            ours = float(worst(values[name][~numpy.isnan(values[name])]))
            delta = tolerance * abs(theirs) + ROUNDING
            self.assertAlmostEqual(ours, theirs, delta=delta, msg=before)
        total = float(re.search(r"Total volume = ([-+.0-9e]+?)\.\s", printed).group(1))
        self.assertAlmostEqual(values["Volume"].sum() / total, 1.0, delta=tolerance)
        self.assertLess(values["Openness"].max(), ROUNDING)

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
        self.assertIn(
            f"maxNonOrtho of snappyHexMesh is {limit:g}",
            known["MaxNonOrthogonality"]["acceptable_source"],
        )

    def test_voronoi(self):
        """Faces are planar as far as single precision goes, which moves centroids by 1e-8."""
        self.compare(simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf")), 1e-7)

    def test_openness(self):
        """Of a Voronoi cell that lacks a face at the boundary checkMesh prints how open it is."""
        points, faces, cells = camaron_testing.read_visf(EXAMPLES / "voronoi-ball.visf")
        uses = numpy.bincount([face for cell in cells for face in cell], minlength=len(faces))
        opened = next(n for n, cell in enumerate(cells) if any(uses[face] == 1 for face in cell))
        cells[opened].remove(next(face for face in cells[opened] if uses[face] == 1))
        streams = []
        for cell in cells:
            lists = [number for face in cell for number in (len(faces[face]), *faces[face])]
            streams.append((VTK_POLYHEDRON, [len(cell), *lists]))
        path = camaron_testing.write_vtk(self.folder / "open.vtk", points, streams)
        source = simple.LegacyVTKReader(FileNames=[str(path)])
        case = self.folder / "case"
        openfoam_case.write(case, source)
        run = subprocess.run(
            openfoam_case.check_mesh(case),
            capture_output=True,
            text=True,
            timeout=120,
            env=openfoam_case.environment(),
        )
        theirs = re.search(r"max cell openness: ([-+.0-9e]+)", run.stdout)
        self.assertIsNotNone(theirs, run.stdout)
        quality = simple.ElementQuality(Input=source, Criteria=["Openness"])
        ours = vtk_to_numpy(self.fetch(quality).GetCellData().GetArray("Openness"))
        self.assertEqual(int(ours.argmax()), opened)
        self.assertAlmostEqual(ours.max() / float(theirs.group(1)), 1.0, delta=1e-7)

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
        self.compare(source, 1e-10)


if __name__ == "__main__":
    if not openfoam_case.PROGRAM:
        print("skipped: OpenFOAM's checkMesh is not installed")
        sys.exit(camaron_testing.SKIPPED)
    camaron_testing.main()
