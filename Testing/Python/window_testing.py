# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sessions of ParaView's window: events as its own tests record them, played in a process of its own."""

import os
import shutil
import subprocess
from xml.sax.saxutils import quoteattr

import camaron_testing

WINDOW = "pqClientMainWindow"
PANEL = f"{WINDOW}/propertiesDock/propertiesPanel"
PROPERTIES = (
    f"{PANEL}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel"
)
FRAME = (
    f"{WINDOW}/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1"
    "/Container/Frame.0"
)
SHELL = f"{WINDOW}/pythonShellDock/pythonShell"
#: Mode of pqPropertiesPanel, for the event `sections`.
SOURCE_PROPERTIES = 1


def event(target, command, arguments=""):
    arguments = quoteattr(str(arguments))
    return f'  <pqevent object="{target}" command="{command}" arguments={arguments} />'


def apply():
    return event(f"{PANEL}/Accept", "activate")


def choose(name, value):
    return event(f"{PROPERTIES}/{name}", "set_string", value)


def check(target, name, value):
    """The session fails where the widget's property has another value."""
    return f'  <pqcheck object="{target}" property="{name}" arguments={quoteattr(str(value))} />'


def edit(action):
    """Undo or Redo."""
    return event(f"{WINDOW}/MainControlsToolbar/action{action}", "activate")


def add_filter(name):
    menu = f"{WINDOW}/menubar"
    return [
        event(menu, "activate", "menuFilters"),
        event(f"{menu}/menuFilters/Camaron", "activate", name),
    ]


def open_example(name):
    return [
        event(f"{WINDOW}/MainControlsToolbar/actionOpenData", "activate"),
        event(f"{WINDOW}/FileOpenDialog", "filesSelected", f"$PARAVIEW_DATA_ROOT/{name}"),
    ]


def save_state(path):
    return [
        event(f"{WINDOW}/menubar/menu_File", "activate", "actionFileSaveServerState"),
        event(f"{WINDOW}/FileSaveServerStateDialog", "filesSelected", path),
    ]


def run_script(path):
    return [
        event(f"{SHELL}/runScriptButton", "activate"),
        event(f"{SHELL}/PythonShellRunScriptDialog", "filesSelected", path),
    ]


#: Adds the commands of Testing/Window to the session's own.
ADD_EVENTS = """
import ctypes
ctypes.CDLL(PATH).AddWindowEvents()
"""
START_TRACE = """
from paraview import smtrace
smtrace.start_trace(preamble="")
"""
STOP_TRACE = """
from paraview import smtrace
with open(PATH, "w") as file:
    file.write(smtrace.stop_trace())
"""


@camaron_testing.require_display()
class WindowTestCase(camaron_testing.TestCase):
    def play(self, *events, options=(), environment=None, display=False):
        """A session of the window. Unless with display, the Properties panel has those of the source only: it makes the
        widgets of a display anew, for half a second, whenever another source or view is active."""
        test, start = self.folder / "session.xml", self.folder / "session.py"
        if not any(option.startswith("--state=") for option in options):  # excludes a script
            options = [*options, f"--script={start}"]
            # The shell imports ParaView at its start.
            text = camaron_testing.QUICK_START if any(SHELL in line for line in events) else ""
            library = os.environ.get("CAMARON_WINDOW_EVENTS")
            if library:
                text += ADD_EVENTS.replace("PATH", repr(library))
                if not display:
                    events = [event(PANEL, "sections", SOURCE_PROPERTIES), *events]
            start.write_text(text)
        lines = ['<?xml version="1.0" ?>', "<pqevents>", *events, "</pqevents>"]
        test.write_text("\n".join(lines) + "\n")
        program = shutil.which("paraview")
        if not program:
            self.skipTest("no paraview")
        command = [
            program,
            "--dr",
            f"--plugin-search-paths={os.environ['PV_PLUGIN_PATH']}",
            "--plugins=Camaron",
            f"--data-directory={camaron_testing.EXAMPLES}",
            f"--test-directory={self.folder}",
            f"--test-script={test}",
            "--exit",
            *options,
        ]
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=240,
            # With --dr, ParaView still writes settings, to a file that all its windows share.
            env={
                **camaron_testing.environment_alone(),
                "XDG_CONFIG_HOME": str(self.folder),
                **(environment or {}),
            },
        )
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr[-3000:])

    def serve(self, ranks=2):
        """Options of the window for a server of some ranks, which ends with the test."""
        port = self.start_server(ranks, os.environ["PV_PLUGIN_PATH"], seconds=260)
        return [f"--server-url=cs://127.0.0.1:{port}"]

    def script(self, name, text):
        """Events that run a text in the window's Python shell, from a file of that name."""
        path = self.folder / f"{name}.py"
        path.write_text(text)
        return run_script(path)

    def require_events(self):
        """Skips a test whose sessions have commands of Testing/Window where those are missing."""
        if not os.environ.get("CAMARON_WINDOW_EVENTS"):
            self.skipTest("no CAMARON_WINDOW_EVENTS: this ParaView has no headers of QtTesting")

    def traced(self, path, *events):
        """The events, with their trace written to a path."""
        stop = STOP_TRACE.replace("PATH", repr(str(path)))
        return [*self.script("start", START_TRACE), *events, *self.script("stop", stop)]

    def replay(self, trace, more):
        """Runs a trace, and then a text, in pvpython."""
        self.run_alone(trace.read_text(), more)

    def replay_state(self, state, more):
        """Loads a state in pvpython, and runs a text there."""
        self.run_alone(f"from paraview import simple\nsimple.LoadState({str(state)!r})", more)

    def run_alone(self, *texts):
        script = self.folder / "replayed.py"
        load = "from camaron.common import pipeline\npipeline.load_plugin()"
        script.write_text("\n".join([camaron_testing.QUICK_START, load, *texts]))
        camaron_testing.run_alone(script, timeout=140)
