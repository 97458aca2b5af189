# SPDX-License-Identifier: MIT
"""area_multipliers - generated multipliers for synth/area/map, in place of Verilog's * in products
of the architectures paper and conference."""
from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import List, Tuple

from common import Failed, Object

HEAD = """module @name@ #(
  parameter A_W = 18, parameter B_W = 38, parameter FULL_W = 56, parameter P_W = 56
) (input wire signed [A_W-1:0] a, input wire signed [B_W-1:0] b, output wire signed [P_W-1:0] p);
  wire [FULL_W-1:0] full;
  assign p = full[FULL_W-1:FULL_W-P_W];
  generate
"""
TAIL = """  endgenerate
endmodule
"""


def sizes(described: Object) -> List[Tuple[int, int, int]]:
    """Bits of both factors and of the product, of each kind of product that sepax.json tells."""
    formats = {row["name"]: row for row in described["formats"]}
    kinds = [("vertex", "normal", "normal_product"), ("vertex", "axis", "product"),
             ("edge", "edge", "cross_product")]
    return sorted({(formats[a]["width"], formats[b]["width"], formats[product]["exact"])
                   for a, b, product in kinds})


def generate(sepax: str, described: Object, out: Path) -> None:
    """Write to `out` the module of the design's products (sepax_mul), with the ports and parameters
    of the design's own, and the multipliers that it chooses from."""
    out.mkdir(parents=True)
    product = described.get("prefix", "sepax") + "_mul"
    text = HEAD.replace("@name@", product)
    for a, b, full in sizes(described):
        wide, narrow = max(a, b), min(a, b)
        name = f"sepax_mul_{wide}x{narrow}"
        done = subprocess.run([sepax, "multiplier", "-a", str(wide), "-b", str(narrow), "-p",
                               str(full), "-o", str(out / name)], stdout=subprocess.DEVNULL,
                              check=False)
        if done.returncode != 0:
            raise Failed(f"no multipliers; is {sepax} the program?")
        for file in [out / name / "sepax_fa.v", *(out / name).glob("sepax_*digit.v")]:
            shutil.copy(file, out)
        first, second = ("b", "a") if a < b else ("a", "b")
        text += (f"    if (A_W == {a} && B_W == {b} && FULL_W == {full}) begin : m_{a}_{b}_{full}\n"
                 f"      {name} of (.a({first}), .b({second}), .p(full));\n    end\n")
    (out / f"{product}.v").write_text(text + TAIL)
