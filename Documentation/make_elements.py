# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Documentation/elements.md from the tables of arrays:
./camaron shell pvpython Documentation/make_elements.py"""

from pathlib import Path

from camaron import pipeline, tables
from paraview import simple

pipeline.load_plugin()

HEAD = """# Faces, edges and vertices

Made from the tables of arrays by `Documentation/make_elements.py`; do not edit.

The filter *Mesh Elements* takes the faces, edges and vertices of a mesh as data sets of their own, each element once.
Its properties *Face Arrays*, *Edge Arrays* and *Vertex Arrays* say which of the arrays below they get; only those are
computed, and only if the mesh has cells of the dimension given here. Those in bold are ticked by default. Angles are in
degrees unless chosen otherwise, solid angles in steradian, lengths and volumes in the units of the mesh. A value is null
(NaN) where it is undefined or where the mesh has not the cells that it needs.

With *Worst Of Cells* vertices get `VertexWorst<Criterion>` for every criterion of Element Quality that the cells of the
input carry and that has a good and a bad end: the worst value of the cells around; null values count for nothing.

For criteria of polygons (areas, interior angles, ratios, ...) evaluate the faces with *Element Quality*.

In parallel, elements that belong to another process are marked as ghosts. `DuplicatePoint` and `FaceMismatch` compare
the points of one process and of its ghost cells.
"""

source = simple.CriteriaTable()
rows = tables.fetch(source, 3)
lines = [HEAD]
for element, title in (("Face", "Faces"), ("Edge", "Edges"), ("Vertex", "Vertices")):
    lines += [f"## {title}", "", "| array | cells | unit | meaning |", "| --- | --- | --- | --- |"]
    for row in rows:
        if row["Element"] == element:
            name = f"**`{row['Name']}`**" if row["IsDefault"] else f"`{row['Name']}`"
            lines.append(f"| {name} | {row['Cells']} | {row['Unit'] or '-'} | {row['Description']} |")
    lines.append("")
Path(__file__).with_name("elements.md").write_text("\n".join(lines).rstrip() + "\n")
