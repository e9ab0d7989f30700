# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sessions of ParaView's window: events as its own tests record them, played in a process of its own."""

import os
import re
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path
from xml.sax.saxutils import quoteattr

import camaron_testing

WINDOW = "pqClientMainWindow"
PANEL = f"{WINDOW}/propertiesDock/propertiesPanel"
PROPERTIES = (
    f"{PANEL}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel"
)
DISPLAY = PROPERTIES.replace("PropertiesFrame", "DisplayFrame")
FRAME = (
    f"{WINDOW}/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1"
    "/Container/Frame.0"
)
VIEWPORT = f"{FRAME}/CentralWidgetFrame/Viewport"
SHELL = f"{WINDOW}/pythonShellDock/pythonShell"
#: Modes of pqPropertiesPanel, for the event `sections`.
ALL_PROPERTIES, SOURCE_PROPERTIES = 7, 1


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


def open_file(path):
    """Opens an example, or any file of the server."""
    return [event(WINDOW, "open", camaron_testing.EXAMPLES / path)]


def save_state(path):
    return [
        event(f"{WINDOW}/menubar/menu_File", "activate", "actionFileSaveServerState"),
        event(f"{WINDOW}/FileSaveServerStateDialog", "filesSelected", path),
    ]


def run_script(path):
    return [event(SHELL, "run", path)]


def show_inspector():
    """Brings the Mesh Inspector to the front."""
    return event(f"{WINDOW}/pqMeshInspectorPanel", "raise")


def by_dialogs(line):
    """Events without those commands of Testing/Window that stand for others."""
    if line == show_inspector():
        return [event(WINDOW, "set_tab_with_text", "Mesh Inspector")]
    found = re.fullmatch(r' *<pqevent .* command="(open|run)" arguments="(.*)" />', line)
    if not found:
        return [line]
    button, dialog = {
        "open": (f"{WINDOW}/MainControlsToolbar/actionOpenData", f"{WINDOW}/FileOpenDialog"),
        "run": (f"{SHELL}/runScriptButton", f"{SHELL}/PythonShellRunScriptDialog"),
    }[found[1]]
    return [event(button, "activate"), event(dialog, "filesSelected", found[2])]


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


class Window:
    """A process of the window that plays sessions one after another. ParaView starts anew between two of them, in a fraction
    of the time that a process takes."""

    SECONDS = 240  # for each session, for what hangs

    def __init__(self, folder, sessions, options=(), environment=None, settings=None):
        """The folder is for its files and settings, unless those are kept in one of their own. It ends after this number of
        sessions."""
        program = shutil.which("paraview")
        if not program:
            raise unittest.SkipTest("no paraview")
        self.pipes = [folder / f"session{i}.xml" for i in range(sessions)]
        for pipe in self.pipes:
            os.mkfifo(pipe)
        self.pipe = None  # the opened one
        self.is_used = False
        self.log = folder / "window.log"
        command = [
            *("timeout", "850", program),
            *([] if settings else ["--dr"]),
            f"--plugin-search-paths={os.environ['PV_PLUGIN_PATH']}",
            "--plugins=Camaron",
            f"--data-directory={camaron_testing.EXAMPLES}",
            *(f"--test-script={pipe}" for pipe in self.pipes),
            "--exit",
            *options,
        ]
        # With --dr, ParaView still writes settings, to a file that all its windows would share.
        environment = {"XDG_CONFIG_HOME": str(settings or folder), **(environment or {})}
        environment = {**camaron_testing.environment_alone(), **environment}
        with open(self.log, "wb") as log:
            self.process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, env=environment
            )

    def play(self, text):
        """Plays a session; None if it passes, else what the window printed."""
        printed = self.log.stat().st_size
        self.is_used = True
        if self._is_ready():
            with open(self.pipe, "w", encoding="utf-8") as pipe:
                pipe.write(text)
            self.pipe = None
            if self._is_ready() or self.process.returncode == 0:
                return None
        self.process.terminate()
        self.process.wait()
        return self.log.read_bytes()[printed:].decode(errors="replace")[-15000:]

    def _is_ready(self):
        """Waits until the window opens the next pipe, which it does when the session before has passed, or ends."""
        deadline = time.monotonic() + self.SECONDS
        while self.pipe is None and self.process.poll() is None and time.monotonic() < deadline:
            try:
                self.pipe = os.open(self.pipes[0], os.O_WRONLY | os.O_NONBLOCK)
                os.set_blocking(self.pipe, True)
                del self.pipes[0]
            except (OSError, IndexError):
                time.sleep(0.02)
        return self.pipe is not None

    def close(self):
        """Ends the process by a session that fails; an error if that crashes or hangs."""
        if self.process.poll() is None:
            failed = self.play(session(event(WINDOW, "unseen")))
            if self.process.returncode != 1:
                raise AssertionError(f"ended with {self.process.returncode}: {failed}")


def session(*events):
    return "\n".join(['<?xml version="1.0" ?>', "<pqevents>", *events, "</pqevents>\n"])


@camaron_testing.require_display()
class WindowTestCase(camaron_testing.TestCase):
    SESSIONS = 12  # of one window, which has a pipe for each and for its end
    shared = None  # the window that all cases use

    def play(
        self, *events, options=(), environment=None, settings=None, display=False, alone=False
    ):
        """A session of the window, alone or with options, an environment or settings in a process of its own. Unless with display,
        the Properties panel has those of the source only: it makes the widgets of a display anew, for half a second,
        whenever another source or view is active."""
        has_state = any(option.startswith("--state=") for option in options)  # excludes a script
        library = os.environ.get("CAMARON_WINDOW_EVENTS")
        if library and not has_state:
            sections = ALL_PROPERTIES if display else SOURCE_PROPERTIES
            events = [event(PANEL, "sections", sections), *events]
        else:
            events = [part for line in events for part in by_dialogs(line)]
        # ParaView's panel crashes when it gets displays back in another session.
        alone = alone or display or not library or options or environment or settings
        if alone:
            folder = Path(tempfile.mkdtemp(dir=self.folder))
            has_shell = any(SHELL in line for line in events)
            start = [] if has_state else self._start(folder, has_shell)
            window = Window(folder, 1, [*start, *options], environment, settings)
            self.addCleanup(window.process.terminate)
        else:
            window = self._shared()
            events = [event(WINDOW, "fresh"), *events] if window.is_used else events
        failed = window.play(session(*events))
        if failed is not None:
            self.fail(f"the window ended with {window.process.returncode}: {failed}")

    def _start(self, folder, has_shell=True):
        """Options that run a script at the start of the window; its shell imports ParaView."""
        start, library = folder / "window.py", os.environ.get("CAMARON_WINDOW_EVENTS")
        # Only paraview.simple notices that another session begins.
        text = camaron_testing.QUICK_START + "import paraview.simple" if has_shell else ""
        start.write_text(text + (ADD_EVENTS.replace("PATH", repr(library)) if library else ""))
        return [f"--script={start}"]

    def _shared(self):
        """The window that plays a session after those of other tests."""
        window = WindowTestCase.shared
        if window and (window.process.poll() is not None or not window.pipes):
            window.close()
            window = None
        if not window:
            folder = Path(tempfile.mkdtemp(prefix="camaron-test-"))
            unittest.addModuleCleanup(shutil.rmtree, folder, ignore_errors=True)
            window = Window(folder, self.SESSIONS + 1, self._start(folder))
            unittest.addModuleCleanup(window.close)
            WindowTestCase.shared = window
        return window

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
