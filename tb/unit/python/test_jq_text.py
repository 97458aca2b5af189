# SPDX-License-Identifier: MIT
"""Tests of scripts/campaigns/jq_text.py: the text is the text of jq 1.6."""
from __future__ import annotations

import unittest

from loading import load

jq_text = load("scripts/campaigns/jq_text.py")

# What jq 1.6 printed of these literals.
NUMBERS = """
0 0 | 7 7 | -3 -3 | 1.0 1 | 0.10 0.1 | 2.5 2.5 | -0 -0 | 0.30000000000000004 0.30000000000000004
0.0001 0.0001 | 0.00001 1e-05 | 0.00001234 1.234e-05 | 1e-7 1e-07 | -1.25e-9 -1.25e-09
1e-300 1e-300 | 1e5 100000 | 1e15 1000000000000000 | 1e16 1e+16 | 100000000000000000000 1e+20
123456789012345678 123456789012345680 | 12345678901234567890 12345678901234567000
1.5e300 1.5e+300 | 1e999 1.7976931348623157e+308 | 1234567890.1234567 1234567890.1234567
"""


class Reading(unittest.TestCase):
    def test_several_values(self) -> None:
        self.assertEqual(jq_text.load_all('{"a": 1}\n [2] null '), [{"a": 1}, [2], None])
        self.assertEqual(jq_text.load_all(" \n"), [])

    def test_what_is_no_json(self) -> None:
        for text in ("{", "1 2", "", "NaN", "-Infinity", "[1,]", "{} x"):
            with self.assertRaises(ValueError, msg=text):
                jq_text.load(text)


class Writing(unittest.TestCase):
    def test_numbers(self) -> None:
        for pair in NUMBERS.replace("\n", "|").split("|"):
            if pair.strip():
                literal, printed = pair.split()
                self.assertEqual(jq_text.dump(jq_text.load(literal)), printed, literal)

    def test_strings(self) -> None:
        self.assertEqual(jq_text.dump('a"\\\b\f\n\r\t\x01\x7fé😀/<'),
                         '"a\\"\\\\\\b\\f\\n\\r\\t\\u0001\\u007fé😀/<"')

    def test_one_line(self) -> None:
        self.assertEqual(jq_text.dump({"b": [1, {}], "a": None, "c": [True, False]}),
                         '{"b":[1,{}],"a":null,"c":[true,false]}')

    def test_indent(self) -> None:
        self.assertEqual(jq_text.dump({"b": [], "a": [1, {"c": "d"}]}, 2),
                         '{\n  "b": [],\n  "a": [\n    1,\n    {\n      "c": "d"\n    }\n  ]\n}')


class Pages(unittest.TestCase):
    def test_grouped(self) -> None:
        for value, said in ((999, "999"), (1000, "1,000"), (387420489, "387,420,489"),
                            (1234.5, "1234.5"), (-1000, "-1000"), ("123456789012", "123456789012"),
                            (None, "null")):
            self.assertEqual(jq_text.grouped(value), said)

    def test_html(self) -> None:
        self.assertEqual(jq_text.html("<a&\"b'>"), "&lt;a&amp;&quot;b&apos;&gt;")

    def test_a_half_goes_away_from_zero(self) -> None:
        for value, nearest in ((0.5, 1), (1.5, 2), (2.5, 3), (-0.5, -1), (2.4, 2),
                               (0.49999999999999994, 0)):
            self.assertEqual(jq_text.rounded(value), nearest)


if __name__ == "__main__":
    unittest.main()
