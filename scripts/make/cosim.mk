# cosim.mk - the Verilog of the design DESIGN_NAME, and what simulates it. `sepax name` gave its
# options: OPTIONS for the program, and each as a variable.

CORE = $(BUILD)/core/$(DESIGN_NAME)
RTL  = $(CORE)/rtl/sepax.f
# Makes that are started from here are of other designs.
MAKEOVERRIDES =
unexport DESIGN_NAME OPTIONS

ifneq ($(and $(filter-out exact,$(ARCH)),$(call given,VIEW)),)
$(error VIEW: architecture $(ARCH) has one view only; leave it out)
endif

.PHONY: core options rtl lint cosim exhaustive wave icarus engine example tree-engine mutated

core:
	@echo $(CORE)
options:
	@echo $(OPTIONS)

# Generated on every run, so that no option goes unread, and moved into place where it differs
# from what is there.
$(RTL): $(SEPAX) FORCE
	@new=$(CORE).$$$$ && mkdir -p $(@D) && trap 'rm -rf $$new' EXIT && \
	$(GEN) $(OPTIONS) -o $$new > /dev/null && { diff -rq $$new $(@D) > /dev/null 2>&1 || \
	  { echo "  GEN     $(@D)"; rm -rf $(@D) && mv $$new $(@D); }; }

rtl: $(RTL)
	@echo "$(CORE)/rtl: $$(wc -l < $(RTL)) modules"

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

# ------------------------------------------------------------------------- Verilator

# The view of exact's arithmetic that is simulated: its macro, and the suffix of what is made of it.
MODEL_PATH = $(addprefix -I,$(abspath lib c_model program))
VIEW_MACRO = $(if $(filter behavioural,$(VIEW)),-DSEPAX_BEHAVIOURAL)
OF_VIEW    = $(if $(filter behavioural,$(VIEW)),,-structural)
COSIM      = $(CORE)/cosim$(OF_VIEW)
WAVE       = $(CORE)/cosim-wave$(OF_VIEW)
COSIM_TOP  = $(if $(filter-out none,$(STREAM)),sepax_stream,sepax_top)
COSIM_CPP  = $(abspath tb/cosim/cosim.cpp $(OPTIONS_OBJ) $(LIB))
COSIM_DEPS = $(RTL) $(LIB) $(OPTIONS_OBJ) $(wildcard tb/cosim/*.cpp tb/cosim/*.h tb/cosim/*.vlt)

# verilate TOP FLAGS FILES: Verilator 5.006 miscompiles trees of single bits (its issue 4059) but
# for -fno-const-bit-op-tree.
verilate = rm -rf $@ $(CORE)/obj-$(@F) && cd $(CORE)/rtl && { $(VERILATOR) --cc --exe --build \
           -O3 --noassert -fno-const-bit-op-tree --x-assign fast --x-initial unique \
           --top-module $(1) -f sepax.f $(VIEW_MACRO) $(2) $(3) \
           --Mdir ../obj-$(@F) -o ../$(@F) > ../$(@F).log 2>&1 || \
           { tail -20 ../$(@F).log >&2; exit 1; }; }
# For a short run one file compiles fastest: each has the header of all signals.
one_file    = $(if $(filter -O0 -O1 -Og,$(1)),--output-split 100000000 --output-split-cfuncs 20000)
COSIM_OPT  ?= -O3
COSIM_FLAGS = -MAKEFLAGS "OPT_FAST=$(COSIM_OPT) OPT_GLOBAL=-O2" $(call one_file,$(COSIM_OPT)) \
              -CFLAGS "$(MODEL_PATH) -I../rtl -DSEPAX_ISOLATION" \
              $(abspath tb/cosim/modules.vlt) $(if $(OF_VIEW),-fno-gate)
# -fno-gate: the function of a kind of multiplier has no signal in it from where one of them stands.

$(COSIM): $(COSIM_DEPS)
	@echo "  VERILATE $(DESIGN_NAME)$(OF_VIEW)"
	@$(call verilate,$(COSIM_TOP),$(COSIM_FLAGS),$(COSIM_CPP))

$(WAVE): $(COSIM_DEPS)
	@echo "  VERILATE $(DESIGN_NAME)$(OF_VIEW) with waveforms"
	@$(call verilate,$(COSIM_TOP),$(COSIM_FLAGS) --trace-fst,$(COSIM_CPP))

cosim: $(COSIM) $(if $(PAIRS),,$(SAMPLES))
	@$(COSIM) $(if $(PAIRS),$(PAIR_ARGS),$(MESH_ARGS)) $(STRESSED)

# 3^18 pairs, or the first GRID of them.
GRID ?= 387420489
exhaustive: $(COSIM)
	@scripts/experiments/exhaustive $(COSIM) $(GRID)

# A mismatch (exit status 1) leaves a waveform; a pair that cannot be read leaves the old one.
wave: $(if $(PAIR),$(WAVE))
	@[ -n "$(PAIR)" ] || { echo "wave: give PAIR='18 or 24 integers'" >&2; exit 2; }
	@status=0; new=$(CORE)/new.$$$$.fst; trap 'rm -f $$new*' EXIT; \
	  echo '$(PAIR)' | $(WAVE) --pairs=- --wave=$$new || status=$$?; \
	  [ $$status -gt 1 ] || mv $$new $(CORE)/wave.fst; exit $$status
	@echo "$(CORE)/wave.fst; gtkwave $(CORE)/wave.fst $(CORE)/rtl/sepax.gtkw"

# The engine: a C program on its verilated buses; the example: the driver on the same buses.
ENGINE     = $(CORE)/engine
ENGINE_OBJ = $(CORE)/obj-c
ENGINE_C   = $(addprefix $(ENGINE_OBJ)/,bench.o crowd.o cycles.o objects.o refusals.o \
             sepax_driver.o)
ENGINE_OPT ?= -O3
BUS_FLAGS   = -MAKEFLAGS "OPT_FAST=$(ENGINE_OPT) OPT_GLOBAL=-O2" $(call one_file,$(ENGINE_OPT)) \
              -CFLAGS "-I$(abspath tb) $(MODEL_PATH) -I../rtl $(BUS_CFLAGS)"

vpath %.c tb/object_engine drivers/object_engine examples/object_engine
$(ENGINE_OBJ)/%.o: %.c $(RTL) $(wildcard tb/object_engine/*.h drivers/object_engine/*.h)
	@mkdir -p $(@D)
	@$(CC) $(SEPAX_CFLAGS) -Itb -Idrivers/object_engine -I$(CORE)/rtl -c $< -o $@

$(ENGINE): $(ENGINE_C) tb/object_engine/bus.cpp tb/object_engine/bus.h $(LIB) $(RTL)
	@echo "  VERILATE $(DESIGN_NAME), the engine"
	@$(call verilate,sepax_engine,$(BUS_FLAGS),$(abspath tb/object_engine/bus.cpp $(ENGINE_C) $(LIB)))

ifeq ($(filter-out 0,$(LANES)),)
engine example:
	@echo "$@: no comparator lanes; give LANES=1 ... 64" >&2; exit 2
else
engine: $(ENGINE) $(if $(filter families,$(PAIRS)),,$(SAMPLES))
	@$(ENGINE) $(STRESSED) $(if $(filter families,$(PAIRS)),,$(if \
	  $(filter-out fit,$(RESOLUTION)),--resolution=$(RESOLUTION)) $(MESH_A) $(MESH_B))

example: $(ENGINE) $(SAMPLES) $(ENGINE_OBJ)/collide.o
	@$(CXX) -o $(CORE)/collide $(ENGINE_OBJ)/collide.o $(ENGINE_OBJ)/sepax_driver.o \
	  $(CORE)/obj-engine/bus.o $(CORE)/obj-engine/Vsepax_engine__ALL.a \
	  $(wildcard $(CORE)/obj-engine/verilated*.o) $(LIB) -lm -pthread
	@$(CORE)/collide "$(MESH_A)" "$(MESH_B)" $(filter-out fit,$(RESOLUTION)) || [ $$? -eq 1 ]
endif

# The tree engine: MESH_A against MESH_B in the poses of a file, or seeded bodies and jobs; FUZZ=n:
# damaged ones; SCENE=n: six bodies in n poses; JOBS: a list of sepax path --jobs.
TREE_ENGINE = $(CORE)/tree-engine
TREE_SRC    = $(wildcard tb/tree_engine/jobs/*.c) tb/object_engine/crowd.c \
              tb/tree_engine/modules/memory.c drivers/tree_engine/sepax_tree_driver.c
TREE_C      = $(patsubst %.c,$(ENGINE_OBJ)/%.o,$(notdir $(TREE_SRC)))
POSE_CHECK  = tb/tree_engine/jobs/sepax_pose_check.sv
TREE_DEPS   = $(RTL) $(POSE_CHECK) $(wildcard $(addsuffix /*.h, \
              tb/tree_engine/modules tb/tree_engine/jobs tb/object_engine drivers/tree_engine))
TREE_CC     = $(CC) $(SEPAX_CFLAGS) -Itb -Idrivers/tree_engine -I$(CORE)/rtl
LATENCY    ?= 100
ROUNDS     ?= 20
MODES      ?= 16

$(TREE_ENGINE): tb/object_engine/bus.cpp $(LIB) $(TREE_DEPS) $(TREE_SRC)
	@echo "  VERILATE $(DESIGN_NAME), the tree engine"
	@mkdir -p $(ENGINE_OBJ)
	@$(foreach c,$(TREE_SRC),$(TREE_CC) -c $(c) -o $(ENGINE_OBJ)/$(notdir $(c:.c=.o)) &&) true
	@$(call verilate,sepax_engine,$(if $(WAVE_FILE),--trace-fst) $(BUS_FLAGS),$(abspath \
	  $(POSE_CHECK) tb/object_engine/bus.cpp $(TREE_C) $(LIB)))

ifeq ($(filter on,$(TREE)),)
tree-engine:
	@echo "tree-engine: no tree engine; give TREE=1" >&2; exit 2
else
tree-engine: $(TREE_ENGINE) $(if $(POSES),$(SAMPLES))
	@$(TREE_ENGINE) $(STRESSED) $(if $(WAVE_FILE),--wave=$(WAVE_FILE)) $(if $(JOBS),\
	  --latency=$(LATENCY) --jobs="$(JOBS)",$(if $(POSES),\
	  --latency=$(LATENCY) --modes=$(MODES) $(if $(BUDGET),--budget=$(BUDGET)) $(if \
	  $(filter-out fit,$(RESOLUTION)),--resolution=$(RESOLUTION)) "$(MESH_A)" "$(MESH_B)" \
	  "$(POSES)",$(if $(FUZZ),--fuzz=$(FUZZ),$(if $(SCENE),--scene=$(SCENE),--rounds=$(ROUNDS)))))
endif

# ------------------------------------------------------------------------- mutants

mutated: $(SEPAX) $(LIB)
	@tb/mutation/measure -c $(if $(call given,COUNT),$(COUNT),2000) -s $(SEED) \
	  $(BUILD)/mutation/$(notdir $(CORE)) $(OPTIONS)

# ------------------------------------------------------------------------- Icarus

TEST_BENCH = tb/cosim/sepax_tb.v
ICARUS     = $(CORE)/icarus$(OF_VIEW).vvp

$(ICARUS): $(RTL) $(TEST_BENCH)
	@cd $(CORE)/rtl && $(IVERILOG) -g2005 -Wall -DSEPAX_ISOLATION $(VIEW_MACRO) -I . \
	  -s sepax_tb -o ../$(@F) -c sepax.f $(abspath $(TEST_BENCH))

# All pairs with coordinates 0, 1.
BITS = awk 'BEGIN { for (n = 0; n < 262144; n++) \
       for (k = 0; k < 18; k++) printf "%d%s", int(n / 2 ^ k) % 2, k < 17 ? " " : "\n" }'

$(CORE)/icarus.pairs: $(SEPAX) FORCE
	@mkdir -p $(CORE)
	@$(if $(filter-out families bits,$(PAIRS)),$(SEPAX) judge $(OPTIONS) --echo "$(PAIRS)",$(if \
	  $(filter bits,$(PAIRS)),$(BITS),$(SEPAX) vectors --word=$(WORD) $(SEEDED)) | \
	  $(SEPAX) judge $(OPTIONS) --echo) > $@

icarus: $(ICARUS) $(CORE)/icarus.pairs
	@$(VVP) -N $(ICARUS) +pairs=$(CORE)/icarus.pairs $(if $(STRESS),+stall=$(STRESS))
