/* SPDX-License-Identifier: MIT */
/* boxes.h - boxes in a pose, each against the eight boxes of a node (private; query.c includes it
 * once for each instruction set). Beyond the macros of util/simd.h:
 *
 * SIMD_NODES                       nodes at once, each with a box in a pose: 1 or 2
 * SIMD_MADD(p, q, r)               p q + r, which may be rounded once
 * SIMD_LOAD(v, node, member, n)    v becomes member[n] and what follows, of the nodes
 * SIMD_OF(p, member)               the member of the boxes in a pose, in the lanes of their nodes
 * SIMD_BOOL                        a set of lanes, as comparisons give it; SIMD_BITS is of that
 * SIMD_SEPARATE(mask, p, q)        put the lanes where |p| > q into the mask
 * SIMD_SIGNS(v)                    the sign bits of a vector of int32_t as a number */

typedef float SIMD_NAME(floats) __attribute__((vector_size(4 * SIMD_FLOATS)));
typedef int32_t SIMD_NAME(masks) __attribute__((vector_size(4 * SIMD_FLOATS)));

#define SIMD_SIZE(v) ((SIMD_FLOAT)((SIMD_MASK)(v)&INT32_MAX))
#define SIMD_DOT(p, q) SIMD_MADD((p)[0], (q)[0], SIMD_MADD((p)[1], (q)[1], (p)[2] * (q)[2]))

/* The children of nodes and one posed box for each node: the offset of the centres, and the cosines
 * between axis i of the children and axis k of the box. All are in coordinates along the axes of
 * the children. */
typedef struct {
  SIMD_FLOAT along[3], half[3], own_half[3], cosine[3][3], size[3][3];
} SIMD_NAME(facing);

SIMD_INLINE SIMD_BOOL SIMD_NAME(face_axes_separate)(SIMD_NAME(facing) * f,
                                                    const body_boxes *const node[SIMD_NODES], int n,
                                                    const posed_box *const p[SIMD_NODES]) {
  SIMD_FLOAT t[3];
  SIMD_BOOL disjoint = {0};
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_LOAD(t[i], node, centre[i], n);
    t[i] = SIMD_OF(p, centre[i]) - t[i] + SIMD_OF(p, rest[i]);
    f->own_half[i] = SIMD_OF(p, half[i]);
  }
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_FLOAT axis[3];
    SIMD_UNROLL for (int j = 0; j < 3; j++) { SIMD_LOAD(axis[j], node, axis[i][j], n); }
    SIMD_LOAD(f->half[i], node, half[i], n);
    f->along[i] = SIMD_DOT(axis, t);
    SIMD_FLOAT reach = f->half[i];
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      SIMD_FLOAT cosine = axis[2] * SIMD_OF(p, axis[k][2]);
      cosine = SIMD_MADD(axis[1], SIMD_OF(p, axis[k][1]), cosine);
      cosine = SIMD_MADD(axis[0], SIMD_OF(p, axis[k][0]), cosine);
      f->cosine[i][k] = cosine;
      f->size[i][k] = SIMD_SIZE(f->cosine[i][k]);
      reach = SIMD_MADD(f->size[i][k], f->own_half[k], reach);
    }
    SIMD_SEPARATE(disjoint, f->along[i], reach);
  }
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    SIMD_FLOAT at = f->along[0] * f->cosine[0][k];
    SIMD_FLOAT reach = SIMD_MADD(f->half[0], f->size[0][k], f->own_half[k]);
    SIMD_UNROLL for (int i = 1; i < 3; i++) {
      at = SIMD_MADD(f->along[i], f->cosine[i][k], at);
      reach = SIMD_MADD(f->half[i], f->size[i][k], reach);
    }
    SIMD_SEPARATE(disjoint, at, reach);
  }
  return disjoint;
}

SIMD_INLINE SIMD_BOOL SIMD_NAME(edge_axes_separate)(const SIMD_NAME(facing) * f) {
  const SIMD_FLOAT *half = f->half;
  const SIMD_FLOAT *own = f->own_half;
  SIMD_FLOAT slack = (half[0] + half[1] + half[2] + (own[0] + own[1] + own[2])) * BOX_SLACK;
  SIMD_BOOL disjoint = {0};
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    int i1 = next[i];
    int i2 = next[i1];
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      int k1 = next[k];
      int k2 = next[k1];
      SIMD_FLOAT at = SIMD_MADD(f->along[i2], f->cosine[i1][k], -f->along[i1] * f->cosine[i2][k]);
      SIMD_FLOAT reach = SIMD_MADD(half[i1], f->size[i2][k], slack);
      reach = SIMD_MADD(half[i2], f->size[i1][k], reach);
      reach = SIMD_MADD(f->size[i][k2], own[k1], reach);
      reach = SIMD_MADD(f->size[i][k1], own[k2], reach);
      SIMD_SEPARATE(disjoint, at, reach);
    }
  }
  return disjoint;
}

/* Bit 8 m + k stands for child k of node m: children that may meet the boxes, and children that are
 * triangles. */
typedef struct {
  uint32_t overlaps, triangles;
} SIMD_NAME(children);

SIMD_INLINE SIMD_NAME(children) SIMD_NAME(compare)(const body_boxes *const node[SIMD_NODES],
                                                   const posed_box *const p[SIMD_NODES]) {
  SIMD_NAME(children) bits = {0, 0};
  const uint32_t all = (1U << SIMD_FLOATS) - 1;
  for (int n = 0; n < SIMD_NODES * BODY_WIDE; n += SIMD_FLOATS) {
    SIMD_NAME(facing) f;
    SIMD_FLOAT child;
    SIMD_LOAD(child, node, child, n);
    SIMD_BOOL disjoint = SIMD_NAME(face_axes_separate)(&f, node, n, p);
    bits.triangles |= SIMD_SIGNS((SIMD_MASK)child) << n;
    if (SIMD_BITS(disjoint) != all) {
      disjoint |= SIMD_NAME(edge_axes_separate)(&f);
      bits.overlaps |= (~(SIMD_BITS(disjoint) | SIMD_SIGNS((SIMD_MASK)child == -1)) & all) << n;
    }
  }
  return bits;
}

SIMD_TARGET static void SIMD_NAME(compare_boxes)(box_task *t, int count) {
  posed_box p[AT_ONCE];
  for (int n = 0; n < count; n++) {
    turn_box(&p[n], t[n].move, t[n].from, t[n].lane);
  }
  for (int n = 0; n < count; n += SIMD_NODES) {
    int last = n + SIMD_NODES <= count ? n + SIMD_NODES - 1 : n;
    const body_boxes *node[] = {t[n].node, t[last].node};
    const posed_box *own[] = {&p[n], &p[last]};
    SIMD_NAME(children) bits = SIMD_NAME(compare)(node, own);
    const int high = (SIMD_NODES - 1) * BODY_WIDE;
    t[last].boxes = (bits.overlaps & ~bits.triangles) >> high;
    t[last].triangles = (bits.overlaps & bits.triangles) >> high;
    t[n].boxes = bits.overlaps & ~bits.triangles & 0xff;
    t[n].triangles = bits.overlaps & bits.triangles & 0xff;
  }
}

#undef SIMD_NAME
#undef SIMD_TARGET
#undef SIMD_LOAD
#undef SIMD_OF
#undef SIMD_SIZE
#undef SIMD_DOT
#undef SIMD_MADD
#undef SIMD_BOOL
#undef SIMD_SEPARATE
#undef SIMD_BITS
#undef SIMD_SIGNS
#undef SIMD_FLOATS
#undef SIMD_NODES
