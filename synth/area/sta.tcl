# SPDX-License-Identifier: MIT
# synth/area/sta.tcl - the slack of a mapped netlist and its slow paths, for synth/area/map, which
# sets period (ns) and late (inputs that come half a period late).

constrain $period $clock $late
report_worst_slack -digits 4
report_checks -path_delay max -digits 4 -group_count 300 -unique_paths_to_endpoint
