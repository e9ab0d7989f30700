# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all commands share: arguments, the ParaView session, files, tables, text and pages."""
