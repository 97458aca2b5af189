/* SPDX-License-Identifier: MIT */
/* svd.c - the registers of an engine in CMSIS-SVD 1.3, for debuggers and generators of code. */
#include "ip/ip.h"
#include "ip/xml.h"

#include "sepax_design.h"

static void put_access(xml *x, engine_kind kind) {
  static const char *const access[] = {"read-only", "read-only", "write-only", "read-write",
                                       "read-write"};
  xml_leaf(x, "access", "%s", access[kind]);
  if (kind >= ENGINE_WRITE) {
    xml_leaf(x, "resetValue", "0x0");
  }
  if (kind == ENGINE_CLEAR) {
    xml_leaf(x, "modifiedWriteValues", "oneToClear");
  }
}

static void put_field(xml *x, const engine_register *field) {
  xml_open(x, "field", "");
  xml_leaf(x, "name", "%s", field->name);
  if (field->about[0] != '\0') {
    xml_leaf(x, "description", "%s", field->about);
  }
  xml_leaf(x, "bitOffset", "%d", field->low);
  xml_leaf(x, "bitWidth", "%d", field->bits);
  xml_close(x, "field");
}

static void put_registers(xml *x, const engine_registers *map) {
  const engine_register *end = map->row + map->rows;
  unsigned address = 0;
  xml_open(x, "registers", "");
  for (const engine_register *r = map->row; r < end;) {
    const engine_register *of = r++;
    const bool fields = r < end && r->kind == ENGINE_FIELD;
    xml_open(x, "register", "");
    xml_leaf(x, "name", "%s", of->name);
    xml_leaf(x, "description", "%s", of->about);
    xml_leaf(x, "addressOffset", "0x%02x", address);
    xml_leaf(x, "size", "32");
    put_access(x, of->kind);
    if (fields) {
      xml_open(x, "fields", "");
      for (; r < end && r->kind == ENGINE_FIELD; r++) {
        put_field(x, r);
      }
      xml_close(x, "fields");
    }
    xml_close(x, "register");
    address += 4;
  }
  xml_close(x, "registers");
}

void ip_svd(const emitter *e, const emit_ports *ports, const engine_registers *map,
            emit_text *out) {
  const char *top = e->module[e->modules - 1]->name;
  const emit_port *address = emit_port_find(ports, "s_axi_awaddr");
  xml x;
  xml_begin(&x, out, "");
  xml_open(&x, "device",
           "schemaVersion=\"1.3\" xmlns:xs=\"http://www.w3.org/2001/XMLSchema-instance\" "
           "xs:noNamespaceSchemaLocation=\"CMSIS-SVD.xsd\"");
  xml_leaf(&x, "name", "%s", top);
  xml_leaf(&x, "version", "%s", SEPAX_VERSION);
  xml_leaf(&x, "description", "%s; baseAddress is to be that of your bus", e->command);
  xml_leaf(&x, "addressUnitBits", "8");
  xml_leaf(&x, "width", "32");
  xml_open(&x, "peripherals", "");
  xml_open(&x, "peripheral", "");
  xml_leaf(&x, "name", "%s", top);
  xml_leaf(&x, "description", "%s", map->about);
  xml_leaf(&x, "baseAddress", "0x0");
  xml_open(&x, "addressBlock", "");
  xml_leaf(&x, "offset", "0x0");
  xml_leaf(&x, "size", "0x%x", 1U << (address != NULL ? address->width : 0));
  xml_leaf(&x, "usage", "registers");
  xml_close(&x, "addressBlock");
  put_registers(&x, map);
  xml_close(&x, "peripheral");
  xml_close(&x, "peripherals");
  xml_close(&x, "device");
}
