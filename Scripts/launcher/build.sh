# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2154  # variables that ./camaron and its other parts set
#
# Builds the plugin, and runs programs with it.

# Contains the plugin's folder; its modification time is that of the start of the last build. The same after a build with
# what only ParaView's window loads.
built=$build/built
built_window=$build/built-window

# environment [PATH...]: sets `enter`, the prefix that runs a command in ParaView's environment, and
# exports the variables that it needs. The paths are visible there.
environment() {
  local threads
  threads=$(nproc)
  user_folder
  [[ -d ${HOME:-} ]] || export HOME=$own # Open MPI, which ParaView uses, does not start without it
  export CAMARON_HOME=${CAMARON_HOME:-$own}
  export CCACHE_DIR=${CCACHE_DIR:-$own/ccache} CCACHE_BASEDIR=${CCACHE_BASEDIR:-$top}
  export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros} # for precompiled headers
  export MESA_SHADER_CACHE_DIR=${MESA_SHADER_CACHE_DIR:-$own/mesa}
  export VTK_SMP_BACKEND_IN_USE=${VTK_SMP_BACKEND_IN_USE:-STDThread}
  export VTK_SMP_MAX_THREADS=${VTK_SMP_MAX_THREADS:-$threads}
  export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$threads}
  # Allow more ranks than cores (Open MPI 4 and 6), and ranks of root.
  export OMPI_MCA_rmaps_base_oversubscribe=1 PRTE_MCA_mapby=:oversubscribe
  export HWLOC_COMPONENTS=${HWLOC_COMPONENTS:--gl} # gl would query foreign displays
  [[ $EUID != 0 ]] || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  if [[ ! -d ${XDG_RUNTIME_DIR:-} || ! -O $XDG_RUNTIME_DIR ]] || untrusted "$XDG_RUNTIME_DIR"; then
    export XDG_RUNTIME_DIR=$own/run
    (umask 077 && mkdir -p "$XDG_RUNTIME_DIR") 2>/dev/null && [[ -O $XDG_RUNTIME_DIR ]] ||
      die "$XDG_RUNTIME_DIR: cannot create this folder, or it belongs to another user"
  fi
  enter=() tied=()
  if [[ $paraview == root ]]; then
    unset PYTHONPATH # it is for the host's Python
    # All ranks are on this machine; ofi would spend a second on searching networks.
    export OMPI_MCA_btl=${OMPI_MCA_btl:-^tcp,ofi}
    root_enter "$@"
    export CAMARON_INSIDE=1
  elif [[ $paraview == host ]]; then
    export PATH=$prefix/bin:$PATH
  fi
  # Open MPI 5 needs this variable; later versions warn about it.
  [[ $("${enter[@]}" mpiexec --version 2>&1) != *'(Open MPI) 5.'* ]] ||
    export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
  export PYTHONPATH=$scripts${PYTHONPATH:+:$PYTHONPATH}
}

# Sets `own`, the folder for caches and other files that programs leave behind: the first of these
# folders that can be trusted, exists or can be created, belongs to the user and is writable.
# CAMARON_HOME may belong to somebody else.
user_folder() {
  local folder
  for folder in ${CAMARON_HOME:+"$CAMARON_HOME"} ${cache:+"$cache/camaron"} "${TMPDIR:-/tmp}/camaron-$EUID"; do
    ! untrusted "$folder" || continue
    reason="$folder: cannot create this folder, or it belongs to another user"
    [[ -d $folder ]] || mkdir -p "$folder" 2>/dev/null || continue
    if [[ -O $folder && -w $folder && ! -L $folder ]]; then
      own=$folder
      return
    fi
  done
  die "$reason; set CAMARON_HOME to a folder of yours"
}

# has PROGRAM: whether ParaView's environment has the program.
has() {
  [[ $paraview == root ]] || type "$1" >/dev/null 2>&1
}

# plugin_ready [TARGET]: builds the plugin, with the target `window` also what only ParaView's window loads, if a source has
# changed since that was built last, and adds the plugin to PV_PLUGIN_PATH.
plugin_ready() {
  local plugin='' target=${1:-Camaron} last=$built
  [[ $target == Camaron ]] || last=$built_window
  [[ ! -r $last ]] || plugin=$(<"$last")
  if [[ ! -e $plugin/Camaron.so || -n $(changed "$last") ]]; then
    may_build
    build_plugin --target "$target"
    plugin=$(<"$built")
  fi
  trusted "$plugin"{,/Camaron.so,/Panel,/Panel/CamaronPanel.so}
  export PV_PLUGIN_PATH=$plugin${PV_PLUGIN_PATH:+:$PV_PLUGIN_PATH}
}

# changed BUILT: prints a source file newer than the build that BUILT is about, or a folder in which files were added or
# removed; else nothing.
changed() {
  local folder
  local -a sources=("$top/CMakeLists.txt" "$top/CMake")
  [[ $paraview == inside ]] || sources+=("$choice")
  for folder in "$top"/*/; do
    [[ ! -e ${folder}vtk.module && ! -e ${folder}paraview.plugin ]] || sources+=("$folder")
  done
  find "${sources[@]}" -newer "$1" -print -quit
}

may_build() {
  mkdir -p "$build" 2>/dev/null && [[ -w $build ]] ||
    die "the plugin has to be built, but $build is not writable: its owner must run" \
      "$top/camaron build"
}

# build_plugin OPTION...: options of cmake --build; without any, all is built.
build_plugin() {
  local started stamp
  local -a stamps=("$built")
  [[ $* == '--target Camaron' ]] || stamps+=("$built_window")
  started=$(date +%s.%N)
  configured "$build" || configure "$build"
  compile "$build" "$@"
  for stamp in "${stamps[@]}"; do
    plugin_folder "$build" >"$stamp.$$"
    touch -d "@$started" "$stamp.$$"
    mv "$stamp.$$" "$stamp"
  done
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
  # Discard CMake's cache if it is for another ParaView or for a clone that was moved.
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

# Prints the path of Python, then the libraries that it loads with ParaView, each after its
# dependencies. Fails if Python does not find this ParaView. Python would import modules from the
# current folder, which may be anybody's.
list_libraries() {
  "${enter[@]}" bash -c 'type -p python3' &&
    "${enter[@]}" env -C / LD_DEBUG=files python3 -c 'import sys, paraview.simple
sys.exit(not paraview.__file__.startswith(sys.argv[1] + "/"))' "${prefix:-/usr}" 2>&1 >/dev/null |
      sed -n 's/.*calling init: //p'
}

# Sets `runner`, the program for Python in one process. python3 starts twice as fast as pvpython,
# which also starts MPI and loads all of ParaView's libraries together, so that the loader searches
# hundreds of them for every symbol. quick_start.py loads the libraries in the list one by one instead.
# Only the writer of CGNS needs MPI.
choose_runner() {
  local python=''
  runner=("$launcher/in-own-folder" pvpython) # if killed, MPI leaves a folder behind
  [[ ! $1 =~ ^(convert|select)$ || ${*,,} != *.cgns* ]] || return 0
  [[ ! -r $build/libraries ]] || read -r python <"$build/libraries" || true
  # On the host, PATH may have another Python than at the last configuration.
  [[ -n $python && ($paraview == root || $(type -p python3) == "$python") ]] || return 0
  runner=(python3)
  export CAMARON_LIBRARIES=$build/libraries
}

# compile FOLDER OPTION...: options of cmake --build.
compile() {
  local folder=$1 gigabytes jobs
  shift
  trusted "$CCACHE_DIR"
  # A translation unit that includes VTK's templates takes about a gigabyte.
  gigabytes=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
  jobs=$(nproc)
  ((jobs <= gigabytes)) || jobs=$((gigabytes > 1 ? gigabytes : 1))
  export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$jobs} # also for nested builds
  lock "$build/lock"
  logged "building" "$folder/log/build.log" "${enter[@]}" \
    cmake --build "$folder" --parallel "$CMAKE_BUILD_PARALLEL_LEVEL" "$@" || exit 2
  unlock
}

plugin_folder() {
  find "$1"/lib* -path '*/Camaron/Camaron.so' -printf '%h\n' -quit | grep . || die "$1 contains no built plugin"
}

# Configures the build with tests and benchmarks, unless it already is.
with_tests() {
  if ! configured "$build" || ! grep -q '^CAMARON_BUILD_TESTING:BOOL=ON' "$build/CMakeCache.txt"; then
    configure "$build" -DCAMARON_BUILD_TESTING=ON
  fi
}

# run COMMAND...: runs COMMAND in ParaView's environment and exits with its status; through the command in the array
# "tied", in place of this process.
run() {
  umask "$mask"
  ((${#enter[@]})) || exec "${tied[@]}" "$@"
  # COMMAND handles Ctrl-C; bubblewrap would end it at once.
  trap '' INT
  ((${#tied[@]} == 0)) || exec "${enter[@]}" env --default-signal=INT "${tied[@]}" "$@"
  "${enter[@]}" env --default-signal=INT "$@"
  exit
}

# run_rendering COMMAND...: the same with a display: the desktop's if there is one, else a new Xvfb. Where there is neither,
# it warns, except of a command that only may render.
run_rendering() {
  local socket=''
  trusted "$MESA_SHADER_CACHE_DIR" # contains compiled shaders
  [[ ! ${DISPLAY:-} =~ ^(unix)?:([0-9]+) ]] || socket=/tmp/.X11-unix/X${BASH_REMATCH[2]}
  if [[ -S $socket ]] && ! untrusted "$socket"; then
    run "$@"
  elif has Xvfb; then
    run "$launcher/with-display" "$@"
  else
    [[ -n ${may_render:-} ]] || say "there is neither a display nor Xvfb: rendering will fail"
    run "$@"
  fi
}
