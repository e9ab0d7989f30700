# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154  # what ./camaron and its other parts set
#
# A private Debian with ParaView, for hosts that have none: made by mmdebstrap, entered with
# bubblewrap, with root's rights or, where user namespaces are allowed, without. It is Debian 13, or the
# release that CAMARON_DEBIAN names, which has a folder of its own here and among the builds.

release=${CAMARON_DEBIAN:-trixie}
[[ $release =~ ^[a-z]+$ ]] || die "CAMARON_DEBIAN is the name of a release, such as forky, not '$release'"
# Its ParaView, or an older one of the same packages, and the room that it takes while it is installed.
root_paraview=6 root_megabytes=6000
[[ $release != trixie ]] || root_paraview=5 root_megabytes=5000
root=$CAMARON_HOME/root${CAMARON_DEBIAN:+-$CAMARON_DEBIAN}
root_log=$CAMARON_HOME/log
root_stamp=$root/camaron-packages # the packages a whole root has; written last
root_path=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin

root_ready() {
  root_whole && return
  lock "$CAMARON_HOME/lock"
  root_whole || root_make
  unlock
}

root_whole() {
  [[ -r $root_stamp && -z $(comm -23 <(packages "$root_paraview") "$root_stamp") ]]
}

root_make() {
  root_tools
  rm -rf --one-file-system "$root".new* # what an interrupted call left
  if [[ -d $root ]]; then
    say "adding packages to $root (logs: $root_log) ..."
    root_install "$root" || die "could not add packages; to start anew, remove $root"
    return
  fi
  local free
  free=$(df -Pk "$CAMARON_HOME" | awk 'NR == 2 { print int($4 / 1024) }')
  ((free >= root_megabytes)) || die "a private Debian needs $root_megabytes MB in $CAMARON_HOME, which has $free MB left;" \
    "name a roomier folder with CAMARON_HOME"
  say "getting ParaView: a private Debian ($release) in $root (some minutes, $((root_megabytes / 1000)) GB; logs: $root_log) ..."
  if root_base "$root.new" && root_install "$root.new"; then
    mv "$root.new" "$root" && rm -f "$root.new.apt"
  else
    rm -rf --one-file-system "$root".new*
    die "could not get ParaView; it takes network access to $(mirror) and $root_megabytes MB in $CAMARON_HOME"
  fi
}

# mmdebstrap and bubblewrap, installed where we may, and a test that they can work here.
root_tools() {
  local tools=(mmdebstrap bubblewrap debian-archive-keyring) use="or use the Dockerfile"
  type apt-get >/dev/null 2>&1 ||
    die "no ParaView >= 5.13 with Qt 6 for CMake on this machine, and no apt to get one: install" \
      "ParaView's SDK and name it with ParaView_DIR, $use"
  [[ $EUID == 0 ]] || tools+=(uidmap)
  if ! type mmdebstrap bwrap >/dev/null 2>&1 || [[ $EUID != 0 ]] && ! type newuidmap >/dev/null 2>&1; then
    [[ $EUID == 0 ]] || die "to get ParaView, let root run: apt-get install ${tools[*]} (or, on Debian 13 or newer," \
      "what $launcher/packages*.txt name); $use"
    refresh_apt
    apt_install "$build/log/packages.log" "${tools[@]}" || die "could not install ${tools[*]}; $use"
  fi
  bwrap --dev-bind / / true 2>/dev/null ||
    die "bubblewrap may not make namespaces here (a container, or a kernel that forbids them to users);" \
      "run as root on the machine itself, $use"
  [[ $EUID == 0 ]] || grep -qE "^($(id -un)|$EUID):" /etc/subuid 2>/dev/null ||
    die "no subordinate user ids for you in /etc/subuid (usermod --add-subuids); $use"
}

# The mirror the host's apt uses, whatever the form of its lists, if that is Debian's.
mirror() {
  (
    # shellcheck disable=SC1091,SC2016
    . /etc/os-release && [[ $ID == debian ]] &&
      apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
      awk -v release="$VERSION_CODENAME" '
        $2 == release && $3 == "main" && /^http/ && !found++ { print $1 }
        END { exit !found }'
  ) 2>/dev/null || echo http://deb.debian.org/debian
}

# How the host's apt reaches the network, for the apt of the root.
apt_settings() {
  apt-config dump --format '%f "%v";%n' Acquire |
    grep -E '^Acquire::((https?|ftp)::(Proxy|Timeout)|Check-|Retries|ForceIPv)' | grep -v Auto
  echo 'Acquire::Languages "none";'
  echo 'APT::Sandbox::User "root";'
}

# root_base DIR: a Debian with apt and nothing more.
root_base() {
  local settings=$1.apt options=(--verbose --variant=apt --dpkgopt=force-unsafe-io
    "--aptopt=$1.apt")
  mkdir -p "$1"
  apt_settings >"$settings"
  if [[ $EUID == 0 ]]; then
    # Mounts of a killed mmdebstrap must not outlive it, lest removing its root reach into /dev.
    logged "base system" "$root_log/base.log" unshare --mount \
      mmdebstrap --mode=root "${options[@]}" "$release" "$1" "$(mirror)"
  else
    logged "base system" "$root_log/base.log" \
      mmdebstrap --mode=unshare --include=fakeroot "${options[@]}" "$release" "$1.tar" "$(mirror)" &&
      tar -x -f "$1.tar" -C "$1" --exclude './dev/*' && rm "$1.tar"
  fi
}

# root_install DIR: the packages into the Debian in DIR. Also mends what an interrupted call left.
root_install() {
  local -a names rights=() become=()
  mapfile -t names < <(packages "$root_paraview")
  # Without root's rights there is only one user id inside; fakeroot pretends there were more.
  [[ $EUID == 0 ]] || {
    rights=(--unshare-user --uid 0 --gid 0)
    become=(env FAKEROOTDONTTRYCHOWN=1 fakeroot-tcp)
  }
  apt_settings >"$1/etc/apt/apt.conf.d/99mmdebstrap"
  echo "deb $(mirror) $release main" >"$1/etc/apt/sources.list"
  touch "$1"/etc/{resolv.conf,hosts,passwd,group,machine-id} # to mount the host's on
  logged "ParaView" "$root_log/paraview.log" \
    bwrap --die-with-parent --unshare-pid "${rights[@]}" --bind "$1" / \
    --dev /dev --proc /proc --tmpfs /run --ro-bind "$launcher" /mnt --chdir / \
    --ro-bind-try /etc/resolv.conf /etc/resolv.conf --ro-bind-try /etc/hosts /etc/hosts \
    --setenv PATH "$root_path" --setenv LC_ALL C.UTF-8 --setenv DEBIAN_FRONTEND noninteractive \
    --unsetenv TMPDIR --unsetenv LD_PRELOAD --unsetenv LD_LIBRARY_PATH \
    "${become[@]}" sh -ec 'dpkg --configure -a
      apt-get update
      apt-get install -y --no-install-recommends "$@"
      apt-get clean
      /mnt/link-modules.sh' sh "${names[@]}" || return
  LC_ALL=C sort -u -o "$1/camaron-packages.new" <(packages "$root_paraview") "$1/${root_stamp##*/}" 2>/dev/null ||
    packages "$root_paraview" >"$1/camaron-packages.new"
  mv "$1/camaron-packages.new" "$1/${root_stamp##*/}"
}

# Sets `enter`, the command that runs another one in the root: Debian's own folders are the root's,
# all others the host's under their own paths, so that a mesh anywhere opens.
# root_enter [PATH...]: with these made visible too, wherever they are.
root_enter() {
  local path target
  enter=(bwrap --die-with-parent --dev-bind /dev /dev --proc /proc --ro-bind /sys /sys --dir /run)
  for path in "$root"/{usr,etc,bin,sbin,lib*} "$root"/var/*; do
    target=${path#"$root"}
    if [[ -L $path ]]; then
      enter+=(--symlink "$(readlink "$path")" "$target")
    elif [[ $target != /var/tmp ]]; then
      enter+=(--ro-bind "$path" "$target")
    fi
  done
  for path in /* /var/* /run/user /run/media; do
    of_root "$path" || [[ ! -d $path ]] || enter+=(--bind-try "$path" "$path")
  done
  for path in /etc/{resolv.conf,hosts,passwd,group,machine-id}; do
    [[ ! -e $path || ! -e $root$path ]] || enter+=(--ro-bind "$path" "$path")
  done
  for path in "$PWD" "$top" "$CAMARON_HOME" "${HOME:-/}" "$@"; do
    [[ -e $path ]] || continue
    path=$(readlink -f -- "$path")
    [[ -d $path ]] || path=${path%/*}
    # Over what Debian needs there, nothing is mounted.
    if of_root "$path" && [[ -z $(ls -A "$root$path" 2>/dev/null) ]]; then
      mkdir -p "$root$path" && enter+=(--bind "$path" "$path")
    fi
  done
  enter+=(--chdir "$PWD" --setenv PATH "$root_path" --setenv LC_ALL C.UTF-8)
  for path in LD_PRELOAD LD_LIBRARY_PATH PYTHONHOME QT_PLUGIN_PATH QT_QPA_PLATFORMTHEME QT_STYLE_OVERRIDE; do
    enter+=(--unsetenv "$path")
  done
}

# of_root PATH: whether it shows the root's folder, not the host's.
of_root() {
  case $1 in
    /run/user* | /run/media* | /var/tmp | /var/tmp/*) false ;;
    /usr | /usr/* | /etc | /etc/* | /bin | /sbin | /lib | /lib32 | /lib64 | /libx32) ;;
    /boot | /dev | /lost+found | /proc | /run | /run/* | /sys | /var) ;;
    /var/*) [[ -e $root/$(cut -d / -f 2,3 <<<"$1") ]] ;;
    *) false ;;
  esac
}
