# SPDX-License-Identifier: MIT
# ip.tcl - packages Verilog of `sepax gen` as a block of the IP catalog of Vivado, with the buses
# that the attributes X_INTERFACE of its top name.
#
#   vivado -mode batch -source synth/fpga/ip.tcl -tclargs RTL-DIR IP-DIR PART
if {[llength $argv] != 3} { error "ip.tcl: give -tclargs RTL-DIR IP-DIR PART" }
lassign $argv rtl ip part
# sepax.f or PREFIX.f, which is before PREFIX_absolute.f.
set list [open [lindex [lsort [glob -directory $rtl -- *.f]] 0]]
set files [split [string trim [read $list]] "\n"]
close $list
set top [file rootname [lindex $files end]]

create_project -in_memory -part $part
foreach file $files { add_files -norecurse [file join $rtl $file] }
set_property top $top [current_fileset]
update_compile_order -fileset sources_1
ipx::package_project -root_dir $ip -vendor sepax -library collision -name $top -version 1.0 \
  -taxonomy /UserIP -import_files -set_current true
set core [ipx::current_core]
set_property description "Exact triangle/triangle collision detection" $core
ipx::create_xgui_files $core
ipx::update_checksums $core
ipx::check_integrity $core
ipx::save_core $core
foreach bus [ipx::get_bus_interfaces -of_objects $core] { puts $bus }
