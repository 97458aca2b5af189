# SPDX-License-Identifier: MIT
# object.mk - the object engine: its test bench and its example.

ifneq ($(DESIGN_NAME),)
.PHONY: cosim-object cosim-object-icarus experiment-driver
ifneq ($(and $(filter object,$(DESIGN_ENGINE)),$(filter cosim,$(MAKECMDGOALS)),$(filter-out \
  families,$(PAIRS))),)
$(error the object engine makes its pairs itself; give MESH_A and MESH_B, or PAIRS=families)
endif
ifneq ($(DESIGN_ENGINE),object)
experiment-driver:
	@echo "driver: no comparator lanes; give LANES=1 ... 64" >&2; exit 2
else

OBJECT_BENCH = $(CORE)/engine
OBJECT_C     = $(addprefix $(ENGINE_OBJ)/,bench.o crowd.o cycles.o objects.o refusals.o \
               sepax_driver.o)

vpath %.c tb/object_engine drivers/object_engine examples/object_engine
$(ENGINE_OBJ)/%.o: %.c $(RTL) $(wildcard tb/object_engine/*.h drivers/object_engine/*.h)
	@mkdir -p $(@D)
	@$(CC) $(SEPAX_CFLAGS) $(ENGINE_OPT) -Itb -Idrivers/object_engine -I$(CORE)/rtl -c $< -o $@

$(OBJECT_BENCH): $(OBJECT_C) tb/object_engine/bus.cpp tb/object_engine/bus.h $(IO) $(LIB) $(RTL)
	@echo "  VERILATE $(DESIGN_NAME), the engine"
	@$(call verilate,sepax_engine,$(BUS_FLAGS),$(abspath tb/object_engine/bus.cpp $(OBJECT_C) \
	  $(IO) $(LIB)))

cosim-object-icarus:
	@echo "cosim: Icarus simulates cores, not engines; leave out SIMULATOR" >&2; exit 2

# MESH_A against MESH_B, or seeded objects.
cosim-object: $(OBJECT_BENCH) $(if $(filter families,$(PAIRS)),,$(SAMPLES))
	@$(OBJECT_BENCH) $(STRESSED) $(if $(filter families,$(PAIRS)),,$(if \
	  $(filter-out fit,$(RESOLUTION)),--resolution=$(RESOLUTION)) $(MESH_A) $(MESH_B))

# The driver on the same buses.
experiment-driver: $(OBJECT_BENCH) $(SAMPLES) $(ENGINE_OBJ)/collide.o
	@$(CXX) -o $(CORE)/collide $(ENGINE_OBJ)/collide.o $(ENGINE_OBJ)/sepax_driver.o \
	  $(CORE)/obj-engine/bus.o $(CORE)/obj-engine/Vsepax_engine__ALL.a \
	  $(wildcard $(CORE)/obj-engine/verilated*.o) $(LIB) -lm -pthread
	@$(CORE)/collide "$(MESH_A)" "$(MESH_B)" $(filter-out fit,$(RESOLUTION)) || [ $$? -eq 1 ]

endif
endif
