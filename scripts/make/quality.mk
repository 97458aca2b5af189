# quality.mk - static analysis and sanitizers.

.PHONY: static sanitize c_tests raced coverage fuzz fuzz-targets fuzzers
OF_TREE = $(wildcard tb/tree_engine/top/*.c drivers/tree_engine/*.c) synth/power/tree_engine.c
C_SRC   = $(LIB_SRC) $(CLI_SRC) $(wildcard program/formats/missing/*.c) $(filter-out $(OF_TREE), \
          $(wildcard tb/*.c tb/*/*.c tb/*/*/*.c synth/*/*.c synth/*/*/*.c \
          examples/object_engine/*.c drivers/object_engine/*.c \
          examples/ulx3s/host/*.c examples/soc/host/*.c \
          examples/five-axis/*.c))
PATH_OF = $(INCLUDES) -Idrivers/object_engine -Idrivers/tree_engine -I$(BUILD)/static/$(1)
analyse = $(CPPCHECK) --quiet --error-exitcode=1 \
          --enable=warning,style,performance,portability --inline-suppr \
          --suppress=missingIncludeSystem --std=c11 $(call PATH_OF,$(1)) $(2) && \
          printf '%s\n' $(2) | xargs -P 2 -I {} $(CLANG_TIDY) --quiet --warnings-as-errors="*" {} \
          -- -std=c11 -D_POSIX_C_SOURCE=200809L $(call PATH_OF,$(1)) $(XML_CFLAGS) \
          -Xclang -analyzer-config -Xclang max-nodes=$(NODES)

# How far clang-tidy follows the paths of one function: its own default; less far in `make test`.
NODES ?= 225000

# Programs of an engine read headers that come with its Verilog.
static: $(SEPAX)
	@mkdir -p $(BUILD)/static
	@$(GEN) --lanes=4 -o $(BUILD)/static/engine > /dev/null
	@$(GEN) --tree -o $(BUILD)/static/tree > /dev/null
	@$(call analyse,engine,$(C_SRC))
	@$(call analyse,tree,$(OF_TREE))

# What runs the C code: unit tests, with fewer random cases, and tests of the commands.
define run_c_tests
@export SEPAX_COUNT=1000 TREE_COLLISIONS=5000; \
  for unit in $(UNIT); do echo $$unit; $$unit || exit 1; done
@tb/fuzz/inputs $(FUZZ)
@for test in system/cli printed/check system/check system/path system/path_between system/cases \
    system/damaged system/size_mechanism page/data; do \
  SEPAX=$(SEPAX) env -u BUILD -u CFLAGS tb/$$test || [ $$? -eq 77 ] || exit 1; done
endef

sanitize:
	@$(MAKE) BUILD=$(BUILD)/sanitize \
	  CFLAGS="-Og -g1 -fsanitize=address,undefined -fno-sanitize-recover=all \
	          -DFEWER_BY=7" c_tests
	@$(MAKE) BUILD=$(BUILD)/raced CFLAGS="-O0 -g1 -fsanitize=thread" GEN_OBJ= raced
c_tests: $(SEPAX) $(UNIT) $(FUZZ)
	$(run_c_tests)

# Lines and branches that these tests run, by gcov.
coverage:
	@rm -rf $(BUILD)/coverage
	@$(MAKE) BUILD=$(BUILD)/coverage CFLAGS="-O0 -g1 --coverage -DFEWER_BY=5" c_tests
	@scripts/coverage $(BUILD)/coverage $(BUILD)/verify

# Threads that share bodies.
raced: $(BUILD)/unit/body/threads
	@TSAN_OPTIONS=halt_on_error=1 $<

# Fuzz targets with libFuzzer and the sanitizers of clang.
CLANG ?= clang
fuzz: fuzz-targets
	@tb/fuzz/run $(if $(call given,COUNT),-c $(COUNT)) -s $(SEED) $(BUILD)/fuzz $(TARGETS)
fuzz-targets: $(SEPAX)
	@tb/fuzz/run -k "$(CLANG)"
	@$(MAKE) BUILD=$(BUILD)/fuzz CC="$(CLANG)" FUZZER=-fsanitize=fuzzer \
	  CFLAGS="-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all \
	          -fsanitize=fuzzer-no-link" fuzzers
fuzzers: $(FUZZ)

# One page of what stands of all that; nothing is run.
.PHONY: verify
verify:
	@scripts/verify $(BUILD)

# Campaigns on a Slurm cluster of four nodes on this computer; COUNT jobs.
.PHONY: slurm-trial
slurm-trial: $(BUILD)/hard-pairs
	@tb/campaign/slurm $(BUILD)/slurm $(if $(call given,COUNT),$(COUNT))

# All proofs, with every planted fault; a row each in build/verify/proofs.json.
.PHONY: proofs
proofs: $(SEPAX)
	@tb/formal/run

# Which share of small faults in the C code the unit tests see.
.PHONY: mutation-c
mutation-c:
	@tb/mutation/c/run $(if $(call given,COUNT),-c $(COUNT)) -s $(SEED) $(BUILD)/mutants \
	  $(or $(PLACES),lib/verdict lib/batch)
