# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154  # what ./camaron and its other parts set
#
# Which ParaView to use, and getting one. The first that there is:
#   host  an SDK >= 5.13 with Qt 6 that CMake finds (or that ParaView_DIR names), or that the host's
#         distribution has as packages: installed where we are root;
#   root  a private Debian in $CAMARON_HOME (root.sh).
# CAMARON_PARAVIEW=host or =root decides otherwise, as CAMARON_DEBIAN does, which names the release of
# the private one. The answer is kept in build/paraview.

choice=$build/paraview

# Sets `paraview` (host, root, or inside where this call runs in the root already) and, for host,
# `prefix` and `sdk`, its bin's parent and its ParaView_DIR.
paraview_ready() {
  local wish=${CAMARON_PARAVIEW:-${CAMARON_DEBIAN:+root}}
  [[ $wish =~ ^(host|root|)$ ]] || die "CAMARON_PARAVIEW is 'host' or 'root', not '$wish'"
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
  [[ $paraview == host ]] || root_ready
}

# A remembered SDK that is gone, or is not the one asked for, is no answer.
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
    find_sdk || die "no ParaView >= 5.13 for CMake in $ParaView_DIR; see $build/log/probe.log"
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

# packages VERSION: those that Debian's ParaView of that version takes.
packages() {
  local -a lists=("$launcher/packages.txt")
  [[ ${1%%.*} == 5 ]] || lists+=("$launcher/packages-6.txt")
  sed 's/#.*//; /^ *$/d' "${lists[@]}" | LC_ALL=C sort -u
}

# Only root may install, and so learn what there is to install.
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

# apt_install LOG PACKAGE...: on the host.
apt_install() {
  logged "installing" "$1" env DEBIAN_FRONTEND=noninteractive \
    sh -ec 'dpkg --configure -a; apt-get install -y --no-install-recommends "$@"' sh "${@:2}"
}

# Once a call at most.
refresh_apt() {
  [[ -z ${refreshed:-} ]] || return 0
  logged "asking apt for packages" "$build/log/apt.log" apt-get update ||
    say "going on with what apt knew before"
  refreshed=yes
}
