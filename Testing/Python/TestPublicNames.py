# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Public names consist of words of the glossary in CONTRIBUTING.md."""

import argparse
import re

import camaron
import camaron_testing
from camaron import cli
from camaron.checking import RulesError
from camaron.common import tables
from paraview import simple

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"

#: Names that contain a word of the glossary's last column in a sense that the glossary allows.
ALLOWED = {
    "CornerScaledJacobian": "the corner Jacobian",
    "Corner scaled Jacobian": "its label",
    "Verdict mean aspect Frobenius of corners": "angles at corners",
    "Side": "of a range",
    "NodeId": "the format says node",
    "NodeCode": "the format says node",
    "NodeComponents": "the format says node",
    ".node": "the format says node",
    **dict.fromkeys(
        (
            "MidsideNodeOffsetAlongEdge",
            "MidsideNodeOffsetFromEdge",
            "Midside node offset along the edge",
            "Midside node offset from the edge",
        ),
        "no vertices",
    ),
}


def split(name):
    """The words of a name in lower case, whether it is CamelCase, snake_case or text."""
    return re.findall(r"[a-z]+|[A-Z](?:[a-z]+|(?:[A-Z](?![a-z]))*)|\d+", name)


def is_in(phrase, words):
    """Whether the words of a phrase follow each other, each in the singular or plural."""
    words = [word.lower() for word in words]
    size = len(phrase)
    return any(
        all(w.rstrip("s") == p.rstrip("s") for w, p in zip(words[i : i + size], phrase))
        for i in range(len(words) - size + 1)
    )


def forbidden_phrases():
    """The last column of the glossary, as lists of words, without the conditions in parentheses."""
    text = (camaron_testing.ROOT / "CONTRIBUTING.md").read_text("utf-8")
    table = text[text.index("| term | means | instead of |") :]
    cells = re.findall(r"(?m)^\|[^|]*\|[^|]*\|([^|]*)\|$", table)[2:]
    phrases = [p for cell in cells for p in re.sub(r"\([^)]*\)", "", cell).split(",")]
    return [phrase.lower().split() for phrase in phrases if phrase.strip()]


def keys(value):
    """All keys of nested dictionaries and lists."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield key
            yield from keys(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from keys(inner)


class TestPublicNames(camaron_testing.TestCase):
    def check(self, names, at_least, kind):
        """That no name contains a forbidden phrase; there must be a certain number of names."""
        names = {name for name in names if name}
        self.assertGreaterEqual(len(names), at_least, kind)
        for name in sorted(names - set(ALLOWED)):
            for phrase in forbidden_phrases():
                self.assertFalse(is_in(phrase, split(name)), f"{kind} {name}: {' '.join(phrase)}")

    def test_glossary(self):
        """If the table were not found, every name would pass."""
        phrases = forbidden_phrases()
        self.assertGreater(len(phrases), 20)
        for word in ("null", "rings", "share", "kind", "wall"):
            self.assertIn([word], phrases)
        for name in ("NullCount", "null_fails", "NumberOfRings", "Worst share", "Change kind"):
            self.assertTrue(any(is_in(p, split(name)) for p in phrases), name)
        for name in ("Nullspace", "UndefinedCount", "sharer", "FacetOfHole"):
            self.assertFalse(any(is_in(p, split(name)) for p in phrases), name)

    def test_server_manager(self):
        """Names and labels of proxies, properties, groups, outputs and choices."""
        names = set()
        for pattern in ("Filters/*/*.xml", "Readers/*/*.xml", "Representations/*/*.xml*"):
            for path in camaron_testing.ROOT.glob(pattern):
                for element in camaron_testing.definition(path).iter():
                    names |= {element.get("name"), element.get("label")}
                    if element.tag in ("Entry", "String"):
                        names |= {element.get("text"), element.get("value")}
        self.check(names, 400, "XML name")

    def test_registry(self):
        """Names and labels of criteria, presets, arrays of elements, bits, and strategies."""
        table = simple.CriteriaTable()
        names = set()
        for port in range(5):
            for row in tables.fetch(table, port):
                names |= set(row)
                names |= {row.get(key) for key in ("Name", "Label", "Preset", "Criterion")}
        select = simple.SelectElements(Input=self.open(BALL))
        names |= set(select.GetProperty("Strategy").Available)
        self.check(names, 200, "name")

    def test_columns_and_arrays(self):
        """Columns of all tables, and arrays that filters add."""
        quality = simple.ElementQuality(
            Input=self.open(BALL), Criteria=["Volume", "MinDihedralAngle"], WriteUndefinedMask=1
        )
        filters = {
            simple.QualityStatistics(Input=quality, WeightArray="Volume"): 4,
            simple.CheckQuality(Input=quality, Rules="MinDihedralAngle >= 60"): 2,
            simple.CompareQuality(Input=quality, Other=quality): 2,
            simple.CorrelateQuality(Input=quality, Arrays=["Volume"]): 1,
            simple.QualityRegions(Input=quality, Array="MinDihedralAngle"): 1,
            simple.SelectionTable(
                Input=simple.SelectElements(Input=quality, Strategy="All", Array="Volume")
            ): 1,
        }
        names = set()
        for source, ports in filters.items():
            for port in range(ports):
                table = self.fetch(source, port)
                names |= {
                    table.GetColumnName(column) for column in range(table.GetNumberOfColumns())
                }
                fields = table.GetFieldData()
                names |= {fields.GetArrayName(array) for array in range(fields.GetNumberOfArrays())}
        names |= set(self.arrays(quality))
        self.assertIn("Volume_Undefined", names)
        for folder in ("Core", "Filters", "Readers", "Representations"):
            for path in (camaron_testing.ROOT / folder).rglob("*.cxx"):
                if "Testing" not in path.parts:
                    names |= set(re.findall(r'SetName\("(\w+)"\)', path.read_text("utf-8")))
        self.check(names, 150, "array or column")

    def arrays(self, source):
        data = self.fetch(source).GetCellData()
        return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]

    def test_json_and_options(self):
        """Keys of the JSON of all commands, and their options."""
        results = [
            camaron.inspect(BALL, self.folder / "report", with_pictures=False, with_mesh=False),
            camaron.check(BALL, ["Volume > 1", "Volume > 0 of polyhedra"]),
            camaron.compare(BALL, BALL, self.folder / "comparison"),
            camaron.select(BALL, ["Worst N: Array=Volume"]),
        ]
        names = set(keys(results)) - {str(percent) for percent in tables.QUANTILES}
        self.assertIn("undefined_fails", names)
        parser = cli._parser()
        (commands,) = [a for a in parser._actions if isinstance(a, argparse._SubParsersAction)]
        for command in commands.choices.values():
            for action in command._actions:
                names |= {option.lstrip("-") for option in action.option_strings}
        self.check(names, 100, "key or option")

    def test_rules(self):
        """Words of rules."""
        with self.assertRaises(RulesError) as caught:
            camaron.check(BALL, ["Volume > 0 x", "Volume > 0 of x"])
        words = re.findall(r"\w+", str(caught.exception))
        self.assertIn("tolerate", words)
        self.check(set(words), 15, "word of rules")


if __name__ == "__main__":
    camaron_testing.main()
