# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names that are HTML are text in reports, wherever they come from."""

import ast
import copy
import csv
import doctest
import json
import xml.etree.ElementTree as ElementTree
from datetime import datetime
from html.parser import HTMLParser
from pathlib import Path

import camaron_testing
import camaron
from camaron import check, compare, inspect, select
from camaron.checking import junit
from camaron.common import markup, svg, text
from camaron.common.inputs import Inputs
from camaron.comparison import comparison_report
from camaron.inspection import report
from gallery import make_grid
from vtkmodules.vtkCommonCore import vtkIntArray
from vtkmodules.vtkCommonDataModel import VTK_TETRA
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

HOSTILE = (
    "<img src=x onerror=alert(1)>",
    "\"' onclick='alert(1)' x=\"",
    "</title></style></script><script>alert(1)</script>",
    "&lt;b&gt;{}{0}%s<!--",
)
#: Names on disk cannot hold a slash.
FILE = "<img src=x onerror=alert(1)>\"'&.vtm"
#: Words that choose something, and are no names.
CHOICES = ("better", "date", "version")


class Structure(HTMLParser):
    """Elements and names of attributes of a page, values and text apart."""

    def __init__(self, page):
        super().__init__()
        self.elements, self.values, self.text = [], [], []
        self.feed(page)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.elements.append((tag, *(name for name, _ in attributes)))
        self.values += [value for _, value in attributes]

    def handle_endtag(self, tag):
        self.elements.append(("/" + tag,))

    def handle_comment(self, data):
        self.elements.append(("comment", data))

    def handle_data(self, data):
        self.text.append(data)


def rename(entry, name, key=None):
    """The entry with every text replaced."""
    if key in CHOICES or isinstance(entry, (bool, int, float)) or entry is None:
        return entry
    if isinstance(entry, dict):
        return {k: rename(v, name, k) for k, v in entry.items()}
    if isinstance(entry, list):
        return [rename(v, name, key) for v in entry]
    return name


class TestMarkup(camaron_testing.TestCase):
    def make_blocks(self, *names):
        """A file of blocks with such names, and a cell array that numbers them."""
        blocks = []
        for number, name in enumerate(names or HOSTILE):
            points = [(number, 0, 0), (number + 1, 0, 0), (number, 1, 0), (number, 0, 1 + number)]
            grid = make_grid(points, [(VTK_TETRA, (0, 1, 2, 3))])
            zones = vtkIntArray()
            zones.SetName("zone")
            zones.InsertNextValue(number)
            grid.GetCellData().AddArray(zones)
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetInputData(grid)
            writer.SetFileName(f"{number}.vtu")
            writer.Write()
            blocks.append(
                markup.html('<DataSet index="{0}" name="{1}" file="{0}.vtu"/>', number, name)
            )
        start = '<?xml version="1.0"?><VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
        Path(FILE).write_text(f"{start}{''.join(blocks)}</vtkMultiBlockDataSet></VTKFile>")
        return FILE

    def test_examples_in_the_code(self):
        for module in (markup, text):
            self.assertEqual(doctest.testmod(module).failed, 0)

    def test_every_name(self):
        """A page has the same elements and attributes whatever the names are, and shows these."""
        mesh = camaron_testing.EXAMPLES / "flange.visf"
        summary = json.loads(json.dumps(inspect(mesh, "report", with_pictures=False)))
        summary["notes"] = ["a warning"]
        compared = json.loads(json.dumps(compare(mesh, mesh)))
        compared["notes"] = ["a warning"]
        picture = Path("a.png")
        picture.write_bytes(b"no picture")
        pages = {
            "inspect": lambda s, n: report.render(s, [report.Picture(picture, n, n)]),
            "compare": lambda s, n: comparison_report.render(s),
        }
        for kind, original in (("inspect", summary), ("compare", compared)):
            plain = Structure(pages[kind](rename(original, "name"), "name"))
            self.assertGreater(len(plain.elements), 300)
            for name in HOSTILE:
                page = Structure(pages[kind](rename(copy.deepcopy(original), name), name))
                self.assertEqual(page.elements, plain.elements, f"{kind}: {name}")
                self.assertGreater("".join(page.text).count(name), 3)

    def test_files_with_such_names(self):
        """From the file to the page: its name, its blocks, an array to group by, the worst cells."""
        mesh = self.make_blocks()
        page = Structure(self.render(mesh))
        tags = {element[0] for element in page.elements}
        self.assertFalse(tags & {"img", "b>", "comment"})
        attributes = {name for element in page.elements for name in element[1:]}
        self.assertFalse({a for a in attributes if a.startswith("on")})
        self.assertEqual(sum(element[0] == "script" for element in page.elements), 1)
        shown = "".join(page.text)
        for name in (*HOSTILE, FILE):
            self.assertIn(name, shown)
        for way in ("block", "zone"):
            page = Structure(self.render(mesh, group_by=way))
            self.assertFalse({element[0] for element in page.elements} & {"img"})

    def render(self, mesh, **options):
        inspect(mesh, "report", with_pictures=False, **options)
        return Path("report/report.html").read_text("utf-8")

    def test_tables(self):
        """A block whose name is a formula of spreadsheets is text in tables."""
        mesh = self.make_blocks("=1+2", "-3", "@4")
        inspect(mesh, "report", with_pictures=False)
        select(mesh, ["All"], ["table.csv"])
        for table in ("report/worst.csv", "table.csv"):
            with open(table, encoding="utf-8", newline="") as file:
                names = {row.get("block", row.get("Block")) for row in csv.DictReader(file)}
            self.assertLessEqual(names, {"'=1+2", "'-3", "'@4"})
            self.assertGreater(len(names), 1)

    def test_verdicts(self):
        """Rules about such blocks, as JUnit's XML, which is read again."""
        mesh = self.make_blocks()
        result = check(mesh, [f"Volume >= 100 in '{HOSTILE[0]}'"])
        junit.write("verdicts.xml", [result], datetime.now(), Inputs())
        root = ElementTree.parse("verdicts.xml").getroot()
        self.assertEqual({e.tag for e in root.iter()} & {"img", "script"}, set())
        self.assertEqual(root.find("testsuite").get("name"), str(mesh))
        self.assertIn(HOSTILE[0], root.find("testsuite/testcase").get("name"))

    def test_templates(self):
        """Templates stand in the code, so that nothing gets into a page without being escaped."""
        folder = Path(camaron.__file__).parent
        found = 0
        for module in (report, comparison_report, svg):
            for node in ast.walk(ast.parse(Path(module.__file__).read_text("utf-8"))):
                name = getattr(getattr(node, "func", None), "id", None)
                if not isinstance(node, ast.Call) or name not in ("html", "Markup"):
                    continue
                self.assertEqual(name, "html", f"{module.__name__}:{node.lineno}")
                template = node.args[0]
                if isinstance(template, ast.Name):
                    template = self.constant(module, template)
                self.assertIsInstance(template, ast.Constant, f"{module.__name__}:{node.lineno}")
                found += 1
        self.assertGreater(found, 60)
        for path in folder.glob("*.py"):
            if path.name != "markup.py":
                self.assertNotIn("Markup(", path.read_text("utf-8"), path.name)

    def constant(self, module, name):
        """What the only assignments to a name in the module are."""
        values = [
            node.value
            for node in ast.walk(ast.parse(Path(module.__file__).read_text("utf-8")))
            if isinstance(node, ast.Assign)
            and [getattr(t, "id", None) for t in node.targets] == [name.id]
        ]
        self.assertTrue(values)
        self.assertTrue(all(isinstance(value, ast.Constant) for value in values), name.id)
        return values[0]


if __name__ == "__main__":
    camaron_testing.main()
