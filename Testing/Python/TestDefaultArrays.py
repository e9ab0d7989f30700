# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where each rank is a client of its own, all take the same array by default, also those without cells."""

import json
import shutil
import subprocess

import camaron_testing

#: What every rank runs: the groups and the field that it gets; tables are on the first.
SCRIPT = """
import json, pathlib, sys
from camaron.common import pipeline
pipeline.load_plugin()
import mesh_parts
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
mesh = mesh_parts.split_source(empty_rank=True, global_ids=True)
mesh.UpdatePipeline()
found = {}
def read(name, filter, **properties):
    with pipeline.Messages() as messages:
        proxy = filter(Input=mesh, Arrays=["Constant"], **properties)
        proxy.UpdatePipeline()
    table = proxy.GetClientSideObject().GetOutputDataObject(0)
    rows = range(table.GetNumberOfRows())
    found[name] = messages.errors + messages.warnings
    for column in ("Group", "Field"):
        if table.GetColumnByName(column):
            found[name] += [table.GetValueByName(i, column).ToString() for i in rows]
read("statistics", simple.QualityStatistics, GroupBy="Cell array")
read("compare", simple.CompareQuality, Other=mesh, GroupBy="Cell array")
read("correlate", simple.CorrelateQuality)
read("of one rank", simple.QualityStatistics, GroupBy="Cell array", GroupArray="Material" if rank else "")
read("of several", simple.CorrelateQuality, Field=["CELLS", "Volume" if rank % 2 else "FaceCount"])
pathlib.Path(f"{sys.argv[1]}.{rank}").write_text(json.dumps(found))
"""


class TestDefaultArrays(camaron_testing.TestCase):
    def test_ranks_agree(self):
        mpiexec, pvbatch = shutil.which("mpiexec"), shutil.which("pvbatch")
        if not mpiexec or not pvbatch:
            self.skipTest("no mpiexec or pvbatch")
        script, target = self.folder / "script.py", self.folder / "found"
        script.write_text(SCRIPT)
        command = [mpiexec, "-n", "3", pvbatch, "--sym", str(script), str(target)]
        run = subprocess.run(command, capture_output=True, text=True, timeout=200)
        self.assertEqual(run.returncode, 0, run.stderr)
        found = [json.loads(self.folder.joinpath(f"found.{rank}").read_text()) for rank in range(3)]
        # The first array of integers is FaceCount, a count of 4 to 8: no ids, and no real numbers.
        groups = ["All", "4", "5", "6", "7", "8"]
        self.assertEqual(found[0]["statistics"], groups)
        self.assertEqual(found[0]["compare"], groups)
        # There are no point arrays, and AllUndefined is the first of those that are no criteria.
        self.assertEqual(found[0]["correlate"], ["All", "AllUndefined_Cells"])
        self.assertEqual(found[0]["of one rank"], ["All", "-3", "-2", "-1", "0", "1", "2", "3"])
        self.assertEqual(found[0]["of several"], ["All", "FaceCount_Cells"])
        for other in found[1:]:
            self.assertEqual(set(map(tuple, other.values())), {()})


if __name__ == "__main__":
    camaron_testing.main()
