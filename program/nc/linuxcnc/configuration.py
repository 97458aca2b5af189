# SPDX-License-Identifier: MIT
"""The configuration of a machine: LinuxCNC's ini file, its units, its joints."""
import os
import re

AXES = "XYZABCUVW"
LENGTHS = (0, 1, 2, 6, 7, 8)  # X Y Z U V W; the others are angles
INCH = 25.4
FAR = 1e9  # a limit that is none


class Refusal(Exception):
    """What cannot be read or is not supported: one line that names the file, the line, the cure."""


class Ini:
    """Entries of an ini file in their order; a name may come several times in a section."""

    def __init__(self, path):
        self.path = path
        self.folder = os.path.dirname(os.path.abspath(path))
        self.lines = []
        self.entries = []
        self._read(path, 0)
        section = None
        for where, line in self.lines:
            text = line.strip()
            if text.startswith("[") and "]" in text:
                section = text[1:text.index("]")].strip()
            elif text and text[0] not in "#;" and "=" in text:
                if section is None:
                    raise Refusal(f"{where}: an entry before the first [SECTION]")
                name, value = text.split("=", 1)
                self.entries.append((section, name.strip(), value.strip(), where))
        if not self.entries:
            raise Refusal(f"{path}: no ini file of LinuxCNC: it has no [SECTION] with NAME = VALUE")

    def _read(self, path, depth):
        for number, line in enumerate(read_text(path).splitlines(), 1):
            include = re.match(r"\s*#INCLUDE\s+(\S+)", line)
            if not include:
                self.lines.append((f"{path}:{number}", line))
            elif depth > 8:
                raise Refusal(f"{path}:{number}: #INCLUDE within #INCLUDE too deep")
            else:
                inner = os.path.join(self.folder, os.path.expanduser(include.group(1)))
                self._read(inner, depth + 1)

    def all(self, section, name):
        """Values of NAME in [SECTION], in their order."""
        return [v for s, n, v, _ in self.entries if (s, n) == (section, name)]

    def get(self, section, name, default=None):
        """The first value, as LinuxCNC takes it."""
        values = self.all(section, name)
        return values[0] if values else default

    def number(self, section, name, default):
        for s, n, value, where in self.entries:
            if (s, n) == (section, name):
                try:
                    return float(value.split("#")[0])
                except ValueError:
                    raise Refusal(f"{where}: [{section}]{name}: '{value}' is no number") from None
        return default


def read_text(path):
    """The text of a file; no file and a binary file are refused."""
    try:
        with open(path, "rb") as file:
            data = file.read()
    except OSError as error:
        raise Refusal(f"{path}: {error.strerror}") from None
    if b"\0" in data or sum(c < 32 and c not in b"\t\n\r\f\x1a\x1b" for c in data) > 8:
        raise Refusal(f"{path}:1: not a text file")
    return data.decode("utf-8", "replace")


class Machine:
    """Units, joints and kinematics module of the ini. Lengths come out in mm, angles in degrees."""

    def __init__(self, ini):
        self.ini = ini
        self.scale = self._units(ini)
        self.kins, *self.words = (ini.get("KINS", "KINEMATICS") or "trivkins").split()
        self.count = int(ini.number("KINS", "JOINTS", 0))
        self.letters = self._letters(ini)
        self.joints = [self._joint(n) for n in range(self.count)]

    @staticmethod
    def _units(ini):
        unit = (ini.get("TRAJ", "LINEAR_UNITS") or "").lower()
        angle = (ini.get("TRAJ", "ANGULAR_UNITS") or "deg").lower()
        if angle not in ("deg", "degree", "1.0", "1"):
            raise Refusal(f"{ini.path}: [TRAJ]ANGULAR_UNITS = {angle}: only deg is supported")
        if unit in ("mm", "metric", "1.0", "1"):
            return 1.0
        if unit in ("in", "inch", "imperial"):
            return INCH
        raise Refusal(f"{ini.path}: [TRAJ]LINEAR_UNITS is '{unit}'; mm and inch are supported")

    def _letters(self, ini):
        if self.count < 1 or self.count > 16:
            raise Refusal(f"{ini.path}: [KINS]JOINTS must be 1 to 16")
        letters = KINEMATICS.get(self.kins)
        if letters is None:
            known = ", ".join(KINEMATICS)
            raise Refusal(f"{ini.path}: [KINS]KINEMATICS {self.kins} is not supported; "
                          f"supported are {known}")
        for word in self.words:
            if word.lower().startswith("coordinates="):
                letters = word[12:].upper()
        if not letters or set(letters) - set(AXES):
            raise Refusal(f"{ini.path}: [KINS]KINEMATICS: coordinates={letters} is not of {AXES}")
        self.count = min(self.count, len(letters))  # joints past the letters follow no axis
        return letters[:self.count]

    def _joint(self, number):
        section = f"JOINT_{number}"
        linear = (self.ini.get(section, "TYPE") or "LINEAR").upper() != "ANGULAR"
        unit = self.scale if linear else 1.0
        low, high, home = (self.ini.number(section, name, default) * unit for name, default in
                           (("MIN_LIMIT", -1e99), ("MAX_LIMIT", 1e99), ("HOME", 0.0)))
        low, high = max(low, -FAR), min(high, FAR)
        fastest = max(self.ini.number(name, "MAX_ACCELERATION", 0.0) * unit
                      for name in (section, f"AXIS_{self.letters[number]}"))
        kind = "linear" if linear else "angular"
        return self.letters[number], kind, low, high, fastest, home

    def limits(self):
        """Speed and acceleration of each axis in coordinated motion, 0 where the ini is silent."""
        for letter in AXES:
            kind, unit = ("ANGULAR", 1.0) if letter in "ABC" else ("LINEAR", self.scale)
            speed, fastest = (self.ini.number(f"AXIS_{letter}", name, 0.0) * unit
                              for name in ("MAX_VELOCITY", "MAX_ACCELERATION"))
            most = self.ini.number("TRAJ", f"MAX_{kind}_ACCELERATION", 0.0) * unit
            if speed > 0 and fastest > 0:
                yield letter, speed, min(fastest, most) if most > 0 else fastest

    def servo_period(self):
        """In seconds; 0 if the ini does not tell it."""
        return self.ini.number("EMCMOT", "SERVO_PERIOD", 0.0) * 1e-9

    def axis_mask(self):
        """The bits of the axes that [TRAJ]COORDINATES names."""
        letters = (self.ini.get("TRAJ", "COORDINATES") or self.letters).upper()
        return sum(1 << AXES.index(a) for a in set(letters) if a in AXES)
