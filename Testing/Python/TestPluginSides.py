# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin on one side only, in different versions on client and server, and with and without its panel."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import camaron_testing
import window_testing

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
#: Startup script of ParaView's window, which writes what it has loaded of ours.
IN_WINDOW = """
import os
from paraview import servermanager, simple

COMMAND
local = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().GetLocalInformation()
plugins = [
    local.GetPluginName(i) for i in range(local.GetNumberOfPlugins()) if local.GetPluginLoaded(i)
]
with open("found", "w") as file:
    print(*(name for name in plugins if "Camaron" in name), file=file)
os._exit(0)
"""
EVALUATE = "import camaron; camaron.load_plugin(); ElementQuality(Input=Sphere()).UpdatePipeline()"


def copy_of_version(parent, file):
    """A copy of the plugin whose file says another version; the folder and both versions."""
    folder = camaron_testing.plugin_folder()
    version = (folder / "version.txt").read_text("utf-8").split()[1]
    other = version[:-4] + "beef"
    copy = parent / "Camaron"
    shutil.copytree(folder, copy)
    content = (copy / file).read_bytes()
    assert version.encode() in content
    (copy / file).write_bytes(content.replace(version.encode(), other.encode()))
    return copy, version, other


@camaron_testing.require_display()
class TestPluginSides(camaron_testing.TestCase):
    def connect(self, client, server, command="pass"):
        """The output of a client that shows an unstructured grid of a server."""
        script = self.folder / "client.py"
        script.write_text(camaron_testing.QUICK_START + CLIENT, encoding="utf-8")
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
        copy, version, other = copy_of_version(self.folder, "Camaron.so")
        status, output = self.connect(folder, copy)
        self.assertEqual(status, 0, output)
        self.assertEqual(output.count("The plugin Camaron is"), 1, output)
        self.assertIn(f"The plugin Camaron is {version} here but {other} on the server", output)
        self.assertTrue(output.endswith("Mesh Inspection: True\n"), output)

    def test_without_window(self):
        """Other programs than ParaView's window load neither the panel nor Qt, even if they are there."""
        folder = camaron_testing.plugin_folder()
        self.assertTrue((folder / "Panel" / "CamaronPanel.so").exists())
        port = self.start_server(plugins=folder)
        servers = [
            file.parent
            for file in Path("/proc").glob("[0-9]*/cmdline")
            if file.read_bytes().startswith(f"pvserver\0--server-port={port}\0".encode())
        ]
        self.assertEqual(len(servers), 1)
        for process in [*servers, Path("/proc/self")]:
            libraries = {
                Path(line).name for line in (process / "maps").read_text().split() if ".so" in line
            }
            self.assertIn("Camaron.so", libraries)
            self.assertEqual(
                {name for name in libraries if re.match("CamaronPanel|libQt|libpq[A-Z]", name)},
                set(),
            )


class TestPanel(window_testing.WindowTestCase):
    """The window has the panel, however it gets the plugin."""

    def window(self, command="pass", **environment):
        """The plugins of ours that a window has loaded, and what it printed."""
        script = self.folder / "script.py"
        text = camaron_testing.QUICK_START + IN_WINDOW.replace("COMMAND", command)
        script.write_text(text, encoding="utf-8")
        program = shutil.which("paraview")
        if not program:
            self.skipTest("no paraview")
        found = self.folder / "found"
        found.unlink(missing_ok=True)
        done = subprocess.run(
            [program, "--dr", f"--script={script}"],
            env={
                **camaron_testing.environment_alone(without=("PV_PLUGIN_PATH",)),
                "XDG_CONFIG_HOME": str(self.folder),
                **environment,
            },
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=200,
        )
        self.assertTrue(found.exists(), done.stdout)
        return found.read_text(encoding="utf-8").split(), done.stdout

    def test_path(self):
        """By PV_PLUGIN_PATH, before ParaView has made anything of its window."""
        plugins, output = self.window(PV_PLUGIN_PATH=os.environ["PV_PLUGIN_PATH"])
        self.assertEqual(plugins, ["Camaron", "CamaronPanel"], output)

    def test_list(self):
        """By a file that lists plugins, which lists Camaron only."""
        folder = camaron_testing.plugin_folder()
        plugins, output = self.window(
            PV_PLUGIN_CONFIG_FILE=str(folder.parent / "camaron.plugins.xml")
        )
        self.assertEqual(plugins, ["Camaron", "CamaronPanel"], output)

    def test_versions(self):
        """By LoadPlugin. The panel of another version is loaded with a warning that names both."""
        folder, version, other = copy_of_version(self.folder, "Panel/CamaronPanel.so")
        plugins, output = self.window(f"simple.LoadPlugin({str(folder / 'Camaron.so')!r})")
        self.assertEqual(plugins, ["Camaron", "CamaronPanel"], output)
        self.assertIn(
            f"The plugin Camaron is {version} but {folder}/Panel/CamaronPanel.so is {other}", output
        )

    def test_absent(self):
        """A plugin without it, such as a build without Qt, is complete: nothing is reported."""
        folder = self.folder / "Camaron"
        shutil.copytree(
            camaron_testing.plugin_folder(), folder, ignore=shutil.ignore_patterns("Panel")
        )
        plugins, output = self.window(f"simple.LoadPlugin({str(folder / 'Camaron.so')!r})")
        self.assertEqual(plugins, ["Camaron"], output)
        self.assertNotIn("Camaron", output)


if __name__ == "__main__":
    camaron_testing.main()
