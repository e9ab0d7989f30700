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

Elements and values do not depend on how a mesh is split over processes and partitions, with or without ghost cells:
cells of other pieces of a block are found by their points, by global ids if all pieces have them, else by their places.
So are those of pieces that a reader put into one data set, as far as points have global ids: of points of the same id
and place the cells have the first one, the other ones are marked as ghosts. An element between pieces belongs to the
one whose cell has the smallest id; in the others it is marked as a ghost. Elements of copies of cells alone are left
out. Faces of fewer than three different points, as hexahedra have that are used as wedges, stand alone: they have one
cell and are no boundary. Other faces run out of, and are seen from, their owner: the cell of the smaller id. Ids of
cells are global ones; without them the cells of a block are counted piece after piece, so that a mesh that is split
into ranges of cells keeps its numbers. `OwnerCell` and the points tell which element is the same in another partition;
the numbers of elements in their data sets are those of one process, faces in the order of its own cells.

Faces between blocks are a boundary of both, unless *Connect Blocks* is on: then blocks are pieces of one mesh, and their
cells are counted block after block.
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
