# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""A trace, a Python state and a state file bring a pipeline of the filters back, with the same numbers."""

import camaron_testing
from camaron_testing import EXAMPLES
from paraview import selection as paraview_selection
from paraview import servermanager, simple, smstate, smtrace
from paraview.modules.vtkRemotingViews import vtkSMSelectionHelper

#: What the filters are set to.
PROPERTIES = {
    "ElementQuality": {
        # In their own order, in which ParaView 6.1 puts them.
        "Criteria": ["VertexCount", "MaxDihedralAngle", "KernelRatio"],
        "AngleUnits": "Radians",
        "WriteUndefinedMask": 1,
    },
    "MeshElements": {
        "FaceArrays": ["FaceCellCount", "NonOrthogonality"],
        "EdgeArrays": ["EdgeAngleSum"],
        "VertexArrays": ["IsBoundary", "VertexAngleSum"],
    },
    "SelectElements": {
        "Strategy": "Half-spaces",
        "Planes": [0, 0, 0.1, 0, 0, 1, 0.2, 0, 0, 1, 1, 0],
        "Placement": "Cut by boundary",
        "Combination": "Add",
    },
    "MeshKernel": {"KernelOf": "Each Cell", "ChosenBy": "VertexCount"},
}


def make_pipeline():
    mesh = simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf"))
    quality = simple.ElementQuality(
        registrationName="ElementQuality", Input=mesh, **PROPERTIES["ElementQuality"]
    )
    for name in ("MeshElements", "SelectElements", "MeshKernel"):
        getattr(simple, name)(registrationName=name, Input=quality, **PROPERTIES[name])


def summary():
    """Of all outputs of the filters the numbers of points and cells, the arrays and their ranges."""
    found = {}
    for name, properties in PROPERTIES.items():
        source = simple.FindSource(name)
        for key, value in properties.items():
            actual = source.GetPropertyValue(key)
            found[name, key] = list(actual) if isinstance(value, list) else actual
        source.UpdatePipeline()
        for port in range(source.GetNumberOfOutputPorts()):
            data = servermanager.Fetch(source, idx=port)
            if data.IsA("vtkSelection"):
                found[name, port] = data.GetNode(0).GetSelectionList().GetNumberOfTuples()
                continue
            arrays = data.GetCellData()
            ranges = {
                arrays.GetArrayName(i): arrays.GetArray(i).GetFiniteRange()
                for i in range(arrays.GetNumberOfArrays())
            }
            found[name, port] = data.GetNumberOfPoints(), data.GetNumberOfCells(), ranges
    return found


class TestReplay(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        simple.ResetSession()
        camaron_testing.pipeline.load_plugin()

    def check(self, expected):
        for name, properties in PROPERTIES.items():
            for key, value in properties.items():
                self.assertEqual(expected[name, key], value)
        self.assertIn(("MeshElements", 2), expected)
        self.assertEqual(summary(), expected)

    def replay(self, text):
        simple.ResetSession()
        camaron_testing.pipeline.load_plugin()
        exec(compile(text, "replayed", "exec"), {})

    def test_trace(self):
        smtrace.start_trace(preamble="")
        make_pipeline()
        text = smtrace.stop_trace()
        expected = summary()
        self.replay(text)
        self.check(expected)

    def test_python_state(self):
        make_pipeline()
        expected = summary()
        self.replay(smstate.get_state())
        self.check(expected)

    def test_state_file(self):
        make_pipeline()
        expected = summary()
        path = str(self.folder / "state.pvsm")
        simple.SaveState(path)
        simple.ResetSession()
        camaron_testing.pipeline.load_plugin()
        simple.LoadState(path)
        self.check(expected)

    def select_from_active_selection(self):
        """As the window makes the filter where something is selected."""
        mesh = simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf"))
        ids = paraview_selection._createSelection(
            "IDSelectionSource", IDs=[-1, 3, -1, 5], FieldType="CELL"
        )
        active = vtkSMSelectionHelper.NewAppendSelectionsFromSelectionSource(ids.SMProxy)
        mesh.SMProxy.SetSelectionInput(0, active, 0)
        active.UnRegister(None)
        simple.SelectElements(registrationName="Selected", Input=mesh, Strategy="Current")

    def number_selected(self):
        selected = simple.FindSource("Selected")
        selected.UpdatePipeline()
        return (
            servermanager.Fetch(selected, idx=1).GetNode(0).GetSelectionList().GetNumberOfTuples()
        )

    def test_active_selection(self):
        for way in ("trace", "state"):
            with self.subTest(way):
                if way == "trace" and not camaron_testing.traces_have_selections():
                    self.skipTest("traces of ParaView 6.1 leave out what has a selection")
                simple.ResetSession()
                camaron_testing.pipeline.load_plugin()
                if way == "trace":
                    smtrace.start_trace(preamble="")
                self.select_from_active_selection()
                text = smtrace.stop_trace() if way == "trace" else smstate.get_state()
                self.assertEqual(self.number_selected(), 2)
                self.replay(text)
                self.assertEqual(self.number_selected(), 2)

    def test_no_input(self):
        """The filter can be made without one."""
        self.assertIsNone(simple.SelectElements(Input=None).Input)


if __name__ == "__main__":
    camaron_testing.main()
