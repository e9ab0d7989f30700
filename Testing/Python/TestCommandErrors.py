# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever ends a command early causes an error of one line, and leaves no files behind."""

import os
import shutil
import subprocess
import unittest

import camaron_testing
from camaron.common.files import Staging
from camaron.common.inputs import Inputs

#: Opens a display that ends before it is asked again.
LOSE_DISPLAY = """
import ctypes, os, signal, subprocess, sys
read, write = os.pipe()
server = subprocess.Popen(
    ["Xvfb", "-displayfd", str(write), "-screen", "0", "64x64x24", "-nolisten", "tcp"],
    pass_fds=[write], stderr=subprocess.DEVNULL)
os.environ["DISPLAY"] = ":" + os.read(read, 20).decode().strip()
from camaron.inspection import pictures
sys.stderr = sys.__stderr__
pictures.end_with_display()
xlib = ctypes.CDLL("libX11.so.6")
xlib.XOpenDisplay.restype = ctypes.c_void_p
display = xlib.XOpenDisplay(None)
server.kill()
server.wait()
print(os.environ["DISPLAY"], flush=True)
xlib.XSync(ctypes.c_void_p(display), 0)
print("went on")
"""


class TestCommandErrors(camaron_testing.TestCase):
    @unittest.skipUnless(shutil.which("Xvfb"), "no Xvfb")
    def test_display(self):
        done = subprocess.run(
            [shutil.which("pvpython"), "-c", LOSE_DISPLAY],
            env=camaron_testing.environment_alone(),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            timeout=240,
        )
        name = done.stdout.strip()
        self.assertEqual(
            done.stderr, f"camaron: the display {name} disappeared while pictures were rendered\n"
        )
        self.assertEqual(done.returncode, 2)

    def test_streams(self):
        """A stream that does not accept anything is an error, not a verdict or a traceback."""
        full = open("/dev/full", "w")
        self.addCleanup(full.close)
        for options, errors in (
            ({"stdout": full}, "camaron: standard output: No space left on device\n"),
            ({"stderr": full, "stdout": full}, None),
        ):
            for arguments in (["criteria", "Volume"], ["check", "--help"]):
                done = camaron_testing.run_command(*arguments, **options)
                self.assertEqual((done.returncode, done.stderr), (2, errors), arguments)

    def test_folder_in_other_bytes(self):
        """In a folder whose name is not valid UTF-8, which VTK would refuse, commands write as elsewhere."""
        folder = os.fsencode(self.folder) + b"/\xff"
        os.mkdir(folder)
        mesh = camaron_testing.EXAMPLES / "voronoi-ball.visf"
        for arguments in (
            ["convert", mesh, "mesh.vtu"],
            ["convert", mesh, "new/mesh.off"],
            ["select", mesh, "--by", "All", "-o", "all.csv", "-o", "all.vtu"],
            ["inspect", mesh, "--no-pictures", "-o", "report"],
            ["compare", mesh, mesh, "-o", "compared"],
        ):
            done = camaron_testing.run_command(*arguments, cwd=folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
        names = b"all.csv all.vtu compared mesh.vtu new report".split()
        self.assertEqual(sorted(os.listdir(folder)), names)

    @unittest.skipUnless(
        hasattr(os, "geteuid") and os.geteuid() == 0, "only root makes links of others"
    )
    def test_links_of_others(self):
        """Nobody gets another user's file replaced by a link in a folder such as /tmp."""
        mesh = camaron_testing.EXAMPLES / "voronoi-ball.visf"
        precious = self.folder / "precious"
        precious.write_text("precious")
        shared = self.folder / "shared"
        shared.mkdir()
        shared.chmod(0o1777)
        for name in ("out.vtu", "out.off"):
            link = shared / name
            link.symlink_to(precious)
            os.chown(link, 65534, 65534, follow_symlinks=False)
            done = camaron_testing.run_command("convert", mesh, link)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, f"^camaron: .*{name}: .*\n$")
        self.assertEqual(precious.read_text(), "precious")

    def test_names(self):
        """Errors give the final path of a file, not the one in the temporary folder."""
        for make, expected in (
            (lambda path: RuntimeError(f"{path}: cannot write"), "mesh.vtu: cannot write"),
            (lambda path: OSError(28, "No space", str(path)), "[Errno 28] No space: '{}mesh.vtu'"),
            (lambda path: OSError(28, "No space"), "[Errno 28] No space: '{}mesh.vtu'"),
        ):
            folder = self.folder / "new" / "report"
            with self.assertRaises((RuntimeError, OSError)) as caught:
                with Staging(folder, Inputs()) as staging:
                    (staging.path / "mesh.vtu").write_text("half")
                    raise make(staging.path / "mesh.vtu")
            if isinstance(caught.exception, RuntimeError):
                expected = f"{folder}/{expected}"
            self.assertEqual(str(caught.exception), expected.format(f"{folder}/", folder=folder))
            self.assertEqual(list(self.folder.iterdir()), [])


camaron_testing.main()
