# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154  # what ./camaron and its other parts set
#
# What every part of the launcher says, and how: messages, progress, logs, locks.

say() {
  printf 'camaron: %s\n' "$*" >&2
}

# 2, as for every error that is not a verdict on a mesh.
die() {
  say "$@"
  exit 2
}

# logged LABEL LOG COMMAND...: runs a program with all it prints in LOG and only its progress on the
# terminal; shows the error when it fails. The program ends with the launcher, however that ends.
logged() {
  local label=$1 log=$2
  shift 2
  mkdir -p "${log%/*}"
  setpriv --pdeathsig TERM "$@" </dev/null 2>&1 | progress "$label" >"$log" && return
  say "$label: failed, see $log:"
  # The first error, which much may follow.
  { grep -E -A 30 -m 1 '^(FAILED:|CMake Error|E: )' "$log" || tail -n 25 "$log"; } >&2
  return 1
}

# progress LABEL: copies its input; shows how far apt, dpkg, ninja or make are.
progress() {
  local label=$1 line state total=0 fetched=0 unpacked=0 done=0 next=$((SECONDS + 2))
  [[ ! -t 2 ]] || show ...
  while IFS= read -r line; do
    printf '%s\n' "$line"
    if [[ $line =~ ([0-9]+)\ newly\ installed ]]; then
      total=${BASH_REMATCH[1]} fetched=0 unpacked=0 done=0
      continue
    elif [[ $line == Get:* && $total != 0 ]]; then
      state="fetched $((++fetched)) of $total packages"
    elif [[ $line == 'Unpacking '* ]]; then
      state="unpacked $((++unpacked)) of $total packages"
    elif [[ $line == 'Setting up '* ]]; then
      state="set up $((++done)) of $total packages"
    elif [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
      state="${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
    elif [[ $line =~ ^\[\ *([0-9]+%)\] ]]; then
      state=${BASH_REMATCH[1]}
    else
      continue
    fi
    show "$state"
  done
  hide
}

# test_progress: shows how far ctest is; copies of its output what is not about a test that begins or passes.
test_progress() {
  local label=testing line failed=0 next=$((SECONDS + 2))
  while IFS= read -r line; do
    if [[ $line =~ ^\ *([0-9]+)/([0-9]+)\ Test\ +\# ]]; then
      local state="${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
      if [[ ! $line =~ \ Passed\ |\*Skipped\  ]]; then
        hide
        printf '%s\n' "$line"
        failed=$((failed + 1))
      fi
      show "$state$( ((failed == 0)) || echo ", $failed failed")"
    elif [[ ! $line =~ ^\ +Start\ +[0-9]+: ]]; then
      hide
      printf '%s\n' "$line"
    fi
  done
  hide
}

# show STATE: of what `label` names; on a terminal in one line that changes, elsewhere in a line every ten
# seconds, from the second `next` on.
show() {
  if [[ -t 2 ]]; then
    printf '\r\033[Kcamaron: %s: %s' "$label" "$1" >&2
  elif ((SECONDS >= next)); then
    say "$label: $1"
    next=$((SECONDS + 10))
  fi
}

hide() {
  [[ ! -t 2 ]] || printf '\r\033[K' >&2
}

# lock FILE ... unlock: one camaron at a time. Programs started meanwhile hold the lock too, so it is
# free only when the last one an interrupted call left behind is gone.
lock() {
  mkdir -p "${1%/*}" 2>/dev/null && : 2>/dev/null >>"$1" || die "$1 has to be written for that, and may not be"
  exec 9>"$1"
  flock -n 9 || { say "waiting for another camaron, which holds $1"; flock 9; }
}

unlock() {
  exec 9>&-
}
