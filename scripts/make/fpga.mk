# SPDX-License-Identifier: MIT
# fpga.mk - the design DESIGN_NAME on the FPGAs of its TARGET: mapped, routed, its gates simulated.

FPGA  = $(CORE)/fpga
ROUTE = $(FPGA)/route$(DEVICE:%=-%)$(GRADE:%=-g%)$(PACKAGE:%=-%)$(PLACER:%=-%)$(if \
        $(PLACEMENTS),-$(PLACEMENTS)x)$(if $(SEEDS),-$(shell echo $(SEEDS) | tr ' ' _))

ROUTED = $(if $(DEVICE),-d $(DEVICE)) $(if $(GRADE),-g $(GRADE)) $(if $(PACKAGE),-k $(PACKAGE)) \
         $(if $(PLACER),-p $(PLACER)) $(if $(PLACEMENTS),-n $(PLACEMENTS)) \
         $(if $(SEEDS),-s "$(SEEDS)")

.PHONY: routed routable fpga-file cosim-netlist cosim-netlist-icarus mapped timed assigned powered

mapped timed assigned powered:
	@echo "$@: gates are of TARGET=asic; make fpga counts the cells of $(TARGET)" >&2; exit 2

$(FPGA)/fpga.json: $(RTL) $(wildcard synth/fpga/map synth/fpga/count.jq synth/fpga/ports.jq \
                     synth/fpga/outreg.jq synth/fpga/families.json synth/fpga/cells/* \
                     synth/fpga/vivado.tcl synth/common synth/netlist.jq)
	@echo "  YOSYS   $(DESIGN_NAME)"
	@synth/fpga/map $(if $(PART),-r $(PART)) -o $(FPGA) $(CORE)/rtl

$(ROUTE)/fpga.json: $(FPGA)/fpga.json $(wildcard synth/fpga/route synth/fpga/routed.jq \
                     synth/fpga/dsps/*)
	@echo "  ROUTE   $(DESIGN_NAME)"
	@synth/fpga/route $(ROUTED) -o $(ROUTE) $(FPGA)

# Whether the design can be routed at all is checked before it is mapped.
routed: $(ROUTE)/fpga.json
routable:
	@synth/fpga/route -c $(TARGET) $(ROUTED)
ifneq ($(filter routed,$(MAKECMDGOALS)),)
$(FPGA)/fpga.json: | routable
endif
fpga-file:
	@echo $(ROUTE)/fpga.json

# ----------------------------------------------------------------- the gates simulated

# The mapped cells as Verilog (gates.v) and as C (gates.c), by Yosys' models of the cells.
$(FPGA)/gates.c: $(FPGA)/fpga.json synth/fpga/models synth/fpga/lanes.awk
	@echo "  GATES   $(DESIGN_NAME), mapped"
	@synth/fpga/models -o $(FPGA) -n $(FPGA)/netlist.v $(TARGET)

$(FPGA)/netlist.vvp: $(FPGA)/gates.c $(TEST_BENCH)
	@scripts/need cosim iverilog vvp
	@$(IVERILOG) -g2005 -I $(CORE)/rtl -s sepax_tb -o $@ $(FPGA)/gates.v $(TEST_BENCH)

cosim-netlist-icarus: COUNT = 170
cosim-netlist-icarus: $(FPGA)/netlist.vvp $(CORE)/icarus.pairs
	@$(VVP) -N $< +pairs=$(CORE)/icarus.pairs

# The test bench with the gates as C, which simulates 64 copies of the design at once.
GATES_OPT ?= -O1
$(FPGA)/gates.o: $(FPGA)/gates.c
	@$(CC) $(GATES_OPT) -c $< -o $@

$(FPGA)/cosim.o: $(COSIM_DEPS)
	@$(CXX) $(GATES_OPT) -std=c++17 -DSEPAX_GATES $(MODEL_PATH) -I$(CORE)/rtl \
	  -c tb/cosim/cosim.cpp -o $@

$(FPGA)/cosim: $(FPGA)/gates.o $(FPGA)/cosim.o
	@$(CXX) -o $@ $^ $(OPTIONS_OBJ) $(IO) $(LIB) $(IO_LIBS) -lm -pthread

cosim-netlist: $(FPGA)/cosim $(GATE_MESHES)
	@$(FPGA)/cosim $(GATE_ARGS) $(STRESSED)
