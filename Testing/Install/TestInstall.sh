#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# TestInstall.sh CMAKE BUILD SOURCE PARAVIEW PLUGINS PYTHON: installs BUILD, and does what README.md says to do then.
# PARAVIEW is the prefix of ParaView, PLUGINS and PYTHON are folders under a prefix.
. "${BASH_SOURCE[0]%/*}/../expect.sh"

cmake=$1 build=$2 source=$3 paraview=$4 plugins=$5 python=$6
# As on the machine of somebody who has installed it, with ParaView in PATH.
unset PV_PLUGIN_PATH PV_PLUGIN_CONFIG_FILE PYTHONPATH CAMARON_INSIDE CAMARON_STATUS
PATH=$paraview/bin:$PATH

prefix=$folder/opt/paraview
"$cmake" --install "$build" --prefix "$prefix" >"$folder/log" || { tail -n 5 "$folder/log"; exit 1; }
expect "paths of the build" "" "$(grep -rlF -e "$build" -e "$source" "$prefix")"
expect "libraries and headers for nobody" "" "$(find "$prefix" -name '*.a' -o -name '*.h')"
mkdir "$folder/elsewhere" && cd "$folder/elsewhere" || exit 1

# The command, on one process and on ranks.
mesh=$source/Examples/voronoi-ball.visf
expect "version" "$("$source/camaron" --version)" "$("$prefix/bin/camaron" --version)"
timeout 100 "$prefix/bin/camaron" check "$mesh" --rules "$source/Examples/fem.rules" >check.txt 2>&1
expect "status of check on a mesh that fails" 1 $?
echo 'Volume > 0' >all.rules
for ranks in "" $(type mpiexec >/dev/null 2>&1 && echo "--ranks=2"); do
  # shellcheck disable=SC2086
  timeout 100 "$prefix/bin/camaron" check "$mesh" --rules all.rules $ranks >check.txt 2>&1
  expect "status of check $ranks on a mesh that passes" 0 $?
done
if [[ -n $ranks && $(uname) == Linux ]]; then
  [[ -r $prefix/$plugins/Camaron/idle-ranks ]]
  expect "what lets ranks sleep" 0 $?
  message=$(LD_PRELOAD=libm.so.6 timeout 100 "$prefix/bin/camaron" check "$mesh" --rules all.rules "$ranks" 2>&1 >/dev/null)
  expect "messages of check $ranks with a library that is preloaded" "" "$message"
fi
expect "messages of convert" "" "$(timeout 100 "$prefix/bin/camaron" convert "$mesh" ball.vtu 2>&1)"
[[ -s ball.vtu ]]
expect "status of convert" 0 $?
"$prefix/bin/camaron" test >/dev/null 2>&1
expect "status of what takes a clone" 2 $?

# Python, where ParaView and the plugin have different prefixes, with the paths that the modulefile sets.
module=$(echo "$prefix"/share/modulefiles/camaron/*)
loaded() {
  local command name value
  while read -r command name value; do
    [[ $command != prepend-path ]] || export "$name=${value//\"/}${!name:+:${!name}}"
  done <module.txt
  "$@"
}
if type tclsh >/dev/null 2>&1; then
  {
    echo 'proc prepend-path {name value} { puts "prepend-path $name $value" }'
    echo 'proc conflict args {}; proc module-whatis args {}'
    echo "set ModulesCurrentModulefile {$module}; source {$module}"
  } >module.tcl
  tclsh module.tcl >module.txt
  expect "status of the modulefile" 0 $?
else
  sed "s|\$prefix|$prefix|" "$module" >module.txt
fi
cat >script.py <<END
from paraview.simple import *
LoadDistributedPlugin("Camaron", ns=globals())
ElementQuality(Input=Sphere()).UpdatePipeline()
import camaron
print(camaron.check("$mesh", "all.rules")["verdict"], camaron.__file__)
END
expect "a script" "pass $prefix/$python/camaron/__init__.py" \
  "$(loaded timeout 100 pvpython script.py 2>&1 | tail -n 1)"
if timeout 100 python3 -c 'import paraview.simple' >/dev/null 2>&1; then # which is no program of ParaView's
  expect "a script of python3" "pass" "$(env -u PV_PLUGIN_PATH "PYTHONPATH=$prefix/$python" timeout 100 python3 -c \
    "import camaron; print(camaron.check('$mesh', 'all.rules')['verdict'])" 2>&1 | tail -n 1)"
fi
expect "the command in PATH" "$prefix/bin/camaron" "$(loaded type -p camaron)"

# Into ParaView's own prefix: its list of plugins has ours, once.
for conf in "$paraview/${plugins%/*}/paraview.conf" "$paraview/bin/paraview.conf"; do
  [[ ! -e $conf ]] || break
done
if [[ -e $conf ]]; then
  copy=$folder/root$conf
  mkdir -p "${copy%/*}" && cp "$conf" "$copy"
  for _ in 1 2; do
    DESTDIR=$folder/root "$cmake" --install "$build" --prefix "$paraview" >"$folder/log" || { tail -n 5 "$folder/log"; exit 1; }
  done
  expect "times that ours is listed" 1 "$(grep -c camaron.plugins.xml "$copy")"
  expect "what was listed before" "" "$(grep -v camaron.plugins.xml "$conf" | grep -vxFf "$copy")"
  line=$(grep camaron.plugins.xml "$copy")
  expect "the file it names is there" "$folder/root$paraview/$plugins/camaron.plugins.xml" \
    "$(realpath "${copy%/*}/$line")"
  # What ParaView does with every line when it starts.
  cat >listed.py <<END
from paraview.modules.vtkRemotingCore import vtkPVPluginTracker
vtkPVPluginTracker.GetInstance().LoadPluginConfigurationXML("${copy%/*}/$line", False)
from paraview.simple import *
assert "ElementQuality" not in globals()
LoadDistributedPlugin("Camaron", ns=globals())
ElementQuality(Input=Sphere()).UpdatePipeline()
print("loaded")
END
  expect "a plugin that is listed" "loaded" "$(timeout 100 pvpython listed.py 2>&1 | tail -n 1)"
fi

exit $((failures > 0))
