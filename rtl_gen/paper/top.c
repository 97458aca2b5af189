/* gen_top.c - sepax_top: figure 5 wired and scheduled as figure 6. */
#include "emit/gen.h"
#include "sepax_design.h"

static void localparam(emit_module *m, const char *name, sepax_format_id id, bool exact,
                       const char *about) {
  const sepax_format *f = &m->emitter->design->format[id];
  emit_parameter(m, EMIT_LOCALPARAM, name, exact ? f->exact : f->width, about);
}

void gen_paper_widths(emit_module *m) {
  localparam(m, "V_W", SEPAX_F_VERTEX, false, "bits of a coordinate");
  localparam(m, "N_W", SEPAX_F_NORMAL, false, "bits of a normal's component");
  localparam(m, "NM_W", SEPAX_F_NORMAL_PRODUCT, true, "coordinate x normal, exact");
  localparam(m, "NP_W", SEPAX_F_NORMAL_PRODUCT, false, "kept of it");
  localparam(m, "NS_W", SEPAX_F_NORMAL_PROJECTION, true, "projection on a normal, exact");
  localparam(m, "ND_W", SEPAX_F_NORMAL_PROJECTION, false, "kept of it");
  localparam(m, "C_W", SEPAX_F_AXIS, false, "bits of an axis component");
  localparam(m, "M_W", SEPAX_F_PRODUCT, true, "coordinate x axis component, exact");
  localparam(m, "P_W", SEPAX_F_PRODUCT, false, "kept of it");
  localparam(m, "S_W", SEPAX_F_PROJECTION, true, "projection on an axis, exact");
  localparam(m, "D_W", SEPAX_F_PROJECTION, false, "kept of it");
}

void gen_paper_ports(emit_module *m) {
  const sepax_design *d = m->emitter->design;
  int word = d->config.word;
  char bits[16];
  snprintf(bits, sizeof bits, "%d", word);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "rst", "", "synchronous reset of the control, active high");
  emit_signal(m, EMIT_INPUT, false, "in_valid", "", "an input word is here; three make a pair");
  for (int i = 0; i < 6; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "in_%c_%c", "ab"[i / 3], "xyz"[i % 3]);
    emit_signal(m, EMIT_INPUT, true, name, bits, "%c of vertex %c_k in word k, %ld ... %ld",
                "xyz"[i % 3], "AB"[i / 3], (long)sepax_word_min(word), (long)sepax_word_max(word));
  }
  for (int i = 0; i < 2; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "in_n%c", "ab"[i]);
    emit_signal(m, EMIT_INPUT, true, name, bits, "component k of N_%c in word k, Q1.%d", "AB"[i],
                word - 1);
  }
  emit_signal(m, EMIT_OUTPUT, false, "out_valid", "", "a verdict is here");
  emit_signal(m, EMIT_OUTPUT, false, "out_collision", "", "1: no separating axis was found");
  emit_signal(m, EMIT_OUTPUT, false, "out_coplanar", "", "1: judged by table 2");
}

static void registers(emit_module *m) {
  char name[EMIT_NAME];
  emit_blank(m);
  emit_signal(m, EMIT_REG, false, "word", "2", "number of words taken of the pair, 0 ... 2");
  for (int cycle = 4; cycle <= 13; cycle++) {
    snprintf(name, sizeof name, "step_%d", cycle);
    emit_signal(m, EMIT_REG, false, name, "", "a pair is in cycle %d", cycle);
  }
  emit_text(m,
            "\n// Vertices and normals {x, y, z}: read in cycles 1-3, held for 5-7, 8-10, 10-12.");
  static const char *const bank[] = {"", "_5", "_8", "_rest"};
  for (int b = 0; b < 4; b++) {
    for (int i = 0; i < 6; i++) {
      snprintf(name, sizeof name, "%c_%d%s", "ab"[i / 3], i % 3 + 1, bank[b]);
      emit_net(m, EMIT_REG, false, name, "3*V_W");
    }
    for (int i = 0; i < 2 && b < 2; i++) {
      snprintf(name, sizeof name, "n_%c%s", "ab"[i], bank[b]);
      emit_net(m, EMIT_REG, false, name, "3*N_W");
    }
  }
}

void gen_paper_control(emit_module *m, int last) {
  emit_text(m, "\n// Control: a word counter and one bit per cycle of the schedule.\n"
               "always @(posedge clk) begin\n"
               "  if (rst) begin\n"
               "    word <= 2'd0;\n"
               "    step_4 <= 1'b0;");
  for (int cycle = 5; cycle <= last; cycle++) {
    emit_text(m, "    step_%d <= 1'b0;", cycle);
  }
  emit_text(m, "  end else begin\n"
               "    if (in_valid) begin\n"
               "      word <= (word == 2'd2) ? 2'd0 : (word + 2'd1);\n"
               "    end\n"
               "    step_4 <= in_valid && (word == 2'd2);");
  for (int cycle = 5; cycle <= last; cycle++) {
    emit_text(m, "    step_%d <= step_%d;", cycle, cycle - 1);
  }
  emit_text(m, "  end\nend");
}

void gen_paper_copy(emit_module *m, const char *indent, const char *to, const char *from) {
  for (int i = 0; i < 6; i++) {
    char vertex[EMIT_NAME];
    snprintf(vertex, sizeof vertex, "%c_%d", "ab"[i / 3], i % 3 + 1);
    emit_text(m, "%s%s%s <= %s%s;", indent, vertex, to, vertex, from);
  }
}

void gen_paper_input(emit_module *m) {
  emit_text(m, "\n// Cycles 1-3: word k brings vertex k and component k of the normals.\n"
               "always @(posedge clk) begin\n"
               "  if (in_valid) begin\n"
               "    a_1 <= a_2;\n"
               "    a_2 <= a_3;\n"
               "    a_3 <= {in_a_x, in_a_y, in_a_z};\n"
               "    b_1 <= b_2;\n"
               "    b_2 <= b_3;\n"
               "    b_3 <= {in_b_x, in_b_y, in_b_z};\n"
               "    n_a <= {n_a[2*N_W-1:0], in_na};\n"
               "    n_b <= {n_b[2*N_W-1:0], in_nb};\n"
               "  end");
}

static void banks(emit_module *m) {
  gen_paper_input(m);
  emit_text(m, "  if (step_4) begin");
  gen_paper_copy(m, "    ", "_5", "");
  emit_text(m, "    n_a_5 <= n_a;\n    n_b_5 <= n_b;\n  end\n  if (step_7) begin");
  gen_paper_copy(m, "    ", "_8", "_5");
  emit_text(m, "  end\n  if (step_9 && !coplanar_7) begin");
  gen_paper_copy(m, "    ", "_rest", "_8");
  emit_text(m, "  end\nend\n");
}

void gen_paper_project(emit_module *m, const char *name, const char *parameters,
                       const char *enables, const char *bank, const char *axis,
                       const char *result) {
  emit_instance(m, "sepax_proj", name, parameters,
                "clk=clk, %s, axis=%s, a_1=a_1%s, a_2=a_2%s, a_3=a_3%s, b_1=b_1%s, b_2=b_2%s, "
                "b_3=b_3%s, on_a=on_a_%s, on_b=on_b_%s",
                enables, axis, bank, bank, bank, bank, bank, bank, result, result);
}

static void normal_axes(emit_module *m) {
  static const char *const parameters = "V_W=V_W, C_W=N_W, M_W=NM_W, P_W=NP_W, S_W=NS_W, D_W=ND_W";
  const sepax_design *d = m->emitter->design;
  char name[EMIT_NAME];
  emit_text(m, "\n// Cycles 4-5: PROJ on the normals; 6: CMP of axes 10 (N_A) and 11 (N_B).");
  for (int i = 10; i <= 11; i++) {
    snprintf(name, sizeof name, "on_a_%d", i);
    emit_signal(m, EMIT_WIRE, false, name, "3*ND_W", i == 10 ? "t_k = A_k.N_A" : "u_k = A_k.N_B");
    snprintf(name, sizeof name, "on_b_%d", i);
    emit_signal(m, EMIT_WIRE, false, name, "3*ND_W", i == 10 ? "s_k = B_k.N_A" : "v_k = B_k.N_B");
    snprintf(name, sizeof name, "overlap_%d_7", i);
    emit_signal(m, EMIT_WIRE, false, name, "", "stands in cycles 7-9");
  }
  emit_blank(m);
  gen_paper_project(m, "proj_10", parameters, "product_en=step_4, sum_en=step_5", "", "n_a", "10");
  gen_paper_project(m, "proj_11", parameters, "product_en=step_4, sum_en=step_5", "", "n_b", "11");
  for (int i = 10; i <= 11; i++) {
    snprintf(name, sizeof name, "cmp_%d", i);
    emit_instance(m, "sepax_cmp", name, "D_W=ND_W",
                  "clk=clk, en=step_6, rest=1'b0, on_a=on_a_%d, on_b=on_b_%d, "
                  "overlap=overlap_%d_7",
                  i, i, i);
  }
  bool plane = d->config.coplanarity == SEPAX_COPLANAR_PLANE;
  emit_text(m, "\n// Cycle 6: COP; its verdict stands in cycles 7-9.");
  emit_signal(m, EMIT_WIRE, true, "coplanar_limit", "ND_W", "%d LSB along a unit normal",
              d->config.epsilon);
  emit_net(m, EMIT_WIRE, false, "coplanar_7", "");
  emit_text(m, "assign coplanar_limit = %d'sd%lld;\n", d->format[SEPAX_F_NORMAL_PROJECTION].width,
            (long long)d->coplanar_limit);
  emit_instance(m, "sepax_cop", "cop", "D_W=ND_W",
                "clk=clk, en=step_6, limit=coplanar_limit, p=%s, q=%s, coplanar=coplanar_7",
                plane ? "on_b_10" : "on_a_10", plane ? "on_a_10" : "on_b_11");
}

static void delays(emit_module *m) {
  emit_text(m, "\n// What cycle 7 knows, carried to cycles 10-12 and to the verdict in cycle 13.");
  static const char *const flag[] = {"coplanar", "overlap_10", "overlap_11"};
  for (int i = 0; i < 3; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "%s_10", flag[i]);
    emit_net(m, EMIT_REG, false, name, "");
    snprintf(name, sizeof name, "%s_13", flag[i]);
    emit_net(m, EMIT_REG, false, name, "");
  }
  emit_text(m, "\nalways @(posedge clk) begin\n  if (step_9) begin");
  for (int i = 0; i < 3; i++) {
    emit_text(m, "    %s_10 <= %s_7;", flag[i], flag[i]);
  }
  emit_text(m, "  end\n  if (step_12) begin");
  for (int i = 0; i < 3; i++) {
    emit_text(m, "    %s_13 <= %s_10;", flag[i], flag[i]);
  }
  emit_text(m, "  end\nend");
}

static void axes(emit_module *m) {
  static const char *const parameters = "V_W=V_W, C_W=C_W, M_W=M_W, P_W=P_W, S_W=S_W, D_W=D_W";
  char name[EMIT_NAME];
  emit_text(m, "\n// Cycles 7-9: operands, products and differences of PSA.");
  for (int i = 1; i <= 9; i++) {
    snprintf(name, sizeof name, "axis_%d", i);
    emit_net(m, EMIT_WIRE, false, name, "3*C_W");
  }
  emit_blank(m);
  emit_instance(m, "sepax_psa", "psa", "",
                "clk=clk, load_en=step_7, product_en=step_8, axis_en=step_9, "
                "coplanar=coplanar_7, a_1=a_1_5, a_2=a_2_5, a_3=a_3_5, b_1=b_1_5, b_2=b_2_5, "
                "b_3=b_3_5, n_a=n_a_5, n_b=n_b_5, axis_1=axis_1, axis_2=axis_2, axis_3=axis_3, "
                "axis_4=axis_4, axis_5=axis_5, axis_6=axis_6, axis_7=axis_7, axis_8=axis_8, "
                "axis_9=axis_9");
  emit_text(m,
            "\n// Cycles 10-11: nine PROJ; 7 ... 9 rest for coplanar pairs. Cycle 12: nine CMP.");
  emit_net(m, EMIT_WIRE, false, "product_en_rest", "");
  emit_net(m, EMIT_WIRE, false, "sum_en_rest", "");
  for (int i = 1; i <= 9; i++) {
    snprintf(name, sizeof name, "on_a_%d", i);
    emit_net(m, EMIT_WIRE, false, name, "3*D_W");
    snprintf(name, sizeof name, "on_b_%d", i);
    emit_net(m, EMIT_WIRE, false, name, "3*D_W");
    snprintf(name, sizeof name, "overlap_%d", i);
    emit_net(m, EMIT_WIRE, false, name, "");
  }
  emit_text(m, "\nassign product_en_rest = step_10 && !coplanar_10;\n"
               "assign sum_en_rest = step_11 && !coplanar_10;\n\n");
  for (int i = 1; i <= 9; i++) {
    bool rests = i > 6;
    char proj[EMIT_NAME];
    char axis[EMIT_NAME];
    char result[EMIT_NAME];
    snprintf(proj, sizeof proj, "proj_%d", i);
    snprintf(axis, sizeof axis, "axis_%d", i);
    snprintf(result, sizeof result, "%d", i);
    gen_paper_project(m, proj, parameters,
                      rests ? "product_en=product_en_rest, sum_en=sum_en_rest"
                            : "product_en=step_10, sum_en=step_11",
                      rests ? "_rest" : "_8", axis, result);
  }
  for (int i = 1; i <= 9; i++) {
    snprintf(name, sizeof name, "cmp_%d", i);
    emit_instance(m, "sepax_cmp", name, "D_W=D_W",
                  "clk=clk, en=step_12, rest=%s, on_a=on_a_%d, on_b=on_b_%d, overlap=overlap_%d",
                  i > 6 ? "coplanar_10" : "1'b0", i, i, i);
  }
}

static void verdict(emit_module *m) {
  emit_text(m, "\n// Cycle 13: the verdict.");
  emit_net(m, EMIT_WIRE, false, "overlap", "11");
  emit_net(m, EMIT_WIRE, false, "separated", "");
  emit_text(m,
            "assign overlap = {overlap_11_13, overlap_10_13, overlap_9, overlap_8, overlap_7,\n"
            "                  overlap_6, overlap_5, overlap_4, overlap_3, overlap_2, overlap_1};\n"
            "assign out_valid = step_13;\n"
            "assign out_collision = out_valid && !separated;\n"
            "assign out_coplanar = out_valid && coplanar_13;\n\n");
  emit_instance(m, "sepax_nand", "last", "", "overlap=overlap, separated=separated");
}

void gen_top(emitter *e) {
  emit_module *m = emit_begin(
      e, "sepax_top",
      "Collision detection of two triangles by the separating axis theorem: the\n"
      "architecture of the paper, figure 5, in the 13 cycles of its figure 6.\n"
      "\n"
      "  cycle   1-3  input: word k brings A_k, B_k and component k of N_A and N_B\n"
      "          4-5  PROJ of all vertices on N_A and N_B\n"
      "          6-7  COP: coplanar? CMP of axes 10 and 11; operands of PSA\n"
      "          8-9  PSA: axes 1 ... 9 (table 1) or 1 ... 6 (table 2, coplanar)\n"
      "        10-11  PROJ of all vertices on the axes; 7 ... 9 rest when coplanar\n"
      "        12-13  CMP and output\n"
      "\n"
      "Latency 13 cycles from the first word to the verdict, initiation interval 3, no\n"
      "stall: words may come back to back or with gaps. Outputs are 0 without out_valid.");
  gen_paper_ports(m);
  gen_paper_widths(m);
  registers(m);
  gen_paper_control(m, 13);
  normal_axes(m);
  delays(m);
  banks(m);
  axes(m);
  verdict(m);
  emit_end(m);
}

bool gen_paper(emitter *e) {
  gen_trunc(e);
  gen_mul(e);
  gen_edge(e);
  gen_dot(e);
  gen_proj(e);
  gen_cop(e);
  if (e->design->config.block_float) {
    gen_norm(e);
  }
  gen_cross(e);
  gen_psa(e);
  gen_cmp(e);
  gen_nand(e);
  gen_top(e);
  return e->error.text[0] == '\0';
}
