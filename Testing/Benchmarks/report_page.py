# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/performance.md and what the README shows of it, from the results of report.py; and two runs compared."""

from collections import Counter

from benchmark_records import CELLS_FOR_SLOW_PEERS, OURS, REPETITIONS
from report_rows import MACHINE, PICTURES, TABLE, Figures

BEGIN = "<!-- Made by Testing/Benchmarks/report.py -->\n"
END = "<!-- end of the benchmarks -->\n"

HEAD = f"""# Performance

Written by `./camaron bench --report`: each piece of work of Camarón beside that of a peer on the same mesh, in the same
run. No figure is taken from elsewhere, such as from papers. Run it on your machine to compare.

Times are medians of {REPETITIONS} runs, of fewer if they take more than a minute; ± is half of the difference between the
longest and the shortest, in percent. Files are in the system's cache. *Faster* is the peer's time divided by ours, for each
cell where the meshes differ: filters that take minutes for a million polyhedra get {CELLS_FOR_SLOW_PEERS:,}. Targets *per
core* are compared with the processor time of all threads together. *Memory* is the peak while it runs, without mapped
files. Polyhedra are truncated octahedra with jittered points; tetrahedra and triangles are in random order.
"""

CARD = """## On a graphics card

Written by the bundle that `./camaron bench --bundle` makes for a machine with a graphics card. How much of a picture is drawn
by the card and how much is computed before differs from row to row.
"""
NO_CARD = """Nobody has run this yet: all figures above are those of the renderer that their section names.
"""
NOT_OPTIMIZED = (
    "**The VTK of this ParaView was compiled without optimization**, Camarón with it: do not quote ratios to filters, readers"
    " and pictures of VTK and ParaView from here."
)


def scaled(value, units):
    """A value in the largest of its units that leaves at least 1, or else in the smallest."""
    for factor, unit in units:
        if value >= factor:
            break
    digits = 0 if value >= 100 * factor else 1 if value >= 10 * factor else 2
    return f"{value / factor:,.{digits}f} {unit}"


def duration(seconds):
    return scaled(seconds, ((1, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")))


def memory(size):
    return scaled(size, ((1e9, "GB"), (1e6, "MB"), (1e3, "kB"), (1, "bytes")))


def time_of(figures, is_per_cell):
    text = duration(figures.per_cell()) + " per cell" if is_per_cell else duration(figures.wall)
    if figures.wall:
        text += f" ±{50 * figures.spread / figures.wall:.0f} %"
    return text + (f", of {figures.runs}" * (1 < figures.runs < REPETITIONS))


def memory_of(figures):
    if not figures or not figures.peak + figures.size:
        return "–"
    return ", mesh ".join(memory(size) for size in (figures.peak, figures.size) if size)


def pairs(records, table=TABLE):
    """Of each row of the table, our figures and those of a peer of the same number of cells, or of what cells there are;
    the first of each row is marked, and figures that nobody measured are None."""
    for row in table:
        found = [Figures.of(r) for r in records if (r["work"], r["mesh"]) == (row.work, row.mesh)]
        peers = [figures for figures in found if figures.by != OURS]
        for ours in [figures for figures in found if figures.by == OURS] or [None]:
            same = [peer for peer in peers if ours and peer.cells == ours.cells]
            for i, peer in enumerate(same or peers or [None]):
                yield row, ours, peer, i == 0


def ratio(ours, peer):
    return scaled(peer.per_cell() / ours.per_cell(), ((1, "×"),)) if ours and peer else ""


def of_cells(ours, peer):
    """Words about the cells of a peer that got other ones."""
    return f", {peer.cells:,} cells" * (peer.cells != ours.cells)


def line(row, ours, peer, is_first):
    """Of the page's table. What is only about us is in the first line of a row."""
    if not ours:
        return f"| {row.work} | {row.mesh} | not measured | | | | | |"
    differs = bool(peer) and peer.cells != ours.cells
    targets = [
        f"{target.text}: {'met' if target.is_met(ours, peer) else '**missed**'}"
        for target in row.targets
        if (peer if target.needs_peer else is_first)
    ]
    our_time = time_of(ours, row.is_per_cell)
    if differs and not row.is_per_cell:
        our_time += f", {duration(ours.per_cell())} per cell"
    columns = [
        row.work if is_first else "",
        f"{ours.cells:,} {row.mesh}" if is_first else "",
        our_time if is_first else "",
        peer.by + of_cells(ours, peer) if peer else "",
        time_of(peer, row.is_per_cell or differs) if peer else "",
        ratio(ours, peer),
        "; ".join(targets),
        f"{memory_of(ours)} / {memory_of(peer)}",
    ]
    return f"| {' | '.join(columns)} |"


def most_common(records, key):
    (value, _), *_ = Counter(r[key] for r in records if r.get(key)).most_common(1) or [("none", 0)]
    return value


def section(version, run, table=TABLE):
    """The page's section about a version of ParaView."""
    records, machine = run["records"], run["machine"]
    lines = [
        f"## ParaView {version}",
        "",
        f"On {run['date']}: {machine['processor']}, {machine['cores']} cores, {machine['memory']};"
        f" VTK {most_common(records, 'vtk')}, {most_common(records, 'threads')} threads, SMP backend"
        f" {most_common(records, 'backend')}; pictures by {most_common(records, 'renderer')},"
        f" OpenGL {most_common(records, 'driver')};"
        f" {run['plugin']}. The load was {run['load']:.2f} before.",
    ]
    if run.get("is_peer_optimized") is False:
        lines += ["", NOT_OPTIMIZED]
    if run["quick"]:
        lines += ["", "**These are tiny meshes, to try the command; the figures say nothing.**"]
    if not run["quiet"]:
        lines += ["", "**The machine was busy with other programs (`--now`): do not quote this.**"]
    limits = [
        f"{r['work']} {r['cells'] / Figures.of(r).wall / 1e9:.1f} GB/s"
        for r in records
        if r["work"] in MACHINE
    ]
    lines += ["", f"The machine itself: {', '.join(limits)}.", ""] if limits else [""]
    lines += [
        "| work | mesh | Camarón | peer | its time | faster | target | memory, ours / the peer's |",
        "| --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    lines += [line(*pair) for pair in pairs(records, table)]
    return "\n".join(lines) + "\n"


def by_version(results):
    """Versions with their runs, the newest ParaView first."""
    return sorted(
        results.items(), key=lambda item: [int(n) for n in item[0].split(".")], reverse=True
    )


def page(results, on_cards=None):
    """The page about all runs; those on graphics cards are in a section of their own."""
    sections = [section(*item) for item in by_version(results)]
    return "\n".join([HEAD, *sections, pictures(on_cards or {})])


def pictures(results):
    """What the bundle for machines with a graphics card writes."""
    sections = []
    for version, run in by_version(results):
        tests = ", ".join(f"`{name}` {result}" for name, result in run["tests"].items())
        sections.append(f"#{section(version, run, PICTURES)}\nTests of pictures: {tests}.\n")
    return "\n".join([CARD, *(sections or [NO_CARD])])


def readme(text, results):
    """The README with the rows of it that the table marks, of the newest ParaView whose VTK is optimized."""
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    runs = by_version(results)
    fair = [item for item in runs if item[1].get("is_peer_optimized") is not False]
    version, run = (fair or runs)[0]
    lines = [
        "## Performance",
        "",
        f"| beside ParaView {version} and OpenFOAM | Camarón | peer | |",
        "| --- | --- | --- | --- |",
    ]
    shown = set()
    for row, ours, peer, _ in pairs(run["records"]):
        if row.is_in_readme and ours and peer and row not in shown:
            shown.add(row)  # of several sizes, the first
            differs = row.is_per_cell or ours.cells != peer.cells
            lines.append(
                f"| {row.work}, {ours.cells:,} {row.mesh} | {time_of(ours, differs)}"
                f" | {peer.by}{of_cells(ours, peer)}: {time_of(peer, differs)} | {ratio(ours, peer)} |"
            )
    lines += [
        "",
        f"On {run['machine']['cores']} cores of {run['machine']['processor']}, Camarón with "
        f"{most_common(run['records'], 'threads')} threads; "
        "[all benchmarks, and how to run them](Documentation/performance.md).",
        "",
    ]
    return before + BEGIN + "\n".join(lines) + END + after


def compare(old, new):
    """Lines about what moved by more than the spread of both runs. On another machine, or with other threads, these are
    ratios to peers, whose times should have changed as ours have."""
    same = all(
        (old["machine"], most_common(old["records"], key))
        == (new["machine"], most_common(new["records"], key))
        for key in ("threads", "backend")
    )
    return list(moved_times(old, new) if same else moved_ratios(old, new))


def moved_times(old, new):
    def keyed(run):
        figures = ((r, Figures.of(r)) for r in run["records"])
        return {(r["work"], r["mesh"], r["by"], f.cells): f for r, f in figures}

    before = keyed(old)
    for key, now in keyed(new).items():
        then = before.get(key)
        if then and abs(now.wall - then.wall) > max(now.spread, then.spread):
            work, mesh, by, cells = key
            what = f"{work}, {cells:,} {mesh}, {by}" if work not in MACHINE else work
            change = f"{100 * (now.wall / then.wall - 1):+.0f} %"
            yield f"{what}: {duration(then.wall)} -> {duration(now.wall)} ({change})"


def moved_ratios(old, new):
    def keyed(run):
        return {
            (row.work, row.mesh, ours.cells, peer.by): (
                peer.per_cell() / ours.per_cell(),
                ours.spread / ours.wall + peer.spread / peer.wall,
            )
            for row, ours, peer, _ in pairs(run["records"])
            if ours and peer
        }

    before = keyed(old)
    for key, (now, spread) in keyed(new).items():
        then, spread_then = before.get(key, (now, 0))
        if abs(now / then - 1) > max(spread, spread_then):
            work, mesh, cells, by = key
            yield f"{work}, {cells:,} {mesh}, beside {by}: {then:.2f} × -> {now:.2f} ×"
