# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of all time steps where the steps do not have the same arrays."""

import camaron_testing
import mesh_parts
from camaron.common import pipeline, tables
from paraview import simple


class TestTimeSteps(camaron_testing.TestCase):
    def evaluate(self, source, **properties):
        statistics = simple.QualityStatistics(Input=source, AllTimeSteps=1, **properties)
        statistics.UpdatePipeline()
        return tables.fetch(statistics)

    def test_arrays_of_some_time_steps(self):
        """Steps that lack an array, or everything, are named; names that come twice have one row."""
        source = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid")
        source.PythonPath = f"'{mesh_parts.__file__.rsplit('/', 1)[0]}'"
        source.ScriptRequestInformation = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
information = self.GetOutputInformation(0)
information.Set(Pipeline.TIME_STEPS(), [0.5, 1, 2, 4], 4)
information.Set(Pipeline.TIME_RANGE(), [0.5, 4], 2)
"""
        source.Script = """
import mesh_parts
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
time = self.GetOutputInformation(0).Get(Pipeline.UPDATE_TIME_STEP())
if time != 4:
    grid = mesh_parts.make_full_mesh()
    if time == 1:
        grid.GetCellData().RemoveArray("Volume")
    self.GetOutputDataObject(0).ShallowCopy(grid)
"""
        names = ["Volume", "Single", "Volume", "Nowhere"]
        with pipeline.Messages() as messages:
            table = self.evaluate(source, Arrays=names)
        self.assertEqual(
            [(row["Time"], row["Criterion"]) for row in table],
            [(0.5, "Volume"), (0.5, "Single"), (1, "Single"), (2, "Volume"), (2, "Single")],
        )
        (warning,) = messages.warnings
        for text in (
            "no one-component cell arrays named: Nowhere.",
            "Volume is missing at time 1, 4.",
            "Single is missing at time 4.",
        ):
            self.assertIn(text, warning)
        with pipeline.Messages() as messages:
            self.evaluate(source, Arrays=["Volume"], WeightArray="Volume")
        self.assertIn("at time 1: the weights need a one-component array", messages.errors[0])

    def test_no_elements(self):
        """A mesh without cells has no values, and lacks no array."""
        mesh = simple.Threshold(
            Input=mesh_parts.producer(mesh_parts.make_full_mesh()),
            Scalars=["CELLS", "Volume"],
            ThresholdMethod="Above Upper Threshold",
            UpperThreshold=1e300,
        )
        with pipeline.Messages() as messages:
            self.assertEqual(
                tables.fetch(simple.QualityStatistics(Input=mesh, Arrays=["Volume"])), []
            )
        self.assertEqual((messages.errors, messages.warnings), ([], []))


if __name__ == "__main__":
    camaron_testing.main()
