# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ranks of commands that wait for each other: they leave the processor to others, and wait for none that has failed."""

import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import camaron_testing
from paraview import simple

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
LAUNCHER = camaron_testing.ROOT / "Scripts" / "launcher"
COMMAND = camaron_testing.ROOT / "Scripts" / "camaron" / "__main__.py"
#: Seconds after which ranks that need about 5 are taken to wait for each other forever.
LONG = 60
#: Of this script the first rank runs the text, while the others wait for it.
WAITING = """
import time
from paraview import simple
sphere = simple.Sphere()
sphere.UpdatePipeline()
print("waits for", sphere.GetDataInformation().GetNumberOfCells(), flush=True)
time.sleep(600)
"""
#: Instead of pvbatch, does something to one rank before.
FAULTY = """#!/bin/bash
[[ ${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-}} != NUMBER ]] || { FAULT; }
exec PVBATCH "$@"
"""
#: Runs a script after one rank may only write small files.
LIMITED = """
import os, resource, runpy, sys
from pathlib import Path
rank, script = sys.argv[1:3]
wanted = "OMPI_COMM_WORLD_RANK=" + rank
for path in Path("/proc").glob("[0-9]*/stat"):
    parent = path.read_text().rsplit(")", 1)[1].split()[1]
    if int(parent) == os.getppid() and wanted in (path.parent / "environ").read_text().split(chr(0)):
        resource.prlimit(int(path.parent.name), resource.RLIMIT_FSIZE, (2000, 2000))
del sys.argv[:2]
runpy.run_path(script, run_name="__main__")
"""
#: Comes before each message of a command, see Scripts/launcher/with-ranks.
MARK = "camaron: "


def ranks_of(process):
    """Ids of the ranks that a process has started, in order, and of the mpiexec that waits for them."""
    parents, ranks = {}, []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            name, rest = path.read_text(errors="replace").rsplit(")", 1)
        except OSError:  # it has ended
            continue
        number = int(path.parent.name)
        parents[number] = int(rest.split()[1])
        if name.partition("(")[2] == "pvbatch":
            ranks.append(number)

    def ancestors(number):
        while number in parents:
            number = parents[number]
            yield number

    ranks = sorted(rank for rank in ranks if process.pid in ancestors(rank))
    return ranks, parents[ranks[0]] if ranks else None


def processor_time(number):
    """Seconds that a process has used."""
    fields = Path(f"/proc/{number}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@unittest.skipUnless(sys.platform == "linux", "processes are found as on Linux")
@unittest.skipUnless(shutil.which("mpiexec"), "no mpiexec")
class TestWaitingRanks(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.environment = camaron_testing.environment_alone()
        self.environment["PRTE_MCA_rmaps_default_mapping_policy"] = ":oversubscribe"
        self.environment["PYTHONFAULTHANDLER"] = "1"
        self.output = self.folder / "output"

    def start(self, ranks, script, *arguments):
        """Starts a script on ranks as the launcher does; they print to the file `output`."""
        with open(self.output, "w", encoding="utf-8") as output:
            process = subprocess.Popen(
                [str(LAUNCHER / "with-ranks"), str(ranks), *map(str, (script, *arguments))],
                env=self.environment,
                stdout=output,
                stderr=subprocess.STDOUT,
                cwd=self.folder,
            )
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        return process

    def start_waiting(self, ranks):
        script = self.folder / "waiting.py"
        script.write_text(WAITING)
        process = self.start(ranks, script)
        end = time.monotonic() + 200
        while "waits" not in self.output.read_text():
            self.assertLess(time.monotonic(), end, self.output.read_text())
            time.sleep(0.1)
        return process

    def end_with_stacks(self, process):
        """Aborts the ranks, for which Open MPI and Python print their stacks, and returns what they have printed."""
        ranks, mpiexec = ranks_of(process)
        if ranks:
            os.kill(mpiexec, signal.SIGSTOP)  # else it would kill the others after the first
            for rank in ranks:
                os.kill(rank, signal.SIGABRT)
            time.sleep(1)
            os.kill(mpiexec, signal.SIGCONT)
        process.wait(60)
        return self.output.read_text(errors="replace")

    def run_command(self, ranks, *arguments, script=()):
        """The exit status and the output of a command; the test fails with the stacks of all ranks if it takes long."""
        report = self.folder / "status"
        report.write_text("")
        self.environment["CAMARON_STATUS"] = str(report)
        process = self.start(ranks, *script, COMMAND, *arguments, "--ranks", ranks)
        try:
            process.wait(LONG)
        except subprocess.TimeoutExpired:
            self.fail(f"{arguments} takes more than {LONG} s:\n{self.end_with_stacks(process)}")
        return report.read_text().strip(), self.output.read_text(errors="replace")

    def make_faulty(self, rank, fault):
        """Lets a rank run a shell command before it starts."""
        program = self.folder / "bin" / "pvbatch"
        program.parent.mkdir(exist_ok=True)
        text = FAULTY.replace("NUMBER", str(rank)).replace("FAULT", fault)
        program.write_text(text.replace("PVBATCH", shutil.which("pvbatch")))
        program.chmod(0o755)
        self.environment["PATH"] = f"{program.parent}{os.pathsep}{os.environ['PATH']}"

    def test_sleep(self):
        """Ranks that wait use almost no processor time, also if other libraries are preloaded."""
        self.environment["LD_PRELOAD"] = "libm.so.6"
        ranks, _ = ranks_of(self.start_waiting(3))
        self.assertEqual(len(ranks), 3)
        before, start = [processor_time(rank) for rank in ranks], time.monotonic()
        time.sleep(5)
        seconds = time.monotonic() - start
        for rank, used in zip(ranks, before):
            self.assertLess(processor_time(rank) - used, 0.2 * seconds)

    def test_stacks(self):
        """Of ranks that wait forever, one sees where: in which functions, and in which line of Python."""
        text = self.end_with_stacks(self.start_waiting(3))
        self.assertIn('waiting.py", line 7', text)
        if (
            "libopen-pal" not in text or "C stack trace" in text
        ):  # of Python 3.14, beside Open MPI 6
            self.skipTest("no Open MPI that prints stacks of waiting ranks")
        self.assertEqual(text.count("vtkMultiProcessController11ProcessRMIsEv"), 2, text)

    def check_errors(self, commands, ranks=2, **options):
        """Each command ends with status 2 and one sentence, in which there are these words."""
        for words, *arguments in commands:
            with self.subTest(arguments=arguments):
                status, output = self.run_command(ranks, *arguments, **options)
                said = [line for line in output.splitlines() if line.startswith(MARK)]
                self.assertEqual((status, len(said)), ("2", 1), output)
                self.assertIn(words, said[0])

    def test_names(self):
        """What no rank finds."""
        (self.folder / "my.rules").write_text("Volum > 0\n")
        self.check_errors(
            [
                ("did you mean Volume", "check", BALL, "--rules", "my.rules"),
                ("none.rules", "check", BALL, "--rules", "none.rules"),
                ("none.txt", "inspect", BALL, "--ranges", "none.txt"),
                ("none.txt", "compare", BALL, BALL, "--ranges", "none.txt"),
                ("Nothing", "inspect", BALL, "--group-by", "Nothing"),
                ("Nothing", "select", BALL, "--by", "Worst N: Array=Nothing"),
            ]
        )

    def test_other_folder(self):
        """What only one rank does not find, because its current folder is another one."""
        (self.folder / "ranges.txt").write_text("Volume 0.1 1\n")
        shutil.copy(BALL, self.folder / "ball.visf")
        simple.SaveData(str(self.folder / "ball.vtu"), simple.OpenDataFile(str(BALL)))
        (self.folder / "other").mkdir()
        self.make_faulty(1, "cd other")
        self.check_errors(
            [
                ("ball.visf: ", "check", "ball.visf", "--preset", "General"),
                ("report", "inspect", BALL, "--no-pictures", "-o", "report"),
                ("out.pvtu", "convert", BALL, "out.pvtu"),
                ("out.vtm", "convert", BALL, "out.vtm"),
                ("bad.pvtu", "select", BALL, "--by", "All", "-o", "bad.pvtu"),
            ]
        )
        # What the first rank reads or writes for all of them, or names for them.
        self.assertEqual(self.run_command(2, "check", "ball.vtu", "--preset", "General")[0], "0")
        options = ("--no-pictures", "--no-mesh", "--ranges", "ranges.txt", "--json")
        status, output = self.run_command(2, "inspect", BALL, "-o", "ranged", *options)
        self.assertEqual(status, "0", output)
        self.assertIn('"ranges": "ranges.txt"', output)
        self.assertEqual(self.run_command(2, "convert", BALL, "out.stl")[0], "0")

    def test_full_disk(self):
        """What only one rank cannot write, be it the first or another."""
        limited = self.folder / "limited.py"
        limited.write_text(LIMITED)
        simple.SaveData(str(self.folder / "ball.vtu"), simple.OpenDataFile(str(BALL)))
        for rank in (0, 1):
            self.make_faulty(rank, "trap '' XFSZ")
            self.check_errors(
                [
                    ("report", "inspect", BALL, "--no-pictures", "-o", "report"),
                    ("out.pvtu", "convert", BALL, "out.pvtu"),
                    ("out.vtm", "convert", BALL, "out.vtm"),
                    *([("out.visf", "convert", BALL, "out.visf")] if rank == 0 else []),
                    ("bad.pvtu", "select", BALL, "--by", "All", "-o", "bad.pvtu"),
                ],
                script=(limited, rank),
            )


if __name__ == "__main__":
    camaron_testing.main()
