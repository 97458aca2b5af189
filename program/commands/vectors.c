/* SPDX-License-Identifier: MIT */
/* vectors.c - sepax vectors: seeded test vectors of hard cases as text. */
#include "cli/cli.h"
#include "command_table.h"
#include "sepax_design.h"
#include "sepax_vectors.h"

#include <stdio.h>
#include <string.h>

typedef struct {
  sepax_config config;
  const char *family;
  uint64_t count, seed;
  bool normals, list, exceed;
} vectors_options;

enum { KEY_NORMALS = 0x200, KEY_LIST, KEY_EXTENT_A, KEY_EXTENT_B, KEY_EXCEED };

static const struct argp_option options[] = {
    {"family", 'f', "NAME", 0, "family of hard pairs, or all of them in turn (default all)", 0},
    {"count", 'n', "PAIRS", 0, "number of pairs (default 1000)", 0},
    {"seed", 's', "SEED", 0, "seed of the random numbers (default 1)", 0},
    {"normals", KEY_NORMALS, NULL, 0, "print 24 integers for each pair, with both normals", 0},
    {"word", 'w', "BITS", 0, "bits W of a coordinate, 4 ... 32 (default 18)", 0},
    {"extent-a", KEY_EXTENT_A, "LSB", 0,
     "largest AABB side of a triangle of A, in LSB (default: no limit; needs --extent-b)", 0},
    {"extent-b", KEY_EXTENT_B, "LSB", 0,
     "largest AABB side of a triangle of B, in LSB (default: no limit; needs --extent-a)", 0},
    {"exceed", KEY_EXCEED, NULL, 0,
     "let one triangle of each pair exceed its extent (needs both extents)", 0},
    {"list", KEY_LIST, NULL, 0, "list the families and exit", 0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  vectors_options *o = state->input;
  sepax_error error;
  switch (key) {
  case 'f':
    o->family = text;
    return 0;
  case 'n':
    o->count = cli_count(state, "count", text, 0, UINT64_MAX);
    return 0;
  case 's':
    o->seed = cli_count(state, "seed", text, 0, UINT64_MAX);
    return 0;
  case 'w':
    if (!sepax_config_set(&o->config, "word", text, &error)) {
      argp_error(state, "%s", error.text);
    }
    return 0;
  case KEY_EXTENT_A:
  case KEY_EXTENT_B:
    if (!sepax_config_set(&o->config, key == KEY_EXTENT_A ? "extent-a" : "extent-b", text,
                          &error)) {
      argp_error(state, "%s", error.text);
    }
    return 0;
  case KEY_EXCEED:
    o->exceed = true;
    return 0;
  case KEY_NORMALS:
    o->normals = true;
    return 0;
  case KEY_LIST:
    o->list = true;
    return 0;
  case ARGP_KEY_ARG:
    argp_error(state, "unexpected argument '%s'", text);
    return 0;
  case ARGP_KEY_END:
    if (o->exceed && o->config.extent_a == 0) {
      argp_error(state, "exceed: needs extents; give --extent-a and --extent-b, too");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static void print_pair(const sepax_pair *pair, bool normals) {
  if (normals) {
    sepax_pair_print(stdout, pair);
    return;
  }
  for (int i = 0; i < 6; i++) {
    sepax_vec v = i < 3 ? pair->a.v[i] : pair->b.v[i - 3];
    printf("%s%d %d %d", i > 0 ? " " : "", v.x, v.y, v.z);
  }
}

static sepax_pair draw(const vectors_options *o, size_t family, sepax_random *random) {
  const int extent[2] = {o->config.extent_a, o->config.extent_b};
  if (extent[0] == 0) {
    return sepax_family_pair(family, o->config.word, random);
  }
  sepax_pair pair = sepax_extent_pair(family, o->config.word, extent, o->exceed, random);
  pair.na = sepax_unit_normal(&pair.a, o->config.word);
  pair.nb = sepax_unit_normal(&pair.b, o->config.word);
  return pair;
}

int cli_vectors(int argc, char **argv) {
  static const struct argp argp = {
      options,
      parse,
      NULL,
      "Print hard pairs of triangles (pairs that touch, nearly touch, or are degenerate), one in "
      "each line, as sepax judge and the test benches read them. The same seed gives the same "
      "pairs.",
      NULL,
      NULL,
      NULL};
  vectors_options o = {.config = sepax_config_default(), .family = "all", .count = 1000, .seed = 1};
  cli_parse(&argp, argc, argv, &o);
  if (o.list) {
    for (size_t i = 0; sepax_family_name(i) != NULL; i++) {
      printf("%-16s %s\n", sepax_family_name(i), sepax_family_about(i));
    }
    return 0;
  }
  sepax_error error = {0};
  size_t first;
  size_t last;
  if (!sepax_config_check(&o.config, &error) || !cli_families(o.family, &first, &last, &error)) {
    return cli_fail(argv[0], &error);
  }
  printf("# sepax vectors --family=%s --word=%d --count=%llu --seed=%llu", o.family, o.config.word,
         (unsigned long long)o.count, (unsigned long long)o.seed);
  if (o.config.extent_a > 0) {
    printf(" --extent-a=%d --extent-b=%d%s", o.config.extent_a, o.config.extent_b,
           o.exceed ? " --exceed" : "");
  }
  putchar('\n');
  sepax_random random = {o.seed};
  size_t family = last;
  for (uint64_t n = 0; n < o.count && !ferror(stdout); n++) {
    family = family < last ? family + 1 : first;
    sepax_pair pair = draw(&o, family, &random);
    print_pair(&pair, o.normals);
    printf(" # %s\n", sepax_family_name(family));
  }
  return 0;
}
