# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as cases of OpenFOAM, for its checkMesh."""

import os
import shutil

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

#: Where checkMesh is; None if it is not installed.
PROGRAM = shutil.which("checkMesh")
HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"


def write(folder, source):
    """The case of a source's mesh, whose faces MeshElements finds."""
    elements = simple.MeshElements(Input=source, FaceArrays=["OwnerCell", "NeighborCell"])
    faces = servermanager.Fetch(elements, idx=0)
    simple.Delete(elements)
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

    def put(name, kind, rows):
        text = "\n".join([str(len(rows)), "(", *rows, ")", ""])
        (mesh / name).write_text(HEADER.format(kind, name) + text)

    put("points", "vectorField", [f"({x!r} {y!r} {z!r})" for x, y, z in points.tolist()])
    rows = [ids[offsets[f] : offsets[f + 1]] for f in order]
    put("faces", "faceList", [f"{len(r)}({' '.join(map(str, r))})" for r in rows])
    put("owner", "labelList", [str(o) for o in owner[order]])
    put("neighbour", "labelList", [str(n) for n in neighbor[inner]])
    walls = f"walls {{ type wall; nFaces {len(order) - len(inner)}; startFace {len(inner)}; }}"
    put("boundary", "polyBoundaryMesh", [walls])
    write_settings(folder)


def write_settings(folder):
    """What checkMesh wants of a case beside its mesh."""
    (folder / "system").mkdir(exist_ok=True)
    for name in ("fvSchemes", "fvSolution"):
        entries = "gradSchemes {} divSchemes {} laplacianSchemes {}\n" * (name == "fvSchemes")
        (folder / "system" / name).write_text(HEADER.format("dictionary", name) + entries)
    (folder / "system" / "controlDict").write_text(
        HEADER.format("dictionary", "controlDict")
        + "application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;"
        " writeControl timeStep; writeInterval 1; writePrecision 12;\n"
    )


def check_mesh(folder, *options):
    """The command that checks the case in a folder."""
    return [PROGRAM, *options, "-noFunctionObjects", "-case", str(folder)]


def environment():
    """What checkMesh expects of its environment. Numbers that are not finite do not end it."""
    return {"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ, "FOAM_SIGFPE": "false"}
