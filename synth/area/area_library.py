# SPDX-License-Identifier: MIT
"""area_library - what synth/area/map does with a cell library and with modules of the design that
cells take the place of."""
from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Dict, List, Optional

HERE = Path(__file__).resolve().parent

# Full-adder cells: name, three inputs, sum, carry. abc does not map to cells of two outputs, so the
# adder's module is made of the cell where the library has one.
FULL_ADDERS = [line.split() for line in """
FA_X1 A B CI S CO
FAX1 A B C YS YC
sky130_fd_sc_hd__fa_1 A B CIN SUM COUT
""".strip().splitlines()]

FULL_ADDER = """module {module} #(parameter N = 8) (
  input wire [N-1:0] a, input wire [N-1:0] b, input wire [N-1:0] c,
  output wire [N-1:0] sum, output wire [N-1:0] carry
);
  genvar i;
  generate for (i = 0; i < N; i = i + 1) begin : bits
    {cell} fa (.{a}(a[i]), .{b}(b[i]), .{c}(c[i]), .{sum}(sum[i]), .{carry}(carry[i]));
  end endgenerate
endmodule
"""

# An addition as a chain of full-adder cells, for techmap, which reads $alu: Y = A + (B ^ BI) + CI,
# CO its carries, X = A ^ B ^ BI. Bits with a constant are logic, which is a half adder or less, and
# so is the highest bit, whose carry is seldom read. Short additions stay as Yosys makes them.
RIPPLE_ADDER = """(* techmap_celltype = "$alu" *)
module _80_ripple_adder (A, B, CI, BI, X, Y, CO);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  parameter _TECHMAP_CONSTMSK_A_ = 0;
  parameter _TECHMAP_CONSTMSK_B_ = 0;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  input CI, BI;
  output [Y_WIDTH-1:0] X, Y, CO;
  wire _TECHMAP_FAIL_ = Y_WIDTH <= {short};
  wire [Y_WIDTH-1:0] a, b_as_given;
  \\$pos #(.A_SIGNED(A_SIGNED), .A_WIDTH(A_WIDTH), .Y_WIDTH(Y_WIDTH)) wide_a (.A(A), .Y(a));
  \\$pos #(.A_SIGNED(B_SIGNED), .A_WIDTH(B_WIDTH), .Y_WIDTH(Y_WIDTH)) wide_b (
    .A(B), .Y(b_as_given)
  );
  wire [Y_WIDTH-1:0] b = b_as_given ^ {{Y_WIDTH{{BI}}}};
  wire [Y_WIDTH:0] carry = {{CO, CI}};
  assign X = a ^ b;
  genvar i;
  generate for (i = 0; i < Y_WIDTH; i = i + 1) begin : bits
    localparam FIXED_A = i < A_WIDTH ? _TECHMAP_CONSTMSK_A_[i]
                                     : !A_SIGNED || _TECHMAP_CONSTMSK_A_[A_WIDTH-1];
    localparam FIXED_B = i < B_WIDTH ? _TECHMAP_CONSTMSK_B_[i]
                                     : !B_SIGNED || _TECHMAP_CONSTMSK_B_[B_WIDTH-1];
    if (i == 0 || i == Y_WIDTH - 1 || FIXED_A || FIXED_B) begin
      assign Y[i] = X[i] ^ carry[i];
      assign CO[i] = (a[i] & b[i]) | (X[i] & carry[i]);
    end else begin
      {cell} fa (.{a}(a[i]), .{b}(b[i]), .{c}(carry[i]), .{sum}(Y[i]), .{carry}(CO[i]));
    end
  end endgenerate
endmodule
"""
SHORT_ADDER = 4  # bits


PREFIX = ["sepax"]  # of the design's modules


def set_prefix(prefix: str) -> None:
    """From now on modules of a class have this prefix in place of sepax."""
    PREFIX[0] = prefix


def of_class(name: str) -> List[str]:
    """The modules of a class of synth/area/modules, with the design's prefix."""
    rows = [line.split() for line in (HERE / "modules").read_text().splitlines()
            if not line.startswith("#")]
    return [PREFIX[0] + row[0][len("sepax"):] for row in rows if row[1:2] == [name]]


def of_class_one(name: str) -> str:
    """The module of a class that has only one."""
    [module] = of_class(name)
    return module


def sizes(lef: str) -> Dict[str, str]:
    """The area of each cell of a LEF file, as Liberty writes it."""
    found, name = {}, ""
    for line in lef.splitlines():
        words = line.split()
        if words[:1] == ["MACRO"]:
            name = words[1]
        elif words[:1] == ["SIZE"]:
            area = float(words[1]) * float(words[3])
            found[name] = f"{area:.0f}" if area == int(area) else f"{area:.6g}"
    return found


def fill_areas(liberty: str, lef: str) -> str:
    """Liberty text in which a cell of area 0, as osu018's latch, has the area that the LEF file
    gives it."""
    size, name, lines = sizes(lef), "", []
    for line in liberty.split("\n"):
        cell = re.match(r" *cell *\( *([A-Za-z0-9_]+)", line)
        if cell:
            name = cell[1]
        if name in size and re.match(r" *area *: *0(\.0*)? *;", line):
            line = re.sub(r":.*", f": {size[name]};", line, count=1)
        lines.append(line)
    return "\n".join(lines)


def smallest_nand(cells: Dict[str, Any], wanted: str) -> Optional[str]:
    """The cell that is one GE: the cell of the wanted name, or else the smallest whose name says
    NAND2 or ND2; None if the library has none."""
    def fits(name: str) -> bool:
        if wanted:
            return name == wanted
        return re.search("nand2|(^|[^a])nd2", name.lower()) is not None

    found = [name for name, cell in cells.items() if (cell.get("area") or 0) > 0 and fits(name)]
    return min(found, key=lambda name: cells[name]["area"], default=None)


def full_adder(cells: Dict[str, Any]) -> str:
    """The adder's module, made of the library's full-adder cell; empty if there is none."""
    for cell, a, b, c, total, carry in FULL_ADDERS:
        if cell in cells:
            return FULL_ADDER.format(module=of_class_one("adder"), cell=cell, a=a, b=b, c=c,
                                     sum=total, carry=carry)
    return ""


def modules_of(verilog: str) -> List[str]:
    """The modules that a Verilog text declares."""
    return re.findall(r"^ *module  *([A-Za-z0-9_]*)", verilog, re.M)


def renamed(rtlil: str, plain: Dict[str, str]) -> str:
    """RTLIL whose modules have plain names. `plain` has the plain name of each module. Modules that
    get the same name are one: a module with its default parameters and a module with the same
    values given are the same."""
    name_of = {**plain, **{"\\" + name: new for name, new in plain.items()}}
    seen, again, lines = set(), False, []
    for line in rtlil.split("\n"):
        words = line.split(None, 3) if line.lstrip().startswith(("module ", "cell ")) else []
        if words and words[0] == "module" and words[1] in name_of:
            name = name_of[words[1]]
            again = name in seen
            seen.add(name)
            line = "module \\" + name
        if again:
            again = line != "end"
        elif words and words[0] == "cell" and words[1] in name_of:
            lines.append(f"  cell \\{name_of[words[1]]} {words[2]}")
        else:
            lines.append(line)
    return "\n".join(lines)


def ripple_adder(cells: Dict[str, Any]) -> str:
    """An addition made of the library's full-adder cell, for techmap; empty if there is none."""
    for cell, a, b, c, total, carry in FULL_ADDERS:
        if cell in cells:
            return RIPPLE_ADDER.format(short=SHORT_ADDER, cell=cell, a=a, b=b, c=c, sum=total,
                                       carry=carry)
    return ""
