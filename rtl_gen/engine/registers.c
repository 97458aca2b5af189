/* engine_registers.c - the register map of the engine, once: for the RTL, for C, for people. */
#include "engine.h"
#include "sepax_design.h"

#include <string.h>

const engine_register engine_registers[ENGINE_REGISTERS] = {
    [ENGINE_ID] = {"ID", ENGINE_READ, "0x53505841, \"SPXA\"", {{0}}},
    [ENGINE_GENERATOR] = {"GENERATOR",
                          ENGINE_READ,
                          "its version",
                          {{"MAJOR", 16, 8, ""}, {"MINOR", 8, 8, ""}, {"PATCH", 0, 8, ""}}},
    [ENGINE_DESIGN] = {"DESIGN",
                       ENGINE_READ,
                       "what was generated",
                       {{"WORD", 0, 6, "bits of a coordinate"},
                        {"LANES", 8, 7, "box lanes"},
                        {"CORES", 16, 4, "exact cores"},
                        {"II", 24, 5, "cycles a pair of each core"}}},
    [ENGINE_MEMORY] = {"MEMORY",
                       ENGINE_READ,
                       "room for triangles",
                       {{"LOG2_A", 0, 4, "2^LOG2_A of A"}, {"LOG2_B", 8, 4, "2^LOG2_B of B"}}},
    [ENGINE_COMMAND] = {"COMMAND",
                        ENGINE_WRITE,
                        "one bit, written as 1",
                        {{"START", 0, 1,
                          "begin a run; refused while busy or loading, or without objects"},
                         {"STOP", 1, 1, "end the run as soon as the core is empty"}}},
    [ENGINE_MODE] = {"MODE",
                     ENGINE_READ_WRITE,
                     "of the next run; not writable while busy",
                     {{"FIRST", 0, 1, "end at the first collision"},
                      {"QUIET", 1, 1, "count only: nothing on the result stream"}}},
    [ENGINE_STATUS] = {"STATUS",
                       ENGINE_READ,
                       "",
                       {{"BUSY", 0, 1, "a run is going on"},
                        {"HIT", 1, 1, "the run has found a collision"},
                        {"OUT_OF_RANGE", 2, 1, "some of them are undecided, and flagged"},
                        {"STOPPED", 3, 1, "the run ended before all pairs were tested"},
                        {"LOADED_A", 4, 1, "object A is whole"},
                        {"LOADED_B", 5, 1, "object B is whole"},
                        {"LOADING", 6, 1, "an object has begun to come"},
                        {"WORD", 8, 1, "last object: a coordinate does not fit W bits"},
                        {"FRAME", 9, 1, "last object: it ended within a triangle"},
                        {"FULL", 10, 1, "last object: more triangles than the memory holds"}}},
    [ENGINE_ENABLE] = {"ENABLE",
                       ENGINE_READ_WRITE,
                       "which of PENDING raise the interrupt",
                       {{"DONE", 0, 1, ""}, {"HIT", 1, 1, ""}, {"LOADED", 2, 1, ""}}},
    [ENGINE_PENDING] = {"PENDING",
                        ENGINE_CLEAR,
                        "write 1 to clear",
                        {{"DONE", 0, 1, "a run has ended"},
                         {"HIT", 1, 1, "a run has found its first collision"},
                         {"LOADED", 2, 1, "an object has come, whole or not"}}},
    [ENGINE_COUNT_A] = {"COUNT_A", ENGINE_READ, "triangles of A, 0 unless it is whole", {{0}}},
    [ENGINE_COUNT_B] = {"COUNT_B", ENGINE_READ, "triangles of B, 0 unless it is whole", {{0}}},
    [ENGINE_MOVE_X] = {"MOVE_X",
                       ENGINE_READ_WRITE,
                       "added to each x of B, signed, W + 1 bits; not writable while busy",
                       {{0}}},
    [ENGINE_MOVE_Y] = {"MOVE_Y", ENGINE_READ_WRITE, "likewise", {{0}}},
    [ENGINE_MOVE_Z] = {"MOVE_Z", ENGINE_READ_WRITE, "likewise", {{0}}},
    [ENGINE_PAIRS] = {"PAIRS", ENGINE_READ, "pairs through the box lanes in this run", {{0}}},
    [ENGINE_CANDIDATES] = {"CANDIDATES", ENGINE_READ, "pairs that went on to the cores", {{0}}},
    [ENGINE_COLLISIONS] = {"COLLISIONS", ENGINE_READ, "pairs that collide", {{0}}},
    [ENGINE_OUT_OF_RANGE] = {"OUT_OF_RANGE",
                             ENGINE_READ,
                             "of these, undecided: beyond the extents, or moved out of W bits",
                             {{0}}},
    [ENGINE_WARNINGS] = {"WARNINGS",
                         ENGINE_READ,
                         "pairs of the band between clearance and warning",
                         {{0}}},
    [ENGINE_CYCLES] = {"CYCLES",
                       ENGINE_READ,
                       "clock cycles of the run; stays at its largest value",
                       {{0}}},
    [ENGINE_FIRST_A] = {"FIRST_A", ENGINE_READ, "first collision: number of A's triangle", {{0}}},
    [ENGINE_FIRST_B] = {"FIRST_B", ENGINE_READ, "first collision: number of B's triangle", {{0}}},
};

static int fields(const engine_register *r) {
  int count = 0;
  while (count < 10 && r->field[count].name != NULL) {
    count++;
  }
  return count;
}

void engine_header(FILE *out) {
  fprintf(out,
          "/* Registers of sepax_engine, 32 bits each. Generated by sepax %s; do not edit. */\n"
          "#ifndef SEPAX_REGISTERS_H\n#define SEPAX_REGISTERS_H\n\n#define SEPAX_IDENTITY 0x%xu\n",
          SEPAX_VERSION, (unsigned)ENGINE_IDENTITY);
  for (int i = 0; i < ENGINE_REGISTERS; i++) {
    const engine_register *r = &engine_registers[i];
    fprintf(out, "\n#define SEPAX_%s 0x%02xu%s%s%s\n", r->name, 4u * (unsigned)i,
            r->about[0] != '\0' ? " /* " : "", r->about, r->about[0] != '\0' ? " */" : "");
    for (int k = 0; k < fields(r); k++) {
      unsigned mask = ((1u << r->field[k].bits) - 1) << r->field[k].low;
      if (r->field[k].bits == 1) {
        fprintf(out, "#define SEPAX_%s_%s 0x%xu\n", r->name, r->field[k].name, mask);
      } else {
        fprintf(out, "#define SEPAX_%s_%s(value) (((value) & 0x%xu) >> %d)\n", r->name,
                r->field[k].name, mask, r->field[k].low);
      }
    }
  }
  fprintf(out, "\n#endif\n");
}

void engine_page(FILE *out) {
  static const char *const access[] = {"read", "write", "read, write", "read, write 1 to clear"};
  fprintf(
      out,
      "# Registers of sepax_engine\n\nGenerated by sepax %s. 32 bits each; other addresses, writes to what is "
      "read only and\npartial strobes are answered with SLVERR. Counts are those of the last run, undefined before the\n"
      "first; FIRST_A and FIRST_B those of the last run with a collision. AWPROT and ARPROT are not there:\n"
      "all accesses are alike.\n\n"
      "| address | name | access | bits | |\n| --- | --- | --- | --- | --- |\n",
      SEPAX_VERSION);
  for (int i = 0; i < ENGINE_REGISTERS; i++) {
    const engine_register *r = &engine_registers[i];
    fprintf(out, "| 0x%02x | `%s` | %s | | %s |\n", 4 * i, r->name, access[r->access], r->about);
    for (int k = 0; k < fields(r); k++) {
      int low = r->field[k].low;
      fprintf(out,
              r->field[k].bits > 1 ? "| | `%s` | | %d:%d | %s |\n" : "| | `%s` | | %d%.0d | %s |\n",
              r->field[k].name, low + r->field[k].bits - 1, r->field[k].bits > 1 ? low : 0,
              r->field[k].about);
    }
  }
}

static void ports(emitter *e, emit_module *m, const engine_plan *p) {
  (void)e;
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "rst", "", "synchronous reset, active high");
  emit_signal(m, EMIT_INPUT, false, "awvalid", "", "AXI4-Lite: an address to write");
  emit_signal(m, EMIT_OUTPUT, false, "awready", "", "it is taken in this cycle");
  emit_signal(m, EMIT_INPUT, false, "awaddr", "7", "address, a multiple of 4");
  emit_signal(m, EMIT_INPUT, false, "wvalid", "", "data to write");
  emit_signal(m, EMIT_OUTPUT, false, "wready", "", "they are taken in this cycle");
  emit_signal(m, EMIT_INPUT, false, "wdata", "32", "data");
  emit_signal(m, EMIT_INPUT, false, "wstrb", "4", "byte strobes; all 1, else SLVERR");
  emit_signal(m, EMIT_OUTPUT_REG, false, "bvalid", "", "the write is done");
  emit_signal(m, EMIT_INPUT, false, "bready", "", "its response is taken");
  emit_signal(m, EMIT_OUTPUT_REG, false, "bresp", "2", "0: OKAY, 2: SLVERR, nothing was changed");
  emit_signal(m, EMIT_INPUT, false, "arvalid", "", "an address to read");
  emit_signal(m, EMIT_OUTPUT, false, "arready", "", "it is taken in this cycle");
  emit_signal(m, EMIT_INPUT, false, "araddr", "7", "address, a multiple of 4");
  emit_signal(m, EMIT_OUTPUT_REG, false, "rvalid", "", "data are here");
  emit_signal(m, EMIT_INPUT, false, "rready", "", "they are taken in this cycle");
  emit_signal(m, EMIT_OUTPUT_REG, false, "rdata", "32", "data");
  emit_signal(m, EMIT_OUTPUT_REG, false, "rresp", "2", "0: OKAY, 2: SLVERR");
  emit_signal(m, EMIT_OUTPUT, false, "irq", "", "interrupt, level");
  emit_signal(m, EMIT_OUTPUT_REG, false, "start", "", "a run begins");
  emit_signal(m, EMIT_OUTPUT, false, "starting", "",
              "a run begins, or a write that asks for it is here");
  emit_signal(m, EMIT_OUTPUT_REG, false, "stop", "", "the run is to end");
  emit_signal(m, EMIT_OUTPUT_REG, false, "first", "", "mode: end at the first collision");
  emit_signal(m, EMIT_OUTPUT_REG, false, "quiet", "", "mode: no result stream");
  for (int axis = 'x'; axis <= 'z'; axis++) {
    emit_signal(m, EMIT_OUTPUT_REG, true, gen_format("move_%c", axis).text,
                gen_format("%d", p->word + 1).text, "added to each %c of B", axis);
  }
  emit_signal(m, EMIT_INPUT, false, "status", "32", "what STATUS shows");
  emit_signal(m, EMIT_INPUT, false, "done", "", "a run ends in this cycle");
  emit_signal(m, EMIT_INPUT, false, "hit", "", "it finds its first collision in this cycle");
  emit_signal(m, EMIT_INPUT, false, "loaded", "", "the last vertex of an object has come");
  static const char *const counts[] = {"count_a",    "count_b",      "pairs",    "candidates",
                                       "collisions", "out_of_range", "warnings", "cycles",
                                       "first_a",    "first_b"};
  for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
    emit_signal(m, EMIT_INPUT, false, counts[i], "32", "the register of that name");
  }
}

/* The register numbered i as it is read; "" if it is not. */
static gen_line shown(const engine_plan *p, int i) {
  int version[3] = {0, 0, 0};
  switch (i) {
  case ENGINE_ID:
    return gen_format("32'd%u", (unsigned)ENGINE_IDENTITY);
  case ENGINE_GENERATOR:
    (void)sscanf(SEPAX_VERSION, "%d.%d.%d", &version[0], &version[1],
                 &version[2]); // NOLINT(cert-err34-c)
    return gen_format("32'd%d", (version[0] << 16) + (version[1] << 8) + version[2]);
  case ENGINE_DESIGN:
    return gen_format("32'd%d",
                      p->word + (p->lanes << 8) + (p->cores << 16) + (p->design->config.ii << 24));
  case ENGINE_MEMORY:
    return gen_format("32'd%d", p->index_a + (p->index_b << 8));
  case ENGINE_MODE:
    return gen_format("%s", "{30'd0, quiet, first}");
  case ENGINE_STATUS:
    return gen_format("%s", "status");
  case ENGINE_ENABLE:
    return gen_format("%s", "{29'd0, enable}");
  case ENGINE_PENDING:
    return gen_format("%s", "{29'd0, pending}");
  case ENGINE_COMMAND:
    return gen_format("%s", "");
  case ENGINE_MOVE_X:
  case ENGINE_MOVE_Y:
  case ENGINE_MOVE_Z: {
    char axis = (char)('x' + i - ENGINE_MOVE_X);
    return p->word + 1 >= 32
               ? gen_format("move_%c[31:0]", axis)
               : gen_format("{{%d{move_%c[%d]}}, move_%c}", 31 - p->word, axis, p->word, axis);
  }
  default: {
    static const char *const counts[] = {
        "count_a",    "count_b",      "",         "",       "",        "pairs",  "candidates",
        "collisions", "out_of_range", "warnings", "cycles", "first_a", "first_b"};
    return gen_format("%s", counts[i - ENGINE_COUNT_A]);
  }
  }
}

static void declare(emit_module *m) {
  emit_net(m, EMIT_REG, false, "address_full", "");
  emit_net(m, EMIT_REG, false, "address", "7");
  emit_net(m, EMIT_REG, false, "data_full", "");
  emit_net(m, EMIT_REG, false, "data", "32");
  emit_net(m, EMIT_REG, false, "whole", "");
  emit_net(m, EMIT_REG, false, "read_full", "");
  emit_net(m, EMIT_REG, false, "read_address", "7");
  emit_net(m, EMIT_REG, false, "enable", "3");
  emit_net(m, EMIT_REG, false, "pending", "3");
  static const char *const wires[] = {"write",     "read",     "fits", "busy",
                                      "can_start", "accepted", "known"};
  for (size_t i = 0; i < sizeof wires / sizeof wires[0]; i++) {
    emit_net(m, EMIT_WIRE, false, wires[i], "");
  }
  emit_net(m, EMIT_WIRE, false, "shown", "32");
  for (int i = 0; i < ENGINE_REGISTERS; i++) {
    if (engine_registers[i].access != ENGINE_READ) {
      emit_net(m, EMIT_WIRE, false, gen_format("to_%d", i).text, "");
    }
    if (engine_registers[i].access != ENGINE_WRITE) {
      emit_net(m, EMIT_WIRE, false, gen_format("from_%d", i).text, "");
    }
  }
}

static void decode(emit_module *m, const engine_plan *p) {
  emit_text(
      m,
      "\nassign awready = !address_full;\nassign wready = !data_full;\nassign arready = !read_full;\n"
      "assign write = address_full && data_full && (!bvalid || bready);\n"
      "assign read = read_full && (!rvalid || rready);\n"
      "assign starting = start || (address_full && data_full && to_%d && data[0]);\n"
      "assign irq = |(pending & enable);\nassign busy = status[0];\n"
      "assign can_start = !busy && !start && status[4] && status[5] && !status[6];",
      ENGINE_COMMAND);
  char any[512] = "";
  for (int i = 0; i < ENGINE_REGISTERS; i++) {
    size_t used = strlen(any);
    if (engine_registers[i].access != ENGINE_READ) {
      emit_text(m, "assign to_%d = address == 7'd%d; // %s", i, 4 * i, engine_registers[i].name);
    }
    if (engine_registers[i].access != ENGINE_WRITE) {
      emit_text(m, "assign from_%d = read_address == 7'd%d; // %s", i, 4 * i,
                engine_registers[i].name);
      snprintf(any + used, sizeof any - used, "%s%sfrom_%d", used > 0 ? " || " : "",
               i % 8 == 0 && used > 0 ? "\n               " : "", i);
    }
  }
  emit_text(m, "assign known = %s;", any);
  /* A move of W + 1 bits is all of 32 at W = 31 and 32 - 1 of them beyond. */
  if (p->word + 1 >= 32) {
    emit_text(m, "assign fits = 1'b1;");
  } else {
    emit_text(m, "assign fits = (data[31:%d] == %d'd0) || (&data[31:%d]);", p->word, 32 - p->word,
              p->word);
  }
  emit_text(
      m,
      "assign accepted = whole && (to_%d ? (data == 32'd1) && can_start || (data == 32'd2) :\n"
      "                  to_%d ? !busy && !start && (data[31:2] == 30'd0) :\n"
      "                  (to_%d || to_%d) ? data[31:3] == 29'd0 :\n"
      "                  (to_%d || to_%d || to_%d) && !busy && !start && fits);",
      ENGINE_COMMAND, ENGINE_MODE, ENGINE_ENABLE, ENGINE_PENDING, ENGINE_MOVE_X, ENGINE_MOVE_Y,
      ENGINE_MOVE_Z);
  const char *lead = "assign shown =";
  for (int i = 0; i < ENGINE_REGISTERS; i++) {
    if (engine_registers[i].access != ENGINE_WRITE) {
      emit_text(m, "%s ({32{from_%d}} & %s)%s", lead, i, shown(p, i).text,
                i < ENGINE_REGISTERS - 1 ? " |" : ";");
      lead = "              ";
    }
  }
}

static void clocked(emit_module *m, const engine_plan *p) {
  emit_text(m,
            "\nalways @(posedge clk) begin\n  if (rst) begin\n"
            "    address_full <= 1'b0;\n    data_full <= 1'b0;\n    read_full <= 1'b0;\n"
            "    bvalid <= 1'b0;\n    rvalid <= 1'b0;\n    start <= 1'b0;\n    stop <= 1'b0;\n"
            "    first <= 1'b0;\n    quiet <= 1'b0;\n    enable <= 3'd0;\n    pending <= 3'd0;\n"
            "    move_x <= %d'd0;\n    move_y <= %d'd0;\n    move_z <= %d'd0;\n"
            "  end else begin\n"
            "    if (awvalid && awready) begin\n      address_full <= 1'b1;\n"
            "    end else if (write) begin\n      address_full <= 1'b0;\n    end\n"
            "    if (wvalid && wready) begin\n      data_full <= 1'b1;\n"
            "    end else if (write) begin\n      data_full <= 1'b0;\n    end\n"
            "    if (write) begin\n      bvalid <= 1'b1;\n"
            "    end else if (bready) begin\n      bvalid <= 1'b0;\n    end\n"
            "    if (arvalid && arready) begin\n      read_full <= 1'b1;\n"
            "    end else if (read) begin\n      read_full <= 1'b0;\n    end\n"
            "    if (read) begin\n      rvalid <= 1'b1;\n"
            "    end else if (rready) begin\n      rvalid <= 1'b0;\n    end",
            p->word + 1, p->word + 1, p->word + 1);
  emit_text(
      m,
      "    start <= write && accepted && to_%d && data[0];\n"
      "    stop <= write && accepted && to_%d && data[1];\n"
      "    if (write && accepted && to_%d) begin\n      first <= data[0];\n      quiet <= data[1];\n    end\n"
      "    if (write && accepted && to_%d) begin\n      enable <= data[2:0];\n    end\n"
      "    pending <= (pending & ~(data[2:0] & {3{write && accepted && to_%d}})) | {loaded, hit, done};",
      ENGINE_COMMAND, ENGINE_COMMAND, ENGINE_MODE, ENGINE_ENABLE, ENGINE_PENDING);
  for (int k = 0; k < 3; k++) {
    emit_text(m, "    if (write && accepted && to_%d) begin\n      move_%c <= %s;\n    end",
              ENGINE_MOVE_X + k, 'x' + k,
              p->word + 1 > 32 ? "{data[31], data}" : gen_format("data[%d:0]", p->word).text);
  }
  emit_text(m, "  end\n"
               "  if (awvalid && awready) begin\n    address <= awaddr;\n  end\n"
               "  if (wvalid && wready) begin\n    data <= wdata;\n    whole <= &wstrb;\n  end\n"
               "  if (write) begin\n    bresp <= {!accepted, 1'b0};\n  end\n"
               "  if (arvalid && arready) begin\n    read_address <= araddr;\n  end\n"
               "  if (read) begin\n    rdata <= shown;\n    rresp <= {!known, 1'b0};\n  end\nend");
}

void gen_engine_registers(emitter *e, const engine_plan *p) {
  emit_module *m = emit_begin(
      e, "sepax_registers",
      "The registers of the engine behind AXI4-Lite (sepax_registers.md lists them). All\n"
      "outputs are registers; a write may come with its data before its address.");
  ports(e, m, p);
  declare(m);
  decode(m, p);
  clocked(m, p);
  emit_end(m);
}
