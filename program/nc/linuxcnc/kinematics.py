# SPDX-License-Identifier: MIT
"""Kinematics of LinuxCNC that are supported, as far as the front end needs them: what position of
the axes belongs to given joints. A switch of the kinematics keeps the joints, so the axes jump.
docs/reference/canonical-motion.md has the formulas."""
import math

# The axis letters of the joints in their order where KINEMATICS has no coordinates=.
KINEMATICS = {"trivkins": "XYZABCUVW", "xyzac-trt-kins": "XYZAC", "xyzbc-trt-kins": "XYZBC",
              "5axiskins": "XYZBCW"}
# Pins of a module, their defaults, and whether they are lengths.
PARAMETERS = {
    "trivkins": {},
    "xyzac-trt-kins": {"x-rot-point": 0.0, "y-rot-point": 0.0, "z-rot-point": 0.0,
                       "y-offset": 0.0, "z-offset": 0.0, "tool-offset": 0.0},
    "xyzbc-trt-kins": {"x-rot-point": 0.0, "y-rot-point": 0.0, "z-rot-point": 0.0,
                       "x-offset": 0.0, "z-offset": 0.0, "tool-offset": 0.0},
    "5axiskins": {"pivot-length": 250.0},
}
X, Y, Z, A, B, C, U, V, W = range(9)


def turn(angle, p, q):
    """(p, q) turned by ANGLE degrees."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return c * p - s * q, s * p + c * q


class Kinematics:
    """Axis positions and joints of one module. `values`: parameters now, with the tool's length."""

    def __init__(self, machine):
        self.name = machine.kins
        self.letters = machine.letters
        self.switchable = machine.kins != "trivkins"
        first = any(w.startswith("sparm=") and "identityfirst" in w for w in machine.words)
        self.tool_centre = {True: 1, False: 0}[first] if self.switchable else None

    def axes_of_letters(self, joints, before):
        """Identity: a letter's first joint; letters without a joint stay."""
        axes = list(before)
        for letter, value in zip(reversed(self.letters), reversed(joints)):
            axes["XYZABCUVW".index(letter)] = value
        return axes

    def joints_of_letters(self, axes):
        return [axes["XYZABCUVW".index(letter)] for letter in self.letters]

    def joints(self, kind, axes, values):
        """The joints for a position of the axes."""
        if kind != self.tool_centre:
            return self.joints_of_letters(axes)
        tip = list(axes)
        if self.name == "5axiskins":
            x, y, z = self._arm(axes, values)
            tip[:3] = axes[X] - x, axes[Y] - y, axes[Z] - z
        else:
            tip[:3] = self._table(axes, values)
        return self.joints_of_letters(tip)

    def axes(self, kind, joints, values, before):
        """The position of the axes for given joints."""
        axes = self.axes_of_letters(joints, before)
        if kind != self.tool_centre:
            return axes
        if self.name == "5axiskins":
            x, y, z = self._arm(axes, values)
            axes[:3] = axes[X] + x, axes[Y] + y, axes[Z] + z
        else:
            axes[:3] = self._table_back(axes, values)
        return axes

    @staticmethod
    def _arm(axes, values):
        pivot = values["pivot-length"]
        reach = pivot + axes[W]
        out, down = reach * math.sin(math.radians(axes[B])), reach * math.cos(math.radians(axes[B]))
        angle = math.radians(axes[C])
        return out * math.cos(angle), out * math.sin(angle), pivot - down

    def _arms(self, values):
        point = [values[n] for n in ("x-rot-point", "y-rot-point", "z-rot-point")]
        height = values["z-offset"] + values["tool-offset"]
        return point, height

    def _table(self, axes, values):
        point, height = self._arms(values)
        x, y = turn(axes[C], axes[X] - point[0], axes[Y] - point[1])
        z = axes[Z] - point[2] - height
        if self.name == "xyzac-trt-kins":
            arm = values["y-offset"]
            y, z = turn(axes[A], y - arm, z)
            y += arm
        else:
            arm = values["x-offset"]
            z, x = turn(axes[B], z, x - arm)
            x += arm
        return x + point[0], y + point[1], z + height + point[2]

    def _table_back(self, axes, values):
        point, height = self._arms(values)
        x, y, z = (axes[i] - point[i] for i in range(3))
        z -= height
        if self.name == "xyzac-trt-kins":
            arm = values["y-offset"]
            y, z = turn(-axes[A], y - arm, z)
            y += arm
        else:
            arm = values["x-offset"]
            z, x = turn(-axes[B], z, x - arm)
            x += arm
        x, y = turn(-axes[C], x, y)
        return x + point[0], y + point[1], z + height + point[2]
