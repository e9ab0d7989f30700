# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154  # variables that ./camaron and its other parts set
#
# Finds ParaView, or installs it. The first one that is available is used:
#   host  an SDK >= 5.13 with Qt 6 that CMake finds (or ParaView_DIR names), or packages of the
#         host's distribution, which root can install;
#   root  a private Debian in $CAMARON_HOME (root.sh).
# CAMARON_PARAVIEW=host or =root restricts the choice. CAMARON_DEBIAN, the release of the private
# Debian, implies =root. The choice is stored in build/paraview.

choice=$build/paraview

# Sets `paraview` to host, root, or inside (this call already runs in the private Debian). For host,
# also sets `prefix`, the parent folder of bin, and `sdk`, its ParaView_DIR.
paraview_ready() {
  local wish=${CAMARON_PARAVIEW:-${CAMARON_DEBIAN:+root}}
  [[ $wish =~ ^(host|root|)$ ]] || die "CAMARON_PARAVIEW must be 'host' or 'root', not '$wish'"
  trusted "$launcher" "$scripts"{,/camaron} "$build"{,/log} "$choice" "$built" "$built_window" "$build/libraries"
  if [[ -n ${CAMARON_INSIDE:-} ]]; then
    paraview=inside
    return
  fi
  if ! read_choice || [[ -n $wish && $wish != "$paraview" ]]; then
    lock "$build/lock"
    choose "$wish"
    unlock
    read_choice
  fi
  if [[ $paraview == host ]]; then
    trusted "$prefix/bin" "$sdk"
  else
    root_ready
  fi
}

# Reads the stored choice. Fails if that SDK no longer exists or is not the one that ParaView_DIR
# names.
read_choice() {
  local asked=
  paraview='' prefix='' sdk=''
  [[ -r $choice ]] || return
  # shellcheck disable=SC2034
  { read -r paraview; read -r prefix; read -r sdk; read -r asked; } <"$choice" || true
  case $paraview in
    root) [[ -z ${ParaView_DIR:-} ]] ;;
    host) [[ -e $sdk && ${ParaView_DIR:-$asked} == "$asked" ]] ;;
    *) false ;;
  esac
}

choose() {
  local wish=$1 answer=root
  if [[ -n ${ParaView_DIR:-} ]]; then
    trusted "$ParaView_DIR" # which CMake runs
    find_sdk || die "CMake finds no ParaView >= 5.13 in $ParaView_DIR; see $build/log/probe.log"
    answer=host
  elif [[ $wish != root ]]; then
    if find_sdk || { distribution_has_paraview && install_packages && find_sdk; }; then
      answer=host
    elif [[ $wish == host ]]; then
      die "CMake finds no ParaView >= 5.13 with Qt 6 on this machine; see $build/log/probe.log"
    fi
  fi
  {
    echo $answer
    [[ $answer == root ]] || { cat "$build/probe/paraview" && echo "${ParaView_DIR:-}"; }
  } >"$choice.new" && mv "$choice.new" "$choice"
}

find_sdk() {
  local log=$build/log/probe.log options=(-Wno-dev)
  type cmake c++ >/dev/null 2>&1 || return
  say "looking for ParaView on this machine ..."
  rm -rf "$build/probe" && mkdir -p "$build/probe" "$build/log" || exit 2
  ! type ninja >/dev/null 2>&1 || options+=(-G Ninja)
  [[ -z ${ParaView_DIR:-} ]] || options+=("-DParaView_DIR=$ParaView_DIR")
  cmake -S "$launcher/probe" -B "$build/probe" "${options[@]}" >"$log" 2>&1 &&
    say "using the ParaView in $(head -n 1 "$build/probe/paraview")"
}

# packages VERSION: prints the packages to install for Debian's ParaView of that version.
packages() {
  local -a lists=("$launcher/packages.txt")
  [[ ${1%%.*} == 5 ]] || lists+=("$launcher/packages-6.txt")
  sed 's/#.*//; /^ *$/d' "${lists[@]}" | LC_ALL=C sort -u
}

# Whether root runs this and can install ParaView >= 5.13 with apt.
distribution_has_paraview() {
  [[ $EUID == 0 ]] && type apt-get >/dev/null 2>&1 || return
  [[ $(candidate) == [0-9]* ]] || refresh_apt
  dpkg --compare-versions "$(candidate)" ge 5.13 2>/dev/null && refresh_apt
}

candidate() {
  LC_ALL=C apt-cache policy paraview-dev | sed -n 's/ *Candidate: //p'
}

install_packages() {
  local -a names
  mapfile -t names < <(packages "$(candidate)")
  say "installing ParaView's packages on this machine (log: $build/log/packages.log) ..."
  apt_install "$build/log/packages.log" "${names[@]}" && "$launcher/link-modules.sh"
}

# apt_install LOG PACKAGE...: installs packages on the host.
apt_install() {
  logged "installing" "$1" env DEBIAN_FRONTEND=noninteractive \
    sh -ec 'dpkg --configure -a; apt-get install -y --no-install-recommends "$@"' sh "${@:2}"
}

# Updates the package lists of apt, at most once per call.
refresh_apt() {
  [[ -z ${refreshed:-} ]] || return 0
  logged "updating package lists" "$build/log/apt.log" apt-get update ||
    say "continuing with the present package lists of apt"
  refreshed=yes
}
