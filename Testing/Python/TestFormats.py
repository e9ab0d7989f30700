# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The one table of formats: XML, README, help and choice of readers follow it."""

import importlib.util
import xml.etree.ElementTree as ElementTree

import camaron_testing
from camaron.common import formats
from paraview import servermanager

ROOT = camaron_testing.ROOT


class TestFormats(camaron_testing.TestCase):
    def hints(self, name, kind, tag):
        path = ROOT / "Readers" / name / f"{name}{kind}.xml"
        if path.read_text("utf-8").startswith("<Documentation"):  # the rest is made from the table
            return [self.made_hint(f"{name}{kind}", tag)]
        found = ElementTree.parse(path).getroot().findall(f".//{tag}[@extensions]")
        self.assertTrue(found, path.name)
        return found

    def made_hint(self, name, tag):
        """What ParaView has of a definition that is made; its label is the name with spaces."""
        manager = servermanager.ProxyManager().SMProxyManager
        proxy = manager.GetPrototypeProxy("sources", name)
        self.assertEqual(proxy.GetXMLLabel().replace(" ", ""), name)
        hint = proxy.GetHints().FindNestedElementByName(tag)
        return {key: hint.GetAttribute(key) for key in ("extensions", "file_description")}

    def test_table_and_xml(self):
        """Extensions and names are in the table and in the XML: both must agree."""
        table = formats.own_formats()
        self.assertGreaterEqual(len(table), 2)
        for f in table:
            extensions = set(f["extensions"])
            for kind, tag in (("reader", "ReaderFactory"), ("writer", "WriterFactory")):
                if not f[kind]:
                    continue
                self.assertTrue(f[kind].endswith(f["name"] + kind.capitalize()), f[kind])
                self.assertTrue(f["reads" if kind == "reader" else "writes"], f["name"])
                found = set()
                for hint in self.hints(f["name"], kind.capitalize(), tag):
                    found |= set(hint.get("extensions").split())
                    self.assertEqual(hint.get("file_description"), f["description"])
                series = {e for e in found if e.endswith(".series")}
                found -= series
                if kind == "reader":
                    read = extensions | {f"{e}.gz" for e in extensions}
                    self.assertEqual(found, read, f["name"])
                    self.assertEqual(series, {f"{e}.series" for e in read}, f["name"])
                else:
                    self.assertLessEqual(found, extensions, f["name"])

    def test_pages(self):
        """Every format has a page, and the README the table as it is made."""
        for f in formats.own_formats():
            self.assertTrue((ROOT / "Readers" / f["name"] / "README.md").exists(), f["name"])
        script = ROOT / "Documentation" / "make_formats.py"
        spec = importlib.util.spec_from_file_location("make_formats", script)
        make_formats = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(make_formats)
        page = (ROOT / "README.md").read_text(encoding="utf-8")
        self.assertEqual(page, make_formats.updated(page), "run Documentation/make_formats.py")

    def test_known_formats(self):
        """Readers and writers of one format are one entry, ours and ParaView's."""
        known = formats.known_formats()
        by_name = {f.reader: f for f in known if f.reader}
        self.assertEqual(by_name["VisfReader"].writers, ["VisfWriter"])
        self.assertTrue(by_name["VisfReader"].own)
        self.assertEqual(by_name["VisfReader"].extensions, [".visf"])
        self.assertIn("XMLUnstructuredGridWriter", by_name["XMLUnstructuredGridReader"].writers)
        self.assertFalse(by_name["XMLUnstructuredGridReader"].own)
        self.assertGreater(len(known), 50)

    def test_help(self):
        """The command accepts what its help lists."""
        command = camaron_testing.run_command("convert", "--help")
        self.assertEqual((command.returncode, command.stderr), (0, ""))
        for line in (
            "  rw  Camarón Visf mesh: .visf",
            "--encoding ascii|binary-little-endian|binary-big-endian|binary-version-0.2 (ascii)",
            "--write-neighbors on|off (off)",
            "  rw  VTK UnstructuredGrid Files: .vtu",
            "--data-mode ascii|binary|appended (appended)",
        ):
            self.assertIn(line, command.stdout)

    def test_every_option_can_be_set(self):
        """Each choice of each option of our writers, as the help spells it."""
        for f in formats.own_formats():
            if not f["writer"]:
                continue
            writer = formats.make_writer(f["writer"])
            self.assertTrue(formats.options(writer), f["writer"])
            for option in formats.options(writer).values():
                for choice in option.choices:
                    formats.set_option(writer, option.flag, choice)
                    self.assertEqual(
                        formats.options(writer)[formats.plain(option.key)].default, choice
                    )
                self.assertGreater(len(option.text), 10)

    def test_readers_by_name(self):
        self.assertEqual(formats.own_readers("some/where/x.VISF"), ["VisfReader"])
        self.assertEqual(formats.own_readers("x.vtu"), [])
        self.assertEqual(formats.own_writer("some/where/x.visf"), "VisfWriter")
        self.assertIsNone(formats.own_writer("x.vtu"))


if __name__ == "__main__":
    camaron_testing.main()
