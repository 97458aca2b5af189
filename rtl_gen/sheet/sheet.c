/* SPDX-License-Identifier: MIT */
/* sheet.c - see sheet.h. */
#include "sheet/sheet.h"

#include "emit/ports.h"
#include "engine/engine.h"
#include "sheet/handshake.h"
#include "sheet/page.h"
#include "sheet/words.h"

#include <stdlib.h>
#include <string.h>

static const emit_module *top_of(const emitter *e) { return e->module[e->modules - 1]; }

/* The address of the register that begins a run; 0 without registers. */
static unsigned start_address(const emitter *e) {
  const engine_registers *map = engine_generator_of(&e->design->config)->registers;
  unsigned address = 0;
  for (size_t i = 0; map != NULL && i < map->rows && strcmp(map->row[i].name, "COMMAND") != 0;
       i++) {
    address += map->row[i].kind != ENGINE_FIELD ? 4 : 0;
  }
  return address;
}

void sheet_wave(const emitter *e, bool svg, emit_text *out) {
  wave w;
  handshake_wave(e->design, start_address(e), &w);
  (svg ? wave_svg : wave_json)(&w, out);
}

/* ------------------------------------------------------------------------ sections */

static void put_glance(const emitter *e, const sheet_costs *costs, page *p) {
  const sepax_design *d = e->design;
  const double ns = words_clock(d);
  page_table(p, "\tvalue");
  page_row(p, "top module\t`%s`", top_of(e)->name);
  page_row(p, "coordinates\t%d bits, signed: %d ... %d", d->config.word,
           sepax_word_min(d->config.word), sepax_word_max(d->config.word));
  page_row(p, "clock\t%g ns (%.4g MHz)", ns, 1000 / ns);
  page_row(p, "initiation interval\t%d cycles a pair%s", d->config.ii,
           d->config.cores > 1 ? " and core" : "");
  page_row(p, "throughput\t%.4g M pairs a second%s", words_pairs(d, costs->pairs) / 1e6,
           words_has_engine(d) ? " through the cores" : "");
  if (costs->compared > 0) {
    page_row(p, "comparator lanes\t%.4g M pairs of bounding boxes a second", costs->compared / 1e6);
  }
  page_row(p, "latency%s\t%d cycles, %.4g ns", words_has_engine(d) ? " of a core" : "", d->latency,
           d->latency * ns);
  page_table_end(p);
}

static void put_ports(emitter *e, page *p) {
  emit_ports ports = emit_ports_of(top_of(e));
  page_section(p, "Ports");
  page_table(p, "port\tdirection\tbits\tmeaning");
  for (int i = 0; i < ports.count; i++) {
    const emit_port *port = &ports.port[i];
    page_row(p, "`%s`\t%s\t%d%s\t%s", port->name, port->is_input ? "in" : "out", port->width,
             port->is_signed ? ", signed" : "", port->about);
  }
  page_table_end(p);
  emit_ports_free(&ports);
}

static void put_handshake(emitter *e, page *p) {
  emit_text svg = {NULL};
  sheet_wave(e, true, &svg);
  char *picture = text_take(&svg);
  page_section(p, "Handshake");
  page_picture(p, "waveform", gen_format("%s_handshake.svg", e->prefix).text,
               picture != NULL ? picture : "");
  p->out->failed |= picture == NULL;
  free(picture);
  words_handshake(e->design, p);
}

static void put_speed(const emitter *e, page *p) {
  const sepax_design *d = e->design;
  const sepax_config *c = &d->config;
  const int transfers = sepax_stream_transfers(c);
  const int cycles = transfers > c->ii ? transfers : c->ii;
  page_section(p, "Latency and throughput");
  if (c->arch != SEPAX_ARCH_EXACT) {
    page_text(p,
              "A verdict comes %d cycles after the first word of its pair, both cycles counted. A "
              "pair can begin every %d cycles.",
              d->latency, c->ii);
    return;
  }
  const gen_line later = gen_format(
      " A pair that is taken before the core can begin with it has up to %d cycles more.", d->wait);
  page_text(
      p,
      "The latency%s is %d cycles, from the cycle that takes a pair to the cycle of its verdict, "
      "both counted. It is the same for every pair, unless earlier verdicts still wait for the "
      "receiver.%s %s takes a pair every %s.",
      words_has_engine(d) ? " of a core" : "", d->latency, d->wait > 0 ? later.text : "",
      words_has_engine(d) ? "A core" : "The block",
      cycles > 1 ? gen_format("%d cycles", cycles).text : "cycle");
}

/* Faults of Yosys 0.23, which make a wrong netlist (docs/developers/results/fpga.md). */
static void put_faults(const sepax_config *c, page *p) {
  if (c->target == SEPAX_TARGET_XC7 || c->target == SEPAX_TARGET_XCUP) {
    page_text(p,
              "If you use Yosys, give `synth_xilinx -nosrl`: Yosys 0.23 loses the clock enable of "
              "shift registers, and the netlist then gives wrong verdicts.");
  } else if (c->target == SEPAX_TARGET_GOWIN) {
    page_text(p,
              "If you use Yosys, run `proc` and `techmap -map synth/fpga/cells/compare.v` of sepax "
              "before `synth_gowin`: Yosys 0.23 maps comparisons wrongly, and the netlist then "
              "gives wrong verdicts.");
  }
}

static void put_costs(const emitter *e, const sheet_costs *costs, page *p) {
  static const char *const workloads[SHEET_ENERGIES] = {"separated", "colliding", "coplanar"};
  page_section(p, "Cost");
  if (!costs->gates_known) {
    page_text(p, e->design->config.arch != SEPAX_ARCH_EXACT
                     ? "sepax predicts no gates for this architecture."
                     : "sepax predicts no cells for FPGAs: run synthesis.");
    put_faults(&e->design->config, p);
  } else {
    page_text(p, "Predicted, not measured: by formulas that were fitted to designs in Nangate45, "
                 "typical corner. The error is the interval of the prediction. GE: 2-input NAND "
                 "gates.");
    page_table(p, "\tpredicted\terror");
    page_row(p, "gates\t%.1fK GE\t+- %.1fK GE", costs->gates / 1000, costs->gates_error / 1000);
    page_row(p, "flip-flops\t%.0f\t+- %.0f", costs->flip_flops, costs->flip_flops_error);
    for (int i = 0; i < SHEET_ENERGIES && costs->energy_known; i++) {
      page_row(p, "energy of a pair that is %s\t%.3f nJ\t+- %.3f nJ", workloads[i],
               costs->energy[i], costs->energy_error[i]);
    }
    page_table_end(p);
  }
  if (costs->memory_bits > 0) {
    page_text(p, "The memories have %llu bits, which are not in the gates.",
              (unsigned long long)costs->memory_bits);
  }
}

static void put_registers(const emitter *e, page *p) {
  static const char *const access[] = {"read", "read", "write", "read, write",
                                       "read, write 1 to clear"};
  const engine_registers *map = engine_generator_of(&e->design->config)->registers;
  if (map == NULL) {
    return;
  }
  page_section(p, "Registers");
  page_table(p, "address\tname\taccess\tbits\tmeaning");
  unsigned address = 0;
  for (const engine_register *r = map->row; r < map->row + map->rows; r++) {
    if (r->kind != ENGINE_FIELD) {
      page_row(p, "0x%02x\t`%s`\t%s\t\t%s", address, r->name, access[r->kind], r->about);
      address += 4;
    } else if (r->bits == 1) {
      page_row(p, "\t`%s`\t\t%d\t%s", r->name, r->low, r->about);
    } else {
      page_row(p, "\t`%s`\t\t%d:%d\t%s", r->name, r->low + r->bits - 1, r->low, r->about);
    }
  }
  page_table_end(p);
}

static void put_options(const emitter *e, page *p) {
  sepax_setting setting;
  page_section(p, "Configuration");
  page_table(p, "option\tvalue");
  for (size_t i = 0; sepax_config_setting(&e->design->config, i, &setting); i++) {
    page_row(p, "`--%s`\t%s", setting.name, setting.value);
  }
  page_table_end(p);
  page_text(p, "The command that made it:");
  page_code(p, e->command);
}

void sheet_write(emitter *e, const sheet_costs *costs, bool html, emit_text *out) {
  page p;
  page_begin(&p, out, html, gen_format("%s: %s", top_of(e)->name, words_title(e->design)).text);
  words_purpose(e->design, &p);
  put_glance(e, costs, &p);
  page_section(&p, "Exactness");
  words_exactness(e->design, &p);
  words_verdict(e->design, &p);
  put_ports(e, &p);
  put_handshake(e, &p);
  put_speed(e, &p);
  put_costs(e, costs, &p);
  put_registers(e, &p);
  put_options(e, &p);
  page_end(&p);
}
