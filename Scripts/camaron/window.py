# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the Mesh Inspector runs in the Python of ParaView's window."""

from __future__ import annotations

import sys

from paraview import servermanager, simple

from .common import console
from .inspection import inspect


def write_report(
    mesh: int,
    port: int,
    criteria: list[str],
    ranges: list[str],
    rules: list[str],
    tolerate: str,
    folder: str,
) -> None:
    """Writes the report about an output of the proxy with a global id; see `inspect`. The reason of
    a failure goes to the standard error, which the window reads."""
    proxy = servermanager._getPyProxy(servermanager.ActiveConnection.Session.GetRemoteObject(mesh))
    active = simple.GetActiveSource()
    try:
        inspect(
            proxy[port],
            folder,
            criteria=criteria or None,
            ranges=ranges or None,
            rules=rules or None,
            tolerate=tolerate or None,
            with_mesh=False,
        )
    except (RuntimeError, ValueError, OSError, MemoryError) as error:
        sys.stderr.write(console.reason(error, folder))
    finally:
        simple.SetActiveSource(active)
