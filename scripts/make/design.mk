# SPDX-License-Identifier: MIT
# design.mk - verbs of one design: the program reads its options, from DESIGN and from variables
# like WORD=12, refuses what does not go together, and prints its name and its options; make
# runs again with them.

DESIGN_VERBS = core options rtl lint cosim experiment-exhaustive experiment-driver wave flow \
               mapped area-file timed timing-file laid layout-file assigned powered power-file \
               workloads routed fpga-file mutated
OF_DESIGN   := $(filter $(DESIGN_VERBS) $(BUILD)/core/%,$(MAKECMDGOALS))

# With DESIGN every verb is of that design alone.
ifneq ($(DESIGN),)
OF_DESIGN := $(or $(MAKECMDGOALS),all)
endif
LATER = $(if $(filter-out $(DESIGN_VERBS) $(BUILD)/core/%,$(OF_DESIGN)),DESIGN_NAME=)

# Verbs of the design itself work in its folder, one make at a time.
ALONE = $(if $(LATER),,scripts/make/alone $(BUILD)/core/$${name%% *})
.PHONY: $(OF_DESIGN)
$(firstword $(OF_DESIGN) $(DESIGN_VERBS)): $(SEPAX) $(LIB) $(IO) $(OPTIONS_OBJ) \
    $(if $(filter powered,$(OF_DESIGN)),$(BUILD)/power) \
    $(if $(or $(filter mapped timed laid assigned powered flow,$(OF_DESIGN)),$(call \
      is_on,NETLIST)),$(BUILD)/liberty)
	@listed=; $(LISTED) design=$$($(SEPAX) name --make --environment $(DESIGN) $$listed) && \
	  name=$${design#DESIGN_NAME=} && \
	  eval "$(ALONE) $(MAKE) DESIGN= $$design $(LATER) $(OF_DESIGN)"
$(wordlist 2,99,$(OF_DESIGN)): $(firstword $(OF_DESIGN))
	@:
