# tree.mk - test benches of the tree engine's modules.

TREE = $(BUILD)/tree
$(TREE)/emit: $(call object,tb/tree/emit.c) $(GEN_OBJ) $(LIB)
	$(link)
$(TREE)/emit: LIBS = -ljansson
