# SPDX-License-Identifier: MIT
# synth.mk - the gates of the design DESIGN_NAME: mapped, timed, simulated.

LIBRARY = $(basename $(notdir $(LIBERTY:.gz=)))

# OpenSTA needs a netlist that is sized for a clock. In Nangate45 this is the generator's clock;
# other libraries are slower, osu018 about four times.
CLOCK_NS ?= $(patsubst CLOCK_NS=%,%,$(filter CLOCK_NS=%,$(shell $(SEPAX) name --make)))
ifneq ($(filter timed timing-file laid layout-file assigned flow,$(MAKECMDGOALS)),)
SIZED_FOR = $(if $(filter nangate45%,$(LIBRARY)),$(if $(filter paper,$(ARCH)),$(CLOCK_NS)),$(shell \
            LC_ALL=C awk 'BEGIN { print 4 * "$(CLOCK_NS)" }'))
PERIOD   := $(or $(PERIOD),$(SIZED_FOR))
# With an UNCERTAINTY of the clock, in percent, cells are sized for a period that is shorter by it.
ifneq ($(filter flow,$(MAKECMDGOALS)),)
UNCERTAINTY ?= 10
endif
ifneq ($(UNCERTAINTY),)
FULL     := $(or $(PERIOD),$(CLOCK_NS))
override PERIOD := $(shell echo "$(FULL) $(UNCERTAINTY)" | LC_ALL=C awk \
  '$$2 ~ /^[0-9]+([.][0-9]+)?$$/ && $$2 < 100 { print $$1 * (1 - $$2 / 100) }')
$(if $(PERIOD),,$(error UNCERTAINTY=$(UNCERTAINTY): not a percentage))
endif
endif
AT_FULL   = $(if $(UNCERTAINTY),-p $(FULL))

# The paper's schedule meets its clock in no library that we have, and further rounds of sizing take
# a minute each and gain nothing. So thresholds are chosen for the period that the first round
# reaches, with generated multipliers, as in `make report`.
ifneq ($(and $(filter assigned,$(MAKECMDGOALS)),$(filter paper conference,$(ARCH))),)
ROUNDS_OF    = -r 1
ONCE         = once
MULTIPLIERS ?= generated
endif

# A given period, generated multipliers, clock gates and sizing in one round change the folder.
GENERATED = $(filter generated,$(MULTIPLIERS))
GATED     = $(if $(call is_on,GATING),gated)
AREA      = $(CORE)/$(LIBRARY)$(PERIOD:%=-%ns)$(GENERATED:%=-%)$(GATED:%=-%)$(ONCE:%=-%)

.PHONY: mapped area-file timed timing-file assigned powered power-file flow routed \
        cosim-netlist cosim-netlist-icarus

routed:
	@echo "fpga: TARGET=asic is none; give TARGET=ecp5, ice40, xc7, xcup or gowin" >&2; exit 2

# The checksum notices another library of the same name. Sizing keeps the limits of all corners.
OTHER_CORNERS = $(or $(CORNERS),$(filter-out $(LIBERTY),$(foreach corner,slow fast, \
                $(dir $(LIBERTY))$(subst typ,$(corner),$(notdir $(LIBERTY))))))
$(AREA)/liberty.sum: FORCE
	@[ -r "$(LIBERTY)" ] || \
	  { echo "area: $(LIBERTY) cannot be read; give LIBERTY=file.lib[.gz]" >&2; exit 2; }
	@mkdir -p $(AREA)
	@cksum "$(LIBERTY)" $(wildcard $(OTHER_CORNERS)) > $@.new; \
	  if cmp -s $@.new $@; then rm $@.new; else mv $@.new $@; fi

$(AREA)/area.json: $(RTL) $(AREA)/liberty.sum $(BUILD)/liberty \
    $(wildcard synth/area/* synth/common* synth/netlist.jq)
	@echo "  YOSYS   $(DESIGN_NAME), $(LIBRARY)"
	@synth/area/map -l $(LIBERTY) $(if $(CORNERS),-c "$(CORNERS)") $(if $(PERIOD),-p $(PERIOD)) \
	  $(ROUNDS_OF) \
	  $(if $(GENERATED),-m $(SEPAX)) $(if $(GATED),-g) -o $(AREA) $(CORE)/rtl

mapped: $(AREA)/area.json
area-file:
	@echo $(AREA)/area.json

timed: $(AREA)/area.json
	@echo "  STA     $(DESIGN_NAME), $(LIBRARY)"
	@synth/timing/sta -l $(LIBERTY) $(AT_FULL) $(if $(CORNERS),-c "$(CORNERS)") \
	  -o $(AREA)/timing $(AREA)
timing-file:
	@echo $(AREA)/timing/timing.json

# Wires: LEF of the technology and of its cells, GDS of its cells; blocks are modules, or the top.
LEF    ?= $(wildcard $(LIBERTY:.lib=.lef))
BLOCKS ?= $(shell sed -n '$$s/[.]v$$//p' $(CORE)/rtl/sepax.f)
laid: $(AREA)/area.json
	@[ -n "$(LEF)" ] || { echo "layout: give LEF=\"FILE ...\" of $(LIBRARY)" >&2; exit 2; }
	@for block in $(BLOCKS); do \
	  echo "  LAYOUT  $(DESIGN_NAME), $$block, $(LIBRARY)"; \
	  synth/layout/run -l $(LIBERTY) -f "$(LEF)" $(if $(GDS),-g $(GDS)) $(if $(USE),-u $(USE)) \
	    $(if $(SEEDS),-r "$(SEEDS)") $(if $(CORNERS),-k "$(CORNERS)") \
	    $(if $(DERATE),-d $(DERATE)) $(AT_FULL) -m $$block -o $(AREA)/layout/$$block $(AREA) || \
	    exit; done
layout-file:
	@for block in $(BLOCKS); do echo $(AREA)/layout/$$block/layout.json; done

# For OpenROAD-flow-scripts and LibreLane.
flow: $(AREA)/area.json
	@echo "  FLOW    $(DESIGN_NAME), $(LIBRARY)"
	@synth/flow/write -l $(LIBERTY) -u $(UNCERTAINTY) $(AT_FULL) $(if $(USE),-s $$(echo \
	  $(USE) | awk '{ print 100 * $$1 }')) -o $(AREA)/flow $(AREA)
	@echo "$(AREA)/flow"

assigned: $(AREA)/area.json
	@synth/multivt/assign -f $(LIBERTY) $(if $(LIBERTY_LOW_LEAKAGE),-s $(LIBERTY_LOW_LEAKAGE)) \
	  -o $(AREA)/multivt $(AREA)
	@cp $(AREA)/multivt/multivt.json $(BUILD)/multivt.json

# ------------------------------------------------------------------------- power

# Seeded pairs that collide or are coplanar, the same for all designs of a word length.
LOADS     = $(BUILD)/power-w$(WORD)
COLLIDING = --family=local --count=12000
COPLANAR_PAIRS = --family=coplanar --count=8000
select    = $(aside) mkdir -p $(@D) && $(SEPAX) vectors --word=$(WORD) $(1) | \
            $(SEPAX) judge --word=$(WORD) --echo | awk '$$$(2) == 1 { NF = 24; print }' > $$new && \
            $(in_place)
$(LOADS)/colliding.txt: $(SEPAX)
	@$(call select,$(COLLIDING),25)
$(LOADS)/coplanar.txt: $(SEPAX)
	@$(call select,$(COPLANAR_PAIRS),26)

.PHONY: workloads
workloads: $(LOADS)/colliding.txt $(LOADS)/coplanar.txt

# An engine finds its pairs itself, so it takes meshes.
CYCLES    ?= 200
POWER_MESH = $(MESH_A) $(MESH_B) $(if $(filter fit,$(RESOLUTION)),0,$(RESOLUTION))
LOAD_FILES = $(or $(LOAD_FILES_$(DESIGN_ENGINE)),$(SAMPLES))
WORKLOADS  = $(or $(WORKLOADS_$(DESIGN_ENGINE)),$(WORKLOADS_none))

LOAD_FILES_none  = $(LOADS)/colliding.txt $(LOADS)/coplanar.txt
WORKLOADS_none   = "separated=$(POWER_MESH)" colliding=$(LOADS)/colliding.txt \
                   coplanar=$(LOADS)/coplanar.txt "idle=idle $(LOADS)/colliding.txt"

WORKLOADS_object = "separated=$(POWER_MESH)" "loading=loading $(POWER_MESH)" \
                   "idle=idle $(POWER_MESH)"

POSES_OF         = $(or $(POSES),$(BUILD)/poses/$(1).txt)
POSED            = poses $(call POSES_OF,$(1)) $(if $(POSES),$(POWER_MESH),$(addprefix \
                   $(BUILD)/mesh/,workpiece.stl ball-end.stl) $(if $(call given,RESOLUTION), \
                   $(patsubst fit,0,$(RESOLUTION)),0.002))
LOAD_FILES_tree  = $(sort $(foreach load,gouge free,$(call POSES_OF,$(load)))) $(if \
                   $(POSES),,$(addprefix $(BUILD)/mesh/,workpiece.stl ball-end.stl))
WORKLOADS_tree   = $(if $(POSES),"poses=$(call POSED)","contact=$(call POSED,gouge)" \
                   "free=$(call POSED,free)") "idle=idle $(call POSED,free)"

powered: $(AREA)/area.json $(BUILD)/power $(LOAD_FILES) $(SAMPLES)
	@echo "  POWER   $(DESIGN_NAME), $(LIBRARY)"
	@POWER=$(BUILD)/power synth/power/run -l $(LIBERTY) -c $(CYCLES) $(if $(call is_on,OPENSTA),-t) \
	  $(if $(GLITCHES),-x $(GLITCHES)) -o $(AREA)/power $(AREA) $(WORKLOADS)
power-file:
	@echo $(AREA)/power/power.json

# ----------------------------------------------------------------- the gates simulated

$(AREA)/netlist.vvp: $(AREA)/area.json $(TEST_BENCH)
	@scripts/need cosim iverilog vvp
	@echo "  ICARUS  $(DESIGN_NAME), mapped to $(LIBRARY)"
	@synth/liberty/models -l $(LIBERTY) -n $(AREA)/netlist.json -o $(AREA)/cells.v
	@$(IVERILOG) -g2005 -I $(CORE)/rtl -s sepax_tb -o $@ $$(grep -q 'input test_enable;' \
	  $(AREA)/netlist.v && echo -DSEPAX_TEST_ENABLE) $(AREA)/netlist.v $(AREA)/cells.v \
	  $(TEST_BENCH)

# A pair takes Icarus a second on gates of W = 18, so there are only ten pairs of each family.
cosim-netlist-icarus: COUNT = 170
cosim-netlist-icarus: $(AREA)/netlist.vvp $(CORE)/icarus.pairs
	@$(VVP) -N $< +pairs=$(CORE)/icarus.pairs

# Verilate hierarchically, one module at a time. This needs the script `verilator`, because
# verilator_bin does not find itself. A design with clock gates is verilated as one, because a
# separately verilated module samples a gated clock at the wrong edge.
SCRIPT_OF_VERILATOR = $(VERILATOR:/usr/bin/verilator_bin=verilator)
BY_MODULE = $(if $(GATED),--output-split 20000,--output-split 1000000 --hierarchical netlist.vlt)
$(AREA)/cosim: $(AREA)/area.json $(COSIM_DEPS)
	@echo "  VERILATE $(DESIGN_NAME), mapped to $(LIBRARY)"
	@synth/liberty/models -l $(LIBERTY) -n $(AREA)/netlist.json -o $(AREA)/cells.v
	@scripts/need cosim c++ verilator
	@cd $(AREA) && { LIBS="$(IO_LIBS)" $(SCRIPT_OF_VERILATOR) --cc --exe --build -j 2 --no-timing \
	  -Wno-fatal -Wno-lint -fno-const-bit-op-tree --top-module $(COSIM_TOP) \
	  -MAKEFLAGS "OPT_FAST=-Og OPT_SLOW=-O0 OPT_GLOBAL=-O2" \
	  -CFLAGS "$(MODEL_PATH) -I$(abspath $(CORE)/rtl)" --Mdir obj -o ../cosim \
	  $(BY_MODULE) cells.v netlist.v $(COSIM_CPP) > cosim.log 2>&1 || \
	  { tail -20 cosim.log >&2; exit 1; }; }

cosim-netlist: $(AREA)/cosim $(GATE_MESHES)
	@$(AREA)/cosim $(GATE_ARGS) $(STRESSED)
