# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: words and titles that the Mesh Inspector shows."""

import json
import unittest

from TestMeshInspector import card, open_card, start
from window_testing import WindowTestCase, check, event

#: Writes properties of the legend of the current criterion and of the bar chart.
TITLES = """
import json
from paraview import servermanager, simple
view = simple.GetActiveView()
legend = simple.GetScalarBar(simple.GetColorTransferFunction("MinDihedralAngle"), view)
manager = servermanager.ProxyManager()
charts = [v for v in manager.GetProxiesInGroup("views").values() if v.GetXMLName() == "XYBarChartView"]
with open(PATH, "w") as file:
    json.dump(
        {
            "views": sorted(v.GetXMLName() for v in manager.GetProxiesInGroup("views").values()),
            "active": view.GetXMLName(),
            "legend": [legend.Title, legend.ComponentTitle, legend.DrawNanAnnotation],
            "charts": [[c.BottomAxisTitle, c.LeftAxisTitle, c.ShowLegend] for c in charts],
        },
        file,
    )
"""


class TestMeshInspectorLook(WindowTestCase):
    def test_words(self):
        """Cell types and defects are words; the element's card says what is where."""
        self.play(
            *start(),
            check(
                card("Mesh", "Types"),
                "text",
                "3264 tetrahedra, 528 hexahedra, 192 wedges, 96 pyramids",
            ),
            *open_card("Element"),
            event(card("Worst", "Next"), "activate"),
            check(
                card("Element", "Summary"),
                "text",
                "Cell 1776: tetrahedron at -0.56, 0.1841, 0.6396",
            ),
        )

    def test_titles(self):
        """Legend and chart name criterion and unit; the mesh's view stays active."""
        titles = self.folder / "titles.json"
        self.play(
            *start(),
            *open_card("Report"),
            event(card("Report", "Chart"), "activate"),
            event(card("Report", "Statistics"), "activate"),
            *self.script("titles", TITLES.replace("PATH", repr(str(titles)))),
        )
        found = json.loads(titles.read_text())
        title = "Minimum dihedral angle (deg)"
        self.assertEqual(found["legend"], [title, "", 0])
        self.assertEqual(found["charts"], [[title, "Cells", 0]])
        self.assertEqual(found["active"], "RenderView")


if __name__ == "__main__":
    unittest.main()
