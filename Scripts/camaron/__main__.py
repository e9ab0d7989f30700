# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the command: pvpython Scripts/camaron ARGUMENTS, or mpiexec -n N pvbatch the same."""

import ctypes
import os
import signal
import sys

if not __package__:  # run by path
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

if hasattr(signal, "SIGXFSZ"):  # writing above a limit is an error, as on a full disk
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
# pvpython redirects Python's output to VTK's output window, which is not a terminal.
sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
try:
    if "CAMARON_LIBRARIES" in os.environ:  # see Scripts/launcher/build.sh
        with open(os.environ["CAMARON_LIBRARIES"], encoding="utf-8") as file:
            for library in file.read().splitlines():
                try:
                    ctypes.CDLL(library)
                except OSError:  # the library was removed, or does not list all of its dependencies
                    pass
    from paraview import servermanager

    # paraview.simple requests the documentation of each of its functions, which takes a third of a
    # second.
    servermanager.ProxyNamespace.getDocumentation = lambda self, name: ""
    from camaron import cli

    status = cli.main(sys.argv[1:])
    sys.stdout.flush()
except SystemExit as end:  # argparse's
    status = end.code or 0
except BaseException as error:
    # Never exit with 1, which means that a mesh violates rules.
    reason = " ".join(str(error).split())
    print(f"camaron: {type(error).__name__}: {reason}" if reason else repr(error), file=sys.stderr)
    status = 2
if status:
    # When the program ends, HDF5 reports a file again that it could not write.
    sys.stderr.flush()
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
# No sys.exit here: it would keep pvbatch from finalizing MPI.
if "CAMARON_STATUS" in os.environ:
    with open(os.environ["CAMARON_STATUS"], "w", encoding="ascii") as file:
        file.write(str(status))
elif status:
    sys.exit(status)
