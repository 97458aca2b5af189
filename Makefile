# Makefile - the front door of sepax; `make help` lists the verbs.

ARCH   ?= paper
WORD   ?= 18
II     ?= 3
PRECISION   ?= full
BLOCK_FLOAT ?= off
COPLANARITY ?= plane
INEQUALITY  ?= correct
EPSILON     ?= 1
COUNT  ?= 100000
SEED   ?= 1

CC        ?= cc
CXX       ?= c++
YOSYS     ?= yosys
VERILATOR ?= verilator
IVERILOG  ?= iverilog
VVP       ?= vvp
GNUPLOT   ?= gnuplot
LIBERTY   ?= /usr/share/qflow/tech/osu018/osu018_stdcells.lib
export CC CXX YOSYS VERILATOR IVERILOG VVP LIBERTY

BUILD  ?= build
CFLAGS ?= -O2 -g
WARN    = -Wall -Wextra -Werror -Wconversion -Wshadow
SEPAX_CFLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L $(WARN) -ffp-contract=off -MMD -MP \
               -Ic_model -Irtl_gen $(CFLAGS)

LIB_SRC = $(wildcard c_model/*.c)
CLI_SRC = $(wildcard c_model/cli/*.c) $(wildcard rtl_gen/*.c)
object  = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))
SEPAX   = $(BUILD)/sepax
LIB     = $(BUILD)/libsepax.a

all: $(SEPAX)

$(BUILD)/obj/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(SEPAX_CFLAGS) -c $< -o $@

$(LIB): $(call object,$(LIB_SRC))
	@rm -f $@
	$(AR) rcs $@ $^

$(SEPAX): $(call object,$(CLI_SRC)) $(LIB)
	$(CC) $(CFLAGS) $^ -ljansson -lm -o $@

-include $(wildcard $(BUILD)/obj/*/*.d $(BUILD)/obj/*/*/*.d)
