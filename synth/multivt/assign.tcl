# SPDX-License-Identifier: MIT
# synth/multivt/assign.tcl - multi-Vt: which cells of a flat netlist may be slow.
#
# swaps (fast cell, slow cell, their leakages), period and activity are set by who sources
# it, after synth/common.tcl. Prints lines that begin with a word of its own, for
# synth/multivt/assign: the cells that become slow, among others.
#
# Where the fast cells alone are late, nothing is swapped. Else first every cell is a slow one.
# Then, as long as paths are too slow, cells on them become fast again: on each path as many as
# it takes, those first which are on many slow paths, gain much and leak little. At last whatever
# has slack to spare goes back, in parts, as far as the period holds.

proc report {when} {
  puts "slack $when [worst_slack]"
  puts "power $when"
  report_power -digits 6
}

constrain $period $clock
set_power_activity -input -activity $activity -duty 0.5
foreach {reset level} {rst 0 aresetn 1} {
  if {[llength [inputs $clock $reset]] > 0} {
    set_power_activity -input_ports $reset -activity 0 -duty $level
  }
}
report before
set possible [expr {[worst_slack] >= 0}]

set file [open $swaps]
while {[gets $file line] >= 0} {
  lassign $line fast slow leak_fast leak_slow
  set slow_of($fast) $slow
  set gain_of($fast) [expr {$leak_fast - $leak_slow}]
}
close $file

foreach cell [get_lib_cells */*] { set lib_cell([get_name $cell]) $cell }
foreach cell [get_cells -hierarchical *] {
  set type [get_property $cell ref_name]
  if {[info exists slow_of($type)]} {
    set name [get_full_name $cell]
    set object($name) $cell
    set type_of($name) $type
    set is_slow($name) 0
  }
}

proc make {slow names} {
  global object type_of is_slow slow_of lib_cell
  foreach name $names {
    set type $type_of($name)
    replace_cell $object($name) $lib_cell([expr {$slow ? $slow_of($type) : $type}])
    set is_slow($name) $slow
  }
}

if {$possible} { make 1 [array names is_slow] }
puts "slack all_slow [worst_slack]"

# The worst path to each late endpoint: slack, slow cells with what each takes longer (about),
# and all cells that could be slow.
proc late_paths {} {
  global is_slow
  set list {}
  foreach end [find_timing_paths -path_delay max -group_count 4000 -unique_paths_to_endpoint \
                 -slack_max 0] {
    set slack [get_property $end slack]
    if {$slack >= 0} { continue }
    set cells {}
    set all {}
    set before 0
    set last ""
    foreach point [get_property $end points] {
      set pin [get_full_name [get_property $point pin]]
      set time [get_property $point arrival]
      set name [string range $pin 0 [string last / $pin]-1]
      if {[info exists is_slow($name)] && $is_slow($name) && $name eq $last} {
        lappend cells $name [expr {($time - $before) * 0.2}]
      }
      if {$name ne $last && [info exists is_slow($name)]} { lappend all $name }
      set last $name
      set before $time
    }
    # The register at the end has its setup time.
    if {[info exists is_slow($name)] && $is_slow($name)} { lappend cells $name 0.008 }
    lappend list [list $slack $cells $all]
  }
  return $list
}

# The pins of a cell that drive, or those that do not.
proc pins {cell driving} {
  set list {}
  set pins [::sta::Instance_pin_iterator $cell]
  while {[$pins has_next]} {
    set pin [$pins next]
    if {[::sta::Pin_is_driver $pin] == $driving} { lappend list $pin }
  }
  $pins finish
  return $list
}

# Cells that drive inputs of these cells, slow or not.
proc drivers {names} {
  global object is_slow
  set list {}
  foreach name $names {
    foreach pin [pins $object($name) 0] {
      set net [::sta::Pin_net $pin]
      if {$net eq "NULL"} { continue }
      foreach driver [::sta::net_driver_pins $net] {
        if {[::sta::Pin_is_top_level_port $driver]} { continue }
        set from [get_full_name [::sta::Pin_instance $driver]]
        if {[info exists is_slow($from)]} { lappend list $from }
      }
    }
  }
  return [lsort -unique $list]
}

# The slow cells nearest before these: their slopes are felt on the path, too.
proc slow_before {names} {
  global is_slow
  for {set level 1} {$level <= 5} {incr level} {
    set names [drivers $names]
    set slow [lmap name $names { if {!$is_slow($name)} { continue }; set name }]
    if {[llength $slow] > 0} { return $slow }
  }
  return {}
}

# Returns the rounds it took, or -1 where a path stays late.
proc meet_period {} {
  global type_of gain_of
  for {set round 1} {$round <= 300} {incr round} {
    set late [late_paths]
    if {[llength $late] == 0} { return $round }
    array unset on
    foreach path $late {
      foreach {name longer} [lindex $path 1] { incr on($name) }
    }
    array unset now
    foreach path $late {
      lassign $path slack cells all
      # Later rounds take larger steps, as few paths are left and each is a round.
      set short [expr {-$slack * (1 + $round / 10.0)}]
      set order {}
      foreach {name longer} $cells {
        if {[info exists now($name)]} {
          set short [expr {$short - $longer}]
        } else {
          set worth [expr {$longer * $on($name) / $gain_of($type_of($name))}]
          lappend order [list $worth $name $longer]
        }
      }
      foreach item [lsort -real -decreasing -index 0 $order] {
        if {$short <= 0} { break }
        set now([lindex $item 1]) 1
        set short [expr {$short - [lindex $item 2]}]
      }
      if {[llength $order] == 0} {
        foreach name [slow_before $all] { set now($name) 1 }
      }
    }
    make 0 [array names now]
    puts "round $round [llength $late] [array size now] [worst_slack]"
    if {[array size now] == 0} { return -1 }
  }
  return -1
}

puts "rounds [expr {$possible ? [meet_period] : -1}]"

# Back again, those that leak most first: a part that makes a path late is undone and halved.
proc slack_of {cell} {
  set list 1e9
  foreach pin [pins $cell 1] {
    foreach vertex [::sta::Pin_vertices $pin] {
      foreach edge {rise fall} {
        lappend list [expr {1e9 * [lindex [::sta::Vertex_slacks $vertex $edge] 1]}]
      }
    }
  }
  return [tcl::mathfunc::min {*}$list]
}

proc try_slow {names} {
  global tries
  if {[llength $names] == 0 || [incr tries] > 100} { return 0 }
  make 1 $names
  if {[worst_slack] >= 0} { return [llength $names] }
  make 0 $names
  if {[llength $names] < 8} { return 0 }
  set half [expr {[llength $names] / 2}]
  return [expr {[try_slow [lrange $names 0 $half-1]] + [try_slow [lrange $names $half end]]}]
}

if {[worst_slack] >= 0} {
  set order {}
  foreach name [array names is_slow] {
    if {!$is_slow($name)} {
      set slack [slack_of $object($name)]
      if {$slack > 0.01} { lappend order [list [expr {$slack * $gain_of($type_of($name))}] $name] }
    }
  }
  set names [lmap item [lsort -real -decreasing -index 0 $order] { lindex $item 1 }]
  set tries 0
  set back 0
  for {set i 0} {$i < [llength $names]} {incr i 200} {
    incr back [try_slow [lrange $names $i $i+199]]
  }
  puts "back [llength $names] $back [worst_slack]"
}

report after
foreach name [array names is_slow] {
  if {$is_slow($name)} { puts "swap $name" }
}
