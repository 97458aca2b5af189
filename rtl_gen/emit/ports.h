/* SPDX-License-Identifier: MIT */
/* ports.h - the ports of a checked module, for files that describe it to other tools. */
#ifndef SEPAX_EMIT_PORTS_H
#define SEPAX_EMIT_PORTS_H

#include "emit/emit.h"

/* A port; texts are cut to their space. */
typedef struct {
  char name[EMIT_NAME];
  bool is_input, is_signed;
  int width;       /* bits, 1 or more */
  char about[128]; /* the comment behind it */
  char type[16];   /* of the bus: "axis", "aximm", "clock", "reset", "interrupt"; "": none */
  char bus[16];    /* "s_axi" */
  char signal[16]; /* its part of the bus: "TVALID" */
} emit_port;

typedef struct {
  emit_port *port;
  int count;
} emit_ports;

/* The ports in their order; to be freed. Without memory there are none and e->error is set. The bus
 * is that of the attribute X_INTERFACE_INFO before the port. */
emit_ports emit_ports_of(const emit_module *m);
void emit_ports_free(emit_ports *ports);

/* A port by name, or NULL. */
const emit_port *emit_port_find(const emit_ports *ports, const char *name);

#endif
