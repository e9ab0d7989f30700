# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Imports ParaView's server manager in about half of the usual time; run it before anything else imports ParaView.

With CAMARON_LIBRARIES in the environment, it loads the libraries in that list of the launcher one by one, see
Scripts/launcher/build.sh.
"""

import ctypes
import os


def load_libraries(path: str) -> None:
    """Loads the libraries in a list."""
    with open(path, encoding="utf-8") as file:
        for library in file.read().splitlines():
            try:
                ctypes.CDLL(library)
            except OSError:  # the library was removed, or does not list all of its dependencies
                pass


if "CAMARON_LIBRARIES" in os.environ:
    load_libraries(os.environ["CAMARON_LIBRARIES"])
from paraview import servermanager

# paraview.simple requests the documentation of each of its functions, which takes most of a second.
servermanager.ProxyNamespace.getDocumentation = lambda self, name: ""
