# SPDX-License-Identifier: MIT
# quality.mk - static analysis and sanitizers.

.PHONY: c_programs fuzz-targets fuzzers
OF_TREE = $(wildcard tb/tree_engine/top/*.c drivers/tree_engine/*.c) synth/power/tree_engine.c
C_SRC   = $(LIB_SRC) $(CLI_SRC) $(filter-out $(OF_TREE), \
          $(wildcard tb/*.c tb/*/*.c tb/*/*/*.c synth/*/*.c synth/*/*/*.c \
          examples/object_engine/*.c drivers/object_engine/*.c \
          examples/ulx3s/host/*.c examples/soc/host/*.c \
          examples/five-axis/*.c))
PATH_OF = $(INCLUDES) -Idrivers/object_engine -Idrivers/tree_engine -I$(BUILD)/static/$(1)
CPPCHECKED = --quiet --error-exitcode=1 --enable=warning,style,performance,portability \
             --inline-suppr --suppress=missingIncludeSystem --std=c11
tidied  = printf '%s\n' $(1) | xargs -P 2 -I {} $(CLANG_TIDY) --quiet --warnings-as-errors="*" {} \
          -- -std=c11 -D_POSIX_C_SOURCE=200809L
FOLLOWED = -Xclang -analyzer-config -Xclang max-nodes=$(NODES)
analyse = $(CPPCHECK) $(CPPCHECKED) $(call PATH_OF,$(1)) $(2) && \
          $(call tidied,$(2)) $(call PATH_OF,$(1)) $(XML_CFLAGS) $(FOLLOWED)
PYTHON_CORE = $(wildcard python/core/*.c)

# How far clang-tidy follows the paths of one function: its default. `make test` gives less.
NODES ?= 225000

# The sources of an engine include headers that are generated with its Verilog.
experiment-static: $(SEPAX)
	@mkdir -p $(BUILD)/static
	@$(GEN) --lanes=4 -o $(BUILD)/static/engine > /dev/null
	@$(GEN) --tree -o $(BUILD)/static/tree > /dev/null
	@$(call analyse,engine,$(C_SRC))
	@$(call analyse,tree,$(OF_TREE))
	@$(CPPCHECK) --library=python $(CPPCHECKED) -Ilib -Iio $(PYTHON_CORE)
	@python=$$($(PYTHON) -c "import sysconfig; print(sysconfig.get_path('include'))") && \
	if [ -e "$$python/Python.h" ]; then \
	  $(call tidied,$(PYTHON_CORE)) -Ilib -Iio -isystem "$$python" $(FOLLOWED); fi

# The program, the unit tests and the fuzz targets. Those in build/sanitize have the sanitizers of
# the compiler; the tests sanitize/... of tb/tests run them.
c_programs: $(SEPAX) $(UNIT) $(FUZZ)
$(BUILD)/sanitize/all: FORCE
	@$(MAKE) BUILD=$(BUILD)/sanitize c_programs \
	  CFLAGS="-Og -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -DFEWER_BY=7"
	@touch $@
$(BUILD)/raced/all: FORCE
	@$(MAKE) BUILD=$(BUILD)/raced CFLAGS="-O1 -g1 -fsanitize=thread -DFEWER_BY=7" GEN_OBJ= \
	  $(addprefix $(BUILD)/raced/unit/,body/threads path/order)
	@touch $@
experiment-sanitize:
	@scripts/test 'sanitize/*'

# Lines and branches that tests run, by gcov: the units, those that are sanitized, others of the
# program.
OF_PROGRAM = accuracy certificate explore guard_tube locale meshes nc_faults nc_read page \
             page_data paper
experiment-coverage:
	@rm -rf $(BUILD)/coverage
	@$(MAKE) BUILD=$(BUILD)/coverage CFLAGS="-O0 -g1 --coverage -DFEWER_BY=5" c_programs
	@chmod -R a+rwX $(BUILD)/coverage # a test of root's runs the program as another user
	@umask 0; tb/unit/all $(BUILD)/coverage
	@umask 0; tb/fuzz/inputs $(BUILD)/coverage/fuzz/*
	@umask 0; awk -F ' *[|] *' '$$2 ~ /sanitized/ { print $$5 }' tb/tests | while read -r test; do \
	  SEPAX=$(BUILD)/coverage/sepax $$test < /dev/null || [ $$? -eq 77 ] || exit 1; done
	@umask 0; SEPAX=$(BUILD)/coverage/sepax scripts/test $(OF_PROGRAM)
	@scripts/coverage $(BUILD)/coverage $(BUILD)/verify

# Fuzz targets with libFuzzer and the sanitizers of clang.
CLANG ?= clang
experiment-fuzz: fuzz-targets
	@tb/fuzz/run $(if $(call given,COUNT),-c $(COUNT)) -s $(SEED) $(BUILD)/fuzz $(TARGETS)
fuzz-targets: $(SEPAX)
	@tb/fuzz/run -k "$(CLANG)"
	@$(MAKE) BUILD=$(BUILD)/fuzz CC="$(CLANG)" FUZZER=-fsanitize=fuzzer \
	  CFLAGS="-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all \
	          -fsanitize=fuzzer-no-link" fuzzers
fuzzers: $(FUZZ)

# One page of the results that are in BUILD. It runs nothing itself.
experiment-verify:
	@scripts/verify $(BUILD)

# Campaigns on a Slurm cluster of four nodes on this computer; COUNT jobs.
experiment-slurm: $(BUILD)/hard-pairs
	@tb/campaign/slurm $(BUILD)/slurm $(if $(call given,COUNT),$(COUNT))

# All proofs, with every planted fault; a row each in build/verify/proofs.json.
experiment-proofs: $(SEPAX)
	@tb/formal/run

# The share of small faults in the C code that the tests see.
experiment-mutation-c:
	@tb/mutation/c/run $(if $(call given,COUNT),-c $(COUNT)) -s $(SEED) $(BUILD)/mutants \
	  $(or $(PLACES),lib/verdict lib/batch)
