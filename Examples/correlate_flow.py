#!/usr/bin/env pvpython
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where bad cells change a flow: OpenFOAM computes that through a mixing elbow twice, with and without its correction
for faces that are not orthogonal to the lines between cells, and Correlate Quality compares the difference with criteria.

    ./camaron shell pvpython Examples/correlate_flow.py mixing_elbow.cas.h5 elbow  # writes two cases
    simpleFoam -case elbow/corrected; simpleFoam -case elbow/uncorrected
    ./camaron shell pvpython Examples/correlate_flow.py elbow

The mesh is among Ansys' public examples, and simpleFoam in Debian's package openfoam. See Documentation/correlation.md.
"""

import pathlib
import sys

import camaron
from paraview import servermanager
from paraview.simple import *

LoadDistributedPlugin("Camaron", ns=globals())

HEADER = "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"
#: Besides their values inside: at the inlets, at the outlet, at the walls.
FIELDS = {
    "U": (
        "volVectorField [0 1 -1 0 0 0 0] (0 0 0)",
        "surfaceNormalFixedValue; refValue uniform %s",
        "inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0)",
        "noSlip",
    ),
    "p": (
        "volScalarField [0 2 -2 0 0 0 0] 0",
        "zeroGradient",
        "fixedValue; value uniform 0",
        "zeroGradient",
    ),
    "k": (
        "volScalarField [0 2 -2 0 0 0 0] 1e-3",
        "fixedValue; value uniform 1e-3",
        "zeroGradient",
        "kqRWallFunction; value uniform 1e-3",
    ),
    "epsilon": (
        "volScalarField [0 2 -3 0 0 0 0] 1e-2",
        "fixedValue; value uniform 1e-2",
        "zeroGradient",
        "epsilonWallFunction; value uniform 1e-2",
    ),
    "nut": (
        "volScalarField [0 2 -1 0 0 0 0] 0",
        "calculated; value uniform 0",
        "calculated; value uniform 0",
        "nutkWallFunction; value uniform 0",
    ),
}
SETTINGS = {
    "constant/transportProperties": "transportModel Newtonian; nu [0 2 -1 0 0 0 0] 1e-6;",
    "constant/turbulenceProperties": "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }",
    "system/controlDict": """application simpleFoam; startFrom startTime; startTime 0; stopAt endTime; endTime %d;
deltaT 1; writeControl timeStep; writeInterval %d; writePrecision 8;""",
    "system/fvSchemes": """ddtSchemes { default steadyState; }
gradSchemes { default cellLimited Gauss linear 1; }
divSchemes { default bounded Gauss upwind; div(phi,U) bounded Gauss linearUpwind grad(U);
    div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear %s; }
interpolationSchemes { default linear; }
snGradSchemes { default %s; }""",
    "system/fvSolution": """solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-8; relTol 0.05; }
    "(U|k|epsilon)" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-9; relTol 0.1; }
}
SIMPLE { nNonOrthogonalCorrectors 1; consistent yes; }
relaxationFactors { equations { ".*" 0.7; } fields { p 0.7; } }""",
}
SCHEMES = ("corrected", "uncorrected")
COLUMNS = [
    "Criterion",
    "Pearson",
    "Spearman",
    "OutsideCount",
    "FieldMeanInside",
    "FieldMeanOutside",
    "OutsideAbove",
]
CRITERIA = [
    "MaxNonOrthogonality",
    "OrthogonalQuality",
    "MaxFaceSkewness",
    "MinVolumeRatio",
    "EquiangleSkewness",
]


def write_case(mesh, folder, scheme, steps):
    """The mesh, the boundary conditions and the settings."""
    camaron.convert(mesh, folder / "case.foam")
    values = {"controlDict": (steps, steps), "fvSchemes": (scheme, scheme)}
    for name, text in SETTINGS.items():
        path = folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(
            HEADER % ("dictionary", path.name) + text % values.get(path.name, ()) + "\n"
        )
    (folder / "0").mkdir()
    for name, (field, inlet, outlet, wall) in FIELDS.items():
        kind, rest = field.split(" ", 1)
        dimensions, inside = rest.split("] ")
        patches = {f"{which}-inlet": inlet for which in ("cold", "hot")}
        if name == "U":
            patches = {"cold-inlet": inlet % -0.4, "hot-inlet": inlet % -1.2}  # m/s
        patches |= {"outlet": outlet, "wall.*": wall, "symmetry.*": "symmetry"}
        (folder / "0" / name).write_text(
            f"{HEADER % (kind, name)}dimensions {dimensions}];\ninternalField uniform {inside};\nboundaryField\n{{\n"
            + "".join(f'    "{patch}" {{ type {what}; }}\n' for patch, what in patches.items())
            + "}\n"
        )


def flow(folder):
    """The velocity in the cells after the last step."""
    case = OpenDataFile(str(folder / "case.foam"))
    case.UpdatePipelineInformation()
    case.MeshRegions, case.CellArrays = ["internalMesh"], ["U"]
    case.UpdatePipeline(max(case.TimestepValues))
    return case


def prepare(mesh, folder, steps=200):
    """Writes the two cases."""
    for scheme in SCHEMES:
        write_case(mesh, folder / scheme, scheme, steps)


def compare(folder):
    """Prints the table of the correlations and returns it."""
    corrected, uncorrected = (flow(folder / scheme) for scheme in SCHEMES)
    quality = ElementQuality(Input=corrected, Criteria=CRITERIA)
    change = PythonCalculator(
        Input=[quality, uncorrected],
        Expression="mag(inputs[0].CellData['U'] - inputs[1].CellData['U'])",
        ArrayAssociation="Cell Data",
        ArrayName="ChangeOfU",
    )
    correlation = CorrelateQuality(Input=change, Field=["CELLS", "ChangeOfU"])
    correlation.UpdatePipeline(max(corrected.TimestepValues))
    table = servermanager.Fetch(OutputPort(correlation, 0))
    print(*COLUMNS)
    for row in range(table.GetNumberOfRows()):
        name, *numbers = (table.GetValueByName(row, column) for column in COLUMNS)
        print(name.ToString(), *(f"{number.ToDouble():.3g}" for number in numbers))
    return table


if __name__ == "__main__":
    *mesh, folder = sys.argv[1:]
    prepare(*mesh, pathlib.Path(folder)) if mesh else compare(pathlib.Path(folder))
