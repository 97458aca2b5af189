# SPDX-License-Identifier: MIT
# flags.mk - how C is compiled, and where its objects are.

CFLAGS      ?= -O2 -g
INCLUDES     = -Ilib -Iio -Ic_model -Irtl_gen -Iprogram -Itb -Isynth
SEPAX_CFLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Werror -Wconversion \
               -Wshadow -ffp-contract=off $(INCLUDES) $(CFLAGS)
XML_CFLAGS  := -isystem $(firstword $(patsubst -I%,%,$(filter -I%,$(shell \
               pkg-config --cflags-only-I libxml-2.0 2> /dev/null))) /usr/include/libxml2)
OBJCOPY     ?= objcopy

# A file is made as $$new and then renamed, so that no other make sees an incomplete file:
#   $(aside) COMMAND -o $$new && $(in_place)
# With --coverage the object is made in its place, because the names of coverage files follow it.
measured     = $(filter --coverage,$(CFLAGS))
aside        = new=$@$(if $(measured),,.$$$$) && \
               $(if $(measured),,trap 'rm -rf $$new $$new.*' EXIT && trap 'exit 1' HUP INT TERM &&)
in_place     = $(if $(measured),:,mv -f $$new $@)

object       = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))
OPTIONS_OBJ  = $(call object,program/cli/options.c)

comma      := ,
hash       := \#
# libxml2 reads robots and DAE, libxml2 and libzip read 3MF, and libmd makes the digests of
# certificates. If one is missing or switched off (LIBXML2=no, LIBZIP=no, LIBMD=no), then files in
# folders `missing` replace the code that calls it.
has = $(shell printf '%s\n' '$(hash)include <$(1)>' 'int main(void) { return 0; }' | \
      $(CC) $(filter-out --coverage,$(CFLAGS)) $(LDFLAGS) $(XML_CFLAGS) -x c - $(2) -o /dev/null \
      2> /dev/null && echo yes || echo no)
ifndef LIBZIP
LIBZIP := $(call has,zip.h,-lzip)
endif
ifndef LIBXML2
LIBXML2 := $(call has,libxml/parser.h,-lxml2)
endif
ifndef LIBMD
LIBMD := $(call has,sha2.h,-lmd)
endif
export LIBZIP LIBXML2 LIBMD
with_xml    = $(filter yes,$(LIBXML2))
with_zip    = $(and $(with_xml),$(filter yes,$(LIBZIP)))
with_md     = $(filter yes,$(LIBMD))
IO_LIBS     = $(if $(with_xml),-lxml2) $(if $(with_zip),-lzip)
