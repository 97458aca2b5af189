# SPDX-License-Identifier: MIT
# mesh.mk - the sample objects.

$(BUILD)/mesh/cutter.stl: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) mesh ball-end --triangles=400 --at=45,0,-20 -o $@

$(BUILD)/mesh/workpiece.stl: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) mesh pocket --triangles=400 -o $@

# The cutter for the poses of scripts/tree_engine/poses: its tip is at the origin.
$(BUILD)/mesh/ball-end.stl: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) mesh ball-end --triangles=400 -o $@

# Poses of B for a tree engine, to simulate its gates.
$(BUILD)/poses/%.txt: scripts/tree_engine/poses
	@mkdir -p $(@D)
	@$(aside) $< $* 64 > $$new && $(in_place)
