# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ranks and servers that are killed, stopped or short of processor time: the others end, report it, and leave nothing behind."""

import contextlib
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import camaron_testing
from camaron.common import pipeline
from paraview import simple

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
LAUNCHER = camaron_testing.ROOT / "Scripts" / "launcher"
COMMAND = camaron_testing.ROOT / "Scripts" / "camaron" / "__main__.py"
#: Seconds after which ranks on a machine with nothing else to do are taken to wait for each other forever.
LONG = 60

#: A script of which only the first rank runs the text, while the others wait.
WAITING = """
import os, sys, time
from paraview import servermanager
assert servermanager.ActiveConnection.GetNumberOfDataPartitions() == 3
print("waits", flush=True)
time.sleep(600)
"""

#: A client of a server of several ranks. It takes a step, and another one when the server may have ended.
CLIENT = """
import sys
from paraview import servermanager, simple
import camaron
port, path, out, earlier, step = sys.argv[1:]
simple.Connect("127.0.0.1", int(port))
camaron.load_plugin(globals())
mesh = simple.OpenDataFile(path)
quality = simple.ElementQuality(Input=mesh, Preset="General")
statistics = simple.QualityStatistics(Input=quality)
steps = {
    "read": mesh.UpdatePipeline,
    "evaluate": quality.UpdatePipeline,
    "gather information": lambda: statistics.GetDataInformation().GetNumberOfRows(),
    "fetch a table": lambda: servermanager.Fetch(statistics),
    "write": lambda: simple.SaveData(out, quality),
    "draw": lambda: simple.Render(),
    "delete": lambda: simple.Delete(statistics),
    "check": lambda: camaron.check(path, preset="General"),
    "select": lambda: camaron.select(path, ["All"]),
    "inspect": lambda: camaron.inspect(path, out),
}
if step == "draw":
    simple.Show(quality)
for name in filter(None, earlier.split(",")):
    steps[name]()
print("ready", flush=True)
sys.stdin.readline()
try:
    steps[step]()
except Exception as error:
    print(f"{type(error).__name__}: {error}", flush=True)
print("went on", flush=True)
"""


def processes(program, argument):
    """Ids of the processes of a program that were called with this argument, in order."""
    found = []
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            name, *arguments = path.read_bytes().decode(errors="replace").split("\0")
        except OSError:  # it has ended
            continue
        if Path(name).name == program and argument in arguments:
            found.append(int(path.parent.name))
    return sorted(found)


def processor_time(ids):
    """Seconds that processes have used."""
    ticks = 0
    for number in ids:
        fields = Path(f"/proc/{number}/stat").read_text().rsplit(")", 1)[1].split()
        ticks += int(fields[11]) + int(fields[12])
    return ticks / os.sysconf("SC_CLK_TCK")


@unittest.skipUnless(sys.platform == "linux", "processes are found as on Linux")
@unittest.skipUnless(shutil.which("mpiexec"), "no mpiexec")
class TestRanks(camaron_testing.TestCase):
    def start(self, ranks, script, *arguments):
        """Starts a script on ranks as the command does, in a process group; its output goes to the file "output"."""
        environment = camaron_testing.environment_alone()
        environment["PRTE_MCA_rmaps_default_mapping_policy"] = ":oversubscribe"
        with open(self.folder / "output", "w", encoding="utf-8") as output:
            process = subprocess.Popen(
                [str(LAUNCHER / "with-ranks"), str(ranks), *map(str, [script, *arguments])],
                env=environment,
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def output(self):
        return (self.folder / "output").read_text(errors="replace")

    def await_(self, condition, seconds=200):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, self.output())
            time.sleep(0.05)

    def print_stacks(self, process, ranks):
        """Aborts the ranks, for which Open MPI prints their stacks, and returns what they have printed."""
        (mpiexec,) = processes("prterun", str(ranks)) or processes("mpiexec", str(ranks))
        for name, signals in (
            (mpiexec, [signal.SIGSTOP]),
            *((r, [signal.SIGABRT, signal.SIGCONT]) for r in []),
            (mpiexec, [signal.SIGCONT]),
        ):
            for number in signals:
                os.kill(name, number)
        return self.output()
