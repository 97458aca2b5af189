/* SPDX-License-Identifier: MIT */
/* option_table.c - every option of a design: a row says all about it except for what it does. */
#include "design/options.h"
#include "design/paper.h"

#include <stddef.h>

enum {
  EXACT = 1 << SEPAX_ARCH_EXACT,
  PUBLISHED = 1 << SEPAX_ARCH_PAPER | 1 << SEPAX_ARCH_CONFERENCE,
  HARDWARE = EXACT | PUBLISHED,
  ALL = (1 << SEPAX_ARCH_COUNT) - 1
};

static const char *const coplanarity_names[] = {"plane", "paper", NULL};
static const char *const inequality_names[] = {"correct", "printed", NULL};
static const char *const switch_names[] = {"off", "on", NULL};
static const char *const early_names[] = {"none", "boxes", NULL};
static const char *const coplanar_names[] = {"exact", "flag", NULL};
static const char *const stream_names[] = {"none", "vertex", "triangle", "pair", NULL};
static const char *const target_names[] = {"asic", "ice40", "ecp5", "xc7", "xcup", "gowin", NULL};

static const char *const corner_names[] = {"typical", "slow", NULL};

/* Macros for parts of a row. The first name of a choice is its default. */
#define FIELD(member) \
  .field = offsetof(sepax_config, member), .size = sizeof(((sepax_config *)0)->member)
#define CHOICES(names) .choices = (names), .low = 0, .high = sizeof(names) / sizeof((names)[0]) - 2
#define RANGE(least, most) .low = (least), .high = (most)

/* clang-format off */
static const design_option table[] = {
    {.name = "arch", .kind = OPTION_ARCH, FIELD(arch), .standard = SEPAX_ARCH_EXACT,
     RANGE(0, SEPAX_ARCH_COUNT - 1), .archs = ALL, .named = ALL, .shown = true, .tag = "%s",
     .argument = "NAME", .decides = true,
     .help = "architecture. Hardware: exact (default), paper, conference. Software only: "
             "reference, float32, float64, interval32, interval64, guigue32, guigue64, filtered"},
    {.name = "word", .letter = 'w', .kind = OPTION_NUMBER, FIELD(word), .standard = 18,
     RANGE(SEPAX_WORD_MIN, SEPAX_WORD_MAX), .archs = ALL, .named = ALL, .shown = true,
     .tag = "-w%s", .argument = "BITS", .decides = true,
     .help = "bits W of a coordinate, 4 ... 32 (default 18)"},
    {.name = "ii", .kind = OPTION_NUMBER, FIELD(ii), .standard = 3, RANGE(1, SEPAX_II_MAX),
     .archs = HARDWARE, .named = EXACT, .shown = true, .tag = "-ii%s", .argument = "CYCLES",
     .help = "initiation interval: cycles between two pairs, 1 ... 18 (default 3); paper and "
             "conference have 3 only"},
    {.name = "coplanar", .kind = OPTION_CHOICE, FIELD(flag), CHOICES(coplanar_names),
     .archs = EXACT, .shown = true, .tag = "-%s", .argument = "HOW", .decides = true,
     .help = "exact: decide coplanar pairs (default); flag: call them collisions and flag them as "
             "undecided, which saves gates"},
    {.name = "clock-ns", .kind = OPTION_PERIOD, FIELD(clock_ps), .standard = 2000,
     RANGE(500, 1000000), .archs = EXACT, .shown = true, .tag = "-%sns", .argument = "PERIOD",
     .help = "clock period in ns for which pipeline registers are placed, 0.5 ... 1000 (default "
             "2)"},
    {.name = "corner", .kind = OPTION_CHOICE, FIELD(corner), CHOICES(corner_names), .archs = EXACT,
     .tag = "-%s", .argument = "NAME",
     .help = "corner of the cells for which the clock period must hold: typical (default) or slow"},
    {.name = "target", .kind = OPTION_CHOICE, FIELD(target), CHOICES(target_names), .archs = EXACT,
     .tag = "-%s", .argument = "FAMILY",
     .help = "technology: asic (default, multipliers made of gates) or an FPGA family (its own "
             "multipliers): ice40, ecp5, xc7, xcup, gowin"},
    {.name = "extent-a", .kind = OPTION_NUMBER, FIELD(extent_a), .standard = 0,
     RANGE(1, INT32_MAX), .archs = EXACT, .needs = "extent-b", .tag = "-a%s", .argument = "LSB",
     .decides = true,
     .help = "largest AABB side of a triangle of A, in LSB. An AABB test then precedes the core, "
             "and the core is smaller because it is built for triangles up to this size. A larger "
             "triangle is reported as a collision and flagged as undecided (default: no limit; "
             "needs --extent-b)"},
    {.name = "extent-b", .kind = OPTION_NUMBER, FIELD(extent_b), .standard = 0,
     RANGE(1, INT32_MAX), .archs = EXACT, .needs = "extent-a", .tag = "-b%s", .argument = "LSB",
     .decides = true,
     .help = "largest AABB side of a triangle of B, in LSB (default: no limit; needs --extent-a)"},
    {.name = "early-out", .kind = OPTION_CHOICE, FIELD(early_out), CHOICES(early_names),
     .archs = EXACT, .tag = "-%s", .argument = "HOW", .decides = true,
     .help = "boxes: put an AABB test before the core; the core idles for pairs that the test "
             "decides, which saves energy; none (default): no such test"},
    {.name = "registered-ready", .kind = OPTION_SWITCH, FIELD(registered_ready),
     CHOICES(switch_names), .archs = EXACT, .tag = "-rr", .argument = "on|off",
     .help = "put a skid buffer before the core, so that in_ready comes from a register and no "
             "input reaches it in the same cycle (default off; a core for an FPGA always has it)"},
    {.name = "clock-gating", .kind = OPTION_SWITCH, FIELD(clock_gating), CHOICES(switch_names),
     .archs = EXACT, .tag = "-cg", .argument = "on|off",
     .help = "add enables to the registers of the core. The enables follow each pair through the "
             "pipeline, so registers without a pair stand still and synthesis can gate their "
             "clocks (default off)"},
    {.name = "clearance", .kind = OPTION_NUMBER, FIELD(clearance), .standard = -1,
     RANGE(0, INT32_MAX), .archs = EXACT, .tag = "-c%s", .argument = "LSB", .decides = true,
     .help = "call a pair free only if the real triangles, before they were rounded to LSB, are "
             "farther apart than this distance (default: none)"},
    {.name = "warning", .kind = OPTION_NUMBER, FIELD(warning), .standard = 0, RANGE(1, INT32_MAX),
     .archs = EXACT, .needs = "clearance", .tag = "-d%s", .argument = "LSB", .decides = true,
     .help = "a second, larger clearance: a pair that is free at --clearance, but not at this "
             "distance, gets band 1 (warning) instead of band 0 (free) (default: none; needs "
             "--clearance)"},
    {.name = "stream", .kind = OPTION_CHOICE, FIELD(stream), CHOICES(stream_names), .archs = EXACT,
     .tag = "-%s", .argument = "WORDS",
     .help = "put AXI4-Stream around the core. One transfer carries a vertex (128 bits), a "
             "triangle (512) or a pair (1024); verdicts have 32 bits and come in order. none "
             "(default): no stream"},
    {.name = "tag", .kind = OPTION_NUMBER, FIELD(tag), .standard = 16, RANGE(1, 64),
     .archs = EXACT, .shown = true, .needs = "stream", .tag = "-t%s", .argument = "BITS",
     .help = "bits of the tag (TUSER) that a pair passes on to its verdict, 1 ... 64 (default 16; "
             "needs --stream)"},
    {.name = "lanes", .kind = OPTION_NUMBER, FIELD(lanes), .standard = 0,
     RANGE(1, SEPAX_LANES_MAX), .archs = EXACT, .tag = "-k%s", .argument = "K",
     .help = "build an object engine around the core. The engine holds two objects in memories and "
             "selects pairs with K comparator lanes, 1 ... 64 (default: no engine)"},
    {.name = "tree", .kind = OPTION_SWITCH, FIELD(tree), CHOICES(switch_names), .archs = EXACT,
     .tag = "-tree", .argument = "on|off", .decides = true,
     .help = "build a tree engine around the core; it reads bodies as trees from external memory "
             "and takes poses (default off)"},
    {.name = "cores", .kind = OPTION_NUMBER, FIELD(cores), .standard = 1,
     RANGE(1, SEPAX_CORES_MAX), .archs = EXACT, .shown = true, .needs = "lanes|tree", .tag = "x%s",
     .argument = "N",
     .help = "cores of the engine, 1 ... 8 (default 1; needs --lanes or --tree)"},
    {.name = "memory-a", .kind = OPTION_NUMBER, FIELD(memory_a), .standard = 512,
     RANGE(SEPAX_MEMORY_MIN, SEPAX_MEMORY_MAX), .archs = EXACT, .shown = true, .needs = "lanes",
     .tag = "-ma%s", .argument = "TRIANGLES",
     .help = "triangles of A that the object engine holds, a power of two, 128 ... 32768 (default "
             "512; needs --lanes)"},
    {.name = "memory-b", .kind = OPTION_NUMBER, FIELD(memory_b), .standard = 512,
     RANGE(SEPAX_MEMORY_MIN, SEPAX_MEMORY_MAX), .archs = EXACT, .shown = true, .needs = "lanes",
     .tag = "-mb%s", .argument = "TRIANGLES",
     .help = "triangles of B that the object engine holds, a power of two, 128 ... 32768 (default "
             "512; needs --lanes)"},
    {.name = "leaves", .kind = OPTION_NUMBER, FIELD(leaves), .standard = 16,
     RANGE(SEPAX_LEAVES_MIN, SEPAX_LEAVES_MAX), .archs = EXACT, .needs = "tree", .tag = "-l%s",
     .argument = "N",
     .help = "leaves of each body that the tree engine holds, a power of two, 8 ... 32 (default "
             "16; needs --tree)"},
    {.name = "rows", .kind = OPTION_NUMBER, FIELD(rows), .standard = 128,
     RANGE(SEPAX_ROWS_MIN, SEPAX_ROWS_MAX), .archs = EXACT, .needs = "tree", .tag = "-r%s",
     .argument = "N",
     .help = "rows that wait in the tree engine, a power of two, 64 ... 256 (default 128; needs "
             "--tree)"},
    {.name = "precision", .kind = OPTION_PRECISION, FIELD(guard), .standard = -1,
     RANGE(-1, 2 * SEPAX_WORD_MAX + 3), .archs = PUBLISHED, .named = PUBLISHED, .shown = true,
     .tag = "-%s", .argument = "BITS", .decides = true,
     .help = "bits kept of each intermediate result. full (default) keeps all bits, word keeps W "
             "bits, and guard=G keeps W + G bits, where G = 0 ... 2 W + 3"},
    {.name = "block-float", .kind = OPTION_SWITCH, FIELD(block_float), CHOICES(switch_names),
     .archs = PUBLISHED, .shown = true, .tag = "-bf", .argument = "on|off", .decides = true,
     .help = "before truncation, shift the three components of an axis left by the same number of "
             "bits (default off)"},
    {.name = "coplanarity", .kind = OPTION_CHOICE, FIELD(coplanarity), CHOICES(coplanarity_names),
     .archs = PUBLISHED, .shown = true, .tag = "-cop", .argument = "TEST", .decides = true,
     .help = "how a pair is tested for coplanarity, where A_k and B_k are vertices and N_A and N_B "
             "are normals. plane (default) tests B_k.N_A = A_k.N_A; paper tests A_k.N_A = "
             "B_k.N_B, which is what the paper prints"},
    {.name = "inequality", .kind = OPTION_CHOICE, FIELD(inequality), CHOICES(inequality_names),
     .archs = PUBLISHED, .shown = true, .tag = "-ineq", .argument = "FORM", .decides = true,
     .help = "form of inequality (5) in the published paper. correct (default): max A < min B; "
             "printed: max A > min B, as the paper prints the inequality"},
    {.name = "epsilon", .kind = OPTION_NUMBER, FIELD(epsilon), .standard = PAPER_EPSILON,
     RANGE(0, INT32_MAX), .archs = PUBLISHED, .shown = true, .tag = "-e%s", .argument = "LSB",
     .decides = true,
     .help = "tolerance of the test of coplanarity, in LSB (default 1; 0 means equality)"},
};
/* clang-format on */

const design_option *sepax__design_option_at(size_t i) {
  return i < sizeof table / sizeof table[0] ? &table[i] : NULL;
}
