# SPDX-License-Identifier: MIT
"""guarded: what an operator does with the guarded machine, and what the pins said meanwhile."""
import os
import subprocess
import time

import hal
import linuxcnc

FOLDER = os.environ["GUARD_FOLDER"]
JOINTS = int(os.environ["GUARD_JOINTS"])
PINS = [f"joint.{n}.pos-cmd" for n in range(JOINTS)] + [
    "motion.feed-inhibit", "motion.jog-stop", "sepax-guard.slow", "sepax-guard.in-tube",
    "sepax-guard.work"]
KINDS = "f" * JOINTS + "bbbbu"
FEED, JOG, SLOW, TUBE, WORK = range(JOINTS, JOINTS + 5)  # columns after the joints
PERIOD = 0.001
command, stat, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()


class Wrong(Exception):
    pass


def halcmd(*words):
    return subprocess.run(("halcmd",) + words, stdout=subprocess.PIPE,
                          check=False).stdout.decode()


def pin(name):
    try:
        return hal.get_value("sepax-guard." + name)
    except RuntimeError:  # the component was unloaded
        return 0


def require(true, what):
    if not true:
        raise Wrong(what)


def until(condition, seconds, what):
    end = time.time() + seconds
    while time.time() < end:
        stat.poll()
        if condition():
            return
        time.sleep(0.005)
    raise Wrong(what)


# ------------------------------------------------------------------ samples

class Samples:
    """The pins of every servo period; periods in which nothing changed are left out."""

    def __init__(self):
        halcmd("loadrt", "sampler", "depth=16000", "cfg=" + KINDS)
        for n, name in enumerate(PINS):
            lines = [line.split() for line in halcmd("-s", "show", "pin", name).splitlines()]
            words = next(line for line in lines if len(line) > 4 and line[4] == name)
            signal = words[-1] if len(words) > 5 else f"sampled-{n}"
            halcmd("net", signal, name, f"sampler.0.pin.{n}")
        halcmd("addf", "sampler.0", "servo-thread")
        self.component = hal.component("sampled")
        self.component.ready()
        self.stream = hal.stream(self.component, 0x48534130)
        self.rows = []

    def drain(self):
        while self.stream.readable:
            row = tuple(self.stream.read())
            if not self.rows or row[:WORK] != self.rows[-1][:WORK]:
                self.rows.append(row)
        require(not self.stream.num_overruns, "samples were lost")

    def begin(self):
        self.drain()
        self.rows = self.rows[-1:]

    def positions(self):
        out = []
        for row in self.rows:
            if not out or out[-1] != row[:JOINTS]:
                out.append(row[:JOINTS])
        return out

    def at_stop(self):
        """Of the first stop: the speeds of the joints in that period, and for how many periods
        after it the machine did not yet brake. None if there was none."""
        rows = self.rows
        for n in range(1, len(rows)):
            if any(rows[n][k] and not rows[n - 1][k] for k in (FEED, JOG)):
                speeds = [[(b - a) / PERIOD for a, b in zip(rows[k - 1][:JOINTS], rows[k][:JOINTS])]
                          for k in range(n, min(n + 40, len(rows)))]
                sizes = [max(abs(v) for v in speed) for speed in speeds]
                late = 0
                while late + 1 < len(sizes) and sizes[late + 1] >= sizes[late] > 0:
                    late += 1
                return speeds[0], late
        return None

    def toggles(self, column):
        return sum(a[column] != b[column] for a, b in zip(self.rows, self.rows[1:]))


# ------------------------------------------------------------------ motion

def mode(wanted):
    command.mode(wanted)
    command.wait_complete()
    stat.poll()
    require(stat.task_mode == wanted, "the mode does not change")


def idle():
    return stat.interp_state == linuxcnc.INTERP_IDLE and stat.inpos


def still():
    return all(joint["velocity"] == 0 for joint in stat.joint[:JOINTS]) and stat.current_vel == 0


def settle(samples, seconds=30.0):
    """Until the motion ends by itself or stands still for 0.3 s."""
    end, since = time.time() + seconds, None
    time.sleep(0.1)
    while time.time() < end:
        samples.drain()
        stat.poll()
        if not still():
            since = None
        elif since is None:
            since = time.time()
        elif time.time() > since + 0.3 and (idle() or pin("stopped") or
                                            hal.get_value("motion.feed-inhibit")):
            return
        time.sleep(0.005)
    raise Wrong("the motion does not end")


def mdi(samples, line, seconds=30.0):
    mode(linuxcnc.MODE_MDI)
    command.mdi(line)
    settle(samples, seconds)


def program(samples, text, seconds=40.0):
    path = FOLDER + "/program.ngc"
    with open(path, "w", encoding="utf-8") as out:
        out.write(text.replace("; ", "\n") + "\nM2\n")
    mode(linuxcnc.MODE_AUTO)
    command.program_open(path)
    command.auto(linuxcnc.AUTO_RUN, 0)
    settle(samples, seconds)


def jog(samples, axis, speed, seconds, joints=False):
    """Hold a key; True if the jog was ended by the guard."""
    mode(linuxcnc.MODE_MANUAL)
    command.teleop_enable(0 if joints else 1)
    command.wait_complete()
    time.sleep(0.05)
    command.jog(linuxcnc.JOG_CONTINUOUS, joints, axis, speed)
    end = time.time() + seconds
    while time.time() < end:
        samples.drain()
        time.sleep(0.005)
    command.jog(linuxcnc.JOG_STOP, joints, axis)
    settle(samples)


def recover(samples):
    """As an operator: abort, jog away, reset."""
    command.abort()
    command.wait_complete()
    time.sleep(0.05)
    samples.drain()
    before = samples.rows[-1][2]
    jog(samples, 2, 40.0, 1.0)
    require(samples.rows[-1][2] > before + 10, "a jog away from the bodies was refused")
    reset()
    require(not pin("stopped"), "the reset does not end the stop")


def reset():
    for value in ("1", "0"):
        halcmd("setp", "sepax-guard.reset", value)
        time.sleep(0.1)  # a loaded machine misses shorter pulses


def place(samples, x, y, z):
    if pin("stopped"):  # a scenario before went wrong, and said so
        recover(samples)
    mdi(samples, "M52 P1")
    mdi(samples, "G53 G0 Z0")
    if JOINTS == 5:
        mdi(samples, "G53 G0 A0 C0")
    mdi(samples, f"G53 G0 X{x} Y{y}")
    mdi(samples, f"G53 G1 Z{z} F1200")
    stat.poll()
    require(not pin("stopped") and idle(), "a harmless motion was stopped, reason %d, at %s" % (
        pin("reason"), " ".join("%.1f" % v for v in samples.rows[-1][:JOINTS])))


def use_tube(text, sure=True):
    """Certify the program, and give its tube to the guard."""
    with open(FOLDER + "/certified.ngc", "w", encoding="utf-8") as out:
        out.write(text.replace("; ", "\n") + "\nM2\n")
    made = subprocess.run(
        [FOLDER + "/sepax", "path", "--machine=mill.ini", "mill.urdf", FOLDER + "/certified.ngc",
         "--clearance=2mm", "--loaded=0", f"--tube={FOLDER}/certified.tube"],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    require(made.returncode == 0 or not sure, "sepax path: " + made.stdout.decode()[-300:])
    said = subprocess.run([FOLDER + "/sepax_guard_tube", FOLDER + "/certified.tube"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    require(said.returncode == 0 or not sure, "sepax_guard_tube: " + said.stdout.decode()[-300:])
    return said.returncode


def no_tube():
    subprocess.run([FOLDER + "/sepax_guard_tube", "--none"], stdout=subprocess.PIPE, check=False)
