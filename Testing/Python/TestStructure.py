# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The folders of the source tree: each small, in modules and layers."""

import re
import shutil
import subprocess
import unittest
from collections import Counter, defaultdict

import camaron_testing
from camaron import cli

#: Folders from the lowest to the highest; each includes only from those before it.
LAYERS = {
    "Core": "Base Scan Geometry Mesh Curved Cell Ranks Criteria Statistics Elements Rules Selection Drawing",
    "Readers/Intake": "Ids Rows Pieces Write FaceMesh CellMesh Fluent",
    "Filters": "Common Statistics Quality Extract Check Compare Select Server",
    "Representations": "Style Cuts Processor Drawing Labels Overlay Inspection",
    "Plugin/Panel": "Plot Server Cards Properties",
}
#: Fewer includes of other folders would mean that they are not found.
INCLUDES = dict(zip(LAYERS, (200, 12, 90, 30, 70)))
#: Folders without code.
NO_LAYERS = {"Testing", "Shaders", "Icons"}

#: Modules, and those that they may include.
MODULES = {
    "Core": "",
    "Readers": "Core",
    "Filters": "Core",
    "Representations": "Core Filters",
    "Plugin/Panel": "",
}

#: Those of the source tree; builds are elsewhere.
FOLDERS = (
    "CMake Core Documentation Examples Filters Plugin Readers Representations Scripts Testing"
).split()

#: Folders of tests and their data, which nobody reads from top to bottom.
LARGE = re.compile(r"Testing/|Documentation/(criteria|images)")
MOST_FILES = 45


class TestStructure(unittest.TestCase):
    def test_layers(self):
        """With an include to a higher layer, a folder could no longer be read on its own."""
        for root, layers in LAYERS.items():
            layers = layers.split()
            folder = camaron_testing.ROOT / root
            folders = {path.name for path in folder.iterdir() if path.is_dir()} - NO_LAYERS
            self.assertEqual(folders, set(layers))
            homes = self.homes(folder)
            includes = 0
            for path in self.code(folder):
                own = path.relative_to(folder).parts[0]
                for used in self.includes(path) if own in layers else ():
                    places = homes.get(used, {own})
                    includes += own not in places
                    lowest = min(map(layers.index, places & set(layers)), default=0)
                    self.assertLessEqual(lowest, layers.index(own), f"{path.name} includes {used}")
            self.assertGreater(includes, INCLUDES[root], root)

    def includes(self, path):
        """What a source includes; never by a path that goes up."""
        found = re.findall(r'#include "([^"]+)"', path.read_text("utf-8"))
        self.assertNotIn("..", "".join(found), path)
        return found

    def homes(self, root):
        """For what stands in an include, the folders of a root in which such a header is."""
        homes = defaultdict(set)
        for path in self.code(root):
            parts = path.relative_to(root.parent).parts
            for i in range(len(parts)):
                homes["/".join(parts[i:])].add(parts[1])
        for path in root.glob("*/*Reading.h"):  # of formats whose reader is made in the build
            homes[f"vtk{path.stem.removesuffix('Reading')}Reader.h"].add(path.parent.name)
        return homes

    def code(self, folder):
        """Sources and headers in a folder, without tests."""
        paths = [p for p in folder.rglob("*") if p.suffix in (".h", ".cxx")]
        return [p for p in paths if "Testing" not in p.parts[len(camaron_testing.ROOT.parts) :]]

    def test_modules(self):
        """A module would build only together with another one; a format could not be left out."""
        homes = defaultdict(set)
        for module in MODULES:
            for name, folders in self.homes(camaron_testing.ROOT / module).items():
                homes[name] |= {(module, f if module == "Readers" else "") for f in folders}
        includes = 0
        for module, others in MODULES.items():
            root = camaron_testing.ROOT / module
            for path in self.code(root):
                folder = path.relative_to(root).parts[0]
                may = {(m, "") for m in [module, *others.split()]}
                if module == "Readers":  # parts of it are common to all formats
                    common = ("Intake",) if folder == "Intake" else ("Intake", "Base", folder)
                    may |= {(module, name) for name in common}
                for used in self.includes(path):
                    includes += used in homes
                    good = used not in homes or homes[used] & may
                    self.assertTrue(good, f"{module}: {path.name} includes {used}")
        self.assertGreater(includes, 2000)

    def sources(self):
        """The files below the folders of the source tree, relative to its root."""
        root = camaron_testing.ROOT
        files = [
            path.relative_to(root).as_posix()
            for folder in FOLDERS
            for path in (root / folder).rglob("*")
            if path.is_file() and "__pycache__" not in path.parts
        ]
        self.assertGreater(len(files), 1000)
        return files

    def test_folders_are_small(self):
        """A folder with more files needs sub-folders."""
        counts = Counter(path.rpartition("/")[0] for path in self.sources())
        self.assertGreater(len(counts), 50)
        for folder, count in counts.items():
            if not LARGE.match(folder + "/") and "/Testing" not in folder:
                self.assertLessEqual(count, MOST_FILES, folder)

    def test_commands(self):
        """A command missing from a list could not be run, or would not be in the help."""
        folder = camaron_testing.ROOT / "Scripts" / "camaron" / "commands"
        files = {path.stem for path in folder.glob("[!_]*.py")}
        self.assertEqual(set(cli.COMMANDS), files)
        launcher = (camaron_testing.ROOT / "camaron").read_text("utf-8")
        (called,) = re.findall(r"(?m)^  (.*)\) python_command ", launcher)
        self.assertEqual(set(called.split(" | ")), files)
        for name in files:
            self.assertRegex(launcher, f"(?m)^  {name} [A-Z[]", "usage")

    def test_public_ci(self):
        """Workflows with other commands than .ci/run, or without one of the ParaViews, would pass what it fails."""
        root = camaron_testing.ROOT
        workflow = (root / ".github" / "workflows" / "ci.yml").read_text("utf-8")
        self.assertIn("run: bash .ci/run\n", workflow)
        self.assertEqual(
            set(re.findall(r"debian: \[(.*)\]", workflow)), {"trixie, forky"}, "Debian 13 and 14"
        )
        launcher = (root / "camaron").read_text("utf-8")
        commands = re.findall(r"\./camaron (\w+)((?: -\S+)*)", workflow)
        commands += re.findall(
            r"\./camaron (\w+)((?: -\S+)*)", (root / ".ci/run").read_text("utf-8")
        )
        self.assertEqual({command for command, _ in commands}, {"build", "format", "test"})
        for command, options in commands:
            self.assertRegex(launcher, f"(?m)^  {command} \\[", "usage")
            for option in re.findall(r"-D(\w+)=", options):
                self.assertIn(f"option({option} ", (root / "CMakeLists.txt").read_text("utf-8"))

    def test_recipes(self):
        """A recipe with another version, or with options unknown to CMake, builds something else."""
        root = camaron_testing.ROOT
        project = (root / "CMakeLists.txt").read_text("utf-8")
        (version,) = re.findall(r"project\(Camaron VERSION (\S+)", project)
        (easyconfig,) = (root / "packaging" / "easybuild").iterdir()
        self.assertRegex(easyconfig.name, rf"^ParaView-Camaron-{re.escape(version)}-foss-\w+\.eb$")
        values = {"SHLIB_EXT": "so"}
        exec(compile(easyconfig.read_text("utf-8"), easyconfig, "exec"), values)
        self.assertEqual(values["version"], version)
        (recipe,) = (root / "packaging" / "spack").rglob("package.py")
        text = recipe.read_text("utf-8")
        compile(text, recipe, "exec")
        options = re.findall(r'define_from_variant\("(\w+)"', text)
        self.assertEqual(len(options), 2)
        for option in options:
            self.assertIn(f"option({option} ", project)
        self.assertEqual(recipe.parents[6], root, "the clone that the recipe takes for its sources")

    def check_format(self, tool, version, files, *options):
        """That the tool would change nothing. Other versions of it format differently."""
        if not shutil.which(tool):
            self.skipTest(f"there is no {tool}")
        found = subprocess.run(
            [tool, "--version"], capture_output=True, text=True, timeout=60
        ).stdout.split("\n")[0]
        if not re.search(rf"\b{version}\.", found):
            self.skipTest(f"{tool} is not version {version}, but: {found}")
        self.assertGreater(len(files), 50)
        done = subprocess.run(
            [tool, *options, *files],
            cwd=camaron_testing.ROOT,
            capture_output=True,
            text=True,
            timeout=280,
        )
        self.assertEqual(done.returncode, 0, f"run ./camaron format\n{done.stderr[:2000]}")

    def test_format_of_cxx(self):
        """C++ is formatted as in .clang-format."""
        files = [path for path in self.sources() if path.endswith((".h", ".cxx"))]
        self.check_format("clang-format", 19, files, "--dry-run", "--Werror")

    def test_format_of_python(self):
        """Python is as black formats it."""
        files = [path for path in self.sources() if path.endswith(".py")]
        self.check_format("black", 25, files, "--check", "--quiet")


if __name__ == "__main__":
    camaron_testing.main()
