# flags.mk - how C is compiled, and where its objects are.

CFLAGS      ?= -O2 -g
INCLUDES     = -Ilib -Iio -Ic_model -Irtl_gen -Iprogram -Itb -Isynth
SEPAX_CFLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Werror -Wconversion \
               -Wshadow -ffp-contract=off $(INCLUDES) $(CFLAGS)
XML_CFLAGS  := -isystem $(firstword $(patsubst -I%,%,$(filter -I%,$(shell \
               pkg-config --cflags-only-I libxml-2.0 2> /dev/null))) /usr/include/libxml2)
OBJCOPY     ?= objcopy
object       = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))
OPTIONS_OBJ  = $(call object,program/cli/options.c)
