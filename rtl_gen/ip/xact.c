/* SPDX-License-Identifier: MIT */
/* xact.c - a component of IP-XACT, IEEE 1685-2014. */
#include "ip/ip.h"
#include "ip/xml.h"

#include "sepax_design.h"

#include <string.h>

/* ------------------------------------------------------------------------- buses */

/* The first port of a bus? */
static bool begins_bus(const emit_ports *ports, int at) {
  const emit_port *port = &ports->port[at];
  const bool is_bus = strcmp(port->type, "axis") == 0 || strcmp(port->type, "aximm") == 0;
  for (int i = 0; i < at && is_bus; i++) {
    if (strcmp(ports->port[i].bus, port->bus) == 0) {
      return false;
    }
  }
  return is_bus;
}

static void put_bus(xml *x, const emit_ports *ports, int first) {
  const emit_port *of = &ports->port[first];
  const bool slave = of->bus[0] == 's';
  const bool stream = strcmp(of->type, "axis") == 0;
  const char *type = stream ? "AXI4Stream" : slave ? "AXI4-Lite" : "AXI4";
  xml_open(x, "busInterface", "");
  xml_leaf(x, "name", "%s", of->bus);
  xml_empty(x, "busType",
            gen_format("vendor=\"amba.com\" library=\"AMBA4\" name=\"%s\" version=\"r0p0_0\"", type)
                .text);
  xml_open(x, "abstractionTypes", "");
  xml_open(x, "abstractionType", "");
  xml_empty(
      x, "abstractionRef",
      gen_format("vendor=\"amba.com\" library=\"AMBA4\" name=\"%s_rtl\" version=\"r0p0_0\"", type)
          .text);
  xml_open(x, "portMaps", "");
  for (int i = first; i < ports->count; i++) {
    if (strcmp(ports->port[i].bus, of->bus) == 0) {
      xml_open(x, "portMap", "");
      xml_open(x, "logicalPort", "");
      xml_leaf(x, "name", "%s", ports->port[i].signal);
      xml_close(x, "logicalPort");
      xml_open(x, "physicalPort", "");
      xml_leaf(x, "name", "%s", ports->port[i].name);
      xml_close(x, "physicalPort");
      xml_close(x, "portMap");
    }
  }
  xml_close(x, "portMaps");
  xml_close(x, "abstractionType");
  xml_close(x, "abstractionTypes");
  if (slave && !stream) {
    xml_open(x, "slave", "");
    xml_empty(x, "memoryMapRef", "memoryMapRef=\"registers\"");
    xml_close(x, "slave");
  } else {
    xml_empty(x, slave ? "slave" : "master", "");
  }
  xml_close(x, "busInterface");
}

static void put_buses(xml *x, const emit_ports *ports) {
  bool any = false;
  for (int i = 0; i < ports->count; i++) {
    if (begins_bus(ports, i)) {
      if (!any) {
        xml_open(x, "busInterfaces", "");
      }
      any = true;
      put_bus(x, ports, i);
    }
  }
  if (any) {
    xml_close(x, "busInterfaces");
  }
}

/* --------------------------------------------------------------------- registers */

static void put_access(xml *x, engine_kind kind) {
  static const char *const access[] = {"read-only", "read-only", "write-only", "read-write",
                                       "read-write"};
  xml_leaf(x, "access", "%s", access[kind]);
}

static void put_field(xml *x, const engine_register *of, const engine_register *field) {
  xml_open(x, "field", "");
  xml_leaf(x, "name", "%s", field != NULL ? field->name : "VALUE");
  if (field != NULL && field->about[0] != '\0') {
    xml_leaf(x, "description", "%s", field->about);
  }
  xml_leaf(x, "bitOffset", "%d", field != NULL ? field->low : 0);
  if (of->kind >= ENGINE_WRITE) {
    xml_open(x, "resets", "");
    xml_open(x, "reset", "");
    xml_leaf(x, "value", "0");
    xml_close(x, "reset");
    xml_close(x, "resets");
  }
  xml_leaf(x, "bitWidth", "%d", field != NULL ? field->bits : 32);
  put_access(x, of->kind);
  if (of->kind == ENGINE_CLEAR) {
    xml_leaf(x, "modifiedWriteValue", "oneToClear");
  }
  xml_close(x, "field");
}

static void put_registers(xml *x, const engine_registers *map, int address_bits) {
  const engine_register *end = map->row + map->rows;
  unsigned address = 0;
  xml_open(x, "memoryMaps", "");
  xml_open(x, "memoryMap", "");
  xml_leaf(x, "name", "registers");
  xml_open(x, "addressBlock", "");
  xml_leaf(x, "name", "registers");
  xml_leaf(x, "baseAddress", "0");
  xml_leaf(x, "range", "%d", 1 << address_bits);
  xml_leaf(x, "width", "32");
  xml_leaf(x, "usage", "register");
  for (const engine_register *r = map->row; r < end;) {
    const engine_register *of = r++;
    xml_open(x, "register", "");
    xml_leaf(x, "name", "%s", of->name);
    xml_leaf(x, "description", "%s", of->about);
    xml_leaf(x, "addressOffset", "%u", address);
    xml_leaf(x, "size", "32");
    put_access(x, of->kind);
    if (r == end || r->kind != ENGINE_FIELD) {
      put_field(x, of, NULL);
    }
    for (; r < end && r->kind == ENGINE_FIELD; r++) {
      put_field(x, of, r);
    }
    xml_close(x, "register");
    address += 4;
  }
  xml_close(x, "addressBlock");
  xml_leaf(x, "addressUnitBits", "8");
  xml_close(x, "memoryMap");
  xml_close(x, "memoryMaps");
}

/* ------------------------------------------------------------------ model, files */

static void put_port(xml *x, const emit_port *port) {
  xml_open(x, "port", "");
  xml_leaf(x, "name", "%s", port->name);
  xml_leaf(x, "description", "%s", port->about);
  xml_open(x, "wire", "");
  xml_leaf(x, "direction", "%s", port->is_input ? "in" : "out");
  if (port->width > 1) {
    xml_open(x, "vectors", "");
    xml_open(x, "vector", "");
    xml_leaf(x, "left", "%d", port->width - 1);
    xml_leaf(x, "right", "0");
    xml_close(x, "vector");
    xml_close(x, "vectors");
  }
  xml_close(x, "wire");
  xml_close(x, "port");
}

static void put_model(xml *x, const char *top, const emit_ports *ports) {
  xml_open(x, "model", "");
  xml_open(x, "views", "");
  xml_open(x, "view", "");
  xml_leaf(x, "name", "rtl");
  xml_leaf(x, "componentInstantiationRef", "verilog");
  xml_close(x, "view");
  xml_close(x, "views");
  xml_open(x, "instantiations", "");
  xml_open(x, "componentInstantiation", "");
  xml_leaf(x, "name", "verilog");
  xml_leaf(x, "language", "Verilog");
  xml_leaf(x, "moduleName", "%s", top);
  xml_open(x, "fileSetRef", "");
  xml_leaf(x, "localName", "verilog");
  xml_close(x, "fileSetRef");
  xml_close(x, "componentInstantiation");
  xml_close(x, "instantiations");
  xml_open(x, "ports", "");
  for (int i = 0; i < ports->count; i++) {
    put_port(x, &ports->port[i]);
  }
  xml_close(x, "ports");
  xml_close(x, "model");
}

static void put_files(xml *x, const emitter *e, bool single) {
  xml_open(x, "fileSets", "");
  xml_open(x, "fileSet", "");
  xml_leaf(x, "name", "verilog");
  for (int i = single ? e->modules - 1 : 0; i < e->modules; i++) {
    xml_open(x, "file", "");
    xml_leaf(x, "name", "../%s.v", e->module[i]->name);
    xml_leaf(x, "fileType", "verilogSource");
    xml_close(x, "file");
  }
  xml_close(x, "fileSet");
  xml_close(x, "fileSets");
}

void ip_xact(const emitter *e, const emit_ports *ports, const engine_registers *map, bool single,
             emit_text *out) {
  static const char names[] =
      "xmlns:ipxact=\"http://www.accellera.org/XMLSchema/IPXACT/1685-2014\"\n"
      "  xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"\n"
      "  xsi:schemaLocation=\"http://www.accellera.org/XMLSchema/IPXACT/1685-2014\n"
      "    http://www.accellera.org/XMLSchema/IPXACT/1685-2014/index.xsd\"";
  const char *top = e->module[e->modules - 1]->name;
  const emit_port *address = emit_port_find(ports, "s_axi_awaddr");
  xml x;
  xml_begin(&x, out, "ipxact:");
  xml_open(&x, "component", names);
  xml_leaf(&x, "vendor", "sepax");
  xml_leaf(&x, "library", "cores");
  xml_leaf(&x, "name", "%s", top);
  xml_leaf(&x, "version", "%s", SEPAX_VERSION);
  put_buses(&x, ports);
  if (map != NULL && address != NULL) {
    put_registers(&x, map, address->width);
  }
  put_model(&x, top, ports);
  put_files(&x, e, single);
  xml_leaf(&x, "description", "%s", e->command);
  xml_close(&x, "component");
}
