# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the command: pvpython Scripts/camaron ARGUMENTS, or mpiexec -n N pvbatch the same."""

import ctypes
import os
import sys

if not __package__:  # run by path
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

# pvpython sends what Python prints through VTK's output window, which is no terminal.
sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
try:
    if "CAMARON_LIBRARIES" in os.environ:  # see Scripts/launcher/build.sh
        with open(os.environ["CAMARON_LIBRARIES"], encoding="utf-8") as file:
            for library in file.read().splitlines():
                try:
                    ctypes.CDLL(library)
                except OSError:  # of one that is gone, or does not name all that it needs
                    pass
    from paraview import servermanager

    # paraview.simple looks it up for each of its functions, which takes a third of a second.
    servermanager.ProxyNamespace.getDocumentation = lambda self, name: ""
    from camaron import cli

    status = cli.main(sys.argv[1:])
    sys.stdout.flush()
except SystemExit as end:  # argparse's
    status = end.code or 0
except BaseException as error:
    # Whatever it is: 1 is for meshes that fail.
    reason = " ".join(str(error).split())
    print(f"camaron: {type(error).__name__}: {reason}" if reason else repr(error), file=sys.stderr)
    status = 2
if status:
    # HDF5 complains once more, when the program ends, of a file that it could not write.
    sys.stderr.flush()
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
# Without sys.exit, which would keep pvbatch from leaving MPI in order.
if "CAMARON_STATUS" in os.environ:
    with open(os.environ["CAMARON_STATUS"], "w", encoding="ascii") as file:
        file.write(str(status))
elif status:
    sys.exit(status)
