# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands, one per file; the table in cli.py lists them.

Each has two functions: `add_parser(commands)` describes its arguments, and `run(options)` runs the
command and returns its exit status. Modules that only one command needs are imported in its `run`.
"""

#: Exit status when a mesh cannot be read or written, or an argument is invalid.
ERROR = 2
