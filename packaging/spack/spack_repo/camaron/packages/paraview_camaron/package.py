# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
import os

from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class ParaviewCamaron(CMakePackage):
    """Camarón for ParaView, a plugin for the quality of polygonal and polyhedral meshes."""

    # The clone that contains this file.
    git = os.path.realpath(os.path.join(os.path.dirname(__file__), *[os.pardir] * 6))

    license("BSD-3-Clause")

    version("main", branch="main")

    variant("qt", default=False, description="Build the Mesh Inspector of ParaView's window")
    variant("python", default=True, description="Install the Python package and the command")
    variant("mpi", default=True, description="Use a ParaView with MPI")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.18:", type="build")
    depends_on("zlib-api")
    depends_on("paraview@5.13.3:6.1 +development_files+shared build_edition=canonical")
    for _part in ("qt", "python", "mpi"):
        depends_on(f"paraview+{_part}", when=f"+{_part}")
        depends_on(f"paraview~{_part}", when=f"~{_part}")
    # ParaView runs the plugin, and the command runs pvpython of PATH.
    depends_on("paraview", type="run")
    conflicts("+qt", when="^paraview@5", msg="Spack's ParaView 5 has Qt 5, the plugin needs Qt 6")

    def cmake_args(self):
        return [
            self.define_from_variant("CAMARON_WITH_QT", "qt"),
            self.define_from_variant("CAMARON_WITH_PYTHON", "python"),
        ]

    def setup_run_environment(self, env: EnvironmentModifications) -> None:
        for plugin in find(self.prefix, "Camaron.so"):
            env.prepend_path("PV_PLUGIN_PATH", os.path.dirname(plugin))
        for package in find(self.prefix, "cli.py"):
            env.prepend_path("PYTHONPATH", os.path.dirname(os.path.dirname(package)))
