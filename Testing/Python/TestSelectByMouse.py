# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: cells by rubber band, one layer more, their faces, less a sphere; and the state of that."""

import json

import camaron_testing
import numpy
from window_testing import (
    FRAME,
    PROPERTIES,
    VIEWPORT,
    WindowTestCase,
    add_filter,
    apply,
    check,
    choose,
    event,
    open_file,
    save_state,
)

#: Run in the window's Python shell: what each filter selects, and the faces' cells.
LIST = """
import json
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
def cells(name, array="Selected"):
    data = servermanager.Fetch(simple.FindSource(name))
    return vtk_to_numpy(data.GetCellData().GetArray(array)).tolist()
found = {number: cells(f"SelectElements{number}") for number in (1, 2, 3, 4)}
found["ends"] = list(zip(cells("SelectElements4", "OwnerCell"), cells("SelectElements4", "NeighborCell")))
faces = servermanager.Fetch(simple.FindSource("SelectElements4"))
found["points"] = [[faces.GetCell(i).GetPoints().GetPoint(k) for k in range(faces.GetCell(i).GetNumberOfPoints())] for i in range(faces.GetNumberOfCells())]
shape = simple.FindSource("SelectElements4").Shape
found["sphere"] = [list(shape.Center), shape.Radius]
with open(PATH, "w") as file:
    json.dump(found, file)
"""


def rubber_band(first, last):
    return [
        event(f"{FRAME}/actionSelectSurfaceCells", "set_boolean", "true"),
        event(VIEWPORT, "mousePress", f"({first},{first},1,1,0)"),
        event(VIEWPORT, "mouseMove", f"({last},{last},1,0,0)"),
        event(VIEWPORT, "mouseRelease", f"({last},{last},1,0,0)"),
    ]


class TestSelectByMouse(WindowTestCase):
    def list(self, name):
        return self.script(name, LIST.replace("PATH", repr(str(self.folder / f"{name}.json"))))

    def found(self, name):
        return json.loads((self.folder / f"{name}.json").read_text())

    def test_session(self):
        state, trace = self.folder / "session.pvsm", self.folder / "trace.py"
        session = [
            *open_file("voronoi-ball.visf"),
            apply(),
            *rubber_band(0.42, 0.58),
            *add_filter("SelectElements"),
            choose("Strategy/ComboBox", "Current"),
            apply(),
            *add_filter("SelectElements"),
            choose("Strategy/ComboBox", "Expand"),
            apply(),
            *add_filter("MeshElements"),
            apply(),
            *add_filter("SelectElements"),
            choose("Strategy/ComboBox", "Change element type"),
            choose("Elements/1QComboBox0", "SelectElements2:Mesh"),
            apply(),
            *add_filter("SelectElements"),
            choose("Strategy/ComboBox", "Shape"),
            choose("Combination/ComboBox", "Subtract"),
            apply(),
            *self.list("before"),
        ]
        self.play(*self.traced(trace, *session), *save_state(state))
        self.play(
            *self.list("after"),
            options=[f"--state={state}"],
        )
        before, after = self.found("before"), self.found("after")
        self.assertEqual(before, after)
        if camaron_testing.traces_have_selections():
            self.replay(trace, LIST.replace("PATH", repr(str(self.folder / "replayed.json"))))
            self.assertEqual(before, self.found("replayed"))
        picked, grown, faces, outer = (numpy.array(before[str(i)]) for i in (1, 2, 3, 4))
        ends = before["ends"]
        # Cells of the surface in the middle of the view, and not most of it.
        boundary = {owner for owner, neighbor in ends if neighbor < 0}
        chosen = set(numpy.flatnonzero(picked).tolist())
        self.assertTrue(chosen)
        self.assertLessEqual(chosen, boundary)
        self.assertLess(len(chosen), len(boundary) / 4)
        layer = {end for pair in ends if set(pair) & chosen for end in pair if end >= 0}
        self.assertEqual(set(numpy.flatnonzero(grown).tolist()), chosen | layer)
        self.assertEqual(faces.tolist(), [int(bool(set(pair) & (chosen | layer))) for pair in ends])
        self.assertGreater(outer.sum(), 0)
        self.assertLess(outer.sum(), faces.sum())
        self.assertTrue((outer <= faces).all())
        center, radius = before["sphere"]
        for points, was, left in zip(before["points"], faces, outer):
            distances = [numpy.linalg.norm(numpy.subtract(point, center)) for point in points]
            if was and sorted(distances)[-1] < radius:
                self.assertFalse(left, "a face inside the sphere")

    def test_count_in_panel(self):
        count = f"{PROPERTIES}/Combination/SelectedCount"
        self.play(
            *open_file("voronoi-ball.visf"),
            apply(),
            *add_filter("SelectElements"),
            choose("Strategy/ComboBox", "By id"),
            choose("Ids/Ids", "3 5 100000000"),
            apply(),
            check(count, "text", "2 cells selected. 1 of 3 ids does not exist."),
            choose("Ids/Ids", "three"),
            apply(),
            check(count, "visible", "false"),
            choose("Ids/Ids", "3"),
            apply(),
            check(count, "text", "1 cell selected."),
            check(count, "visible", "true"),
            choose("Strategy/ComboBox", "All"),
            apply(),
            check(count, "text", "800 cells selected."),
        )


if __name__ == "__main__":
    camaron_testing.main()
