# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks of the table in report_rows.py and writes Documentation/performance.md.

Usage: ./camaron bench --report [--now] [--quick]

The page is made of performance.json beside it, which stores one run for each version of ParaView; a run replaces that of
its own version, and says what has moved since. --now does not wait until the machine is quiet, and --quick uses tiny
meshes: the page then says so, and goes to the folder of the build.
"""

import argparse
import datetime
import json
import os
import platform
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from report_page import compare, page, pictures, readme
from report_rows import MACHINE, PICTURE_RUNS, RUNS, TABLE

ROOT = Path(__file__).resolve().parents[2]
#: Processes that run or want to, on average over a minute.
QUIET_LOAD = 0.3
#: What pictures should look like, run before their benchmarks.
PICTURE_TESTS = ("TestMeshInspection.py", "TestExactCut.py")


def load():
    return os.getloadavg()[0]


def wait_until_quiet():
    said = False
    while load() >= QUIET_LOAD:
        if not said:
            print(
                f"load {load():.2f}: waiting until it is below {QUIET_LOAD}; --now does not wait",
                flush=True,
            )
            said = True
        time.sleep(5)


def first_match(path, pattern):
    found = re.search(pattern, Path(path).read_text(encoding="utf-8"), re.MULTILINE)
    return found[1].strip() if found else "unknown"


def machine():
    """What figures depend on beside the programs."""
    memory = int(first_match("/proc/meminfo", r"^MemTotal:\s*(\d+)"))
    return {
        "processor": first_match("/proc/cpuinfo", r"^model name\s*: (.*)") or platform.machine(),
        "cores": len(os.sched_getaffinity(0)),
        "memory": f"{memory / 2**20:.0f} GiB",
    }


def plugin():
    """The line about this build, such as "camaron 0.1.0+3f2a9c1b2d for ParaView 5.13.2, ..."."""
    folder = os.environ["PV_PLUGIN_PATH"].split(os.pathsep)[0]
    return Path(folder, "version.txt").read_text(encoding="utf-8").strip()


def is_peer_optimized():
    """Whether VTK is, as far as its code tells: None where it does not. Debian's ParaView 5.13 has a VTK that is not.

    Without optimization nearly every function of x86-64 begins with a frame and stores its first argument in it.
    """
    try:
        import vtkmodules.vtkFiltersCore  # noqa: F401

        with open("/proc/self/maps", encoding="utf-8") as file:
            found = re.search(r"/\S+/libvtkFiltersCore\S*", file.read())
    except (ImportError, OSError):
        return None
    if not found or platform.machine() != "x86_64":
        return None
    code = Path(found[0]).read_bytes()
    frames = len(re.findall(rb"\x55\x48\x89\xe5", code))  # push %rbp; mov %rsp,%rbp
    stores = re.findall(rb"\x55\x48\x89\xe5\x53?(?:\x48\x83\xec.)?\x48\x89\x7d", code, re.DOTALL)
    return len(stores) < 0.2 * max(frames, 1000)


def run(programs, is_quick, runs=RUNS):
    """The records of the table's rows, from all benchmarks in turn."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "records")
        environment = {**os.environ, "CAMARON_BENCHMARK_RECORDS": str(path)}
        for name, usual, tiny in runs:
            command = [str(programs / f"Benchmark{name}"), *map(str, tiny if is_quick else usual)]
            print(f"\n{' '.join(command)}", flush=True)
            status = subprocess.run(command, env=environment).returncode
            if status:
                sys.exit(f"camaron: {command[0]} failed with status {status}")
        lines = path.read_text(encoding="utf-8").splitlines()
    wanted = {(row.work, row.mesh) for row in TABLE} | {(work, "machine") for work in MACHINE}
    return [r for r in map(json.loads, lines) if (r["work"], r["mesh"]) in wanted]


def test_pictures(programs, folder):
    """The results of tests by name. What they print goes to logs in the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    results = {}
    for name in PICTURE_TESTS:
        command = [programs / "python", ROOT / "Testing" / "Python" / name]
        with open(folder / f"{name}.log", "w", encoding="utf-8") as log:
            status = subprocess.run(command, stdout=log, stderr=subprocess.STDOUT).returncode
        results[name] = {0: "passed", 77: "skipped"}.get(status, "**failed**")
        print(f"{name}: {results[name].strip('*')}", flush=True)
    return results


def as_json(results):
    """One line for each record, so that differences can be read."""
    lines = []
    for version, of_version in results.items():
        head = {key: value for key, value in of_version.items() if key != "records"}
        head = json.dumps({**head, "records": []}, ensure_ascii=False)
        records = (json.dumps(r, ensure_ascii=False) for r in of_version["records"])
        lines.append(f"{json.dumps(version)}: {head[:-2]}\n" + ",\n".join(records) + "\n]}")
    return "{\n" + ",\n".join(lines) + "\n}\n"


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(prog="camaron bench --report", description=__doc__)
    parser.add_argument("programs", type=Path, help=argparse.SUPPRESS)  # their folder
    parser.add_argument("--now", action="store_true", help="do not wait for a quiet machine")
    parser.add_argument("--quick", action="store_true", help="tiny meshes, to try the command")
    parser.add_argument("--pictures", type=Path, metavar="FOLDER", help=argparse.SUPPRESS)
    options = parser.parse_args()
    folder = options.programs.parent / "report" if options.quick else ROOT / "Documentation"
    stored = folder / "performance.json"
    results = json.loads(stored.read_text(encoding="utf-8")) if stored.exists() else {}
    if not options.now:
        wait_until_quiet()
    new = {
        "plugin": plugin(),
        "date": datetime.date.today().isoformat(),
        "load": load(),
        "quiet": load() < QUIET_LOAD,
        "quick": options.quick,
        "machine": machine(),
        "is_peer_optimized": is_peer_optimized(),
    }
    version = re.search(r"for ParaView ([\d.]+)", new["plugin"])[1]
    if options.pictures:
        new["tests"] = test_pictures(options.programs, options.pictures)
        new["records"] = []
        for one in PICTURE_RUNS:  # what there is so far, should the machine be taken away
            new["records"] += run(options.programs, options.quick, [one])
            text = pictures({version: new})
            write(options.pictures / "graphics-card.json", as_json({version: new}))
            write(options.pictures / "graphics-card.md", text)
        print(f"\n{text}\nwrote {options.pictures}/graphics-card.md and .json")
        return
    new["records"] = run(options.programs, options.quick)
    if version in results:
        print(f"\nSince {results[version]['date']}:")
        print("\n".join(compare(results[version], new)) or "nothing moved by more than the spread")
    results[version] = new
    write(stored, as_json(results))
    on_cards = ROOT / "Documentation" / "graphics-card.json"
    on_cards = json.loads(on_cards.read_text(encoding="utf-8")) if on_cards.exists() else {}
    write(folder / "performance.md", page(results, on_cards))
    if not options.quick:
        path = ROOT / "README.md"
        write(path, readme(path.read_text(encoding="utf-8"), results))
    print(f"\nwrote {folder / 'performance.md'}")


if __name__ == "__main__":
    main()
