#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Works around a packaging bug of Debian's ParaView, 5.13 to 6.1: its CMake targets refer to Python
# modules as X.so, but the package contains X.cpython-*.so. Creates the missing links. (Python still
# loads X.cpython-*.so, which it searches first.)
set -eu
for package in vtkmodules paraview; do
  find -L "/usr/lib/python3/dist-packages/$package" -name '*.cpython-*.so' 2>/dev/null
done | while IFS= read -r module; do
  link=${module%%.cpython-*}.so
  [ -e "$link" ] || ln -s "${module##*/}" "$link"
done
