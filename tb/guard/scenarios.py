# SPDX-License-Identifier: MIT
"""scenarios: what is done with the guarded machine, and what must come of it."""
import time

import linuxcnc
from guarded import (JOINTS, TUBE, Wrong, command, halcmd, idle, jog, mdi, mode, no_tube, pin,
                     place, program, recover, require, reset, settle, stat, until, use_tube)


def crash(start, run, recovers=True, once=True):
    """From the start the motion leads into the bodies; the guard must stop it."""
    def scenario(samples):
        place(samples, *start)
        samples.begin()
        stops = pin("stops")
        run(samples)
        require(pin("stopped"), "the guard did not stop: state %d" % pin("state"))
        require(pin("stops") == stops + 1 or not once, "more stops than one")
        if recovers:
            recover(samples)
    return scenario


def harmless(run):
    def scenario(samples):
        place(samples, 0, 0, 0)
        samples.begin()
        run(samples)
        require(not pin("stopped") and idle(), "a harmless motion was stopped")
        require(len(samples.positions()) > 100, "it did not move")
    return scenario


def toward(samples):
    """After a stop, jogs that come nearer are refused; after a reset the guard stops them again."""
    jog(samples, 2, -60.0, 4.0)
    require(pin("stopped"), "the guard did not stop")
    at = samples.rows[-1][2]
    for _ in range(5):
        jog(samples, 2, -40.0, 0.4)
        require(pin("stopped"), "a jog ends the stop")
    require(samples.rows[-1][2] > at - 0.2, "jogs went on towards the bodies")
    for _ in range(4):
        reset()
        jog(samples, 2, -40.0, 0.4)


def failing(break_it, mend_it=None, reason=None):
    """A harmless motion, during which the guard fails: the machine must stop on the way."""
    def scenario(samples):
        place(samples, -60, 0, 0)
        samples.begin()
        mode(linuxcnc.MODE_MDI)
        command.mdi("G53 G1 X60 F1200")
        until(lambda: stat.joint_actual_position[0] > -40, 10, "it does not move")
        at = stat.joint_actual_position[0]
        break_it()
        settle(samples)
        stat.poll()
        end = stat.joint_actual_position[0]
        require(end < at + 15, "the machine went on for %g mm" % (end - at))
        if reason is not None:
            require(pin("reason") == reason, "the reason is %d" % pin("reason"))
        jog_from = samples.rows[-1][0]
        command.abort()
        command.wait_complete()
        jog(samples, 0, 20.0, 0.5)
        require(abs(samples.rows[-1][0] - jog_from) < 1, "it jogs although the guard failed")
        if mend_it:
            mend_it()
            time.sleep(0.1)
            require(pin("stopped"), "the stop is not latched")
            reset()
            require(not pin("stopped"), "the reset does not end the stop")
    return scenario


def loose(name, value, signal):
    """The pin gets a value of its own; and back."""
    def break_it():
        halcmd("unlinkp", "sepax-guard." + name)
        halcmd("setp", "sepax-guard." + name, value)

    def mend_it():
        halcmd("net", signal, "sepax-guard." + name)
    return break_it, mend_it


def killed():
    halcmd("delf", "sepax-guard.check", "servo-thread")


def gone():
    halcmd("delf", "sepax-guard.check", "servo-thread")
    halcmd("unloadrt", "sepax_guard")


# Near the table and along the workpiece, at speed: 5 mm and 3 mm away.
NEAR = ("G64 P0.05; G0 X60 Y-20; G0 Z-175; G1 X48 F6000; G1 Y20; G1 X60; G0 Z-120; G1 Z-175 F6000; "
        "G2 X60 Y-20 I0 J-20; G0 Z0; G0 X0 Y0")


def certified(samples):
    """In its tube the program goes where the guard would stop another at this speed."""
    place(samples, 0, 0, 0)
    use_tube(NEAR)
    time.sleep(0.1)
    samples.begin()
    program(samples, NEAR)
    no_tube()
    require(not pin("stopped") and idle(), "the program was stopped in its tube")
    left = sum(1 for row in samples.rows[1:] if not row[TUBE])
    require(left < 50, "%d of %d periods outside of the tube" % (left, len(samples.rows)))
    require(len(samples.positions()) > 1000, "it did not move")


def after_tube(change, run, restore=None):
    """With the tube of NEAR the machine does something else."""
    def scenario(samples):
        place(samples, 0, 0, 0)
        use_tube(NEAR)
        change(samples)
        samples.begin()
        run(samples)
        no_tube()
        require(pin("stopped"), "the guard did not stop: state %d" % pin("state"))
        recover(samples)
        if restore:
            restore(samples)
    return scenario


def refused(samples):
    """A program that collides has no tube, and one that is free of less is refused."""
    place(samples, 0, 0, 0)
    samples.begin()
    require(use_tube("G0 Z-160", sure=False) == 2, "a program that collides has a tube")
    mdi(samples, "G53 G0 X20")
    mdi(samples, "G53 G0 X0")
    require(not pin("in-tube"), "there is a tube")


SCENARIOS = {
    "rapid": crash((0, 0, 0), lambda s: mdi(s, "G53 G0 Z-180")),
    "feed": crash((0, 0, -120), lambda s: mdi(s, "G53 G1 Z-180 F600", 60)),
    "holder": crash((47, 0, -120), lambda s: mdi(s, "G53 G1 Z-185 F3000")),
    "clamp": crash((100, 0, -140), lambda s: program(s, "G53 G1 X-150 F4000; G53 G0 Z0")),
    "diagonal": crash((-150, -100, 0), lambda s: program(s, "G53 G0 X20 Y10 Z-170")),
    "blend": crash((-20, 0, -110), lambda s: program(
        s, "G64; G1 X-19 F5000; X80; Z-165; X-50; Z0")),
    "blend-p": crash((-150, 0, -110), lambda s: program(
        s, "G64 P1; G1 X0 F5000; X10 Z-160; X80; X-100 Z-190; Z0")),
    "exact": crash((-150, 0, -110), lambda s: program(
        s, "G61; G1 X0 F5000; X10 Z-160; X80; X-100 Z-190; Z0")),
    "arc": crash((100, 0, -100), lambda s: program(s, "G18; G3 X-100 Z-100 I-100 K0 F4000")),
    "override": crash((0, 0, 0), lambda s: (command.feedrate(1.2), mdi(s, "G53 G1 Z-180 F5000"),
                                            command.feedrate(1.0))),
    "jog-world": crash((0, 0, 0), lambda s: jog(s, 2, -100.0, 3.0)),
    "jog-joint": crash((0, 0, 0), lambda s: jog(s, 2, -100.0, 3.0, True), False),
    "jog-side": crash((100, 0, -150), lambda s: jog(s, 0, -60.0, 4.0)),
    "toward": crash((0, 0, 0), toward, once=False),
    "free": harmless(lambda s: program(
        s, "G64; G0 X100 Y80; G1 X-100 F6000; G2 X-60 Y40 R60; G1 Z-80; X0 Y0; Z0")),
    "free-jog": harmless(lambda s: (jog(s, 0, 80.0, 1.0), jog(s, 0, -80.0, 1.0),
                                    jog(s, 2, 60.0, 0.5, True))),
    "not-a-number": failing(*loose("joint.1.pos-cmd", "nan", "guard-j1-pos"), 4),
    "tool": failing(*loose("tool-number", "7", "guard-tool"), 5),
    "acceleration": failing(lambda: halcmd("setp", "sepax-guard.joint.2.max-accel", "0"),
                            lambda: halcmd("setp", "sepax-guard.joint.2.max-accel", "1000"), 4),
    "missed": failing(*loose("joint.0.vel-cmd", "0", "guard-j0-vel"), 6),
    "killed": failing(killed),
    "unloaded": failing(gone),
    "tube": certified,
    "tube-deeper": after_tube(lambda s: mdi(s, "G10 L2 P1 Z-8"), lambda s: program(s, NEAR),
                              lambda s: mdi(s, "G10 L2 P1 Z0")),
    "tube-aside": after_tube(lambda s: mdi(s, "G10 L2 P1 X-6"), lambda s: program(s, NEAR),
                             lambda s: mdi(s, "G10 L2 P1 X0")),
    "tube-other": after_tube(lambda s: None, lambda s: program(
        s, NEAR.replace("G1 X48", "G1 X20"))),
    "tube-jog": after_tube(lambda s: None, lambda s: jog(s, 2, -100.0, 3.0)),
    "tube-refused": refused,
    "five-tilt": crash((0, 50, -130), lambda s: mdi(s, "G53 G1 A60 F2000")),
    "five-turn": crash((0, 46, -160), lambda s: mdi(s, "G53 G1 C-90 F2000")),
    "five-both": crash((0, 60, -115), lambda s: program(
        s, "G64 P0.1; G1 A10 C10 F2000; G1 Y40 A50 C60 F1500")),
    "five-down": crash((0, 0, 0), lambda s: program(s, "G0 A30 C20; G1 Z-180 F5000")),
    "five-jog-tilt": crash((0, 50, -130), lambda s: jog(s, 3, 40.0, 3.0)),
    "five-jog-turn": crash((0, 46, -160), lambda s: jog(s, 4, -40.0, 3.0, True), False),
    "five-free": harmless(lambda s: program(
        s, "G64 P0.1; G1 X60 Y40 A10 C30 F3000; G1 X-60 A-10 C-60; G0 A0 C0; G0 X0 Y0")),
}
