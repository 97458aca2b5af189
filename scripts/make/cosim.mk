# SPDX-License-Identifier: MIT
# cosim.mk - the Verilog of the design DESIGN_NAME, and its simulations. `sepax name` gave the
# design's options, as OPTIONS for the program and each as a variable, and its DESIGN_ENGINE.

CORE = $(BUILD)/core/$(DESIGN_NAME)
RTL  = $(CORE)/rtl/sepax.f
# A make that a rule starts is for another design.
MAKEOVERRIDES =
unexport DESIGN_NAME DESIGN_ENGINE OPTIONS VERDICT_OPTIONS

ifneq ($(and $(filter-out exact,$(ARCH)),$(call given,VIEW)),)
$(error VIEW: architecture $(ARCH) has one view only; leave it out)
endif

.PHONY: core options rtl lint cosim cosim-core cosim-core-icarus experiment-exhaustive wave mutated

core:
	@echo $(CORE)
options:
	@echo $(OPTIONS)

# Generated on every run, so that a wrong option is always refused, but moved into place only if the
# files differ.
$(RTL): $(SEPAX) FORCE
	@new=$(CORE).$$$$ && mkdir -p $(@D) && trap 'rm -rf $$new' EXIT && \
	$(GEN) $(OPTIONS) -o $$new > /dev/null && { diff -rq $$new $(@D) > /dev/null 2>&1 || \
	  { echo "  GEN     $(@D)"; rm -rf $(@D) && mv $$new $(@D); }; }

rtl: $(RTL)
	@echo "$(CORE)/rtl: $$(wc -l < $(RTL)) modules$$(sed -n \
	  's/^ *"latency": \([0-9]*\),/, latency \1 cycles/p' $(CORE)/rtl/sepax.json), II $(II)"

lint: $(RTL)
	@cd $(CORE)/rtl && $(abspath scripts/lint) $(LINT_TOOLS)

# ------------------------------------------------------------------------- data

MESH_ARGS = $(if $(filter fit,$(RESOLUTION)),,--resolution=$(RESOLUTION)) \
            --normals=$(NORMALS) "$(MESH_A)" "$(MESH_B)"
SAMPLES   = $(filter $(BUILD)/mesh/%,$(MESH_A) $(MESH_B))
SEEDED    = --count=$(COUNT) --seed=$(SEED)
STRESSED  = $(if $(STRESS),--stress=$(STRESS))
PAIR_ARGS = $(if $(filter families,$(PAIRS)),$(SEEDED),$(if \
            $(filter corners within beyond overlaps powers axes,$(PAIRS)),--$(PAIRS) \
            $(SEEDED),$(if $(filter grid,$(PAIRS)),--sample --count=$(COUNT),$(if \
            $(filter bits,$(PAIRS)),--bits,--pairs="$(PAIRS)"))))

# Two meshes have too many pairs for a simulation of gates, unless the user names the meshes.
GATE_MESHES = $(if $(PAIRS),,$(if $(call given,MESH_A),$(SAMPLES)))
GATE_ARGS   = $(if $(PAIRS),$(PAIR_ARGS),$(if $(call given,MESH_A),$(MESH_ARGS),$(SEEDED)))

# Of the variables that choose pairs, those that this run of `make cosim` reads. Any other one is an
# error, because its value would be ignored.
SIMULATED = $(if $(call is_on,NETLIST),netlist,$(filter object tree,$(DESIGN_ENGINE)))
ifeq ($(MAKECMDGOALS),cosim)
OF_PAIRS = MESH_A MESH_B RESOLUTION NORMALS PAIRS COUNT SEED STRESS VIEW SIMULATOR NETLIST \
           POSES JOBS LATENCY MODES BUDGET ROUNDS FUZZ SCENE GRID PAIR
RUN      = $(or $(SIMULATED),core)$(if $(filter icarus,$(SIMULATOR)),-icarus)
MESHED   = MESH_A MESH_B RESOLUTION NORMALS
DRAWN    = PAIRS $(if $(filter families corners within beyond overlaps powers axes,$(PAIRS)),COUNT \
           SEED) $(if $(filter grid,$(PAIRS)),COUNT)
LISTED_PAIRS = PAIRS $(if $(filter-out families,$(PAIRS)),,COUNT SEED)
READ_core           = VIEW STRESS SIMULATOR NETLIST $(if $(PAIRS),$(DRAWN),$(MESHED))
READ_core-icarus    = VIEW STRESS SIMULATOR NETLIST $(LISTED_PAIRS)
READ_netlist        = STRESS SIMULATOR NETLIST $(if $(PAIRS),$(DRAWN),$(if \
                      $(call given,MESH_A),$(MESHED),COUNT SEED))
READ_netlist-icarus = SIMULATOR NETLIST $(LISTED_PAIRS)
READ_object         = VIEW STRESS SIMULATOR NETLIST PAIRS $(if $(PAIRS),,MESH_A MESH_B RESOLUTION)
READ_tree           = VIEW STRESS SIMULATOR NETLIST $(if \
                      $(POSES),,MESH_A MESH_B PAIRS) $(if $(JOBS),JOBS LATENCY,$(if \
                      $(POSES),POSES LATENCY MODES BUDGET RESOLUTION MESH_A MESH_B,$(if \
                      $(FUZZ),FUZZ,$(if $(SCENE),SCENE,ROUNDS))))
unread := $(filter-out $(READ_$(RUN)),$(filter $(OF_PAIRS),$(on_line)))
unread := $(firstword $(foreach v,$(unread),$(if $(strip $($(v))),$(v))))
ifneq ($(and $(READ_$(RUN)),$(unread)),)
$(error cosim: this run does not read $(unread); it reads $(strip $(READ_$(RUN))); leave \
  $(unread) out$(if $(and $(if $(PAIRS),,none),$(filter core netlist,$(RUN)),$(filter \
  COUNT SEED,$(unread))),$(comma) or give PAIRS=families))
endif
ifneq ($(and $(filter %-icarus,$(RUN)),$(filter corners within beyond overlaps powers axes \
  grid,$(PAIRS))),)
$(error cosim: SIMULATOR=icarus takes PAIRS=FILE, families or bits; leave out SIMULATOR for \
  PAIRS=$(PAIRS))
endif
# A file that is not there is said before anything is compiled. The sample meshes are made.
NAMED_PAIRS = families corners within beyond overlaps powers axes grid bits
FILES_READ := $(if $(PAIRS),$(if $(filter $(NAMED_PAIRS) -,$(PAIRS)),,'$(PAIRS)'),$(if \
              $(mesh_named),'$(MESH_A)' '$(MESH_B)'))
no_file    := $(if $(FILES_READ),$(shell for file in $(FILES_READ); do \
              case $$file in ($(BUILD)/mesh/*) continue ;; esac; \
              [ -r "$$file" ] || { echo "$$file"; break; }; done))
OF_FILES   = core core-icarus netlist netlist-icarus $(if $(PAIRS),,object)
ifneq ($(and $(filter $(OF_FILES),$(RUN)),$(no_file)),)
$(error cosim: $(no_file): No such file, or it cannot be read; give $(if \
  $(PAIRS),a file of pairs$(comma) or PAIRS=NAME with one of: $(NAMED_PAIRS),MESH_A and MESH_B))
endif
endif

# ------------------------------------------------------------------------- Verilator

# The view of exact's multipliers that is simulated: its macro, and the suffix of file names.
MODEL_PATH = $(addprefix -I,$(abspath lib io c_model program tb))
VIEW_MACRO = $(if $(filter behavioural,$(VIEW)),-DSEPAX_BEHAVIOURAL)
OF_VIEW    = $(if $(filter behavioural,$(VIEW)),,-structural)
COSIM      = $(CORE)/cosim$(OF_VIEW)
WAVE       = $(CORE)/cosim-wave$(OF_VIEW)
COSIM_TOP  = $(if $(filter stream,$(DESIGN_ENGINE)),sepax_stream,sepax_top)
COSIM_CPP  = $(abspath tb/cosim/cosim.cpp $(OPTIONS_OBJ) $(IO) $(LIB))
COSIM_DEPS = $(RTL) $(LIB) $(IO) $(OPTIONS_OBJ) tb/meshes.h \
             $(wildcard tb/cosim/*.cpp tb/cosim/*.h tb/cosim/*.vlt)

# verilate TOP FLAGS FILES, linked with the libraries of the mesh readers. Without
# -fno-const-bit-op-tree, Verilator 5.006 miscompiles trees of single bits (its issue 4059).
verilate = scripts/need cosim c++ verilator && \
           rm -rf $@ $(CORE)/obj-$(@F) && cd $(CORE)/rtl && { LIBS="$(IO_LIBS)" \
           $(VERILATOR) --cc --exe --build -O3 --noassert -fno-const-bit-op-tree \
           --x-assign fast --x-initial unique --top-module $(1) -f sepax.f $(VIEW_MACRO) $(2) $(3) \
           --Mdir ../obj-$(@F) -o ../$(@F) > ../$(@F).log 2>&1 || \
           { tail -20 ../$(@F).log >&2; exit 1; }; }
# One large file compiles fastest, because each file includes the header of all signals.
one_file    = $(if $(filter -O0 -O1 -Og,$(1)),--output-split 100000000 --output-split-cfuncs 20000)
COSIM_OPT  ?= -O3
COSIM_FLAGS = -MAKEFLAGS "OPT_FAST=$(COSIM_OPT) OPT_GLOBAL=-O2" $(call one_file,$(COSIM_OPT)) \
              -CFLAGS "$(MODEL_PATH) -I../rtl -DSEPAX_ISOLATION" \
              $(abspath tb/cosim/modules.vlt) $(if $(OF_VIEW),-fno-gate)
# -fno-gate: otherwise Verilator moves signals of one instance into the function that all
# multipliers of this kind share, and the build fails.

$(COSIM): $(COSIM_DEPS)
	@echo "  VERILATE $(DESIGN_NAME)$(OF_VIEW)"
	@$(call verilate,$(COSIM_TOP),$(COSIM_FLAGS),$(COSIM_CPP))

$(WAVE): $(COSIM_DEPS)
	@echo "  VERILATE $(DESIGN_NAME)$(OF_VIEW) with waveforms"
	@$(call verilate,$(COSIM_TOP),$(COSIM_FLAGS) --trace-fst,$(COSIM_CPP))

# The test bench: for the core in Verilator or Icarus, for its mapped gates, or for an engine.
cosim: cosim-$(or $(SIMULATED),core)$(if $(filter icarus,$(SIMULATOR)),-icarus)

cosim-core: $(COSIM) $(if $(PAIRS),,$(SAMPLES))
	@$(COSIM) $(if $(PAIRS),$(PAIR_ARGS),$(MESH_ARGS)) $(STRESSED)

# 3^18 pairs, or the first GRID of them.
GRID ?= 387420489
experiment-exhaustive: $(COSIM)
	@scripts/experiments/exhaustive $(COSIM) $(GRID)

# A mismatch (exit status 1) leaves a waveform; a pair that cannot be read leaves the old one.
wave: $(if $(PAIR),$(WAVE))
	@[ -n "$(PAIR)" ] || { echo "wave: give PAIR='18 or 24 integers'" >&2; exit 2; }
	@status=0; new=$(CORE)/new.$$$$.fst; trap 'rm -f $$new*' EXIT; \
	  echo '$(PAIR)' | $(WAVE) --pairs=- --wave=$$new || status=$$?; \
	  [ $$status -gt 1 ] || mv $$new $(CORE)/wave.fst; exit $$status
	@echo "$(CORE)/wave.fst; gtkwave $(CORE)/wave.fst $(CORE)/rtl/sepax.gtkw"

# Programs in C on the verilated buses of an engine (scripts/make/engines).
ENGINE_OBJ  = $(CORE)/obj-c
ENGINE_OPT ?= -O3
BUS_FLAGS   = -MAKEFLAGS "OPT_FAST=$(ENGINE_OPT) OPT_GLOBAL=-O2" $(call one_file,$(ENGINE_OPT)) \
              -CFLAGS "-I$(abspath tb) $(MODEL_PATH) -I../rtl $(BUS_CFLAGS)"

# ------------------------------------------------------------------------- mutants

mutated: $(SEPAX) $(LIB)
	@tb/mutation/hardware/measure -c $(if $(call given,COUNT),$(COUNT),2000) -s $(SEED) \
	  $(BUILD)/mutation/$(notdir $(CORE)) $(OPTIONS)

# ------------------------------------------------------------------------- Icarus

TEST_BENCH = tb/cosim/sepax_tb.v
ICARUS     = $(CORE)/icarus$(OF_VIEW).vvp

$(ICARUS): $(RTL) $(TEST_BENCH)
	@scripts/need cosim iverilog vvp
	@cd $(CORE)/rtl && $(IVERILOG) -g2005 -Wall -DSEPAX_ISOLATION $(VIEW_MACRO) -I . \
	  -s sepax_tb -o ../$(@F) -c sepax.f $(abspath $(TEST_BENCH))

# All pairs with coordinates 0, 1.
BITS = awk 'BEGIN { for (n = 0; n < 262144; n++) \
       for (k = 0; k < 18; k++) printf "%d%s", int(n / 2 ^ k) % 2, k < 17 ? " " : "\n" }'

JUDGE = $(SEPAX) judge $(VERDICT_OPTIONS) --echo
$(CORE)/icarus.pairs: $(SEPAX) FORCE
	@mkdir -p $(CORE)
	@$(if $(filter-out families bits,$(PAIRS)),$(JUDGE) "$(PAIRS)",$(if \
	  $(filter bits,$(PAIRS)),$(BITS),$(SEPAX) vectors --word=$(WORD) $(SEEDED)) | \
	  $(JUDGE)) > $@

cosim-core-icarus: $(ICARUS) $(CORE)/icarus.pairs
	@$(VVP) -N $(ICARUS) +pairs=$(CORE)/icarus.pairs $(if $(STRESS),+stall=$(STRESS))
