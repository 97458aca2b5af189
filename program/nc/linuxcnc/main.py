# SPDX-License-Identifier: MIT
"""Canonical motion of a program for LinuxCNC, on standard output; what is wrong, as one line on
standard error with status 2. docs/reference/canonical-motion.md has the format.
  MACHINE.INI PART.NGC [--tool-table=FILE] [--start=X,Y,Z,A,B,C,U,V,W]
  [--control=table-units=mm|inch] [--control=seconds=N] [--control=block-delete]
  [--control=set=PIN=VALUE]...
LinuxCNC's interpreter runs in a process of its own with a private HOME: it writes a map of the
tool table there, which is that of a machine that runs if HOME is the user's. Its parameter file
is a copy."""
import mmap
import os
import re
import shutil
import signal
import sys
import tempfile

ENDED, END_OF_FILE = 1, 3  # what the interpreter returns where it did not fail


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
        hal = Hal(self.ini, self.machine)
        self.parameters = hal.parameters(self.machine, self.given)
        self.switch_output = hal.switch_output()
        self.table = table_path(self.ini, self.table)
        self.tools = read_tools(self.table) if self.table else []
        if self.table:
            check_units(self.table, self.tools, self.machine, self.table_units)
        self.change_position = self._change_position()
        self.text = read_text(self.program)
        self._check_characters()
        self.start = self._start()
        self.changes_units = self._changes_units()
        self.folder, self.parameter_file, self.out = None, None, None
        self.last = mmap.mmap(-1, 8)  # shared with the child: the last line that began

    def _option(self, word):
        given = "--" + word[10:] if word.startswith("--control=") else word
        name, _, value = given.partition("=")
        if name == "--tool-table":
            self.table = value
        elif name == "--table-units" and value in ("mm", "inch"):
            self.table_units = value
        elif name == "--seconds":
            self.seconds = self._numbers(word, value)[0]
            if not self.seconds > 0:
                raise Refusal(f"linuxcnc: {word}: give a time above 0")
        elif name == "--block-delete":
            self.block_delete = True
        elif name == "--start":
            self.start_given = self._numbers(word, value)
        elif name == "--set" and "=" in value:
            pin, _, text = value.partition("=")
            self.given[pin] = self._numbers(word, text)[0]
        elif word.startswith("--"):
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

    def _start(self):
        """Where the axes are before the program: as --start says, else at home."""
        if self.start_given is None:
            return self._home()
        count, most = len(self.start_given), max(AXES.index(a) for a in self.machine.letters) + 1
        if not most <= count <= len(AXES):
            raise Refusal(f"linuxcnc: start: {count} numbers; give {','.join(AXES[:most])} of the "
                          f"machine in mm and degrees, 0 for axes that it does not have")
        return self.start_given + [0.0] * (len(AXES) - count)

    def _home(self):
        """Where the axes are when all joints are at HOME."""
        values = {n: c for n, (c, _) in self.parameters.items()}
        homes = [joint[-1] for joint in self.machine.joints]
        return self.kinematics.axes(0, homes, values, [0.0] * 9)

    def _check_characters(self):
        """The interpreter's Python fails on comments that are not UTF-8, without saying so."""
        with open(self.program, "rb") as file:
            for number, line in enumerate(file, 1):
                try:
                    line.decode("utf-8")
                except UnicodeDecodeError:
                    raise Refusal(f"{self.program}:{number}: a character that is not UTF-8; "
                                  f"convert the file (iconv -f latin1 -t utf-8)") from None

    def _change_position(self):
        text = self.ini.get("EMCIO", "TOOL_CHANGE_POSITION")
        if not text:
            return []
        values = [float(v) for v in text.split("#")[0].split()]
        if len(values) not in (3, 6, 9):
            raise Refusal(f"{self.ini_path}: [EMCIO]TOOL_CHANGE_POSITION has 3, 6 or 9 numbers")
        return [v * self.machine.scale if i in LENGTHS else v for i, v in enumerate(values)]

    def _changes_units(self):
        """Whether the program or a subroutine beside it may switch between mm and inches."""
        other = "20" if self.machine.scale == 1.0 else "21"
        texts = [self.text]
        for name in (self.ini.get("RS274NGC", "SUBROUTINE_PATH") or "").split(":") + [
                self.ini.get("DISPLAY", "PROGRAM_PREFIX") or "", os.path.dirname(self.program)]:
            folder = os.path.join(self.ini.folder, os.path.expanduser(name))
            for file in sorted(os.listdir(folder)) if os.path.isdir(folder) else []:
                path = os.path.join(folder, file)
                if file.endswith(".ngc") and os.path.isfile(path):
                    with open(path, encoding="utf-8", errors="replace") as text:
                        texts.append(text.read())
        code = re.compile(r"G(0*%s(?![0-9.])|[\[#])" % other)
        return any(code.search(bare(line)) for text in texts for line in text.splitlines())

    def head(self):
        """The records before the first line of the program."""
        machine = self.machine
        yield "sepax-nc 1"
        yield f"file 0 {self.program}"
        yield " ".join(["machine", machine.kins, *machine.words])
        for name, (value, times) in self.parameters.items():
            yield f"parameter {name} {value!r}" + (" z" if times else "")
        yield f"servo {machine.servo_period()!r}"
        for number, (axis, kind, low, high, fastest, _) in enumerate(machine.joints):
            yield f"joint {number} {axis} {kind} {low!r} {high!r} {fastest!r}"
        for letter, speed, fastest in machine.limits():
            yield f"limits {letter} {speed!r} {fastest!r}"
        for tool in self.tools:
            offset = [v * machine.scale if i in LENGTHS else v for i, v in enumerate(tool.offset)]
            width = tool.diameter * machine.scale
            yield (f"tool {tool.number} {tool.pocket} {width!r} {numbers(offset)} "
                   f"{tool.comment}").rstrip()
        yield f"start {'given' if self.start_given else 'home'} {numbers(self.start)}"


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
    message = f" ({'; '.join(canon.messages)})" if canon.messages else ""
    if result not in (ENDED, END_OF_FILE):
        raise Refusal(error_text(job, canon, this, gcode.strerror(result)))
    if not canon.recording:
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
    elif bare(next((text for text in lines if bare(text)), "")) != "%":
        raise Refusal(f"{job.program}:{len(lines)}: the program has no end (M2, M30 or %)")
    if canon.moves == 0:
        raise Refusal(f"{job.program}:{canon.place[1]}: the program does not move{message}")


END = re.compile(r"(?<![A-Z0-9#])M0*(2|30)(?![0-9.])")


def bare(text):
    """A line without comments and blanks, in capitals."""
    return re.sub(r"\s", "", re.sub(r"\([^)]*\)|;.*", "", text)).upper()


def error_text(job, canon, this, text):
    """The interpreter leaves its subroutines when it fails: its line is that of the outermost call.
    Where the last record came from a subroutine of that call, the message names it."""
    line = max(1, this.sequence_number)
    if not canon.recording:
        return (f"{job.ini_path}: LinuxCNC refuses what runs before the program "
                f"([RS274NGC]RS274NGC_STARTUP_CODE, REMAP, [PYTHON]): {text}")
    where = f"{job.program}:{line}"
    if canon.stack and canon.stack[0][1] == line:
        file, line = canon.place
        return f"{where}: {text}: in a subroutine, after {canon.name(file)}:{line}"
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
        line = int.from_bytes(job.last[:8], "little")
        raise Refusal(f"{job.program}:{line}: LinuxCNC's interpreter crashed or hung in this line "
                      f"or a later one (signal {os.WTERMSIG(status)}); mend the program")
    return os.WEXITSTATUS(status)


def check_interpreter():
    """One line with the cure where LinuxCNC is missing."""
    import importlib.util
    if importlib.util.find_spec("gcode") is None:
        raise Refusal("linuxcnc: LinuxCNC's interpreter (Python module gcode) is not installed; "
                      "scripts/setup cnc or apt-get install linuxcnc-uspace installs it")


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
