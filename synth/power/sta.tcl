# SPDX-License-Identifier: MIT
# synth/power/sta.tcl - hands transitions to OpenSTA and asks its report_power.
#
# period (ns) and pins (what build/power -t wrote) are set by who sources it, after
# synth/common.tcl. set_power_activity -pins of 2.0.17 calls a procedure that it does not have; what
# it would call is called here. A pin that is not there is an error.

create_clock -name clk -period $period [get_ports $clock]

set file [open $pins]
set rows 0
while {[gets $file line] >= 0} {
  lassign $line kind name activity duty
  if {$kind eq "port"} {
    ::sta::set_power_input_port_activity [get_ports $name] $activity $duty
  } else {
    set pin [get_pins $name]
    if {[llength $pin] != 1} {
      puts "Error: no pin $name"
      exit 1
    }
    ::sta::set_power_pin_activity $pin $activity $duty
  }
  incr rows
}
close $file
puts "rows $rows"
report_power -digits 6
