#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# TestTrust.sh CLONE: whose programs ./camaron runs. Nothing is built: a copy of the launcher has a
# ParaView and a private Debian of a few scripts.
. "${BASH_SOURCE[0]%/*}/../expect.sh"

[[ $EUID == 0 ]] && stranger=(setpriv --reuid 65534 --regid 65534 --clear-groups) && "${stranger[@]}" true ||
  { echo "only root can create files of other users"; exit 77; }
source=$1
while IFS='=' read -r name _; do
  [[ $name != @(CAMARON|OMPI|PV|PYTHON|XDG)* ]] || unset "$name"
done < <(env)
unset DISPLAY ParaView_DIR CCACHE_DIR MESA_SHADER_CACHE_DIR
chmod 755 "$folder" && umask 022
export HOME=$folder/home TMPDIR=$folder/tmp

# Every program here leaves a line in the file ran.
program() {
  printf '#!/bin/sh\n%s\n[ ! -w %q ] || echo "$0" >>%q\n' "${2:-}" "$folder" "$folder/ran" >"$1" && chmod +x "$1"
}

clone=$folder/clone debian=$folder/home/.cache/camaron/root
fresh() {
  rm -rf "${folder:?}"/{clone,home,tmp,paraview,bin,link,open,ran}
  mkdir -p "$clone"/{CMake,build/lib/Camaron/Panel} "$debian"/{usr/bin,usr/lib/x86_64-linux-gnu,etc} "$folder"/{bin,tmp,paraview/{bin,sdk}}
  chmod 1777 "$folder/tmp"
  cp -r "$source/camaron" "$source/Scripts" "$clone"
  touch "$clone/CMakeLists.txt" "$clone/build/lib/Camaron"/{Camaron.so,Panel/CamaronPanel.so}
  program "$folder/bin/bwrap"
  program "$folder/paraview/bin/mpiexec"
  sed 's/#.*//; /^ *$/d' "$clone/Scripts/launcher/packages.txt" | LC_ALL=C sort -u >"$debian/camaron-packages"
  choose host
}

choose() {
  printf '%s\n' "$1" "$folder/paraview" "$folder/paraview/sdk" '' >"$clone/build/paraview"
  echo "$clone/build/lib/Camaron" >"$clone/build/built"
}

# is_run HOST_OR_ROOT WHAT [VARIABLE...]
is_run() {
  rm -f "$folder/ran" && choose "$1"
  message=$(env PATH="$folder/bin:$PATH" "${@:3}" "$clone/camaron" shell true 2>&1)
  expect "status of shell ($2: $message)" 0 $?
  [[ -s $folder/ran ]]
  expect "whether a program was run ($2)" 0 $?
}

# is_refused HOST_OR_ROOT PATH CAUSE [VARIABLE...]
is_refused() {
  rm -f "$folder/ran" && choose "$1"
  message=$(env PATH="$folder/bin:$PATH" "${@:4}" "$clone/camaron" shell true 2>&1)
  expect "status of shell for $2 ($3)" 2 $?
  [[ $message == "camaron: $2 is not used: $3"* && $message != *$'\n'* ]]
  expect "message for $2 ($3): $message" 0 $?
  [[ $2 == "$folder/paraview"* ]] || sed -i "\\|^$folder/paraview/bin/mpiexec$|d" "$folder/ran" 2>/dev/null
  [[ ! -s $folder/ran ]]
  expect "whether no program was run for $2 ($3)" 0 $?
}

fresh
is_run host "ParaView of root"
is_run root "private Debian of root"

# What belongs to somebody else, or to everybody.
while read -r choice path; do
  fresh && chown 65534 "$folder/$path"
  is_refused "$choice" "$folder/$path" "$folder/$path belongs to $(id -nu 65534), not to you"
  fresh && chmod o+w "$folder/$path"
  is_refused "$choice" "$folder/$path" "everybody may write to $folder/$path"
  fresh && chmod g+w "$folder/$path" && chgrp 65534 "$folder/$path"
  is_run "$choice" "of a group: $path"
done <<'END'
host clone/build
host clone/build/paraview
host clone/build/lib/Camaron
host clone/build/lib/Camaron/Camaron.so
host clone/build/lib/Camaron/Panel
host clone/build/lib/Camaron/Panel/CamaronPanel.so
host clone/Scripts/camaron
host clone/Scripts/launcher
host paraview/bin
host paraview/sdk
root home/.cache/camaron
root home/.cache/camaron/root
root home/.cache/camaron/root/usr/bin
root home/.cache/camaron/root/usr/lib/x86_64-linux-gnu
root home/.cache/camaron/root/camaron-packages
END
fresh && chmod 1777 "$HOME/.cache/camaron"
is_refused root "$HOME/.cache/camaron" "everybody may write"
fresh && chmod 666 "$clone/build/built"
is_refused host "$clone/build/built" "everybody may write"

# On the path to it: folders and links.
fresh && chown 65534 "$HOME"
is_refused root "$HOME/.cache/camaron" "$HOME belongs to"
is_run root "a trusted user's home" CAMARON_TRUST="daemon $(id -nu 65534)"
is_refused root "$HOME/.cache/camaron" "$HOME belongs to" CAMARON_TRUST=daemon
fresh && chmod 777 "$HOME"
is_refused root "$HOME/.cache/camaron" "everybody may write to $HOME"
fresh && chmod 1777 "$HOME"
is_run root "in a sticky folder"
fresh && ln -s home/.cache/../.cache/camaron "$folder/link"
is_run root "link of root" CAMARON_HOME="$folder/link"
(cd "$folder" && is_run root "relative path" CAMARON_HOME=link && exit "$failures")
failures=$?
chown -h 65534 "$folder/link"
is_refused root "$folder/link" "$folder/link belongs to" CAMARON_HOME="$folder/link"
ln -sfn link "$folder/link"
is_refused root "$folder/link" "it has too many links" CAMARON_HOME="$folder/link"
fresh && mkdir -p "$folder/open/clone" && mv "$clone" "$folder/open/" && chmod 777 "$folder/open" && ln -s open/clone "$clone"
is_refused host "$folder/open/clone/Scripts/launcher" "everybody may write to $folder/open"

# The owner of the clone is trusted, too; nobody else is by root or by a user.
fresh && chown -R 65534 "$clone" "$HOME" "$folder/paraview"
is_run host "ParaView of the clone's owner"
is_run root "private Debian of the clone's owner"
chown 1 "$debian"
is_refused root "$debian" "$debian belongs to $(id -nu 1), not to you, root or the owner of $clone"
chown 54321 "$debian"
is_refused root "$debian" "$debian belongs to 54321, not to you"
is_run root "of a user without a name" CAMARON_TRUST=54321
fresh && chown -R 65534 "$HOME/.cache/camaron"
choose root
message=$("${stranger[@]}" env PATH="$folder/bin:$PATH" "$clone/camaron" shell true 2>&1)
expect "status of shell for a user's own folder in one of root: $message" 0 $?
chown 1 "$debian/usr/bin"
message=$("${stranger[@]}" env PATH="$folder/bin:$PATH" "$clone/camaron" shell true 2>&1)
expect "status of shell for a user, with programs of another one" 2 $?

# In a container of the user, who is the only one with a number there.
inside=(setpriv --reuid 1 --regid 1 --clear-groups unshare --user --map-current-user)
if "${inside[@]}" true 2>/dev/null; then
  fresh && chown -R 1 "$clone" "$HOME" "$folder/paraview"
  message=$("${inside[@]}" "$clone/camaron" shell true 2>&1)
  expect "status of shell in a container: $message" 0 $?
  chown 2 "$clone/build"
  message=$("${inside[@]}" "$clone/camaron" shell true 2>&1)
  expect "status of shell in a container, with a build of another user" 2 $?
fi

# Caches of compiled code.
fresh && mkdir "$folder/open" && chown 65534 "$folder/open"
is_refused host "$folder/open" "$folder/open belongs to" MESA_SHADER_CACHE_DIR="$folder/open"
program "$folder/paraview/bin/cmake"
rm -r "$clone/build/built"
message=$(CCACHE_DIR=$folder/open "$clone/camaron" build 2>&1)
expect "status of build with a ccache of another user: $message" 2 $?
[[ ${message##*$'\n'} == "camaron: $folder/open is not used: $folder/open belongs to"* ]]
expect "message of build with that: $message" 0 $?

# A ParaView is trusted before CMake runs its files.
fresh && mkdir "$folder/open" && chown 65534 "$folder/open"
program "$folder/bin/cmake"
is_refused host "$folder/open" "$folder/open belongs to" ParaView_DIR="$folder/open"

# Without HOME.
fresh
unset HOME
for arguments in --version help "view --help"; do
  # shellcheck disable=SC2086
  "$clone/camaron" $arguments >/dev/null 2>&1
  expect "status of camaron $arguments without HOME" 0 $?
done
is_run host "without HOME"
expect "owner and rights of caches" "0 755" "$(stat -c '%u %a' "$TMPDIR/camaron-0")"
expect "owner and rights of the folder for sockets" "0 700" "$(stat -c '%u %a' "$TMPDIR/camaron-0/run")"
rm -f "$folder/ran" && choose root
message=$(PATH=$folder/bin:$PATH "$clone/camaron" shell true 2>&1)
expect "status of shell without HOME" 2 $?
[[ $message == "camaron: set CAMARON_HOME to a folder for a private Debian"* && ! -e $folder/ran ]]
expect "message of shell without HOME: $message" 0 $?
chown 65534 "$TMPDIR/camaron-0"
is_refused host "$TMPDIR/camaron-0" "$TMPDIR/camaron-0 belongs to"
rm -r "$TMPDIR/camaron-0"
ln -s "$folder/bin" "$TMPDIR/camaron-0" && chown -h 65534 "$TMPDIR/camaron-0"
is_refused host "$TMPDIR/camaron-0" "$TMPDIR/camaron-0 belongs to"
rm "$TMPDIR/camaron-0"
export HOME=$folder/home

# As with sudo: folders for caches and sockets are one's own.
fresh && mkdir "$folder/open" && chown -R 65534 "$folder/open" "$HOME"
for runtime in "$folder/open" "$TMPDIR" "$folder/missing"; do
  expect "folder for sockets instead of $runtime" "$TMPDIR/camaron-0/run" \
    "$(XDG_RUNTIME_DIR=$runtime "$clone/camaron" shell printenv XDG_RUNTIME_DIR 2>/dev/null)"
done
chown 0 "$folder/open"
expect "one's own folder for sockets" "$folder/open" \
  "$(XDG_RUNTIME_DIR=$folder/open "$clone/camaron" shell printenv XDG_RUNTIME_DIR 2>/dev/null)"
expect "files that root leaves in a user's home" "" "$(find "$HOME" -user 0)"

# Builds are not everybody's, whatever the umask is; files of the user are as it says. Python does
# not import from the current folder.
fresh && rm -r "$clone/build"/{lib,built}
program "$folder/paraview/bin/cmake" "mkdir -p $clone/build/lib/Camaron && touch $clone/build/lib/Camaron/Camaron.so"
program "$folder/paraview/bin/python3" "pwd >$folder/tmp/python"
(cd "$folder/tmp" && umask 0 && "$clone/camaron" build) >/dev/null 2>&1
expect "status of build with umask 0" 0 $?
expect "what everybody may write to" "" "$(find "$clone/build" -perm -o+w)"
expect "current folder of Python" / "$(cat "$folder/tmp/python")"
expect "umask" 0000 "$(umask 0 && "$clone/camaron" shell sh -c umask 2>/dev/null)"

# Displays of others, and cookies.
if type Xvfb xauth python3 >/dev/null 2>&1 && [[ -d /tmp/.X11-unix ]]; then
  fresh
  socket=/tmp/.X11-unix/X$((1000 + RANDOM))
  python3 -c 'import socket, sys; socket.socket(socket.AF_UNIX).bind(sys.argv[1])' "$socket"
  export DISPLAY=:${socket##*/X}
  expect "one's own display" "$DISPLAY" "$("$clone/camaron" shell printenv DISPLAY)"
  chown 65534 "$socket"
  [[ $("$clone/camaron" shell printenv DISPLAY) =~ ^:[0-9]{3}$ ]]
  expect "a display of another user is not used" 0 $?
  unset DISPLAY
  rm "$socket"
  # shellcheck disable=SC2016
  cookies=$("$clone/Scripts/launcher/with-display" sh -c 'stat -c "%u %a" "${XAUTHORITY%/*}"; echo "$XAUTHORITY"')
  expect "owner and rights of the folder of cookies" "0 700" "${cookies%%$'\n'*}"
  expect "the folder of cookies afterwards" "" "$(ls -A "$TMPDIR")"
fi

# Installed: the prefix is its owner's.
fresh
prefix=$folder/open share=$folder/open/share/camaron
mkdir -p "$share/Scripts" "$prefix"/{bin,python,plugins/Camaron/Panel}
cp "$source/camaron" "$share" && cp -r "$source/Scripts/launcher" "$share/Scripts" && cp -r "$source/Scripts/camaron" "$prefix/python"
sed 's|@CAMARON_DATA_DIR@|share/camaron|; s|@CAMARON_PYTHON_DIR@|python|; s|@CAMARON_PLUGINS_DIR@|plugins|' \
  "$source/Scripts/launcher/installed.sh.in" >"$share/Scripts/launcher/installed.sh"
touch "$prefix/plugins/Camaron"/{Camaron.so,Panel/CamaronPanel.so} && ln -s ../share/camaron/camaron "$prefix/bin/camaron"
program "$prefix/bin/mpiexec"
for path in bin python/camaron plugins/Camaron{,/Camaron.so,/Panel,/Panel/CamaronPanel.so}; do
  program "$prefix/bin/pvpython"
  message=$(PATH=/usr/bin:/bin "$prefix/bin/camaron" shell true 2>&1)
  expect "status of an installed camaron: $message" 0 $?
  if [[ $path == bin ]]; then
    ! PATH=/usr/bin:/bin type pvpython >/dev/null 2>&1 || continue # which is used instead
  fi
  chown 65534 "$prefix/$path"
  message=$(PATH=/usr/bin:/bin "$prefix/bin/camaron" shell true 2>&1)
  expect "status of an installed camaron with $path of another user" 2 $?
  [[ $message == "camaron: $prefix/$path is not used: $prefix/$path belongs to"* ]]
  expect "message for $path: $message" 0 $?
  chown 0 "$prefix/$path"
done
chown -R 65534 "$prefix"
message=$(PATH=/usr/bin:/bin "$prefix/bin/camaron" shell true 2>&1)
expect "status of another user's installation: $message" 0 $?

exit $((failures > 0))
