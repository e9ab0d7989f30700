#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# TestGpuBundle.sh SOURCE: the bundle runs in a root with a few ordinary programs and nothing else, without network, and
# a damaged one does not. Exits with 77 where the programs that this takes are missing or not allowed.
. "${BASH_SOURCE[0]%/*}/../../expect.sh"

source=$1
namespace=(unshare --mount --net)
((EUID == 0)) || namespace=(unshare --map-root-user --mount --net)
type strace ldd >/dev/null 2>&1 && "${namespace[@]}" true 2>/dev/null ||
  { echo "no strace, or no namespaces"; exit 77; }

bare=$folder/bare
programs=(cat chroot cp dirname grep id ln mkdir mktemp mv nproc rm sed sha256sum sleep sort tail tar tr gzip uname)
for program in "${programs[@]}"; do
  program=$(type -P "$program")
  for file in "$program" $(ldd "$program" | grep -o '/[^ ]*'); do
    mkdir -p "$bare${file%/*}" && cp -L "$file" "$bare$file"
  done
done
mkdir -p "$bare"/{bin,dev,proc,tmp,bundle}
cp -L /bin/sh "$bare/bin/sh"

# bare COMMAND...: in the bare root.
bare() {
  "${namespace[@]}" python3 -c '
import ctypes, os, sys
root, *command = sys.argv[1:]
BIND_ALL = 0x5000
for name in "dev", "proc":
    if ctypes.CDLL(None).mount(f"/{name}".encode(), f"{root}/{name}".encode(), None, BIND_ALL, None):
        sys.exit(f"cannot mount /{name}")
os.chroot(root)
os.chdir("/")
os.execve(command[0], command, {"PATH": "/usr/bin:/bin:/usr/sbin:/sbin", "HOME": "/"})' "$bare" "$@"
}

"$source/camaron" bench --bundle "$bare/bundle" >"$folder/log" 2>&1
expect "status of the bundle's maker" 0 $?
((failures == 0)) || { tail -n 20 "$folder/log"; exit 1; }
expect "parts above 60 MiB" "" "$(find "$bare/bundle" -size +60M)"
bare /bin/sh -c 'type python3 Xvfb' >/dev/null 2>&1
expect "status of a search for Python and Xvfb" 127 $?

part=$bare/bundle/part-00
cp "$part" "$folder/part" && printf x | dd of="$part" bs=1 seek=1000 conv=notrunc status=none
message=$(bare /bundle/unpack-and-run --quick /results 2>&1)
expect "status of a damaged bundle" 2 $?
expect "its message" "camaron: damaged or missing: part-00; copy the bundle again" "$message"
cp "$folder/part" "$part"

bare /bundle/unpack-and-run --quick /results >"$folder/log" 2>&1
expect "status of the bundle" 0 $?
page=$bare/results/graphics-card.md
[[ -s $bare/results/graphics-card.json ]] && grep -q 'pictures by llvmpipe' "$page"
expect "status of a look at its page" 0 $?
expect "what was not measured" "" "$(grep 'not measured' "$page")"
expect "tests that passed" 2 "$(grep -o '`[^`]*` passed' "$page" | wc -l)"
for peer in 'Surface With Edges' Surface Clip Contour; do
  grep -q "| $peer |" "$page"
  expect "status of a search for $peer" 0 $?
done
expect "what it leaves behind" "" "$(ls "$bare/tmp")"
((failures == 0)) || tail -n 20 "$folder/log" "$bare"/results/*.log
exit $((failures > 0))
