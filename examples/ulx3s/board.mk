# SPDX-License-Identifier: MIT
# board.mk - the object engine on a board: its Makefile sets what is its own and includes this file.
#   make bitstream    synthesis, place and route: $(IMAGE), and a table of what it takes
#   make host         the program $(BOARD)
#   make simulate     A.stl against B.stl (MESH_A, MESH_B) by that program on the verilated board
#   make lint         Verilator, Icarus and Yosys on the Verilog
# All that is made is in build/BOARD/NAME/ of the project, NAME being that of the engine.
#
# A board sets before:
#   BOARD, PORT      its name, and the serial line on which its program finds it
#   TARGET, CELLS    the FPGA: --target of the engine, and Yosys's Verilog of its cells
#   LANES, MEMORY, WORD, II, CLOCK_NS      the engine
#   MHZ, MULTIPLY, DIVIDE, OUTPUT          its oscillator, and the PLL's dividers
#   PLL_MULTIPLY, PLL_DIVIDE, PLL_OUTPUT   the dividers that the PLL has
#   PLL_LOWEST, PLL_HIGHEST                MHz of the PLL's own oscillator
#   RESULTS          2^RESULTS results wait for the serial line without holding up a run
#   SYNTH_CELLS, SYNTH_PRODUCTS, SYNTH_SUMS, SYNTH_FLOW   parts of the Yosys script, below
#   IMAGE, ROUTED    files in $(OUT): the bitstream, and what nextpnr makes beside report.json
# and has the rules for $(OUT)/$(ROUTED) and $(OUT)/$(IMAGE) after. Verilog in its rtl/: BOARD_top.v
# and board_pll.v; C++ in its sim/: ports.h.

# The serial line; in the simulation a bit is SIM_CLOCKS cycles.
BAUD       ?= 3000000
SIM_CLOCKS ?= 4

ROOT     = ../..
BUILD   ?= $(ROOT)/build
SEPAX    = $(BUILD)/sepax
LIB      = $(BUILD)/libsepax-model.a $(BUILD)/libsepax.a
DESIGN   = --arch=exact --word=$(WORD) --ii=$(II) --lanes=$(LANES) --memory-a=$(MEMORY) \
           --memory-b=$(MEMORY) --target=$(TARGET) --clock-ns=$(CLOCK_NS)
OUT      = $(abspath $(BUILD))/$(BOARD)/w$(WORD)-ii$(II)-k$(LANES)-m$(MEMORY)
ENGINE   = $(OUT)/rtl/sepax.f
MESH_A  ?= $(BUILD)/mesh/cutter.stl
MESH_B  ?= $(BUILD)/mesh/workpiece.stl
RESOLUTION ?= $(if $(filter $(BUILD)/mesh/cutter.stl,$(MESH_A)),0.002)
# A file is looked for here and in the folder of the project, where make is called with -C.
mesh = $(firstword $(wildcard $(1) $(ROOT)/$(1)) $(1))
A = $(call mesh,$(MESH_A))
B = $(call mesh,$(MESH_B))

CC        ?= cc
YOSYS     ?= yosys
VERILATOR ?= verilator
IVERILOG  ?= iverilog
# Yosys of the bitstream.
SYNTH_YOSYS ?= $(YOSYS)
SYNTH_SETUP ?= scripts/setup
SEED      ?= 1
VENV       = $(abspath $(BUILD))/venv/bin
FPGA       = $(abspath $(ROOT)/synth/fpga)
export OBJCACHE ?= $(abspath $(ROOT))/scripts/make/compile $(abspath $(BUILD))/compiled
need = command -v $(1) > /dev/null || { echo "$(BOARD): no $(1); run $(2)" >&2; exit 2; }

SHARED   = ../ulx3s
SHARED_V = $(filter-out %_top.v %_pll.v,$(wildcard $(SHARED)/rtl/*.v))
TOP      = $(BOARD)_top
BOARD_V  = $(sort $(abspath $(wildcard rtl/*.v) $(SHARED_V)))
SIM_V    = $(filter-out %_pll.v,$(BOARD_V)) $(abspath $(SHARED)/sim/board_pll.v)
SET      = -set MULTIPLY $(MULTIPLY) -set DIVIDE $(DIVIDE) -set OUTPUT $(OUTPUT) \
           -set BAUD $(BAUD) -set RESULTS $(RESULTS)

SETTINGS = $(SET) $(SIM_CLOCKS) $(SEED) $(DEVICE) $(GRADE)

.DELETE_ON_ERROR:
.DEFAULT_GOAL = bitstream
.PHONY: bitstream host simulate lint table FORCE

include ../engine.mk

# What is made anew where it is another; no PLL that the FPGA does not have.
DIVIDERS = $(and $(filter $(MULTIPLY),$(PLL_MULTIPLY)),$(filter $(DIVIDE),$(PLL_DIVIDE)),$\
             $(filter $(OUTPUT),$(PLL_OUTPUT)))
$(OUT)/settings: FORCE
	@[ -n "$(DIVIDERS)" ] && mhz=$$(($(MHZ) * $(MULTIPLY) * $(OUTPUT) / $(DIVIDE))) && \
	[ $$mhz -ge $(PLL_LOWEST) ] && [ $$mhz -le $(PLL_HIGHEST) ] || \
	{ echo "$(BOARD): no such PLL: $(MHZ) MHz * $(MULTIPLY) / $(DIVIDE), times $(OUTPUT);" \
	  "set MULTIPLY, DIVIDE and OUTPUT as rtl/board_pll.v says" >&2; exit 2; }
	@mkdir -p $(@D) && echo '$(SETTINGS)' | cmp -s - $@ || echo '$(SETTINGS)' > $@

# ------------------------------------------------------------------------- host

host: $(OUT)/$(BOARD)

$(OUT)/$(BOARD): $(wildcard $(SHARED)/host/*) \
                 $(wildcard $(ROOT)/drivers/object_engine/sepax_driver.*) \
                 $(ENGINE) $(LIB) $(OUT)/settings
	@echo "  CC      $@"
	@$(CC) -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Werror -Wconversion -Wshadow -O2 -g \
	  -DBOARD_RESULTS=$(RESULTS) -DBOARD_NAME='"$(BOARD)"' -DBOARD_PORT='"$(PORT)"' \
	  -I$(ROOT)/drivers/object_engine -I$(ROOT)/lib -I$(ROOT)/c_model -I$(OUT)/rtl -o $@ \
	  $(SHARED)/host/ulx3s.c $(SHARED)/host/board.c \
	  $(ROOT)/drivers/object_engine/sepax_driver.c $(LIB) -lm -pthread

# ------------------------------------------------------------------------- simulation

ENGINE_OPT ?= -O3
$(OUT)/board: $(ENGINE) $(SIM_V) $(SHARED)/sim/board.cpp sim/ports.h $(OUT)/settings
	@echo "  VERILATE $(@D)"
	@cd $(OUT)/rtl && rm -rf ../obj && { $(VERILATOR) --cc --exe --build -O3 --noassert \
	  -fno-const-bit-op-tree --x-assign fast --x-initial unique --top-module $(TOP) \
	  -GCLOCKS=$(SIM_CLOCKS) -GIDLE=14 -GRESULTS=$(RESULTS) \
	  -GMULTIPLY=$(MULTIPLY) -GDIVIDE=$(DIVIDE) -GOUTPUT=$(OUTPUT) \
	  -MAKEFLAGS "OPT_FAST=$(ENGINE_OPT) OPT_GLOBAL=-O2" \
	  -CFLAGS "-DBOARD_CLOCKS=$(SIM_CLOCKS) -I$(abspath sim)" \
	  -f sepax.f $(SIM_V) $(abspath $(SHARED)/sim/board.cpp) \
	  --Mdir ../obj -o ../board > ../board.log 2>&1 || \
	  { tail -20 ../board.log >&2; exit 1; }; }

$(BUILD)/mesh/%.stl: $(SEPAX)
	@$(MAKE) --no-print-directory -C $(ROOT) build/mesh/$*.stl

simulate: $(OUT)/board $(OUT)/$(BOARD) $(A) $(B)
	@$(SHARED)/sim/run $(OUT)/board $(OUT)/$(BOARD) --check \
	  $(if $(RESOLUTION),--resolution=$(RESOLUTION)) "$(A)" "$(B)" || [ $$? -eq 1 ]

lint: $(ENGINE)
	@cd $(OUT)/rtl && $(VERILATOR) --lint-only -Wall --top-module $(TOP) -f sepax.f $(SIM_V)
	@cd $(OUT)/rtl && $(IVERILOG) -g2005 -Wall -t null -s $(TOP) -c sepax.f $(SIM_V)
	@cd $(OUT)/rtl && $(YOSYS) -q -p "read_verilog -lib $(CELLS); \
	  read_verilog $$(tr '\n' ' ' < sepax.f) $(BOARD_V); hierarchy -check -top $(TOP); \
	  proc; check -assert"

# ------------------------------------------------------------------------- bitstream

bitstream: $(OUT)/$(IMAGE) table

# As synth/fpga/map does.
$(OUT)/$(BOARD).json: $(ENGINE) $(BOARD_V) $(OUT)/settings
	@$(call need,$(SYNTH_YOSYS),$(SYNTH_SETUP))
	@echo "  YOSYS   $@"
	@cd $(OUT)/rtl && $(SYNTH_YOSYS) -q -l ../yosys.log -p "$(SYNTH_CELLS) \
	  read_verilog $$(tr '\n' ' ' < sepax.f) $(BOARD_V); chparam $(SET) $(TOP); \
	  techmap -map $(FPGA)/cells/$(SYNTH_PRODUCTS); hierarchy -top $(TOP); proc; opt_expr; \
	  opt_clean; $(SYNTH_SUMS) \
	  select sepax_* sepax_mul_* %d ulx3s_* $(TOP); techmap -map $(FPGA)/cells/adders.v; \
	  select -clear; $(SYNTH_FLOW) -top $(TOP); write_json ../$(@F)"

table: $(OUT)/$(ROUTED)
	@jq -r -f report.jq $(OUT)/report.json
