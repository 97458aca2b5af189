/* reach.h - how near boxes and pairs of triangles come to each other (private; search.c includes it
 * once per instruction set).
 *
 * NAME(x), TARGET   a name of its own, the attribute of its functions
 * FLOATS, LANES     boxes, pairs of triangles at once
 * BITS(v)           sign bits of int32_t lanes */

typedef float NAME(floats) __attribute__((vector_size(4 * FLOATS)));
typedef int32_t NAME(masks) __attribute__((vector_size(4 * FLOATS)));
typedef double NAME(reals) __attribute__((vector_size(8 * LANES)));
typedef int64_t NAME(lanes) __attribute__((vector_size(8 * LANES)));

#define F NAME(floats)
#define M NAME(masks)
#define R NAME(reals)
#define V NAME(lanes)
#define INLINE TARGET static inline __attribute__((always_inline))

#define LOAD(v, from) memcpy(&(v), from, sizeof(v))
#define STORE(to, v) memcpy(to, &(v), sizeof(v))
#define SIZE(v) ((F)((M)(v)&INT32_MAX))

/* Where positive; what is not a number is 0. */
INLINE F NAME(positive)(F v) { return (F)((M)v & (v > 0)); }

INLINE F NAME(most_of)(F p, F q) {
  M second = q > p;
  return (F)(((M)q & second) | ((M)p & ~second));
}

/* square[k]: not above the square of the distance of child k of a node from a box of the other
 * body, in units of the node's body. The gaps on axes at right angles to each other are the sides
 * of a box between them; the way between the bodies is one more axis, of length 1 or 0. Bit k: the
 * square is at most with->most. Rounding: search.c. */
TARGET static uint32_t NAME(bound)(const body_boxes *node, const facing *with,
                                   const body_boxes *from, uint32_t lane, float square[BODY_WIDE]) {
  const float *way = with->way;
  posed_box p;
  uint32_t bits = 0;
  turn_box(&p, with->motion, from, lane);
  float own_reach = 0;
  UNROLL for (int k = 0; k < 3; k++) {
    four_floats axis = p.axis[k];
    own_reach += fabsf(axis[0] * way[0] + axis[1] * way[1] + axis[2] * way[2]) * p.half[k];
  }
  for (int n = 0; n < BODY_WIDE; n += FLOATS) {
    F t[3];
    F at[3] = {{0}, {0}, {0}};
    F reach[3];
    F least[2] = {{0}, {0}};
    F along_way = {0};
    F way_reach = (F){0} + own_reach;
    UNROLL for (int i = 0; i < 3; i++) {
      LOAD(t[i], node->centre[i] + n);
      t[i] = p.centre[i] - t[i] + p.rest[i];
      reach[i] = (F){0} + p.half[i];
      along_way += t[i] * way[i];
    }
    F slack = (SIZE(t[0]) + SIZE(t[1]) + SIZE(t[2])) * with->slack;
    UNROLL for (int i = 0; i < 3; i++) {
      F axis[3];
      F half;
      UNROLL for (int j = 0; j < 3; j++) { LOAD(axis[j], node->axis[i][j] + n); }
      LOAD(half, node->half[i] + n);
      F along = axis[0] * t[0] + axis[1] * t[1] + axis[2] * t[2];
      F own = half;
      way_reach += SIZE(axis[0] * way[0] + axis[1] * way[1] + axis[2] * way[2]) * half;
      UNROLL for (int k = 0; k < 3; k++) {
        F cosine = axis[0] * p.axis[k][0] + axis[1] * p.axis[k][1] + axis[2] * p.axis[k][2];
        own += SIZE(cosine) * p.half[k];
        reach[k] += SIZE(cosine) * half;
        at[k] += along * cosine;
      }
      F gap = NAME(positive)(SIZE(along) - own - slack);
      least[0] += gap * gap;
    }
    UNROLL for (int k = 0; k < 3; k++) {
      F gap = NAME(positive)(SIZE(at[k]) - reach[k] - slack);
      least[1] += gap * gap;
    }
    F gap = NAME(positive)(SIZE(along_way) - way_reach - slack);
    F all = NAME(most_of)(NAME(most_of)(least[0], least[1]), gap * gap);
    STORE(square + n, all);
    bits |= (~BITS(all > with->most) & ((1U << FLOATS) - 1)) << n;
  }
  return bits;
}

/* ------------------------------------------------------------- pairs of triangles */

typedef struct {
  R c[3];
} NAME(vector);

#define W NAME(vector)

INLINE R NAME(chosen)(V which, R p, R q) { return (R)(((V)p & which) | ((V)q & ~which)); }
INLINE R NAME(greater)(R p, R q) { return NAME(chosen)(p > q, p, q); }
INLINE R NAME(lesser)(R p, R q) { return NAME(chosen)(p < q, p, q); }

/* Within 0 ... most; what is not a number is 0. */
INLINE R NAME(limited)(R t, R most) { return NAME(lesser)((R)((V)t & (t > 0)), most); }

INLINE R NAME(dot)(const W *p, const W *q) {
  return p->c[0] * q->c[0] + p->c[1] * q->c[1] + p->c[2] * q->c[2];
}

INLINE W NAME(minus)(const W *p, const W *q) {
  return (W){{p->c[0] - q->c[0], p->c[1] - q->c[1], p->c[2] - q->c[2]}};
}

INLINE W NAME(cross)(const W *p, const W *q) {
  return (W){{p->c[1] * q->c[2] - p->c[2] * q->c[1], p->c[2] * q->c[0] - p->c[0] * q->c[2],
              p->c[0] * q->c[1] - p->c[1] * q->c[0]}};
}

/* p + s u - t v */
INLINE W NAME(between)(const W *p, R s, const W *u, R t, const W *v) {
  W r;
  UNROLL for (int i = 0; i < 3; i++) { r.c[i] = p->c[i] + s * u->c[i] - t * v->c[i]; }
  return r;
}

/* The shortest way so far from a point of A to one of B. */
typedef struct {
  R square;
  W way;
} NAME(nearest);

INLINE void NAME(offer)(NAME(nearest) * n, const W *way) {
  R square = NAME(dot)(way, way);
  V which = square < n->square;
  n->square = NAME(chosen)(which, square, n->square);
  UNROLL for (int i = 0; i < 3; i++) { n->way.c[i] = NAME(chosen)(which, way->c[i], n->way.c[i]); }
}

typedef struct {
  W v[3], e[3]; /* e[k]: from vertex k to the next */
  R over[3];    /* 1 / e[k] . e[k] */
} NAME(triangle);

INLINE void NAME(offer_edges)(NAME(nearest) * n, const NAME(triangle) * a, int i,
                              const NAME(triangle) * b, int j) {
  const R one = (R){0} + 1;
  const W *u = &a->e[i];
  const W *v = &b->e[j];
  W d = NAME(minus)(&b->v[j], &a->v[i]);
  R uv = NAME(dot)(u, v);
  R du = NAME(dot)(&d, u) * a->over[i];
  R dv = NAME(dot)(&d, v) * b->over[j];
  R area = 1 - uv * uv * (a->over[i] * b->over[j]);
  R s = NAME(limited)((du - uv * dv * a->over[i]) / area, one);
  R t = NAME(limited)(s * uv * b->over[j] - dv, one);
  s = NAME(limited)(t * uv * a->over[i] + du, one);
  W way = NAME(between)(&d, t, v, s, u);
  NAME(offer)(n, &way);
}

/* The vertices of x and the face of f. With n = e_0 x e_2 the foot of f_0 + d is at e_0 times
 * d . (e_2 x n) / n . n less e_2 times d . (e_0 x n) / n . n. */
INLINE void NAME(offer_face)(NAME(nearest) * n, const NAME(triangle) * x,
                             const NAME(triangle) * f) {
  W normal = NAME(cross)(&f->e[0], &f->e[2]);
  R over = 1 / NAME(dot)(&normal, &normal);
  W first = NAME(cross)(&f->e[2], &normal);
  W second = NAME(cross)(&f->e[0], &normal);
  UNROLL for (int k = 0; k < 3; k++) {
    W d = NAME(minus)(&x->v[k], &f->v[0]);
    R s = NAME(limited)(NAME(dot)(&d, &first) * over, (R){0} + 1);
    R t = NAME(limited)(NAME(dot)(&d, &second) * over, 1 - s);
    W way = NAME(between)(&d, t, &f->e[2], s, &f->e[0]);
    NAME(offer)(n, &way);
  }
}

/* The gap of the projections on a way; 0 if there is none. */
INLINE R NAME(gap_along)(const W *way, const NAME(triangle) * a, const NAME(triangle) * b) {
  R low[2];
  R high[2];
  UNROLL for (int k = 0; k < 6; k++) {
    R t = NAME(dot)(way, k < 3 ? &a->v[k] : &b->v[k - 3]);
    low[k / 3] = k % 3 == 0 ? t : NAME(lesser)(t, low[k / 3]);
    high[k / 3] = k % 3 == 0 ? t : NAME(greater)(t, high[k / 3]);
  }
  return NAME(greater)(NAME(greater)(low[1] - high[0], low[0] - high[1]), (R){0});
}

/* Vertex k of n is from[(3 k + coordinate) LANES + n]; posed. */
INLINE void NAME(place)(NAME(triangle) * t, const double *from, const world_pose *pose) {
  UNROLL for (int k = 0; k < 3; k++) {
    R x[3];
    UNROLL for (int i = 0; i < 3; i++) { LOAD(x[i], from + (3 * k + i) * LANES); }
    UNROLL for (int i = 0; i < 3; i++) {
      const double *row = pose->rotation[i];
      t->v[k].c[i] = x[0] * row[0] + x[1] * row[1] + x[2] * row[2] + pose->translation[i];
    }
  }
}

INLINE R NAME(from_origin)(NAME(triangle) * t, const W *origin, R most) {
  UNROLL for (int k = 0; k < 3; k++) {
    t->v[k] = NAME(minus)(&t->v[k], origin);
    UNROLL for (int i = 0; i < 3; i++) {
      R size = (R)((V)t->v[k].c[i] & INT64_MAX);
      most = NAME(greater)(size, most);
    }
  }
  UNROLL for (int k = 0; k < 3; k++) {
    t->e[k] = NAME(minus)(&t->v[next[k]], &t->v[k]);
    t->over[k] = 1 / NAME(dot)(&t->e[k], &t->e[k]);
  }
  return most;
}

/* Pairs of triangles: an enclosure of their distance, and the way between their nearest points.
 * from: A's vertices, then B's. */
TARGET static void NAME(enclose)(const double *from, const world_pose pose[2], pair_enclosure *e) {
  NAME(triangle) t[2];
  NAME(nearest) n = {(R){0} + INFINITY, {{{0}, {0}, {0}}}};
  R gap;
  R size = {0};
  NAME(place)(&t[0], from, &pose[0]);
  NAME(place)(&t[1], from + 9 * LANES, &pose[1]);
  W origin = t[0].v[0];
  size = NAME(from_origin)(&t[0], &origin, size);
  size = NAME(from_origin)(&t[1], &origin, size);
  for (int i = 0; i < 3; i++) {
    UNROLL for (int j = 0; j < 3; j++) { NAME(offer_edges)(&n, &t[0], i, &t[1], j); }
  }
  NAME(offer_face)(&n, &t[0], &t[1]);
  NAME(offer_face)(&n, &t[1], &t[0]);
  gap = NAME(gap_along)(&n.way, &t[0], &t[1]);
  for (int k = 0; k < LANES; k++) {
    double error = PAIR_ERROR * size[k] + pose[0].error + pose[1].error;
    e[k].least = gap[k] / sqrt(n.square[k] + 0x1p-1000) - error;
    e[k].most = sqrt(n.square[k]) + error;
    for (int i = 0; i < 3; i++) {
      e[k].way[i] = n.way.c[i][k];
    }
  }
}

#undef F
#undef M
#undef R
#undef V
#undef W
#undef INLINE
#undef LANES
#undef NAME
#undef TARGET
#undef LOAD
#undef STORE
#undef SIZE
#undef BITS
#undef FLOATS
