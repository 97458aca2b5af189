# SPDX-License-Identifier: MIT
# Makefile - the verbs of sepax; `make help` lists them. scripts/make/ has the rules behind them.

# The input of a simulation: two meshes, PAIRS=file, or COUNT seeded hard pairs.
MESH_A     ?= $(BUILD)/mesh/cutter.stl
MESH_B     ?= $(BUILD)/mesh/workpiece.stl
# The sample objects need 16 bits at a resolution of 0.002.
SHORT_WORD  = $(filter 4 5 6 7 8 9 10 11 12 13 14 15,$(WORD))
RESOLUTION ?= $(if $(SHORT_WORD),fit,$(if $(filter $(BUILD)/mesh/%,$(MESH_A)),0.002,fit))
NORMALS    ?= computed
COUNT      ?= 100000
SEED       ?= 1
VIEW       ?= behavioural

# Tools and the cell library.
CC         ?= cc
CXX        ?= c++
YOSYS      ?= yosys
VERILATOR  ?= verilator
IVERILOG   ?= iverilog
VVP        ?= vvp
CPPCHECK   ?= cppcheck
CLANG_TIDY ?= clang-tidy
OSU018      = /usr/share/qflow/tech/osu018/osu018_stdcells.lib
LIBERTY    ?= $(or $(wildcard $(OSU018)),synth/area/generic.lib)
STA        ?= sta
KLAYOUT    ?= klayout
GNUPLOT    ?= gnuplot
export CC CXX YOSYS VERILATOR IVERILOG VVP CPPCHECK CLANG_TIDY STA KLAYOUT GNUPLOT LIBERTY

BUILD  ?= build
PREFIX ?= /usr/local

# Verilator compiles C++ through this script, which keeps what all designs share in a folder.
export OBJCACHE ?= $(abspath scripts/make/compile) $(abspath $(BUILD))/compiled
SEPAX   = $(BUILD)/sepax
LIB     = $(addprefix $(BUILD)/obj/,models.a lib.a)
IO      = $(BUILD)/obj/io.a
PUBLIC  = $(addprefix $(BUILD)/,libsepax-model.a libsepax-io.a libsepax.a)
GEN     = $(SEPAX) gen

# The default clock of a design for an FPGA. Only exact has this option.
ifneq ($(and $(filter-out asic,$(TARGET)),$(filter exact,$(or $(ARCH),exact))),)
export CLOCK_NS ?= 10
endif
given   = $(filter command environment,$(firstword $(origin $(1))))
is_on   = $(filter-out 0 off no,$($(1)))

include scripts/make/variables.mk
ifeq ($(strip $(BUILD)),)
$(error BUILD is empty; give a folder, or leave it out)
endif
ifneq ($(words $(BUILD) $(abspath .)),2)
$(error BUILD and the project's own path must be without blanks)
endif
# If a folder of BUILD cannot be written, say so in one line before anything is made.
ifeq ($(findstring n,$(firstword -$(MAKEFLAGS))),)
ifneq ($(filter-out help help-all clean setup uninstall mutations,$(or $(MAKECMDGOALS),all)),)
unwritable := $(shell mkdir -p "$(BUILD)" 2> /dev/null; for folder in "$(BUILD)" "$(BUILD)"/*/; do \
                [ -w "$$folder" ] || [ "$$folder" = "$(BUILD)/*/" ] || \
                { echo "$${folder%/}"; break; }; done)
ifneq ($(unwritable),)
$(error $(unwritable) cannot be written; change its owner or its permissions, or give BUILD=FOLDER)
endif
endif
endif

# -r: make's built-in rules are not used, and trying them for each header took most of its time.
MAKEFLAGS += --no-print-directory -r
.DELETE_ON_ERROR:
.DEFAULT_GOAL = all
.PHONY: FORCE

# The rules of each engine.
ENGINES = $(wildcard scripts/make/engines/*.mk)

# Rules of one design: scripts/make/design.mk calls make again with the variables that `sepax name`
# prints, among them DESIGN_NAME.
ifneq ($(DESIGN_NAME),)
include $(addprefix scripts/make/,flags.mk mesh.mk cosim.mk) $(ENGINES)
include scripts/make/$(if $(filter-out asic,$(TARGET)),fpga,synth).mk
else
include $(addprefix scripts/make/,flags.mk mesh.mk build.mk) $(ENGINES) scripts/make/design.mk
ifeq ($(DESIGN),)
include $(addprefix scripts/make/,install.mk python.mk quality.mk)

# The names that `make experiment` takes; scripts/make has the rules of some.
EXPERIMENTS = accuracy area-sweep bench bench-bodies bench-meshes bench-python by-hand calibrate \
              clearance cocotb compare-meshes corpus coverage distances driver engine-sweep \
              estimate exhaustive fuzz guard guard-time hard impeller machine material multivt \
              mutation mutation-c netlist-sweep packages path-campaign posed-pairs proofs \
              random-designs sanitize scene slurm static tree-campaign tree-fuzz tree-scene \
              tree-sweep verify

.PHONY: all job help help-all build setup test experiment $(EXPERIMENTS:%=experiment-%) \
        reference clean paper area timing power fpga layout report \
        mutations

all:
	@scripts/setup job
	@$(MAKE) job

# Not a failure: SIGPIPE ended the command, because a reader such as head had read enough.
READER_LEFT = [ $$? -eq 141 ]

help:
	@cat scripts/make/help.txt || $(READER_LEFT)

help-all:
	@cat scripts/make/help.txt scripts/make/help-all.txt || $(READER_LEFT)
	@{ if [ -x $(SEPAX) ]; then $(MAKE) -s $(SEPAX) > /dev/null && $(SEPAX) name --list; \
	  else echo "The variables of a design are listed here after make build."; fi; } || $(READER_LEFT)

build:
	@scripts/setup build
	@$(MAKE) $(PROGRAM) $(PUBLIC)

setup:
	@scripts/setup

test:
	@scripts/setup
	@scripts/test $(if $(call is_on,QUICK),-q) $(TESTS)

experiment:
	@$(if $(filter $(NAME),$(EXPERIMENTS)),$(MAKE) experiment-$(NAME),echo "experiment: NAME=$(NAME) \
	  is not one of: $(EXPERIMENTS)" >&2; exit 2)

experiment-cocotb: $(SEPAX)
	@tb/packaging/cocotb
	@$(if $(call is_on,FAULTS),tb/packaging/faults)

clean:
	rm -rf $(BUILD)

# Both architectures; only one if ARCH is given, or an option that only exact has.
ONLY_EXACT = $(strip $(foreach name,II VIEW $(shell $(SEPAX) name --only),$(call given,$(name))))
ARCHS      = $(if $(call given,ARCH),$(ARCH),exact $(if $(ONLY_EXACT),,paper))

job: $(SEPAX)
	@$(foreach arch,$(ARCHS), \
	  echo "== architecture $(arch) against its golden model: $(MESH_A), $(MESH_B)" && \
	  $(MAKE) ARCH=$(arch) cosim &&) true
	@echo "== gates"
	@$(MAKE) area

# Designs of W = 18: all of them in build/, or with REFERENCE=rtl those that come with the source.
REFERENCE ?= $(BUILD)/reference
REFERENCE_DESIGNS = exact-w18-ii3 paper-w18 \
                    $(if $(filter rtl,$(REFERENCE)),,exact-w18-ii1 engine-w18-k4)
REFERENCE_exact-w18-ii3 = --word=18 --ii=3
REFERENCE_exact-w18-ii1 = --word=18 --ii=1
REFERENCE_engine-w18-k4 = --word=18 --ii=3 --lanes=4
REFERENCE_paper-w18     = --arch=paper --word=18
reference: $(SEPAX)
	@mkdir -p $(REFERENCE)
	@$(foreach name,$(REFERENCE_DESIGNS),rm -rf $(REFERENCE)/$(name) && \
	  $(SEPAX) gen $(REFERENCE_$(name)) -o $(REFERENCE)/$(name) &&) true

# ------------------------------------------------------------------ gates, clock, power

# Before anything is compiled, look for the tools that a verb needs, also in build/venv.
TOOLS_paper  = yosys verilator c++
TOOLS_area   = yosys python3
TOOLS_timing = yosys jq sta
TOOLS_layout = yosys jq sta klayout
TOOLS_power  = yosys jq
TOOLS_fpga   = yosys jq
NEEDING      = $(addprefix need-,paper area timing layout power fpga)
.PHONY: $(NEEDING)
$(NEEDING): need-%:
	@scripts/need $* $(TOOLS_$*)
	@$(CHECK_$*)
CHECK_layout = synth/layout/run -c && { [ -n "$(or $(LEF),$(wildcard $(LIBERTY:.lib=.lef)))" ] || \
               { echo 'layout: give LEF="FILE ..." of $(notdir $(LIBERTY))' >&2; exit 2; }; }
ROUTED_HERE  = $(filter ecp5 ice40 gowin,$(if $(call given,TARGET),$(TARGET),ecp5 ice40 gowin))
# If the program is built, it refuses a design that does not exist before the tools are asked.
CHECK_fpga   = { [ ! -x $(SEPAX) ] || $(SEPAX) name --environment > /dev/null; } && \
               $(foreach target,$(ROUTED_HERE),synth/fpga/route -c $(target) &&) true

# The designs of `make area`: the design that is given. Without one: exact, and paper in two
# precisions, because the paper's word length can be read both ways; with conference also paper.
PAPERS     = "ARCH=paper PRECISION=full" "ARCH=paper PRECISION=word" \
             "ARCH=paper PRECISION=full MULTIPLIERS=generated"
BESIDE     = $(foreach bits,full word, \
             "ARCH=conference PRECISION=$(bits)" "ARCH=paper PRECISION=$(bits)")
PAIR_II    = "ARCH=exact II=3" "ARCH=exact II=1"
AREAS_paper      = $(if $(call given,PRECISION),"",$(PAPERS))
AREAS_conference = $(if $(call given,PRECISION),"" ARCH=paper,$(BESIDE))
AREAS      = $(if $(call given,ARCH),$(or $(AREAS_$(ARCH)),""),$(if \
             $(ONLY_EXACT),"",$(PAIR_II) $(PAPERS)))
TIMINGS    = $(if $(call given,ARCH)$(ONLY_EXACT),"",$(PAIR_II))
POWERS     = $(if $(call given,ARCH)$(ONLY_EXACT),"", \
             "ARCH=paper PRECISION=full MULTIPLIERS=generated" $(PAIR_II) \
             "ARCH=exact II=3 EARLY_OUT=boxes")
AREA_JSON ?= $(BUILD)/area.json

# Tables 3 and 4 of the paper, with our figures in each row.
paper: need-paper $(SEPAX) $(BUILD)/liberty
	@scripts/paper

area: need-area $(SEPAX) $(BUILD)/liberty
	@scripts/designs -j 2 mapped $(AREAS)
	@synth/report/tables gates -o $(AREA_JSON) $$(scripts/designs area-file $(AREAS) | sort)

timing: need-timing $(SEPAX) $(BUILD)/liberty
	@scripts/designs timed $(TIMINGS)
	@synth/report/tables timing -o $(BUILD)/timing.json $$(scripts/designs timing-file $(TIMINGS))

# Place and route the design that is given, or else the smallest. BLOCKS names modules of it.
LAYOUTS = $(if $(call given,ARCH)$(ONLY_EXACT),"","WORD=4 II=18")
layout: need-layout $(SEPAX) $(BUILD)/liberty $(BUILD)/layout
	@scripts/designs laid $(LAYOUTS)
	@synth/report/tables layout -o $(BUILD)/layout.json $$(scripts/designs layout-file $(LAYOUTS))

LIBERTY_FAST ?= $(LIBERTY)
experiment-multivt: $(SEPAX) $(BUILD)/liberty
	@$(MAKE) LIBERTY=$(LIBERTY_FAST) assigned

power: need-power $(SEPAX) $(BUILD)/liberty $(BUILD)/power
	@scripts/designs powered $(POWERS)
	@synth/report/tables power -o $(BUILD)/power.json $$(scripts/designs power-file $(POWERS))

# Cells and clocks on FPGAs, of the design that is given, or else of these.
FPGAS = $(if $(call given,TARGET)$(ONLY_EXACT),"", \
        "TARGET=ecp5 II=3" "TARGET=ice40 WORD=8 II=9" "TARGET=xc7 II=3" "TARGET=xc7 II=1" \
        "TARGET=xcup II=3" "TARGET=gowin II=3")
fpga: need-fpga $(SEPAX)
	@scripts/designs -j 2 routed $(FPGAS)
	@synth/report/tables fpga -o $(BUILD)/fpga.json $$(scripts/designs fpga-file $(FPGAS))

# Mapped cells against the golden model: three W, three II, every family. A full run takes hours.
experiment-netlist-sweep: $(SEPAX)
	@synth/fpga/sweep $(if $(call given,COUNT),-c $(COUNT)) $(if $(call given,WORD),-w "$(WORD)") \
	  $(if $(call given,II),-i "$(II)") $(if $(call given,TARGET),-t "$(TARGET)") \
	  $(BUILD)/netlist-sweep

# Single faults in the netlist of the design that is given, or else of these.
MUTATIONS = $(if $(call given,ARCH)$(ONLY_EXACT),"", \
            "WORD=8 II=1" "WORD=6 II=3" "WORD=6 II=1 EARLY_OUT=boxes" \
            "WORD=4 II=3 CLEARANCE=1 WARNING=3" "ARCH=paper WORD=4" \
            "WORD=4 II=3 LANES=4 MEMORY_A=128 MEMORY_B=128" "WORD=6 II=6 TREE=1")
experiment-mutation: $(SEPAX)
	@scripts/designs mutated $(MUTATIONS)
# Faults planted by hand in control, buses and memories; NAMES is a pattern that chooses some.
experiment-by-hand: $(SEPAX) $(LIB) $(IO)
	@tb/mutation/hardware/by_hand $(if $(NAMES),-n '$(NAMES)')
mutations:
	@printf '%s\n' $(MUTATIONS)

# ------------------------------------------------------------------------- experiments

EXPERIMENT = scripts/experiments
OVER       = $(if $(call given,WORD),-w "$(WORD)") $(if $(call given,II),-i "$(II)")

experiment-area-sweep: $(SEPAX) $(BUILD)/liberty
	@PERIOD=$(PERIOD) $(EXPERIMENT)/area-sweep $(OVER) $(BUILD)/area-sweep

experiment-calibrate: $(SEPAX) $(BUILD)/liberty
	@$(EXPERIMENT)/calibrate $(OVER) $(if $(CLOCKS),-c "$(CLOCKS)") \
	  $(if $(RANDOM),-r $(RANDOM) -n $(SEED)) $(BUILD)/calibrate

experiment-estimate: $(SEPAX) $(BUILD)/liberty $(BUILD)/power \
  $(addprefix $(BUILD)/mesh/,cutter.stl workpiece.stl)
	@$(EXPERIMENT)/estimate map $(or $(RANDOM),40) $(if $(call given,SEED),$(SEED),2) \
	  $(BUILD)/estimate
	@$(EXPERIMENT)/estimate check -o $(BUILD)/estimate/estimate.json $(BUILD)/estimate

experiment-scene: $(SEPAX) $(BUILD)/liberty
	@PERIOD=$(PERIOD) $(EXPERIMENT)/scene $(BUILD)/scene

report: $(SEPAX) $(BUILD)/liberty
	@$(EXPERIMENT)/report $(if $(call is_on,QUICK),-q) $(if $(call is_on,TREE),-t) $(BUILD)/report

experiment-accuracy: $(SEPAX) $(BUILD)/bench
	@$(EXPERIMENT)/accuracy $(if $(call is_on,QUICK),-q) $(BUILD)/accuracy $(MESHES)

experiment-clearance: $(BUILD)/clearance-pairs
	@$(EXPERIMENT)/clearance $< $(if $(call given,COUNT),$(COUNT),10000000) $(BUILD)/clearance

experiment-bench: $(SEPAX) $(BUILD)/bench $(BUILD)/bench_batch
	@$(EXPERIMENT)/bench $(BUILD)/software $(if $(call given,COUNT),$(COUNT))
	@echo "== verilated core with its golden model, all families:"
	@$(MAKE) PAIRS=families cosim

experiment-posed-pairs: $(BUILD)/posed-pairs
	@$(EXPERIMENT)/campaign $< $(if $(call given,COUNT),$(COUNT),10000000) $(SEED)

experiment-distances: $(BUILD)/distances
	@$(EXPERIMENT)/distances $< $(if $(call given,COUNT),$(COUNT),1000000) $(SEED)

experiment-material: $(BUILD)/material
	@$< --bodies=$(if $(call given,COUNT),$(COUNT),100000) --seed=$(SEED)

# A folder of real meshes, if there is one.
MESH_DIR ?= $(wildcard ../shared/meshes)
experiment-bench-bodies: $(BUILD)/bench_bodies
	@$(MAKE) -C examples/five-axis BUILD=$(abspath $(BUILD)) scene
	@MESH_DIR="$(MESH_DIR)" $(EXPERIMENT)/bodies $(BUILD)/bodies \
	  $(if $(call given,COUNT),$(COUNT),1000) $(MESHES)

# The example's mill, period by period.
experiment-machine: $(BUILD)/bench_machine
	@$(MAKE) -s -C examples/five-axis scene BUILD=$(abspath $(BUILD)) > /dev/null
	@$(BUILD)/bench_machine $(BUILD)/five-axis $(if $(call given,COUNT),$(COUNT),100000)

# Our readers of meshes beside other readers. PYTHON should have trimesh.
PYTHON      ?= $(firstword $(wildcard $(BUILD)/venv/bin/python) python3)
MESH_READER  = $(addprefix $(BUILD)/,mesh_files mesh_writer)
experiment-bench-meshes: $(MESH_READER)
	@$(PYTHON) $(EXPERIMENT)/mesh-times $(if $(call is_on,QUICK),-q) \
	  $(if $(call given,COUNT),-n $(COUNT)) $(BUILD)/bench-meshes
experiment-compare-meshes: $(BUILD)/mesh_files
	$(if $(MESH_DIR),,@echo "compare-meshes: give MESH_DIR=FOLDER" >&2; exit 2)
	@$(PYTHON) $(EXPERIMENT)/meshes -o $(BUILD)/compare-meshes.json "$(MESH_DIR)" $(MESHES)

# Points inside and outside of real meshes.
experiment-corpus: $(BUILD)/solid-corpus
	$(if $(MESH_DIR),,@echo "corpus: give MESH_DIR=FOLDER" >&2; exit 2)
	@$(EXPERIMENT)/corpus $(if $(call given,COUNT),-n $(COUNT)) -s $(SEED) $(BUILD)/corpus \
	  "$(MESH_DIR)" $(MESHES)

experiment-hard: $(SEPAX)
	@$(EXPERIMENT)/hard $(if $(call given,COUNT),$(COUNT))

experiment-packages: $(SEPAX)
	@$(EXPERIMENT)/packages $(BUILD)/packages

experiment-engine-sweep: $(SEPAX) $(BUILD)/liberty
	@LIBERTY="$(if $(call given,LIBERTY),$(LIBERTY))" $(EXPERIMENT)/engine-sweep $(BUILD)/engine-sweep

# COUNT runs without the host, and an eighth as many with it.
experiment-tree-fuzz: COUNT_OF = $(if $(call given,COUNT),$(COUNT),1000000)
experiment-tree-fuzz: $(SEPAX) $(LIB)
	@DESIGN="--word=8 --ii=6" RUNS=10 FUZZ=$(COUNT_OF) tb/tree_engine/modules/walks
	@$(MAKE) WORD=8 II=6 FUZZ=$$(($(COUNT_OF) / 8)) COUNT= SEED= cosim

# Random designs; COUNT in all, with those of docs/developers/results/random-designs.tsv.
experiment-random-designs: $(SEPAX) $(LIB) $(IO)
	@$(EXPERIMENT)/random-designs $(if $(call given,COUNT),$(COUNT),2000) $(SEED)

experiment-tree-scene: $(SEPAX)
	@$(MAKE) SCENE=$(if $(call given,COUNT),$(COUNT),10000) COUNT= SEED= cosim

CLAIMS = $(addprefix $(BUILD)/unit/tree/,walk turned_boxes posed_clearance)
experiment-tree-campaign: $(SEPAX) $(CLAIMS)
	@scripts/tree_engine/campaign $(if $(SHARE),-s $(SHARE)) $(BUILD)/tree-campaign

experiment-path-campaign: $(SEPAX) $(LIB) $(BUILD)/sepax-certificate-check
	@scripts/experiments/paths $(BUILD)/path-campaign $(if $(call given,COUNT),$(COUNT),100) \
	  $(or $(GRAZES),10) $(SEED)

experiment-guard: $(SEPAX)
	@tb/guard/crashes

experiment-guard-time: $(SEPAX)
	@tb/guard/times

experiment-impeller: $(SEPAX)
	@scripts/experiments/impeller $(BUILD)/impeller $(or $(CELLS),0.25 0.2 0.1)

experiment-tree-sweep: $(SEPAX) $(BUILD)/refine $(BUILD)/bench_tree
	@MESH_DIR="$(MESH_DIR)" scripts/tree_engine/sweep $(if $(call given,COUNT),-c $(COUNT)) \
	  $(if $(SWEEP),-s "$(SWEEP)") $(BUILD)/tree-sweep

endif
endif
