# SPDX-License-Identifier: MIT
# build.mk - the program, the library, and the programs of tests and reports.

XML_OF      = $(if $(with_xml),$(wildcard io/xml/*.c io/robot/libxml2/*.c),io/missing/libxml2.c)
ZIP_OF      = $(if $(with_zip),$(wildcard io/archive/*.c),io/missing/libzip.c)
FORMAT_OBJ  = $(call object,$(wildcard program/formats/*.c))
# Parts of the commands that program/formats calls: options of meshes, and messages about them.
FORMAT_USES = $(call object,program/cli/meshes.c program/cli/question.c \
              $(wildcard program/report/*.c))

LIB_SRC   = $(wildcard lib/*/*.c)
MODEL_SRC = $(wildcard c_model/*/*.c)
IO_SRC    = $(wildcard io/reader/*.c io/robot/*.c io/text/*.c) $(XML_OF) $(ZIP_OF)
CHECKER  = $(wildcard $(addprefix program/certificate_checker/,*.c */*.c))
MD_OF    = program/path/certificate/$(if $(with_md),libmd,missing)/digest.c
CLI_SRC  = $(filter-out $(CHECKER),$(wildcard program/*.c program/*/*.c \
           program/path/*/*.c)) $(MD_OF) $(RTL_GEN)
RTL_GEN  = $(wildcard rtl_gen/*.c rtl_gen/*/*.c rtl_gen/*/*/*.c)
UNIT     = $(patsubst tb/unit/%.c,$(BUILD)/unit/%,$(wildcard tb/unit/*.c tb/unit/*/*.c))

# If the first build lacks a package, say so in one line before the compiler fails.
ifeq ($(wildcard $(BUILD)/obj),)
LACKING := $(shell CC="$(CC)" CFLAGS="$(CFLAGS)" scripts/setup -n build)
endif
$(BUILD)/obj/%.o: %.c
	$(if $(LACKING),@echo "build: $(LACKING)" >&2; exit 2)
	@mkdir -p $(@D)
	@echo "  CC      $<"
	@$(aside) $(CC) $(SEPAX_CFLAGS) -MMD -MP -MT $@ -MF $$new.dep -c $< -o $$new && \
	  mv -f $$new.dep $(@:.o=.d) && $(in_place)

# The same objects go into the shared libraries. Functions that no public header declares are
# hidden.
LIB_OBJ   = $(call object,$(LIB_SRC))
MODEL_OBJ = $(call object,$(MODEL_SRC))
IO_OBJ    = $(call object,$(IO_SRC))
VISIBILITY ?= hidden
$(LIB_OBJ) $(MODEL_OBJ) $(IO_OBJ): SEPAX_CFLAGS += -fPIC -fno-semantic-interposition \
                                        -fvisibility=$(VISIBILITY)

# This project's own programs and tests link these archives, which have internal functions, too.
$(BUILD)/obj/lib.a: $(LIB_OBJ)
$(BUILD)/obj/models.a: $(MODEL_OBJ)
$(BUILD)/obj/io.a: $(IO_OBJ) $(BUILD)/obj/libraries
$(BUILD)/obj/lib.a $(BUILD)/obj/models.a $(BUILD)/obj/io.a:
	@$(aside) rm -f $$new && $(AR) rcs $$new $(filter %.o,$^) && $(in_place)

# Users link these: libsepax, and on top of it libsepax-io and libsepax-model, which have copies of
# the internal functions of libsepax that they call. An archive is one object in which internal
# names are local, so that they cannot clash with names of a user's program.
$(BUILD)/libsepax.a $(BUILD)/libsepax.so.0: $(LIB_OBJ)
$(BUILD)/libsepax-model.a $(BUILD)/libsepax-model.so.0: $(MODEL_OBJ) \
  $(call object,lib/util/write_file.c lib/util/temporary.c)
$(BUILD)/libsepax-io.a $(BUILD)/libsepax-io.so.0: $(IO_OBJ) \
  $(call object,lib/util/text.c lib/mesh/stl_read.c lib/body/orient.c lib/mechanism/join.c) \
  $(BUILD)/obj/libraries
$(BUILD)/libsepax-model.so.0 $(BUILD)/libsepax-io.so.0: $(BUILD)/libsepax.so.0
$(BUILD)/libsepax-io.so.0: LIBS = $(IO_LIBS)
$(BUILD)/libsepax.a $(BUILD)/libsepax-model.a $(BUILD)/libsepax-io.a:
	@parts=$@.$$$$ && trap 'rm -rf $$parts' EXIT && trap 'exit 1' HUP INT TERM && \
	  mkdir $$parts && $(LD) -r -o $$parts/$(@F:.a=.o) $(filter %.o,$^) && \
	  $(OBJCOPY) --localize-hidden $$parts/$(@F:.a=.o) && \
	  $(AR) rcs $$parts/$(@F) $$parts/$(@F:.a=.o) && mv -f $$parts/$(@F) $@
$(BUILD)/libsepax.so.0 $(BUILD)/libsepax-model.so.0 $(BUILD)/libsepax-io.so.0:
	@echo "  LINK    $@"
	@$(aside) $(CC) $(CFLAGS) -shared -Wl,-soname,$(@F) -Wl,-Bsymbolic-functions \
	  $(filter %.o %.so.0,$^) $(LIBS) -lm -pthread -o $$new && $(in_place)

# Not optimised: the emulated vectors take 20 s to optimise, and the test then runs in 2 s anyway.
$(BUILD)/obj/tb/unit/avx512.o: SEPAX_CFLAGS += -O0
.SECONDARY: $(BUILD)/obj/tb/harness.o

# The Verilog templates as C strings.
TEMPLATES    = $(wildcard rtl_gen/*/*.v rtl_gen/*/*/*.v)
TEMPLATE_OBJ = $(BUILD)/obj/templates.o
$(BUILD)/obj/templates.c: scripts/embed $(TEMPLATES) $(wildcard rtl_gen/* rtl_gen/*/*)
	@mkdir -p $(@D)
	@$(aside) scripts/embed $(TEMPLATES) > $$new && $(in_place)
$(TEMPLATE_OBJ): $(BUILD)/obj/templates.c
	@$(aside) $(CC) $(SEPAX_CFLAGS) -c $< -o $$new && $(in_place)

# The page of sepax path as a C string.
PAGE_OBJ = $(BUILD)/obj/page.o
$(BUILD)/obj/page.c: scripts/embed program/path/print/page.html
	@mkdir -p $(@D)
	@$(aside) scripts/embed -t path_page_html program/path/print/page.html > $$new && $(in_place)
$(PAGE_OBJ): $(BUILD)/obj/page.c
	@$(aside) $(CC) $(SEPAX_CFLAGS) -c $< -o $$new && $(in_place)

# The page of sepax explore.
EXPLORE_OBJ = $(BUILD)/obj/explore.o
$(BUILD)/obj/explore.c: scripts/embed program/commands/explore.html
	@mkdir -p $(@D)
	@$(aside) scripts/embed -t explore_html program/commands/explore.html > $$new && $(in_place)
$(EXPLORE_OBJ): $(BUILD)/obj/explore.c
	@$(aside) $(CC) $(SEPAX_CFLAGS) -c $< -o $$new && $(in_place)

# The front end of NC programs as a C string: its files in the order in which they need each other.
LINUXCNC_OBJ = $(BUILD)/obj/linuxcnc.o
NC_PY  = $(addprefix program/nc/linuxcnc/,\
  configuration.py kinematics.py hal.py tools.py canon.py private.py main.py)
$(BUILD)/obj/linuxcnc.c: scripts/embed $(NC_PY)
	@mkdir -p $(@D)
	@cat $(NC_PY) > $(BUILD)/obj/linuxcnc.py
	@$(aside) scripts/embed -t path_linuxcnc $(BUILD)/obj/linuxcnc.py > $$new && $(in_place)
$(LINUXCNC_OBJ): $(BUILD)/obj/linuxcnc.c
	@$(aside) $(CC) $(SEPAX_CFLAGS) -c $< -o $$new && $(in_place)

# Code that calls libxml2.
$(BUILD)/obj/io/xml/%.o $(BUILD)/obj/io/archive/%.o $(BUILD)/obj/io/robot/libxml2/%.o: \
  SEPAX_CFLAGS += $(XML_CFLAGS)
# Written only if it changes: the program is then linked again.
$(BUILD)/obj/libraries: FORCE
	@mkdir -p $(@D)
	@echo 'libxml2 $(LIBXML2), libzip $(LIBZIP), libmd $(LIBMD)' | cmp -s - $@ || { \
	  $(if $(with_xml),,echo "  WITHOUT libxml2: no URDF, SRDF, DAE, 3MF";) \
	  $(if $(filter yes,$(LIBZIP)),,echo "  WITHOUT libzip: no 3MF";) \
	  $(if $(with_md),,echo "  WITHOUT libmd: no certificates";) \
	  $(aside) echo 'libxml2 $(LIBXML2), libzip $(LIBZIP), libmd $(LIBMD)' > $$new && $(in_place); }

# Programs: objects, then libraries.
define link
@mkdir -p $(@D)
@echo "  LINK    $@"
@$(aside) $(CC) $(CFLAGS) $(LDFLAGS) $(filter %.o %.a,$^) $(LIBS) $(LDLIBS) -lm -pthread \
  -o $$new && $(in_place)
endef
CHECKER_OBJ = $(call object,$(CHECKER))
NC_OBJ      = $(call object,$(wildcard program/nc/*.c))
ORACLE_OBJ  = $(call object,$(wildcard tb/oracle/*.c))
LIBERTY_OBJ = $(call object,$(wildcard synth/liberty/*.c))
LAYOUT_OBJ  = $(call object,$(wildcard synth/layout/*.c synth/layout/*/*.c) synth/liberty/text.c)
GEN_OBJ     = $(call object,$(RTL_GEN)) $(TEMPLATE_OBJ)
POWER_OBJ   = $(call object,$(wildcard synth/power/*.c)) $(filter-out %/main.o,$(LIBERTY_OBJ))

# Registers of the engines, as their drivers read them.
$(BUILD)/obj/synth/power/%_engine.o: SEPAX_CFLAGS += -Idrivers/$(*F)

$(SEPAX): $(call object,$(CLI_SRC)) $(TEMPLATE_OBJ) $(PAGE_OBJ) $(EXPLORE_OBJ) $(LINUXCNC_OBJ) \
          $(IO) $(LIB)
$(BUILD)/bench: $(call object,tb/benchmark/verdicts.c) $(LIB)
$(BUILD)/bench_batch: $(call object,tb/benchmark/batch.c) $(LIB)
$(BUILD)/clearance-pairs: $(call object,tb/pairs/clearance.c) $(ORACLE_OBJ) $(LIB)
$(BUILD)/posed-pairs: $(call object,tb/pairs/posed.c) $(ORACLE_OBJ) $(LIB)
$(BUILD)/distances: $(call object,$(wildcard tb/pairs/distances/*.c)) $(ORACLE_OBJ) $(LIB)
$(BUILD)/material: $(call object,$(wildcard tb/material/*.c)) \
          $(filter-out %/check.o,$(CHECKER_OBJ)) $(LIB)
$(BUILD)/stock-trial: $(call object,$(wildcard tb/stock/*.c)) $(LIB)
$(BUILD)/hard-pairs: $(call object,tb/pairs/hard.c) $(LIB)
$(BUILD)/refine: $(call object,tb/tree_engine/sweep/refine.c) $(LIB)
$(BUILD)/liberty: $(LIBERTY_OBJ)
$(BUILD)/nc-rows: $(call object,tb/nc/rows.c) $(NC_OBJ) $(LIB)
$(BUILD)/sepax-certificate-check: $(CHECKER_OBJ)
$(BUILD)/certificate-grazes: $(call object,tb/certificate/grazes.c)
$(BUILD)/power: $(POWER_OBJ) $(IO) $(LIB)
$(BUILD)/layout: $(LAYOUT_OBJ)
$(BUILD)/liberty $(BUILD)/layout: LIBS = -ljansson
$(BUILD)/power: LIBS = -ljansson $(IO_LIBS)
$(SEPAX): LIBS = -ljansson $(IO_LIBS) $(if $(with_md),-lmd)
$(BUILD)/sepax-certificate-check $(BUILD)/material: LIBS = -ljansson -lxml2 -lzip -lmd
$(CHECKER_OBJ): SEPAX_CFLAGS += $(XML_CFLAGS)
$(BUILD)/clearance-pairs $(BUILD)/posed-pairs $(BUILD)/distances: LIBS = -lgmp
$(SEPAX) $(addprefix $(BUILD)/,bench_batch layout liberty power refine) \
    $(addprefix $(BUILD)/,clearance-pairs posed-pairs distances hard-pairs bench material) \
    $(addprefix $(BUILD)/,sepax-certificate-check certificate-grazes nc-rows stock-trial):
	$(link)

$(BUILD)/unit/%: LIBS = -lcmocka -lgmp -ljansson
$(BUILD)/unit/%: $(BUILD)/obj/tb/unit/%.o $(BUILD)/obj/tb/harness.o $(ORACLE_OBJ) $(GEN_OBJ) $(LIB)
	$(link)

$(BUILD)/unit/formats/%: LIBS = -lcmocka -lgmp -ljansson $(IO_LIBS)
$(BUILD)/unit/formats/%: $(BUILD)/obj/tb/unit/formats/%.o $(BUILD)/obj/tb/harness.o \
                         $(ORACLE_OBJ) $(FORMAT_OBJ) $(FORMAT_USES) $(OPTIONS_OBJ) $(IO) $(LIB)
	$(link)

$(BUILD)/unit/io/%: LIBS = -lcmocka -lgmp $(IO_LIBS)
$(BUILD)/unit/io/%: $(BUILD)/obj/tb/unit/io/%.o $(BUILD)/obj/tb/harness.o $(ORACLE_OBJ) \
                    $(IO) $(LIB)
	$(link)

REPORT_OBJ = $(call object,$(wildcard program/report/*.c))
$(BUILD)/unit/report/%: LIBS = -lcmocka -lgmp -ljansson
$(BUILD)/unit/report/%: $(BUILD)/obj/tb/unit/report/%.o $(BUILD)/obj/tb/harness.o $(ORACLE_OBJ) \
                        $(REPORT_OBJ) $(LIB)
	$(link)

$(BUILD)/unit/path/%: LIBS = -lcmocka -lgmp -ljansson $(IO_LIBS) $(if $(with_md),-lmd)
$(BUILD)/unit/path/%: $(BUILD)/obj/tb/unit/path/%.o $(BUILD)/obj/tb/harness.o $(ORACLE_OBJ) \
                      $(call object,$(filter-out program/main.c,$(CLI_SRC))) $(TEMPLATE_OBJ) \
                      $(PAGE_OBJ) $(EXPLORE_OBJ) $(LINUXCNC_OBJ) $(IO) $(LIB)
	$(link)

$(BUILD)/unit/nc/%: LIBS = -lcmocka -lgmp
$(BUILD)/unit/nc/%: $(BUILD)/obj/tb/unit/nc/%.o $(BUILD)/obj/tb/harness.o $(ORACLE_OBJ) \
                    $(NC_OBJ) $(LIB)
	$(link)

$(BUILD)/unit/synth/%: LIBS = -lcmocka -lgmp
$(BUILD)/unit/synth/%: $(BUILD)/obj/tb/unit/synth/%.o $(BUILD)/obj/tb/harness.o $(ORACLE_OBJ) \
                       $(call object,synth/power/gates.c synth/power/glitches.c \
                         synth/liberty/text.c) $(LIB)
	$(link)

# Fuzz targets. Without FUZZER they run on given inputs. With FUZZER=-fsanitize=fuzzer they are
# linked with libFuzzer, which has a main of its own.
FUZZ     = $(patsubst tb/fuzz/target/%.c,$(BUILD)/fuzz/%,$(wildcard tb/fuzz/target/*.c))
FUZZ_OBJ = $(call object,$(if $(FUZZER),,tb/fuzz/replay.c) $(addprefix tb/fuzz/,fuzz.c mesh.c))
$(FUZZ): LIBS = -ljansson $(IO_LIBS) $(FUZZER)
$(BUILD)/fuzz/%: $(BUILD)/obj/tb/fuzz/target/%.o $(FUZZ_OBJ) $(FORMAT_OBJ) $(FORMAT_USES) \
                 $(NC_OBJ) $(OPTIONS_OBJ) $(IO) $(LIB)
	$(link)

# Benchmark of moving bodies, beside those of FCL, Coal, CGAL and Embree that are installed.
header   = $(shell echo '$(hash)include <$(1)>' | $(CXX) $(PEERS_I) -x c++ -E - > /dev/null 2>&1 \
             && echo $(2))
PEERS_I  = $(patsubst -I%,-isystem %,$(shell pkg-config --cflags-only-I fcl eigen3 2> /dev/null || \
             echo -I/usr/include/eigen3))
BODIES_O = $(patsubst %.cpp,$(BUILD)/obj/%.o,$(wildcard tb/benchmark/*.cpp)) \
           $(call object,tb/oracle/oracle.c)
SWEEP_O  = $(patsubst %.cpp,$(BUILD)/obj/%.o,$(wildcard tb/tree_engine/sweep/*.cpp) \
           tb/benchmark/peer_fcl.cpp tb/benchmark/peer_sepax.cpp)
$(BUILD)/obj/tb/%.o: tb/%.cpp
	@mkdir -p $(@D)
	@echo "  CXX     $<"
	@$(aside) $(CXX) -std=c++17 -O3 -DNDEBUG -Wall -Wextra -Werror -Ilib -Ic_model -Itb \
	  $(PEER_FLAGS) $(PEERS_I) -MMD -MP -MT $@ -MF $$new.dep -c $< -o $$new && \
	  mv -f $$new.dep $(@:.o=.d) && $(in_place)
# Coal comes from PyPI (scripts/setup venv), and Eigen from Debian.
CMEEL      = $(wildcard $(BUILD)/venv/lib/python3*/site-packages/cmeel.prefix)
COAL       = $(wildcard $(addsuffix /include/coal/distance.h,$(CMEEL)))
COAL_OF    = $(abspath $(COAL:%/include/coal/distance.h=%))
COAL_LIB   = $(addsuffix /lib,$(COAL_OF))
$(BUILD)/obj/tb/benchmark/peer_coal.o: PEER_FLAGS = $(COAL_OF:%=-isystem %/include)
$(BUILD)/obj/tb/benchmark/peer_coal.o: $(COAL)
$(BUILD)/bench_bodies: $(BODIES_O) $(LIB)
	@echo "  LINK    $@"
	@$(aside) $(CXX) $^ $(call header,fcl/fcl.h,-lfcl -lccd) \
	  $(call header,embree3/rtcore.h,-lembree3) $(call header,mpfr.h,-lmpfr) \
	  $(addsuffix /libcoal.so,$(COAL_LIB)) \
	  $(addprefix -Wl$(comma)-rpath$(comma),$(COAL_LIB)) \
	  -lgmp -lm -pthread -o $$new && $(in_place)
# Benchmark of queries of a whole machine.
$(BUILD)/bench_machine: LIBS = -ljansson $(IO_LIBS)
$(BUILD)/bench_machine: $(call object,tb/benchmark/machine.c tb/benchmark/mill.c \
                          tb/benchmark/mill_pairs.c) $(FORMAT_OBJ) $(FORMAT_USES) \
                        $(OPTIONS_OBJ) $(IO) $(LIB)
	$(link)
# Benchmark of mesh files; with assimp beside our readers if its header is installed.
$(BUILD)/mesh_files: LIBS = -ljansson $(IO_LIBS) $(call header,assimp/cimport.h,-lassimp)
$(BUILD)/mesh_files: $(call object,tb/benchmark/mesh_files.c) $(IO) $(LIB)
$(BUILD)/solid-corpus: LIBS = $(IO_LIBS)
$(BUILD)/solid-corpus: $(call object,tb/solid/corpus.c) $(IO) $(LIB)
$(BUILD)/mesh_writer: LIBS = $(call header,zip.h,-lzip)
$(BUILD)/mesh_writer: $(call object,tb/benchmark/mesh_writer.c)
$(BUILD)/obj/tb/benchmark/mesh_files.o: SEPAX_CFLAGS += $(call header,assimp/cimport.h,-DASSIMP)
$(BUILD)/obj/tb/benchmark/mesh_writer.o: SEPAX_CFLAGS += $(call header,zip.h,-DZIP)
$(addprefix $(BUILD)/,mesh_files mesh_writer solid-corpus):
	$(link)
$(BUILD)/bench_tree: $(SWEEP_O) $(LIB)
	@echo "  LINK    $@"
	@$(aside) $(CXX) $^ $(call header,fcl/fcl.h,-lfcl -lccd) -lm -pthread \
	  -o $$new && $(in_place)

-include $(wildcard $(BUILD)/obj/*/*/*/*.d $(BUILD)/obj/*/*/*.d $(BUILD)/obj/*/*.d)
