# SPDX-License-Identifier: MIT
# synth/area/limits.tcl - the loads and slopes of a mapped netlist in one corner, for
# synth/area/map, which sets period (ns), late (inputs that come half a period late) and limits (the
# file that gets them).

constrain $period $clock $late
tell_limits $limits
