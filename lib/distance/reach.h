/* SPDX-License-Identifier: MIT */
/* reach.h - how near boxes and pairs of triangles come to each other (private; bounds.c includes it
 * once for each instruction set). It needs the macros of util/simd.h, SIMD_BITS of a vector of
 * int32_t. */

typedef float SIMD_NAME(floats) __attribute__((vector_size(4 * SIMD_FLOATS)));
typedef int32_t SIMD_NAME(masks) __attribute__((vector_size(4 * SIMD_FLOATS)));
typedef double SIMD_NAME(reals) __attribute__((vector_size(8 * SIMD_LANES)));
typedef int64_t SIMD_NAME(lanes) __attribute__((vector_size(8 * SIMD_LANES)));

#define SIMD_LOAD(v, from) memcpy(&(v), from, sizeof(v))
#define SIMD_STORE(to, v) memcpy(to, &(v), sizeof(v))
#define SIMD_SIZE(v) ((SIMD_FLOAT)((SIMD_MASK)(v)&INT32_MAX))

/* v where it is positive, otherwise 0, also for NaN. */
SIMD_INLINE SIMD_FLOAT SIMD_NAME(positive)(SIMD_FLOAT v) {
  return (SIMD_FLOAT)((SIMD_MASK)v & (v > 0));
}

SIMD_INLINE SIMD_FLOAT SIMD_NAME(most_of)(SIMD_FLOAT p, SIMD_FLOAT q) {
  SIMD_MASK second = q > p;
  return (SIMD_FLOAT)(((SIMD_MASK)q & second) | ((SIMD_MASK)p & ~second));
}

/* What a box, or the triangle in it, covers on an axis, from its centre: low ... high. cosine[k] is
 * that of the axis and axis k of the box.
 *
 * The triangle has two vertices at -half[0] and half[0] on axis 0 and at -half[1] on axis 1, the
 * third at `foot` and half[1]. Rounding moves the centre by up to 2^-11 of all three half sides
 * (body/fit.c). They are too long by as much, so that the box holds the triangle, and by 2^-14 of
 * all three; centre and half sides by m->lost, too. So the vertices may be farther out by 2^-10 and
 * 2^-14 of all three and 2 m->lost, less than `thick`. */
typedef struct {
  SIMD_FLOAT low, high;
} SIMD_NAME(range);

SIMD_INLINE SIMD_NAME(range) SIMD_NAME(covered)(const SIMD_FLOAT cosine[3], const posed_box *p,
                                                bool triangle, float foot, float lost) {
  SIMD_FLOAT across = SIMD_SIZE(cosine[0]) * p->half[0];
  SIMD_FLOAT thick = SIMD_SIZE(cosine[2]) * p->half[2];
  if (!triangle) {
    SIMD_FLOAT reach = across + SIMD_SIZE(cosine[1]) * p->half[1] + thick;
    return (SIMD_NAME(range)){-reach, reach};
  }
  thick += 0x1p-9F * (p->half[0] + p->half[1] + p->half[2]) + 2 * lost;
  SIMD_FLOAT up = cosine[1] * p->half[1];
  SIMD_FLOAT apex = cosine[0] * foot + up;
  return (SIMD_NAME(range)){-(SIMD_NAME(most_of)(across + up, -apex) + thick),
                            SIMD_NAME(most_of)(across - up, apex) + thick};
}

/* square[k]: not above the square of the distance of child k of a node from a box of the other
 * body, or from the triangle in it, in units of the node's body. The gaps on axes at right angles
 * to each other are the sides of a box between them; the way between the bodies is one more axis,
 * of length 1 or 0. Bit k: the square is at most with->most. Rounding: bounds.c. */
SIMD_INLINE uint32_t SIMD_NAME(bound_of)(const body_boxes *node, const facing *with,
                                         const body_boxes *from, uint32_t lane, bool triangle,
                                         float square[BODY_WIDE]) {
  const float *way = with->way;
  posed_box p;
  uint32_t bits = 0;
  turn_box(&p, with->motion, from, lane);
  float foot = with->motion->ratio * with->foot;
  SIMD_FLOAT on_way[3];
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    four_floats axis = p.axis[k];
    on_way[k] = (SIMD_FLOAT){0} + (axis[0] * way[0] + axis[1] * way[1] + axis[2] * way[2]);
  }
  const SIMD_NAME(range) own_way =
      SIMD_NAME(covered)(on_way, &p, triangle, foot, with->motion->lost);
  for (int n = 0; n < BODY_WIDE; n += SIMD_FLOATS) {
    SIMD_FLOAT t[3];
    SIMD_FLOAT at[3] = {{0}, {0}, {0}};
    SIMD_FLOAT reach[3];
    SIMD_FLOAT least[2] = {{0}, {0}};
    SIMD_FLOAT along_way = {0};
    SIMD_FLOAT way_reach = {0};
    SIMD_UNROLL for (int i = 0; i < 3; i++) {
      SIMD_LOAD(t[i], node->centre[i] + n);
      t[i] = p.centre[i] - t[i] + p.rest[i];
      reach[i] = (SIMD_FLOAT){0} + p.half[i];
      along_way += t[i] * way[i];
    }
    SIMD_FLOAT slack = (SIMD_SIZE(t[0]) + SIMD_SIZE(t[1]) + SIMD_SIZE(t[2])) * with->slack;
    SIMD_UNROLL for (int i = 0; i < 3; i++) {
      SIMD_FLOAT axis[3];
      SIMD_FLOAT cosine[3];
      SIMD_FLOAT half;
      SIMD_UNROLL for (int j = 0; j < 3; j++) { SIMD_LOAD(axis[j], node->axis[i][j] + n); }
      SIMD_LOAD(half, node->half[i] + n);
      SIMD_FLOAT along = axis[0] * t[0] + axis[1] * t[1] + axis[2] * t[2];
      way_reach += SIMD_SIZE(axis[0] * way[0] + axis[1] * way[1] + axis[2] * way[2]) * half;
      SIMD_UNROLL for (int k = 0; k < 3; k++) {
        cosine[k] = axis[0] * p.axis[k][0] + axis[1] * p.axis[k][1] + axis[2] * p.axis[k][2];
        reach[k] += SIMD_SIZE(cosine[k]) * half;
        at[k] += along * cosine[k];
      }
      SIMD_NAME(range) own = SIMD_NAME(covered)(cosine, &p, triangle, foot, with->motion->lost);
      SIMD_FLOAT away = SIMD_NAME(most_of)(along + own.low, -(along + own.high));
      SIMD_FLOAT gap = SIMD_NAME(positive)(away - half - slack);
      least[0] += gap * gap;
    }
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      SIMD_FLOAT gap = SIMD_NAME(positive)(SIMD_SIZE(at[k]) - reach[k] - slack);
      least[1] += gap * gap;
    }
    SIMD_FLOAT away = SIMD_NAME(most_of)(along_way + own_way.low, -(along_way + own_way.high));
    SIMD_FLOAT gap = SIMD_NAME(positive)(away - way_reach - slack);
    SIMD_FLOAT all = SIMD_NAME(most_of)(SIMD_NAME(most_of)(least[0], least[1]), gap * gap);
    SIMD_STORE(square + n, all);
    bits |= (~SIMD_BITS(all > with->most) & ((1U << SIMD_FLOATS) - 1)) << n;
  }
  return bits;
}

SIMD_TARGET static uint32_t SIMD_NAME(bound)(const body_boxes *node, const facing *with,
                                             const body_boxes *from, uint32_t lane,
                                             float square[BODY_WIDE]) {
  return isinf(with->foot) ? SIMD_NAME(bound_of)(node, with, from, lane, false, square)
                           : SIMD_NAME(bound_of)(node, with, from, lane, true, square);
}

/* ------------------------------------------------------------- pairs of triangles */

typedef struct {
  SIMD_REAL c[3];
} SIMD_NAME(vector);

#define SIMD_POINT SIMD_NAME(vector)

SIMD_INLINE SIMD_REAL SIMD_NAME(chosen)(SIMD_WHOLE which, SIMD_REAL p, SIMD_REAL q) {
  return (SIMD_REAL)(((SIMD_WHOLE)p & which) | ((SIMD_WHOLE)q & ~which));
}
SIMD_INLINE SIMD_REAL SIMD_NAME(greater)(SIMD_REAL p, SIMD_REAL q) {
  return SIMD_NAME(chosen)(p > q, p, q);
}
SIMD_INLINE SIMD_REAL SIMD_NAME(lesser)(SIMD_REAL p, SIMD_REAL q) {
  return SIMD_NAME(chosen)(p < q, p, q);
}

/* t limited to 0 ... most; 0 for NaN. */
SIMD_INLINE SIMD_REAL SIMD_NAME(limited)(SIMD_REAL t, SIMD_REAL most) {
  return SIMD_NAME(lesser)((SIMD_REAL)((SIMD_WHOLE)t & (t > 0)), most);
}

SIMD_INLINE SIMD_REAL SIMD_NAME(dot)(const SIMD_POINT *p, const SIMD_POINT *q) {
  return p->c[0] * q->c[0] + p->c[1] * q->c[1] + p->c[2] * q->c[2];
}

SIMD_INLINE SIMD_POINT SIMD_NAME(minus)(const SIMD_POINT *p, const SIMD_POINT *q) {
  return (SIMD_POINT){{p->c[0] - q->c[0], p->c[1] - q->c[1], p->c[2] - q->c[2]}};
}

SIMD_INLINE SIMD_POINT SIMD_NAME(cross)(const SIMD_POINT *p, const SIMD_POINT *q) {
  return (SIMD_POINT){{p->c[1] * q->c[2] - p->c[2] * q->c[1], p->c[2] * q->c[0] - p->c[0] * q->c[2],
                       p->c[0] * q->c[1] - p->c[1] * q->c[0]}};
}

/* p + s u - t v */
SIMD_INLINE SIMD_POINT SIMD_NAME(between)(const SIMD_POINT *p, SIMD_REAL s, const SIMD_POINT *u,
                                          SIMD_REAL t, const SIMD_POINT *v) {
  SIMD_POINT r;
  SIMD_UNROLL for (int i = 0; i < 3; i++) { r.c[i] = p->c[i] + s * u->c[i] - t * v->c[i]; }
  return r;
}

/* The shortest vector so far from a point of A to a point of B. */
typedef struct {
  SIMD_REAL square;
  SIMD_POINT way;
} SIMD_NAME(nearest);

SIMD_INLINE void SIMD_NAME(offer)(SIMD_NAME(nearest) * n, const SIMD_POINT *way) {
  SIMD_REAL square = SIMD_NAME(dot)(way, way);
  SIMD_WHOLE which = square < n->square;
  n->square = SIMD_NAME(chosen)(which, square, n->square);
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    n->way.c[i] = SIMD_NAME(chosen)(which, way->c[i], n->way.c[i]);
  }
}

typedef struct {
  SIMD_POINT v[3], e[3]; /* e[k]: from vertex k to the next */
  SIMD_REAL over[3];     /* 1 / e[k] . e[k] */
} SIMD_NAME(triangle);

SIMD_INLINE void SIMD_NAME(offer_edges)(SIMD_NAME(nearest) * n, const SIMD_NAME(triangle) * a,
                                        int i, const SIMD_NAME(triangle) * b, int j) {
  const SIMD_REAL one = (SIMD_REAL){0} + 1;
  const SIMD_POINT *u = &a->e[i];
  const SIMD_POINT *v = &b->e[j];
  SIMD_POINT d = SIMD_NAME(minus)(&b->v[j], &a->v[i]);
  SIMD_REAL uv = SIMD_NAME(dot)(u, v);
  SIMD_REAL du = SIMD_NAME(dot)(&d, u) * a->over[i];
  SIMD_REAL dv = SIMD_NAME(dot)(&d, v) * b->over[j];
  SIMD_REAL area = 1 - uv * uv * (a->over[i] * b->over[j]);
  SIMD_REAL s = SIMD_NAME(limited)((du - uv * dv * a->over[i]) / area, one);
  SIMD_REAL t = SIMD_NAME(limited)(s * uv * b->over[j] - dv, one);
  s = SIMD_NAME(limited)(t * uv * a->over[i] + du, one);
  SIMD_POINT way = SIMD_NAME(between)(&d, t, v, s, u);
  SIMD_NAME(offer)(n, &way);
}

/* The vertices of x and the face of f. With n = e_0 x e_2 the foot of f_0 + d is at e_0 times
 * d . (e_2 x n) / n . n less e_2 times d . (e_0 x n) / n . n. */
SIMD_INLINE void SIMD_NAME(offer_face)(SIMD_NAME(nearest) * n, const SIMD_NAME(triangle) * x,
                                       const SIMD_NAME(triangle) * f) {
  SIMD_POINT normal = SIMD_NAME(cross)(&f->e[0], &f->e[2]);
  SIMD_REAL over = 1 / SIMD_NAME(dot)(&normal, &normal);
  SIMD_POINT first = SIMD_NAME(cross)(&f->e[2], &normal);
  SIMD_POINT second = SIMD_NAME(cross)(&f->e[0], &normal);
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    SIMD_POINT d = SIMD_NAME(minus)(&x->v[k], &f->v[0]);
    SIMD_REAL s = SIMD_NAME(limited)(SIMD_NAME(dot)(&d, &first) * over, (SIMD_REAL){0} + 1);
    SIMD_REAL t = SIMD_NAME(limited)(SIMD_NAME(dot)(&d, &second) * over, 1 - s);
    SIMD_POINT way = SIMD_NAME(between)(&d, t, &f->e[2], s, &f->e[0]);
    SIMD_NAME(offer)(n, &way);
  }
}

/* The gap of the projections on a vector; 0 if there is none. */
SIMD_INLINE SIMD_REAL SIMD_NAME(gap_along)(const SIMD_POINT *way, const SIMD_NAME(triangle) * a,
                                           const SIMD_NAME(triangle) * b) {
  SIMD_REAL low[2];
  SIMD_REAL high[2];
  SIMD_UNROLL for (int k = 0; k < 6; k++) {
    SIMD_REAL t = SIMD_NAME(dot)(way, k < 3 ? &a->v[k] : &b->v[k - 3]);
    low[k / 3] = k % 3 == 0 ? t : SIMD_NAME(lesser)(t, low[k / 3]);
    high[k / 3] = k % 3 == 0 ? t : SIMD_NAME(greater)(t, high[k / 3]);
  }
  return SIMD_NAME(greater)(SIMD_NAME(greater)(low[1] - high[0], low[0] - high[1]), (SIMD_REAL){0});
}

/* Load and pose the triangles: coordinate i of vertex k of pair n is from[(3 k + i) SIMD_LANES +
 * n]. */
SIMD_INLINE void SIMD_NAME(place)(SIMD_NAME(triangle) * t, const double *from,
                                  const world_pose *pose) {
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    SIMD_REAL x[3];
    SIMD_UNROLL for (int i = 0; i < 3; i++) { SIMD_LOAD(x[i], from + (3 * k + i) * SIMD_LANES); }
    SIMD_UNROLL for (int i = 0; i < 3; i++) {
      const double *row = pose->rotation[i];
      t->v[k].c[i] = x[0] * row[0] + x[1] * row[1] + x[2] * row[2] + pose->translation[i];
    }
  }
}

SIMD_INLINE SIMD_REAL SIMD_NAME(from_origin)(SIMD_NAME(triangle) * t, const SIMD_POINT *origin,
                                             SIMD_REAL most) {
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    t->v[k] = SIMD_NAME(minus)(&t->v[k], origin);
    SIMD_UNROLL for (int i = 0; i < 3; i++) {
      SIMD_REAL size = (SIMD_REAL)((SIMD_WHOLE)t->v[k].c[i] & INT64_MAX);
      most = SIMD_NAME(greater)(size, most);
    }
  }
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    t->e[k] = SIMD_NAME(minus)(&t->v[next[k]], &t->v[k]);
    t->over[k] = 1 / SIMD_NAME(dot)(&t->e[k], &t->e[k]);
  }
  return most;
}

/* The gap of pairs on a direction of length 1, its errors taken off, if it is above what is enough
 * in each lane. */
SIMD_INLINE bool SIMD_NAME(apart_on)(const double way[3], double enough, SIMD_REAL error,
                                     const SIMD_NAME(triangle) t[2], pair_enclosure *e) {
  SIMD_POINT w = {{(SIMD_REAL){0} + way[0], (SIMD_REAL){0} + way[1], (SIMD_REAL){0} + way[2]}};
  SIMD_REAL gap = SIMD_NAME(gap_along)(&w, &t[0], &t[1]) * (1 - 0x1p-49) - error;
  for (int k = 0; k < SIMD_LANES; k++) {
    if (!(gap[k] > enough)) {
      return false;
    }
  }
  for (int k = 0; k < SIMD_LANES; k++) {
    e[k] = (pair_enclosure){gap[k], INFINITY, {way[0], way[1], way[2]}};
  }
  return true;
}

/* Enclose the distances of pairs of triangles, and find the vectors between their nearest points.
 * `from` has A's vertices, then B's. */
SIMD_TARGET static void SIMD_NAME(enclose)(const double *from, const world_pose pose[2],
                                           const short_cut *cut, pair_enclosure *e) {
  SIMD_NAME(triangle) t[2];
  SIMD_NAME(nearest) n = {(SIMD_REAL){0} + INFINITY, {{{0}, {0}, {0}}}};
  SIMD_REAL gap;
  SIMD_REAL size = {0};
  SIMD_NAME(place)(&t[0], from, &pose[0]);
  SIMD_NAME(place)(&t[1], from + 9 * SIMD_LANES, &pose[1]);
  SIMD_POINT origin = t[0].v[0];
  size = SIMD_NAME(from_origin)(&t[0], &origin, size);
  size = SIMD_NAME(from_origin)(&t[1], &origin, size);
  SIMD_REAL error = PAIR_ERROR * size + (pose[0].error + pose[1].error);
  if (SIMD_NAME(apart_on)(cut->way[0], cut->enough, error, t, e) ||
      SIMD_NAME(apart_on)(cut->way[1], cut->enough, error, t, e)) {
    return;
  }
  for (int i = 0; i < 3; i++) {
    SIMD_UNROLL for (int j = 0; j < 3; j++) { SIMD_NAME(offer_edges)(&n, &t[0], i, &t[1], j); }
  }
  SIMD_NAME(offer_face)(&n, &t[0], &t[1]);
  SIMD_NAME(offer_face)(&n, &t[1], &t[0]);
  gap = SIMD_NAME(gap_along)(&n.way, &t[0], &t[1]);
  for (int k = 0; k < SIMD_LANES; k++) {
    e[k].least = gap[k] / sqrt(n.square[k] + 0x1p-1000) - error[k];
    e[k].most = sqrt(n.square[k]) + error[k];
    for (int i = 0; i < 3; i++) {
      e[k].way[i] = n.way.c[i][k];
    }
  }
}

#undef SIMD_POINT
#undef SIMD_LANES
#undef SIMD_NAME
#undef SIMD_TARGET
#undef SIMD_LOAD
#undef SIMD_STORE
#undef SIMD_SIZE
#undef SIMD_BITS
#undef SIMD_FLOATS
