/* SPDX-License-Identifier: MIT */
/* vhdl.c - the component of the top in a VHDL package. */
#include "ip/ip.h"

#include <string.h>

static int longest_name(const emit_ports *ports) {
  int longest = 0;
  for (int i = 0; i < ports->count; i++) {
    const int length = (int)strlen(ports->port[i].name);
    longest = length > longest ? length : longest;
  }
  return longest;
}

static void put_port(const emit_port *port, int column, bool last, emit_text *out) {
  text_printf(out, "      %-*s : %-3s ", column, port->name, port->is_input ? "in" : "out");
  if (port->width == 1) {
    text_puts(out, "std_logic");
  } else {
    text_printf(out, "std_logic_vector(%d downto 0)", port->width - 1);
  }
  text_printf(out, "%s -- %s%s\n", last ? "" : ";", port->is_signed ? "signed: " : "", port->about);
}

void ip_vhdl(const emitter *e, const emit_ports *ports, emit_text *out) {
  const sepax_design *d = e->design;
  const char *top = e->module[e->modules - 1]->name;
  const int column = longest_name(ports);
  text_printf(out,
              "-- sepax_pkg.vhd\n-- SPDX-License-Identifier: MIT\n--\n"
              "-- The component of the Verilog module %s, for designs in VHDL.\n--\n",
              top);
  emit_origin(e, "--", out);
  text_printf(out,
              "\nlibrary ieee;\nuse ieee.std_logic_1164.all;\n\npackage sepax_pkg is\n\n"
              "  constant sepax_word    : positive := %d; -- bits of a coordinate\n"
              "  constant sepax_latency : positive := %d; -- cycles from a pair to its verdict\n"
              "  constant sepax_ii      : positive := %d; -- cycles between two pairs\n\n"
              "  component %s is\n    port (\n",
              d->config.word, d->latency, d->config.ii, top);
  for (int i = 0; i < ports->count; i++) {
    put_port(&ports->port[i], column, i + 1 == ports->count, out);
  }
  text_puts(out, "    );\n  end component;\n\nend package;\n");
}
