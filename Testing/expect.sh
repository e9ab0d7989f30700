# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by tests in bash: a temporary folder, $folder, and `expect`, which counts in $failures.
set -uo pipefail
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
failures=0

# expect WHAT WANTED GOT
expect() {
  [[ $2 == "$3" ]] && return
  echo "$1: expected '$2', got '$3'"
  failures=$((failures + 1))
}
