# SPDX-License-Identifier: MIT
# tree.mk - the tree engine: its test bench, and those of its modules.

ifeq ($(DESIGN_NAME),)

TREE_MODULES = $(BUILD)/tree
$(TREE_MODULES)/emit: $(call object,tb/tree_engine/modules/emit.c) $(GEN_OBJ) $(LIB)
	$(link)
$(TREE_MODULES)/emit: LIBS = -ljansson

# Poses, jobs, damaged trees and scenes are for a tree engine.
ifneq ($(and $(filter cosim,$(MAKECMDGOALS)),$(filter POSES JOBS FUZZ SCENE,$(on_line))),)
export TREE ?= on
# A list of jobs has the word and the clearances of its design.
LISTED = $(if $(JOBS), \
  listed=$$($(SEPAX) tree "$(JOBS)") && \
  { listed=$$(echo "$$listed" | grep -oE -e '--(word|clearance|warning)=[0-9]+') || \
    { echo "cosim: $(JOBS): no list of jobs" >&2; exit 2; }; } &&)
endif

else
.PHONY: cosim-tree cosim-tree-icarus
ifeq ($(DESIGN_ENGINE),tree)
ifneq ($(and $(filter cosim,$(MAKECMDGOALS)),$(filter MESH_A PAIRS,$(on_line))),)
ifeq ($(strip $(POSES)),)
$(error the tree engine takes MESH_A and MESH_B in the poses of POSES=file, or JOBS=file; without \
  them it gets seeded bodies)
endif
endif

TREE_BENCH  = $(CORE)/tree-engine
TREE_SRC    = $(wildcard tb/tree_engine/top/*.c) tb/object_engine/crowd.c \
              tb/tree_engine/modules/memory.c drivers/tree_engine/sepax_tree_driver.c
TREE_C      = $(patsubst %.c,$(ENGINE_OBJ)/%.o,$(notdir $(TREE_SRC)))
POSE_CHECK  = tb/tree_engine/top/sepax_pose_check.sv
TREE_DEPS   = $(RTL) $(POSE_CHECK) $(wildcard $(addsuffix /*.h, \
              tb/tree_engine/modules tb/tree_engine/top tb/object_engine drivers/tree_engine))
TREE_CC     = $(CC) $(SEPAX_CFLAGS) $(ENGINE_OPT) -Itb -Idrivers/tree_engine -I$(CORE)/rtl
LATENCY    ?= 100
ROUNDS     ?= 20
MODES      ?= 16

$(TREE_BENCH): tb/object_engine/bus.cpp $(IO) $(LIB) $(TREE_DEPS) $(TREE_SRC)
	@echo "  VERILATE $(DESIGN_NAME), the tree engine"
	@mkdir -p $(ENGINE_OBJ)
	@$(foreach c,$(TREE_SRC),$(TREE_CC) -c $(c) -o $(ENGINE_OBJ)/$(notdir $(c:.c=.o)) &&) true
	@$(call verilate,sepax_engine,$(if $(WAVE_FILE),--trace-fst) $(BUS_FLAGS),$(abspath \
	  $(POSE_CHECK) tb/object_engine/bus.cpp $(TREE_C) $(IO) $(LIB)))

# MESH_A against MESH_B in the poses of a file, or seeded bodies and jobs; FUZZ=n: damaged ones;
# SCENE=n: six bodies in n poses; JOBS: a list of sepax path --jobs.
cosim-tree-icarus:
	@echo "cosim: Icarus simulates cores, not engines; leave out SIMULATOR" >&2; exit 2

cosim-tree: $(TREE_BENCH) $(if $(POSES),$(SAMPLES))
	@$(TREE_BENCH) $(STRESSED) $(if $(WAVE_FILE),--wave=$(WAVE_FILE)) $(if $(JOBS),\
	  --latency=$(LATENCY) --jobs="$(JOBS)",$(if $(POSES),\
	  --latency=$(LATENCY) --modes=$(MODES) $(if $(BUDGET),--budget=$(BUDGET)) $(if \
	  $(filter-out fit,$(RESOLUTION)),--resolution=$(RESOLUTION)) "$(MESH_A)" "$(MESH_B)" \
	  "$(POSES)",$(if $(FUZZ),--fuzz=$(FUZZ),$(if $(SCENE),--scene=$(SCENE),--rounds=$(ROUNDS)))))

endif
endif
