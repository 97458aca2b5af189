/* boxes.h - boxes in a pose, each against the eight boxes of a node (private; query.c includes it
 * once per instruction set).
 *
 * NAME(x), TARGET   a name of its own, the attribute of its functions
 * FLOATS            boxes of nodes at once
 * NODES             nodes at once, for each of which there is a box in a pose: 1 or 2
 * MADD(p, q, r)     p q + r, which may be rounded once
 * LOAD(v, node, member, n)   from member[n] of the nodes on
 * OF(p, member)     the member of the boxes in a pose, in the lanes of their nodes
 * MASK, SEPARATE(mask, p, q), BITS(mask)   bits of lanes, of which those where |p| > q are set
 * SIGNS(v)          sign bits of int32_t lanes */

typedef float NAME(floats) __attribute__((vector_size(4 * FLOATS)));
typedef int32_t NAME(masks) __attribute__((vector_size(4 * FLOATS)));

#define F NAME(floats)
#define M NAME(masks)
#define INLINE TARGET static inline __attribute__((always_inline))

#define SIZE(v) ((F)((M)(v)&INT32_MAX))
#define DOT(p, q) MADD((p)[0], (q)[0], MADD((p)[1], (q)[1], (p)[2] * (q)[2]))

/* Children of nodes and a posed box for each node: offset of the centres, and the cosines between
 * axes i of the children and k of the box, on the axes of the children. */
typedef struct {
  F along[3], half[3], own_half[3], cosine[3][3], size[3][3];
} NAME(facing);

INLINE MASK NAME(face_axes_separate)(NAME(facing) * f, const body_boxes *const node[NODES], int n,
                                     const posed_box *const p[NODES]) {
  F t[3];
  MASK disjoint = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    LOAD(t[i], node, centre[i], n);
    t[i] = OF(p, centre[i]) - t[i] + OF(p, rest[i]);
    f->own_half[i] = OF(p, half[i]);
  }
  UNROLL for (int i = 0; i < 3; i++) {
    F axis[3];
    UNROLL for (int j = 0; j < 3; j++) { LOAD(axis[j], node, axis[i][j], n); }
    LOAD(f->half[i], node, half[i], n);
    f->along[i] = DOT(axis, t);
    F reach = f->half[i];
    UNROLL for (int k = 0; k < 3; k++) {
      F cosine = axis[2] * OF(p, axis[k][2]);
      cosine = MADD(axis[1], OF(p, axis[k][1]), cosine);
      cosine = MADD(axis[0], OF(p, axis[k][0]), cosine);
      f->cosine[i][k] = cosine;
      f->size[i][k] = SIZE(f->cosine[i][k]);
      reach = MADD(f->size[i][k], f->own_half[k], reach);
    }
    SEPARATE(disjoint, f->along[i], reach);
  }
  UNROLL for (int k = 0; k < 3; k++) {
    F at = f->along[0] * f->cosine[0][k];
    F reach = MADD(f->half[0], f->size[0][k], f->own_half[k]);
    UNROLL for (int i = 1; i < 3; i++) {
      at = MADD(f->along[i], f->cosine[i][k], at);
      reach = MADD(f->half[i], f->size[i][k], reach);
    }
    SEPARATE(disjoint, at, reach);
  }
  return disjoint;
}

INLINE MASK NAME(edge_axes_separate)(const NAME(facing) * f) {
  const F *half = f->half;
  const F *own = f->own_half;
  F slack = (half[0] + half[1] + half[2] + (own[0] + own[1] + own[2])) * BOX_SLACK;
  MASK disjoint = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    int i1 = next[i];
    int i2 = next[i1];
    UNROLL for (int k = 0; k < 3; k++) {
      int k1 = next[k];
      int k2 = next[k1];
      F at = MADD(f->along[i2], f->cosine[i1][k], -f->along[i1] * f->cosine[i2][k]);
      F reach = MADD(half[i1], f->size[i2][k], slack);
      reach = MADD(half[i2], f->size[i1][k], reach);
      reach = MADD(f->size[i][k2], own[k1], reach);
      reach = MADD(f->size[i][k1], own[k2], reach);
      SEPARATE(disjoint, at, reach);
    }
  }
  return disjoint;
}

/* Children that may meet the boxes, and that are triangles: bit 8 m + k of child k of node m. */
typedef struct {
  uint32_t overlaps, triangles;
} NAME(children);

INLINE NAME(children)
    NAME(compare)(const body_boxes *const node[NODES], const posed_box *const p[NODES]) {
  NAME(children) bits = {0, 0};
  const uint32_t all = (1U << FLOATS) - 1;
  for (int n = 0; n < NODES * BODY_WIDE; n += FLOATS) {
    NAME(facing) f;
    F child;
    LOAD(child, node, child, n);
    MASK disjoint = NAME(face_axes_separate)(&f, node, n, p);
    bits.triangles |= SIGNS((M)child) << n;
    if (BITS(disjoint) != all) {
      disjoint |= NAME(edge_axes_separate)(&f);
      bits.overlaps |= (~(BITS(disjoint) | SIGNS((M)child == -1)) & all) << n;
    }
  }
  return bits;
}

TARGET static void NAME(compare_boxes)(box_task *t, int count) {
  posed_box p[AT_ONCE];
  for (int n = 0; n < count; n++) {
    turn_box(&p[n], t[n].move, t[n].from, t[n].lane);
  }
  for (int n = 0; n < count; n += NODES) {
    int last = n + NODES <= count ? n + NODES - 1 : n;
    const body_boxes *node[] = {t[n].node, t[last].node};
    const posed_box *own[] = {&p[n], &p[last]};
    NAME(children) bits = NAME(compare)(node, own);
    const int high = (NODES - 1) * BODY_WIDE;
    t[last].boxes = (bits.overlaps & ~bits.triangles) >> high;
    t[last].triangles = (bits.overlaps & bits.triangles) >> high;
    t[n].boxes = bits.overlaps & ~bits.triangles & 0xff;
    t[n].triangles = bits.overlaps & bits.triangles & 0xff;
  }
}

#undef F
#undef M
#undef INLINE
#undef NAME
#undef TARGET
#undef LOAD
#undef OF
#undef SIZE
#undef DOT
#undef MADD
#undef MASK
#undef SEPARATE
#undef BITS
#undef SIGNS
#undef FLOATS
#undef NODES
