#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# TestPackage.sh CPACK BUILD: the Debian package has everything, nothing of this machine, and touches no file of another
# package. Exits with 77 where there is no Debian.
. "${BASH_SOURCE[0]%/*}/../expect.sh"

cpack=$1 build=$2
type dpkg-deb >/dev/null 2>&1 || { echo "no dpkg-deb"; exit 77; }

(cd "$build" && "$cpack" -G DEB -B "$folder") >"$folder/log" 2>&1 || { tail -n 5 "$folder/log"; exit 1; }
package=$(echo "$folder"/*.deb)
dpkg-deb -R "$package" "$folder/root" || exit 1
cd "$folder/root" || exit 1
for name in Camaron/Camaron.so Camaron/Panel/CamaronPanel.so formats.json camaron.plugins.xml camaron/__init__.py bin/camaron Documentation/inspector.md \
  Examples/flange.visf LICENSE; do
  expect "files named $name" 1 "$(find . -path "*/$name" | wc -l)"
done
expect "libraries and headers for nobody" "" "$(find . -name '*.a' -o -name '*.h' -o -name __pycache__)"
expect "paths of the build" "" "$(grep -rlF "$build" .)"
expect "dependency on ParaView" 1 "$(grep -c "^Depends: paraview (>= .*), paraview (<< " DEBIAN/control)"
expect "dependency on libraries" 1 "$(grep Depends DEBIAN/control | grep -c 'libstdc++6 (>= ')"
expect "maintainer" 1 "$(grep -c '^Maintainer: .* <.*@.*>$' DEBIAN/control)"
expect "configuration files and scripts but prerm" "" "$(find DEBIAN etc -type f 2>/dev/null | grep -Ev '/(control|md5sums|prerm)$')"
expect "plugins that ParaView is told of" 1 "$(grep -c 'name="Camaron"' usr/share/paraview/plugins)"
expect "compressed changelogs" 2 "$(find usr/share/doc/paraview-camaron -name 'changelog*.gz' | wc -l)"

# Manual pages: what --help says, for installed commands alone.
page() { gzip -cd "usr/share/man/man1/$1.1.gz"; }
for command in inspect check compare convert select criteria; do
  expect "manual page of $command" 1 "$(page camaron-$command | grep -c '^usage: camaron\|^.B camaron$\|^camaron $command')"
done
expect "commands in the manual" 1 "$(page camaron | grep -c 'inspect MESH')"
expect "commands of a clone in the manual" 0 "$(page camaron | grep -c 'fuzz FORMAT')"

if type lintian >/dev/null 2>&1; then
  expect "errors that lintian finds" "" "$(lintian --allow-root --fail-on none "$package" | grep '^E:')"
fi

mkdir -p usr/lib/python3/dist-packages/camaron/__pycache__
sed "s|^find [^ ]*|find $folder/root/usr/lib/python3/dist-packages|" DEBIAN/prerm | sh -s remove
expect "what Python compiled, afterwards" "" "$(find . -name __pycache__)"
((failures == 0))
