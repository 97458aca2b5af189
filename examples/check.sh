#!/bin/sh
# SPDX-License-Identifier: MIT
# check.sh - does a cutter touch the workpiece on its way down? `sepax check` answers with its
# exit status: 0 free, 1 collision, else no verdict.
#   examples/check.sh    from the project's folder, after `make`; SEPAX=program
# Exit status 2: a step failed, so that nothing is known of that position.
set -eu
sepax=${SEPAX:-build/sepax}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$sepax" mesh pocket --triangles=400 -o "$scratch/workpiece.stl" > "$scratch/log"
for z in 10 0 -10 -20 -24 -28; do
  "$sepax" mesh ball-end --triangles=400 --at=10,0,$z -o "$scratch/cutter.stl" > "$scratch/log"
  status=0
  "$sepax" check "$scratch/cutter.stl" "$scratch/workpiece.stl" \
    > "$scratch/verdict" || status=$?
  case $status in
    0) echo "tip at z = $z mm: free" ;;
    1) echo "tip at z = $z mm: $(tail -n 1 "$scratch/verdict")" ;;
    *)
      echo "check.sh: no verdict at z = $z mm" >&2
      exit 2
      ;;
  esac
done
