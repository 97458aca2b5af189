# SPDX-License-Identifier: MIT
# variables.mk - every variable that a rule reads. If a user gives another one on the command line,
# then this is an error, so that WRD=12 does not make the design of W = 18. A make that another make
# started also has the variables of that one. scripts/make/help-all.txt says what each is for.

# Options of a design: the rows of c_model/design/option_table.c.
DESIGN_VARIABLES := $(shell sed -n 's/^ *{[.]name = "\([a-z-]*\)".*/\1/p' \
                      c_model/design/option_table.c | tr a-z- A-Z_)

VARIABLES = DESIGN NAME TESTS QUICK BUILD PREFIX DESTDIR LIBDIR REFERENCE \
  MESH_A MESH_B RESOLUTION NORMALS PAIRS COUNT SEED PAIR POSES JOBS VIEW SIMULATOR NETLIST \
  STRESS LATENCY MODES BUDGET ROUNDS GRID FUZZ SCENE \
  LIBERTY LIBERTY_FAST LIBERTY_LOW_LEAKAGE LEF GDS PERIOD UNCERTAINTY CORNERS MULTIPLIERS GATING \
  DERATE USE SEEDS BLOCKS CYCLES OPENSTA GLITCHES DEVICE GRADE PACKAGE PLACER PLACEMENTS PART \
  CLOCKS RANDOM MESHES MESH_DIR SWEEP SHARE GRAZES CELLS PLACES TARGETS NAMES NODES FAULTS PERIODS \
  SIMULATE \
  CC CXX CLANG CFLAGS LDFLAGS LDLIBS LD AR OBJCOPY OBJCACHE PYTHON YOSYS VERILATOR IVERILOG VVP \
  CPPCHECK CLANG_TIDY STA KLAYOUT GNUPLOT LIBXML2 LIBZIP LIBMD

# On or off.
SWITCHES = QUICK NETLIST GATING FAULTS OPENSTA
SWITCHED = 1 on yes 0 off no

# What the rules and the tests hand to a make that they start.
HANDED = DESIGN_NAME DESIGN_ENGINE OPTIONS VERDICT_OPTIONS CORE GEN GEN_OBJ FUZZER VISIBILITY \
  BUS_CFLAGS   COSIM_OPT COSIM_FLAGS ENGINE_OPT GATES_OPT LINT_TOOLS WAVE_FILE AREA_JSON

upper     = $(shell echo '$(1)' | tr a-z- A-Z_)
of_user   = $(filter command,$(firstword $(origin $(1))))
on_line  := $(foreach v,$(.VARIABLES),$(if $(call of_user,$(v)),$(v)))
unknown  := $(firstword $(filter-out $(DESIGN_VARIABLES) $(VARIABLES) $(HANDED) MAKEFLAGS \
              MAKEOVERRIDES -*-,$(on_line)))
ifneq ($(if $(filter 0,$(MAKELEVEL)),$(unknown)),)
$(error there is no variable $(unknown); $(if $(filter $(DESIGN_VARIABLES) $(VARIABLES),$(call \
  upper,$(unknown))),write $(call upper,$(unknown)),'make help-all' lists the variables))
endif

# What would be passed over.
# (Scripts ask core and options with the variables of a whole run.)
WITHOUT_PAIRS = build rtl lint area timing layout fpga flow paper install dist
OF_OTHERS     = MESH_A MESH_B RESOLUTION NORMALS PAIRS COUNT SEED PAIR POSES JOBS SIMULATOR \
                NETLIST STRESS LATENCY MODES BUDGET ROUNDS GRID FUZZ SCENE NAME TESTS QUICK
passed_over  := $(firstword $(filter $(OF_OTHERS),$(on_line)))
ifneq ($(and $(filter 0,$(MAKELEVEL)),$(MAKECMDGOALS),$(passed_over)),)
ifeq ($(filter-out $(WITHOUT_PAIRS),$(MAKECMDGOALS)),)
$(error make $(MAKECMDGOALS) does not read $(passed_over); leave it out)
endif
endif
# Those who know sepax gen --prefix would take PREFIX for it.
OF_DESIGN = rtl cosim wave lint area timing power layout fpga
ifneq ($(and $(filter 0,$(MAKELEVEL)),$(filter PREFIX,$(on_line)),$(filter \
  $(OF_DESIGN),$(MAKECMDGOALS))),)
$(error make $(firstword $(filter $(OF_DESIGN),$(MAKECMDGOALS))) does not read PREFIX, the folder \
  of make install; to give modules a prefix run build/sepax gen --prefix=$(PREFIX) -o DIR)
endif
ifneq ($(and $(DESIGN),$(filter DESIGN,$(on_line)),$(filter $(DESIGN_VARIABLES),$(on_line))),)
$(error DESIGN="$(DESIGN)" and $(firstword $(filter $(DESIGN_VARIABLES),$(on_line))) both describe \
  the design; give one of them)
endif
mesh_given := $(filter MESH_A MESH_B,$(on_line))
mesh_named := $(strip $(foreach v,$(mesh_given),$(if $(strip $($(v))),$(v))))
ifeq ($(words $(mesh_named)),1)
$(error $(mesh_named) is one mesh; give MESH_A and MESH_B)
endif
ifneq ($(mesh_given),$(mesh_named))
$(error $(mesh_given) without a name; give MESH_A and MESH_B, or leave them out)
endif
ifneq ($(and $(filter MESH_A,$(on_line)),$(filter PAIRS,$(on_line)),$(MESH_A),$(PAIRS)),)
$(error MESH_A, MESH_B and PAIRS are two sources of pairs; give one of them)
endif
wrong_switch := $(firstword $(foreach v,$(SWITCHES),$(if $(filter-out $(SWITCHED),$($(v))),$(v))))
ifneq ($(wrong_switch),)
$(error $(wrong_switch): '$($(wrong_switch))' is none of: 1, on, yes; 0, off, no)
endif
ifeq ($(filter behavioural structural,$(VIEW)),)
$(error VIEW: '$(VIEW)' is none of: behavioural, structural)
endif
ifneq ($(filter-out verilator icarus,$(SIMULATOR)),)
$(error SIMULATOR: '$(SIMULATOR)' is none of: verilator, icarus)
endif
