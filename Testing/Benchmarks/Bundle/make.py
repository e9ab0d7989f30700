# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a bundle that measures pictures of Mesh Inspection on a machine that has a graphics card and nothing else.

Usage: ./camaron bench --bundle FOLDER

Runs the benchmark once with tiny meshes, and copies the files that it opened: of ParaView, Python, the loader of OpenGL and
an X server. FOLDER gets an archive in parts, their checksums and the script unpack-and-run, to be copied there together.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import paraview

BUNDLE = Path(__file__).resolve().parent
ROOT = BUNDLE.parents[2]
#: Of a part, in bytes.
LARGEST_PART = 60 * 2**20
#: Of ours, beside the plugin.
OURS = ("Examples", "Scripts", "Testing/Baselines", "Testing/Benchmarks", "Testing/Python")
#: What only other machines open: drivers of graphics cards need these, and no program names its loader.
MORE = ("libdl.so.2", "libpthread.so.0", "librt.so.1", "libXext.so.6", "libX11-xcb.so.1")
LOADER = "/lib64/ld-linux-x86-64.so.2"
#: Files in these folders are the machine's.
OF_THE_MACHINE = ("/dev/", "/etc/", "/proc/", "/run/", "/sys/", "/tmp/", "/var/")


def has_egl():
    """Whether this ParaView draws without an X server; 6.0 and newer do."""
    try:
        from vtkmodules.vtkRenderingOpenGL2 import vtkEGLRenderWindow  # noqa: F401
    except ImportError:
        return False
    return True


def stage(bundle, make_mesh):
    """Copies what is ours, with programs that run inside the bundle and, as now, outside."""
    ours, plugin = bundle / "camaron", Path(os.environ["PV_PLUGIN_PATH"].split(os.pathsep)[0])
    for folder in OURS:
        unneeded = shutil.ignore_patterns("__pycache__")
        shutil.copytree(ROOT / folder, ours / folder, ignore=unneeded)
    (ours / "plugin").mkdir()
    for name in ("Camaron.so", "formats.json", "version.txt"):
        shutil.copy2(plugin / name, ours / "plugin")
    (ours / "bin").mkdir()
    shutil.copy2(make_mesh, ours / "bin" / "MakeMesh.program")
    python = os.path.realpath(sys.executable)
    script = '"$bin/../Testing/Benchmarks/BenchmarkInspection.py" "$bin/MakeMesh"'
    for name, command in (
        ("python", f'"${{CAMARON_ROOT-}}{python}"'),
        ("MakeMesh", '"$bin/MakeMesh.program"'),
        ("BenchmarkInspection", f'"${{CAMARON_ROOT-}}{python}" {script}'),
    ):
        path = ours / "bin" / name
        loader = f'"$CAMARON_ROOT{LOADER}" --library-path "$CAMARON_LIBRARIES"'
        path.write_text(
            "#!/bin/sh\nbin=${0%/*}\n"
            f'[ -n "${{CAMARON_ROOT-}}" ] || exec {command} "$@"\nexec {loader} {command} "$@"\n'
        )
        path.chmod(0o755)
    return ours


def trace(command, folder, **environment):
    """The files that a command and its children open and run."""
    log = folder / "trace"
    shutil.rmtree(log, ignore_errors=True)
    log.mkdir()
    strace = ["strace", "-ff", "--seccomp-bpf", "-qq", "-y", "-z", "-s", "4096"]
    strace += ["-e", "trace=open,openat,execve", "-e", "signal=none", "-o", str(log / "of")]
    status = subprocess.run(strace + command, env={**os.environ, **environment}).returncode
    if status:
        sys.exit(f"camaron: a run with tiny meshes failed with status {status}")
    text = "".join(of.read_text("utf-8") for of in log.iterdir())
    # As named, for links, and as found, for names in other folders.
    named = re.findall(r'^(?:openat\([^"]*|open\(|execve\()"(/[^"]+)"', text, re.MULTILINE)
    return {*named, *re.findall(r"^open.* = \d+<(/[^>]+)>$", text, re.MULTILINE)}


def depends_on(library):
    """The library's path and those of what it needs, without those that this machine does not have."""
    text = subprocess.run(["ldd", library], capture_output=True, text=True).stdout
    return [library, *re.findall(r"=> (/\S+)", text)]


def needed(opened, temporary):
    """The files of ParaView and the system among those that were opened, and those that belong to them."""
    libraries = os.path.dirname(next(p for p in opened if p.endswith("/libc.so.6")))
    more = [os.path.join(libraries, name) for name in MORE]
    opened = {LOADER, *opened, *(p for m in more if os.path.exists(m) for p in depends_on(m))}
    # Python does not use the compiled module without the other.
    opened |= {re.sub(r"__pycache__/([^/]+)\.cpython-\d+\.pyc$", r"\1.py", path) for path in opened}
    mine = (*OF_THE_MACHINE, f"{temporary}/", f"{ROOT}/", f"{os.environ['CAMARON_HOME']}/")
    for path in sorted(opened):
        if not path.startswith(mine) and os.path.isfile(path):
            yield path


def copy(path, root):
    """Copies a file, and the links on the way to it as relative ones."""
    done, rest = "/", [part for part in path.split("/") if part]
    while rest:
        here = os.path.normpath(os.path.join(done, rest.pop(0)))
        copied = Path(f"{root}{here}")
        if os.path.islink(here):
            target = os.path.normpath(os.path.join(done, os.readlink(here)))
            if not copied.is_symlink():
                copied.parent.mkdir(parents=True, exist_ok=True)
                copied.symlink_to(os.path.relpath(target, done))
            done, rest = "/", [part for part in target.split("/") if part] + rest
        else:
            done = here
    if not copied.exists():
        copied.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(done, copied)
    return done


def pack(bundle, folder):
    """Writes the parts, their checksums and the script that unpacks them."""
    part = str(folder / "part-")
    tar = subprocess.Popen(["tar", "-cz", "-C", str(bundle), "."], stdout=subprocess.PIPE)
    split = ["split", "-d", "-b", str(LARGEST_PART), "-", part]
    subprocess.run(split, stdin=tar.stdout, check=True)
    if tar.wait():
        sys.exit("camaron: tar failed")
    parts = sorted(path.name for path in folder.glob("part-*"))
    with open(folder / "checksums", "w") as file:
        subprocess.run(["sha256sum", *parts], cwd=folder, stdout=file, check=True)
    shutil.copy2(BUNDLE / "unpack-and-run", folder)
    size = sum((folder / name).stat().st_size for name in parts)
    print(
        f"wrote {folder}: {len(parts)} parts, {size / 2**20:.0f} MiB; copy it, and run unpack-and-run there"
    )


def main():
    parser = argparse.ArgumentParser(prog="camaron bench --bundle", description=__doc__)
    parser.add_argument("make_mesh", help=argparse.SUPPRESS)
    parser.add_argument("folder", type=Path, help="a folder that does not exist or is empty")
    options = parser.parse_args()
    if not shutil.which("strace"):
        parser.error("there is no strace, which finds the files of the bundle: install it")
    options.folder.mkdir(parents=True, exist_ok=True)
    if any(options.folder.iterdir()):
        parser.error(f"{options.folder}: expected an empty folder")
    with tempfile.TemporaryDirectory(prefix="camaron-bundle.") as name:
        bundle = Path(name, "bundle")
        ours = stage(bundle, options.make_mesh)
        environment = {
            "PV_PLUGIN_PATH": str(ours / "plugin"),
            "PYTHONPATH": f"{ours}/Scripts:{ours}/Testing/Python",
            "PYTHONDONTWRITEBYTECODE": "1",
            "HOME": name,  # without anybody's settings
        }
        report = [str(ours / "bin" / "python"), str(ours / "Testing/Benchmarks/report.py")]
        report += [str(ours / "bin"), "--now", "--quick", "--pictures", str(Path(name, "results"))]
        display = str(ROOT / "Scripts" / "launcher" / "with-display")
        opened = trace([display, *report], Path(name), **environment)
        if has_egl():
            egl = {"VTK_DEFAULT_OPENGL_WINDOW": "vtkEGLRenderWindow", "DISPLAY": ""}
            tiny = [str(ours / "bin" / "BenchmarkInspection"), "0.001", "0"]
            opened |= trace(tiny, Path(name), **environment, **egl)
            (bundle / "has-egl").touch()
        root = bundle / "root"
        copied = [copy(path, root) for path in needed(opened, name)]
        folders = sorted({os.path.dirname(path) for path in copied if ".so" in Path(path).name})
        (bundle / "libraries").write_text("\n".join(folders) + "\n")
        modules = Path(paraview.__file__).parents[1]
        (bundle / "python").write_text(f"{sys.prefix}\n{modules}\n")
        (root / "tmp").mkdir()  # of the X server, whoever starts it
        (root / "tmp").chmod(0o1777)
        shutil.copy2(BUNDLE / "run", bundle)
        pack(bundle, options.folder)


main()
