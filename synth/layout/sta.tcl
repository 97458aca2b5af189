# SPDX-License-Identifier: MIT
# synth/layout/sta.tcl - what OpenSTA says of a netlist that is laid out. clock (its port, or
# nothing), period (ns), spef (or nothing: the library's default wires, an ideal clock), derate (in
# percent), limits (the file that gets loads and slopes, or nothing) and late (how many paths with
# little slack to tell, or nothing) are set by who sources it, after synth/common.tcl. Prints lines
# of a word and a number in ns, and paths.
#
# With a derate, cells and wires of what must not be late take so much longer, and those of what
# must not be early so much shorter, as they vary on a chip.
#
# With wires the clock comes by its tree. Inputs then arrive with its latest register, outputs are
# due with its earliest at the next edge, as if the same tree went on around the design. Hold is of
# paths between registers; "ports" is the hold of paths from inputs that change 0 ns after the edge
# at the clock's port, before the tree.

proc worst {args} {
  set paths [find_timing_paths {*}$args]
  return [expr {[llength $paths] == 0 ? "" : [least_slack $paths]}]
}

if {![llength [get_ports -quiet $clock]]} {
  create_clock -name clk -period $period
  set_input_delay 0 -clock clk [all_inputs]
  set_output_delay 0 -clock clk [all_outputs]
} else {
  constrain $period $clock
}
if {$derate > 0} {
  set_operating_conditions -analysis_type on_chip_variation
  set_timing_derate -late [expr {1 + $derate / 100.0}]
  set_timing_derate -early [expr {1 - $derate / 100.0}]
}
if {$spef ne ""} { read_spef $spef }
if {$spef ne "" && [llength [get_ports -quiet $clock]]} {
  set_propagated_clock [get_clocks clk]
  set file [file rootname $spef].skew
  report_clock_skew -setup > $file
  set skew [open $file]
  set edges [lmap line [split [read $skew] "\n"] {
    if {![regexp {^ +([0-9.]+)} $line all latency]} { continue }
    set latency
  }]
  close $skew
  if {[llength $edges] > 0} {
    set latest [tcl::mathfunc::max {*}$edges]
    set earliest [tcl::mathfunc::min {*}$edges]
    puts "latency $latest"
    set_input_delay $latest -clock clk [inputs $clock *]
    set_output_delay [expr {-$earliest}] -clock clk [all_outputs]
  }
}
puts "slack [worst -path_delay max]"
set hold [worst -path_delay min -from [all_registers -clock_pins]]
if {$hold ne ""} { puts "hold $hold" }
puts "path"
report_checks -path_delay max -digits 4 -format full_clock_expanded
if {$late ne ""} {
  report_checks -path_delay max -digits 4 -format full_clock_expanded \
    -slack_max [expr {0.03 * $period}] -group_count $late -unique_paths_to_endpoint
}
if {$limits ne ""} {
  if {[llength [get_ports -quiet $clock]]} {
    set_input_delay 0 -clock clk [inputs $clock *]
    set ports [worst -path_delay min -from [inputs $clock *]]
    if {$ports ne ""} { puts "ports $ports" }
  }
  tell_limits $limits
}
