# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Documentation of proxies and properties in ParaView: everything has a text."""

import importlib.util
import re

import camaron_testing
from camaron.common import tables
from paraview import simple

XMLS = ("Filters/*/*.xml", "Readers/*/*.xml")


def words(element):
    documentation = element.find("Documentation")
    return "" if documentation is None else " ".join((documentation.text or "").split())


def script(name):
    """A script of Documentation/ as a module."""
    path = camaron_testing.ROOT / "Documentation" / f"{name}.py"
    specification = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


class TestDocumentation(camaron_testing.TestCase):
    def proxies(self):
        for pattern in XMLS:
            for path in sorted(camaron_testing.ROOT.glob(pattern)):
                for group in camaron_testing.definition(path).findall("ProxyGroup"):
                    for proxy in group:
                        yield path.name, group.get("name"), proxy

    def test_every_proxy_and_property(self):
        """A proxy that people see has a short and a long text, every property of it a sentence."""
        seen = 0
        for file, group, proxy in self.proxies():
            if group.startswith("internal") or group == "misc" or proxy.get("base_proxyname"):
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
        """The Python name of a proxy or property comes from its label: both are the same word.

        Readers that must be listed before ParaView's have a prefix, and keep the former name for states.
        """
        former = {
            proxy.get("base_proxyname"): proxy.get("name")
            for file, _, proxy in self.proxies()
            if proxy.get("base_proxyname") and file.endswith("Reader.xml")
        }
        for file, _, proxy in self.proxies():
            for item in [proxy, *(p for p in proxy if p.tag.endswith("Property"))]:
                if item.get("label") and item.tag != "PropertyGroup":
                    label = re.sub(r"[^A-Za-z0-9_]", "", item.get("label"))
                    self.assertEqual(label, former.get(item.get("name"), item.get("name")), file)

    def test_every_criterion_is_explained(self):
        """A row of the registry without its formula would leave a hole in the documentation."""
        notes = tables.known_notes()
        self.assertGreater(len(notes), 20)
        for name, note in notes.items():
            for key, words in note.items():
                self.assertTrue(words or key == "curved", f"{key} of {name}")

    def test_pages_are_those_of_the_registry(self):
        """Pages and pictures are generated and compared, including values of degenerate cells."""
        folder = camaron_testing.ROOT / "Documentation"
        make_criteria = script("make_criteria")
        expected = make_criteria.files()
        for path, page in expected.items():
            self.assertEqual(
                (folder / path).read_text("utf-8"), page, f"{path}: run make_criteria.py"
            )
        for part in ("criteria", "images/criteria"):
            for path in (folder / part).iterdir():
                self.assertIn(path.relative_to(folder).as_posix(), expected)

    def test_strategies_are_those_of_the_table(self):
        """The page and the tool tip of Strategy are generated and compared."""
        make_selection = script("make_selection")
        for path, update in (
            (make_selection.PAGE, make_selection.updated_page),
            (make_selection.DEFINITION, make_selection.updated_definition),
        ):
            text = path.read_text("utf-8")
            self.assertEqual(update(text), text, f"{path}: run make_selection.py")

    def test_lists_agree(self):
        """Registry, XML, properties and the Python package have the same names."""
        criteria, presets = list(tables.known_criteria()), list(tables.known_presets())
        self.assertEqual(list(tables.known_notes()), criteria)
        self.assertEqual(list(simple.ElementQuality().GetProperty("Criteria").Available), criteria)
        found = 0
        for file, _, proxy in self.proxies():
            for item in proxy.findall("StringVectorProperty[@name='Preset']"):
                names = getattr(simple, proxy.get("name"))().GetProperty("Preset").Available
                no_presets = ["Automatic", "None"] if file == "CheckQuality.xml" else names[:1]
                self.assertEqual(list(names), [*no_presets, *presets], file)
                found += 1
        self.assertGreaterEqual(found, 7)
        # Properties of Select Elements are visible for strategies that exist.
        strategies = set(simple.SelectElements().GetProperty("Strategy").Available)
        shown = {
            decorator.get("value")
            for _, _, proxy in self.proxies()
            for decorator in proxy.iter("PropertyWidgetDecorator")
            if decorator.get("property") == "Strategy"
        }
        self.assertGreater(len(shown), 10)
        self.assertLessEqual(shown, strategies)
        listed = camaron_testing.run_command("criteria").stdout
        rows = [line.split()[0] for line in listed.splitlines() if line]
        self.assertEqual(rows[1 : len(criteria) + 1], criteria)
        for preset in presets:
            self.assertIn(f"\n{preset} ", listed)


if __name__ == "__main__":
    camaron_testing.main()
