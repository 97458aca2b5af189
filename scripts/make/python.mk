# SPDX-License-Identifier: MIT
# python.mk - the Python packages: make python, and what their tests run.

.PHONY: python
python: $(if $(filter yes,$(LIBXML2)),$(SEPAX))
	@BUILD=$(BUILD) scripts/python wheels $(BUILD)/python/dist

# Installed in a folder of build/, where this Python can do so; else with a file that says why not.
PYTHON_SRC = pyproject.toml setup.py MANIFEST.in scripts/python scripts/requirements.txt \
             $(wildcard python/* python/*/* python/*/*/*) \
             $(wildcard lib/*.h lib/*/*.[ch] io/*.h io/*/*.[ch] io/*/*/*.[ch]) \
             $(wildcard $(BUILD)/venv/requirements.txt)
$(BUILD)/python/site.made: $(SEPAX)
$(BUILD)/python/site.made $(BUILD)/python/sanitized.made: $(PYTHON_SRC)
	@echo "  PYTHON  $(basename $@)"
	@BUILD=$(BUILD) scripts/python -k $(notdir $(basename $@)) $(basename $@)
	@touch $@
