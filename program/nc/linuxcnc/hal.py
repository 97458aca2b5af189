# SPDX-License-Identifier: MIT
"""HAL of a configuration, read and not run: what drives the pins of the kinematics."""
import os
import re

HALLIB = "/usr/share/linuxcnc/hallib"
# Pins of LinuxCNC's own windows that stand for a length of the machine: the word of loadusr that
# sets it, and its value without the word.
WINDOW_PINS = {"5axisgui.pivot_len": ("pivot_len", 250.0)}


class Hal:
    """Signals, values and drivers, from [HAL]HALFILE, HALCMD and POSTGUI_HALFILE. Trivial
    kinematics have no pins, so nothing is read for them."""

    def __init__(self, ini, machine):
        self.ini = ini
        self.values = {}   # pin or signal: its constant, and where it was set
        self.signal = {}   # pin: its signal
        self.pins = {}     # signal: its pins
        self.words = {}    # program of loadusr: its words
        self.scripts = []  # Tcl, which is not read: (path, text)
        for section, name, value, where in ini.entries if machine.kins != "trivkins" else []:
            if section == "HAL" and name in ("HALFILE", "POSTGUI_HALFILE"):
                self._file(value.split()[0], where)
            elif section == "HAL" and name in ("HALCMD", "POSTGUI_HALCMD"):
                self._command(value, where)

    def _file(self, name, where):
        library = name.startswith("LIB:")
        path = os.path.join(HALLIB if library else self.ini.folder,
                            os.path.expanduser(name[4:] if library else name))
        if not os.path.exists(path) and not library:
            path = os.path.join(HALLIB, name)
        if not os.path.exists(path):
            raise Refusal(f"{where}: {name} is not there")
        text = read_text(path)
        if path.endswith(".tcl"):
            if not library:
                self.scripts.append((path, text))
            return
        joined = re.sub(r"\\\n", " ", text)
        for line in joined.splitlines():
            self._command(line, path)

    def _entry(self, match):
        return self.ini.get(match.group(1), match.group(2), match.group(0))

    def _command(self, line, where):
        line = re.sub(r"\[(\w+)\]\(?(\w+)\)?", self._entry, line.split("#")[0])
        words = [w for w in line.split() if w not in ("=>", "<=", "<=>")]
        verb, words = (words[0].lower(), words[1:]) if words else ("", [])
        if verb == "net" and words:
            for pin in words[1:]:
                self._link(pin, words[0])
        elif verb in ("linksp", "linkps") and len(words) == 2:
            self._link(*(reversed(words) if verb == "linksp" else words))
        elif verb in ("setp", "sets") and len(words) >= 2:
            self.values[words[0]] = (words[1], where)
        elif verb == "unlinkp" and words:
            self.signal.pop(words[0], None)
        elif verb == "loadusr":
            for place, word in enumerate(words):
                if not word.startswith("-"):
                    self.words.setdefault(os.path.basename(word), words[place + 1:])
        elif verb == "source" and words:
            self._file(words[0], where)

    def _link(self, pin, signal):
        self.signal[pin] = signal
        self.pins.setdefault(signal, []).append(pin)

    def _constant(self, name):
        text, where = self.values[name]
        try:
            return float(text)
        except ValueError:
            raise Refusal(f"{where}: {name}: '{text}' is no number") from None

    def evaluate(self, pin, default, depth=0):
        """(constant, times): the pin is the constant plus `times` the Z of the tool's offset."""
        if depth > 20:
            raise Refusal(f"{self.ini.path}: HAL drives {pin} in a circle; "
                          f"give --control=set={pin}=VALUE")
        signal = self.signal.get(pin)
        if signal is None:
            return (self._constant(pin), 0) if pin in self.values else (default, 0)
        for driver in self.pins[signal]:
            found = self._driver(driver, depth)
            if found is not None:
                return found
        if signal in self.values:
            return self._constant(signal), 0
        if len(self.pins[signal]) == 1:
            return 0.0, 0  # a signal that nothing drives is 0
        raise Refusal(f"{self.ini.path}: what HAL gives to {pin} (signal {signal}) is not known; "
                      f"give --control=set={pin}=VALUE")

    def _driver(self, pin, depth):
        if pin == "motion.tooloffset.z":
            return 0.0, 1
        if pin in WINDOW_PINS:
            word, value = WINDOW_PINS[pin]
            for given in self.words.get(pin.split(".")[0], []):
                if given.startswith(word + "="):
                    value = float(given.split("=")[1])
            return value, 0
        part, _, last = pin.rpartition(".")
        if last == "out" and f"{part}.in0" in self.signal and f"{part}.in1" in self.signal:
            return self._sum(part, depth)
        if re.match(r"constant\.\d+\.out$", pin):
            return self.evaluate(part + ".value", 0.0, depth + 1)
        return None

    def _sum(self, part, depth):
        """Component sum2: in0 gain0 + in1 gain1 + offset."""
        constant, times = self.evaluate(part + ".offset", 0.0, depth + 1)
        for which in "01":
            gain, _ = self.evaluate(f"{part}.gain{which}", 1.0, depth + 1)
            one, one_times = self.evaluate(f"{part}.in{which}", 0.0, depth + 1)
            constant += gain * one
            times += gain * one_times
        return constant, times

    def parameters(self, machine, given):
        """Parameter: (constant in mm, times), of the module of the kinematics."""
        for path, text in self.scripts:
            if machine.kins + "." in text:
                raise Refusal(f"{path}: Tcl sets pins of {machine.kins}, which is not read; "
                              f"give --control=set={machine.kins}.PIN=VALUE for each")
        known = [f"{machine.kins}.{name}" for name in PARAMETERS[machine.kins]]
        for pin in given:
            if pin not in known:
                raise Refusal(f"linuxcnc: --control=set={pin}: no pin of {machine.kins}, which has "
                              f"{', '.join(known) or 'none'}")
        found = {}
        for name, default in PARAMETERS[machine.kins].items():
            pin = f"{machine.kins}.{name}"
            value, times = (given[pin], 0) if pin in given else self.evaluate(pin, default)
            if times not in (0, 1):
                raise Refusal(f"{self.ini.path}: {pin} follows {times} times the tool's length")
            found[name] = (value * machine.scale, times)
        pin = machine.kins + ".conventional-directions"
        if self.values.get(pin, ("0",))[0].lower() not in ("0", "false") or pin in self.signal:
            raise Refusal(f"{self.ini.path}: {pin} is not supported")
        return found

    def switch_output(self):
        """N of motion.analog-out-0N that switches the kinematics (M68 EN), or None."""
        signal = self.signal.get("motion.switchkins-type")
        for pin in self.pins.get(signal, []):
            match = re.match(r"motion\.analog-out-(\d+)$", pin)
            if match:
                return int(match.group(1))
        return None
