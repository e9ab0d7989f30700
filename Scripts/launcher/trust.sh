# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154  # variables that ./camaron and its other parts set
#
# Whose programs and libraries are run: those in folders that belong to the user, to root, to the
# owner of this clone or to a user in CAMARON_TRUST, and that not everybody may write to. The same
# is required of each link and folder on the path to them; those may be sticky instead, as /tmp is.
# Members of a folder's group may write.

# trusted PATH...: ends with status 2 unless all of them are; what does not exist yet is.
trusted() {
  ! untrusted "$@" || die "$reason"
}

# untrusted PATH...: whether one of them is; sets `reason`.
untrusted() {
  local path rest at step links=0 i owner mode
  local -a steps=("$top" /) found
  local -A named=([/]='') # folder or link: the path that it leads to
  local -A ends=()
  for path in "$@"; do
    at='' rest=$path/
    [[ $path == /* ]] || rest=$PWD/$rest
    while [[ -n $rest ]]; do
      step=${rest%%/*} rest=${rest#*/}
      case $step in
        '' | .) continue ;;
        ..) at=${at%/*}; continue ;;
      esac
      at+=/$step
      [[ -e $at || -L $at ]] || continue 2
      if [[ -z ${named[$at]+known} ]]; then
        named[$at]=$path
        steps+=("$at")
      fi
      if [[ -L $at ]]; then
        ((++links <= 40)) || { reason="$path is not used: it has too many links"; return; }
        rest=$(readlink "$at")/$rest
        at=${at%/*}
        [[ $rest != /* ]] || at=''
      fi
    done
    ends[${at:-/}]=$path
  done
  mapfile -t found < <(stat -c '%u %f' -- "${steps[@]}" 2>/dev/null)
  ((${#found[@]} == ${#steps[@]})) || { reason="$1 is not used: a folder on the path is being removed"; return; }
  for i in "${!steps[@]}"; do
    ((i)) || continue # the clone itself is listed for its owner only
    at=${steps[i]} path=${ends[${steps[i]}]:-${named[${steps[i]}]:-$1}}
    owner=${found[i]% *} mode=$((16#${found[i]#* }))
    if ! { [[ $owner == 0 || $owner == "$EUID" || $owner == "${found[0]% *}" ]] || in_trust "$owner" "$at"; }; then
      owner=$(id -nu -- "$owner" 2>/dev/null) || owner=${found[i]% *}
      reason="$path is not used: $at belongs to $owner, not to you, root or the owner of $top"
      reason+=" (CAMARON_TRUST=$owner trusts that user)"
      return
    fi
    case $((mode & 8#170002)) in $((8#120002)) | $((8#140002))) continue ;; esac # links and sockets
    if ((mode & 2)) && [[ -n ${ends[$at]:-} || $((mode & 8#1000)) == 0 ]]; then
      reason="$path is not used: everybody may write to $at (chmod o-w prevents it)"
      return
    fi
  done
  return 1
}

# in_trust OWNER PATH: whether CAMARON_TRUST has the user, or nobody knows who it is.
in_trust() {
  local name first count nobody
  for name in ${CAMARON_TRUST:-}; do
    [[ $name != "$1" && $(id -u -- "$name" 2>/dev/null) != "$1" ]] || return 0
  done
  # In a container that a user started, /home belongs to nobody: to users outside, such as root.
  [[ -z ${ends[$2]:-} ]] && read -r nobody 2>/dev/null </proc/sys/kernel/overflowuid && [[ $1 == "$nobody" ]] || return
  while read -r first _ count; do
    ((nobody < first || nobody >= first + count)) || return
  done 2>/dev/null </proc/self/uid_map
}
