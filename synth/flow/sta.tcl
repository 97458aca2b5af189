# SPDX-License-Identifier: MIT
# synth/flow/sta.tcl - the slack of a mapped netlist by the constraints that flows get, and by those
# that it was sized by. period (ns) and sdc are set by who sources it, after synth/common.tcl.

proc between_registers {} {
  set path [find_timing_paths -path_delay max -from [all_registers -clock_pins] \
    -to [all_registers -data_pins]]
  return [get_property [lindex $path 0] slack]
}

constrain $period $clock
puts "mapped [between_registers]"
read_sdc $sdc
puts "slack [between_registers]"
puts "ports [worst_slack]"
