/* SPDX-License-Identifier: MIT */
/* output.c - writing a generated design into a folder. */
#include "files/output.h"

#include "bench/bench.h"
#include "emit/prefix.h"
#include "engine/engine.h"
#include "files/describe.h"
#include "files/folder.h"
#include "ip/ip.h"
#include "sheet/sheet.h"
#include "util/error.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { OTHER_FILES = 24, HERE_LENGTH = 3000, PATH_LENGTH = 2 * HERE_LENGTH + 8 };

/* The first module that has a file. */
static int first_file(const emitter *e, const sepax_output *how) {
  return how->single_file ? e->modules - 1 : 0;
}

/* A path as a list of files has it: Icarus Verilog takes // for a comment. */
static void put_path(emit_text *list, const char *path) {
  for (const char *c = path; *c != '\0'; c++) {
    if (c[0] != '/' || c[1] != '/') {
      text_putc(list, *c);
    }
  }
}

/* The list of files with paths from the root. Like the other list it has no comments: Yosys takes
 * read_verilog $(cat LIST). Tools split a line at a blank, and replace what begins with $. */
static bool list_absolute(const emitter *e, const sepax_output *how, const char *folder,
                          emit_text *list, sepax_error *error) {
  char path[PATH_LENGTH] = "";
  const bool rooted = folder[0] == '/';
  list->failed = list->failed || (!rooted && getcwd(path, HERE_LENGTH - 1) == NULL);
  const size_t here = strlen(path);
  snprintf(path + here, sizeof path - here, "%s%s/", rooted ? "" : "/", folder);
  if (strpbrk(path, " \t\r\n\"'\\$*?") != NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%.200s: a list of files cannot name a folder with blanks, quotes, \\, $, * "
                      "or ?; give another folder, or leave --absolute out",
                      folder);
  }
  for (int i = first_file(e, how); i < e->modules; i++) {
    put_path(list, path);
    prefix_put(list, e->module[i]->name, e->prefix);
    text_puts(list, ".v\n");
  }
  return true;
}

/* Registers of an engine, if there are any. */
static void render_registers(const sepax_design *d, folder_files *o) {
  const engine_registers *registers = engine_generator_of(&d->config)->registers;
  if (registers != NULL) {
    engine_header(registers, folder_add(o, registers->file, "h"));
    engine_page(registers, folder_add(o, registers->file, "md"));
    engine_rdl(registers, folder_add(o, registers->file, "rdl"));
  }
}

/* The datasheet, with the waveform of the handshake. */
static void render_sheet(emitter *e, const sheet_costs *costs, folder_files *o) {
  sheet_write(e, costs, false, folder_add(o, "doc/sepax", "md"));
  sheet_write(e, costs, true, folder_add(o, "doc/sepax", "html"));
  sheet_wave(e, true, folder_add(o, "doc/sepax_handshake", "svg"));
  sheet_wave(e, false, folder_add(o, "doc/sepax_handshake", "json"));
}

/* The top for other languages and tools. */
static void render_ip(emitter *e, bool single_file, folder_files *o) {
  const engine_registers *registers = engine_generator_of(&e->design->config)->registers;
  emit_ports ports = emit_ports_of(e->module[e->modules - 1]);
  ip_vhdl(e, &ports, folder_add(o, "ip/sepax_pkg", "vhd"));
  ip_systemverilog(e, &ports, folder_add(o, "ip/sepax_if", "sv"));
  ip_xact(e, &ports, registers, single_file, folder_add(o, "ip/sepax", "xml"));
  if (registers != NULL) {
    ip_svd(e, &ports, registers, folder_add(o, "ip/sepax", "svd"));
  }
  emit_ports_free(&ports);
}

static void render(emitter *e, const sepax_output *how, const sheet_costs *costs, folder_files *o) {
  const sepax_design *d = e->design;
  for (int i = first_file(e, how); i < e->modules; i++) {
    emit_text *file = folder_add(o, e->module[i]->name, "v");
    if (how->single_file) {
      emit_print_all(e, file);
    } else {
      emit_print(e->module[i], file);
    }
  }
  emit_text *list = folder_add(o, "sepax", "f");
  for (int i = first_file(e, how); i < e->modules; i++) {
    text_printf(list, "%s.v\n", e->module[i]->name);
  }
  if (d == NULL) {
    return;
  }
  describe_c(d, folder_add(o, "sepax_params", "h"));
  describe_verilog(e, folder_add(o, "sepax_params", "vh"));
  render_registers(d, o);
  describe_json(e, folder_add(o, "sepax", "json"));
  describe_constraints(e, folder_add(o, "sepax", "sdc"));
  if (d->config.target == SEPAX_TARGET_XC7 || d->config.target == SEPAX_TARGET_XCUP) {
    describe_constraints(e, folder_add(o, "sepax", "xdc"));
  }
  describe_waves(e, folder_add(o, "sepax", "gtkw"));
  if (how->vectors >= 0) {
    bench_write(e, how->vectors > 0 ? how->vectors : BENCH_VECTORS,
                folder_add(o, "tb/sepax_tb", "v"));
  }
  if (how->vectors >= 0 && d->config.lanes > 0) {
    bench_write_object(e, folder_add(o, "tb/sepax_engine_tb", "v"));
  }
  render_sheet(e, costs, o);
  render_ip(e, how->single_file, o);
}

bool gen_write(emitter *e, const char *folder, const sepax_output *how, const sheet_costs *costs,
               sepax_error *error) {
  folder_files o;
  folder_init(&o, folder, e->prefix, e->modules + OTHER_FILES);
  render(e, how, costs, &o);
  folder_rename(&o);
  bool ok =
      !how->absolute || list_absolute(e, how, folder, folder_add(&o, "sepax_absolute", "f"), error);
  if (ok && !emit_works(e)) {
    *error = e->error;
    ok = false;
  }
  ok = ok && folder_write(&o, error);
  folder_free(&o);
  return ok;
}
