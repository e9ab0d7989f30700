# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `camaron check`: what it prints, its exit status, and its files."""

import contextlib
import io
import json
import os
import subprocess
from datetime import datetime
from xml.etree import ElementTree

import camaron_testing
import numpy
from camaron import check, cli
from camaron import checking
from camaron.checking import junit
from camaron.common import json_text
from camaron.common.inputs import Inputs

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
FLANGE = camaron_testing.EXAMPLES / "flange.visf"


class TestCommand(camaron_testing.TestCase):
    def run_check(self, *arguments):
        """The command in this process, which saves seconds for each."""
        words = ["check", *map(str, arguments)]
        out, err = io.StringIO(), io.StringIO()
        before = os.getcwd()
        os.chdir(self.folder)
        try:
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                status = cli.main(words)
        except SystemExit as end:  # argparse's
            status = end.code
        finally:
            os.chdir(before)
        return subprocess.CompletedProcess(words, status, out.getvalue(), err.getvalue())

    def rules(self, *lines):
        path = self.folder / "my.rules"
        path.write_text("\n".join(lines) + "\n")
        return path

    def test_table(self):
        """Verdicts, the cells that fail, and the exit status."""
        passed = self.run_check(BALL, "--rules", self.rules("Volume > 0", "FaceCount <= 22"))
        self.assertEqual((passed.returncode, passed.stderr), (0, ""))
        self.assertRegex(passed.stdout, r"(?m)^pass +Volume +> 0 +800 +0 +0 +0 +0\.0")
        self.assertIn("pass: 2 rules", passed.stdout)
        rules = self.rules("Volume > 0", "FaceCount <= 20")
        failed = camaron_testing.run_command("check", BALL, "--rules", rules, "--worst", 2)
        self.assertEqual((failed.returncode, failed.stderr), (1, ""))
        _, _, cells = camaron_testing.read_visf(BALL)
        counts = numpy.array([len(cell) for cell in cells])
        bad = int((counts > 20).sum())
        worst = numpy.argsort(-counts, kind="stable")[:2]
        self.assertIn(f"FaceCount <= 20: {bad} of 800 cells", failed.stdout)
        for cell in worst:
            self.assertRegex(failed.stdout, rf"(?m)^  {cell} +polyhedron +{counts[cell]} ")
        self.assertIn(f"  and {bad - 2} more\n", failed.stdout)
        self.assertIn("FAIL: 1 of 2 rules", failed.stdout)
        tolerated = self.run_check(
            BALL, "--rules", self.rules("FaceCount <= 20"), "--tolerate", str(bad)
        )
        self.assertEqual(tolerated.returncode, 0)

    def test_warnings(self):
        """Hints of a preset warn; written out as a rule they fail."""
        sliver = camaron_testing.write_vtk(
            self.folder / "sliver.vtk",
            [(0, 0, 0), (1.998, 0, 0), (0.999, 0.05, 0)],
            [(5, [0, 1, 2])],
        )
        warned = self.run_check(sliver, "--preset", "Overview", "--junit", "warned.xml")
        self.assertEqual(warned.returncode, 0, warned.stderr)
        self.assertRegex(
            warned.stdout,
            r"(?m)^WARN +EquiangleSkewness +<= 0\.9 +of triangles, [a-z, ]+ 1 +1 +100",
        )
        self.assertRegex(
            warned.stdout,
            r"EquiangleSkewness <= 0\.9 of triangles, [a-z, ]+: 1 of 1 cell \(100 %\) fails\n",
        )
        self.assertIn("WARN: 1 of 2 rules\n", warned.stdout)
        self.assertIn('failures="0"', (self.folder / "warned.xml").read_text())
        result = check(sliver, preset="Overview")
        self.assertEqual(result["verdict"], "warn")
        self.assertEqual(
            [(c["hint"], c["verdict"]) for c in result["checks"]], [(True, "empty"), (True, "warn")]
        )
        rules = self.rules("preset Overview", "EquiangleSkewness <= 0.9")
        failed = self.run_check(sliver, "--rules", rules)
        self.assertEqual(
            (failed.returncode, failed.stdout.splitlines()[-1]), (1, "FAIL: 1 of 2 rules")
        )
        square = camaron_testing.write_vtk(
            self.folder / "square.vtk",
            [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
            [(9, [0, 1, 2, 3])],
        )
        both = self.run_check(sliver, square, "--preset", "Overview", "--json")
        self.assertEqual((both.returncode, json.loads(both.stdout)["verdict"]), (0, "warn"))

    def test_several_meshes(self):
        """All are checked, the worst of them counts; JSON and JUnit have them in order."""
        rules = self.rules("FaceCount 4 20", "Volume > 0 of wedges", "Volume > 0 of triangles")
        odd = self.folder / "a&b <\"c'>.visf"
        odd.write_bytes(BALL.read_bytes())
        run = self.run_check(
            FLANGE, "none.visf", odd.name, "--rules", rules, "--json", "--junit", "new/check.xml"
        )
        self.assertEqual(run.returncode, 2)
        self.assertEqual(run.stderr, "camaron: none.visf: there is no such file\n")
        printed = json.loads(run.stdout, parse_constant=self.fail)
        self.assertEqual((printed["version"], printed["verdict"]), (1, "error"))
        self.assertEqual([m["verdict"] for m in printed["meshes"]], ["pass", "error", "fail"])
        self.assertEqual(printed["meshes"][1]["error"], "none.visf: there is no such file")
        self.assertEqual((printed["rules"], printed["rule"]), ([str(rules)], []))
        expected = json.loads(json_text.to_json(check(odd, rules, worst=5)))
        for key in ("checks", "cells", "notes"):
            self.assertEqual(printed["meshes"][2][key], expected[key])
        self.assertEqual([p.name for p in (self.folder / "new").iterdir()], ["check.xml"])
        suites = self.check_junit(self.folder / "new" / "check.xml")
        keys = ("tests", "failures", "errors", "skipped")
        counts = [tuple(int(suite.get(key)) for key in keys) for suite in suites]
        self.assertEqual(counts, [(3, 0, 0, 1), (1, 0, 1, 0), (3, 1, 0, 2)])
        names = [suite.get("name") for suite in suites]
        self.assertEqual(names, [str(FLANGE), "none.visf", odd.name])
        (failure,) = suites[2].iter("failure")
        worst = expected["checks"][0]["worst"][0]
        self.assertIn(f"cell {worst['id']} {worst['value']:g}", failure.get("message"))
        self.assertIn("FaceCount 4 to 20", failure.get("message"))
        self.assertEqual(
            [case.get("name") for case in suites[0].iter("testcase")],
            ["FaceCount 4 to 20", "Volume > 0 of wedges", "Volume > 0 of triangles"],
        )

    def check_junit(self, path):
        """The suites of a file with the order, the elements and the attributes of the schema."""
        attributes = {
            "testsuites": set(),
            "testsuite": set(
                "name package id tests failures errors skipped time timestamp hostname".split()
            ),
            "properties": set(),
            "testcase": {"name", "classname", "time"},
            "failure": {"message", "type"},
            "error": {"message", "type"},
            "skipped": {"message"},
            "system-out": set(),
            "system-err": set(),
        }
        root = ElementTree.parse(path).getroot()
        self.assertEqual(root.tag, "testsuites")
        for element in root.iter():
            self.assertEqual(set(element.attrib), attributes[element.tag], element.tag)
        for number, suite in enumerate(root):
            tags = [element.tag for element in suite]
            cases = tags.count("testcase")
            wanted = ["properties", *["testcase"] * cases, "system-out", "system-err"]
            self.assertEqual(tags, wanted)
            self.assertEqual((int(suite.get("id")), int(suite.get("tests"))), (number, cases))
            for tag, key in (("failure", "failures"), ("error", "errors"), ("skipped", "skipped")):
                self.assertEqual(len([*suite.iter(tag)]), int(suite.get(key)))
            datetime.strptime(suite.get("timestamp"), "%Y-%m-%dT%H:%M:%S")
            self.assertGreaterEqual(float(suite.get("time")), 0)
        return list(root)

    def test_junit_of_any_name(self):
        """Characters that XML cannot store do not make the file unreadable."""
        path = self.folder / "names.xml"
        result = checking.failed_to_check("a\x01\ud800]]>&\ufffe.vtu", "why \x00?")
        junit.write(path, [result], datetime(2020, 1, 2, 3, 4, 5, 678), Inputs())
        (suite,) = self.check_junit(path)
        self.assertEqual(suite.get("name"), "a??]]>&?.vtu")
        self.assertEqual(suite.get("timestamp"), "2020-01-02T03:04:05")

    def test_junit_is_whole_or_not_there(self):
        """An existing folder of that name is kept, and causes an error."""
        (self.folder / "report.xml").mkdir()
        rules = self.rules("Volume > 0")
        run = self.run_check(BALL, "--rules", rules, "--junit", "report.xml")
        self.assertEqual(run.returncode, 2)
        self.assertIn("report.xml: there is a folder of this name", run.stderr)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["my.rules", "report.xml"])

    def test_wrong_rules(self):
        """All wrong lines with file and line, status 2, and no mesh is read."""
        rules = self.rules("Volumen > 0", "Volume > 0", "Volume > x")
        run = self.run_check("none.visf", "--rules", rules, "--junit", "report.xml", "--json")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertEqual(
            run.stderr,
            f"camaron: {rules}:1: expected the name of a criterion, found 'Volumen'; "
            f"did you mean Volume?\ncamaron: {rules}:3: expected a number, found 'x'\n",
        )
        self.assertFalse((self.folder / "report.xml").exists())
        none = self.run_check(BALL)
        self.assertEqual(none.returncode, 2)
        self.assertIn("expected --rules FILE, --rule RULE or --preset P", none.stderr)
        missing = self.run_check(BALL, "--rules", "none.rules")
        self.assertEqual(missing.returncode, 2)
        self.assertRegex(missing.stderr, "^camaron: none.rules: No such file")
        wrong = self.run_check(BALL, "--preset", "Finite volume", "--tolerate", "0.1")
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("did you mean 0.1%?", wrong.stderr)

    def test_rules_add_up(self):
        """Files, single rules and a preset are checked together, and errors name each of them."""
        more = self.folder / "more.rules"
        more.write_text("FaceCount <= 22\n")
        words = ("--rules", self.rules("Volume > 0"), "--rule", "FaceCount <= 20", "--rules", more)
        run = self.run_check(BALL, *words, "--rule=FaceCount >= 4", "--preset", "VEM", "--json")
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        printed = json.loads(run.stdout)
        self.assertEqual(printed["rules"], [str(self.folder / "my.rules"), str(more)])
        self.assertEqual(printed["rule"], ["FaceCount <= 20", "FaceCount >= 4"])
        checks = printed["meshes"][0]["checks"]
        found = [c["rule"] for c in checks if not c["preset"]]
        rules = ["Volume > 0", "FaceCount <= 22", "FaceCount <= 20", "FaceCount >= 4"]
        self.assertEqual(found, rules)
        self.assertGreater(len(checks), len(found))
        run = self.run_check(BALL, "--rule", "Volume > 0", "--rule", "Volumen > 0")
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, "^camaron: --rule 2: expected the name of a criterion")
        run = self.run_check(BALL, "--rule", "Volume > 0", "--rule", "Volume > 0")
        self.assertIn("--rule 2: expected a rule other than that of --rule 1, found", run.stderr)

    def test_rules_of_streams(self):
        """Rules from standard input and from a pipe."""
        words = ("check", BALL, "--json", "--rules", "-", "--rule", "Volume > 0")
        run = camaron_testing.run_command(*words, input="FaceCount <= 20\n")
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        checks = json.loads(run.stdout)["meshes"][0]["checks"]
        self.assertEqual([c["rule"] for c in checks], ["FaceCount <= 20", "Volume > 0"])
        self.assertEqual([c["line"] for c in checks], [1, 1])
        for text, message in (
            ("\nVolumen > 0\n", "camaron: stdin:2: expected the name of a criterion"),
            (" # none\n\n", "camaron: stdin: expected at least one rule, found none"),
            ("Volume > 0\0", "camaron: stdin: expected text, found a zero byte"),
            ("#" * (1 << 20) + "\n", "camaron: stdin: too large for a file of rules"),
        ):
            run = camaron_testing.run_command(*words, input=text)
            self.assertEqual(run.returncode, 2)
            self.assertRegex(run.stderr, "^" + message)
        os.mkfifo(self.folder / "pipe")
        with subprocess.Popen(["sh", "-c", "echo 'Volume > 0' >pipe"], cwd=self.folder):
            run = self.run_check(BALL, "--rules", "pipe")
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_preset(self):
        run = self.run_check(BALL, "--preset", "finite volume", "--tolerate", "100%", "--json")
        self.assertEqual(run.returncode, 0)
        printed = json.loads(run.stdout)
        self.assertEqual(printed["preset"], "Finite volume")
        self.assertEqual({c["tolerance"] for c in printed["meshes"][0]["checks"]}, {"100%"})


if __name__ == "__main__":
    camaron_testing.main()
