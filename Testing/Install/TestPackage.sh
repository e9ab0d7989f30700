#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
#
# TestPackage.sh CPACK BUILD: the Debian package has everything, nothing of this machine, and its scripts list the plugin
# in ParaView's paraview.conf once and remove it. Exits with 77 where there is no Debian.
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
expect "dependency on ParaView" 2 "$(grep Depends DEBIAN/control | grep -o 'paraview ([<>]' | wc -l)"

# The scripts, for a copy of paraview.conf.
conf=$folder/paraview.conf
printf 'plugins/paraview.plugins.xml\n/usr/share/paraview/plugins\n' >"$conf"
cp "$conf" "$folder/before"
for script in postinst prerm; do
  sed -i "s|^conf=.*|conf=$conf|; s|^find [^ ]*|find $folder/root|" "DEBIAN/$script"
done
sh DEBIAN/postinst configure && sh DEBIAN/postinst triggered
expect "lines for the plugin" 1 "$(grep -c '^plugins/camaron.plugins.xml$' "$conf")"
sh DEBIAN/prerm upgrade
expect "lines during an upgrade" 1 "$(grep -c '^plugins/camaron.plugins.xml$' "$conf")"
sh DEBIAN/prerm remove
expect "paraview.conf afterwards" "$(cat "$folder/before")" "$(cat "$conf")"
((failures == 0))
