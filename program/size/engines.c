/* SPDX-License-Identifier: MIT */
/* engines.c - requests designs with one engine each, and prints them. */
#include "size/parts.h"
#include "design/engine_table.h"

#include <stdio.h>

static bool ask_core(sepax_size_request *r, const size_options *o, const size_answer *answer) {
  (void)answer;
  r->lanes_most = 0;
  r->tree = false;
  return !o->request.tree && r->lanes_least == 0;
}

static void print_core(const sepax_config *c, double kbit) {
  (void)c;
  (void)kbit;
  puts("no comparator lanes");
}

static bool ask_object(sepax_size_request *r, const size_options *o, const size_answer *answer) {
  (void)answer;
  r->lanes_least = r->lanes_least == 0 ? 1 : r->lanes_least;
  r->tree = false;
  return !o->request.tree && r->lanes_least <= r->lanes_most;
}

static void print_object(const sepax_config *c, double kbit) {
  printf("%d comparator lanes, %d core%s, memories of %.0f kbit\n", c->lanes, c->cores,
         c->cores > 1 ? "s" : "", kbit);
}

static void print_object_basis(const size_options *o) {
  if (!o->is_scene) {
    printf("rests on   the golden model's cycles in each pose, and vertices that are loaded anew "
           "for each,\n%-*s3 cycles a triangle\n",
           SIZE_WIDTH, "");
  }
}

static bool ask_tree(sepax_size_request *r, const size_options *o, const size_answer *answer) {
  r->lanes_least = 1;
  r->lanes_most = 0;
  r->tree = true;
  return answer->size->trees != NULL && !o->lanes_given;
}

static void print_tree(const sepax_config *c, double kbit) {
  printf("tree engine, %d core%s, memories of %.0f kbit\n", c->cores, c->cores > 1 ? "s" : "",
         kbit);
}

static void print_tree_basis(const size_options *o) {
  printf("rests on   cycles that the golden model's walk of each pose predicts, in measured "
         "scenes the\n%-*smean to 4 %%, a pose to 13 %%; memory of %d cycles latency and 128 "
         "bits, caches cold\n%-*sat each pose\n",
         SIZE_WIDTH, "", o->request.latency, SIZE_WIDTH, "");
}

const size_engine size_engines[SEPAX_ENGINE_COUNT] = {
    [SEPAX_ENGINE_NONE] = {.name = "core alone", .ask = ask_core, .print = print_core},
    [SEPAX_ENGINE_OBJECT] = {.name = "object engine",
                             .ask = ask_object,
                             .print = print_object,
                             .print_basis = print_object_basis},
    [SEPAX_ENGINE_TREE] = {.name = "tree engine",
                           .walks_trees = true,
                           .ask = ask_tree,
                           .print = print_tree,
                           .print_basis = print_tree_basis},
};

const size_engine *size_engine_of(const sepax_sized_design *m) {
  return &size_engines[sepax__config_engine(&m->config)];
}
