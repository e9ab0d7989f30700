#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# TestLauncher.sh CLONE: what ./camaron passes on, and what it refuses.
. "${BASH_SOURCE[0]%/*}/../expect.sh"

# Else ./camaron would begin to build.
[[ -n ${CAMARON_HOME:-} && -r $1/build${CAMARON_DEBIAN:+/$CAMARON_DEBIAN}/built ]] || { echo "not run by ./camaron test"; exit 77; }

# As one finds it in PATH, called from elsewhere.
ln -s "$1/camaron" "$folder/camaron"
mkdir "$folder/my meshes" && cd "$folder/my meshes" || exit 1
camaron=$folder/camaron

[[ $("$camaron" --version) =~ ^camaron\ [0-9]+\.[0-9]+\.[0-9]+\+[0-9a-f]+\ for\ ParaView\ [0-9.]+,\ built\ by\ [^/]*$ ]]
expect "--version matches" 0 $?
for arguments in "" "no-such-command" "build --no-such-option" "inspect a --ranks many" "fuzz" "fuzz a/b" \
  "fuzz Visf soon" "fuzz --all soon"; do
  # shellcheck disable=SC2086
  "$camaron" $arguments >/dev/null 2>&1 </dev/null
  expect "status of camaron $arguments" 2 $?
done

expect "current folder" "$PWD" "$("$camaron" shell pwd)"
expect "words" "a b|c*" "$("$camaron" shell printf '%s|%s' 'a b' 'c*')"
"$camaron" shell bash -c 'exit 7'
expect "status" 7 $?
# shellcheck disable=SC2016
plugin=$("$camaron" shell bash -c 'echo "${PV_PLUGIN_PATH%%:*}"')
[[ -e $plugin/Camaron.so ]]
expect "the plugin lies in PV_PLUGIN_PATH" 0 $?

# One status on one process and on ranks, and mpiexec has nothing to add.
for ranks in "" "--ranks 2"; do
  # shellcheck disable=SC2086
  message=$(timeout 100 "$camaron" inspect missing.visf $ranks 2>&1)
  expect "status of inspect $ranks on a missing mesh" 2 $?
  expect "message of inspect $ranks" "camaron: missing.visf: there is no such file" "$message"
  echo 'Volume < 0' >my.rules
  # shellcheck disable=SC2086
  timeout 100 "$camaron" check "$1/Examples/voronoi-ball.visf" --rules my.rules $ranks >/dev/null 2>&1
  expect "status of check $ranks on a mesh that fails" 1 $?
  # shellcheck disable=SC2086
  timeout 100 "$camaron" check "$1/Examples/voronoi-ball.visf" --junit=my.rules --rules - $ranks <my.rules >/dev/null 2>&1
  expect "status of check $ranks whose output is its standard input" 2 $?
  expect "rules of standard input after that" 'Volume < 0' "$(<my.rules)"
done

# Names that look like options.
message=$(timeout 100 "$camaron" convert -- -missing.off --ranks.visf 2>&1)
expect "status of convert on a missing mesh" 2 $?
expect "message of convert" "camaron: -missing.off: there is no such file" "$message"
touch -- -empty.off
message=$(timeout 100 "$camaron" convert -- -empty.off x.visf 2>&1)
expect "message of convert on an empty file" "camaron: -empty.off: the file is empty" "$message"

# 1 says that a mesh fails; whatever ends ParaView before is an error that says so, on ranks as well.
mesh=$1/Examples/voronoi-ball.visf
mkdir "$folder/ends"
while read -r end words; do
  for program in python3 pvpython pvbatch; do
    printf '#!/bin/bash\n%s\n' "${end/_/ }" >"$folder/ends/$program"
    chmod +x "$folder/ends/$program"
  done
  for command in "check MESH --rules my.rules" "check MESH --rules my.rules --ranks 2" "inspect MESH"; do
    # shellcheck disable=SC2086
    message=$(PATH=$folder/ends:$PATH timeout 100 "$camaron" ${command//MESH/$mesh} 2>&1)
    expect "status of $command after $end" 2 $?
    [[ $message == "camaron: "*"$words"* && $message != *$'\n'* ]]
    expect "one line about $words of $command: $message" 0 $?
  done
done <<'END'
exit_1 ended early (status 1)
kill_-KILL$IFS$$ out of memory
kill_-SEGV$IFS$$ crashed (signal 11)
END

# Whoever ends the command alone, as batch systems do, ends all of it.
for program in python3 pvpython pvbatch; do
  # shellcheck disable=SC2016
  printf '#!/bin/bash\necho $$ >>"%s/started"\nexec sleep 100\n' "$folder" >"$folder/ends/$program"
done
for options in "" "--ranks 2"; do
  mkdir "$folder/terminated"
  # shellcheck disable=SC2086
  TMPDIR=$folder/terminated PATH=$folder/ends:$PATH "$camaron" check "$mesh" --preset General $options >/dev/null 2>&1 &
  for ((i = 0; i < 300; ++i)); do [[ ! -s $folder/started ]] || break; sleep 0.1; done
  sleep 0.5
  kill -TERM $!
  wait $!
  expect "status of check $options after SIGTERM" 143 $?
  for ((i = 0; i < 100; ++i)); do
    running=$(while read -r id; do ! kill -0 "$id" 2>/dev/null || echo "$id"; done <"$folder/started")
    [[ -n $running || -n $(ls -A "$folder/terminated") ]] || break
    sleep 0.1
  done
  expect "processes of check $options after SIGTERM" "" "$running"
  expect "files of check $options after SIGTERM" "" "$(ls -A "$folder/terminated")"
  rm -r "$folder/terminated" "$folder/started"
done
for command in "inspect MESH" "check MESH --rules my.rules" "compare MESH MESH" "convert MESH x.vtu" \
  "select MESH --by All"; do
  # shellcheck disable=SC2086
  message=$("$camaron" ${command//MESH/$'bad\xff.visf'} 2>&1)
  expect "status of camaron $command with other bytes than UTF-8" 2 $?
  expect "message of that" "camaron: expected an argument in UTF-8, found \$'bad\\377.visf'" "$message"
  (ulimit -v 300000; exec timeout 100 "$camaron" ${command//MESH/$mesh} >"$folder/small" 2>&1)
  expect "status of camaron $command with little memory" 2 $?
done

# Of a shared installation: somebody else's, for a user who has no folders.
if [[ $EUID == 0 ]] && stranger=(setpriv --reuid 65534 --regid 65534 --clear-groups) &&
  "${stranger[@]}" test -r "$mesh" 2>/dev/null; then
  mkdir "$folder/shared" "$folder/own" && chmod 755 "$folder" && chown 65534 "$folder/own"
  (
    cd "$folder/own" || exit 1
    unset HOME XDG_RUNTIME_DIR XDG_CACHE_HOME MESA_SHADER_CACHE_DIR CCACHE_DIR
    export TMPDIR=$folder/own CAMARON_HOME=$folder/shared
    echo 'Volume > 0' >my.rules
    timeout 100 "${stranger[@]}" "$1/camaron" check "$mesh" --rules my.rules
  ) >"$folder/stranger" 2>&1
  expect "status of check for a stranger: $(tail -n 3 "$folder/stranger")" 0 $?
  expect "files in the shared folder" "" "$(ls -A "$folder/shared")"
fi

# What new format makes is complete, also its bytes: 12 points, 11 faces and 2 cells after a line.
clone=$folder/clone
mkdir -p "$clone/Readers/Base" "$clone/Scripts"
cp "$1/camaron" "$clone" && cp -r "$1/Scripts/launcher" "$clone/Scripts"
cp -r "$1/Readers/Base/Skeleton" "$clone/Readers/Base" && cp "$1/Readers/Formats.cmake" "$clone/Readers"
"$clone/camaron" new format Foo >/dev/null
expect "status of new format" 0 $?
"$clone/camaron" new format Bar --faces >/dev/null
expect "status of new format --faces" 0 $?
expect "files with places to fill in" "" "$(grep -rlaE '@[A-Z]+@' "$clone/Readers/Foo" "$clone/Readers/Bar")"
expect "names with places to fill in" "" "$(find "$clone/Readers/Foo" "$clone/Readers/Bar" -name '*@*' -o -name '*.in')"
expect "formats" "Foo Bar" "$(grep -oE 'NAME +(Foo|Bar)$' "$clone/Readers/Formats.cmake" | awk '{ print $2 }' | xargs)"
expect "bytes of a seed" $((19 + 12 * 24 + (11 * 5 + 2 * 8) * 4)) "$(stat -c %s "$clone/Readers/Bar/Testing/Seeds/little.bar")"
for arguments in "Foo" "foo" "Baz --edges" "Baz --faces more"; do
  # shellcheck disable=SC2086
  "$clone/camaron" new format $arguments >/dev/null 2>&1
  expect "status of new format $arguments" 2 $?
done

# Displays of their own, gone afterwards.
if type Xvfb xauth >/dev/null 2>&1; then
  # shellcheck disable=SC2016
  show='xauth list "$DISPLAY" | wc -l; echo "$XAUTHORITY $DISPLAY"; sleep 1'
  for i in 1 2 3; do
    "$1/Scripts/launcher/with-display" bash -c "$show" >"$folder/display$i" &
  done
  wait
  expect "displays" 3 "$(grep -h -o ':[0-9]*$' "$folder"/display? | sort -u | wc -l)"
  expect "cookies" "1 1 1" "$(head -q -n 1 "$folder"/display? | xargs)"
  while read -r authority _; do
    [[ ! -e $authority ]]
    expect "$authority is gone" 0 $?
  done < <(tail -q -n 1 "$folder"/display?)
fi

exit $((failures > 0))
