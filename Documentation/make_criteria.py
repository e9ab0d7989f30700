# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the pages of the criteria from the registry: ./camaron shell pvpython Documentation/make_criteria.py

criteria.md has the tables, criteria/ a page for each family, images/criteria/ their pictures. What
criteria answer for degenerate cells is not told but evaluated.
"""

import math
import sys
from pathlib import Path

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_POLYGON,
    VTK_POLYHEDRON,
    VTK_QUAD,
    VTK_TETRA,
    VTK_TRIANGLE,
    vtkUnstructuredGrid,
)

from camaron.common import pipeline, tables, text

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))
from criteria_pictures import PICTURES  # noqa: E402  (of this folder)

HEAD = """# Quality criteria

Made from the registry by `Documentation/make_criteria.py`; do not edit.

Lengths, areas and volumes are in the units of the mesh, angles in degrees unless chosen otherwise,
solid angles in steradian. *Better* says which end is good. An acceptable range marked *hint* is
common practice, or missed on purpose as by stretched cells; it is no verdict. A range is for the shapes that its source
is about: other cells are neither inside nor outside. Ranges of your own are for all cells and come from a [file](inspect.md#ranges).

A value is **null** (NaN) where the criterion has no meaning for the shape or is undefined, and
**infinite** where it grows without bound: an infinite value is bad, not absent. *Write Null Mask*
tells why a value is null: 1 not applicable to this shape, 2 degenerate (0/0), 3 invalid topology
(open, or several surfaces in one), 4 no neighbour, 5 the neighbour's piece is not known, 6 value of
the corners of a higher-order cell. A cell with coordinates that are not finite has null values.

Every cell is taken as the polygon or polyhedron that it is: a hexahedron has the same values as the
polyhedron with its faces. An edge is collapsed when it is shorter than *Degeneracy Tolerance* times
the diameter, faces and cells accordingly; by default 1e-12, and never less than 8 rounding units of
double precision: it depends on the mesh, not on the type that holds its coordinates.

**Symbols.** pᵢ the corners of a face in order, pᵢ₊₁ the next one; l the lengths of edges; P
perimeter, A area, V volume, h diameter, r inradius, R circumradius; S_f the vector area of a face
f, pointing outward, n its unit normal, c_f its centre; C or P the centroid of the cell, N that of a
neighbour; a hat marks a vector of length 1.
"""

#: Pictures under the first of the criteria that they belong to.
SHOWN = {
    "interior-angle": ("MinInteriorAngle", "MaxInteriorAngle", "MinFaceAngle", "MaxFaceAngle"),
    "dihedral-angle": ("MinDihedralAngle", "MaxDihedralAngle"),
    "solid-angle": ("MinSolidAngle", "MaxSolidAngle"),
    "equiangle": ("EquiangleSkewness",),
    "radius-ratio": ("TriangleRadiusRatio",),
    "radius-edge": ("TriangleRadiusEdgeRatio", "TetRadiusEdgeRatio"),
    "warpage": ("MinFaceFlatness", "MaxWarpage"),
    "decomposition": ("MinFacePyramidVolume", "MinTetVolume"),
    "non-orthogonality": ("MaxNonOrthogonality",),
    "skewness": ("MaxFaceSkewness",),
    "orthogonal-quality": ("OrthogonalQuality",),
    "kernel": ("KernelRatio",),
}
#: Families whose answers for degenerate cells are not shown: those of Verdict depend on the version of
#: VTK, the others are about more than one cell.
WITHOUT_ANSWERS = ("Verdict", "Place in the mesh")

SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
CUBE = [*SQUARE, *((x, y, 1) for x, y, _ in SQUARE)]
CUBE_FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
L_SHAPE = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
L_FACES = [
    (5, 4, 3, 2, 1, 0),
    (6, 7, 8, 9, 10, 11),
    *((i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6) for i in range(6)),
]
#: Cells by name: type, points, and faces of a polyhedron.
POLYGONS = {
    "three points on a line": (VTK_TRIANGLE, [(0, 0, 0), (1, 0, 0), (2, 0, 0)]),
    "triangle, two corners in one place": (VTK_TRIANGLE, [(0, 0, 0), (0, 0, 0), (1, 0, 0)]),
    "triangle in one point": (VTK_TRIANGLE, [(0, 0, 0)] * 3),
    "quadrilateral with a collapsed edge": (VTK_QUAD, [*SQUARE[:3], SQUARE[2]]),
    "quadrilateral that crosses itself": (VTK_QUAD, [SQUARE[i] for i in (0, 1, 3, 2)]),
    "L of six corners": (VTK_POLYGON, [(x, y, 0) for x, y in L_SHAPE]),
}
POLYHEDRA = {
    "flat tetrahedron": (VTK_TETRA, SQUARE),
    "inverted tetrahedron": (VTK_TETRA, [(0, 0, 0), (0, 1, 0), (1, 0, 0), (0, 0, 1)]),
    "tetrahedron in one point": (VTK_TETRA, [(0, 0, 0)] * 4),
    "cube, faces inward": (VTK_POLYHEDRON, CUBE, [face[::-1] for face in CUBE_FACES]),
    "cube without a face": (VTK_POLYHEDRON, CUBE, CUBE_FACES[:-1]),
    "cube with a collapsed edge": (VTK_HEXAHEDRON, [*CUBE[:7], CUBE[6]]),
    "L-shaped prism": (
        VTK_POLYHEDRON,
        [(x, y, z) for z in (0, 1) for x, y in L_SHAPE],
        L_FACES,
    ),
}


def make_cells(cells):
    """Each cell with points of its own."""
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetDataTypeToDouble()
    grid.SetPoints(points)
    for kind, places, *faces in cells:
        first = points.GetNumberOfPoints()
        for place in places:
            points.InsertNextPoint(*place)
        if kind == VTK_POLYHEDRON:
            stream = vtkIdList()
            stream.InsertNextId(len(faces[0]))
            for face in faces[0]:
                for number in (len(face), *(first + i for i in face)):
                    stream.InsertNextId(number)
            grid.InsertNextCell(kind, stream)
        else:
            grid.InsertNextCell(kind, len(places), range(first, first + len(places)))
    return grid


def answers(cells, names):
    """What the criteria say of the cells: a list of texts by the name of the criterion."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(make_cells(cells))
    quality = simple.ElementQuality(Input=source, Criteria=names, WriteNullMask=1)
    data = servermanager.Fetch(quality).GetCellData()
    result = {}
    for name in names:
        values, reasons = data.GetArray(name), data.GetArray(f"{name}_Null")
        result[name] = [
            answer(values.GetValue(cell), int(reasons.GetValue(cell)))
            for cell in range(values.GetNumberOfTuples())
        ]
    simple.Delete(quality)
    simple.Delete(source)
    return result


def answer(value, reason):
    if math.isnan(value):
        return f"null ({reason})"
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    return number(0.0 if abs(value) < 1e-12 else value)


def number(value):
    return "" if value is None else text.number(value).replace("-", "−")


def bounds(c):
    low, high = c["range"]
    return f"{number(low) or '−∞'} to {number(high) or '∞'}"


def acceptable(c):
    if c["acceptable"] == [None, None]:
        return ""
    source = ("hint: " if c["acceptable_is_hint"] else "") + c["acceptable_source"]
    shapes = "" if c["acceptable_for"] == c["applies_to"] else f"; for {c['acceptable_for']} only"
    return f"{text.interval(*c['acceptable'], '')} ({source}{shapes})"


def better(c):
    return "" if c["better"] == "neither" else c["better"]


def page_name(family):
    return family.lower().replace(" ", "-")


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def overview(families, presets):
    parts = [HEAD]
    for family, criteria in families.items():
        parts.append(f"## {family}\n")
        page = f"criteria/{page_name(family)}.md"
        parts.append(f"Formulas and more: [{page}]({page})\n")
        head = ["name", "applies to", "unit", "range", "ideal", "better", "acceptable", "meaning"]
        rows = [
            [
                f"[`{c['name']}`]({page}#{c['name'].lower()})",
                c["applies_to"],
                c["unit"] or "-",
                bounds(c),
                number(c["ideal"]),
                better(c),
                acceptable(c),
                c["description"],
            ]
            for c in criteria
        ]
        parts.append(table(head, rows) + "\n")
    parts.append("## Presets\n\nA preset names criteria and their acceptable ranges.\n")
    for name, preset in presets.items():
        parts.append(f"**{name}**: {preset['description']}\n")
        lines = []
        for criterion, limits in preset["rules"].items():
            limited = list(limits) != [None, None]
            shapes = preset["shapes"][criterion]
            hint = ", a hint" if criterion in preset["hints"] else ""
            limited = f" {text.interval(*limits, '')} of {shapes}{hint}" if limited else ""
            lines.append(f"- `{criterion}`{limited}")
        parts.append("\n".join(lines) + "\n")
    return "\n".join(parts)


def section(c, pictures):
    lines = [f"## {c['name']}\n", f"*{c['label']}*, of {c['applies_to']}. {c['description']}\n"]
    for picture in pictures:
        lines.append(f"![{picture.replace('-', ' ')}](../images/criteria/{picture}.svg)\n")
    lines.append(f"> {c['formula']}\n".replace("*", "\\*").replace("_", "\\_"))
    facts = [
        ("Unit", c["unit"]),
        ("Range", bounds(c)),
        ("Ideal", number(c["ideal"])),
        ("Better", better(c)),
        ("Acceptable", acceptable(c)),
        ("Cells outside", c["consequence"]),
        ("Degenerate cells", c["degenerate"].replace("_", "\\_")),
        ("Other programs", c["agreement"]),
    ]
    lines.append("\n".join(f"- {name}: {fact}" for name, fact in facts if fact) + "\n")
    return "\n".join(lines)


def family_page(family, criteria):
    parts = [f"# {family}\n\n[All criteria](../criteria.md), where the symbols are explained.\n"]
    shown = set()
    for c in criteria:
        pictures = [p for p, names in SHOWN.items() if c["name"] in names and p not in shown]
        shown.update(pictures)
        parts.append(section(c, pictures))
    if family in WITHOUT_ANSWERS:
        return "\n".join(parts)
    parts.append("## Answers for degenerate cells\n")
    parts.append("As evaluated; the numbers of null values tell the reason.\n")
    names = [c["name"] for c in criteria]
    for shapes in (POLYGONS, POLYHEDRA):
        found = answers(shapes.values(), names)
        rows = [
            [f"`{name}`", *found[name]]
            for name in names
            if any(value != "null (1)" for value in found[name])
        ]
        if rows:
            parts.append(table(["", *shapes], rows) + "\n")
    return "\n".join(parts)


def files():
    """All pages and pictures: their texts by their path below Documentation."""
    pipeline.load_plugin()
    families, notes = {}, tables.known_notes()
    for name, c in tables.known_criteria().items():
        families.setdefault(notes[name]["family"], []).append({**c, **notes[name]})
    result = {"criteria.md": overview(families, tables.known_presets())}
    for family, criteria in families.items():
        result[f"criteria/{page_name(family)}.md"] = family_page(family, criteria)
    known = {c["name"] for criteria in families.values() for c in criteria}
    for name, names in SHOWN.items():
        if known & set(names):
            result[f"images/criteria/{name}.svg"] = PICTURES[name]().svg()
    return {path: page.rstrip() + "\n" for path, page in result.items()}


def main():
    for folder in ("criteria", "images/criteria"):
        (FOLDER / folder).mkdir(parents=True, exist_ok=True)
        for path in (FOLDER / folder).iterdir():
            path.unlink()
    for path, page in files().items():
        (FOLDER / path).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
