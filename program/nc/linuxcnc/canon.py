# SPDX-License-Identifier: MIT
"""What LinuxCNC's interpreter calls back, as records of canonical motion: every position with all
offsets applied. `interpreter.this` shows the state of the interpreter while it calls."""
import math
import re
import time

START = "sepax: start"  # a comment that the front end executes before the program
SPLINES = (50, 51, 52, 53)
SPINDLE = (330, 331, 760)  # G33, G33.1, G76: the spindle drives the feed


class Canon:
    """Receives the calls of gcode.parse(). `out` gets the records."""

    def __init__(self, job):
        self.job = job
        self.machine, self.kinematics = job.machine, job.kinematics
        self.parameter_file = job.parameter_file
        self.out = job.out
        self.rows = [NO_TOOL] + [t.row() for t in job.tools]
        self.files = {job.program: 0}  # the program has two names: as given, and with its folder
        self.file_count = 1
        self.stack = []           # (file, line) of the call of each subroutine that runs
        self.remaps = {}          # level of calls: line of a remapped code that called
        self.place = (0, 0)
        self.line = 0             # of the motion; cutter compensation hands it on later
        self.recording = False
        self.failure = None       # why the program is refused
        self.moves = 0
        self.messages = []        # since the last motion
        self.offset = [0.0] * 9   # tool offset, mm
        self.g5x, self.g92 = [0.0] * 9, [0.0] * 9
        self.cosine, self.sine = 1.0, 0.0
        self.plane = 1
        self.kind = 0             # type of the kinematics
        self.unsynchronized = None
        self.feed = False         # a feed rate is set
        self.spindle, self.blend = None, None
        self.blend_raw = None
        self.at = job.start
        self.deadline = time.monotonic() + job.seconds

    # --- where -------------------------------------------------------------------------------

    def _this(self):
        import interpreter  # there only after gcode.parse() began
        return interpreter.this

    def _file(self, path):
        if not path:
            return 0
        if path not in self.files:
            self.files[path] = self.file_count
            self.file_count += 1
            self.out(f"file {self.files[path]} {path}")
        return self.files[path]

    def where(self, this):
        """FILE LINE of what is executed now. Motion that cutter compensation held back is of an
        earlier line: its file is known only if the program has no other file."""
        file = self._file(this.filename)
        if self.line != this.sequence_number and this.sequence_number and self.file_count > 1:
            file = -1
        self.stack = [(this.sub_context[i].filename,
                       this.sub_context[i].sequence_number or self.remaps.get(i, 0))
                      for i in range(this.call_level)]
        self.place = (file, self.line)
        return f"{file} {self.line}"

    def fail(self, text):
        """Refuses the program at the line that is executed."""
        this = self._this()
        self.line = this.sequence_number or self.line
        self.where(this)
        self.failure = self.failure or f"{self.told()}: {text}"
        raise Refusal(self.failure)

    def name(self, file):
        """The path of a file, as the user gave it where it is the program."""
        if file == 0:
            return self.job.program
        return next((path for path, number in self.files.items() if number == file), "a subroutine")

    def told(self):
        """The place for a message: the program's own line first, then that in a subroutine."""
        file, line = self.place
        inner = f"{self.name(file)}:{line}"
        if self.stack and self._file(self.stack[0][0]) == 0:
            return f"{self.job.program}:{self.stack[0][1]}: in a subroutine, {inner}"
        return inner

    def next_line(self, state):
        if state.sequence_number >= 0:  # not in a motion of the control's own, such as a quill's
            self.line = state.sequence_number
        self.job.last[:8] = self.line.to_bytes(8, "little")

    def check_abort(self):
        if time.monotonic() > self.deadline:
            self.fail(f"the program runs longer than {self.job.seconds:g} s in the interpreter, "
                      f"perhaps in an endless loop; --control=seconds=N gives it more")
        return False

    # --- positions ---------------------------------------------------------------------------

    def _scaled(self, values):
        """The interpreter's inches as mm; angles stay."""
        return [v * INCH if i in LENGTHS else v for i, v in enumerate(values)]

    def to_machine(self, values):
        """Position of the program (inches, degrees) -> position of the axes (mm, degrees)."""
        p = [v + g for v, g in zip(self._scaled(values), self.g92)]
        x, y = p[0], p[1]
        p[0], p[1] = x * self.cosine - y * self.sine, x * self.sine + y * self.cosine
        return [v + g + t for v, g, t in zip(p, self.g5x, self.offset)]

    def to_program(self, axes):
        """The reverse, in mm and degrees."""
        p = [v - g - t for v, g, t in zip(axes, self.g5x, self.offset)]
        x, y = p[0], p[1]
        p[0], p[1] = x * self.cosine + y * self.sine, y * self.cosine - x * self.sine
        return [v - g for v, g in zip(p, self.g92)]

    def tell(self, axes):
        """Tells the interpreter where the axes are, as the machine does at a synchronization."""
        this = self._this()
        unit = 1.0 if this.length_units == 2 else 1.0 / INCH
        names = ("current_x", "current_y", "current_z", "AA_current", "BB_current", "CC_current",
                 "u_current", "v_current", "w_current")
        for i, value in enumerate(self.to_program(axes)):
            setattr(this, names[i], value * unit if i in LENGTHS else value)
        self.at = list(axes)

    def values(self):
        """The parameters of the kinematics with the tool offset in force."""
        return {n: c + times * self.offset[2] for n, (c, times) in self.job.parameters.items()}

    # --- state before a motion ---------------------------------------------------------------

    def _state(self, this, where):
        """Says what changed since the last motion: the spindle, the path mode, the tool. The codes
        of the line that runs count first, because the interpreter's state is that of the line
        before."""
        if not self.recording:
            return
        block = this.blocks[0]
        held = self.line != this.sequence_number
        self._spindle(this, block, where, held)
        self._blend(this, block, where)
        if block.motion_to_be in SPLINES:
            self.fail("splines (G5, G5.1, G5.2) are not supported, because LinuxCNC's preview only "
                      "approaches them")
        if block.m_modes[6] == 61:
            self._change_number(this)
        if self.unsynchronized is not None:
            self.fail("the kinematics was switched in line %d, and nothing synchronizes after it "
                      "(M66 E0 L0)" % self.unsynchronized)

    def _spindle(self, this, block, where, held):
        code = block.m_modes[7]
        if code < 0:
            code = this.active_m_codes[2]
            if block.m_modes[6] == 6 and not this.tool_change_with_spindle_on:
                code = 5
        speed = block.s_number if block.s_flag else this.active_settings[2]
        turns = "on" if code in (3, 4) and speed > 0 else "off"
        if turns == self.spindle:
            return
        if held and self.spindle is not None:
            if self._codes_between(self.line, this.sequence_number):
                return  # the motion came before
            self.fail("the spindle starts or stops while cutter compensation holds motion back")
        self.spindle = turns
        self.out(f"spindle {where} {turns}")

    def _codes_between(self, first, last):
        """Whether a line of the program after FIRST and before LAST has M3, M4 or M5."""
        lines = self.job.text.splitlines()[first:last - 1]
        return any(re.search(r"M0*[345](?![0-9.])", bare(text)) for text in lines)

    def _blend(self, this, block, where):
        """G61, G64. Where the program may change units, the interpreter shows P = Q = 0.1 after a
        change, whatever is in force; and it never shows the unit of P. Then the worst counts."""
        settings = this.active_settings
        mode, p, q = this.active_g_codes[11], settings[3], settings[4]
        here = block.g_modes[13] >= 0
        if here:
            mode = block.g_modes[13]
            p = block.p_number if block.p_flag else 0.0
            q = block.q_number if block.q_flag else p
        if (mode, p, q) == self.blend_raw:
            return
        self.blend_raw = (mode, p, q)
        unsure = self.job.changes_units and not here
        unit = INCH if unsure or this.length_units != 2 else 1.0
        within = 0.0 if mode in (610, 611) else (p + q) * unit if p > 0 else math.inf
        if unsure and (p, q) == (0.1, 0.1) and within:
            within = max(within, self.blend or 0.0)
        if within != self.blend:
            self.blend = within
            said = {0.0: "exact", math.inf: "unbounded"}.get(within, f"within {within!r}")
            self.out(f"blend {where} {said}")

    # --- motion ------------------------------------------------------------------------------

    def _move(self, kind, axes):
        this = self._this()
        where = self.where(this)
        self._state(this, where)
        self.at = axes
        if self.recording:
            self.moves += 1
            self.messages = []
            self.out(f"move {kind} {where} {numbers(axes)}")

    def straight_traverse(self, *values):
        self._move("rapid", self.to_machine(values))

    def straight_feed(self, *values):
        self._need_feed()
        self._move("feed", self.to_machine(values))

    def _need_feed(self):
        """The control refuses a feed before any F; gcode.parse() does not."""
        if not self.feed and self._this().motion_mode not in SPINDLE:
            self.fail("a feed before any F word: the control has no feed rate")

    def straight_probe(self, *values):
        self._move("probe", self.to_machine(values))

    def rigid_tap(self, x, y, z):
        """Down and up again; the other axes stay."""
        back = self.at
        down = self.to_machine([x, y, z] + [0.0] * 6)
        self._move("feed", down[:3] + list(back[3:]))
        self._move("feed", back)

    def set_plane(self, plane):
        self.plane = plane

    def arc_feed(self, first, second, first_centre, second_centre, turns, along, *rest):
        self._need_feed()
        order = {1: (0, 1, 2), 2: (1, 2, 0), 3: (2, 0, 1)}[self.plane]
        end, centre, normal = [0.0] * 9, [0.0] * 9, [0.0] * 3
        end[3:] = rest
        for values, given in ((end, (first, second, along)),
                              (centre, (first_centre, second_centre, along))):
            for axis, value in zip(order, given):
                values[axis] = value
        normal[order[2]] = 1.0 if turns > 0 else -1.0
        x, y, z = normal
        normal = [x * self.cosine - y * self.sine, x * self.sine + y * self.cosine, z]
        this = self._this()
        where = self.where(this)
        self._state(this, where)
        self.at = self.to_machine(end)
        if self.recording:
            self.moves += 1
            middle = self.to_machine(centre)[:3]
            self.out(f"arc feed {where} {numbers(self.at)} {numbers(middle)} {numbers(normal)} "
                     f"{abs(turns) - 1}")

    def dwell(self, seconds):
        if self.recording:
            self.out(f"dwell {self.where(self._this())} {float(seconds)!r}")

    # --- offsets and tools -------------------------------------------------------------------

    def set_g5x_offset(self, _index, *values):
        self.g5x = self._scaled(values)
        self.where(self._this())

    def set_g92_offset(self, *values):
        self.g92 = self._scaled(values)

    def set_xy_rotation(self, degrees):
        self.cosine = math.cos(math.radians(degrees)) if degrees else 1.0
        self.sine = math.sin(math.radians(degrees)) if degrees else 0.0

    def tool_offset(self, *values):
        new = self._scaled(values)
        if new != self.offset:
            self.offset = new
            self.out(f"length {self.where(self._this())} {numbers(new)}")

    def get_tool(self, index):
        """Asked for each pocket at the start and after each M6. The interpreter has then taken its
        position from LinuxCNC's preview, which does not know all of it."""
        if index == 0 and self.recording:
            self.tell(self.at)
            self._take_table(self._this())
            self._change_number(self._this())
        return self.rows[index] if index < len(self.rows) else NO_TOOL

    def _change_number(self, this):
        """M61 says that another tool is in the spindle, and LinuxCNC's preview passes it over."""
        row = self.rows[this.current_pocket] if this.current_pocket else NO_TOOL
        if row[0] != self.rows[0][0]:
            self.line = this.sequence_number
            self._load(row, self.where(this))

    def _take_table(self, this):
        """G10 L1, L10 and L11 change the table of the interpreter, which asks for it anew now."""
        for index in range(1, len(self.rows)):
            told = this.tool_table[index]
            o, t = told.offset, told.offset.tran
            row = (told.toolno, t.x, t.y, t.z, o.a, o.b, o.c, o.u, o.v, o.w, told.diameter,
                   told.frontangle, told.backangle, told.orientation)
            if row != self.rows[index]:
                self.out(f"note {self.where(this)} G10 changed tool {told.toolno}: the offset is "
                         f"followed, the diameter of the table stays")
                if self.rows[0][0] == row[0]:
                    self.rows[0] = row
                self.rows[index] = row

    def _load(self, row, where):
        self.rows[0] = row
        self.out(f"load {where} {max(row[0], 0)}")

    def change_tool(self, index):
        """M6: to the position of the change, where the configuration has one, and the tool."""
        where = self.where(self._this())
        self._state(self._this(), where)
        if self.job.change_position:
            axes = list(self.at)
            axes[:len(self.job.change_position)] = self.job.change_position
            self._move("rapid", axes)
            self.tell(axes)
        self.unsynchronized = None
        self._load(self.rows[index] if index else NO_TOOL, where)

    # --- kinematics, remapped from M66, M67 and M68 -------------------------------------------

    def output(self, line, index, value):
        """M67 or M68 in a line: an analog output; one of them may switch the kinematics."""
        self.line = line
        if not self.kinematics.switchable:
            return
        if self.job.switch_output is None and "switchkins" in read_text(self._this().filename):
            self.fail("HAL connects no motion.analog-out-0N with motion.switchkins-type, so the "
                      "kinematics does not switch")
        if index != self.job.switch_output:
            return
        kind = int(value)
        if kind not in (0, 1):
            self.fail(f"kinematics of type {kind} is the user's own: not supported")
        if kind == self.kind:
            return
        joints = self.kinematics.joints(self.kind, self.at, self.values())
        axes = self.kinematics.axes(kind, joints, self.values(), self.at)
        self.kind = kind
        where = self.where(self._this())
        if self.stack and self._file(self.stack[0][0]) == 0:
            where = f"0 {self.stack[0][1]}"  # the line with M428, rather than M68 in its remap
        self.out(f"kins {where} {kind} {numbers(axes)}")
        self.tell(axes)
        self.unsynchronized = line

    def remapped(self, level, line):
        """A code that the configuration remaps calls a subroutine."""
        self.remaps[level - 1] = line

    def synchronize(self, line, words):
        """M66: the program waits for the machine and takes its position. Its usual form for that
        is E0 L0; any other asks for an input."""
        self.unsynchronized = None
        if "p" in words or words.get("e", 0) or words.get("l", 0):
            self.line = line
            self.out(f"note {self.where(self._this())} M66: the input is taken for 0")

    # --- texts -------------------------------------------------------------------------------

    def comment(self, text):
        if text.strip() == START:
            self.tell(self.job.start)
            self.recording = True

    def message(self, text):
        this = self._this()
        text = " ".join(text.split())
        self.messages.append(text)
        self.out(f"note {self.where(this)} {text}")

    def user_defined_function(self, number, p, q):
        where = self.where(self._this())
        self.out(f"note {where} M{100 + number} P{p:g} Q{q:g} is not run: what it does is unknown")

    # --- what the interpreter asks and says besides -------------------------------------------

    def set_feed_rate(self, rate):
        self.feed = self.feed or rate > 0
        self.where(self._this())

    def get_block_delete(self):
        return self.job.block_delete

    def get_axis_mask(self):
        return self.machine.axis_mask()

    def get_external_length_units(self):
        return 1.0 if self.machine.scale == 1.0 else 1.0 / INCH

    def get_external_angular_units(self):
        return 1.0

    def __getattr__(self, name):
        """A call that this version of LinuxCNC makes and the front end does not know."""
        if name.startswith("_") or not re.match(r"[a-z_]+$", name) or name == "use_move_batches":
            raise AttributeError(name)
        raise Refusal(f"LinuxCNC's interpreter calls {name}(): this version is not supported")


def numbers(values):
    return " ".join(repr(float(v)) for v in values)
