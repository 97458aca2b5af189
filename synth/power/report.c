/* report.c - what build/power writes. */
#include "analysis.h"
#include "liberty/text.h"

#include <stdio.h>
#include <stdlib.h>

static void print_path(FILE *out, const gates *g, int instance) {
  if (g->instance[instance].parent >= 0) {
    print_path(out, g, g->instance[instance].parent);
    fprintf(out, "%s/", g->instance[instance].name);
  }
}

static FILE *create(const char *path) {
  FILE *out = fopen(path, "w");
  if (out == NULL) {
    fprintf(stderr, "power: %s: cannot be written\n", path);
    exit(2);
  }
  return out;
}

static void close_file(FILE *out, const char *path) {
  if (fclose(out) != 0) {
    fprintf(stderr, "power: %s: cannot be written\n", path);
    exit(2);
  }
}

/* What OpenSTA lets be set: inputs of the top, and all pins of cells. */
static void print_pins(const analysis *m) {
  const gates *g = &m->g;
  FILE *out = create(m->want->pins);
  for (int k = 0; k < g->ports; k++) {
    if (!g->port[k].output && g->port[k].net != g->clock) {
      fprintf(out, "port %s %.6g %.6g\n", g->port[k].name, m->act[g->port[k].net],
              m->one[g->port[k].net]);
    }
  }
  for (int c = 0; c < g->cells; c++) {
    const gates_cell *cell = &g->cell[c];
    for (int k = 0; k < cell->type->pins; k++) {
      if (cell->net[k] > 1 && cell->net[k] != g->clock) {
        fprintf(out, "pin ");
        print_path(out, g, cell->instance);
        fprintf(out, "%s/%s %.6g %.6g\n", cell->name, cell->type->pin[k].name, m->act[cell->net[k]],
                m->one[cell->net[k]]);
      }
    }
  }
  close_file(out, m->want->pins);
}

static void print_cells(const analysis *m) {
  FILE *out = create(m->want->by_cell);
  for (int c = 0; c < m->g.cells; c++) {
    watts w = power_of(m, &m->g.cell[c]);
    print_path(out, &m->g, m->g.cell[c].instance);
    fprintf(out, "%s %s %.6g %.6g %.6g\n", m->g.cell[c].name, m->g.cell[c].type->name, w.internal,
            w.switching, w.leakage);
  }
  close_file(out, m->want->by_cell);
}

static void print_watts(watts w) {
  printf("\"leakage_w\": %.6g, \"internal_w\": %.6g, \"switching_w\": %.6g, \"total_w\": %.6g",
         w.leakage, w.internal, w.switching, w.leakage + w.internal + w.switching);
}

static void print_report(const analysis *m) {
  const gates *g = &m->g;
  watts *own = text_alloc((size_t)g->instances, sizeof *own);
  int *cells = text_alloc((size_t)g->instances, sizeof *cells);
  watts all = {0, 0, 0};
  watts registers = {0, 0, 0};
  for (int c = 0; c < g->cells; c++) {
    watts w = power_of(m, &g->cell[c]);
    watts *into[3] = {&own[g->cell[c].instance], &all,
                      g->cell[c].type->register_ ? &registers : NULL};
    for (int k = 0; k < 3 && into[k] != NULL; k++) {
      into[k]->leakage += w.leakage;
      into[k]->internal += w.internal;
      into[k]->switching += w.switching;
    }
    cells[g->cell[c].instance]++;
  }
  double joule = (all.leakage + all.internal + all.switching) * m->want->period * 1e-9;
  printf("{\"period_ns\": %g, \"lanes\": %d, \"cycles\": %llu, \"pairs\": %llu, \"judged\": %llu, "
         "\"collisions\": %llu, \"coplanar\": %llu, \"wrong\": %llu, "
         "\"undecided_percent\": %.4g, \"cells\": %d,\n ",
         m->want->period, GATES_LANES, (unsigned long long)g->cycles, (unsigned long long)m->taken,
         (unsigned long long)m->judged, (unsigned long long)m->collisions,
         (unsigned long long)m->coplanar, (unsigned long long)m->wrong,
         m->pairs > 0 ? 100.0 * (double)m->undecided / (double)m->pairs : 0.0, g->cells);
  print_watts(all);
  printf(", \"cycle_pj\": %.6g, \"pair_pj\": ", joule * 1e12);
  if (m->taken > 0) {
    printf("%.6g", joule * 1e12 * (double)g->cycles * GATES_LANES / (double)m->taken);
  } else {
    printf("null");
  }
  if (m->engine) {
    printf(", \"run_nj\": %.6g, \"memories\": \"not counted\"", joule * 1e9 * (double)g->cycles);
  }
  printf(",\n \"registers\": {");
  print_watts(registers);
  printf("}, \"clock_pins_pj\": %.6g,\n \"instances\": [",
         m->load[g->clock] * m->lib.volt * m->lib.volt * 1e12);
  for (int k = 0; k < g->instances; k++) {
    printf("%s\n  {\"path\": \"", k > 0 ? "," : "");
    print_path(stdout, g, k);
    printf("\", \"module\": \"%s\", \"cells\": %d, ", g->instance[k].module, cells[k]);
    print_watts(own[k]); /* NOLINT(clang-analyzer-core.NullDereference): as many as instances */
    printf("}");
  }
  printf("]}\n");
  free(own);
  free(cells);
}

void power_report(const analysis *m) {
  if (m->want->pins != NULL) {
    print_pins(m);
  }
  if (m->want->by_cell != NULL) {
    print_cells(m);
  }
  print_report(m);
}
