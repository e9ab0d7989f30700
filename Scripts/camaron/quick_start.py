# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Imports ParaView's server manager in about half of the usual time; run it before anything else imports ParaView.

With CAMARON_LIBRARIES in the environment, it loads the libraries in that list of the launcher one by one, see
Scripts/launcher/build.sh.
"""

import ctypes
import os
import sys


def load_libraries(path: str) -> None:
    """Loads the libraries in a list. Functions are looked up when they are called first: most never are."""
    load = ctypes.CDLL(None).dlopen
    load.argtypes, load.restype = [ctypes.c_char_p, ctypes.c_int], ctypes.c_void_p
    with open(path, "rb") as file:
        for library in file.read().splitlines():
            load(library, os.RTLD_LAZY)  # fails silently if it was removed or lacks a dependency


if "CAMARON_LIBRARIES" in os.environ:
    load_libraries(os.environ["CAMARON_LIBRARIES"])
    flags = sys.getdlopenflags()
    sys.setdlopenflags(os.RTLD_LAZY)
    import paraview.servermanager

    # Else a module of others that lacks a function would end the program when it is called.
    sys.setdlopenflags(flags)
from paraview import servermanager

# paraview.simple requests the documentation of each of its functions, which takes most of a second.
servermanager.ProxyNamespace.getDocumentation = lambda self, name: ""
