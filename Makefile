# Makefile - the front door of sepax; `make help` lists the verbs and variables.

# The design: what `sepax gen --help` calls --arch, --word, ...
ARCH        ?= exact
WORD        ?= 18
II          ?= 3
COPLANAR    ?= exact
CLOCK_NS    ?= 2
EXTENT_A    ?=
EXTENT_B    ?=
EARLY_OUT   ?= none
LANES       ?=
CORES       ?=
MEMORY_A    ?=
MEMORY_B    ?=
CLEARANCE   ?=
WARNING     ?=
PRECISION   ?= full
BLOCK_FLOAT ?= off
COPLANARITY ?= plane
INEQUALITY  ?= correct
EPSILON     ?= 1

# The view of architecture exact that is simulated: behavioural or structural.
VIEW ?= behavioural

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
PERIOD     ?=
MULTIPLIERS ?=
LIBERTY    ?= /usr/share/qflow/tech/osu018/osu018_stdcells.lib
export CC CXX YOSYS VERILATOR IVERILOG VVP CPPCHECK CLANG_TIDY LIBERTY

# Most of what Verilator has compiled is the same for every design.
export OBJCACHE  ?= $(shell command -v ccache)
export CCACHE_DIR ?= $(abspath $(BUILD))/ccache

BUILD  ?= build
PREFIX ?= /usr/local
CFLAGS ?= -O2 -g
SEPAX_CFLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Werror -Wconversion \
               -Wshadow -ffp-contract=off -Ic_model -Irtl_gen -Itb -Isynth $(CFLAGS)

LIB_SRC = $(filter-out c_model/cli/%,$(wildcard c_model/*/*.c))
CLI_SRC = $(wildcard c_model/cli/*.c) $(wildcard rtl_gen/*/*.c)
UNIT    = $(patsubst tb/unit/%.c,$(BUILD)/unit/%,$(wildcard tb/unit/*.c))
SEPAX   = $(BUILD)/sepax
LIB     = $(BUILD)/libsepax.a
object  = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))
TEMPLATES    = $(wildcard rtl_gen/*/*.v)
TEMPLATE_OBJ = $(BUILD)/obj/templates.o

# Choices of one architecture go to it; those of another only when someone made them, so
# that the program refuses them.
given         = $(filter command environment,$(firstword $(origin $(1))))
CHOICES_exact = COPLANAR CLOCK_NS $(if $(filter-out none,$(EARLY_OUT)),EARLY_OUT) $(foreach choice,EXTENT_A EXTENT_B CLEARANCE WARNING LANES CORES MEMORY_A \
                MEMORY_B,$(if $($(choice)),$(choice)))
CHOICES_paper = PRECISION BLOCK_FLOAT COPLANARITY INEQUALITY EPSILON
CHOICES_conference = $(CHOICES_paper)
OPTION_COPLANAR    = --coplanar=$(COPLANAR)
OPTION_CLOCK_NS    = --clock-ns=$(CLOCK_NS)
OPTION_EXTENT_A    = --extent-a=$(EXTENT_A)
OPTION_EXTENT_B    = --extent-b=$(EXTENT_B)
OPTION_LANES       = --lanes=$(LANES)
OPTION_CORES       = --cores=$(CORES)
OPTION_MEMORY_A    = --memory-a=$(MEMORY_A)
OPTION_MEMORY_B    = --memory-b=$(MEMORY_B)
OPTION_EARLY_OUT   = --early-out=$(EARLY_OUT)
OPTION_CLEARANCE   = --clearance=$(CLEARANCE)
OPTION_WARNING     = --warning=$(WARNING)
OPTION_PRECISION   = --precision=$(PRECISION)
OPTION_BLOCK_FLOAT = --block-float=$(BLOCK_FLOAT)
OPTION_COPLANARITY = --coplanarity=$(COPLANARITY)
OPTION_INEQUALITY  = --inequality=$(INEQUALITY)
OPTION_EPSILON     = --epsilon=$(EPSILON)
OPTIONS = $(strip --arch=$(ARCH) --word=$(WORD) --ii=$(II) $(foreach \
          choice,$(CHOICES_exact) $(CHOICES_paper),$(if $(filter \
          $(choice),$(CHOICES_$(ARCH)))$(call given,$(choice)),$(OPTION_$(choice)))))

# build/core/exact-w18-ii3, build/core/paper-w18-full, with a suffix for whatever is not
# the default.
NAME_exact = exact-w$(WORD)-ii$(II)$(if $(filter flag,$(COPLANAR)),-flag)$(if \
             $(filter-out 2,$(CLOCK_NS)),-$(CLOCK_NS)ns)$(if $(EXTENT_A),-a$(EXTENT_A))$(if $(EXTENT_B),-b$(EXTENT_B))$(if $(filter boxes,$(EARLY_OUT)),-boxes)$(if \
             $(CLEARANCE),-c$(CLEARANCE))$(if $(WARNING),-d$(WARNING))$(if \
             $(LANES),-k$(LANES))$(if $(CORES),x$(CORES))$(if $(MEMORY_A),-ma$(MEMORY_A))$(if $(MEMORY_B),-mb$(MEMORY_B))
NAME_paper = $(ARCH)-w$(WORD)-$(subst =,,$(PRECISION))$(if $(filter on,$(BLOCK_FLOAT)),-bf)$(if \
             $(filter paper,$(COPLANARITY)),-cop)$(if $(filter printed,$(INEQUALITY)),-ineq)$(if \
             $(filter-out 1,$(EPSILON)),-e$(EPSILON))
NAME_conference = $(NAME_paper)
CORE_NAME = $(firstword $(or $(NAME_$(ARCH)),$(ARCH)-w$(WORD)))
CORE      = $(BUILD)/core/$(CORE_NAME)
MESH_ARGS = $(if $(filter fit,$(RESOLUTION)),,--resolution=$(RESOLUTION)) \
            --normals=$(NORMALS) "$(MESH_A)" "$(MESH_B)"
SAMPLES   = $(filter $(BUILD)/mesh/%,$(MESH_A) $(MESH_B))

# Tools that read the Verilog: the macro of the view, the suffix of what is made from it,
# the bench.
VIEW_MACRO = $(if $(filter behavioural,$(VIEW)),-DSEPAX_BEHAVIOURAL)
OF_VIEW    = $(if $(filter behavioural,$(VIEW)),,-structural)
BENCH      = $(if $(filter exact,$(ARCH)),sepax_exact_tb,sepax_tb)

ifeq ($(filter behavioural structural,$(VIEW)),)
$(error VIEW: '$(VIEW)' is none of: behavioural, structural)
endif
ifneq ($(and $(filter paper conference,$(ARCH)),$(call given,VIEW)),)
$(error VIEW: architecture $(ARCH) has one view only; leave it out)
endif
ifneq ($(words $(BUILD) $(abspath .)),2)
$(error BUILD and the project's own path must be without blanks)
endif

.DELETE_ON_ERROR:
.PHONY: all job help setup test rtl reference cosim icarus exhaustive hard wave lint area \
        area-sweep timing calibrate multivt power report scene accuracy clearance install uninstall mapped netlist gates bench sanitize sanitized static options core area-file engine engine-sweep example clean FORCE

all:
	@scripts/setup
	@$(MAKE) --no-print-directory job

help:
	@sed -n 's/^#: //p' Makefile

#: make            the main job: 160,000 pairs of two 400-triangle objects through the
#:                 exact machine and the paper's, each held against its golden model, and
#:                 the gate report
#: make test       every test (about 20 minutes); ends with N passed, N failed
#: make rtl        the Verilog of the design, in build/core/NAME/rtl
#: make cosim      meshes (MESH_A, MESH_B) or PAIRS=file through the verilated machine, or
#:                 PAIRS=families|corners: COUNT seeded hard pairs, or PAIRS=bits: all 2^18
#:                 pairs with coordinates 0, 1; with extents PAIRS=within|beyond: COUNT hard
#:                 pairs within them, or one triangle of each not
#: make engine     the object engine (LANES=16): MESH_A against MESH_B, or PAIRS=families
#:                 (STRESS=seed: random gaps and blocks on all buses)
#: make example    (LANES=16) its C driver on the verilated engine: the pairs that collide
#: make engine-sweep cycles over lanes, real meshes, all boxes meeting; build/engine-sweep
#: make icarus     the same vectors through Icarus Verilog (PAIRS=file|bits, or COUNT seeded
#:                 ones)
#: make exhaustive all 3^18 pairs with coordinates -1, 0, 1 through the verilated machine
#:                 (GRID=n: the first n)
#: make hard       35 designs: 20,000,000 hard pairs at W = 18, 1,000,000 at six more W, for five II
#:                 (COUNT=n: n instead of 1,000,000)
#: make wave       PAIR='18 or 24 integers' as a waveform: build/core/NAME/wave.fst
#: make lint       Verilator, Icarus and Yosys on the design's Verilog
#: make area       gates with LIBERTY, beside the paper's: of the design, or without ARCH
#:                 and II of both architectures
#: make area-sweep GE and GE x II of exact over W and II, as table, CSV, JSON and SVG
#: make scene      a core for 5 mm triangles in a 200 mm workspace: sized, simulated, and mapped
#:                 beside the core for any pair of 18 bits
#: make timing     least period, critical path, slacks at each corner by OpenSTA: of the design, or
#:                 without one of exact at II = 3 and 1; build/timing.json, slack.svg
#: make calibrate  does OpenSTA confirm CLOCK_NS? WORD x II x CLOCKS of exact; hours in full
#: make multivt    low-leakage cells where slack allows: power before and after; without
#:                 LIBERTY_LOW_LEAKAGE a variant derived from LIBERTY_FAST, which the report says
#: make power      power and energy per pair of the mapped gates by workload and module: exact at
#:                 II = 3 and 1 beside paper, or the design; build/power.json
#: make report     every machine in one table beside the paper's, each figure made anew, in twenty
#:                 minutes: build/report.html, build/report/report.json (QUICK=1: two of W = 4)
#: make netlist    the mapped gates through the Icarus bench (COUNT=170 takes minutes)
#: make gates      the mapped gates through the Verilator bench
#: make bench      speed of the software verdicts, 100,000,000 pairs of every path against the
#:                 scalar model (COUNT=n), meshes, threads, and the verilated machine
#: make accuracy   wrong verdicts of every design point by family, against speed and gates:
#:                 build/accuracy/index.html, CSV, JSON, SVG (QUICK=1: a fiftieth of the pairs)
#: make clearance  10,000,000 pairs of real triangles near the limits of a clearance, held against
#:                 exact distances (COUNT=n); false alarms over distance: build/clearance/
#: make install    program, library, header, manual pages (PREFIX=/usr/local DESTDIR=);
#:                 make uninstall removes them
#: make reference  regenerate rtl/, the W = 18 cores that come with the source
#: make setup      install what is missing (Debian, Ubuntu); make and make test do it
#: make clean      remove build/
#:
#: Design:  ARCH=exact WORD=18 II=1...18 COPLANAR=exact|flag CLOCK_NS=2 EXTENT_A= EXTENT_B=
#:          EARLY_OUT=none|boxes CLEARANCE= WARNING=
#:          with an object engine: LANES=1...64 CORES=1 MEMORY_A=512 MEMORY_B=512
#:          ARCH=paper|conference WORD=18 PRECISION=full|word|guard=G BLOCK_FLOAT=off|on
#:          COPLANARITY=plane|paper INEQUALITY=correct|printed EPSILON=1
#: View:    VIEW=behavioural|structural: which body of exact's arithmetic is simulated
#: Data:    MESH_A= MESH_B= RESOLUTION=fit|length NORMALS=computed|file PAIRS= COUNT= SEED=
#: Tools:   CC CXX YOSYS VERILATOR IVERILOG VVP CPPCHECK CLANG_TIDY LIBERTY=file.lib[.gz]
#:          MULTIPLIERS=generated in the gates of paper, conference: those that exact is made of, not *
#:          PERIOD=ns the clock that the gates are sized for (CLOCK_NS with Nangate45, else none)
#:          CORNERS="file ..." further Liberty files for timing (default: slow, fast beside typ)

setup:
	@scripts/setup

# Both machines, or the one that was chosen or has the choice that was made.
ONLY_EXACT = $(strip $(foreach choice,II $(CHOICES_exact) VIEW,$(call given,$(choice))))
MACHINES   = $(if $(call given,ARCH),$(ARCH),exact $(if $(ONLY_EXACT),,paper))

machine-%:
	@echo "== architecture $* against its golden model: $(MESH_A), $(MESH_B)"
	@$(MAKE) --no-print-directory ARCH=$* cosim

# One after the other.
job: $(SEPAX)
	@$(foreach machine,$(MACHINES),$(MAKE) --no-print-directory machine-$(machine) &&) true
	@echo "== gates"
	@$(MAKE) --no-print-directory area

test:
	@scripts/setup
	@scripts/test

# ------------------------------------------------------------------ the program

$(BUILD)/obj/%.o: %.c
	@mkdir -p $(@D)
	@echo "  CC      $<"
	@$(CC) $(SEPAX_CFLAGS) -MMD -MP -c $< -o $@

# The library's objects serve the shared library, too.
$(BUILD)/obj/c_model/%.o: SEPAX_CFLAGS += -fPIC -fno-semantic-interposition

$(LIB): $(call object,$(LIB_SRC))
	@rm -f $@
	@$(AR) rcs $@ $^

$(BUILD)/libsepax.so.0: c_model/libsepax.map $(call object,$(LIB_SRC))
	@echo "  LINK    $@"
	@$(CC) $(CFLAGS) -shared -Wl,-soname,libsepax.so.0 -Wl,-Bsymbolic-functions \
	  -Wl,--version-script=$< $(filter %.o,$^) -lm -pthread -o $@

# The Verilog templates as C strings.
$(BUILD)/obj/templates.c: scripts/embed $(TEMPLATES) $(wildcard rtl_gen/*)
	@mkdir -p $(@D)
	@scripts/embed $(TEMPLATES) > $@
$(TEMPLATE_OBJ): $(BUILD)/obj/templates.c
	@$(CC) $(SEPAX_CFLAGS) -c $< -o $@

$(SEPAX): $(call object,$(CLI_SRC)) $(TEMPLATE_OBJ) $(LIB)
	@echo "  LINK    $@"
	@$(CC) $(CFLAGS) $^ -ljansson -lm -pthread -o $@

GEN_OBJ = $(call object,$(wildcard rtl_gen/*/*.c)) $(TEMPLATE_OBJ)

$(BUILD)/unit/%: $(call object,tb/unit/%.c $(addprefix tb/oracle/,oracle.c mesh_tools.c pair_tools.c \
                 distance.c real_pairs.c clear_rules.c)) \
                 $(GEN_OBJ) $(LIB)
	@mkdir -p $(@D)
	@echo "  LINK    $@"
	@$(CC) $(CFLAGS) $^ -lcmocka -lgmp -ljansson -lm -pthread -o $@

-include $(wildcard $(BUILD)/obj/*/*/*.d)

# -------------------------------------------------------------------- installation

VERSION = $(shell sed -n 's/.define SEPAX_VERSION "\(.*\)"/\1/p' c_model/sepax.h)
ROOT    = $(DESTDIR)$(PREFIX)
MAN     = share/man/man1/sepax.1 share/man/man3/libsepax.3

install: $(SEPAX) $(LIB) $(BUILD)/libsepax.so.0
	@case "$(PREFIX)" in *" "*) echo "install: PREFIX must be without blanks" >&2; exit 2 ;; /*) ;; \
	  *) echo "install: PREFIX=$(PREFIX) is not absolute; begin with /" >&2; exit 2 ;; esac
	@printf '%s\n' 'prefix=$(PREFIX)' 'includedir=$${prefix}/include' 'libdir=$${prefix}/lib' 'Name: sepax' \
	  'Description: exact triangle/triangle collision detection' 'Version: $(VERSION)' \
	  'Cflags: -I$${includedir}' 'Libs: -L$${libdir} -lsepax' 'Libs.private: -lm -pthread' > $(BUILD)/sepax.pc
	@$(foreach page,$(MAN),sed 's/@VERSION@/$(VERSION)/' docs/$(notdir $(page)) > $(BUILD)/$(notdir $(page)) &&) true
	@install -d $(addprefix $(ROOT)/,bin include lib/pkgconfig $(dir $(MAN)))
	@install -m 755 $(SEPAX) $(ROOT)/bin
	@install -m 644 $(wildcard c_model/sepax*.h) $(ROOT)/include
	@install -m 644 $(LIB) $(BUILD)/libsepax.so.0 $(ROOT)/lib
	@ln -sf libsepax.so.0 $(ROOT)/lib/libsepax.so
	@install -m 644 $(BUILD)/sepax.pc $(ROOT)/lib/pkgconfig
	@$(foreach page,$(MAN),install -m 644 $(BUILD)/$(notdir $(page)) $(ROOT)/$(page) &&) true
	@echo "installed in $(ROOT)"

uninstall:
	@rm -f $(addprefix $(ROOT)/,bin/sepax $(addprefix include/,$(notdir $(wildcard c_model/sepax*.h))) lib/libsepax.a lib/libsepax.so \
	  lib/libsepax.so.0 lib/pkgconfig/sepax.pc $(MAN))

# -------------------------------------------------------------------- the meshes

$(BUILD)/mesh/cutter.stl: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) mesh ball-end --triangles=400 --at=45,0,-20 -o $@

$(BUILD)/mesh/workpiece.stl: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) mesh pocket --triangles=400 -o $@

# ----------------------------------------------------------------- the benchmark

$(BUILD)/bench: $(BUILD)/obj/tb/benchmark/verdicts.o $(LIB)
$(BUILD)/bench_batch: $(BUILD)/obj/tb/benchmark/batch.o $(LIB)
$(BUILD)/bench $(BUILD)/bench_batch:
	@echo "  LINK    $@"
	@$(CC) $(CFLAGS) $^ -lm -pthread -o $@

bench: $(SEPAX) $(BUILD)/bench $(BUILD)/bench_batch $(COSIM)
	@scripts/experiments/bench $(BUILD)/software $(if $(call given,COUNT),$(COUNT))
	@echo "== verilated machine with its golden model, all families:"
	@$(COSIM) $(SEEDED)

NEAR_SRC = $(addprefix tb/,benchmark/clearance.c $(addprefix oracle/,oracle.c distance.c real_pairs.c clear_rules.c))
$(BUILD)/clearance-test: $(call object,$(NEAR_SRC)) $(LIB)
	@echo "  LINK    $@"
	@$(CC) $(CFLAGS) $^ -lgmp -lm -pthread -o $@

clearance: $(BUILD)/clearance-test
	@scripts/experiments/clearance $< $(if $(call given,COUNT),$(COUNT),10000000) $(BUILD)/clearance

accuracy: $(SEPAX) $(BUILD)/bench
	@[ -n "$(QUICK)" ] || [ -r $(BUILD)/area.json ] || $(MAKE) --no-print-directory area > $(BUILD)/area.txt
	@scripts/experiments/accuracy $(if $(QUICK),-q) $(BUILD)/accuracy

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

REFERENCE ?= rtl
reference: $(SEPAX)
	@cd $(REFERENCE) && rm -rf exact-w18-ii3 exact-w18-ii1 paper-w18 && \
	  $(abspath $(SEPAX)) gen --arch=exact --word=18 --ii=3 -o exact-w18-ii3 && \
	  $(abspath $(SEPAX)) gen --arch=exact --word=18 --ii=1 -o exact-w18-ii1 && \
	  $(abspath $(SEPAX)) gen --arch=paper --word=18 -o paper-w18

lint: $(RTL)
	@cd $(CORE)/rtl && $(abspath scripts/lint)

# ----------------------------------------------------------------- co-simulation

# Verilator 5.006 miscompiles trees of single bits (its issue 4059) but for the last option
# of the first line.
VERILATE = $(VERILATOR) --cc --exe --build -O3 --noassert -fno-const-bit-op-tree \
           --x-assign fast --x-initial unique --top-module sepax_top -f sepax.f $(VIEW_MACRO) \
           -MAKEFLAGS "OPT_FAST=-O3 OPT_GLOBAL=-O2" \
           -CFLAGS "-I$(abspath c_model) -I../rtl" \
           $(abspath tb/cosim/cosim.cpp $(BUILD)/obj/c_model/cli/options.o $(LIB))
COSIM_DEPS = $(RTL) $(addprefix tb/cosim/,cosim.cpp pair_source.h design_under_test.h verilated_top.h driver_paper.h \
             driver_exact.h) $(LIB) $(BUILD)/obj/c_model/cli/options.o
COSIM      = $(CORE)/cosim$(OF_VIEW)
WAVE       = $(CORE)/cosim-wave$(OF_VIEW)
verilate   = rm -rf $@ $(CORE)/obj-$(notdir $@) && cd $(CORE)/rtl && { $(VERILATE) $(1) --Mdir ../obj-$(notdir $@) -o ../$(notdir $@) \
             > ../$(notdir $@).log 2>&1 || { tail -20 ../$(notdir $@).log >&2; exit 1; }; }

$(COSIM): $(COSIM_DEPS)
	@echo "  VERILATE $(CORE_NAME)$(OF_VIEW)"
	@$(call verilate)

$(WAVE): $(COSIM_DEPS)
	@echo "  VERILATE $(CORE_NAME)$(OF_VIEW) with waveforms"
	@$(call verilate,--trace-fst)

# The engine: a C program on its verilated buses.
ENGINE      = $(CORE)/engine
ENGINE_OBJ  = $(CORE)/obj-c
ENGINE_C    = $(ENGINE_OBJ)/engine.o $(ENGINE_OBJ)/sepax_driver.o

$(ENGINE_OBJ)/%.o: tb/cosim/%.c $(RTL) $(wildcard tb/cosim/*.h examples/engine/*.h)
	@mkdir -p $(@D)
	@$(CC) $(SEPAX_CFLAGS) -Itb -Iexamples/engine -I$(CORE)/rtl -c $< -o $@
$(ENGINE_OBJ)/%.o: examples/engine/%.c $(RTL) $(wildcard tb/cosim/*.h examples/engine/*.h)
	@mkdir -p $(@D)
	@$(CC) $(SEPAX_CFLAGS) -Itb -Iexamples/engine -I$(CORE)/rtl -c $< -o $@

ENGINE_OPT     ?= -O3
VERILATE_ENGINE = $(VERILATOR) --cc --exe --build -O3 --noassert -fno-const-bit-op-tree \
                  --x-assign fast --x-initial unique --top-module sepax_engine -f sepax.f $(VIEW_MACRO) \
                  -MAKEFLAGS "OPT_FAST=$(ENGINE_OPT) OPT_GLOBAL=-O2" -CFLAGS "-I$(abspath tb)" \
                  $(abspath tb/cosim/engine_bus.cpp)

$(ENGINE): $(ENGINE_C) tb/cosim/engine_bus.cpp tb/cosim/engine_bus.h $(LIB) $(RTL)
	@echo "  VERILATE $(CORE_NAME), the engine"
	@rm -f $@ && cd $(CORE)/rtl && { $(VERILATE_ENGINE) $(abspath $(ENGINE_C) $(LIB)) --Mdir ../obj-engine -o ../engine \
	  > ../engine.log 2>&1 || { tail -20 ../engine.log >&2; exit 1; }; }

ifeq ($(filter-out 0,$(LANES)),)
engine example:
	@echo "$@: no box lanes; give LANES=1 ... 64" >&2; exit 2
else
engine: $(ENGINE) $(if $(filter families,$(PAIRS)),,$(SAMPLES))
	@$(ENGINE) $(if $(STRESS),--stress=$(STRESS)) $(if $(filter families,$(PAIRS)),,$(if \
	  $(filter-out fit,$(RESOLUTION)),--resolution=$(RESOLUTION)) $(MESH_A) $(MESH_B))

# The example: the driver and the same buses.
example: $(ENGINE) $(SAMPLES) $(ENGINE_OBJ)/collide.o
	@$(CXX) -o $(CORE)/collide $(ENGINE_OBJ)/collide.o $(ENGINE_OBJ)/sepax_driver.o $(CORE)/obj-engine/engine_bus.o \
	  $(CORE)/obj-engine/Vsepax_engine__ALL.a $(wildcard $(CORE)/obj-engine/verilated*.o) $(LIB) -lm -pthread
	@$(CORE)/collide "$(MESH_A)" "$(MESH_B)" $(filter-out fit,$(RESOLUTION)) || [ $$? -eq 1 ]

endif

engine-sweep: $(SEPAX)
	@LIBERTY="$(if $(call given,LIBERTY),$(LIBERTY))" scripts/experiments/engine-sweep $(BUILD)/engine-sweep

SEEDED      = --count=$(COUNT) --seed=$(SEED)
FROM_PAIRS  = $(if $(filter families,$(PAIRS)),$(SEEDED),$(if $(filter corners within beyond,$(PAIRS)),--$(PAIRS) \
              $(SEEDED),$(if $(filter bits,$(PAIRS)),--bits,--pairs="$(PAIRS)")))
COSIM_ARGS  = $(if $(PAIRS),$(FROM_PAIRS),$(MESH_ARGS)) $(if $(STRESS),--stress=$(STRESS))

cosim: $(COSIM) $(if $(PAIRS),,$(SAMPLES))
	@$(COSIM) $(COSIM_ARGS)

# 3^18 pairs, or the first GRID of them.
GRID ?= 387420489
exhaustive: $(COSIM)
	@scripts/experiments/exhaustive $(COSIM) $(GRID)

hard: $(SEPAX)
	@scripts/experiments/hard $(if $(call given,COUNT),$(COUNT))

wave: $(if $(PAIR),$(WAVE))
	@[ -n "$(PAIR)" ] || { echo "wave: give PAIR='18 or 24 integers'" >&2; exit 2; }
	@echo '$(PAIR)' | $(WAVE) --pairs=- --wave=$(CORE)/wave.fst
	@echo "$(CORE)/wave.fst"

ICARUS = $(CORE)/icarus$(OF_VIEW).vvp

$(ICARUS): $(RTL) tb/cosim/$(BENCH).v
	@cd $(CORE)/rtl && $(IVERILOG) -g2005 -Wall -DSEPAX_REST $(VIEW_MACRO) -I . -s $(BENCH) \
	  -o ../$(notdir $@) -c sepax.f $(abspath tb/cosim/$(BENCH).v)

# All pairs with coordinates 0, 1.
BITS = awk 'BEGIN { for (n = 0; n < 262144; n++) { line = ""; rest = n; for (k = 0; k < 18; k++) { \
       line = line " " rest % 2; rest = int(rest / 2) } print line } }'

$(CORE)/icarus.pairs: $(SEPAX) FORCE
	@mkdir -p $(CORE)
	@$(if $(filter-out families bits,$(PAIRS)),$(SEPAX) judge $(OPTIONS) --echo "$(PAIRS)",$(if \
	  $(filter bits,$(PAIRS)),$(BITS),$(SEPAX) vectors --word=$(WORD) $(SEEDED)) | \
	  $(SEPAX) judge $(OPTIONS) --echo) > $@

icarus: $(ICARUS) $(CORE)/icarus.pairs
	@$(VVP) -N $(ICARUS) +pairs=$(CORE)/icarus.pairs $(if $(STRESS),+stall=$(STRESS))

# --------------------------------------------------------------------- the gates

# The design that was chosen; the paper's in both precisions, as its word length leaves
# both readings open, unless one was chosen; conference beside paper of the same choices;
# without a choice the exact ones and the paper's.
AREA_LIST ?= $(BUILD)/area.list
LIBRARY = $(basename $(notdir $(LIBERTY:.gz=)))
# A period that was chosen has a folder of its own.
AREA    = $(CORE)/$(LIBRARY)$(if $(PERIOD),-$(PERIOD)ns)$(if $(filter generated,$(MULTIPLIERS)),-generated)
PAPERS  = $(if $(call given,PRECISION),area-of-this,area-of-full area-of-word area-of-generated)
BESIDE  = $(if $(call given,PRECISION),area-of-this area-of-paper,$(foreach \
          bits,full word,area-of-conference-$(bits) area-of-$(bits)))
AREAS   = $(if $(call given,ARCH),$(if $(filter paper,$(ARCH)),$(PAPERS),$(if $(filter \
          conference,$(ARCH)),$(BESIDE),area-of-this)),$(if \
          $(ONLY_EXACT),area-of-this,area-of-ii3 area-of-ii1 $(PAPERS)))

# Another library of the same name is another library.
$(AREA)/liberty.sum: FORCE
	@[ -r "$(LIBERTY)" ] || { echo "area: $(LIBERTY) cannot be read; give LIBERTY=file.lib[.gz]" >&2; exit 2; }
	@mkdir -p $(AREA)
	@cksum "$(LIBERTY)" > $@.new; if cmp -s $@.new $@; then rm $@.new; else mv $@.new $@; fi

MAP_SRC = $(wildcard synth/area/* synth/common* synth/netlist.jq) $(BUILD)/liberty

$(AREA)/area.json: $(RTL) $(AREA)/liberty.sum $(MAP_SRC)
	@echo "  YOSYS   $(CORE_NAME), $(LIBRARY)"
	@synth/area/map -l $(LIBERTY) $(if $(PERIOD),-p $(PERIOD)) \
	  $(if $(filter generated,$(MULTIPLIERS)),-m $(SEPAX)) -o $(AREA) $(CORE)/rtl

area-of-this:
	@$(MAKE) --no-print-directory mapped
area-of-ii%:
	@$(MAKE) --no-print-directory ARCH=exact II=$* mapped
area-of-full area-of-word:
	@$(MAKE) --no-print-directory ARCH=paper PRECISION=$(@:area-of-%=%) mapped
area-of-paper:
	@$(MAKE) --no-print-directory ARCH=paper mapped
area-of-conference-full area-of-conference-word:
	@$(MAKE) --no-print-directory ARCH=conference PRECISION=$(@:area-of-conference-%=%) mapped
area-of-generated: area-of-full
	@$(MAKE) --no-print-directory ARCH=paper PRECISION=full MULTIPLIERS=generated mapped

mapped: $(AREA)/area.json
	@echo $(AREA)/area.json >> $(AREA_LIST)

area: $(SEPAX)
	@rm -f $(AREA_LIST)
	@$(MAKE) --no-print-directory -j2 $(AREAS)
	@synth/report/gates -o $(BUILD)/area.json $$(sort $(AREA_LIST))

area-sweep: $(SEPAX) $(BUILD)/liberty
	@PERIOD=$(PERIOD) scripts/experiments/area-sweep $(if $(call given,WORD),-w "$(WORD)") $(if \
	  $(call given,II),-i "$(II)") $(BUILD)/area-sweep

scene: $(SEPAX) $(BUILD)/liberty
	@PERIOD=$(PERIOD) scripts/experiments/scene $(BUILD)/scene

# OpenSTA wants a netlist that is sized for a clock: the generator's, in Nangate45; other
# libraries are slower, osu018 about four times.
CORNERS             ?=
CLOCKS              ?=
LIBERTY_FAST        ?= $(LIBERTY)
LIBERTY_LOW_LEAKAGE ?=
TIMED   = $(if $(PERIOD),,$(if $(filter nangate45%,$(LIBRARY)),$(if $(filter paper,$(ARCH)),PERIOD=$(CLOCK_NS)),PERIOD=$(shell \
          awk 'BEGIN { print 4 * "$(CLOCK_NS)" }')))
TIMINGS = $(if $(call given,ARCH)$(ONLY_EXACT),timing-of-this,timing-of-ii3 timing-of-ii1)

timing-of-this: $(AREA)/area.json
	@echo "  STA     $(CORE_NAME), $(LIBRARY)"
	@synth/timing/sta -l $(LIBERTY) $(if $(CORNERS),-c "$(CORNERS)") -o $(AREA)/timing $(AREA)
	@echo $(AREA)/timing/timing.json >> $(BUILD)/timing.list
timing-of-ii%:
	@$(MAKE) --no-print-directory ARCH=exact II=$* timing-of-this

timing: $(SEPAX)
	@rm -f $(BUILD)/timing.list
	@$(MAKE) --no-print-directory $(TIMED) $(TIMINGS)
	@synth/report/timing -o $(BUILD)/timing.json $$(cat $(BUILD)/timing.list)

calibrate: $(SEPAX) $(BUILD)/liberty
	@scripts/experiments/calibrate $(if $(call given,WORD),-w "$(WORD)") $(if $(call given,II),-i "$(II)") $(if \
	  $(CLOCKS),-c "$(CLOCKS)") $(BUILD)/calibrate

multivt-of-this: $(AREA)/area.json
	@synth/multivt/assign -f $(LIBERTY) $(if $(LIBERTY_LOW_LEAKAGE),-s $(LIBERTY_LOW_LEAKAGE)) \
	  -o $(AREA)/multivt $(AREA)
	@cp $(AREA)/multivt/multivt.json $(BUILD)/multivt.json

multivt: $(SEPAX)
	@$(MAKE) --no-print-directory LIBERTY=$(LIBERTY_FAST) multivt-timed
multivt-timed:
	@$(MAKE) --no-print-directory $(TIMED) multivt-of-this

# Power: the gates simulated with the pairs of four workloads, the sums by build/power.
LIBERTY_C = $(wildcard synth/liberty/*.c)
$(BUILD)/liberty: $(call object,$(LIBERTY_C))
	@echo "  LINK    $@"
	@$(CC) $(CFLAGS) $^ -ljansson -o $@

POWER_C = $(call object,$(wildcard synth/power/*.c) $(filter-out %/main.c,$(LIBERTY_C)) c_model/cli/options.c)
$(BUILD)/power: $(POWER_C) $(LIB)
	@echo "  LINK    $@"
	@$(CC) $(CFLAGS) $^ -ljansson -lm -o $@

# Pairs that collide, pairs in one plane: seeded, those of all the mapped designs.
$(BUILD)/power-w$(WORD)/colliding.txt: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) vectors --word=$(WORD) --family=local --count=12000 | $(SEPAX) judge --word=$(WORD) --echo | \
	  awk '$$25 == 1 { NF = 24; print }' > $@
$(BUILD)/power-w$(WORD)/coplanar.txt: $(SEPAX)
	@mkdir -p $(@D)
	@$(SEPAX) vectors --word=$(WORD) --family=coplanar --count=8000 | $(SEPAX) judge --word=$(WORD) --echo | \
	  awk '$$26 == 1 { NF = 24; print }' > $@

CYCLES    ?= 200
OPENSTA   ?=
LOADS      = $(BUILD)/power-w$(WORD)/colliding.txt $(BUILD)/power-w$(WORD)/coplanar.txt
POWER_RES  = $(if $(filter fit,$(RESOLUTION)),0,$(RESOLUTION))
POWER_MESH = $(MESH_A) $(MESH_B) $(POWER_RES)
# An engine makes its pairs itself.
WORKLOADS  = "separated=$(POWER_MESH)" $(if $(filter-out 0,$(LANES)),"loading=loading $(POWER_MESH)" \
             "idle=idle $(POWER_MESH)",colliding=$(word 1,$(LOADS)) coplanar=$(word 2,$(LOADS)) "idle=idle $(word 1,$(LOADS))")
POWERS     = $(if $(call given,ARCH)$(ONLY_EXACT),power-of-this,power-of-paper power-of-ii3 power-of-ii1 \
             power-of-early)
# The paper's machine is made of the same multipliers as exact.
power-of-this: $(AREA)/area.json $(BUILD)/power $(if $(filter-out 0,$(LANES)),,$(LOADS)) $(SAMPLES)
	@echo "  POWER   $(CORE_NAME), $(LIBRARY)"
	@POWER=$(BUILD)/power synth/power/run -l $(LIBERTY) -c $(CYCLES) $(if $(OPENSTA),-t) -o $(AREA)/power $(AREA) \
	  $(WORKLOADS)
	@echo $(AREA)/power/power.json >> $(BUILD)/power.list
power-of-ii%:
	@$(MAKE) --no-print-directory ARCH=exact II=$* power-of-this
power-of-early:
	@$(MAKE) --no-print-directory ARCH=exact II=3 EARLY_OUT=boxes power-of-this
power-of-paper:
	@$(MAKE) --no-print-directory ARCH=paper PRECISION=full MULTIPLIERS=generated power-of-this

power: $(SEPAX)
	@rm -f $(BUILD)/power.list
	@$(MAKE) --no-print-directory $(POWERS)
	@synth/report/power -o $(BUILD)/power.json $$(cat $(BUILD)/power.list)

# Every machine beside the paper's; Nangate45 where it is at hand.
report: $(SEPAX)
	@LIBERTY=$(if $(call given,LIBERTY),$(LIBERTY),$(firstword $(wildcard ../shared/pdk/nangate45_typ.lib.gz) $(LIBERTY))) \
	  scripts/experiments/report $(if $(QUICK),-q) $(BUILD)/report

$(AREA)/netlist.vvp: $(AREA)/area.json tb/cosim/$(BENCH).v
	@echo "  ICARUS  $(CORE_NAME), mapped to $(LIBRARY)"
	@synth/liberty/models -l $(LIBERTY) -n $(AREA)/netlist.v -o $(AREA)/cells.v
	@$(IVERILOG) -g2005 -I $(CORE)/rtl -s $(BENCH) -o $@ $(AREA)/netlist.v $(AREA)/cells.v \
	  tb/cosim/$(BENCH).v

# A gate-level pair takes a second at W = 18: ten of each family are many.
netlist: COUNT = 170
netlist: $(AREA)/netlist.vvp $(CORE)/icarus.pairs
	@$(VVP) -N $< +pairs=$(CORE)/icarus.pairs

# The mapped gates under the Verilator bench, module by module.
GATES = $(AREA)/cosim

$(GATES): $(AREA)/area.json $(COSIM_DEPS)
	@echo "  VERILATE $(CORE_NAME), mapped to $(LIBRARY)"
	@synth/liberty/models -l $(LIBERTY) -n $(AREA)/netlist.v -o $(AREA)/cells.v
	@cd $(AREA) && { $(VERILATOR) --cc --exe --build -j 2 --hierarchical --no-timing \
	  -Wno-fatal -Wno-lint -fno-const-bit-op-tree --output-split 1000000 --top-module sepax_top \
	  -MAKEFLAGS "OPT_FAST=-O1 OPT_SLOW=-O0 OPT_GLOBAL=-O1" \
	  -CFLAGS "-I$(abspath c_model) -I$(abspath $(CORE)/rtl)" --Mdir obj -o ../cosim \
	  netlist.vlt cells.v netlist.v \
	  $(abspath tb/cosim/cosim.cpp $(BUILD)/obj/c_model/cli/options.o $(LIB)) > cosim.log 2>&1 || \
	  { tail -20 cosim.log >&2; exit 1; }; }

gates: $(GATES)
	@$(GATES) $(if $(PAIRS),$(FROM_PAIRS),$(SEEDED)) $(if $(STRESS),--stress=$(STRESS))

# ------------------------------------------------------------------ code quality

C_SRC  = $(LIB_SRC) $(CLI_SRC) $(wildcard tb/*/*.c synth/*/*.c examples/engine/*.c)
C_PATH = -Ic_model -Irtl_gen -Itb -Isynth -Iexamples/engine -I$(BUILD)/static

# Programs of the engine read headers that come with its Verilog.
static: $(SEPAX)
	@$(GEN) --lanes=4 -o $(BUILD)/static > /dev/null
	@$(CPPCHECK) --quiet --error-exitcode=1 --enable=warning,style,performance,portability \
	  --inline-suppr --suppress=missingIncludeSystem --std=c11 $(C_PATH) $(C_SRC)
	@printf '%s\n' $(C_SRC) | xargs -P 2 -I {} $(CLANG_TIDY) --quiet \
	  --warnings-as-errors="*" {} -- -std=c11 -D_POSIX_C_SOURCE=200809L $(C_PATH)

sanitize:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/sanitize \
	  CFLAGS="-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all \
	          -DEXACT_PAIRS=50000" sanitized

sanitized: $(SEPAX) $(UNIT)
	@for unit in $(UNIT); do echo $$unit; $$unit || exit 1; done
	@SEPAX=$(SEPAX) tb/system/cli

# What the scripts ask: the options of the design and the name of its folder.
options:
	@echo $(OPTIONS)
core:
	@echo $(CORE)
area-file:
	@echo $(AREA)/area.json

clean:
	rm -rf $(BUILD)
