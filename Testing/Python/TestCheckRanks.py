# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.check distributes the mesh and has the verdicts, counts and cells of the whole one."""

import json
import os
import sys
from pathlib import Path

import camaron_testing
from camaron import check
from camaron.common import json_text

RULES = {
    "flange.visf": [
        "preset 'Finite volume' tolerate 1%",
        "MinDihedralAngle > 20 of tetrahedra",
        "MinDihedralAngle > 20 of hexahedra",
        "EdgeLengthRatio 0.1 0.9 of type Wedge",
        "EdgeLengthRatio 0.1 0.9",
        "TetRadiusRatio >= 0.5",
    ],
    "voronoi-ball.visf": [
        "EdgeLengthRatio >= 0.01 where FaceCount = 15",
        "EdgeLengthRatio >= 0.01",
        "FaceCount <= 14 tolerate 50%",
        "NonOrthogonality <= 20 of faces",
        "EdgeLength >= 0.01 of edges",
        "MinVolumeRatio > 0.2 where RegionId = 0",
        "Volume > 0 of wedges",
    ],
}


def verdicts():
    """All that does not depend on the time it takes, by the name of the mesh."""
    results = {}
    for name, rules in RULES.items():
        result = check(camaron_testing.EXAMPLES / name, rules, worst=30)
        del result["seconds"]
        for entry in result["checks"]:
            for cell in entry["worst"]:
                del cell["id_space"]  # only pieces have global ids, which then are the indices
        results[name] = json.loads(json_text.to_json(result))
    return results


class TestCheckRanks(camaron_testing.TestCase):
    def test_same_as_whole(self):
        """Everything that a single process finds, to the last bit and in the same order."""
        reference = self.folder / "reference.json"
        camaron_testing.run_alone(__file__, reference, timeout=200)
        expected = json.loads(reference.read_text("utf-8"))
        for name, result in verdicts().items():
            self.assertEqual(result, expected[name], name)
            failing = [entry["failing"] for entry in result["checks"]]
            self.assertGreater(sum(map(bool, failing)), 2, "there is something to compare")

    def test_wrong_scope(self):
        """An error, not ranks that wait for each other."""
        mesh = camaron_testing.EXAMPLES / "voronoi-ball.visf"
        with self.assertRaisesRegex(RuntimeError, "there is no cell array Nothing"):
            check(mesh, ["Volume > 0 where Nothing = 1"])


if __name__ == "__main__":
    if len(sys.argv) > 1:
        Path(sys.argv[1]).write_text(json.dumps(verdicts()), encoding="utf-8")
        os._exit(0)
    camaron_testing.main()
