# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154  # variables that ./camaron and its other parts set
#
# Messages, progress, logs and locks for all parts of the launcher.

# say MESSAGE...: prints a line for the user, in place of a line that shows progress. Where the user is not to be
# reached, nothing else is.
say() {
  local to=${CAMARON_ERRORS:-2} start=''
  [[ ! -t $to ]] || start=$'\r\033[K'
  printf '%scamaron: %s\n' "$start" "$*" >&"$to" 2>/dev/null || true
}

interrupted() {
  say interrupted
  exit 130
}

# die MESSAGE...: ends with status 2. Status 1 is reserved for meshes that fail a check.
die() {
  say "$@"
  exit 2
}

# logged LABEL LOG COMMAND...: runs a program; its output goes to LOG, its progress to the terminal.
# If it fails, the error is shown. The program ends when the launcher does, even if that is killed.
logged() {
  local label=$1 log=$2
  shift 2
  mkdir -p "${log%/*}"
  setpriv --pdeathsig TERM "$@" </dev/null 2>&1 | progress "$label" >"$log" && return
  say "$label: failed; log file $log:"
  # Show the first error; later ones are often consequences.
  { grep -E -A 30 -m 1 '^(FAILED:|CMake Error|E: )' "$log" || tail -n 25 "$log"; } >&2
  return 1
}

# progress LABEL: copies its input to the output and shows the progress of apt, dpkg, ninja or make, and for ninja how
# long it will take.
progress() {
  local label=$1 line state total=0 fetched=0 unpacked=0 done=0 next=$((SECONDS + 2)) began=$SECONDS step steps
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
      step=${BASH_REMATCH[1]} steps=${BASH_REMATCH[2]}
      state="$step of $steps"
      ((step == 0 || SECONDS - began < 30)) ||
        state+=", about $(((SECONDS - began) * (steps - step) / step / 60 + 1)) min left"
    elif [[ $line =~ ^\[\ *([0-9]+%)\] ]]; then
      state=${BASH_REMATCH[1]}
    else
      continue
    fi
    show "$state"
  done
  hide
}

# test_progress: shows the progress of ctest; copies its output without the lines of tests that
# start or pass.
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

# show STATE: shows the state of the job `label`: on a terminal in a single line that is
# overwritten, elsewhere in a new line every ten seconds, the first one at the second `next`.
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

# lock FILE ... unlock: only one camaron at a time runs the code between. Child processes inherit
# the lock, so it stays taken until the last process of an interrupted call has ended.
lock() {
  mkdir -p "${1%/*}" 2>/dev/null && : 2>/dev/null >>"$1" || die "$1: cannot write this file"
  exec 9>"$1"
  flock -n 9 || { say "waiting for another camaron, which has locked $1"; flock 9; }
}

unlock() {
  exec 9>&-
}
