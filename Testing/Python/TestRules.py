# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The language of rules: what a line means, and what is said about a wrong one."""

import doctest
import math
import os
import random
from fractions import Fraction

import camaron_testing
from camaron.checking import rules
from camaron.common import tables
from camaron.checking.rules import Parser, RulesError, Scope, Tolerance

CRITERIA = ["Volume", "MinDihedralAngle", "EdgeLengthRatio", "FaceCount"]
PRESETS = {
    "Finite volume": {
        "rules": {"Volume": [2e-308, None], "EdgeLengthRatio": [None, None]},
        "hints": [],
        "shapes": {},
    },
    "Shape": {
        "rules": {"EdgeLengthRatio": [0.25, None], "Volume": [0.5, None]},
        "hints": ["EdgeLengthRatio"],
        "shapes": {},
    },
}
SHAPES = ", ".join([*rules.FAMILIES, *rules.FAMILY_SETS])
CLAUSES = "expected of, in, where, tolerate, null or end of line"


def parser(**options):
    return Parser(CRITERIA, PRESETS, ["Tetra", "Hexahedron"], **options)


def parse(*lines, **options):
    return parser(**options).parse(lines)


class TestRules(camaron_testing.TestCase):
    def test_examples_in_the_code(self):
        result = doctest.testmod(rules)
        self.assertEqual(result.failed, 0)
        self.assertGreater(result.attempted, 3)

    def test_ranges(self):
        """Numbers in range are those between the limits of a Rule, both included."""
        above = lambda x: math.nextafter(x, math.inf)
        below = lambda x: math.nextafter(x, -math.inf)
        most = math.nextafter(math.inf, 0)
        for words, expected in (
            ("1 2", (1, 2)),
            ("1 *", (1, most)),
            ("- 2", (-most, 2)),
            ("-inf 2", (-most, 2)),
            ("-1.5e-3 +1d3", (-0.0015, 1000)),
            (">= 10", (10, most)),
            (">=10", (10, most)),
            ("> 0", (above(0), most)),
            ("> 1", (above(1), most)),
            ("<= 1e3", (-most, 1000)),
            ("< 5", (-most, below(5))),
            ("= 3", (3, 3)),
            ("== 3", (3, 3)),
            ("> 1 <= 2", (above(1), 2)),
            ("< 2 >= 1", (1, below(2))),
            ("3 3", (3, 3)),
        ):
            with self.subTest(words):
                (rule,) = parse(f"Volume {words}")
                self.assertEqual(rule.limits(), expected)
                # What is printed is a rule of the same meaning, but for the words of two limits.
                again = parse(str(rule).replace(" to ", " "))[0]
                self.assertEqual(again.limits(), expected)

    def test_clauses(self):
        for words, member, expected in (
            ("", "scope", None),
            ("of tetrahedra", "scope", Scope("family", "tetrahedra")),
            ("of Tetrahedron", "scope", Scope("family", "tetrahedra")),
            ("of wedge", "scope", Scope("family", "wedges")),
            ("of type Tetra", "scope", Scope("type", "Tetra")),
            ("in rotor/blades", "scope", Scope("block", "rotor/blades")),
            ('in "my # block"', "scope", Scope("block", "my # block")),
            ("in 'a \"b\"'", "scope", Scope("block", 'a "b"')),
            ("in of", "scope", Scope("block", "of")),
            ("where Material = 3", "scope", Scope("array", 3, "Material")),
            ("where 'my array'=-3", "scope", Scope("array", -3, "my array")),
            ("where Material == 3.0", "scope", Scope("array", 3, "Material")),
            ("tolerate 0.1%", "tolerance", Tolerance(percent=Fraction(1, 1000) * 100)),
            ("tolerate 0.1 %", "tolerance", Tolerance(percent=Fraction(1, 10))),
            ("tolerate 100%", "tolerance", Tolerance(percent=Fraction(100))),
            ("tolerate 1e-3%", "tolerance", Tolerance(percent=Fraction(1, 1000))),
            ("tolerate 5", "tolerance", Tolerance(count=5)),
            ("tolerate 5 cells", "tolerance", Tolerance(count=5)),
            ("tolerate 1 cell", "tolerance", Tolerance(count=1)),
            ("", "tolerance", Tolerance()),
            ("", "null_fails", True),
            ("null fails", "null_fails", True),
            ("null passes", "null_fails", False),
        ):
            with self.subTest(words):
                (rule,) = parse(f"Volume > 0 {words}  # a comment")
                self.assertEqual(getattr(rule, member), expected)
                if member == "scope":
                    self.assertEqual(parse(str(rule))[0].scope, expected)
        (rule,) = parse("Volume 0 1 null passes tolerate 2% of wedges")
        self.assertEqual(
            (rule.scope.value, rule.tolerance.percent, rule.null_fails), ("wedges", 2, False)
        )

    def test_files(self):
        """Line ends of every system, a mark of the byte order, comments, blank lines."""
        path = self.folder / "my.rules"
        path.write_bytes(
            b"\xef\xbb\xbf# mine\r\n\r\nVolume > 0 # all\rFaceCount 4 20\n\t\nEdgeLengthRatio>=.1"
        )
        found = parser().read(path)
        self.assertEqual(
            [(rule.criterion, rule.line) for rule in found],
            [("Volume", 3), ("FaceCount", 4), ("EdgeLengthRatio", 6)],
        )
        path.write_bytes(b"Volume > 0 # \xff\xfe\n")
        with self.assertRaisesRegex(RulesError, "my.rules: expected text in UTF-8"):
            parser().read(path)
        path.write_bytes(b"#" * (rules.MAX_SIZE + 1))
        with self.assertRaisesRegex(RulesError, "my.rules: too large"):
            parser().read(path)
        path.write_bytes(b"Volume > 0\0\n")
        with self.assertRaisesRegex(RulesError, "my.rules: expected text, found a zero byte"):
            parser().read(path)
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        for special in (pipe, "/dev/zero"):
            with self.assertRaisesRegex(
                RulesError, "expected a file of rules, found a pipe or a device"
            ):
                parser().read(special)
        with self.assertRaisesRegex(RulesError, "Is a directory"):
            parser().read(self.folder)
        with self.assertRaisesRegex(RulesError, "none.rules: No such file"):
            parser().read(self.folder / "none.rules")

    def test_files_of_ranges(self):
        """What Quality Statistics takes as a file of ranges are rules with the same limits."""
        path = self.folder / "solver.txt"
        path.write_text(
            "# name  lowest highest\nMinDihedralAngle  15 *# none\n\nTetRadiusEdgeRatio - 1.8d0\n"
            "MaxFaceSkewness -inf +4\nFaceCount 4 INF\nVolume * *\nEdgeLengthRatio .25 1e0\n"
        )
        ranges = tables.known_ranges(path)
        self.assertEqual(ranges.pop("Volume"), [None, None])
        found = Parser(tables.known_criteria(), {}, []).read(path)
        self.assertEqual({rule.criterion: [rule.low, rule.high] for rule in found}, ranges)

    def test_several_shapes(self):
        """Shapes in a row, sets of them, and those of presets, which rules of one's own replace."""
        for words, families in (
            ("tetrahedron, wedges", ["tetrahedra", "wedges"]),
            ("2D cells", ["triangles", "quadrangles", "polygons"]),
            ("pyramids, 2d", ["pyramids", "triangles", "quadrangles", "polygons"]),
        ):
            (rule,) = parse(f"Volume >= 7 of {words} null passes")
            self.assertEqual(rule.scope.families(), families)
            self.assertEqual(parse(str(rule))[0].scope, rule.scope, "what it says is read again")
        with self.assertRaisesRegex(rules.RulesError, "expected type, or a shape"):
            parse("Volume >= 7 of wedges,")
        presets = {
            "P": {"rules": {"Volume": [1, None]}, "hints": [], "shapes": {"Volume": "wedges"}}
        }
        limited = lambda *lines: [str(r) for r in Parser(CRITERIA, presets, []).parse(lines)]
        self.assertEqual(limited("preset P"), ["Volume >= 1 of wedges"])
        self.assertEqual(limited("preset P", "Volume >= 2"), ["Volume >= 2"])
        self.assertEqual(limited("preset P in rotor"), ["Volume >= 1 in rotor"])

    def test_presets(self):
        """Rules that are written out replace those of presets, of which the last one counts."""
        names = lambda *lines: [(r.criterion, r.low, r.preset) for r in parse(*lines)]
        whole = ("Volume", 2e-308, "Finite volume")
        self.assertEqual(names('preset "finite volume"'), [whole])
        ratio = ("EdgeLengthRatio", 0.25, "Shape")
        self.assertEqual(
            names('preset "Finite volume"', "preset Shape"), [("Volume", 0.5, "Shape"), ratio]
        )
        for lines in (("Volume >= 7", "preset Shape"), ("preset Shape", "Volume 7 *")):
            self.assertEqual(names(*lines), [ratio, ("Volume", 7, None)])
        # Other cells are another matter.
        self.assertEqual(
            names("preset Shape", "Volume >= 7 of wedges"),
            [ratio, ("Volume", 0.5, "Shape"), ("Volume", 7, None)],
        )
        self.assertEqual(names("preset Shape", "Volume * *"), [ratio])
        hints = lambda *lines: [rule.criterion for rule in parse(*lines) if rule.hint]
        self.assertEqual(
            hints("preset Shape of wedges", 'preset "Finite volume"'), ["EdgeLengthRatio"]
        )
        self.assertEqual(hints("preset Shape", "EdgeLengthRatio >= 0.25"), [])
        (rule, _) = parse("preset Shape of wedges tolerate 3 null passes")
        self.assertEqual(
            (rule.scope.value, rule.tolerance.count, rule.null_fails), ("wedges", 3, False)
        )

    def test_steps(self):
        """Several rules of one criterion all hold."""
        found = parse("Volume > 1 tolerate 1%", "Volume > 0")
        self.assertEqual([rule.low for rule in found], [1, 0])

    def test_default_tolerance(self):
        """That of the command line is for rules that do not say."""
        default = Tolerance(count=7)
        found = parse(
            "Volume > 0",
            "FaceCount < 9 tolerate 0",
            "preset Shape",
            "preset Shape of wedges tolerate 1%",
            tolerance=default,
        )
        tolerated = {(r.criterion, str(r.scope)): str(r.tolerance) for r in found}
        self.assertEqual(
            tolerated,
            {
                ("Volume", "None"): "7",
                ("EdgeLengthRatio", "None"): "7",
                ("FaceCount", "None"): "0",
                ("Volume", "of wedges"): "1%",
                ("EdgeLengthRatio", "of wedges"): "1%",
            },
        )
        with self.assertRaisesRegex(ValueError, "--tolerate: expected a percentage .* mean 0.5%"):
            rules.tolerance("0.5")
        with self.assertRaisesRegex(ValueError, "--tolerate: expected end of text, found 'b'"):
            rules.tolerance("5 b")

    def test_shares_are_exact(self):
        """The share passes, one more cell does not, without rounding."""
        for words, checked, allowed in (
            ("0.1%", 1000, 1),
            ("0.1%", 999, 0),
            ("0.7%", 1000, 7),  # 1000 * 0.007 is 7.000000000000001 in floating point
            ("33.3%", 1000, 333),
            ("29%", 100, 29),  # 100 * 0.29 is 28.999999999999996
            ("0.0000000001%", 10**12, 1),
            ("0.0000000001%", 10**12 - 1, 0),
            ("100%", 3, 3),
            ("0%", 3, 0),
            ("2", 1, 2),
        ):
            self.assertEqual(rules.tolerance(words).cells(checked), allowed, words)

    def test_wrong_lines(self):
        """Each tells what was expected, what was found, and what may have been meant."""
        for line, message in (
            (
                "MinDihedralAngel >= 10",
                "expected the name of a criterion, found 'MinDihedralAngel'; did you mean MinDihedralAngle?",
            ),
            (
                "volume >= 10",
                "expected the name of a criterion, found 'volume'; did you mean Volume?",
            ),
            ("qqq >= 10", "expected the name of a criterion, found 'qqq'"),
            (">= 10", "expected the name of a criterion, found '>='"),
            ("q\0q >= 10", "expected the name of a criterion, found 'q\\x00q'"),
            (1000 * "q" + " >= 10", f"expected the name of a criterion, found '{59 * 'q'}..."),
            ("Volume", "expected a range: >= 10, or a lower and an upper limit, found end of line"),
            ("Volume of wedges", "expected the lower limit: a number, or * for none, found 'of'"),
            ("Volume 1", "expected the upper limit: a number, or * for none, found end of line"),
            ("Volume 1 x", "expected the upper limit: a number, or * for none, found 'x'"),
            ("Volume nan *", "expected the lower limit: a number, or * for none, found 'nan'"),
            ("Volume 1 2 3", CLAUSES + ", found '3'"),
            (
                "Volume 2 1",
                "expected a lower limit that is not above the upper limit, found Volume 2 to 1",
            ),
            (
                "Volume > 1 < 1",
                "expected a lower limit that is not above the upper limit, found Volume > 1 < 1",
            ),
            ("Volume inf *", "expected a range with values, found none of Volume"),
            ("Volume > x", "expected a number, found 'x'"),
            ("Volume >", "expected a number, found end of line"),
            ("Volume < inf", "expected a finite number after <, found inf"),
            ("Volume > 1 >= 2", "expected one lower and one upper limit, found another: '>='"),
            ("Volume = 1 < 2", "expected one lower and one upper limit, found another: '<'"),
            ("Volume > 0 of", f"expected type, or a shape: {SHAPES}, found end of line"),
            (
                "Volume > 0 of tetraeder",
                f"expected type, or a shape: {SHAPES}, found 'tetraeder'; did you mean tetrahedra?",
            ),
            (
                "Volume > 0 of type Tetrah",
                "expected VTK's name of a cell type, such as Tetra, found 'Tetrah'; did you mean Tetra?",
            ),
            ("Volume > 0 in", "expected the name of a block, found end of line"),
            ("Volume > 0 where", "expected the name of a cell array, found end of line"),
            ("Volume > 0 where Material 3", "expected = after Material, found '3'"),
            ("Volume > 0 where Material > 3", "expected = after Material, found '>'"),
            ("Volume > 0 where Material = steel", "expected an integer, found 'steel'"),
            ("Volume > 0 where Material = 3.5", "expected a 64-bit integer, found '3.5'"),
            (
                "Volume > 0 where Material = 2e19",
                "expected a 64-bit integer, found '2e19'",
            ),
            (
                "Volume > 0 where Material = 9007199254740992.5",
                "expected a 64-bit integer, found '9007199254740992.5'",
            ),
            ("Volume > 0 where Material = inf", "expected a 64-bit integer, found 'inf'"),
            (
                "Volume > 0 tolerate",
                "expected a percentage such as 0.1%, or a number of cells, found end of line",
            ),
            (
                "Volume > 0 tolerate few",
                "expected a percentage such as 0.1%, or a number of cells, found 'few'",
            ),
            (
                "Volume > 0 tolerate -1",
                "expected a percentage such as 0.1%, or a number of cells, found '-1'",
            ),
            (
                "Volume > 0 tolerate 0.1",
                "expected a percentage such as 0.1%, or a number of cells, found '0.1'; did you mean 0.1%?",
            ),
            ("Volume > 0 tolerate 101%", "expected a percentage of at most 100%, found '101%'"),
            ("Volume > 0 null", "expected fails or passes after null, found end of line"),
            (
                "Volume > 0 null pass",
                "expected fails or passes after null, found 'pass'; did you mean passes?",
            ),
            ("Volume > 0 tolerat 1%", CLAUSES + ", found 'tolerat'; did you mean tolerate?"),
            (
                "Volume > 0 of wedges in x",
                "expected one of the words of, in and where, found another: 'in'",
            ),
            (
                "Volume > 0 tolerate 1 tolerate 1",
                "expected one tolerate, found another: 'tolerate'",
            ),
            ("Volume > 0 null fails null fails", "expected one null, found another: 'null'"),
            ('Volume > 0 in "my block', 'expected a closing ", found end of line'),
            ("preset", "expected the name of a preset, found end of line"),
            (
                "preset Finite volume",
                "expected the name of a preset, found 'Finite'; did you mean Finite volume?",
            ),
            ("preset Shape 1 2", CLAUSES + ", found '1'"),
        ):
            with self.subTest(line):
                with self.assertRaises(RulesError) as caught:
                    parse("# first", line)
                self.assertEqual(str(caught.exception), f"rules:2: {message}")

    def test_all_that_is_wrong(self):
        """All wrong lines at once, each with its number."""
        with self.assertRaises(RulesError) as caught:
            parse(
                "Volume > x",
                "Volume > 0",
                "",
                "FaceCont > 1",
                "Volume 0 *",
                "Volume > 0 of wedges",
                "Volume > 0",
            )
        self.assertEqual(
            caught.exception.problems,
            [
                "rules:1: expected a number, found 'x'",
                "rules:4: expected the name of a criterion, found 'FaceCont'; "
                "did you mean FaceCount?",
                "rules:7: expected a rule other than that of line 2, found Volume > 0 again",
            ],
        )
        for lines in ((), ("# nothing",), ("Volume * *",)):
            with self.assertRaisesRegex(RulesError, "^rules: expected at least one criterion"):
                parse(*lines)

    def test_whatever_the_text(self):
        """Any line is a rule or an error, never another exception."""
        words = (
            "Volume > >= = 1 * - inf of in where null % ' \" # type tolerate preset \0 é".split()
        )
        choose = random.Random(3)
        known = parser()
        outcomes = set()
        for _ in range(20000):
            line = choose.choice(("", " ")).join(choose.choices(words, k=choose.randint(1, 7)))
            try:
                known.parse([line, "FaceCount > 0"])
                outcomes.add("rule")
            except RulesError as error:
                self.assertRegex(str(error), "^rules:1: expected .* found ")
                outcomes.add("error")
        self.assertEqual(outcomes, {"rule", "error"})


if __name__ == "__main__":
    camaron_testing.main()
