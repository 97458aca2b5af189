# tree.mk - test benches of the tree engine's modules.

TREE_BENCH = $(BUILD)/tree
$(TREE_BENCH)/emit: $(call object,tb/tree_engine/modules/emit.c) $(GEN_OBJ) $(LIB)
	$(link)
$(TREE_BENCH)/emit: LIBS = -ljansson
