#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Mends a packaging fault of Debian's ParaView, 5.13 to 6.1: its CMake targets name the Python modules
# X.so, the package has X.cpython-*.so. Puts a link beside each; does nothing where they are there.
# (Python goes on taking X.cpython-*.so, which it looks for first.)
set -eu
for package in vtkmodules paraview; do
  find -L "/usr/lib/python3/dist-packages/$package" -name '*.cpython-*.so' 2>/dev/null
done | while IFS= read -r module; do
  link=${module%%.cpython-*}.so
  [ -e "$link" ] || ln -s "${module##*/}" "$link"
done
