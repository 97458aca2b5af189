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

# Writes a file for synth/limits.py: each output of a cell with its load (F) and the pins that read
# it, and what OpenSTA finds of max_transition, in ps. This OpenSTA (2.0.17) judges no other limit.
# The clock's own port is no output of a cell, because its tree is made in the layout.
proc tell_limits {file} {
  global sta_report_default_digits
  set corner [sta::cmd_corner]
  set out [open $file w]
  set cells [sta::leaf_instance_iterator]
  while {[sta::LeafInstanceIterator_has_next $cells]} {
    set cell [sta::LeafInstanceIterator_next $cells]
    set type [get_name [sta::Instance_liberty_cell $cell]]
    set pins [sta::Instance_pin_iterator $cell]
    while {[sta::InstancePinIterator_has_next $pins]} {
      set pin [sta::InstancePinIterator_next $pins]
      set net [sta::Pin_net $pin]
      if {$net eq "NULL" || ![sta::Pin_is_driver $pin]} { continue }
      set load [expr {max([sta::Pin_capacitance $pin rise $corner max],
                          [sta::Pin_capacitance $pin fall $corner max])}]
      puts $out "output [get_full_name $pin] $type $load [llength [sta::net_load_pins $net]]"
    }
    sta::InstancePinIterator_finish $pins
  }
  sta::LeafInstanceIterator_finish $cells
  close $out
  set digits $sta_report_default_digits
  set sta_report_default_digits 4
  set_cmd_units -time ps
  report_check_types -no_line_splits -max_transition >> $file
  report_check_types -no_line_splits -max_transition -all_violators >> $file
  set_cmd_units -time ns
  set sta_report_default_digits $digits
}
