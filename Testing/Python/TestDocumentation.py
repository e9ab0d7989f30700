# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""What people read about proxies and properties in ParaView: nothing is left without a word."""

import re
import xml.etree.ElementTree as ElementTree

import camaron_testing
from paraview import simple

XMLS = ("Filters/*.xml", "Formats/*/*.xml")


def words(element):
    documentation = element.find("Documentation")
    return "" if documentation is None else " ".join((documentation.text or "").split())


class TestDocumentation(camaron_testing.TestCase):
    def proxies(self):
        for pattern in XMLS:
            for path in sorted(camaron_testing.ROOT.glob(pattern)):
                for group in ElementTree.parse(path).getroot().findall("ProxyGroup"):
                    for proxy in group:
                        yield path.name, group.get("name"), proxy

    def test_every_proxy_and_property(self):
        """A proxy that people see has a short and a long text, every property of it a sentence."""
        seen = 0
        for file, group, proxy in self.proxies():
            if group.startswith("internal") or group == "misc":
                continue
            seen += 1
            documentation = proxy.find("Documentation")
            self.assertIsNotNone(documentation, file)
            self.assertTrue(documentation.get("short_help"), file)
            self.assertGreater(len(words(proxy)), 40, file)
            for item in proxy:
                if not item.tag.endswith("Property") or item.get("information_only"):
                    continue
                self.assertGreater(len(words(item)), 10, f"{file}: {item.get('name')}")
        self.assertGreater(seen, 5)

    def test_names_are_labels_without_spaces(self):
        """The Python name of a proxy or property comes from its label: both are the same word."""
        for file, _, proxy in self.proxies():
            for item in [proxy, *(p for p in proxy if p.tag.endswith("Property"))]:
                if item.get("label") and item.tag != "PropertyGroup":
                    label = re.sub(r"[^A-Za-z0-9_]", "", item.get("label"))
                    self.assertEqual(label, item.get("name"), file)

    def test_criteria_in_the_documentation(self):
        """The page of the criteria has a section row for each, with its unit."""
        page = (camaron_testing.ROOT / "Documentation" / "criteria.md").read_text()
        table = self.fetch(simple.CriteriaTable())
        names, units = table.GetColumnByName("Name"), table.GetColumnByName("Unit")
        self.assertGreater(table.GetNumberOfRows(), 20)
        for row in range(table.GetNumberOfRows()):
            name, unit = names.GetValue(row), units.GetValue(row)
            self.assertRegex(page, rf"\| `{name}` \|.*\| {unit or '-'} \|")


if __name__ == "__main__":
    camaron_testing.main()
