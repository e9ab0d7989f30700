# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154  # variables that ./camaron and its other parts set
#
# A private Debian with ParaView, for hosts without ParaView. mmdebstrap creates it, bubblewrap
# enters it; both work as root, or as any user where user namespaces are allowed. It is Debian 13,
# or the release that CAMARON_DEBIAN names, which has its own folder here and in build/.

release=${CAMARON_DEBIAN:-trixie}
[[ $release =~ ^[a-z]+$ ]] || die "CAMARON_DEBIAN must be the name of a release, such as forky, not '$release'"
# Version of its ParaView, or of an older one with the same packages, and the disk space needed to
# install it.
root_paraview=6 root_megabytes=6000
[[ $release != trixie ]] || root_paraview=5 root_megabytes=5000
root=$CAMARON_HOME/root${CAMARON_DEBIAN:+-$CAMARON_DEBIAN}
root_log=$CAMARON_HOME/log
root_stamp=$root/camaron-packages # lists the installed packages; written last
root_path=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin

root_ready() {
  [[ -n $CAMARON_HOME ]] ||
    die "set CAMARON_HOME to a folder for a private Debian with ParaView; there is no HOME, in which it would be"
  trusted "$home" "$root" "$root"/{etc,usr,usr/{bin,sbin,lib,libexec},usr/lib/{*-linux-gnu,python3/dist-packages}} \
    "$root_stamp" "$root_log"
  root_whole && return
  [[ -e $CAMARON_HOME ]] || ! mkdir -p "$CAMARON_HOME" 2>/dev/null || trusted "$CAMARON_HOME"
  lock "$CAMARON_HOME/lock"
  root_whole || root_make
  unlock
}

root_whole() {
  [[ -r $root_stamp && -z $(comm -23 <(packages "$root_paraview") "$root_stamp") ]]
}

root_make() {
  root_tools
  rm -rf --one-file-system "$root".new* # left by an interrupted call
  if [[ -d $root ]]; then
    say "adding packages to $root (logs: $root_log) ..."
    root_install "$root" || die "could not add packages; remove $root to start over"
    return
  fi
  local free
  free=$(df -Pk "$CAMARON_HOME" | awk 'NR == 2 { print int($4 / 1024) }')
  ((free >= root_megabytes)) || die "a private Debian needs $root_megabytes MB in $CAMARON_HOME, which has $free MB left;" \
    "set CAMARON_HOME to a folder with more space"
  say "installing ParaView: a private Debian ($release) in $root (some minutes, $((root_megabytes / 1000)) GB; logs: $root_log) ..."
  if root_base "$root.new" && root_install "$root.new"; then
    mv "$root.new" "$root" && rm -f "$root.new.apt"
  else
    rm -rf --one-file-system "$root".new*
    die "could not install ParaView; this needs network access to $(mirror) and $root_megabytes MB in $CAMARON_HOME"
  fi
}

# Installs mmdebstrap and bubblewrap if root runs this, and checks that they work here.
root_tools() {
  local tools=(mmdebstrap bubblewrap debian-archive-keyring) use="or use the Dockerfile"
  type apt-get >/dev/null 2>&1 ||
    die "there is no ParaView >= 5.13 with Qt 6 on this machine, and no apt to install it: install" \
      "ParaView's SDK and set ParaView_DIR to it, $use"
  [[ $EUID == 0 ]] || tools+=(uidmap)
  if ! type mmdebstrap bwrap >/dev/null 2>&1 || [[ $EUID != 0 ]] && ! type newuidmap >/dev/null 2>&1; then
    [[ $EUID == 0 ]] || die "to install ParaView, run as root: apt-get install ${tools[*]} (or, on Debian 13 or newer," \
      "the packages in $launcher/packages*.txt); $use"
    refresh_apt
    apt_install "$build/log/packages.log" "${tools[@]}" || die "could not install ${tools[*]}; $use"
  fi
  bwrap --dev-bind / / true 2>/dev/null ||
    die "bubblewrap cannot create namespaces here (in a container, or forbidden by the kernel);" \
      "run as root on the machine itself, $use"
  [[ $EUID == 0 ]] || grep -qE "^($(id -un)|$EUID):" /etc/subuid 2>/dev/null ||
    die "your user has no subordinate user ids in /etc/subuid: add them with usermod --add-subuids; $use"
}

# Prints the mirror that the host's apt uses if the host is Debian, else Debian's own.
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

# Prints the network settings of the host's apt, for apt in the private Debian.
apt_settings() {
  apt-config dump --format '%f "%v";%n' Acquire |
    grep -E '^Acquire::((https?|ftp)::(Proxy|Timeout)|Check-|Retries|ForceIPv)' | grep -v Auto
  echo 'Acquire::Languages "none";'
  echo 'APT::Sandbox::User "root";'
}

# root_base DIR: creates a minimal Debian with apt.
root_base() {
  local settings=$1.apt options=(--verbose --variant=apt --dpkgopt=force-unsafe-io
    "--aptopt=$1.apt")
  mkdir -p "$1"
  apt_settings >"$settings"
  if [[ $EUID == 0 ]]; then
    # In its own mount namespace, so that no mounts of a killed mmdebstrap remain: removing the
    # folder would delete files of the host's /dev through them.
    logged "base system" "$root_log/base.log" unshare --mount \
      mmdebstrap --mode=root "${options[@]}" "$release" "$1" "$(mirror)"
  else
    logged "base system" "$root_log/base.log" \
      mmdebstrap --mode=unshare --include=fakeroot "${options[@]}" "$release" "$1.tar" "$(mirror)" &&
      tar -x -f "$1.tar" -C "$1" --exclude './dev/*' && rm "$1.tar"
  fi
}

# root_install DIR: installs the packages in the Debian in DIR. Also repairs an interrupted
# installation.
root_install() {
  local -a names rights=() become=()
  mapfile -t names < <(packages "$root_paraview")
  # Without root privileges there is only one user id inside; fakeroot simulates the others.
  [[ $EUID == 0 ]] || {
    rights=(--unshare-user --uid 0 --gid 0)
    become=(env FAKEROOTDONTTRYCHOWN=1 fakeroot-tcp)
  }
  apt_settings >"$1/etc/apt/apt.conf.d/99mmdebstrap"
  echo "deb $(mirror) $release main" >"$1/etc/apt/sources.list"
  touch "$1"/etc/{resolv.conf,hosts,passwd,group,machine-id} # mount points for the host's files
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

# root_enter [PATH...]: sets `enter`, the prefix that runs a command in the private Debian. Its
# system folders replace the host's; all other folders of the host keep their paths, so meshes open
# from anywhere. The paths are made visible even in system folders.
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
    # Never mount over files that the private Debian needs.
    if of_root "$path" && [[ -z $(ls -A "$root$path" 2>/dev/null) ]]; then
      mkdir -p "$root$path" && enter+=(--bind "$path" "$path")
    fi
  done
  enter+=(--chdir "$PWD" --setenv PATH "$root_path" --setenv LC_ALL C.UTF-8)
  for path in LD_PRELOAD LD_LIBRARY_PATH PYTHONHOME QT_PLUGIN_PATH QT_QPA_PLATFORMTHEME QT_STYLE_OVERRIDE; do
    enter+=(--unsetenv "$path")
  done
}

# of_root PATH: whether the path is the private Debian's, not the host's.
of_root() {
  local name=${1#/var/}
  case $1 in
    /run/user* | /run/media* | /var/tmp | /var/tmp/*) false ;;
    /usr | /usr/* | /etc | /etc/* | /bin | /sbin | /lib | /lib32 | /lib64 | /libx32) ;;
    /boot | /dev | /lost+found | /proc | /run | /run/* | /sys | /var) ;;
    /var/*) [[ -e $root/var/${name%%/*} ]] ;;
    *) false ;;
  esac
}
