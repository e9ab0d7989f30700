# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts any mesh that can be read to any format that can be written."""

from __future__ import annotations

import math
import os
import re
from pathlib import Path
from typing import Any, Mapping, Optional

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import VTK_FLOAT

from ..common import formats, mesh_facts, pipeline, tables, text
from ..common.files import Staging, same_file
from ..common.inputs import Inputs
from . import completeness, foam_case, storable_names
from .completeness import FORMATS_IN_PIECES
from .storable_names import OF_IOSS

#: Extensions of formats that can store blocks; for all other formats, blocks are merged.
FORMATS_WITH_BLOCKS = {".vtm", ".vtmb", ".vtpc", ".vtpd", ".vtkhdf", ".cgns", ".ex2", ".exo", ".e"}
#: ParaView's formats of points and polygons for which lost arrays are reported.
BARE_SURFACES = {".stl"}
#: ParaView's formats whose writers fail silently for polyhedra, or write files that cannot be read.
WITHOUT_POLYHEDRA = {".vtkhdf", ".e", ".g", ".ex2", ".ex2v2"}
#: ParaView's formats with coordinates in single precision.
SINGLE_PRECISION = {".stl", ".case", ".encas"}
#: Cells that the writer of OF_IOSS supports; other cells make it terminate the program.
IOSS_TYPES = set(
    "Vertex Line Triangle QuadraticTriangle Quad QuadraticQuad BiQuadraticQuad Tetra Hexahedron QuadraticHexahedron "
    "TriQuadraticHexahedron Wedge QuadraticWedge BiQuadraticQuadraticWedge Pyramid QuadraticPyramid".split()
)
#: Arrays that filters and readers add and whose loss is not reported.
NO_LOSS = {pipeline.GHOSTS, "vtkOriginalPointIds", "vtkOriginalCellIds"}
#: Writers that write a folder beside the target, complete or not at all.
OF_FOLDERS = {"PolyMeshWriter"}
#: Writers that store the boundaries by zone that readers of other formats have as a further output.
OF_BOUNDARIES = {"FluentMeshWriter", "FluentHDF5Writer", "PolyMeshWriter"}
#: The marker of an OpenFOAM case for a target that is a folder.
MARKER = "case.foam"
#: Parts of extensions that are read only, and the options that write the same data under another
#: extension.
OPTIONS_INSTEAD = (
    ("face", "--write-boundary-faces"),
    ("st", "--write-texture-coordinates"),
    ("cnoff", "--vertex-colors NAME"),
    ("coff", "--vertex-colors NAME"),
    ("noff", "--write-normals"),
)
#: Cell types without triangles, as named in the tables of statistics.
POINTS_AND_LINES = ("Vertex", "PolyVertex", "Line", "PolyLine", "QuadraticEdge", "CubicLine")


def convert(
    source: os.PathLike | str,
    target: os.PathLike | str,
    *,
    time: str = "last",
    reader: Optional[Mapping[str, Any]] = None,
    strict: bool = False,
    **options: Any,
) -> list[str]:
    """Writes the mesh of one file to another; the format follows from the name of the target.

    Formats of the plugin are written by its own writers, others by ParaView's. `options` are
    properties of the writer, in any spelling: `file_type="Ascii"` sets FileType; `reader` has those of the reader; with
    `strict`, arrays that cannot be read are an error instead of a sentence. If a format of
    ParaView cannot store the mesh, blocks are merged, surfaces become unstructured grids, and for
    surface formats the boundary is written; for formats of the plugin, the options of the writer
    decide. Further outputs of a reader, such as boundaries by zone, are written too if the format
    stores them. A target that is a folder becomes an OpenFOAM case. Returns a list of sentences: changes to the mesh, and the warnings of the reader
    and the writer.

    >>> convert("part.visf", "part.vtu", compressor_type="LZ4")
    []
    >>> convert("part.visf", "part.stl")
    ['The boundary surface was written, as triangles.']
    """
    is_folder = str(target).endswith(os.sep)
    target = Path(target)
    if is_folder or (target.is_dir() and not target.suffix):
        target /= MARKER
    if not target.suffix:
        raise ValueError(
            f"{target}: the name of the target needs an extension, which selects the format"
        )
    if target.suffix.lower() == ".gz":
        raise ValueError(
            f"{target}: compressed files can be read, but not written: write {target.stem} and compress it"
        )
    pipeline.load_plugin()
    _check_name(target)
    inputs = Inputs(source)
    inputs.refuse(target)
    _check_ranks(target)
    opened = pipeline.open_mesh(source, time, inputs, reader, strict)
    made = [opened.source]
    try:
        notes = list(opened.warnings)
        if opened.time and opened.time["steps"] > 1 and not _writes_all_steps(options):
            notes.append(
                f"Of {opened.time['steps']} time steps, step {opened.time['step']}, counted from 0,"
                f" was used (time {opened.time['value']:g})."
            )
        if not formats.own_writer(target):
            notes += _pieces_that_stay(Path(source))
        elif formats.own_writer(target) in OF_BOUNDARIES and not reader:
            _add_patches(opened, made, target, notes)
        proxy = made[1] if len(made) > 1 else _suitable(made, target, notes)
        write(proxy, target, options, inputs, notes, Path(source))
        return notes
    finally:
        for proxy in reversed(made):
            simple.Delete(proxy)


def write_source(source: Any, target: os.PathLike | str, notes: list[str]) -> None:
    """Writes the output of a source in the format of the extension; adds the sentences of `convert`
    to `notes`."""
    made = [source]
    try:
        write(_suitable(made, Path(target), notes), target, {}, Inputs(source), notes)
    finally:
        for proxy in reversed(made[1:]):
            simple.Delete(proxy)


def check_target(target: os.PathLike | str) -> None:
    """Raises ValueError if there is no writer for the extension."""
    _check_name(Path(target))
    suffix = Path(target).suffix.lower()
    if not formats.own_writer(Path(target)) and suffix not in formats.written_extensions():
        raise ValueError(f"{target}: no writer for {suffix or 'files without an extension'}")


def _check_name(target: Path) -> None:
    """Raises ValueError for extensions of the plugin's formats that are read, but not written, and for one whose writer
    ends the program."""
    suffix = target.suffix.lower()
    if suffix in formats.ENDING_WRITERS:
        raise ValueError(
            f"{target}: ParaView's writer ends the program for *.gen files: write {target.stem}.exo, which has the same "
            "format"
        )
    name = formats.written_instead(target)
    if name is None:
        return
    options = [option for word, option in OPTIONS_INSTEAD if word in suffix]
    how = f" with {' '.join(options)}" if options else ""
    raise ValueError(
        f"{target}: *{suffix} files can be read, but not written under that name: "
        f"write {name}{how}, which has the same format"
    )


def _check_ranks(target: Path) -> None:
    suffix = target.suffix.lower()
    if (
        pipeline.rank_count() > 1
        and suffix in formats.written_extensions()
        and suffix not in FORMATS_IN_PIECES | {".stl"}
        and not formats.own_writer(target)
    ):
        pieces = f".p{suffix[1:]}"
        raise ValueError(
            f"{target}: *{suffix} files can be written by one process only: omit --ranks, or choose "
            f"{pieces if pieces in FORMATS_IN_PIECES else '.pvtu'} or a format of the plugin"
        )


def _pieces_that_stay(source: Path) -> list[str]:
    """A sentence about a file of several pieces, which ParaView does not merge; the plugin's
    writers do."""
    if source.suffix.lower() not in (".pvtu", ".pvtp"):
        return []
    pieces = len(re.findall(rb"<Piece\s", source.read_bytes()))
    if pieces <= pipeline.rank_count():
        return []
    return [f"Points at the borders of the {pieces} pieces may be duplicated."]


def _writes_all_steps(options: dict[str, Any]) -> bool:
    names = {"writetimesteps", "writealltimesteps", "writetimestepsasfileseries"}
    return any(
        formats.plain(name) in names and str(value).lower() not in ("0", "off", "no", "false")
        for name, value in options.items()
    )


def _suitable(made: list[Any], target: Path, notes: list[str]) -> Any:
    """The part of the mesh that the format can store; adds the necessary filters to `made`."""
    suffix = target.suffix.lower()
    writer = formats.own_writer(target)
    others = _further_outputs(made[0])
    if others and (
        writer in OF_BOUNDARIES or writer == formats.own_counterpart(made[0].GetXMLName())
    ):
        made.append(simple.GroupDatasets(Input=[made[0], *others]))
        return made[-1]
    for output in others:
        notes.append(f"The output {_describe_output(output)} of the reader was not written.")
    if writer:
        return made[0]  # the writer accepts any mesh, including blocks

    def fits(proxy) -> bool:
        return suffix in writable_extensions(proxy)

    def append(proxy) -> Any:
        proxy.UpdatePipeline()
        made.append(proxy)
        return proxy

    def without_ghosts(proxy) -> Any:
        if suffix in FORMATS_IN_PIECES or not proxy.CellData[pipeline.GHOSTS]:
            return proxy
        real = pipeline.without_ghosts(proxy)
        if real is proxy:
            return proxy
        append(real)
        cells = [pipeline.data_information(p).GetNumberOfCells() for p in (proxy, real)]
        if cells[0] > cells[1]:
            notes.append(f"Omitted: {text.plural(cells[0] - cells[1], 'ghost cell')}.")
        return real

    proxy = append(pipeline.checked(made[0]))  # also of further time steps
    if pipeline.is_composite(proxy) and suffix not in FORMATS_WITH_BLOCKS:
        proxy = append(simple.MergeBlocks(Input=proxy))
        notes.append("The blocks were merged.")
    kind = pipeline.data_information(proxy).GetCompositeDataClassName()
    if kind == "vtkMultiBlockDataSet" and suffix in {".vtpc", *OF_IOSS}:
        proxy = append(simple.ConvertToPartitionedDataSetCollection(Input=proxy))
    if suffix == ".stl":
        notes += _without_triangles(proxy)
    if fits(proxy) and not (suffix == ".stl" and _is_volume(proxy)):
        proxy = without_ghosts(proxy)
        return (
            append(simple.MeshSurface(Input=proxy, Triangulate=1, PassThroughIds=0))
            if suffix == ".stl"
            else proxy
        )
    grid = append(simple.AppendDatasets(Input=proxy))
    if fits(grid) and suffix != ".stl":
        return without_ghosts(grid)
    triangles = suffix == ".stl"
    # This filter does not treat faces of ghost cells as boundary faces.
    surface = append(simple.MeshSurface(Input=proxy, Triangulate=int(triangles), PassThroughIds=0))
    if fits(surface):
        if _has_volumes(grid):
            notes.append(
                f"The boundary surface was written{', as triangles' if triangles else ''}."
            )
        return surface
    known = writable_extensions(made[0]) | writable_extensions(grid) | writable_extensions(surface)
    has_blocks = pipeline.is_composite(made[0])
    if suffix in FORMATS_WITH_BLOCKS & formats.written_extensions() and not has_blocks:
        raise ValueError(
            f"{target}: *{suffix} files store meshes of several blocks, and this mesh has none: write "
            f"{target.stem}{mesh_facts.extension(made[0])}"
        )
    if suffix in formats.written_extensions():
        raise ValueError(f"{target}: *{suffix} files cannot store a mesh like this")
    raise ValueError(
        f"{target}: no writer for {suffix}{formats.suggestion(suffix, known)}; "
        f"the known extensions are {' '.join(sorted(known))}"
    )


def _add_patches(opened: pipeline.Opened, made: list[Any], target: Path, notes: list[str]) -> None:
    """Makes ParaView's OpenFOAM reader read the patches, too, whose names become those of boundaries; or adds to `made`
    a source with the whole mesh, if possible."""
    source = opened.source
    if source.GetXMLName() != "OpenFOAMReader":
        return
    beside = next(folder for folder in target.absolute().parents if folder.is_dir())
    reason = "it has several meshes"
    with pipeline.Messages() as messages:
        try:
            if foam_case.has_one_mesh(source):
                made.append(foam_case.restore(source, beside))
                return
        except Exception as error:  # of files that this package does not understand
            reason = str(error)
        notes.append(
            "Only the names of patches are read of the case, and points in single precision, because "
            f"{reason}."
        )
        known = source.GetProperty("MeshRegions").Available
        source.MeshRegions = [n for n in known if n == "internalMesh" or n.startswith("patch/")]
        source.UpdatePipeline(opened.time["value"] if opened.time else None)
    if messages.errors:
        raise RuntimeError(messages.errors[0])


def _further_outputs(source: Any) -> list[Any]:
    """The non-empty outputs of a reader other than the mesh, such as boundaries by zone."""
    ports = range(1, source.SMProxy.GetNumberOfOutputPorts())
    return [
        simple.OutputPort(source, port)
        for port in ports
        if pipeline.data_information(source[port]).GetNumberOfCells() > 0
    ]


def _describe_output(output: Any) -> str:
    """`Boundaries (inlet, outlet)`"""
    name = output.SMProxy.GetOutputPortName(output.Port)
    hierarchy = output.GetDataInformation().GetHierarchy()
    if hierarchy is None:
        return name
    blocks = [hierarchy.GetNodeName(i) for i in hierarchy.GetChildNodes(hierarchy.GetRootNode())]
    return f"{name} ({', '.join(blocks)})"


def _is_volume(proxy: Any) -> bool:
    return not pipeline.data_information(proxy).DataSetTypeIsA("vtkPolyData")


def _has_volumes(proxy: Any) -> bool:
    """Whether there are 3D cells."""
    quality = simple.ElementQuality(Input=proxy, Criteria=["FaceCount"])
    quality.UpdatePipeline()
    counts = quality.CellData["FaceCount"]  # NaN of other cells
    low, high = counts.GetRange() if counts else (1, 0)
    simple.Delete(quality)
    return low <= high


def _count_by_type(proxy: Any) -> dict[str, int]:
    """`{"Tetra": 12, "All": 12}`"""
    quality = simple.ElementQuality(Input=proxy, Criteria=["CellTypeId"])
    statistics = simple.QualityStatistics(
        Input=quality, GroupBy="Cell type", NumberOfWorst=0, NumberOfBins=1
    )
    counts = {row["Group"]: row["Count"] for row in tables.fetch(statistics)}
    for made in (statistics, quality):
        simple.Delete(made)
    return counts


def _check_types(proxy: Any, target: Path) -> None:
    """Raises ValueError if the mesh has cells that would crash the writer of one of ParaView's
    formats."""
    suffix = target.suffix.lower()
    if suffix not in WITHOUT_POLYHEDRA | OF_IOSS or formats.own_writer(target):
        return
    if not pipeline.data_information(proxy).GetNumberOfCells():
        return
    counts = _count_by_type(proxy)
    known = IOSS_TYPES if suffix in OF_IOSS else set(counts) - {"Polyhedron"}
    for label, count in counts.items():
        if label != "All" and label not in known:
            raise ValueError(
                f"{target}: *{suffix} files cannot store {text.cell_type(label)}, and the mesh has "
                f"{count}: choose .vtu or a format of the plugin"
            )


def _without_triangles(proxy: Any) -> list[str]:
    """A sentence about cells of fewer than two dimensions, if there are any."""
    counts = _count_by_type(proxy)
    lost = [
        f"{counts[label]} {text.cell_type(label, counts[label])}"
        for label in POINTS_AND_LINES
        if counts.get(label)
    ]
    return [f"Omitted, because these are not triangles: {', '.join(lost)}."] if lost else []


def writable_extensions(proxy: Any) -> set[str]:
    """Extensions of the formats that can store the output of the source, such as ".vtu"."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    if not factory.GetNumberOfRegisteredPrototypes():
        factory.UpdateAvailableWriters()
    types = factory.GetSupportedFileTypes(proxy.SMProxy, 0)
    return {"." + extension.lower() for extension in re.findall(r"\*\.([\w.]+)", types)}


def write(
    proxy: Any,
    target: os.PathLike | str,
    options: dict[str, Any],
    inputs: Inputs,
    notes: Optional[list[str]] = None,
    source: Optional[Path] = None,
) -> list[str]:
    """Writes to a temporary name, then renames; returns the names of the files and folders written.
    Raises ValueError for a target that would replace an input.

    Formats of several files (.vtm, .node and .ele) have further names, which must not belong to the
    mesh of the file `source`. Warnings of the writer are added to `notes`.
    """
    target = Path(target)
    inputs.refuse(target)
    _check_types(proxy, target)
    with Staging(target.parent, inputs) as staging, pipeline.Messages() as messages:
        own = formats.own_writer(target)
        path = (target.parent if own in OF_FOLDERS else staging.path) / target.name
        renamed, changes = proxy, []
        writer = _make_writer(proxy, path)
        try:
            if messages.errors:  # the writer of CGNS, which needs MPI, would crash
                raise RuntimeError(messages.errors[0])
            if _table(writer):
                writer.Precision = 17  # digits; all that double-precision numbers have
            for name, value in options.items():
                formats.set_option(writer, name, value)
            table = _table(writer)
            mark = storable_names.usual_mark(writer) if table else None
            if own:
                writer.UpdatePipeline()
            else:
                renamed, names_of_arrays = storable_names.writable(proxy, target, changes)
                writer.Input = renamed
                storable_names.choose_renamed(writer, names_of_arrays)
                _write_as_paraview(writer, proxy, path, _writes_all_steps(options))
                if mark is not None and pipeline.is_first_rank():
                    storable_names.set_mark(staging.path, mark)
        except RuntimeError as error:
            messages.errors.append(str(error))
        finally:
            simple.Delete(writer)
            if renamed is not proxy:
                simple.Delete(renamed)
        names = staging.names() if own not in OF_FOLDERS else [target.name] * target.exists()
        if messages.errors or (not names and pipeline.is_first_rank()):
            reason = completeness.plain_reason(messages.errors, staging.path)
            raise RuntimeError(_with_path(target, reason))
        if own not in OF_FOLDERS:
            _check_companions(target, names, source)
            staging.publish()
        if notes is not None:
            notes += [note for note in changes + messages.warnings if note not in notes]
            notes += _companions_that_stay(target, names)
            notes += _lost_in_surfaces(proxy, target)
            notes += _rounded(proxy, target)
            if table:
                notes.append(
                    f"Only a table of the {table} was written; the option field-association "
                    "selects other data."
                )
            if staging.created:
                notes.append(f"The folder {target.parent} was created.")
    return names


def _write_as_paraview(writer: Any, proxy: Any, path: Path, all_steps: bool) -> None:
    """Writes with one of ParaView's writers; raises RuntimeError even if the writer does not report
    its failure."""
    completeness.check_space(proxy, path, path.parent)
    with pipeline.threads_for(pipeline.data_information(proxy)):
        if path.suffix.lower() not in completeness.WITH_HDF5:
            writer.UpdatePipeline()
        else:
            with completeness.StandardError() as noise:
                writer.UpdatePipeline()
            if noise.reason():
                raise RuntimeError(noise.reason())
    if not pipeline.is_first_rank():
        return
    _name_as_asked(path)
    completeness.check_written(proxy, path, all_steps)


def _name_as_asked(path: Path) -> None:
    """Renames `part.0.case`, as the EnSight writer names `part.case`, or `part.CASE`."""
    numbered = path.with_name(f"{path.stem}.0{path.suffix.lower()}")
    if not path.exists() and numbered.is_file():
        numbered.rename(path)


def _are_of_one_mesh(a: Path, b: Path) -> bool:
    """Whether two files have the names of one mesh in a format of the plugin with several files per
    mesh."""
    kinds = formats.own_extensions(formats.own_writer(b))
    return a.suffix.lower() in kinds and same_file(a.parent, b.parent) and a.stem == b.stem


def _check_companions(target: Path, names: list[str], source: Optional[Path]) -> None:
    """Raises RuntimeError if files or folders written with the target would replace those of
    another mesh."""
    replaced = [place for place in (target.parent / name for name in names) if place.exists()]
    if source and replaced and len(names) > 1 and _are_of_one_mesh(source, target):
        raise RuntimeError(
            f"{target}: this would replace {', '.join(map(str, replaced))}, which belongs to the mesh of "
            f"{source}: choose another name"
        )
    if target.exists():
        return  # they belong to the target
    for place in (target.parent / name for name in names):
        if place.is_dir():
            raise RuntimeError(
                f"{target}: the folder {place} for its pieces already exists: choose another "
                "name, or remove the folder"
            )
        if place.name != target.name and place.suffix != target.suffix and place.exists():
            raise RuntimeError(
                f"{target}: the file {place}, which is written with it, already exists: choose another "
                "name, or remove the file"
            )


def _companions_that_stay(target: Path, names: list[str]) -> list[str]:
    """A sentence about files of another mesh that readers will combine with the files written."""
    kinds = formats.own_extensions(formats.own_writer(target)) if len(names) > 1 else []
    old = [target.stem + kind for kind in kinds if target.stem + kind not in names]
    old = [name for name in old if (target.parent / name).exists()]
    return [f"Files of the same name do not belong to this mesh: {', '.join(old)}."] if old else []


def _lost_in_surfaces(proxy: Any, target: Path) -> list[str]:
    """A sentence about arrays that formats of bare surfaces cannot store."""
    suffix = target.suffix.lower()
    if suffix not in BARE_SURFACES:
        return []
    lost = [
        f"{name} of {noun}"
        for noun, data in (("points", proxy.PointData), ("cells", proxy.CellData))
        for name in data.keys()
        if name not in NO_LOSS
    ]
    return [f"*{suffix} files store no arrays; not written: {', '.join(lost)}."] if lost else []


def _rounded(proxy: Any, target: Path) -> list[str]:
    """A sentence where single precision is coarse for the mesh, as far from the origin; the plugin's writers refuse
    cells that it spoils."""
    suffix = target.suffix.lower()
    if suffix not in SINGLE_PRECISION:
        return []
    data = pipeline.data_information(proxy)
    points = data.GetPointArrayInformation()
    if not points or points.GetDataType() == VTK_FLOAT:
        return []
    bounds = data.GetBounds()
    greatest, size = max(map(abs, bounds)), math.dist(bounds[::2], bounds[1::2])
    step = math.ldexp(1, math.frexp(greatest)[1] - 24) if math.isfinite(greatest) else 0
    if not step > 1e-6 * size > 0:
        return []
    return [
        f"*{suffix} files have coordinates in single precision: they are rounded to multiples of {step:g} in a mesh of "
        f"size {size:g}, because it is far from the origin."
    ]


def _make_writer(proxy: Any, path: Path) -> Any:
    """The plugin's writer for the extension, else ParaView's."""
    name = formats.own_writer(path)
    if name is None:
        # ParaView knows extensions in lower case only.
        writer = simple.CreateWriter(str(path.with_suffix(path.suffix.lower())), proxy)
        if writer:
            writer.FileName = str(path)
        return writer
    writer = formats.make_writer(name)
    writer.Input = proxy
    writer.FileName = str(path)
    return writer


def _table(writer: Any) -> Optional[str]:
    """The data that a writer of tables writes of a mesh: "point data"."""
    association = writer.GetProperty("FieldAssociation")
    return association.GetData().lower() if association else None


def _with_path(target: Path, reason: str) -> str:
    """The reason after the path; messages of the plugin's writers already begin with the name."""
    if reason.startswith(target.name + ": "):
        reason = reason[len(target.name) + 2 :]
    return f"{target}: {reason}"
