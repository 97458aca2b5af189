/* gen_engine_bus.c - the two ends of the engine: sepax_load takes triangles from AXI4-Stream,
 * sepax_results counts the verdicts and sends the collisions. */
#include "engine.h"

#include <string.h>

void gen_engine_load(emitter *e, const engine_plan *p) {
  int w = p->word;
  int index = p->index_a > p->index_b ? p->index_a : p->index_b;
  emit_module *m = emit_begin(
      e, "sepax_load",
      "Triangles from AXI4-Stream into a memory: a vertex a transfer, three a triangle, an\n"
      "object up to TLAST. An object that is not whole is not there: its count stays 0.");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "rst", "", "synchronous reset, active high");
  emit_signal(m, EMIT_INPUT, false, "busy", "", "a run goes on or begins: nothing is taken");
  emit_signal(m, EMIT_INPUT, false, "tvalid", "", "a vertex is here");
  emit_signal(m, EMIT_OUTPUT, false, "tready", "", "it is taken in this cycle");
  emit_signal(m, EMIT_INPUT, false, "tdata", "96", "{z, y, x}, signed, 32 bits each");
  emit_signal(m, EMIT_INPUT, false, "tlast", "", "the last of the object");
  emit_signal(m, EMIT_INPUT, false, "tdest", "",
              "0: of object A, 1: of B; that of its first vertex counts");
  emit_signal(m, EMIT_OUTPUT_REG, false, "write_a", "", "write a triangle of A");
  emit_signal(m, EMIT_OUTPUT_REG, false, "write_b", "", "write a triangle of B");
  emit_signal(m, EMIT_OUTPUT_REG, false, "address", gen_format("%d", index).text, "its number");
  emit_signal(m, EMIT_OUTPUT_REG, false, "triangle", gen_format("%d", 9 * w).text,
              "signed, %d bits each, x of the first vertex lowest", w);
  emit_signal(m, EMIT_OUTPUT, false, "box", gen_format("%d", 6 * w).text,
              "its box, {high, low} of z, y, x");
  emit_signal(m, EMIT_OUTPUT_REG, false, "count_a", gen_format("%d", p->index_a + 1).text,
              "triangles of A");
  emit_signal(m, EMIT_OUTPUT_REG, false, "count_b", gen_format("%d", p->index_b + 1).text,
              "triangles of B");
  emit_signal(m, EMIT_OUTPUT_REG, false, "loading", "", "an object has begun to come");
  emit_signal(m, EMIT_OUTPUT_REG, false, "ended", "",
              "the last vertex of an object came in the cycle before");
  emit_signal(m, EMIT_OUTPUT_REG, false, "bad_word", "", "last object: a coordinate does not fit");
  emit_signal(m, EMIT_OUTPUT_REG, false, "bad_frame", "", "last object: ended within a triangle");
  emit_signal(m, EMIT_OUTPUT_REG, false, "bad_size", "", "last object: too many triangles");
  emit_signal(m, EMIT_REG, false, "is_b", "", "object B is coming");
  emit_signal(m, EMIT_REG, false, "phase", "3", "one-hot: the vertex of the triangle");
  emit_signal(m, EMIT_REG, false, "number", gen_format("%d", index + 1).text, "of the triangle");
  emit_net(m, EMIT_REG, false, "vertex_1", gen_format("%d", 3 * w).text);
  emit_net(m, EMIT_REG, false, "vertex_2", gen_format("%d", 3 * w).text);
  emit_net(m, EMIT_WIRE, false, "vertex", gen_format("%d", 3 * w).text);
  static const char *const wires[] = {"take", "to_b", "fits", "room", "bad", "whole"};
  for (size_t i = 0; i < sizeof wires / sizeof wires[0]; i++) {
    emit_net(m, EMIT_WIRE, false, wires[i], "");
  }
  emit_net(m, EMIT_WIRE, false, "next_number", gen_format("%d", index + 1).text);
  for (int k = 0; k < 6; k++) {
    emit_net(m, EMIT_WIRE, true, gen_format("%s_%c", k % 2 ? "high" : "low", 'x' + k / 2).text,
             gen_format("%d", w).text);
  }
  emit_text(m, "\nassign tready = !busy;\nassign take = tvalid && tready;\n"
               "assign to_b = loading ? is_b : tdest;");
  if (w == 32) {
    emit_text(m, "assign vertex = tdata;\nassign fits = 1'b1;");
  } else {
    emit_text(m, "assign vertex = {tdata[%d:64], tdata[%d:32], tdata[%d:0]};", 63 + w, 31 + w,
              w - 1);
    emit_text(m,
              "assign fits = ((tdata[31:%d] == %d'd0) || (&tdata[31:%d])) &&\n"
              "              ((tdata[63:%d] == %d'd0) || (&tdata[63:%d])) &&\n"
              "              ((tdata[95:%d] == %d'd0) || (&tdata[95:%d]));",
              w - 1, 33 - w, w - 1, 31 + w, 33 - w, 31 + w, 63 + w, 33 - w, 63 + w);
  }
  if (p->index_a == p->index_b) {
    emit_text(m, "assign room = !number[%d];", index);
  } else {
    bool less_of_b = p->index_b < p->index_a;
    int less = less_of_b ? p->index_b : p->index_a;
    emit_text(m, "assign room = !number[%d] && (%sto_b || (number[%d:%d] == %d'd0));", index,
              less_of_b ? "!" : "", index - 1, less, index - less);
  }
  emit_text(m,
            "assign bad = loading && (bad_word || bad_frame || bad_size);\n"
            "assign whole = tlast && phase[2] && fits && room && !bad;\n"
            "assign next_number = number + %d'd1;",
            index + 1);
  for (int axis = 0; axis < 3; axis++) {
    char part[3][48];
    for (int k = 0; k < 3; k++) {
      snprintf(part[k], sizeof part[k], "triangle[%d:%d]", (3 * k + axis + 1) * w - 1,
               (3 * k + axis) * w);
    }
    emit_instance(m, "sepax_bounds", gen_format("bounds_%c", 'x' + axis).text,
                  gen_format("W=%d", w).text, "p=%s, q=%s, r=%s, low=low_%c, high=high_%c", part[0],
                  part[1], part[2], 'x' + axis, 'x' + axis);
  }
  emit_text(m, "assign box = {high_z, low_z, high_y, low_y, high_x, low_x};");
  emit_text(
      m,
      "\nalways @(posedge clk) begin\n  if (rst) begin\n"
      "    loading <= 1'b0;\n    ended <= 1'b0;\n    phase <= 3'b001;\n    number <= %d'd0;\n    write_a <= 1'b0;\n"
      "    write_b <= 1'b0;\n    count_a <= %d'd0;\n    count_b <= %d'd0;\n    bad_word <= 1'b0;\n"
      "    bad_frame <= 1'b0;\n    bad_size <= 1'b0;\n"
      "  end else begin\n"
      "    ended <= take && tlast;\n"
      "    write_a <= take && phase[2] && room && !to_b;\n"
      "    write_b <= take && phase[2] && room && to_b;\n"
      "    if (take) begin\n"
      "      loading <= !tlast;\n"
      "      phase <= tlast ? 3'b001 : {phase[1:0], phase[2]};\n"
      "      bad_word <= !fits || (loading && bad_word);\n"
      "      bad_frame <= tlast && !phase[2];\n"
      "      bad_size <= (phase[2] && !room) || (loading && bad_size);\n"
      "      if (tlast) begin\n        number <= %d'd0;\n"
      "      end else if (phase[2] && room) begin\n        number <= next_number;\n      end",
      index + 1, p->index_a + 1, p->index_b + 1, index + 1);
  for (int t = 0; t < 2; t++) {
    int bits = t == 0 ? p->index_a : p->index_b;
    emit_text(
        m,
        "      if (%sto_b) begin\n        count_%c <= next_number[%d:0] & {%d{whole}};\n      end",
        t == 0 ? "!" : "", 'a' + t, bits, bits + 1);
  }
  emit_text(m,
            "    end\n  end\n"
            "  if (take && !loading) begin\n    is_b <= tdest;\n  end\n"
            "  if (take && phase[0]) begin\n    vertex_1 <= vertex;\n  end\n"
            "  if (take && phase[1]) begin\n    vertex_2 <= vertex;\n  end\n"
            "  if (take && phase[2]) begin\n    triangle <= {vertex, vertex_2, vertex_1};\n"
            "    address <= number[%d:0];\n  end\nend",
            index - 1);
  emit_end(m);
}

void gen_engine_results(emitter *e, const engine_plan *p) {
  bool near = p->design->config.extent_a > 0;
  bool bands = p->design->limits > 0;
  emit_module *m = emit_begin(
      e, "sepax_results",
      "Counts verdicts and sends those that are collisions as AXI4-Stream, 64 bits each:\n"
      "  [31:0] number in A, [55:32] number in B, [56] coplanar, [57] out of range, [58]\n"
      "  warning\n"
      "A run ends with a transfer with TLAST: [31:0] how many there were, [62] stopped,\n"
      "[63] 1.");
  const gen_line a = gen_format("%d", p->index_a);
  const gen_line b = gen_format("%d", p->index_b);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "rst", "", "synchronous reset, active high");
  emit_signal(m, EMIT_INPUT, false, "start", "", "a run begins");
  emit_signal(m, EMIT_INPUT, false, "stop", "", "it is to end");
  emit_signal(m, EMIT_INPUT, false, "first", "", "it is to end at its first collision");
  emit_signal(m, EMIT_INPUT, false, "quiet", "", "nothing is sent");
  emit_signal(m, EMIT_INPUT, false, "tested", "7", "pairs that the lanes test in this cycle");
  emit_signal(m, EMIT_INPUT, false, "survived", "", "a pair goes on to a core");
  emit_signal(m, EMIT_INPUT, false, "drained", "", "no pair is left anywhere");
  emit_signal(m, EMIT_INPUT, false, "valid", "", "a verdict is here");
  emit_signal(m, EMIT_OUTPUT, false, "ready", "", "it is taken");
  emit_signal(m, EMIT_INPUT, false, "collision", "", "the verdict");
  emit_signal(m, EMIT_INPUT, false, "coplanar", "", "the triangles are in one plane");
  if (near) {
    emit_signal(m, EMIT_INPUT, false, "beyond", "", "beyond the extents");
  }
  if (bands) {
    emit_signal(m, EMIT_INPUT, false, "warning", "", "in the band between clearance and warning");
  }
  emit_signal(m, EMIT_INPUT, false, "outside", "", "B was moved out of the word");
  emit_signal(m, EMIT_INPUT, false, "a", a.text, "the pair: number in A");
  emit_signal(m, EMIT_INPUT, false, "b", b.text, "number in B");
  emit_signal(m, EMIT_OUTPUT_REG, false, "tvalid", "", "a result is here");
  emit_signal(m, EMIT_INPUT, false, "tready", "", "it is taken in this cycle");
  emit_signal(m, EMIT_OUTPUT_REG, false, "tdata", "64", "the result");
  emit_signal(m, EMIT_OUTPUT_REG, false, "tlast", "", "the end of the run");
  emit_signal(m, EMIT_OUTPUT, false, "halt", "", "make no more pairs and drop those under way");
  emit_signal(m, EMIT_OUTPUT, false, "done", "", "the run ends in this cycle");
  emit_signal(m, EMIT_OUTPUT, false, "hit", "", "its first collision is here");
  emit_signal(m, EMIT_OUTPUT_REG, false, "busy", "", "a run is going on");
  emit_signal(m, EMIT_OUTPUT_REG, false, "stopped", "", "it ends before all pairs are tested");
  emit_signal(m, EMIT_OUTPUT_REG, false, "any", "", "a collision was found");
  static const char *const counters[][2] = {
      {"pairs", "pairs tested"},
      {"candidates", "pairs that went to the cores"},
      {"collisions", "pairs that collide"},
      {"out_of_range", "of these, undecided"},
      {"warnings", "pairs that are too near"},
      {"cycles", "clock cycles of the run; stays at its largest value"},
      {"first_a", "first collision: number in A"},
      {"first_b", "first collision: number in B"}};
  for (size_t i = 0; i < sizeof counters / sizeof counters[0]; i++) {
    emit_signal(m, EMIT_OUTPUT_REG, false, counters[i][0], "32", "%s", counters[i][1]);
  }
  emit_net(m, EMIT_REG, false, "ending", "");
  static const char *const wires[] = {"take", "undecided", "found", "warned", "free", "finish"};
  for (size_t i = 0; i < sizeof wires / sizeof wires[0]; i++) {
    emit_net(m, EMIT_WIRE, false, wires[i], "");
  }
  emit_text(
      m, "\nassign free = !tvalid || tready;\nassign ready = free;\nassign take = valid && ready;");
  emit_text(m, near ? "assign undecided = outside || beyond;" : "assign undecided = outside;");
  emit_text(m,
            "assign found = take && !stopped && (collision || undecided);\n"
            "%s"
            "assign hit = found && !any;\n"
            "assign halt = stop || (first && hit);\n"
            "assign finish = busy && !ending && drained && free;\n"
            "assign done = (finish && quiet) || (ending && free);",
            bands ? "assign warned = take && !stopped && warning && !collision && !undecided;\n"
                  : "assign warned = 1'b0;\n");
  emit_net(m, EMIT_WIRE, false, "sent", "32");
  emit_text(m, "assign sent = collisions + warnings;");
  emit_text(
      m,
      "\nalways @(posedge clk) begin\n  if (rst) begin\n"
      "    busy <= 1'b0;\n    ending <= 1'b0;\n    stopped <= 1'b0;\n    any <= 1'b0;\n    tvalid <= 1'b0;\n"
      "  end else begin\n"
      "    if (start) begin\n      busy <= 1'b1;\n    end else if (done) begin\n      busy <= 1'b0;\n    end\n"
      "    ending <= (finish && !quiet) || (ending && !free);\n"
      "    if (start) begin\n      stopped <= 1'b0;\n      any <= 1'b0;\n    end else begin\n"
      "      stopped <= stopped || (busy && !ending && halt);\n      any <= any || found;\n    end\n"
      "    if (free) begin\n      tvalid <= (found || warned || finish) && !quiet;\n    end\n"
      "  end\n"
      "  if (free) begin\n    tlast <= finish;\n"
      "    tdata <= finish ? {1'b1, stopped, 30'd0, sent} :\n"
      "             {5'd0, warned, undecided, coplanar && !undecided, %s, %s};\n  end",
      gen_format(p->index_b < 24 ? "{%d'd0, b}" : "b", 24 - p->index_b).text,
      gen_format("{%d'd0, a}", 32 - p->index_a).text);
  emit_text(
      m,
      "  if (hit) begin\n    first_a <= {%d'd0, a};\n    first_b <= {%d'd0, b};\n  end\n"
      "  if (start) begin\n    pairs <= 32'd0;\n    candidates <= 32'd0;\n    collisions <= 32'd0;\n"
      "    out_of_range <= 32'd0;\n    warnings <= 32'd0;\n    cycles <= 32'd0;\n"
      "  end else begin\n"
      "    pairs <= pairs + {25'd0, tested};\n"
      "    candidates <= candidates + {31'd0, survived};\n"
      "    collisions <= collisions + {31'd0, found};\n"
      "    out_of_range <= out_of_range + {31'd0, found && undecided};\n"
      "    warnings <= warnings + {31'd0, warned};\n"
      "    cycles <= cycles + {31'd0, busy && !(&cycles)};\n"
      "  end\nend",
      32 - p->index_a, 32 - p->index_b);
  emit_end(m);
}
