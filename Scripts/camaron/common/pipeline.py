# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Access to ParaView for the rest of the package: the plugin, files, messages."""

from __future__ import annotations

import bisect
import contextlib
import itertools
import os
import re
import socket
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Optional

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkSMPTools, vtkVersion

from . import formats, reader_choice, silent_losses, text, vtk_lists

if TYPE_CHECKING:
    from .inputs import Inputs

#: How many files of a list are read again after an error, to name the one that is broken.
MOST_READ_AGAIN = 8
#: The name of the array that marks ghost cells.
GHOSTS = "vtkGhostType"
#: Classes of meshes whose cells have a place in a grid.
STRUCTURED = ("vtkImageData", "vtkRectilinearGrid", "vtkStructuredGrid")


def load_plugin(namespace: Optional[dict] = None) -> None:
    """Loads the plugin here, and on the server that ParaView is connected to, unless they have it.

    `namespace`: where its functions, such as ElementQuality, are added, for example globals().
    """
    connection = servermanager.ActiveConnection
    if not connection:
        raise RuntimeError("ParaView is not connected to a server, nor to its own; see Connect")
    require_server()
    if not _has_plugin():
        _load_here()
    elif not hasattr(
        simple, "ElementQuality"
    ):  # ParaView loaded it, or a script for its own globals
        simple.LoadDistributedPlugin("Camaron", remote=False, ns=vars(simple))
    if connection.IsRemote() and not _has_plugin(connection.Session):
        try:
            simple.LoadDistributedPlugin("Camaron", remote=True, ns=vars(simple))
        except RuntimeError:
            raise RuntimeError(
                "the server does not find the plugin Camaron: set PV_PLUGIN_PATH where pvserver runs"
            ) from None
    if namespace is not None:
        for name, value in vars(simple).items():
            if not name.startswith("_"):
                namespace.setdefault(name, value)


def _has_plugin(session: Any = None) -> bool:
    """Whether this process, or the server of a session, has loaded it."""
    manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
    plugins = manager.GetRemoteInformation(session) if session else manager.GetLocalInformation()
    return any(
        plugins.GetPluginName(i) == "Camaron" and plugins.GetPluginLoaded(i)
        for i in range(plugins.GetNumberOfPlugins())
    )


def _libraries() -> Iterator[Path]:
    """Files of the plugin: those in PV_PLUGIN_PATH, then the one that was installed with this package, which python3
    does not find by name as programs of ParaView do."""
    for folder in os.environ.get("PV_PLUGIN_PATH", "").split(os.pathsep):
        yield from sorted(Path(folder).glob("**/Camaron.so")) if folder else ()
    package = Path(__file__).parents[1]
    with contextlib.suppress(OSError):
        yield package / (package / "plugin").read_text("utf-8").strip()


def _load_here() -> None:
    with Messages() as messages:
        for library in _libraries():
            if library.is_file():
                simple.LoadPlugin(str(library), remote=False, ns=vars(simple))
            if _has_plugin():
                return
        try:
            simple.LoadDistributedPlugin("Camaron", remote=False, ns=vars(simple))
        except RuntimeError as error:
            messages.errors.append(str(error))
    if not _has_plugin():
        reason = messages.errors[0] if messages.errors else "is the folder in PV_PLUGIN_PATH?"
        raise RuntimeError(f"the plugin Camaron cannot be loaded: {reason}")


#: Error after the end of the server, whatever ParaView reports.
LOST = "the connection to the server is lost"


def is_connected() -> bool:
    """Whether the server still runs, if ParaView is connected to one; on Windows, always."""
    connection = servermanager.ActiveConnection
    if not connection or not connection.IsRemote() or not hasattr(socket, "MSG_DONTWAIT"):
        return True
    controller = connection.Session.GetController(servermanager.vtkSMSession.DATA_SERVER_ROOT)
    server = controller.GetCommunicator().GetSocket().GetSocketDescriptor()
    try:
        # No setblocking: ParaView's socket, of which this is a copy, would not block either, and
        # ParaView waits for an answer forever then.
        with socket.fromfd(server, socket.AF_INET, socket.SOCK_STREAM) as copy:
            return copy.recv(1, socket.MSG_PEEK | socket.MSG_DONTWAIT) != b""
    except BlockingIOError:  # nothing to read
        return True
    except OSError:
        return False


def require_server() -> None:
    """Raises RuntimeError if the server that ParaView was connected to has ended, or ends before all
    of its ranks answer: ParaView survives that for this question, but not for properties."""
    connection = servermanager.ActiveConnection
    if connection and connection.IsRemote() and is_connected():
        servers = servermanager.vtkSMSession.SERVERS
        connection.Session.GatherInformation(
            servers, servermanager.vtkPVSystemConfigInformation(), 0
        )
    if not is_connected():
        raise RuntimeError(LOST)


def update_information(proxy: Any, *properties: Any) -> None:
    """Updates information properties, or raises RuntimeError; ParaView aborts if it asks a server
    for them that has ended."""
    require_server()
    proxy.UpdatePropertyInformation(*properties)


#: Message of ParaView 6.1 on the first rank about an error on another rank, which reports the error
#: itself.
ELSEWHERE = "There was an error on a server process"


#: Instead of a message that has other bytes.
NOT_UTF8 = "a message that is not valid UTF-8"


class Messages:
    """Collects VTK's errors and warnings of all ranks in two lists instead of printing them.

    >>> with Messages() as messages:
    ...     source.UpdatePipeline()
    >>> messages.errors
    ['cube.visf: byte 12: expected ...']
    """

    def __init__(self):
        self._errors: list[str] = []
        self._warnings: list[str] = []
        self._collectors: list[Any] = []

    @property
    def errors(self) -> list[str]:
        self._gather()
        reasons = [error for error in self._errors if ELSEWHERE not in error]
        self._errors[:] = reasons or self._errors
        if not is_connected():
            self._errors[:] = [LOST]
        return self._errors

    @property
    def warnings(self) -> list[str]:
        self._gather()
        return self._warnings

    def forget(self) -> None:
        """Forgets all errors so far."""
        self._gather()
        self._errors.clear()

    def refuse(self, what: Any) -> None:
        """Raises RuntimeError with the first error, if there is one, after the name of the file,
        `what`."""
        if self.errors:
            raise RuntimeError(f"{what}: {self.errors[0]}")

    def __enter__(self) -> "Messages":
        def observer(texts):
            def callback(_window, _event, text=""):
                try:
                    _note(texts, text or NOT_UTF8)  # VTK passes no text then
                except (MemoryError, SystemError):  # which VTK would only print
                    texts.append("a message for which there is not enough memory")

            callback.CallDataType = "string0"
            return callback

        own = _new_collector("ClientMessages") if _has_plugin() else None
        others = _new_collector("ProcessMessages") if rank_count() > 1 else None
        self._collectors = [collector for collector in (own, others) if collector]
        self._window = vtkOutputWindow.GetInstance()
        self._mode = self._window.GetDisplayMode()
        self._verbosity = vtkLogger.GetCurrentVerbosityCutoff()
        self._observers = []
        if own:
            # Not by Python, for which a thread of a pipeline that reports something would wait forever.
            own.InvokeCommand("Observe")
        else:  # the plugin is being loaded
            self._observers = [
                self._window.AddObserver("ErrorEvent", observer(self._errors)),
                self._window.AddObserver("WarningEvent", observer(self._warnings)),
            ]
        self._window.SetDisplayModeToNever()
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        return self

    def __exit__(self, kind, error, trace) -> None:
        try:
            self._gather()
        finally:
            self._collectors = []
            for observer in self._observers:
                self._window.RemoveObserver(observer)
            self._window.SetDisplayMode(self._mode)
            vtkLogger.SetStderrVerbosity(self._verbosity)

    def _gather(self) -> None:
        """Adds the messages since the last time."""
        if not is_connected():
            return
        for collector in self._collectors:
            collector.InvokeCommand("Gather")
            update_information(collector)
            for name, texts in (("Errors", self._errors), ("Warnings", self._warnings)):
                found = collector.GetProperty(name).GetElement(0)
                # Bytes if some are not UTF-8.
                whole = found.encode() if isinstance(found, str) else found
                for message in whole.split(b"\x1f"):
                    try:
                        _note(texts, message.decode())
                    except UnicodeDecodeError:
                        _note(texts, NOT_UTF8)


def once(*lists: list[str]) -> list[str]:
    """The sentences of several lists, each once: reading a mesh again repeats its warnings."""
    return list(dict.fromkeys(sentence for sentences in lists for sentence in sentences))


def _new_collector(name: str) -> Any:
    """A proxy of the plugin that collects messages; None if the server does not know it."""
    if not servermanager.ActiveConnection:
        return None
    collector = servermanager.ProxyManager().NewProxy("misc", name)
    if collector:
        collector.UpdateVTKObjects()
    return collector


def _note(texts: list[str], message: str) -> None:
    """Adds a message to a list, unless the list contains it."""
    message = _plain(message)
    if message and message not in texts:
        texts.append(message)


def _plain(message: str) -> str:
    """The message without the source location and the address of the object."""
    message = re.sub(r"^(ERROR|Warning|Generic Warning): In .*?, line \d+\s*", "", message.strip())
    message = re.sub(r"^[\w:<>]+ \((0x)?[0-9a-fA-F]+\): ", "", message)
    return text.printable(" ".join(message.split()))


class Opened:
    """A mesh that was read: the source, its file or else its name in the pipeline, the chosen time,
    and the warnings of the reader."""

    def __init__(
        self,
        source: Any,
        path: Path,
        time: Optional[dict[str, Any]],
        warnings: list[str],
        is_file: bool = True,
    ):
        self.source, self.path, self.time, self.warnings = source, path, time, warnings
        self.is_file = is_file


def open_mesh(
    path: os.PathLike | str,
    time: str = "last",
    inputs: Optional[Inputs] = None,
    reader: Optional[Mapping[str, Any]] = None,
    strict: bool = False,
    unknown: Optional[dict[str, formats.UnknownOption]] = None,
) -> Opened:
    """Opens and reads any mesh that ParaView can read.

    `time` is "first", "last" or the number of a step; `reader` has options of the reader by name, in any spelling;
    errors about those that it does not know are added to `unknown`, if given. Arrays that cannot be read are left out,
    with a warning, unless `strict`. All files that were opened are added to `inputs`, also after an error. Raises
    RuntimeError with the reader's reason, or if cells cannot be read.
    """
    path = Path(path)
    if not path.exists():
        raise RuntimeError(f"{path}: there is no such file")
    notes: list[str] = []
    value = 0.0
    with Messages() as messages:
        try:
            require_server()
            source = reader_choice.make_reader(path, notes)
        except reader_choice.NotReadable as error:
            reason = _reason(messages, path, str(error))
            raise _refusal(reason, path, value, reader, strict) from None
        try:
            formats.set_reader_options(source, reader or {}, unknown)
            chosen = _choose_time(source, time)
            value = chosen["value"] if chosen else 0.0
            vtk_lists.check(path, value)
            if path.suffix.lower() == ".pvd":
                _check_parts(path, value)
            source.UpdatePipeline(value)
            if inputs is not None:
                inputs.add(source)
            source, broken = silent_losses.without_lost(source, path, value, messages.warnings)
            fields = list(silent_losses.fields(source, path, value))
            broken += silent_losses.empty_fields(fields)
            if messages.errors:
                broken += _leave_out_broken_arrays(source, value, messages)
            cut = silent_losses.cut_fields(source, fields)
            if strict and broken + cut:
                raise RuntimeError("; ".join(broken + cut))
            notes += [f"Left out: {sentence}." for sentence in broken]
            notes += [f"Incomplete: {sentence}." for sentence in cut]
            is_read = not messages.errors
            if is_read:
                _check_cells(source, value)
        except ValueError as error:
            simple.Delete(source)
            raise type(error)(f"{path}: {error}") from None
        except RuntimeError as error:
            simple.Delete(source)
            raise _refusal(f"{path}: {error}", path, value, reader, strict) from None
    if messages.errors or not is_mesh(source) or _is_empty(source):
        others = reader_choice.own_reason(path, source)
        kind = data_information(source).GetPrettyDataTypeString().lower()
        if others:
            theirs = messages.errors[0] if messages.errors else "no points"
            name = source.GetXMLLabel()
            simple.Delete(source)
            raise RuntimeError(f"{others} ({name} of ParaView: {theirs.rstrip('.')})")
    if messages.errors:
        simple.Delete(source)
        reason = _reason(messages, path, "")
        raise RuntimeError(reason) if is_read else _refusal(reason, path, value, reader, strict)
    if not is_mesh(source):
        composite = is_composite(source)
        simple.Delete(source)
        what = "no points and no cells were found" if composite else f"not a mesh, but a {kind}"
        raise RuntimeError(f"{path}: {what}")
    return Opened(source, path, chosen, notes + messages.warnings)


def _check_parts(path: Path, time: float) -> None:
    """Raises RuntimeError if a file that a collection (.pvd) names for this time is missing or cut: ParaView's reader
    leaves it out without a word."""
    try:
        parts = list(vtk_lists.files_in_list(path, time))
    except vtk_lists.NOT_UNDERSTOOD:
        return
    for part in parts:
        fault = vtk_lists.fault_at_ends(part)
        if fault:
            raise RuntimeError(f"{part.name}: {fault}")


def _refusal(
    reason: str, path: Path, time: float, reader: Optional[Mapping[str, Any]], strict: bool
) -> RuntimeError:
    """The error about a file that cannot be read. Of a list of files, it is about the first of them that cannot be read
    at this time, or about the first one of all, from which readers know the arrays."""

    def at_ends(file: Path) -> str:
        fault = vtk_lists.fault_at_ends(file)
        return fault and f"{file}: {fault}"

    def in_header(file: Path) -> str:
        with Messages() as messages:
            try:
                source = reader_choice.make_reader(file, [])
            except reader_choice.NotReadable as error:
                return _reason(messages, file, str(error))
            source.UpdatePipelineInformation()
            simple.Delete(source)
        return _reason(messages, file, "") if messages.errors else ""

    def anywhere(file: Path) -> str:
        try:
            simple.Delete(open_mesh(file, reader=reader, strict=strict, unknown={}).source)
        except RuntimeError as error:
            return str(error)
        except ValueError:  # an option for other files of the list
            pass
        return ""

    first = itertools.islice(vtk_lists.files_with_cells(path), 1)
    files = dict.fromkeys([*vtk_lists.files_with_cells(path, time), *first])
    files.pop(path, None)
    few = itertools.islice(files, MOST_READ_AGAIN)
    faults = itertools.chain(map(at_ends, files), map(in_header, files), map(anywhere, few))
    fault = next(filter(None, faults), "").removeprefix(os.path.join(path.parent, ""))
    return RuntimeError(f"{path}: {fault}" if fault else reason)


def _leave_out_broken_arrays(source: Any, time: float, messages: Messages) -> list[str]:
    """After errors of a reader: if it reads the mesh without arrays, lets it read those that it can, and forgets the
    errors. Returns words about each of the others; none if the mesh itself cannot be read, whose errors are kept.
    """
    chosen = {key: list(getattr(source, key)) for key in formats.array_lists(source)}
    reasons: dict[str, str] = {}

    def is_read(key: str, names: list[str]) -> bool:
        """Whether the reader reads these arrays of one list, without those of the others."""
        for other in chosen:
            setattr(source, other, names if other == key else [])
        with Messages() as found:
            source.UpdatePipeline(time)
        if found.errors and len(names) == 1:
            reasons[names[0]] = found.errors[0]
        if found.errors and not names:
            messages.forget()
            messages.errors.extend(found.errors)
        return not found.errors

    def whole(key: str, names: list[str]) -> list[str]:
        """Those of the arrays that can be read, found by halving."""
        if not names or is_read(key, names):
            return names
        half = len(names) // 2
        return whole(key, names[:half]) + whole(key, names[half:]) if half else []

    if not any(chosen.values()) or not is_read("", []):
        return []
    for key, names in {key: whole(key, names) for key, names in chosen.items()}.items():
        setattr(source, key, names)
    messages.forget()
    source.UpdatePipeline(time)
    return [
        f"the array {text.printable(name)} cannot be read"
        + ("" if reason == NOT_UTF8 else f" ({reason.rstrip('.')})")
        for name, reason in reasons.items()
    ]


def _check_cells(source: Any, time: float) -> None:
    """Reports an error if the cells of an output cannot be read, before anything reads them."""
    for port in range(source.SMProxy.GetNumberOfOutputPorts()):
        check = checked(simple.OutputPort(source, port))
        try:
            check.UpdatePipeline(time)
        finally:
            simple.Delete(check)


def checked(source: Any) -> Any:
    """A filter that passes on the output of a source, or reports an error if its cells cannot be
    read: of a tetrahedron of three points, ParaView's filters and writers read a fourth one."""
    manager = servermanager.vtkSMProxyManager.GetProxyManager()
    check = servermanager._getPyProxy(manager.NewProxy("internal_filters", "CheckCells"))
    check.Input = source
    check.UpdateVTKObjects()
    return check


def adopt(source: Any) -> Opened:
    """A source of the pipeline at the current time."""
    steps = _time_steps(source)
    now = simple.GetTimeKeeper().Time
    step = max(0, bisect.bisect_right(steps, now) - 1)
    time = {"step": step, "steps": len(steps), "value": steps[step]} if steps else None
    names = getattr(source, "FileName", None) or getattr(source, "FileNames", None)
    name = names if isinstance(names, str) else names[min(step, len(names) - 1)] if names else ""
    is_file = bool(name)
    if not is_file:
        manager = servermanager.ProxyManager().SMProxyManager
        name = manager.GetProxyName("sources", source.SMProxy) or source.GetXMLLabel()
    return Opened(source, Path(name), time, [], is_file)


def _reason(messages: Messages, path: Path, otherwise: str) -> str:
    """The first error, which may begin with its location in the file: "mesh.visf:17: ..."."""
    first = messages.errors[0] if messages.errors else otherwise
    first = first.replace(_plain(text.printable(str(path.absolute()))), str(path))
    for name in (_plain(text.printable(str(name))) for name in (path, path.name)):
        if first.startswith(name + ":"):
            return str(path) + first[len(name) :]
    return f"{path}: {first}"


def _choose_time(source: Any, time: str) -> Optional[dict[str, Any]]:
    values = _time_steps(source)
    steps = max(1, len(values))
    names = {"first": 0, "last": steps - 1}
    if time not in names and not str(time).isdecimal():
        raise ValueError(f"time is 'first', 'last' or the number of a step, not {time!r}")
    step = names[time] if time in names else int(time)
    if step >= steps:
        there_is = f"the steps are 0 to {steps - 1}" if steps > 1 else "0 is the only one"
        raise ValueError(f"there is no time step {step}: {there_is}")
    if not values:
        return None
    return {"step": step, "steps": len(values), "value": values[step]}


def _time_steps(source: Any) -> list[float]:
    values = getattr(source, "TimestepValues", None)
    values = [] if values is None else values if hasattr(values, "__len__") else [values]
    return [float(value) for value in values]


def data_information(source: Any) -> Any:
    """vtkPVDataInformation of a source or an OutputPort, gathered over all ranks."""
    return source.GetDataInformation().DataInformation


@contextlib.contextmanager
def threads_for(information: Any) -> Iterator[None]:
    """Meanwhile, VTK's own loops have one thread if data of this vtkPVDataInformation have small blocks: it would wake all
    threads for the range of each array of each block, which takes longer than the ranges."""
    size = max(information.GetNumberOfCells(), information.GetNumberOfPoints())
    are_small = size < 10_000 * information.GetNumberOfDataSets()
    before = vtkSMPTools.GetBackend()
    if are_small:
        vtkSMPTools.SetBackend("Sequential")
    try:
        yield
    finally:
        if are_small:
            vtkSMPTools.SetBackend(before)


def without_ghosts(source: Any) -> Any:
    """A filter that removes the ghost cells of a source; the source if it is structured, of which ParaView cannot
    remove cells, and writers omit them."""
    # For polyhedra, VTK 9.6 needs memory for all faces times the points of all faces.
    version = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())
    information = data_information(source)
    if is_structured(source):
        return source
    ghosts = information.GetCellDataInformation().GetArrayInformation(GHOSTS)
    if (
        version < (9, 6)
        or information.DataSetTypeIsA("vtkPolyData")
        or not ghosts
        or ghosts.GetIsPartial()  # blocks without the array would be lost
    ):
        return simple.RemoveGhostInformation(Input=source)
    return simple.Threshold(
        Input=source,
        Scalars=["CELLS", GHOSTS],
        ThresholdMethod="Below Lower Threshold",
        LowerThreshold=0,
    )


def is_structured(source: Any) -> bool:
    """Whether the output, or each of its blocks, is structured."""
    information = data_information(source)
    return any(information.DataSetTypeIsA(name) for name in STRUCTURED)


def is_composite(source: Any) -> bool:
    return data_information(source).GetCompositeDataSetType() != -1


def _is_empty(source: Any) -> bool:
    information = data_information(source)
    return information.GetNumberOfCells() + information.GetNumberOfPoints() == 0


def is_mesh(source: Any) -> bool:
    """Whether the output contains points or cells."""
    information = data_information(source)
    return information.DataSetTypeIsA("vtkDataSet") or (
        is_composite(source)
        and information.GetNumberOfCells() + information.GetNumberOfPoints() > 0
    )


def is_first_rank() -> bool:
    """Whether this rank writes the files; with pvbatch --sym, all ranks run the script."""
    return servermanager.vtkProcessModule.GetProcessModule().GetPartitionId() == 0


def rank_count() -> int:
    """Number of MPI ranks of this program, or of the server that it is connected to."""
    connection = servermanager.ActiveConnection
    return connection.GetNumberOfDataPartitions() if connection else 1
