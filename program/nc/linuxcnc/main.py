# SPDX-License-Identifier: MIT
# Canonical motion of a program for LinuxCNC, on standard output; what is wrong, as one line on
# standard error with status 2. docs/reference/canonical-motion.md has the format.
#   MACHINE.INI PART.NGC [--table=FILE] [--table-units=mm|inch] [--seconds=N] [--block-delete]
#   [--start=X,Y,Z,A,B,C,U,V,W] [--set=PIN=VALUE]...
# LinuxCNC's interpreter runs in a process of its own with a private HOME: it writes a map of the
# tool table there, which is that of a machine that runs if HOME is the user's. Its parameter file
# is a copy.
import ctypes
import os
import re
import shutil
import signal
import sys
import tempfile

ENDED, END_OF_FILE, OK, FINISH = 1, 3, 0, 2  # what the interpreter returns


class Job:
    """A program, its machine, and the options."""

    def __init__(self, words):
        self.table, self.table_units, self.seconds, self.block_delete = None, None, 60.0, False
        self.given, self.start_given = {}, None
        files = [w for w in words if not self._option(w)]
        if len(files) != 2:
            raise Refusal("linuxcnc: needs MACHINE.INI and PART.NGC")
        self.ini_path, self.program = files
        self.ini = Ini(self.ini_path)
        self.machine = Machine(self.ini)
        self.kinematics = Kinematics(self.machine)
        hal = Hal(self.ini)
        self.parameters = hal.parameters(self.machine, self.given)
        self.switch_output = hal.switch_output()
        self.table = table_path(self.ini, self.table)
        self.tools = read_tools(self.table) if self.table else []
        if self.table:
            check_units(self.table, self.tools, self.machine, self.table_units)
        self.change_position = self._change_position()
        self.text = read_text(self.program)
        self.start = self.start_given or self._home()
        self.folder, self.parameter_file, self.out = None, None, None

    def _option(self, word):
        name, _, value = word.partition("=")
        if name == "--table":
            self.table = value
        elif name == "--table-units" and value in ("mm", "inch"):
            self.table_units = value
        elif name == "--seconds":
            self.seconds = self._numbers(word, value)[0]
        elif name == "--block-delete":
            self.block_delete = True
        elif name == "--start":
            self.start_given = (self._numbers(word, value) + [0.0] * 9)[:9]
        elif name == "--set" and "=" in value:
            pin, _, text = value.partition("=")
            self.given[pin] = self._numbers(word, text)[0]
        elif word.startswith("-"):
            raise Refusal(f"linuxcnc: '{word}' is no option")
        else:
            return False
        return True

    @staticmethod
    def _numbers(word, text):
        try:
            return [float(v) for v in text.split(",")]
        except ValueError:
            raise Refusal(f"linuxcnc: {word}: '{text}' is no number") from None

    def _home(self):
        """Where the axes are when all joints are at HOME."""
        values = {n: c for n, (c, _) in self.parameters.items()}
        homes = [home for _, _, _, _, home in self.machine.joints]
        return self.kinematics.axes(0, homes, values, [0.0] * 9)

    def _change_position(self):
        text = self.ini.get("EMCIO", "TOOL_CHANGE_POSITION")
        if not text:
            return []
        values = [float(v) for v in text.split("#")[0].split()]
        if len(values) not in (3, 6, 9):
            raise Refusal(f"{self.ini_path}: [EMCIO]TOOL_CHANGE_POSITION has 3, 6 or 9 numbers")
        return [v * self.machine.scale if i in LENGTHS else v for i, v in enumerate(values)]

    def head(self):
        """The records before the first line of the program."""
        machine = self.machine
        yield "sepax-nc 1"
        yield f"file 0 {self.program}"
        yield " ".join(["machine", machine.kins, *machine.words])
        for name, (value, times) in self.parameters.items():
            yield f"parameter {name} {value!r}" + (" z" if times else "")
        for number, (axis, kind, low, high, _) in enumerate(machine.joints):
            yield f"joint {number} {axis} {kind} {low!r} {high!r}"
        for tool in self.tools:
            offset = [v * machine.scale if i in LENGTHS else v for i, v in enumerate(tool.offset)]
            width = tool.diameter * machine.scale
            yield (f"tool {tool.number} {tool.pocket} {width!r} {numbers(offset)} "
                   f"{tool.comment}").rstrip()
        yield f"start {'given' if self.start_given else 'home'} {numbers(self.start)}"


# What LinuxCNC's Python calls for a remapped M66, M67, M68.
REMAPS = '''
def sepax_m66(self, **words):
    self.params[5399] = 0.0
    canon.synchronize()
    return OK

def sepax_output(self, **words):
    if "e" not in words or "q" not in words:
        self.set_errormsg("M67 and M68 need E and Q")
        return ERROR
    pin = "_hal[motion.switchkins-type]"
    try:
        canon.output(int(words["e"]), words["q"])
    except Exception as bad:
        canon.failure = canon.failure or str(bad)
        self.set_errormsg(str(bad))
        return ERROR
    if int(words["e"]) == canon.job.switch_output and canon.job.hal_pins:
        self.params[pin] = float(canon.kind)
    return OK
'''


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
    lines, rs274ngc = [], False
    ours = ["HAL_PIN_VARS = 0", "REMAP = M66 modalgroup=10 argspec=pelq python=sepax_m66",
            "REMAP = M67 modalgroup=10 argspec=eq python=sepax_output",
            "REMAP = M68 modalgroup=10 argspec=eq python=sepax_output"]
    home = os.path.expanduser("~")
    for _, line in ini.lines:
        name = line.split("=")[0].strip()
        if name in ("HAL_PIN_VARS", "PARAMETER_FILE", "TOPLEVEL", "LOG_FILE"):
            continue
        lines.append(re.sub(r"([=:]\s*)~/", lambda m: m.group(1) + home + "/", line))
        if line.strip() == "[RS274NGC]" and not rs274ngc:
            rs274ngc = True
            lines += ours
    if not rs274ngc:
        lines += ["[RS274NGC]"] + ours
    lines += ["[PYTHON]", f"TOPLEVEL = {job.folder}/toplevel.py"]
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
    module.__dict__.update(canon=SHARED["canon"], OK=OK, ERROR=5)
    exec(REMAPS, module.__dict__)  # pylint: disable=exec-used


SHARED = {}  # the Canon, for join_remaps(), which LinuxCNC's Python calls


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
    if job.hal_pins:
        codes.append("#<_hal[motion.switchkins-type]> = 0")
        for name, (value, times) in job.parameters.items():
            if not times:
                value /= job.machine.scale
                codes.append(f"#<_hal[{job.machine.kins}.{name}]> = {value:.17f}")
    return codes + [f"({START})"]


def interpret(job):
    """Runs the program and writes its records."""
    program = prepare(job)
    import gcode  # LinuxCNC's module
    canon = SHARED["canon"] = Canon(job)
    canon.files[program] = 0
    try:
        result, _ = gcode.parse(program, canon, first_codes(job))
    except (Refusal, RuntimeError):
        raise Refusal(canon.failure or f"{canon.told()}: LinuxCNC's interpreter failed") from None
    if canon.failure:
        raise Refusal(canon.failure)
    judge(job, canon, result, gcode)
    file, line = canon.place
    job.out(f"end {file} {line}")


def judge(job, canon, result, gcode):
    """Refuses a program that failed, has no end, ends early or does not move."""
    this = canon._this()
    message = f" ({canon.message_text})" if canon.message_text else ""
    if result not in (ENDED, END_OF_FILE, OK, FINISH):
        raise Refusal(error_text(job, canon, this, gcode.strerror(result)))
    if result == END_OF_FILE and not canon.recording:
        raise Refusal(f"{job.ini_path}: [RS274NGC]RS274NGC_STARTUP_CODE ends the program")
    lines = job.text.splitlines()
    if result == ENDED:
        file, line = canon.place
        if canon.stack or file != 0:
            raise Refusal(f"{canon.told()}: the program ends within a subroutine{message}")
        later = [n for n, text in enumerate(lines, 1) if n > line and END.search(bare(text))]
        if later:
            raise Refusal(f"{job.program}:{line}: the program ends here, before its end in line "
                          f"{later[-1]}{message}")
    elif not (lines and this.percent_flag and bare(last_line(lines)) == "%"):
        raise Refusal(f"{job.program}:{len(lines)}: the program has no end (M2, M30 or %)")
    if canon.moves == 0:
        raise Refusal(f"{job.program}:{canon.place[1]}: the program does not move{message}")


END = re.compile(r"(?<![A-Z0-9#])M0*(2|30)(?![0-9.])")


def bare(text):
    """A line without comments and blanks, in capitals."""
    return re.sub(r"\s", "", re.sub(r"\([^)]*\)|;.*", "", text)).upper()


def last_line(lines):
    return next((text for text in reversed(lines) if text.strip()), "")


def error_text(job, canon, this, text):
    """The interpreter leaves its subroutines when it fails: its line is that of the outermost call.
    Where the last record came from a subroutine of that call, the message names it."""
    line = this.sequence_number
    if not canon.recording:
        return f"{job.ini_path}: [RS274NGC]RS274NGC_STARTUP_CODE: {text}"
    where = f"{job.program}:{line}"
    if canon.stack and canon.stack[0][1] == line:
        names = {number: path for path, number in canon.files.items()}
        return f"{where}: {text}: in a subroutine, after {names[canon.place[0]]}:{canon.place[1]}"
    return f"{where}: {text}"


def guarded(method):
    """LinuxCNC drops what a callback raises; it is kept here."""
    def call(self, *words):
        try:
            return method(self, *words)
        except Refusal as refusal:
            self.failure = self.failure or str(refusal)
            raise
        except Exception as bad:
            self.failure = self.failure or f"{self.told()}: {method.__name__}: {bad!r}"
            raise
    return call


for _name in ("next_line check_abort straight_traverse straight_feed straight_probe rigid_tap "
              "set_plane arc_feed dwell set_g5x_offset set_g92_offset set_xy_rotation tool_offset "
              "get_tool change_tool comment message user_defined_function set_feed_rate").split():
    setattr(Canon, _name, guarded(getattr(Canon, _name)))


def child(job, stream, problem):
    """The interpreter's process. It writes to standard output and error as it likes; both are
    closed to it."""
    nothing = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1, 2):
        os.dup2(nothing, number)
    status = 2
    try:
        job.out = lambda record: stream.write(record + "\n")
        for record in job.head():
            job.out(record)
        interpret(job)
        stream.flush()
        status = 0
    except Refusal as refusal:
        problem.write(str(refusal).replace("\n", " ") + "\n")
    except BrokenPipeError:
        status = 3
    except Exception as bad:  # pylint: disable=broad-except
        problem.write(f"{job.program}: linuxcnc: {bad!r}\n")
    problem.flush()
    os._exit(status)


def run(job):
    """Runs the interpreter in a child, so that not even its crash goes by without a word."""
    stream = os.fdopen(os.dup(1), "w", encoding="utf-8", buffering=1 << 20)
    problem = os.fdopen(os.dup(2), "w", encoding="utf-8", errors="replace")
    process = os.fork()
    if process == 0:
        child(job, stream, problem)
    signal.signal(signal.SIGALRM, lambda *_: os.kill(process, signal.SIGKILL))
    signal.alarm(int(job.seconds) + 10)
    _, status = os.waitpid(process, 0)
    signal.alarm(0)
    if os.WIFSIGNALED(status):
        raise Refusal(f"{job.program}: LinuxCNC's interpreter crashed or hung (signal "
                      f"{os.WTERMSIG(status)})")
    return os.WEXITSTATUS(status)


def check_interpreter():
    """One line with the cure where LinuxCNC is missing."""
    import importlib.util
    if importlib.util.find_spec("gcode") is None:
        raise Refusal("linuxcnc: LinuxCNC's interpreter (Python module gcode) is not there; install "
                      "it by scripts/setup cnc, or apt-get install linuxcnc-uspace")


def main(words):
    folder = tempfile.mkdtemp(prefix="sepax-nc-")
    try:
        check_interpreter()
        job = Job(words)
        job.folder = folder
        return run(job)
    except Refusal as refusal:
        print(refusal, file=sys.stderr)
        return 2
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
