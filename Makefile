# Makefile - the front door of sepax; `make help` lists the verbs and variables.

# The design: what `sepax gen --help` calls --arch, --word, ...
ARCH        ?= paper
WORD        ?= 18
II          ?= 3
PRECISION   ?= full
BLOCK_FLOAT ?= off
COPLANARITY ?= plane
INEQUALITY  ?= correct
EPSILON     ?= 1

# What goes through it: two meshes, or PAIRS=file, or COUNT seeded hard pairs.
MESH_A     ?= $(BUILD)/mesh/cutter.stl
MESH_B     ?= $(BUILD)/mesh/workpiece.stl
RESOLUTION ?= $(if $(filter $(BUILD)/mesh/%,$(MESH_A)),0.002,fit)
NORMALS    ?= computed
PAIRS      ?=
PAIR       ?=
COUNT      ?= 100000
SEED       ?= 1
STRESS     ?=

# Tools and the cell library.
CC         ?= cc
CXX        ?= c++
YOSYS      ?= yosys
VERILATOR  ?= verilator
IVERILOG   ?= iverilog
VVP        ?= vvp
CPPCHECK   ?= cppcheck
CLANG_TIDY ?= clang-tidy
LIBERTY    ?= /usr/share/qflow/tech/osu018/osu018_stdcells.lib
export CC CXX YOSYS VERILATOR IVERILOG VVP CPPCHECK CLANG_TIDY LIBERTY

BUILD  ?= build
CFLAGS ?= -O2 -g
SEPAX_CFLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Werror -Wconversion \
               -Wshadow -ffp-contract=off -Ic_model -Irtl_gen $(CFLAGS)

LIB_SRC = $(wildcard c_model/*.c)
CLI_SRC = $(wildcard c_model/cli/*.c) $(wildcard rtl_gen/*.c)
UNIT    = $(patsubst tb/%.c,$(BUILD)/%,$(wildcard tb/test_*.c))
SEPAX   = $(BUILD)/sepax
LIB     = $(BUILD)/libsepax.a
object  = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))

OPTIONS = --arch=$(ARCH) --word=$(WORD) --ii=$(II) --precision=$(PRECISION) \
          --block-float=$(BLOCK_FLOAT) --coplanarity=$(COPLANARITY) \
          --inequality=$(INEQUALITY) --epsilon=$(EPSILON)

# build/core/paper-w18-full, with a suffix for whatever is not the default.
CORE_NAME = $(ARCH)-w$(WORD)-$(subst =,,$(PRECISION))$(if $(filter on,$(BLOCK_FLOAT)),-bf)$(if \
            $(filter paper,$(COPLANARITY)),-cop)$(if $(filter printed,$(INEQUALITY)),-ineq)$(if \
            $(filter-out 1,$(EPSILON)),-e$(EPSILON))
CORE      = $(BUILD)/core/$(CORE_NAME)
MESH_ARGS = $(if $(filter fit,$(RESOLUTION)),,--resolution=$(RESOLUTION)) \
            --normals=$(NORMALS) "$(MESH_A)" "$(MESH_B)"
SAMPLES   = $(filter $(BUILD)/mesh/%,$(MESH_A) $(MESH_B))

ifneq ($(words $(BUILD) $(abspath .)),2)
$(error BUILD and the project's own path must be without blanks)
endif

.DELETE_ON_ERROR:
.PHONY: all job help setup test rtl reference cosim icarus wave lint area mapped netlist bench \
        sanitize sanitized static options core clean FORCE

all:
	@scripts/setup
	@$(MAKE) --no-print-directory job

help:
	@sed -n 's/^#: //p' Makefile

#: make            the main job: 160,000 pairs of two 400-triangle objects through the
#:                 paper's machine, held against the golden model, and its gate report
#: make test       every test (about 15 minutes); ends with N passed, N failed
#: make rtl        the Verilog of the design, in build/core/NAME/rtl
#: make cosim      meshes (MESH_A, MESH_B) or PAIRS=file or PAIRS=families through the
#:                 verilated machine
#: make icarus     the same vectors through Icarus Verilog (PAIRS, or COUNT seeded ones)
#: make wave       PAIR='18 or 24 integers' as a waveform: build/core/NAME/wave.fst
#: make lint       Verilator, Icarus and Yosys on the design's Verilog
#: make area       gates of the design with LIBERTY, beside the paper's
#: make netlist    the mapped gates through the Icarus bench (COUNT=170 takes minutes)
#: make bench      pairs a second of the software verdicts and of the verilated machine
#: make reference  regenerate rtl/, the committed W = 18 cores
#: make setup      install what is missing (Debian, Ubuntu); make and make test do it
#: make clean      remove build/
#:
#: Design:  ARCH=paper WORD=18 II=3 PRECISION=full|word|guard=G BLOCK_FLOAT=off|on
#:          COPLANARITY=plane|paper INEQUALITY=correct|printed EPSILON=1
#: Data:    MESH_A= MESH_B= RESOLUTION=fit|length NORMALS=computed|file PAIRS= COUNT= SEED=
#: Tools:   CC CXX YOSYS VERILATOR IVERILOG VVP CPPCHECK CLANG_TIDY LIBERTY=file.lib[.gz]

setup:
	@scripts/setup

job: $(SEPAX)
	@echo "== the machine of the paper against its golden model: $(MESH_A), $(MESH_B)"
	@$(MAKE) --no-print-directory cosim
	@echo "== its gates"
	@$(MAKE) --no-print-directory area

test:
	@scripts/setup
	@scripts/test

# ------------------------------------------------------------------ the program

$(BUILD)/obj/%.o: %.c
	@mkdir -p $(@D)
	@echo "  CC      $<"
	@$(CC) $(SEPAX_CFLAGS) -MMD -MP -c $< -o $@

$(LIB): $(call object,$(LIB_SRC))
	@rm -f $@
	@$(AR) rcs $@ $^

$(SEPAX): $(call object,$(CLI_SRC)) $(LIB)
	@echo "  LINK    $@"
	@$(CC) $(CFLAGS) $^ -ljansson -lm -o $@

GEN_OBJ = $(filter-out %/cmd_gen.o,$(call object,$(wildcard rtl_gen/*.c)))

$(BUILD)/test_%: $(call object,tb/test_%.c tb/oracle.c tb/mesh_tools.c tb/pair_tools.c) \
                 $(GEN_OBJ) $(LIB)
	@echo "  LINK    $@"
	@$(CC) $(CFLAGS) $^ -lcmocka -lgmp -ljansson -lm -o $@

-include $(wildcard $(BUILD)/obj/*/*.d $(BUILD)/obj/*/*/*.d)

# -------------------------------------------------------------------- the meshes

$(BUILD)/mesh/cutter.stl: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) mesh ball-end --triangles=400 --at=45,0,-20 -o $@

$(BUILD)/mesh/workpiece.stl: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) mesh pocket --triangles=400 -o $@

# ----------------------------------------------------------------- the benchmark

$(BUILD)/bench: $(BUILD)/obj/tb/bench.o $(LIB)
	@$(CC) $(CFLAGS) $^ -lm -o $@

bench: $(BUILD)/bench $(CORE)/cosim
	@echo "software, one core, families uniform and local, W = 18; ratio to float64:"
	@$(BUILD)/bench
	@echo "verilated machine with its golden model, all families:"
	@$(CORE)/cosim --count=$(COUNT) --seed=$(SEED)

# ---------------------------------------------------------------------- the RTL

RTL = $(CORE)/rtl/sepax.f
GEN = $(SEPAX) gen

# Generated on every run, so that no setting goes unread, and moved into place where it
# differs from what is there.
$(RTL): $(SEPAX) FORCE
	@rm -rf $(BUILD)/new-$(CORE_NAME)
	@$(GEN) $(OPTIONS) -o $(BUILD)/new-$(CORE_NAME) > /dev/null
	@if diff -rq $(BUILD)/new-$(CORE_NAME) $(CORE)/rtl > /dev/null 2>&1; then \
	  rm -rf $(BUILD)/new-$(CORE_NAME); \
	else \
	  echo "  GEN     $(CORE)/rtl"; mkdir -p $(CORE) && rm -rf $(CORE)/rtl && \
	  mv $(BUILD)/new-$(CORE_NAME) $(CORE)/rtl; \
	fi

rtl: $(RTL)
	@echo "$(CORE)/rtl: $$(wc -l < $(RTL)) modules"

reference: $(SEPAX)
	@rm -rf rtl/paper-w18
	@$(SEPAX) gen --arch=paper --word=18 -o rtl/paper-w18

lint: $(RTL)
	@cd $(CORE)/rtl && $(abspath scripts/lint)

# ----------------------------------------------------------------- co-simulation

VERILATE = $(VERILATOR) --cc --exe --build -O3 --x-assign unique --x-initial unique \
           --top-module sepax_top -f sepax.f -CFLAGS "-O2 -I$(abspath c_model) -I../rtl" \
           $(abspath tb/cosim.cpp $(BUILD)/obj/c_model/cli/options.o $(LIB))
COSIM_DEPS = $(RTL) tb/cosim.cpp $(LIB) $(BUILD)/obj/c_model/cli/options.o

$(CORE)/cosim: $(COSIM_DEPS)
	@echo "  VERILATE $(CORE_NAME)"
	@cd $(CORE)/rtl && $(VERILATE) --Mdir ../obj-cosim -o ../cosim > ../verilate.log 2>&1 \
	  || { tail -20 ../verilate.log >&2; exit 1; }

$(CORE)/cosim-wave: $(COSIM_DEPS)
	@echo "  VERILATE $(CORE_NAME) with waveforms"
	@cd $(CORE)/rtl && $(VERILATE) --trace-fst --Mdir ../obj-wave -o ../cosim-wave \
	  > ../verilate-wave.log 2>&1 || { tail -20 ../verilate-wave.log >&2; exit 1; }

COSIM_ARGS = $(if $(filter families,$(PAIRS)),--count=$(COUNT) --seed=$(SEED),$(if \
             $(PAIRS),--pairs="$(PAIRS)",$(MESH_ARGS)))

cosim: $(CORE)/cosim $(if $(PAIRS),,$(SAMPLES))
	@$(CORE)/cosim $(COSIM_ARGS) $(if $(STRESS),--stress=$(STRESS))

wave: $(if $(PAIR),$(CORE)/cosim-wave)
	@[ -n "$(PAIR)" ] || { echo "wave: give PAIR='18 or 24 integers'" >&2; exit 2; }
	@echo '$(PAIR)' | $(CORE)/cosim-wave --pairs=- --wave=$(CORE)/wave.fst
	@echo "$(CORE)/wave.fst"

$(CORE)/icarus.vvp: $(RTL) tb/sepax_tb.v
	@cd $(CORE)/rtl && $(IVERILOG) -g2005 -Wall -DSEPAX_REST -I . -s sepax_tb -o ../icarus.vvp \
	  -c sepax.f $(abspath tb/sepax_tb.v)

$(CORE)/icarus.pairs: $(SEPAX) FORCE
	@mkdir -p $(CORE)
	@$(if $(filter-out families,$(PAIRS)),$(SEPAX) judge $(OPTIONS) --echo "$(PAIRS)",$(SEPAX) \
	  vectors --word=$(WORD) --count=$(COUNT) --seed=$(SEED) | $(SEPAX) judge $(OPTIONS) --echo) > $@

icarus: $(CORE)/icarus.vvp $(CORE)/icarus.pairs
	@$(VVP) -N $(CORE)/icarus.vvp +pairs=$(CORE)/icarus.pairs

# --------------------------------------------------------------------- the gates

# Each precision that was not chosen: the paper's word length leaves both readings open.
LIBRARY    = $(basename $(notdir $(LIBERTY:.gz=)))
AREA       = $(CORE)/$(LIBRARY)
PRECISIONS = $(if $(filter command environment,$(firstword $(origin PRECISION))),$(PRECISION),full word)

# Another library of the same name is another library.
$(AREA)/liberty.sum: FORCE
	@[ -r "$(LIBERTY)" ] || { echo "area: $(LIBERTY) cannot be read; give LIBERTY=file.lib[.gz]" >&2; exit 2; }
	@mkdir -p $(AREA)
	@cksum "$(LIBERTY)" > $@.new; if cmp -s $@.new $@; then rm $@.new; else mv $@.new $@; fi

$(AREA)/area.json: $(RTL) $(AREA)/liberty.sum $(wildcard synth/*)
	@echo "  YOSYS   $(CORE_NAME), $(LIBRARY)"
	@synth/area -l $(LIBERTY) -o $(AREA) $(CORE)/rtl

area-of-%:
	@$(MAKE) --no-print-directory PRECISION=$* mapped

mapped: $(AREA)/area.json
	@echo $(AREA)/area.json >> $(BUILD)/area.list

area: $(SEPAX)
	@rm -f $(BUILD)/area.list
	@$(MAKE) --no-print-directory -j2 $(PRECISIONS:%=area-of-%)
	@synth/report -o $(BUILD)/area.json $$(sort $(BUILD)/area.list)

$(AREA)/netlist.vvp: $(AREA)/area.json tb/sepax_tb.v
	@echo "  ICARUS  $(CORE_NAME), mapped to $(LIBRARY)"
	@synth/cells -l $(LIBERTY) -n $(AREA)/netlist.v -o $(AREA)/cells.v
	@$(IVERILOG) -g2005 -I $(CORE)/rtl -s sepax_tb -o $@ $(AREA)/netlist.v $(AREA)/cells.v \
	  tb/sepax_tb.v

# A gate-level pair takes a second at W = 18: ten of each family are many.
netlist: COUNT = 170
netlist: $(AREA)/netlist.vvp $(CORE)/icarus.pairs
	@$(VVP) -N $< +pairs=$(CORE)/icarus.pairs

# ------------------------------------------------------------------ code quality

C_SRC = $(LIB_SRC) $(CLI_SRC) $(wildcard tb/*.c)

static:
	@$(CPPCHECK) --quiet --error-exitcode=1 --enable=warning,style,performance,portability \
	  --inline-suppr --suppress=missingIncludeSystem --std=c11 -Ic_model -Irtl_gen $(C_SRC)
	@printf '%s\n' $(C_SRC) | xargs -P 2 -I {} $(CLANG_TIDY) --quiet \
	  --warnings-as-errors="*" {} -- -std=c11 -D_POSIX_C_SOURCE=200809L -Ic_model -Irtl_gen

sanitize:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/sanitize \
	  CFLAGS="-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all \
	          -DEXACT_PAIRS=50000" sanitized

sanitized: $(SEPAX) $(UNIT)
	@for unit in $(UNIT); do echo $$unit; $$unit || exit 1; done
	@SEPAX=$(SEPAX) tb/cli_test

# What the scripts ask: the options of the design and the name of its folder.
options:
	@echo $(OPTIONS)
core:
	@echo $(CORE)

clean:
	rm -rf $(BUILD)
