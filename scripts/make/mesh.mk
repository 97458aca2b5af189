# mesh.mk - the sample objects.

$(BUILD)/mesh/cutter.stl: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) mesh ball-end --triangles=400 --at=45,0,-20 -o $@

$(BUILD)/mesh/workpiece.stl: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) mesh pocket --triangles=400 -o $@
