# SPDX-License-Identifier: MIT
# synth/common.tcl - what every run of OpenSTA begins with: reads the design. liberty (files),
# netlist and top are set by who sources it (run_sta of synth/common).

foreach file $liberty { read_liberty $file }
set_cmd_units -time ns
read_verilog $netlist
link_design $top

# The clock's port, unless it is set: aclk of a top with buses, clk of a core.
if {![info exists clock] || $clock eq ""} {
  set clock clk
  foreach port [all_inputs] { if {[get_name $port] eq "aclk"} { set clock aclk } }
}

# Inputs but the clock, those whose name matches `late` or only those.
proc inputs {clock late} {
  lmap port [all_inputs] {
    set name [get_name $port]
    if {$name eq $clock || ![string match $late $name]} { continue }
    set port
  }
}

# Inputs arrive with the clock's edge, `late` ones half a period after it; outputs are due at the
# next edge; the clock is ideal.
proc constrain {period clock {late ""}} {
  create_clock -name clk -period $period [get_ports $clock]
  set_input_delay 0 -clock clk [inputs $clock *]
  if {$late ne ""} { set_input_delay [expr {$period / 2.0}] -clock clk [inputs $clock $late] }
  set_output_delay 0 -clock clk [all_outputs]
}

# Of paths, as find_timing_paths lists them: one of each group.
proc least_slack {paths} {
  return [::tcl::mathfunc::min {*}[lmap path $paths { get_property $path slack }]]
}

proc worst_slack {} {
  return [least_slack [find_timing_paths -path_delay max]]
}
