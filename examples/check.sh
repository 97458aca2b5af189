#!/bin/sh
# Does a cutter touch the workpiece on its way down? Run from the project's folder after
# `make`. Exit status 1 of `sepax check` is a collision.
set -eu
sepax=build/sepax
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
$sepax mesh pocket --triangles=400 -o "$scratch/workpiece.stl"
for z in 10 0 -10 -20 -24 -28; do
  $sepax mesh ball-end --triangles=400 --at=10,0,$z -o "$scratch/cutter.stl" > "$scratch/log"
  if $sepax check --resolution=0.002 "$scratch/cutter.stl" "$scratch/workpiece.stl" \
    > "$scratch/verdict"; then
    echo "tip at z = $z mm: free"
  else
    echo "tip at z = $z mm: $(tail -1 "$scratch/verdict")"
  fi
done
