/* gen_engine.c - sepax_engine: memories, box lanes, the cores behind them, and both buses. */
#include "engine.h"
#include "sepax_design.h"

#include <stdarg.h>
#include <string.h>

gen_line gen_format(const char *format, ...) {
  gen_line line;
  va_list args;
  va_start(args, format);
  vsnprintf(line.text, sizeof line.text, format, args);
  va_end(args);
  return line;
}

static void gen_ram(emitter *e) {
  emit_module *m =
      emit_begin(e, "sepax_ram",
                 "A memory with one port to write and one to read, which keeps what it read last.\n"
                 "Its contents are not reset. Latency 1.");
  emit_parameter(m, EMIT_PARAMETER, "WIDTH", 8, "bits of a word");
  emit_parameter(m, EMIT_PARAMETER, "ADDRESS", 7, "bits of an address");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "write", "", "write a word");
  emit_signal(m, EMIT_INPUT, false, "write_address", "ADDRESS", "where");
  emit_signal(m, EMIT_INPUT, false, "write_data", "WIDTH", "the word");
  emit_signal(m, EMIT_INPUT, false, "read", "", "read a word");
  emit_signal(m, EMIT_INPUT, false, "read_address", "ADDRESS", "where");
  emit_signal(m, EMIT_OUTPUT_REG, false, "read_data", "WIDTH", "the word, from the next cycle on");
  emit_memory(m, "words", "WIDTH", "ADDRESS", "the memory");
  emit_text(m, "\nalways @(posedge clk) begin\n"
               "  if (write) begin\n    words[write_address] <= write_data;\n  end\n"
               "  if (read) begin\n    read_data <= words[read_address];\n  end\nend");
  emit_end(m);
}

void gen_engine_queue(emitter *e, const char *name, const char *banner, int width, int log2,
                      int margin) {
  emit_module *m = emit_begin(e, name, banner);
  const gen_line place = gen_format("%d", log2);
  const gen_line word = gen_format("%d", width);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "clear", "", "drop all words");
  emit_signal(m, EMIT_INPUT, false, "push", "", "append a word; only with a place free");
  emit_signal(m, EMIT_INPUT, false, "in", word.text, "the word");
  emit_signal(m, EMIT_OUTPUT_REG, false, "room", "", "%d or more of %d places are free", margin,
              1 << log2);
  emit_signal(m, EMIT_OUTPUT, false, "more", "", "there is a word");
  emit_signal(m, EMIT_INPUT, false, "pop", "", "take it");
  emit_signal(m, EMIT_OUTPUT, false, "out", word.text, "the oldest word");
  emit_memory(m, "words", word.text, place.text, "ring");
  emit_net(m, EMIT_REG, false, "head", place.text);
  emit_net(m, EMIT_REG, false, "tail", place.text);
  emit_net(m, EMIT_REG, false, "count", gen_format("%d", log2 + 1).text);
  emit_net(m, EMIT_WIRE, false, "next_count", gen_format("%d", log2 + 1).text);
  emit_text(
      m,
      "\nassign more = count != %d'd0;\nassign out = words[head];\n"
      "assign next_count = count + {%d'd0, push} - {%d'd0, pop};\n"
      "\nalways @(posedge clk) begin\n  if (clear) begin\n"
      "    head <= %d'd0;\n    tail <= %d'd0;\n    count <= %d'd0;\n    room <= 1'b1;\n  end else begin\n"
      "    count <= next_count;\n    room <= next_count <= %d'd%d;\n"
      "    if (push) begin\n      tail <= tail + %d'd1;\n    end\n"
      "    if (pop) begin\n      head <= head + %d'd1;\n    end\n  end\n"
      "  if (push) begin\n    words[tail] <= in;\n  end\nend",
      log2 + 1, log2, log2, log2, log2, log2 + 1, log2 + 1, (1 << log2) - margin, log2, log2);
  emit_end(m);
}

static void gen_fetch(emitter *e, const engine_plan *p) {
  int w = p->word;
  int v = p->moved;
  emit_module *m = emit_begin(
      e, "sepax_fetch",
      "The triangles of a pair from the memories, B's moved, and valid/ready to the cores.\n"
      "A pair of which B does not fit the word any more is marked; its verdict does not\n"
      "count.");
  const gen_line a = gen_format("%d", p->index_a);
  const gen_line b = gen_format("%d", p->index_b);
  const gen_line triangle = gen_format("%d", 9 * w);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "clear", "", "drop what is under way");
  emit_signal(m, EMIT_INPUT, false, "valid", "", "a pair is here");
  emit_signal(m, EMIT_INPUT, false, "a", a.text, "number of A's triangle");
  emit_signal(m, EMIT_INPUT, false, "b", b.text, "number of B's triangle");
  emit_signal(m, EMIT_OUTPUT, false, "read", "", "it is taken: read both memories");
  emit_signal(m, EMIT_INPUT, false, "read_a", triangle.text, "from A's, in the next cycle");
  emit_signal(m, EMIT_INPUT, false, "read_b", triangle.text, "from B's");
  for (int axis = 'x'; axis <= 'z'; axis++) {
    emit_signal(m, EMIT_INPUT, true, gen_format("move_%c", axis).text, gen_format("%d", w + 1).text,
                "added to %c of B", axis);
  }
  emit_signal(m, EMIT_OUTPUT, false, "busy", "", "a pair is under way");
  emit_signal(m, EMIT_OUTPUT_REG, false, "out_valid", "", "a pair for a core");
  emit_signal(m, EMIT_INPUT, false, "out_ready", "", "it is taken");
  emit_signal(m, EMIT_OUTPUT_REG, false, "out_a", triangle.text, "A");
  emit_signal(m, EMIT_OUTPUT_REG, false, "out_b", triangle.text, "B");
  emit_signal(m, EMIT_OUTPUT_REG, false, "out_outside", "", "B does not fit");
  emit_signal(m, EMIT_OUTPUT_REG, false, "number_a", a.text, "number of A's triangle");
  emit_signal(m, EMIT_OUTPUT_REG, false, "number_b", b.text, "number of B's triangle");
  emit_net(m, EMIT_REG, false, "valid_1", "");
  emit_net(m, EMIT_REG, false, "a_1", a.text);
  emit_net(m, EMIT_REG, false, "b_1", b.text);
  emit_net(m, EMIT_WIRE, false, "enable_1", "");
  emit_net(m, EMIT_WIRE, false, "enable_2", "");
  emit_net(m, EMIT_WIRE, false, "outside", "9");
  for (int k = 0; k < 9; k++) {
    emit_net(m, EMIT_WIRE, false, gen_format("moved_%d", k).text, gen_format("%d", v).text);
  }
  /* in_ready of a core comes late in its cycle; every other cycle is enough but for II = 1. */
  emit_text(m, p->design->config.ii == 1 || p->cores > 1
                   ? "\nassign enable_2 = !out_valid || out_ready;"
                   : "\nassign enable_2 = !out_valid;");
  emit_text(m, "assign enable_1 = !valid_1 || enable_2;\nassign read = valid && enable_1;\n"
               "assign busy = valid_1 || out_valid;");
  for (int k = 0; k < 9; k++) {
    int axis = 'x' + k % 3;
    emit_text(m, "assign moved_%d = {{2{read_b[%d]}}, read_b[%d:%d]} + {move_%c[%d], move_%c};", k,
              (k + 1) * w - 1, (k + 1) * w - 1, k * w, axis, w, axis);
    emit_text(
        m, "assign outside[%d] = (moved_%d[%d] != moved_%d[%d]) || (moved_%d[%d] != moved_%d[%d]);",
        k, k, v - 1, k, w - 1, k, v - 2, k, w - 1);
  }
  char moved[512] = "";
  for (int k = 8; k >= 0; k--) {
    size_t used = strlen(moved);
    snprintf(moved + used, sizeof moved - used, "moved_%d[%d:0]%s", k, w - 1, k > 0 ? ", " : "");
  }
  emit_text(
      m,
      "\nalways @(posedge clk) begin\n"
      "  if (clear) begin\n    valid_1 <= 1'b0;\n    out_valid <= 1'b0;\n"
      "  end else begin\n"
      "    if (enable_1) begin\n      valid_1 <= valid;\n    end\n"
      "    if (enable_2) begin\n      out_valid <= valid_1;\n"
      "    end else if (out_ready) begin\n      out_valid <= 1'b0;\n    end\n  end\n"
      "  if (read) begin\n    a_1 <= a;\n    b_1 <= b;\n  end\n"
      "  if (enable_2) begin\n    number_a <= a_1;\n    number_b <= b_1;\n    out_a <= read_a;\n"
      "    out_outside <= |outside;\n    out_b <= {%s};\n  end\nend",
      moved);
  emit_end(m);
}

/* The cores: a pair goes to one that is ready; verdicts leave in the order of the pairs. */
static void gen_cores(emit_module *m, const engine_plan *p) {
  bool near = p->design->config.extent_a > 0;
  bool bands = p->design->limits > 0;
  int w = p->word;
  const gen_line cores = gen_format("%d", p->cores);
  static const char *const from[] = {"core_ready", "verdict", "collides", "in_plane"};
  for (size_t i = 0; i < sizeof from / sizeof from[0]; i++) {
    emit_net(m, EMIT_WIRE, false, from[i], cores.text);
  }
  emit_signal(m, EMIT_WIRE, false, "due", cores.text, "one-hot: the core that has the oldest pair");
  emit_net(m, EMIT_WIRE, false, "offered", cores.text);
  emit_net(m, EMIT_WIRE, false, "wanted", cores.text);
  if (bands) {
    emit_net(m, EMIT_WIRE, false, "warns", cores.text);
  }
  if (near) {
    emit_net(m, EMIT_WIRE, false, "too_long", cores.text);
  }
  if (p->cores == 1) {
    emit_text(m, "\nassign chosen = 1'd1;");
  } else {
    emit_text(m, "\nassign chosen = core_ready & (~core_ready + %d'd1); // the first that is ready",
              p->cores);
  }
  emit_text(m,
            "assign pair_ready = |core_ready && flight_room;\n"
            "assign offered = chosen & {%d{pair_valid && flight_room}};\n"
            "assign due = landed[%d:%d] & {%d{flight_more}};\n"
            "assign verdict_valid = |(verdict & due);\nassign wanted = due & {%d{verdict_ready}};\n"
            "assign collision = |(collides & due);\nassign coplanar = |(in_plane & due);",
            p->cores, p->index_a + p->index_b + p->cores, p->index_a + p->index_b + 1, p->cores,
            p->cores);
  if (near) {
    emit_text(m, "assign beyond = |(too_long & due);");
  }
  if (bands) {
    emit_text(m, "assign warning = |(warns & due);");
  }
  for (int c = 0; c < p->cores; c++) {
    char connections[2048];
    size_t used = (size_t)snprintf(
        connections, sizeof connections,
        "clk=clk, rst=rst, in_valid=offered[%d], in_ready=core_ready[%d], out_valid=verdict[%d], "
        "out_ready=wanted[%d], out_coplanar=in_plane[%d], "
        "out_axis=unused_axis_%d",
        c, c, c, c, c, c);
    if (bands) {
      emit_net(m, EMIT_WIRE, false, gen_format("band_%d", c).text, "2");
      emit_net(m, EMIT_WIRE, false, gen_format("unused_collision_%d", c).text, "");
      emit_text(m, "assign collides[%d] = band_%d[1];\nassign warns[%d] = band_%d[0];", c, c, c, c);
      used += (size_t)snprintf(connections + used, sizeof connections - used,
                               ", out_band=band_%d, out_collision=unused_collision_%d", c, c);
    } else {
      used += (size_t)snprintf(connections + used, sizeof connections - used,
                               ", out_collision=collides[%d]", c);
    }
    if (near) {
      used += (size_t)snprintf(connections + used, sizeof connections - used,
                               ", out_of_range=too_long[%d]", c);
    }
    for (int k = 0; k < 18; k++) {
      int word = k % 9;
      used += (size_t)snprintf(connections + used, sizeof connections - used,
                               ", in_%c%d_%c=pair_%c[%d:%d]", "ab"[k / 9], word / 3 + 1,
                               'x' + word % 3, "ab"[k / 9], (word + 1) * w - 1, word * w);
    }
    emit_net(m, EMIT_WIRE, false, gen_format("unused_axis_%d", c).text, "4");
    emit_instance(m, "sepax_top", gen_format("core_%d", c).text, "", "%s", connections);
  }
}

/* Both buses under the names of their standard. */
static const struct {
  emit_kind kind;
  const char *name, *width, *about;
} port[] = {
    {EMIT_INPUT, "clk", "", "clock of everything"},
    {EMIT_INPUT, "rst", "", "synchronous reset of the control, active high"},
    {EMIT_INPUT, "s_axi_awvalid", "", "AXI4-Lite, registers: address to write"},
    {EMIT_OUTPUT, "s_axi_awready", "", "taken in this cycle"},
    {EMIT_INPUT, "s_axi_awaddr", "7", "sepax_registers.md"},
    {EMIT_INPUT, "s_axi_wvalid", "", "data to write"},
    {EMIT_OUTPUT, "s_axi_wready", "", "taken in this cycle"},
    {EMIT_INPUT, "s_axi_wdata", "32", "data"},
    {EMIT_INPUT, "s_axi_wstrb", "4", "byte strobes, all 1"},
    {EMIT_OUTPUT, "s_axi_bvalid", "", "response to a write"},
    {EMIT_INPUT, "s_axi_bready", "", "taken in this cycle"},
    {EMIT_OUTPUT, "s_axi_bresp", "2", "0: OKAY, 2: SLVERR"},
    {EMIT_INPUT, "s_axi_arvalid", "", "address to read"},
    {EMIT_OUTPUT, "s_axi_arready", "", "taken in this cycle"},
    {EMIT_INPUT, "s_axi_araddr", "7", "sepax_registers.md"},
    {EMIT_OUTPUT, "s_axi_rvalid", "", "data that were read"},
    {EMIT_INPUT, "s_axi_rready", "", "taken in this cycle"},
    {EMIT_OUTPUT, "s_axi_rdata", "32", "data"},
    {EMIT_OUTPUT, "s_axi_rresp", "2", "0: OKAY, 2: SLVERR"},
    {EMIT_INPUT, "s_axis_tvalid", "", "AXI4-Stream, triangles: a vertex"},
    {EMIT_OUTPUT, "s_axis_tready", "", "taken in this cycle"},
    {EMIT_INPUT, "s_axis_tdata", "96", "{z, y, x}, signed, 32 bits each"},
    {EMIT_INPUT, "s_axis_tlast", "", "last vertex of the object"},
    {EMIT_INPUT, "s_axis_tdest", "", "0: object A, 1: object B"},
    {EMIT_OUTPUT, "m_axis_tvalid", "", "AXI4-Stream, results: a colliding pair, or the end"},
    {EMIT_INPUT, "m_axis_tready", "", "taken in this cycle"},
    {EMIT_OUTPUT, "m_axis_tdata", "64", "sepax_results.v"},
    {EMIT_OUTPUT, "m_axis_tlast", "", "end of the run"},
    {EMIT_OUTPUT, "irq", "", "interrupt, level: PENDING and ENABLE"},
};
enum { PORTS = sizeof port / sizeof port[0] };

/* What goes between the logic and its memories: `from_memories` is the direction of what was
 * read, EMIT_INPUT in the logic and EMIT_WIRE around it. */
typedef struct {
  emit_kind kind; /* as the logic sees it */
  gen_line name;
  int width;
  const char *about;
} memory_port;
enum { MEMORY_PORTS = 17 };

static int memory_ports(const engine_plan *p, memory_port list[MEMORY_PORTS]) {
  int w = p->word;
  int index = p->index_a > p->index_b ? p->index_a : p->index_b;
  int n = 0;
  list[n++] = (memory_port){EMIT_OUTPUT, gen_format("write_address"), index,
                            "number of a triangle to write"};
  list[n++] = (memory_port){EMIT_OUTPUT, gen_format("write_triangle"), 9 * w, "its coordinates"};
  list[n++] = (memory_port){EMIT_OUTPUT, gen_format("write_box"), 6 * w, "its box"};
  list[n++] = (memory_port){EMIT_OUTPUT, gen_format("step"), 0, "read both memories of boxes"};
  list[n++] = (memory_port){EMIT_OUTPUT, gen_format("fetch"), 0, "read both memories of triangles"};
  for (int t = 0; t < 2; t++) {
    int bits = t == 0 ? p->index_a : p->index_b;
    int x = 'a' + t;
    list[n++] = (memory_port){EMIT_OUTPUT, gen_format("write_%c", x), 0,
                              "write to both memories of the object"};
    list[n++] = (memory_port){EMIT_OUTPUT, gen_format("address_%c", x), bits, "of the box to read"};
    list[n++] = (memory_port){EMIT_INPUT, gen_format("read_box_%c", x), 6 * w,
                              "the box, in the next cycle"};
    list[n++] =
        (memory_port){EMIT_OUTPUT, gen_format("pick_%c", x), bits, "of the triangle to read"};
    list[n++] = (memory_port){EMIT_INPUT, gen_format("read_triangle_%c", x), 9 * w,
                              "the triangle, in the next cycle"};
  }
  return n;
}

static void declare_ports(emit_module *m) {
  for (int i = 0; i < PORTS; i++) {
    emit_signal(m, port[i].kind, false, port[i].name, port[i].width, "%s", port[i].about);
  }
}

/* "" for one bit. */
static gen_line width_text(int width) {
  return width == 0 ? gen_format("%s", "") : gen_format("%d", width);
}

static void declare_wires(emit_module *m, const engine_plan *p) {
  static const char *const bits[] = {
      "start",      "starting",      "hold",          "stop",          "first",
      "quiet",      "halt",          "clear",         "done",          "hit",
      "busy",       "stopped",       "any",           "drained",       "loading",
      "ended",      "bad_word",      "bad_frame",     "bad_size",      "running",
      "is_a",       "is_b",          "load",          "lanes_busy",    "push",
      "room",       "more",          "pop",           "pick_valid",    "fetch_busy",
      "pair_valid", "pair_ready",    "outside",       "flight_room",   "flight_more",
      "launch",     "land",          "verdict_valid", "verdict_ready", "collision",
      "coplanar",   "flight_outside"};
  for (size_t i = 0; i < sizeof bits / sizeof bits[0]; i++) {
    emit_net(m, EMIT_WIRE, false, bits[i], "");
  }
  if (p->design->config.extent_a > 0) {
    emit_net(m, EMIT_WIRE, false, "beyond", "");
  }
  if (p->design->limits > 0) {
    emit_net(m, EMIT_WIRE, false, "warning", "");
  }
  int w = p->word;
  int candidates = p->lanes + p->index_b + p->index_a;
  const struct {
    const char *name;
    int width;
  } words[] = {{"count_a", p->index_a + 1},
               {"count_b", p->index_b + 1},
               {"step_j", p->index_b + 1},
               {"round_base", p->index_a},
               {"mask", p->lanes},
               {"mask_j", p->index_b},
               {"mask_base", p->index_a},
               {"tested", 7},
               {"candidate", candidates},
               {"oldest", candidates},
               {"pair_a", 9 * w},
               {"pair_b", 9 * w},
               {"number_a", p->index_a},
               {"number_b", p->index_b},
               {"launched", p->index_a + p->index_b + 1 + p->cores},
               {"landed", p->index_a + p->index_b + 1 + p->cores},
               {"landed_a", p->index_a},
               {"landed_b", p->index_b},
               {"status", 32},
               {"shown_a", 32},
               {"shown_b", 32},
               {"pairs", 32},
               {"candidates", 32},
               {"collisions", 32},
               {"out_of_range", 32},
               {"warnings", 32},
               {"cycles", 32},
               {"first_a", 32},
               {"first_b", 32},
               {"chosen", p->cores}};
  for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
    emit_net(m, EMIT_WIRE, false, words[i].name, gen_format("%d", words[i].width).text);
  }
  for (int axis = 'x'; axis <= 'z'; axis++) {
    emit_net(m, EMIT_WIRE, true, gen_format("move_%c", axis).text, gen_format("%d", w + 1).text);
  }
}

static void glue(emit_module *m, const engine_plan *p) {
  emit_text(
      m,
      "\nassign clear = rst || start || halt;\nassign hold = busy || starting;\n"
      "assign drained = !running && !lanes_busy && !more && !pick_valid && !fetch_busy && !flight_more;\n"
      "assign candidate = {mask, mask_j, mask_base};\n"
      "assign launch = pair_valid && pair_ready;\nassign launched = {chosen, outside, number_b, number_a};\n"
      "assign land = verdict_valid && verdict_ready;\n"
      "assign landed_a = landed[%d:0];\nassign landed_b = landed[%d:%d];\nassign flight_outside = landed[%d];\n"
      "assign shown_a = {%d'd0, count_a};\nassign shown_b = {%d'd0, count_b};\n"
      "assign status = {21'd0, bad_size, bad_frame, bad_word, 1'b0, loading, |count_b, |count_a, stopped,\n"
      "                 any && |out_of_range, any, busy};",
      p->index_a - 1, p->index_a + p->index_b - 1, p->index_a, p->index_a + p->index_b,
      31 - p->index_a, 31 - p->index_b);
}

static void instances(emit_module *m, const engine_plan *p) {
  int candidates = p->lanes + p->index_b + p->index_a;
  emit_blank(m);
  emit_instance(
      m, "sepax_registers", "registers", "",
      "clk=clk, rst=rst, awvalid=s_axi_awvalid, awready=s_axi_awready, awaddr=s_axi_awaddr, "
      "wvalid=s_axi_wvalid, wready=s_axi_wready, wdata=s_axi_wdata, wstrb=s_axi_wstrb, bvalid=s_axi_bvalid, "
      "bready=s_axi_bready, bresp=s_axi_bresp, arvalid=s_axi_arvalid, arready=s_axi_arready, "
      "araddr=s_axi_araddr, rvalid=s_axi_rvalid, rready=s_axi_rready, rdata=s_axi_rdata, rresp=s_axi_rresp, "
      "irq=irq, start=start, starting=starting, stop=stop, first=first, quiet=quiet, move_x=move_x, move_y=move_y, "
      "move_z=move_z, status=status, done=done, hit=hit, loaded=ended, count_a=shown_a, count_b=shown_b, pairs=pairs, "
      "candidates=candidates, collisions=collisions, out_of_range=out_of_range, "
      "warnings=warnings, cycles=cycles, first_a=first_a, first_b=first_b");
  emit_instance(
      m, "sepax_load", "load_objects", "",
      "clk=clk, rst=rst, busy=hold, tvalid=s_axis_tvalid, tready=s_axis_tready, tdata=s_axis_tdata, "
      "tlast=s_axis_tlast, tdest=s_axis_tdest, write_a=write_a, write_b=write_b, address=write_address, "
      "triangle=write_triangle, box=write_box, count_a=count_a, count_b=count_b, loading=loading, "
      "ended=ended, bad_word=bad_word, bad_frame=bad_frame, bad_size=bad_size");
  emit_instance(
      m, "sepax_walk", "walk", "",
      "clk=clk, rst=rst, start=start, halt=halt, room=room, count_a=count_a, count_b=count_b, "
      "running=running, step=step, j=step_j, is_b=is_b, address_b=address_b, round_base=round_base, "
      "address_a=address_a, load=load, is_a=is_a");
  emit_instance(
      m, "sepax_lanes", "lanes", "",
      "clk=clk, clear=clear, step=step, j=step_j, is_b=is_b, base=round_base, load=load, is_a=is_a, "
      "box_a=read_box_a, box_b=read_box_b, move_x=move_x, move_y=move_y, move_z=move_z, busy=lanes_busy, push=push, "
      "mask=mask, mask_j=mask_j, mask_base=mask_base, tested=tested");
  emit_instance(
      m, "sepax_candidates", "candidate_queue", "",
      "clk=clk, clear=clear, push=push, in=candidate, room=room, more=more, pop=pop, out=oldest");
  emit_instance(
      m, "sepax_pick", "pick", "",
      "clk=clk, clear=clear, more=more, pop=pop, next_mask=oldest[%d:%d], next_j=oldest[%d:%d], "
      "next_base=oldest[%d:0], valid=pick_valid, take=fetch, a=pick_a, b=pick_b",
      candidates - 1, candidates - p->lanes, candidates - p->lanes - 1, p->index_a, p->index_a - 1);
  emit_instance(
      m, "sepax_fetch", "fetch_pair", "",
      "clk=clk, clear=clear, valid=pick_valid, a=pick_a, b=pick_b, read=fetch, read_a=read_triangle_a, "
      "read_b=read_triangle_b, move_x=move_x, move_y=move_y, move_z=move_z, busy=fetch_busy, "
      "out_valid=pair_valid, out_ready=pair_ready, out_a=pair_a, out_b=pair_b, out_outside=outside, "
      "number_a=number_a, number_b=number_b");
  emit_instance(
      m, "sepax_flight", "flight", "",
      "clk=clk, clear=rst, push=launch, in=launched, room=flight_room, more=flight_more, pop=land, out=landed");
  gen_cores(m, p);
  emit_instance(
      m, "sepax_results", "results", "",
      "clk=clk, rst=rst, start=start, stop=stop, first=first, quiet=quiet, tested=tested, survived=launch, "
      "drained=drained, valid=verdict_valid, ready=verdict_ready, collision=collision, coplanar=coplanar, "
      "%s%soutside=flight_outside, a=landed_a, b=landed_b, tvalid=m_axis_tvalid, tready=m_axis_tready, "
      "tdata=m_axis_tdata, tlast=m_axis_tlast, halt=halt, done=done, hit=hit, busy=busy, stopped=stopped, "
      "any=any, pairs=pairs, candidates=candidates, collisions=collisions, out_of_range=out_of_range, "
      "warnings=warnings, cycles=cycles, first_a=first_a, first_b=first_b",
      p->design->config.extent_a > 0 ? "beyond=beyond, " : "",
      p->design->limits > 0 ? "warning=warning, " : "");
}

static int log2_of(int number) {
  int bits = 0;
  while (1 << bits < number) {
    bits++;
  }
  return bits;
}

/* The logic, with the memories beside it. */
static void gen_around(emitter *e, const engine_plan *p, const char *banner) {
  emit_module *m = emit_begin(e, "sepax_engine", banner);
  memory_port between[MEMORY_PORTS];
  int count = memory_ports(p, between);
  declare_ports(m);
  for (int i = 0; i < count; i++) {
    emit_net(m, EMIT_WIRE, false, between[i].name.text, width_text(between[i].width).text);
  }
  char connections[4096];
  size_t used = 0;
  for (int i = 0; i < PORTS; i++) {
    used += (size_t)snprintf(connections + used, sizeof connections - used, "%s%s=%s",
                             i > 0 ? ", " : "", port[i].name, port[i].name);
  }
  for (int i = 0; i < count; i++) {
    used += (size_t)snprintf(connections + used, sizeof connections - used, ", %s=%s",
                             between[i].name.text, between[i].name.text);
  }
  emit_blank(m);
  emit_instance(m, "sepax_engine_logic", "logic_part", "", "%s", connections);
  for (int t = 0; t < 2; t++) {
    int x = 'a' + t;
    int bits = t == 0 ? p->index_a : p->index_b;
    emit_instance(
        m, "sepax_ram", gen_format("boxes_%c", x).text,
        gen_format("WIDTH=%d, ADDRESS=%d", 6 * p->word, bits).text,
        "clk=clk, write=write_%c, write_address=write_address[%d:0], write_data=write_box, read=step, "
        "read_address=address_%c, read_data=read_box_%c",
        x, bits - 1, x, x);
    emit_instance(
        m, "sepax_ram", gen_format("triangles_%c", x).text,
        gen_format("WIDTH=%d, ADDRESS=%d", 9 * p->word, bits).text,
        "clk=clk, write=write_%c, write_address=write_address[%d:0], write_data=write_triangle, read=fetch, "
        "read_address=pick_%c, read_data=read_triangle_%c",
        x, bits - 1, x, x);
  }
  emit_end(m);
}

void gen_engine(emitter *e, int places) {
  const sepax_config *c = &e->design->config;
  engine_plan plan = {.design = e->design,
                      .word = c->word,
                      .moved = c->word + 2,
                      .lanes = c->lanes,
                      .cores = c->cores,
                      .index_a = log2_of(c->memory_a),
                      .index_b = log2_of(c->memory_b)};
  plan.flight_log2 = log2_of(places * c->cores + 1);
  gen_ram(e);
  gen_bounds(e);
  gen_engine_load(e, &plan);
  gen_engine_lanes(e, &plan);
  gen_fetch(e, &plan);
  gen_engine_queue(e, "sepax_flight", "Numbers of the pairs that are in the cores.",
                   plan.index_a + plan.index_b + 1 + plan.cores, plan.flight_log2, 2);
  gen_engine_results(e, &plan);
  gen_engine_registers(e, &plan);
  emit_module *m = emit_begin(e, "sepax_engine_logic",
                              "sepax_engine but for its memories, which are beside it.");
  memory_port between[MEMORY_PORTS];
  int count = memory_ports(&plan, between);
  declare_ports(m);
  for (int i = 0; i < count; i++) {
    emit_signal(m, between[i].kind, false, between[i].name.text, width_text(between[i].width).text,
                "%s", between[i].about);
  }
  declare_wires(m, &plan);
  glue(m, &plan);
  instances(m, &plan);
  emit_end(m);
  gen_around(
      e, &plan,
      gen_format(
          "Which triangles of object A collide with which of object B: all pairs go through\n"
          "%d box lanes, those whose boxes meet to %d exact core%s behind a queue.\n"
          "%d triangles of A, %d of B at most. Objects come over AXI4-Stream, a vertex a\n"
          "transfer; AXI4-Lite starts a run and reads its counts; collisions leave over\n"
          "AXI4-Stream. A run takes about ceil(a / %d) max(b, %d) + %d cycles and the latency of\n"
          "the core, more where the cores do not keep up.",
          c->lanes, c->cores, c->cores > 1 ? "s" : "", c->memory_a, c->memory_b, c->lanes, c->lanes,
          c->lanes + 8)
          .text);
}
