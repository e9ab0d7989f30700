# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin on one side only, and in different versions on client and server."""

import os
import shutil
import subprocess

import camaron_testing

CLIENT = """
import sys
from paraview.simple import *

assert Connect("127.0.0.1", int(sys.argv[1]))
exec(sys.argv[2])
mesh = Tetrahedralize(Input=Wavelet(WholeExtent=[0, 3, 0, 3, 0, 3]))
display = Show(mesh)
Render()
print("Mesh Inspection:", "Mesh Inspection" in display.GetProperty("Representation").Available)
"""
EVALUATE = "import camaron; camaron.load_plugin(); ElementQuality(Input=Sphere()).UpdatePipeline()"


@camaron_testing.require_display()
class TestPluginSides(camaron_testing.TestCase):
    def connect(self, client, server, command="pass"):
        """The output of a client that shows an unstructured grid of a server."""
        script = self.folder / "client.py"
        script.write_text(CLIENT, encoding="utf-8")
        done = subprocess.run(
            [
                shutil.which("pvpython"),
                str(script),
                str(self.start_server(plugins=server)),
                command,
            ],
            env={**os.environ, "PV_PLUGIN_PATH": str(client)},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=200,
        )
        return done.returncode, done.stdout

    def test_both(self):
        """Mesh Inspection is offered, and nothing is reported."""
        folder = camaron_testing.plugin_folder()
        self.assertEqual(self.connect(folder, folder, EVALUATE), (0, "Mesh Inspection: True\n"))

    def test_server_only(self):
        """ParaView would abort if it got representations that it cannot create."""
        found = self.connect("", camaron_testing.plugin_folder())
        self.assertEqual(found, (0, "Mesh Inspection: False\n"))

    def test_client_only(self):
        """Meshes are shown as without the plugin; loading it reports what is missing."""
        found = self.connect(camaron_testing.plugin_folder(), "")
        self.assertEqual(found, (0, "Mesh Inspection: False\n"))
        status, output = self.connect(camaron_testing.plugin_folder(), "", EVALUATE)
        self.assertEqual(status, 1)
        self.assertIn("RuntimeError: the server does not find the plugin Camaron: set PV", output)

    def test_versions(self):
        """One warning names both versions."""
        folder = camaron_testing.plugin_folder()
        version = (folder / "version.txt").read_text("utf-8").split()[1]
        other = version[:-4] + "beef"
        copy = self.folder / "Camaron"
        shutil.copytree(folder, copy)
        library = copy / "Camaron.so"
        content = library.read_bytes()
        self.assertIn(version.encode(), content)
        library.write_bytes(content.replace(version.encode(), other.encode()))
        status, output = self.connect(folder, copy)
        self.assertEqual(status, 0, output)
        self.assertEqual(output.count("The plugin Camaron is"), 1, output)
        self.assertIn(f"The plugin Camaron is {version} here but {other} on the server", output)
        self.assertTrue(output.endswith("Mesh Inspection: True\n"), output)


if __name__ == "__main__":
    camaron_testing.main()
