/* boxes.h - boxes in a pose, each against the eight boxes of a node (private; query.c includes it
 * once per instruction set).
 *
 * NAME(x), TARGET   a name of its own, the attribute of its functions
 * FLOATS            boxes at once
 * MADD(p, q, r), ALL(x)  p q + r, which may be rounded once; the number in all lanes
 * BITS(v)           sign bits of int32_t lanes */

typedef float NAME(floats) __attribute__((vector_size(4 * FLOATS)));
typedef int32_t NAME(masks) __attribute__((vector_size(4 * FLOATS)));

#define F NAME(floats)
#define M NAME(masks)
#define INLINE TARGET static inline __attribute__((always_inline))

#define LOAD(v, from) memcpy(&(v), from, sizeof(v))
#define SIZE(v) ((F)((M)(v)&INT32_MAX))
#define DOT(p, q) MADD((p)[0], (q)[0], MADD((p)[1], (q)[1], (p)[2] * (q)[2]))

/* The eight children of a node and one posed box: offset of the centres, and the cosines between
 * axes i of the children and k of the box, on the axes of the children. */
typedef struct {
  F along[3], half[3], cosine[3][3], size[3][3];
} NAME(facing);

INLINE M NAME(face_axes_separate)(NAME(facing) * f, const body_boxes *node, int n,
                                  const posed_box *p) {
  F t[3];
  M disjoint = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    LOAD(t[i], node->centre[i] + n);
    t[i] = p->centre[i] - t[i] + p->rest[i];
  }
  UNROLL for (int i = 0; i < 3; i++) {
    F axis[3];
    UNROLL for (int j = 0; j < 3; j++) { LOAD(axis[j], node->axis[i][j] + n); }
    LOAD(f->half[i], node->half[i] + n);
    f->along[i] = DOT(axis, t);
    F reach = f->half[i];
    UNROLL for (int k = 0; k < 3; k++) {
      F cosine = axis[2] * p->axis[k][2];
      cosine = MADD(axis[1], ALL(p->axis[k][1]), cosine);
      cosine = MADD(axis[0], ALL(p->axis[k][0]), cosine);
      f->cosine[i][k] = cosine;
      f->size[i][k] = SIZE(f->cosine[i][k]);
      reach = MADD(f->size[i][k], ALL(p->half[k]), reach);
    }
    disjoint |= SIZE(f->along[i]) > reach;
  }
  UNROLL for (int k = 0; k < 3; k++) {
    F at = f->along[0] * f->cosine[0][k];
    F reach = MADD(f->half[0], f->size[0][k], ALL(p->half[k]));
    UNROLL for (int i = 1; i < 3; i++) {
      at = MADD(f->along[i], f->cosine[i][k], at);
      reach = MADD(f->half[i], f->size[i][k], reach);
    }
    disjoint |= SIZE(at) > reach;
  }
  return disjoint;
}

INLINE M NAME(edge_axes_separate)(const NAME(facing) * f, const posed_box *p) {
  F slack =
      (f->half[0] + f->half[1] + f->half[2] + (p->half[0] + p->half[1] + p->half[2])) * BOX_SLACK;
  M disjoint = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    int i1 = next[i];
    int i2 = next[i1];
    UNROLL for (int k = 0; k < 3; k++) {
      int k1 = next[k];
      int k2 = next[k1];
      F at = MADD(f->along[i2], f->cosine[i1][k], -f->along[i1] * f->cosine[i2][k]);
      F reach = MADD(f->half[i1], f->size[i2][k], slack);
      reach = MADD(f->half[i2], f->size[i1][k], reach);
      reach = MADD(f->size[i][k2], ALL(p->half[k1]), reach);
      reach = MADD(f->size[i][k1], ALL(p->half[k2]), reach);
      disjoint |= SIZE(at) > reach;
    }
  }
  return disjoint;
}

/* Bit k: child k of the node may meet the box. */
INLINE uint32_t NAME(overlaps)(const body_boxes *node, const posed_box *p) {
  uint32_t bits = 0;
  for (int n = 0; n < BODY_WIDE; n += FLOATS) {
    NAME(facing) f;
    M disjoint = NAME(face_axes_separate)(&f, node, n, p);
    if (BITS(disjoint) != (1U << FLOATS) - 1) {
      disjoint |= NAME(edge_axes_separate)(&f, p);
      bits |= (~BITS(disjoint) & ((1U << FLOATS) - 1)) << n;
    }
  }
  return bits;
}

TARGET static void NAME(test_boxes)(box_test *t, int count) {
  posed_box p[AT_ONCE];
  for (int n = 0; n < count; n++) {
    turn_box(&p[n], t[n].move, t[n].from, t[n].lane);
  }
  for (int n = 0; n < count; n++) {
    t[n].overlaps = NAME(overlaps)(t[n].node, &p[n]);
  }
}

#undef F
#undef M
#undef INLINE
#undef NAME
#undef TARGET
#undef LOAD
#undef SIZE
#undef DOT
#undef MADD
#undef ALL
#undef BITS
#undef FLOATS
