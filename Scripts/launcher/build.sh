# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154  # what ./camaron and its other parts set
#
# Building, and running things with what was built.

built=$build/built # as old as the sources the plugin was built from; holds the plugin's folder

# Sets `enter`, the prefix that runs a command beside ParaView, and the variables it runs with.
# environment [PATH...]: with these visible.
environment() {
  local threads
  threads=$(nproc)
  user_folder
  [[ -d ${HOME:-} ]] || export HOME=$own # Open MPI, as part of ParaView, does not start without
  export CAMARON_HOME
  export CCACHE_DIR=${CCACHE_DIR:-$own/ccache} CCACHE_BASEDIR=${CCACHE_BASEDIR:-$top}
  export MESA_SHADER_CACHE_DIR=${MESA_SHADER_CACHE_DIR:-$own/mesa}
  export VTK_SMP_BACKEND_IN_USE=${VTK_SMP_BACKEND_IN_USE:-STDThread}
  export VTK_SMP_MAX_THREADS=${VTK_SMP_MAX_THREADS:-$threads}
  export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$threads}
  # More ranks than cores, in Open MPI 4 and 6, and as root.
  export OMPI_MCA_rmaps_base_oversubscribe=1 PRTE_MCA_mapby=:oversubscribe
  export HWLOC_COMPONENTS=${HWLOC_COMPONENTS:--gl} # which looks for displays that are not ours
  [[ $EUID != 0 ]] || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  if [[ ! -d ${XDG_RUNTIME_DIR:-} ]]; then
    export XDG_RUNTIME_DIR=$own/run
    (umask 077 && mkdir -p "$XDG_RUNTIME_DIR") 2>/dev/null || die "$XDG_RUNTIME_DIR: cannot make this folder"
  fi
  enter=()
  if [[ $paraview == root ]]; then
    unset PYTHONPATH # of another Python
    # All ranks are on this machine; ofi looks for networks, which takes a second.
    export OMPI_MCA_btl=${OMPI_MCA_btl:-^tcp,ofi}
    root_enter "$@"
    export CAMARON_INSIDE=1
  elif [[ $paraview == host ]]; then
    export PATH=$prefix/bin:$PATH
  fi
  # In Open MPI 5; a later one warns of this name.
  [[ $("${enter[@]}" mpiexec --version 2>&1) != *'(Open MPI) 5.'* ]] ||
    export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
  export PYTHONPATH=$scripts${PYTHONPATH:+:$PYTHONPATH}
}

# Sets `own`, a folder for what is left behind by running: CAMARON_HOME, which may be somebody else's, or
# the first other one that is, or can be made, the user's alone.
user_folder() {
  local folder
  for folder in "$CAMARON_HOME" "${XDG_CACHE_HOME:-${HOME:-/nonexistent}/.cache}/camaron" "${TMPDIR:-/tmp}/camaron-$EUID"; do
    mkdir -p "$folder" 2>/dev/null || continue
    if [[ -O $folder && -w $folder && ! -L $folder ]]; then
      own=$folder
      return
    fi
  done
  die "$folder: cannot make this folder of yours"
}

# Whether ParaView's side has a program.
has() {
  [[ $paraview == root ]] || type "$1" >/dev/null 2>&1
}

# Makes the plugin ready: at once when no source changed since.
plugin_ready() {
  local plugin=''
  [[ ! -r $built ]] || plugin=$(<"$built")
  if [[ ! -e $plugin/Camaron.so || -n $(changed) ]]; then
    may_build
    build_plugin --target Camaron
    plugin=$(<"$built")
  fi
  export PV_PLUGIN_PATH=$plugin${PV_PLUGIN_PATH:+:$PV_PLUGIN_PATH}
}

# Something newer than the last build, if there is: a source, or a folder that gained or lost one.
changed() {
  local folder
  local -a sources=("$top/CMakeLists.txt" "$top/CMake")
  [[ $paraview == inside ]] || sources+=("$choice")
  for folder in "$top"/*/; do
    [[ ! -e ${folder}vtk.module && ! -e ${folder}paraview.plugin ]] || sources+=("$folder")
  done
  find "${sources[@]}" -newer "$built" -print -quit
}

may_build() {
  mkdir -p "$build" 2>/dev/null && [[ -w $build ]] ||
    die "the plugin is not built, or older than its sources, and $build may not be written: let its owner" \
      "run $top/camaron build"
}

# build_plugin OPTION...: options of cmake --build.
build_plugin() {
  local started
  started=$(date +%s.%N)
  configured "$build" || configure "$build"
  compile "$build" "$@"
  plugin_folder "$build" >"$built.$$"
  touch -d "@$started" "$built.$$"
  mv "$built.$$" "$built"
}

configured() {
  [[ -e $1/CMakeCache.txt && -r $1/configured && ! $choice -nt $1/configured ]] &&
    [[ $(<"$1/configured") == "$top" ]]
}

# configure FOLDER CMAKE_OPTION...
configure() {
  local folder=$1 options=(-Wno-dev -DCMAKE_BUILD_TYPE=Release)
  shift
  lock "$build/lock"
  # What CMake remembers of another ParaView, or of a clone that was moved, misleads it.
  if [[ -e $folder/configured ]] && ! configured "$folder"; then
    rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles"
  fi
  rm -f "$folder/configured"
  if [[ ! -e $folder/CMakeCache.txt ]] && has ninja; then
    options+=(-G Ninja)
  fi
  if has ccache; then
    options+=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  [[ $paraview != host ]] || options+=("-DParaView_DIR=$sdk")
  logged "configuring" "$folder/log/configure.log" "${enter[@]}" \
    cmake -S "$top" -B "$folder" "${options[@]}" "$@" || exit 2
  list_libraries >"$folder/libraries" || rm "$folder/libraries"
  printf '%s\n' "$top" >"$folder/configured"
  unlock
}

# Python, and the libraries that it loads with ParaView, each after those that it needs; fails where Python does not
# know this ParaView.
list_libraries() {
  "${enter[@]}" bash -c 'type -p python3' &&
    "${enter[@]}" env LD_DEBUG=files python3 -c 'import sys, paraview.simple
sys.exit(not paraview.__file__.startswith(sys.argv[1] + "/"))' "${prefix:-/usr}" 2>&1 >/dev/null |
      sed -n 's/.*calling init: //p'
}

# Sets `runner`, the program for Python in one process. Python itself starts in half of the time of pvpython, which
# starts MPI, too, and has all of ParaView's libraries loaded together: the loader then looks for every symbol in
# hundreds of them. __main__.py loads those that are listed one by one.
choose_runner() {
  local python=''
  runner=("$launcher/in-own-folder" pvpython) # where MPI leaves one, if it is killed
  [[ ! -r $build/libraries ]] || read -r python <"$build/libraries" || true
  # On the host another Python may have become the first one in PATH.
  [[ -n $python && ($paraview == root || $(type -p python3) == "$python") ]] || return 0
  runner=(python3)
  export CAMARON_LIBRARIES=$build/libraries
}

# compile FOLDER OPTION...: options of cmake --build.
compile() {
  local folder=$1 gigabytes jobs
  shift
  # A translation unit that includes VTK's templates takes about a gigabyte.
  gigabytes=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
  jobs=$(nproc)
  ((jobs <= gigabytes)) || jobs=$((gigabytes > 1 ? gigabytes : 1))
  export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$jobs} # of builds within it too
  lock "$build/lock"
  logged "building" "$folder/log/build.log" "${enter[@]}" \
    cmake --build "$folder" --parallel "$CMAKE_BUILD_PARALLEL_LEVEL" "$@" || exit 2
  unlock
}

plugin_folder() {
  find "$1"/lib* -path '*/Camaron/Camaron.so' -printf '%h\n' -quit | grep . || die "no plugin in $1"
}

# Configures tests and benchmarks too, once and for all.
with_tests() {
  if ! configured "$build" || ! grep -q '^CAMARON_BUILD_TESTING:BOOL=ON' "$build/CMakeCache.txt"; then
    configure "$build" -DCAMARON_BUILD_TESTING=ON
  fi
}

# Runs the rest of this call: COMMAND beside ParaView.
run() {
  ((${#enter[@]})) || exec "$@"
  # Ctrl-C is for COMMAND to answer; bubblewrap would end it without asking.
  trap '' INT
  "${enter[@]}" env --default-signal=INT "$@"
  exit
}

# The same with a display: the desktop's if there is one, else one of its own.
run_rendering() {
  if [[ ${DISPLAY:-} =~ ^(unix)?:([0-9]+) && -S /tmp/.X11-unix/X${BASH_REMATCH[2]} ]]; then
    run "$@"
  elif has Xvfb; then
    run "$launcher/with-display" "$@"
  else
    say "no display and no Xvfb: pictures will fail"
    run "$@"
  fi
}
