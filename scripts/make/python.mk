# SPDX-License-Identifier: MIT
# python.mk - the Python packages: make python, and what their tests run.

.PHONY: python
python: $(if $(filter yes,$(LIBXML2)),$(SEPAX))
	@BUILD=$(BUILD) scripts/python wheels $(BUILD)/python/dist

# The packages, installed in a folder of build/. If this Python cannot do that, then a file there
# says why.
PYTHON_SRC = pyproject.toml setup.py MANIFEST.in scripts/python scripts/requirements.txt \
             $(wildcard python/* python/*/* python/*/*/*) \
             $(wildcard lib/*.h lib/*/*.[ch] io/*.h io/*/*.[ch] io/*/*/*.[ch]) \
             $(wildcard $(BUILD)/venv/requirements.txt)
$(BUILD)/python/site.made: $(SEPAX)
$(BUILD)/python/site.made $(BUILD)/python/sanitized.made: $(PYTHON_SRC)
	@echo "  PYTHON  $(basename $@)"
	@BUILD=$(BUILD) scripts/python -k $(notdir $(basename $@)) $(basename $@)
	@touch $@

# The scenes of bench-bodies as files for Python, and the times of C for them.
$(BUILD)/python_scenes: $(BUILD)/obj/tb/python/scenes.o $(BUILD)/obj/tb/benchmark/bodies_scenes.o \
                        $(LIB)
	@echo "  LINK    $@"
	@$(aside) $(CXX) $^ -lm -pthread -o $$new && $(in_place)
experiment-bench-python: $(BUILD)/python_scenes $(BUILD)/python/site.made
	@MESH_DIR="$(MESH_DIR)" $(PYTHON) scripts/experiments/bench-python \
	  $(BUILD)/bench-python $(if $(call given,COUNT),$(COUNT),10000) $(MESHES)
