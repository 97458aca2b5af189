# SPDX-License-Identifier: MIT
# synth/timing/sta.tcl - what OpenSTA is asked about a mapped netlist, in one corner.
#
# clock (its port), period (ns) and limits (the file that gets loads and slopes) are set by who
# sources it, after synth/common.tcl. Prints lines that begin with a word of its own, for
# synth/timing/sta.

proc slack_at {ns} {
  global clock
  constrain $ns $clock
  return [worst_slack]
}

constrain $period $clock
# Outputs that are constants, and registers whose input is one, through full adders with constant
# inputs, say, have no path.
foreach pin [all_registers -data_pins] {
  if {[::sta::pin_sim_logic_value $pin] in {0 1}} { puts "constant [get_full_name $pin]" }
}
foreach port [all_outputs] {
  set pin [::sta::get_port_pin_arg "port" $port warn]
  if {[::sta::pin_sim_logic_value $pin] in {0 1}} { puts "constant [get_name $port]" }
}
puts "check_setup"
check_setup -verbose
puts "check_setup done"
puts "clocked [llength [all_registers -clock_pins]]"
set latches [llength [all_registers -level_sensitive -clock_pins]]

set most 0
foreach net [get_nets -hierarchical *] {
  set loads [llength [::sta::net_load_pins $net]]
  if {$loads > $most && [get_name $net] ne $clock} { set most $loads }
}
puts "loads $most"

set worst ""
foreach end [find_timing_paths -path_delay max -group_count 1000000 -unique_paths_to_endpoint] {
  set slack [get_property $end slack]
  set pin [get_property $end endpoint]
  if {$worst eq "" || $slack < $worst} { set worst $slack; set last $pin }
  puts "endpoint $slack [get_full_name $pin]"
}
set hold [find_timing_paths -path_delay min -from [all_registers -clock_pins]]
puts "hold [least_slack $hold]"
puts "path"
report_checks -path_delay max -digits 4 -to $last
puts "path done"
tell_limits $limits

# With the least period there is no slack left, or a path was judged by another edge.
set least [expr {$period - $worst}]
constrain $least $clock
# Through latches, those of clock gates, a path lasts half a period, or one borrows from the next.
if {$latches > 0} {
  set low 0
  for {set high $period} {[slack_at $high] < 0} {set high [expr {2 * $high}]} { set low $high }
  while {$high - $low > 2e-5} {
    set least [expr {($low + $high) / 2.0}]
    if {[slack_at $least] < 0} { set low $least } else { set high $least }
  }
  set least $high
  constrain $least $clock
}
puts "least $least [worst_slack]"
