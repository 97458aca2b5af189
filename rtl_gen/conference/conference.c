/* gen_conference.c - sepax_top of architecture conference: the machine that the paper improves
 * on, table by table in its 20 cycles (docs/conference.md). */
#include "emit/gen.h"
#include "sepax_design.h"

enum { LAST = 20, FIRST_NORMAL = 10, AXES = 11, FLAT_AXES = 6 };

static const char *const normal_widths = "V_W=V_W, C_W=N_W, M_W=NM_W, P_W=NP_W, S_W=NS_W, D_W=ND_W";
static const char *const axis_widths = "V_W=V_W, C_W=C_W, M_W=M_W, P_W=P_W, S_W=S_W, D_W=D_W";

/* A wire, its number behind its name. */
static void net(emit_module *m, const char *stem, int number, const char *width) {
  char name[EMIT_NAME];
  snprintf(name, sizeof name, "%s_%d", stem, number);
  emit_net(m, EMIT_WIRE, false, name, width);
}

static void registers(emit_module *m) {
  char name[EMIT_NAME];
  emit_blank(m);
  emit_signal(m, EMIT_REG, false, "word", "2", "number of words taken of the pair, 0 ... 2");
  for (int cycle = 4; cycle <= LAST; cycle++) {
    snprintf(name, sizeof name, "step_%d", cycle);
    emit_signal(m, EMIT_REG, false, name, "", "a pair is in cycle %d", cycle);
  }
  emit_text(
      m,
      "\n// Vertices and normals {x, y, z}: read in cycles 1-3, held for 5-7, 8-10, 11-13; vertices of\n"
      "// coplanar pairs for 14-16.");
  static const char *const bank[] = {"", "_5", "_8", "_11", "_14"};
  for (int b = 0; b < 5; b++) {
    for (int i = 0; i < 6; i++) {
      snprintf(name, sizeof name, "%c_%d%s", "ab"[i / 3], i % 3 + 1, bank[b]);
      emit_net(m, EMIT_REG, false, name, "3*V_W");
    }
    for (int i = 0; i < 2 && b < 4; i++) {
      snprintf(name, sizeof name, "n_%c%s", "ab"[i], bank[b]);
      emit_net(m, EMIT_REG, false, name, "3*N_W");
    }
  }
}

static void banks(emit_module *m) {
  static const struct {
    int step;
    const char *to, *from;
  } copy[] = {{4, "_5", ""}, {7, "_8", "_5"}, {10, "_11", "_8"}};
  gen_paper_input(m);
  for (int i = 0; i < 3; i++) {
    emit_text(m, "  if (step_%d) begin", copy[i].step);
    gen_paper_copy(m, "    ", copy[i].to, copy[i].from);
    emit_text(m, "    n_a%s <= n_a%s;\n    n_b%s <= n_b%s;\n  end", copy[i].to, copy[i].from,
              copy[i].to, copy[i].from);
  }
  emit_text(m, "  if (flat_load) begin");
  gen_paper_copy(m, "    ", "_14", "_11");
  emit_text(m, "  end\nend");
}

static void eleven_axes(emit_module *m) {
  char name[EMIT_NAME];
  char axis[EMIT_NAME];
  char result[EMIT_NAME];
  emit_text(m, "\n// Cycles 4-6: the nine axes across edges; 10 is N_A, 11 is N_B.");
  for (int i = 1; i < FIRST_NORMAL; i++) {
    net(m, "axis", i, "3*C_W");
  }
  emit_blank(m);
  emit_instance(
      m, "sepax_psa_9", "psa_9", "",
      "clk=clk, load_en=step_4, product_en=step_5, axis_en=step_6, a_1=a_1, a_2=a_2, a_3=a_3, "
      "b_1=b_1, b_2=b_2, b_3=b_3, axis_1=axis_1, axis_2=axis_2, axis_3=axis_3, axis_4=axis_4, "
      "axis_5=axis_5, axis_6=axis_6, axis_7=axis_7, axis_8=axis_8, axis_9=axis_9");
  emit_text(m, "\n// Cycles 7-8: eleven PROJ. Cycle 9: eleven CMP, which stand in cycles 10-12.");
  for (int i = 1; i <= AXES; i++) {
    const char *width = i < FIRST_NORMAL ? "3*D_W" : "3*ND_W";
    net(m, "on_a", i, width);
    net(m, "on_b", i, width);
    net(m, "overlap", i, "");
  }
  emit_net(m, EMIT_WIRE, false, "overlap", "11");
  emit_blank(m);
  for (int i = 1; i <= AXES; i++) {
    snprintf(name, sizeof name, "proj_%d", i);
    if (i < FIRST_NORMAL) {
      snprintf(axis, sizeof axis, "axis_%d", i);
    } else {
      snprintf(axis, sizeof axis, "n_%c_5", "ab"[i - FIRST_NORMAL]);
    }
    snprintf(result, sizeof result, "%d", i);
    gen_paper_project(m, name, i < FIRST_NORMAL ? axis_widths : normal_widths,
                      "product_en=step_7, sum_en=step_8", "_5", axis, result);
  }
  for (int i = 1; i <= AXES; i++) {
    snprintf(name, sizeof name, "cmp_%d", i);
    emit_instance(m, "sepax_cmp", name, i < FIRST_NORMAL ? "D_W=D_W" : "D_W=ND_W",
                  "clk=clk, en=step_9, rest=1'b0, on_a=on_a_%d, on_b=on_b_%d, overlap=overlap_%d",
                  i, i, i);
  }
  emit_text(
      m, "assign overlap = {overlap_11, overlap_10, overlap_9, overlap_8, overlap_7, overlap_6,\n"
         "                  overlap_5, overlap_4, overlap_3, overlap_2, overlap_1};");
}

static void coplanarity(emit_module *m) {
  const sepax_design *d = m->emitter->design;
  bool plane = d->config.coplanarity == SEPAX_COPLANAR_PLANE;
  emit_text(
      m,
      "\n// Cycles 10-11: inner products for COP alone. 12: COP; its verdict stands in cycles 13-15.");
  emit_net(m, EMIT_WIRE, false, "on_a_cop", "3*ND_W");
  emit_net(m, EMIT_WIRE, false, "on_b_cop", "3*ND_W");
  emit_signal(m, EMIT_WIRE, true, "coplanar_limit", "ND_W", "%d LSB along a unit normal",
              d->config.epsilon);
  emit_net(m, EMIT_WIRE, false, "coplanar_13", "");
  emit_text(m, "assign coplanar_limit = %d'sd%lld;\n", d->format[SEPAX_F_NORMAL_PROJECTION].width,
            (long long)d->coplanar_limit);
  emit_instance(
      m, "sepax_cop_proj", "cop_proj", normal_widths,
      "clk=clk, product_en=step_10, sum_en=step_11, axis_a=n_a_8, axis_b=n_%c_8, a_1=a_1_8, "
      "a_2=a_2_8, a_3=a_3_8, b_1=b_1_8, b_2=b_2_8, b_3=b_3_8, on_a=on_a_cop, on_b=on_b_cop",
      plane ? 'a' : 'b');
  emit_instance(m, "sepax_cop", "cop", "D_W=ND_W",
                "clk=clk, en=step_12, limit=coplanar_limit, p=%s, q=%s, coplanar=coplanar_13",
                plane ? "on_b_cop" : "on_a_cop", plane ? "on_a_cop" : "on_b_cop");
}

static void six_axes(emit_module *m) {
  char name[EMIT_NAME];
  char axis[EMIT_NAME];
  char result[EMIT_NAME];
  emit_text(
      m,
      "\n// Cycles 13-15: the six axes of table 2; 16-17: six PROJ; 18: six CMP, which stand in cycles\n"
      "// 19-21. All of them rest for pairs that are not coplanar.");
  static const struct {
    const char *name;
    int step, known;
  } enable[] = {{"flat_load", 13, 13}, {"flat_product", 14, 13}, {"flat_axis", 15, 13},
                {"flat_proj", 16, 16}, {"flat_sum", 17, 16},     {"flat_cmp", 18, 16}};
  emit_net(m, EMIT_REG, false, "coplanar_16", "");
  for (int i = 0; i < 6; i++) {
    emit_net(m, EMIT_WIRE, false, enable[i].name, "");
  }
  for (int i = 1; i <= FLAT_AXES; i++) {
    net(m, "axis_flat", i, "3*C_W");
    net(m, "on_a_flat", i, "3*D_W");
    net(m, "on_b_flat", i, "3*D_W");
    net(m, "overlap_flat", i, "");
  }
  emit_net(m, EMIT_WIRE, false, "overlap_flat", "6");
  emit_blank(m);
  for (int i = 0; i < 6; i++) {
    emit_text(m, "assign %s = step_%d && coplanar_%d;", enable[i].name, enable[i].step,
              enable[i].known);
  }
  emit_blank(m);
  emit_instance(
      m, "sepax_psa_6", "psa_6", "",
      "clk=clk, load_en=flat_load, product_en=flat_product, axis_en=flat_axis, a_1=a_1_11, "
      "a_2=a_2_11, a_3=a_3_11, b_1=b_1_11, b_2=b_2_11, b_3=b_3_11, n_a=n_a_11, n_b=n_b_11, "
      "axis_1=axis_flat_1, axis_2=axis_flat_2, axis_3=axis_flat_3, axis_4=axis_flat_4, "
      "axis_5=axis_flat_5, axis_6=axis_flat_6");
  for (int i = 1; i <= FLAT_AXES; i++) {
    snprintf(name, sizeof name, "proj_flat_%d", i);
    snprintf(axis, sizeof axis, "axis_flat_%d", i);
    snprintf(result, sizeof result, "flat_%d", i);
    gen_paper_project(m, name, axis_widths, "product_en=flat_proj, sum_en=flat_sum", "_14", axis,
                      result);
  }
  for (int i = 1; i <= FLAT_AXES; i++) {
    snprintf(name, sizeof name, "cmp_flat_%d", i);
    emit_instance(m, "sepax_cmp", name, "D_W=D_W",
                  "clk=clk, en=flat_cmp, rest=1'b0, on_a=on_a_flat_%d, on_b=on_b_flat_%d, "
                  "overlap=overlap_flat_%d",
                  i, i, i);
  }
  emit_text(
      m, "assign overlap_flat = {overlap_flat_6, overlap_flat_5, overlap_flat_4, overlap_flat_3,\n"
         "                       overlap_flat_2, overlap_flat_1};");
}

static void verdict(emit_module *m) {
  emit_text(
      m, "\n// What cycles 10 and 13 know, carried to the choice in cycle 19: eleven axes or six.");
  static const char *const flag[] = {"separated_13", "separated_16", "separated_19",
                                     "coplanar_19",  "collision_20", "coplanar_20"};
  for (int i = 0; i < 6; i++) {
    emit_net(m, EMIT_REG, false, flag[i], "");
  }
  emit_text(m, "\nalways @(posedge clk) begin\n"
               "  if (step_12) begin\n"
               "    separated_13 <= ~(&overlap);\n"
               "  end\n"
               "  if (step_15) begin\n"
               "    separated_16 <= separated_13;\n"
               "    coplanar_16 <= coplanar_13;\n"
               "  end\n"
               "  if (step_18) begin\n"
               "    separated_19 <= separated_16;\n"
               "    coplanar_19 <= coplanar_16;\n"
               "  end\n"
               "  if (step_19) begin\n"
               "    collision_20 <= coplanar_19 ? (&overlap_flat) : !separated_19;\n"
               "    coplanar_20 <= coplanar_19;\n"
               "  end\n"
               "end\n"
               "\n"
               "// Cycle 20: the verdict.\n"
               "assign out_valid = step_20;\n"
               "assign out_collision = out_valid && collision_20;\n"
               "assign out_coplanar = out_valid && coplanar_20;");
}

static void gen_conference_top(emitter *e) {
  emit_module *m = emit_begin(
      e, "sepax_top",
      "Collision detection of two triangles by the separating axis theorem: the machine that\n"
      "the paper improves on, with nothing shared between its two tables of axes.\n"
      "\n"
      "  cycle   1-3  input: word k brings A_k, B_k and component k of N_A and N_B\n"
      "          4-6  PSA of table 1: nine axes across edges\n"
      "          7-8  PROJ of all vertices on these, N_A and N_B\n"
      "            9  CMP of the eleven\n"
      "        10-11  PROJ of all vertices on normals, for COP alone\n"
      "        12-13  COP: coplanar? operands of the six axes, if so\n"
      "        14-15  PSA of table 2: six axes across normals and edges\n"
      "        16-17  PROJ of all vertices on these\n"
      "           18  CMP of the six\n"
      "        19-20  the verdict of the six or of the eleven, and output\n"
      "\n"
      "Latency 20 cycles from the first word to the verdict, initiation interval 3, no stall:\n"
      "words may come back to back or with gaps. Outputs are 0 without out_valid.");
  gen_paper_ports(m);
  gen_paper_widths(m);
  registers(m);
  gen_paper_control(m, LAST);
  eleven_axes(m);
  coplanarity(m);
  six_axes(m);
  banks(m);
  verdict(m);
  emit_end(m);
}

bool gen_conference(emitter *e) {
  gen_trunc(e);
  gen_mul(e);
  gen_edge(e);
  gen_dot(e);
  gen_proj(e);
  gen_cop_proj(e);
  gen_cop(e);
  if (e->design->config.block_float) {
    gen_norm(e);
  }
  gen_cross(e);
  gen_psa_9(e);
  gen_psa_6(e);
  gen_cmp(e);
  gen_conference_top(e);
  return e->error.text[0] == '\0';
}
