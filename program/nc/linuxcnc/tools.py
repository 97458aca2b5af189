# SPDX-License-Identifier: MIT
"""The tool table of LinuxCNC, checked line by line: LinuxCNC itself skips a line that it does not
understand, and the tool is then another one."""
import os
import re


class Tool:
    """A line of the table, in the units of the machine."""

    def __init__(self, number, pocket, words, comment):
        self.number = number
        self.pocket = pocket
        self.words = words
        self.comment = comment
        self.offset = [words.get(a, 0.0) for a in AXES]
        self.diameter = words.get("D", 0.0)

    def row(self):
        """What the interpreter asks for: number, offsets, diameter, two angles, orientation."""
        w = self.words
        return (self.number, *self.offset, self.diameter, w.get("I", 0.0), w.get("J", 0.0),
                int(w.get("Q", 0)))


NO_TOOL = (-1,) + (0.0,) * 12 + (0,)


def tool_of_line(line, where):
    """The tool of a line, or None where the line is empty or a comment."""
    text, _, comment = line.partition(";")
    words = {}
    for word in text.split():
        match = re.match(r"([TPDXYZABCUVWIJQ])([-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)$",
                         word.upper())
        if not match:
            raise Refusal(f"{where}: '{word}' is no word of a tool table (T1 P1 Z50.5 D6 ;comment)")
        if match.group(1) in words:
            raise Refusal(f"{where}: two {match.group(1)} words")
        words[match.group(1)] = float(match.group(2))
    if not words:
        return None
    if "T" not in words or "P" not in words:
        raise Refusal(f"{where}: a tool needs a T word (its number) and a P word (its pocket)")
    return Tool(int(words["T"]), int(words["P"]), words, " ".join(comment.split()))


def read_tools(path):
    """The tools of the table in its order."""
    tools = []
    seen = {}
    for number, line in enumerate(read_text(path).splitlines(), 1):
        where = f"{path}:{number}"
        tool = tool_of_line(line, where)
        if tool is None:
            continue
        if tool.number in seen:
            raise Refusal(f"{where}: tool {tool.number} is in line {seen[tool.number]}, too")
        seen[tool.number] = number
        tools.append(tool)
    if len(tools) > 999:
        raise Refusal(f"{path}: more than 999 tools")
    return tools


def check_units(path, tools, machine, said):
    """Refuses a table whose lengths look like those of the other unit. LinuxCNC takes them in the
    unit of the ini, whatever they are, and the table does not say its unit."""
    unit = "mm" if machine.scale == 1.0 else "inch"
    if said is not None:
        if said != unit:
            raise Refusal(f"{path}: the table is in {said}, and [TRAJ]LINEAR_UNITS is {unit}: "
                          f"LinuxCNC would take its lengths as {unit}; convert the table")
        return
    widths = [abs(t.diameter) for t in tools if t.diameter]
    lengths = [abs(t.offset[2]) for t in tools if t.offset[2]]
    if not widths or not lengths:
        return
    if unit == "mm" and max(widths) <= 2.0 and max(lengths) <= 15.0:
        other = "inch"
    elif unit == "inch" and min(widths) >= 3.0 and min(lengths) >= 20.0:
        other = "mm"
    else:
        return
    raise Refusal(f"{path}: the tools (diameters {min(widths):g} ... {max(widths):g}, lengths "
                  f"{min(lengths):g} ... {max(lengths):g}) look like {other}, and the machine is "
                  f"in {unit}; if they are right, say --control=table-units={unit}")


def table_path(ini, given):
    """The table that was given, or that of the ini, or None."""
    if ini.get("EMCIO", "DB_PROGRAM") and given is None:
        raise Refusal(f"{ini.path}: [EMCIO]DB_PROGRAM: tools in a data base; "
                      f"give --tool-table=FILE")
    if (ini.get("EMCIO", "RANDOM_TOOLCHANGER") or "0").split("#")[0].strip() not in ("0", ""):
        raise Refusal(f"{ini.path}: [EMCIO]RANDOM_TOOLCHANGER = 1 is not supported")
    name = ini.get("EMCIO", "TOOL_TABLE")
    if given is not None or name is None:
        return given
    path = os.path.join(ini.folder, os.path.expanduser(name))
    if not os.path.exists(path):
        raise Refusal(f"{ini.path}: [EMCIO]TOOL_TABLE = {name} is not there; "
                      f"give --tool-table=FILE")
    return path
