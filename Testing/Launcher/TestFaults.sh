#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# TestFaults.sh CLONE: whatever stops a command of ./camaron, it says so on one line, with status 2 or that of a signal.
. "${BASH_SOURCE[0]%/*}/../expect.sh"

# Else ./camaron would begin to build.
[[ -n ${CAMARON_HOME:-} && -r $1/build${CAMARON_DEBIAN:+/$CAMARON_DEBIAN}/built ]] || { echo "not run by ./camaron test"; exit 77; }

camaron=$1/camaron mesh=$1/Examples/voronoi-ball.visf
export TMPDIR=$folder/temporary
mkdir "$TMPDIR" "$folder/work" && cd "$folder/work" || exit 1
echo 'Volume < 0' >my.rules

# fails FAULT STATUS WORDS COMMAND: what a command does after the words of bash in FAULT. With no WORDS, nothing is said.
fails() {
  local wanted=1 said
  # shellcheck disable=SC2086
  (eval "$1" && exec timeout 100 "$camaron" ${4//MESH/$mesh}) 2>&1 >"$folder/out" | cat >"$folder/err"
  expect "status of $4 after $1" "$2" "${PIPESTATUS[0]}"
  said=$(grep -v '^shell-init: ' "$folder/err") # bash's own, in a folder that is gone
  [[ -n $3 ]] || wanted=0
  expect "lines of $4 after $1: $said" "$wanted" "$(grep -c . <<<"$said")"
  [[ $said == *"$3"* && ($wanted == 0 || $said == "camaron: "*) ]]
  expect "message of $4 after $1: $said" 0 $?
  expect "temporary files of $4 after $1" "" "$(ls -A "$folder/temporary")"
}

while IFS='|' read -r fault status words command; do
  fails "$fault" "$status" "$words" "$command"
done <<'END'
exec >&-|2|standard output: Bad file descriptor|criteria Volume
exec >&-|2|standard output: Bad file descriptor|check MESH --rules my.rules --ranks 2
exec >&-|0||convert MESH silent.vtu
exec >/dev/full|2|standard output: No space left on device|convert --help
exec >/dev/full|2|standard output: No space left on device|check MESH --rules my.rules --ranks 2
exec >/dev/full|2|standard output: cannot write to it|--help
exec >/dev/full 2>/dev/full|2||criteria Volume
exec >&- 2>&- <&-|2||criteria Volume
exec 2>&-|1||check MESH --rules my.rules
exec <&-|1||check MESH --rules my.rules
mkdir gone && cd gone && rmdir ../gone|2|gone: the current folder does not exist anymore|criteria Volume
mkdir $'other\xff' && cd $'other\xff'|0||convert MESH x.vtu
cd $'other\xff'|0||inspect MESH --no-pictures
TMPDIR=$PWD/missing|2|missing: cannot write to this folder: No such file or directory|criteria Volume
TMPDIR=$PWD/my.rules|2|my.rules: cannot write to this folder: Not a directory|criteria Volume
mkdir open && chmod o+w open && TMPDIR=$PWD/open|2|everybody may write to|criteria Volume
mkdir "a  b" && TMPDIR="a  b"|1||check MESH --rules my.rules --ranks 2
ulimit -f 0|2|cannot write to this folder: File too large|criteria Volume
ulimit -n 20|2|only 20 files may be open at a time|criteria Volume
ulimit -v 100000|2|out of memory|criteria Volume
ulimit -v 300000|2|out of memory|criteria Volume
HOME=$PWD/missing|1||check MESH --rules my.rules --ranks 2
true|0||convert MESH with-mpi.cgns
END
expect "converted" "x.vtu" "$(ls $'other\xff' | grep x.vtu)"
expect "home" "" "$(ls -A missing 2>/dev/null)"

# What libraries print is not shown, but says why.
mkdir "$folder/ends"
while IFS='|' read -r end status words; do
  for program in python3 pvpython pvbatch; do
    printf '#!/bin/bash\nfor i in {1..60}; do echo "$i: somewhere()" >&2; done\n%s\n' "$end" >"$folder/ends/$program"
    chmod +x "$folder/ends/$program"
  done
  for options in "" " --ranks 2"; do
    fails "PATH=$folder/ends:\$PATH" "$status" "$words" "check MESH --rules my.rules$options"
  done
done <<'END'
kill -ABRT $$|2|ParaView crashed (signal 6)
echo "what(): std::bad_alloc" >&2; kill -ABRT $$|2|out of memory: check
echo "pvbatch: libx.so: failed to map segment from shared object" >&2; exit 127|2|out of memory: check
echo "write: No space left on device" >&2; exit 1|2|No space left on device: check
echo "socket: Too many open files" >&2; exit 213|2|Too many open files: check
kill -INT $$|130|interrupted
kill -TERM $$|143|ended by signal 15 (SIGTERM): check
kill -HUP $$|129|ended by signal 1 (SIGHUP): check
kill -XCPU $$|2|SIGXCPU
END

exit $((failures > 0))
