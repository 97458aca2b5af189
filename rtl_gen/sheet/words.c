/* SPDX-License-Identifier: MIT */
/* words.c - see words.h. */
#include "sheet/words.h"

bool words_has_engine(const sepax_design *d) { return d->config.lanes > 0 || d->config.tree; }

double words_clock(const sepax_design *d) {
  const double of_conference = 2.5;
  return d->config.arch == SEPAX_ARCH_CONFERENCE ? of_conference : d->config.clock_ps / 1000.0;
}

double words_pairs(const sepax_design *d, double through_core) {
  const int transfers = sepax_stream_transfers(&d->config);
  const double most = transfers > 0 ? 1e9 / words_clock(d) / transfers : through_core;
  return most < through_core ? most : through_core;
}

static bool is_exact(const sepax_design *d) { return d->config.arch == SEPAX_ARCH_EXACT; }

const char *words_title(const sepax_design *d) {
  const sepax_config *c = &d->config;
  return c->tree         ? "collisions of two meshes in many poses"
         : c->lanes > 0  ? "collisions of two meshes"
         : !is_exact(d)  ? "collision test of two triangles, as published"
         : d->limits > 0 ? "clearance test of two triangles"
                         : "exact collision test of two triangles";
}

void words_purpose(const sepax_design *d, page *p) {
  const sepax_config *c = &d->config;
  if (c->tree) {
    page_text(p, "The block finds the triangles of two meshes that collide. It reads the meshes as "
                 "trees from external memory, and takes a list of jobs and poses. The registers "
                 "are on AXI4-Lite, the memory on AXI4, and the results on AXI4-Stream.");
  } else if (c->lanes > 0) {
    page_text(p,
              "The block finds the triangles of two meshes that collide. It holds up to %d and %d "
              "triangles in its memories; %d comparator lanes select the pairs for the core. The "
              "registers are on AXI4-Lite; the meshes come and the results leave on AXI4-Stream.",
              c->memory_a, c->memory_b, c->lanes);
  } else {
    page_text(p,
              "The block tells whether two triangles in space share a point%s. The coordinates are "
              "signed integers of %d bits.",
              d->limits > 0 ? ", and whether they are nearer than a clearance" : "", c->word);
  }
}

void words_exactness(const sepax_design *d, page *p) {
  const sepax_config *c = &d->config;
  if (!is_exact(d)) {
    page_text(p,
              "The block computes what the published architecture computes, bit for bit. It takes "
              "unit normals, which are rounded, so its verdict can be wrong. "
              "`docs/reference/%s.md` of sepax has the formats and the causes.",
              sepax_arch_name(c->arch));
    return;
  }
  if (d->limits > 0) {
    page_text(p,
              "The band `free` is certain: the real triangles, of which each coordinate may differ "
              "by 1/2 LSB from the number given, are farther apart than %d LSB. Pairs that are "
              "somewhat farther apart may be called nearer. `docs/reference/clearance.md` of sepax "
              "has the proof.",
              c->warning > 0 ? c->warning : c->clearance);
  } else {
    page_text(p,
              "The verdict is the mathematical one for every %s: there is no rounding and no "
              "tolerance. Triangles that touch collide. Triangles without area are allowed. "
              "`docs/reference/exact.md` of sepax has the proof.",
              c->flag || c->extent_a > 0 ? "pair that is decided" : "input");
  }
  if (c->flag) {
    page_text(p, "Pairs in one plane are not decided: they are called collisions and flagged as "
                 "coplanar.");
  }
  if (c->extent_a > 0) {
    page_text(p,
              "The core is made for triangles up to %d LSB (A) and %d LSB (B) along each axis. If "
              "the bounding boxes of a pair overlap and a triangle is larger, then the pair is not "
              "decided: it is called a collision and flagged as out of range.",
              c->extent_a, c->extent_b);
  }
}

/* The bits of m_axis_tdata. */
static void put_data(const sepax_design *d, page *p) {
  page_table(p, "bits of `m_axis_tdata`\tmeaning");
  page_row(p, "0\tcollision");
  page_row(p, "1\tcoplanar: all six vertices are in one plane");
  page_row(p, "2\tnot decided, called a collision%s",
           d->config.word < 32 || d->config.extent_a > 0 ? ": a number is out of range, or bit 3"
                                                         : ": bit 3");
  page_row(p, "3\tTLAST cut the pair short");
  if (d->limits > 0) {
    page_row(p, "5:4\tband: 0 free, 1 warning, 2 collision");
  }
  page_row(p, "11:8\taxis");
  page_row(p, "others\t0");
  page_table_end(p);
}

/* As sepax_results.v sends them. */
static void put_results(page *p) {
  page_section(p, "Results");
  page_table(p, "bits of `m_axis_tdata`\ta pair\tthe end, with TLAST");
  page_row(p, "31:0\tnumber of the triangle in A\tresults before it");
  page_row(p, "55:32\tnumber of the triangle in B\t0");
  page_row(p, "56\tcoplanar: all six vertices are in one plane\t0");
  page_row(p, "57\tout of range: not decided, called a collision\t0");
  page_row(p, "58\twarning: no collision, but nearer than the warning\t0");
  page_row(p, "62\t0\tthe run was stopped");
  page_row(p, "63\t0\t1");
  page_row(p, "others\t0\t0");
  page_table_end(p);
}

void words_verdict(const sepax_design *d, page *p) {
  const bool stream = d->config.stream != SEPAX_STREAM_NONE;
  if (d->config.lanes > 0) {
    put_results(p);
  }
  if (!is_exact(d) || words_has_engine(d)) {
    return;
  }
  page_section(p, "Verdict");
  if (stream) {
    put_data(d, p);
  }
  page_table(p, stream ? "axis\tmeaning" : "`out_axis`\tmeaning");
  page_row(p, "0\tno axis separates: a collision");
  page_row(
      p,
      "1 + 3 i + j\tthe cross product of edge i of A and edge j of B separates; edge i goes from "
      "vertex i + 1 to the next one; i, j = 0, 1, 2");
  page_row(p, "10\tthe normal of A separates");
  page_row(p, "11\tthe normal of B separates");
  if (d->limits > 0) {
    page_row(p, "12\tan axis normal to an edge separates");
  } else if (!d->config.flag) {
    page_row(p, "12\tan axis in the common plane separates");
  }
  if (d->aabb_test || d->limits > 0) {
    page_row(p, "13\tthe bounding boxes are disjoint");
  }
  if (d->config.extent_a > 0 || stream) {
    page_row(p, "14\tout of range: not decided, called a collision");
  }
  page_table_end(p);
}

void words_handshake(const sepax_design *d, page *p) {
  const sepax_config *c = &d->config;
  if (!is_exact(d)) {
    page_text(p, "A pair takes three words, with or without gaps. Nothing can be stopped: the "
                 "verdict comes a fixed number of cycles after the first word, if the words came "
                 "without gaps. The outputs are 0 without `out_valid`.");
  } else if (words_has_engine(d)) {
    page_text(p, "Registers are accessed by AXI4-Lite, 32 bits at a time. Accesses to other "
                 "addresses are answered with SLVERR.");
  } else if (c->stream != SEPAX_STREAM_NONE) {
    page_text(p, "A transfer takes place in each cycle in which TVALID and TREADY are 1. The tag "
                 "(TUSER) and TLAST of the last transfer of a pair leave with its verdict. "
                 "`s_axis_tready` comes from a register.");
  } else {
    page_text(p,
              "A pair is taken in each cycle in which `in_valid` and `in_ready` are 1. A verdict "
              "stays until `out_ready` is 1. Verdicts leave in the order of the pairs. The "
              "outputs are 0 without `out_valid`.");
  }
  page_text(p,
            "All registers use the rising edge of the clock. The reset is synchronous, active %s, "
            "and one cycle is enough. It drops what is in flight.",
            words_has_engine(d) || c->stream != SEPAX_STREAM_NONE ? "low" : "high");
}
