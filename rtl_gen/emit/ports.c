/* SPDX-License-Identifier: MIT */
/* ports.c - see ports.h. */
#include "emit/ports.h"

#include "emit/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Copy the text up to one of `ends`, and return what is behind that. */
static const char *copy_until(char *to, size_t size, const char *text, const char *ends) {
  const size_t length = strcspn(text, ends);
  snprintf(to, size, "%.*s", (int)length, text);
  return text[length] != '\0' ? text + length + 1 : text + length;
}

/* "xilinx.com:interface:axis:1.0 s_axis TVALID" */
static void read_interface(emit_port *port, const char *text) {
  const char *type = strchr(text, ':');
  type = type != NULL ? strchr(type + 1, ':') : NULL;
  if (type != NULL) {
    const char *version = copy_until(port->type, sizeof port->type, type + 1, ":");
    const char *bus = version + strcspn(version, " ");
    const char *signal = copy_until(port->bus, sizeof port->bus, bus + (*bus == ' '), " ");
    copy_until(port->signal, sizeof port->signal, signal, "\"");
  }
}

static void read_port(emit_port *port, const check_name *n, const char *before) {
  static const char info[] = "X_INTERFACE_INFO = \"";
  snprintf(port->name, sizeof port->name, "%s", n->name);
  port->is_input = n->kind == NAME_INPUT;
  port->is_signed = n->is_signed;
  port->width = n->width;
  copy_until(port->about, sizeof port->about, n->about, "\n");
  const char *attribute = strstr(before, info);
  if (attribute != NULL && attribute < n->about) {
    read_interface(port, attribute + sizeof info - 1);
  }
}

emit_ports emit_ports_of(const emit_module *m) {
  emit_ports ports = {NULL, 0};
  reader r;
  reader_open(&r, m, m->verilog);
  check_header(&r);
  ports.port = r.failed ? NULL : calloc((size_t)r.header + 1, sizeof *ports.port);
  const char *before = m->verilog;
  for (int i = 0; ports.port != NULL && i < r.header; i++) {
    if (r.name[i].kind != NAME_CONSTANT) {
      read_port(&ports.port[ports.count++], &r.name[i], before);
      before = r.name[i].about;
    }
  }
  reader_close(&r);
  if (ports.port == NULL) {
    emit_no_memory(m->emitter);
  }
  return ports;
}

void emit_ports_free(emit_ports *ports) {
  free(ports->port);
  *ports = (emit_ports){NULL, 0};
}

const emit_port *emit_port_find(const emit_ports *ports, const char *name) {
  for (int i = 0; i < ports->count; i++) {
    if (strcmp(ports->port[i].name, name) == 0) {
      return &ports->port[i];
    }
  }
  return NULL;
}
