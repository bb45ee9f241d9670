"""runmark dictionaries: what it lists, in which formats, and what it refuses."""

import json
import pathlib
import subprocess
import unittest

from command import PROGRAM, SOURCE, CommandTest


class Dictionaries(CommandTest):
    def list(self, *arguments):
        result = self.run_program("dictionaries", *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        return result.stdout.decode()

    def test_text(self):
        lines = self.list().splitlines()
        rows = {line.split()[0]: line.split()[1:7] for line in lines}
        self.assertEqual(rows["name"], ["codes", "cells", "border", "bits", "distance", "corrected"])
        self.assertEqual(rows["tag36h11"], ["587", "8x8", "black", "36", "11", "2"])
        self.assertEqual(rows["DICT_4X4_1000"], ["1,000", "6x6", "black", "16", "2", "0"])
        self.assertEqual(rows["tagStandard41h12"], ["2,115", "5x5", "reversed", "41", "12", "3"])
        self.assertEqual(len({len(line) for line in lines}), 1)

    def test_json_and_the_rules_it_must_show(self):
        found = {one["name"]: one for one in json.loads(self.list("--format", "json"))}
        self.assertEqual(found["tagCustom48h12"]["codes"], 42211)
        for one in found.values():
            self.assertLess(one["lookup_bytes"], 4 << 20, one)
            if one["corrected_bits"] > 0:
                self.assertLessEqual(one["accepted_share"], 1 / 4096, one)
                self.assertLess(2 * one["corrected_bits"], one["distance"], one)

    def test_a_file_of_ones_own(self):
        path = pathlib.Path(self.path("mine.codes"))
        path.write_text("4 1\n5867\n8b03\n")
        row = self.list(path).splitlines()[1].split()
        self.assertEqual(row[:7], ["mine", "2", "6x6", "black", "16", "8", "1"])
        path.write_text("4 1\n5867\nspam\n")
        self.expect_error(self.run_program("dictionaries", path), f"{path}, line 3: 'spam'")

    def test_close_names(self):
        self.expect_error(self.run_program("dictionaries", "tag3611"), "'tag3611'; did you mean tag36h11,")

    def test_format(self):
        self.expect_error(self.run_program("dictionaries", "--format", "xml"), "--format", "xml")

    def test_the_page_is_up_to_date(self):
        script = SOURCE / "scripts/write-dictionary-table"
        subprocess.run(["bash", script, "--check", PROGRAM], check=True)


if __name__ == "__main__":
    unittest.main()
