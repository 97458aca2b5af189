/* SPDX-License-Identifier: MIT */
/* systemverilog.c - interfaces of SystemVerilog around the top. */
#include "ip/ip.h"

#include <string.h>

/* The ports that begin like this form an interface. */
static const struct {
  const char *prefix, *name, *about;
} groups[] = {
    {"in_", "pair", "Pairs of triangles, which the user sends"},
    {"out_", "verdict", "Verdicts, which the user takes"},
    {"s_axi_", "s_axi", "AXI4-Lite: registers"},
    {"m_axi_", "m_axi", "AXI4: memory"},
    {"s_axis_", "s_axis", "AXI4-Stream into the design"},
    {"m_axis_", "m_axis", "AXI4-Stream out of the design"},
};
enum { GROUPS = sizeof groups / sizeof groups[0] };

static bool belongs(const emit_port *port, int group) {
  return strncmp(port->name, groups[group].prefix, strlen(groups[group].prefix)) == 0;
}

static int group_of(const emit_port *port) {
  int group = 0;
  while (group < GROUPS && !belongs(port, group)) {
    group++;
  }
  return group;
}

static bool is_there(const emit_ports *ports, int group) {
  for (int i = 0; i < ports->count; i++) {
    if (belongs(&ports->port[i], group)) {
      return true;
    }
  }
  return false;
}

static void put_type(const emit_port *port, emit_text *out) {
  text_puts(out, port->is_signed ? "logic signed " : "logic ");
  if (port->width > 1) {
    text_printf(out, "[%d:0] ", port->width - 1);
  }
}

/* The signals of a group with their directions; `core`: as the top has them, else the opposite. */
static void put_modport(const emit_ports *ports, int group, bool core, emit_text *out) {
  bool first = true;
  text_printf(out, "  modport %s (\n", core ? "core" : "user");
  for (int i = 0; i < ports->count; i++) {
    const emit_port *port = &ports->port[i];
    if (belongs(port, group)) {
      text_printf(out, "%s    %s %s", first ? "" : ",\n",
                  port->is_input == core ? "input" : "output",
                  port->name + strlen(groups[group].prefix));
      first = false;
    }
  }
  text_puts(out, "\n  );\n");
}

static void put_interface(const emit_ports *ports, int group, emit_text *out) {
  text_printf(out, "// %s.\ninterface sepax_%s_if;\n", groups[group].about, groups[group].name);
  for (int i = 0; i < ports->count; i++) {
    const emit_port *port = &ports->port[i];
    if (belongs(port, group)) {
      text_puts(out, "  ");
      put_type(port, out);
      text_printf(out, "%s; // %s\n", port->name + strlen(groups[group].prefix), port->about);
    }
  }
  put_modport(ports, group, true, out);
  put_modport(ports, group, false, out);
  text_puts(out, "endinterface\n\n");
}

static void put_wrapper(const char *top, const emit_ports *ports, emit_text *out) {
  bool first = true;
  text_printf(out, "module %s_if (\n", top);
  for (int i = 0; i < ports->count; i++) {
    const emit_port *port = &ports->port[i];
    if (group_of(port) == GROUPS) {
      text_printf(out, "%s  %s ", first ? "" : ",\n",
                  port->is_input ? "input  wire" : "output wire");
      put_type(port, out);
      text_puts(out, port->name);
      first = false;
    }
  }
  for (int group = 0; group < GROUPS; group++) {
    if (is_there(ports, group)) {
      text_printf(out, ",\n  sepax_%s_if.core %s", groups[group].name, groups[group].name);
    }
  }
  text_printf(out, "\n);\n  %s top (\n", top);
  for (int i = 0; i < ports->count; i++) {
    const emit_port *port = &ports->port[i];
    const int group = group_of(port);
    text_printf(out, "    .%s(", port->name);
    if (group < GROUPS) {
      text_printf(out, "%s.%s", groups[group].name, port->name + strlen(groups[group].prefix));
    } else {
      text_puts(out, port->name);
    }
    text_puts(out, i + 1 < ports->count ? "),\n" : ")\n");
  }
  text_puts(out, "  );\nendmodule\n");
}

void ip_systemverilog(const emitter *e, const emit_ports *ports, emit_text *out) {
  const char *top = e->module[e->modules - 1]->name;
  text_printf(
      out,
      "// sepax_if.sv\n// SPDX-License-Identifier: MIT\n//\n"
      "// Interfaces of SystemVerilog for %s, and %s_if, which has them as ports.\n"
      "// Modport core is that of the design, modport user that of what is around it.\n//\n",
      top, top);
  emit_origin(e, "//", out);
  text_puts(out, "\n`default_nettype none\n/* verilator lint_off DECLFILENAME */\n\n");
  for (int group = 0; group < GROUPS; group++) {
    if (is_there(ports, group)) {
      put_interface(ports, group, out);
    }
  }
  put_wrapper(top, ports, out);
  text_puts(out, "\n`default_nettype wire\n");
}
