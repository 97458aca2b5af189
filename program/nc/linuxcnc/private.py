# SPDX-License-Identifier: MIT
"""Private files for LinuxCNC's interpreter, and the remaps by which it tells what its preview does
not hand on: outputs, synchronizations, and the line of a remapped code."""
import ctypes
import os
import re
import shutil

OK, ERROR = 0, 5  # what a remap returns
SHARED = {}       # the Canon, for join_remaps(), which LinuxCNC's Python calls

# What LinuxCNC's Python calls for a remapped M66, M67, M68.
REMAPS = '''
def sepax_prolog(self, **words):
    canon.remapped(self.call_level, int(words.get("n", 0)))
    return OK

def sepax_m66(self, **words):
    self.params[5399] = 0.0
    canon.synchronize(int(words["n"]), words)
    return OK

def sepax_output(self, **words):
    if "e" not in words or "q" not in words:
        self.set_errormsg("M67 and M68 need E and Q")
        return ERROR
    pin = "_hal[motion.switchkins-type]"
    try:
        canon.output(int(words["n"]), int(words["e"]), words["q"])
    except Exception as bad:
        canon.failure = canon.failure or str(bad)
        self.set_errormsg(str(bad))
        return ERROR
    if int(words["e"]) == canon.job.switch_output and canon.job.hal_pins:
        self.params[pin] = float(canon.kind)
    return OK
'''


def with_line(remap):
    """A REMAP= of the ini whose line in the program the front end gets to know (argspec N)."""
    if not re.match(r"\s*REMAP\s*=\s*[GgMm]\d.*ngc=", remap) or "prolog=" in remap:
        return remap
    given = re.search(r"argspec=(\S*)", remap)
    if given is None:
        remap += " argspec=N"
    elif "N" not in given.group(1):
        remap = remap.replace(given.group(0), given.group(0) + "N")
    return remap + " prolog=sepax_prolog"


def private_ini(job):
    """The ini for the interpreter: without HAL, with our remaps, with folders that do not depend
    on HOME. HAL pins become named parameters of the same name."""
    ini = job.ini
    job.hal_pins = (ini.get("RS274NGC", "HAL_PIN_VARS") or "0").split("#")[0].strip() == "1"
    taken = [v.split()[0].upper() for v in ini.all("RS274NGC", "REMAP") if v.split()]
    for code in ("M66", "M67", "M68"):
        if code in taken:
            raise Refusal(f"{ini.path}: [RS274NGC]REMAP={code} is not supported, because the front "
                          f"end remaps it")
    ours = {
        "[RS274NGC]": ["HAL_PIN_VARS = 0",
                       "REMAP = M66 modalgroup=10 argspec=pelqN python=sepax_m66",
                       "REMAP = M67 modalgroup=10 argspec=eqN python=sepax_output",
                       "REMAP = M68 modalgroup=10 argspec=eqN python=sepax_output"],
        "[PYTHON]": [f"TOPLEVEL = {job.folder}/toplevel.py"]}
    lines, home = [], os.path.expanduser("~")
    for _, line in ini.lines:
        name = line.split("=")[0].strip()
        if name in ("HAL_PIN_VARS", "PARAMETER_FILE", "TOPLEVEL", "LOG_FILE"):
            continue
        if name == "REMAP":
            line = with_line(line)
        lines.append(re.sub(r"([=:]\s*)~/", lambda m: m.group(1) + home + "/", line))
        # LinuxCNC reads only the first section of a name.
        lines += ours.pop(line.strip(), [])
    for section, entries in ours.items():
        lines += [section] + entries
    path = os.path.join(job.folder, "private.ini")
    with open(path, "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")
    toplevel = ini.get("PYTHON", "TOPLEVEL")
    with open(os.path.join(job.folder, "toplevel.py"), "w", encoding="utf-8") as out:
        out.write("import sys, types\n")
        if toplevel:
            theirs = os.path.join(ini.folder, os.path.expanduser(toplevel))
            out.write(f"exec(compile(open({theirs!r}).read(), {theirs!r}, 'exec'))\n")
        out.write("remap = sys.modules.setdefault('remap', types.ModuleType('remap'))\n"
                  "sys.modules['__main__'].join_remaps(remap)\n")
    return path


def join_remaps(module):
    """Puts our remaps beside those of the configuration."""
    module.__dict__.update(canon=SHARED["canon"], OK=OK, ERROR=ERROR)
    exec(REMAPS, module.__dict__)  # pylint: disable=exec-used


def attach_tools(job):
    """The map of the tool table that LinuxCNC's interpreter looks a T word up in."""
    path = os.path.join(job.folder, "table")
    with open(path, "w", encoding="utf-8") as out:
        for tool in job.tools:
            out.write(f"T{tool.number} P{tool.pocket}\n")
    library = ctypes.CDLL("libtooldata.so.0")
    library._Z17tool_mmap_creatorPK13EMC_TOOL_STATi(ctypes.create_string_buffer(1 << 20), 0)
    library._Z13tooldata_initb(ctypes.c_bool(False))
    if library._Z13tooldata_loadPKcPPc(path.encode(), None):
        raise Refusal("linuxcnc: the tool table cannot be handed to LinuxCNC")


def prepare(job):
    """Private files; the environment of the interpreter."""
    job.parameter_file = os.path.join(job.folder, "parameters")
    name = job.ini.get("RS274NGC", "PARAMETER_FILE")
    theirs = os.path.join(job.ini.folder, os.path.expanduser(name)) if name else ""
    if os.path.isfile(theirs):
        shutil.copyfile(theirs, job.parameter_file)
    else:
        open(job.parameter_file, "w", encoding="utf-8").close()
    program = os.path.abspath(job.program)
    os.environ["INI_FILE_NAME"] = private_ini(job)
    os.environ["HOME"] = job.folder
    attach_tools(job)
    os.chdir(job.ini.folder)
    return program


def first_codes(job):
    """What is executed before the program: LinuxCNC's defaults, the ini's startup code, the pins of
    HAL that are known."""
    codes = ["G21" if job.machine.scale == 1.0 else "G20", "G64"]
    startup = job.ini.get("RS274NGC", "RS274NGC_STARTUP_CODE")
    if startup:
        codes.append(startup.split("#")[0])
        codes.append("G64")  # LinuxCNC 2.9 forgets G61 and G64 P of this code at an emergency stop
    if job.hal_pins:
        codes.append("#<_hal[motion.switchkins-type]> = 0")
        for name, (value, times) in job.parameters.items():
            if not times:
                value /= job.machine.scale
                codes.append(f"#<_hal[{job.machine.kins}.{name}]> = {value:.17f}")
    return codes + [f"({START})"]
