# SPDX-License-Identifier: MIT

# Synthesises, places and routes the design out of context: its ports get no pins.
#
#   vivado -mode batch -source vivado.tcl
#
# Writes utilization.txt, timing.txt and routed.dcp into the working folder; fmax_mhz is the last
# line that it prints.
set files [open $list]
foreach file [split [string trim [read $files]] "\n"] { read_verilog [file join $rtl $file] }
close $files
synth_design -top $top -part $part -mode out_of_context -include_dirs $rtl
create_clock -name clk -period $period [get_ports -regexp {a?clk}]
opt_design
place_design
phys_opt_design
route_design
report_utilization -file utilization.txt
report_timing_summary -file timing.txt
write_checkpoint -force routed.dcp
set slack [get_property SLACK [get_timing_paths]]
puts "fmax_mhz [expr {1000.0 / ($period - $slack)}]"
