/* SPDX-License-Identifier: MIT */
/* sepax_tree_driver.h - driver of a tree engine, for bare metal: no heap, no operating system, C11.
 *
 * docs/reference/tree-engine.md specifies trees, jobs, poses and results. sepax_tree_registers.h
 * has the registers, which are the same for every tree engine, whatever its --prefix. You write the
 * three functions of sepax_tree_device_bus. A batch takes these steps:
 *   1. copy files of `sepax tree` into the engine's memory, each at a multiple of 4096;
 *   2. sepax_tree_device_open, once; sepax_tree_device_fits, once for each pair of bodies;
 *   3. sepax_tree_device_body, sepax_tree_device_pose and sepax_tree_device_job make the records;
 *   4. write the records to the memory and flush the processor's caches. The bytes must not change
 *      until the batch has ended;
 *   5. sepax_tree_device_start; then sepax_tree_device_take until an outcome is the last one. The
 *      engine waits while nobody takes its results.
 *
 * Make one call at a time, and no call from an interrupt while another call runs. */
#ifndef SEPAX_TREE_DRIVER_H
#define SEPAX_TREE_DRIVER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Bytes of the records. */
enum { SEPAX_TREE_DEVICE_BODY = 32, SEPAX_TREE_DEVICE_POSE = 144, SEPAX_TREE_DEVICE_JOB = 128 };

/* The accesses to the engine. Each gets `context`, and returns false if the access failed. */
typedef struct {
  void *context;
  bool (*read)(void *context, uint32_t address, uint32_t *value);
  bool (*write)(void *context, uint32_t address, uint32_t value);
  /* Wait for a transfer of the result stream and take it. *last is its TLAST. */
  bool (*receive)(void *context, uint64_t *result, bool *last);
} sepax_tree_device_bus;

typedef struct {
  sepax_tree_device_bus bus;
  int word;   /* bits of a coordinate of the design */
  int margin; /* margin m of the design: largest gap of near AABBs, in LSB */
} sepax_tree_device;

/* ---------------------------------------------------------------- memory */

/* Make the body record of a file of `sepax tree`, whose bytes the processor finds at `file` and the
 * engine at `address`, a multiple of 4096. Returns false if the file is no tree, or has another
 * version, or if `address` is not a multiple of 4096. The function checks only the first bytes;
 * `sepax tree FILE` checks all. */
bool sepax_tree_device_body(uint8_t record[SEPAX_TREE_DEVICE_BODY], const uint8_t *file,
                            uint64_t address);

/* True if the engine can test the files a and b against each other: both are trees, with the same
 * resolution and with words up to that of the engine. Call it once for each pair of bodies. The
 * engine cannot check this itself: its verdicts would be wrong, without any error. */
bool sepax_tree_device_fits(const sepax_tree_device *device, const uint8_t *a, const uint8_t *b);

/* Make the record of a pose, in which the vertex p of B has the place matrix p + shift in A's
 * coordinates. `matrix` is the rotation in 2^-20. `shift` is in 2^-20 LSB and includes the offsets
 * of both trees: if B is rotated by R and moved by T, then
 * shift = (R offset_b + T - offset_a) / resolution.
 * Double precision suffices: a clearance is proved for a shift that is wrong by less than 2^-17
 * LSB. `word` and `margin` are those of the sepax_tree_device.
 * A's boxes are turned by the transposed matrix. The function computes exactly by how much these
 * boxes must be enlarged, for any matrix. Returns false if a number does not fit or if the matrix
 * is too far from a rotation. */
bool sepax_tree_device_pose(uint8_t pose[SEPAX_TREE_DEVICE_POSE], const int32_t matrix[3][3],
                            const int64_t shift[3], int word, int margin);

/* Modes of a job (docs/reference/tree-engine.md, Job). */
enum {
  SEPAX_TREE_DEVICE_FIRST = 1, /* a pose ends at its first collision */
  SEPAX_TREE_DEVICE_QUIET = 2, /* colliding pairs are counted but not sent */
  SEPAX_TREE_DEVICE_ROW = 4,   /* `row` is valid: the first pose tests this pair first */
  SEPAX_TREE_DEVICE_AGAIN =
      8, /* a pose tests first the pair that collided first in an earlier pose */
  SEPAX_TREE_DEVICE_COLD = 16, /* empty the caches before each pose, not only before the first */
  SEPAX_TREE_DEVICE_WARM =
      32, /* keep the caches for the first pose: same bodies as the job before */
  SEPAX_TREE_DEVICE_LEAVE = 64 /* the first pose that collides ends the job */
};

/* A job: two bodies and a queue of poses. */
typedef struct {
  uint8_t body[2][SEPAX_TREE_DEVICE_BODY];
  uint64_t poses;  /* address of the first pose, a multiple of 256; poses are 256 bytes apart */
  uint32_t count;  /* number of poses, 1 or more */
  uint32_t modes;  /* SEPAX_TREE_DEVICE_FIRST ... */
  uint32_t budget; /* cycles after which a pose is stopped, 0: 2^32 - 1. A stopped pose still waits
                      for its open bursts */
  uint32_t row[2]; /* sepax_outcome.row of an earlier pose */
} sepax_tree_device_work;

/* Make the record of a job. */
void sepax_tree_device_job(uint8_t job[SEPAX_TREE_DEVICE_JOB], const sepax_tree_device_work *work);

/* ---------------------------------------------------------------- lists */

/* The jobs of a list in a file. */
typedef struct {
  uint64_t list;  /* address of the jobs, for sepax_tree_device_start */
  uint32_t jobs;  /* number of jobs, for sepax_tree_device_start */
  uint32_t poses; /* poses of each job */
} sepax_tree_device_list;

/* Prepare a list of `sepax path --jobs`, whose bytes the processor finds at `file` and the engine
 * at `address`, a multiple of 4096. The function writes the addresses of bodies and poses into the
 * jobs. Returns false, and changes nothing, if the file is no list, is for a design of another word
 * or of other clearances, or if `address` is not a multiple of 4096. The function checks only the
 * head of the file; `sepax tree FILE` checks all. */
bool sepax_tree_device_place(const sepax_tree_device *device, sepax_tree_device_list *list,
                             uint8_t *file, uint64_t address);

/* ---------------------------------------------------------------- runs */

/* A pair that collides or is too near. a and b are numbers in the trees. The table at the end of a
 * file of `sepax tree` has their numbers in the mesh (docs/reference/tree-engine.md, The file). */
typedef struct {
  uint32_t a, b;
  bool coplanar;
  bool out_of_range; /* undecided, reported as a collision */
  bool warning;      /* no collision, but within the warning limit of the engine */
} sepax_contact;

/* The end of a pose. */
typedef struct {
  uint32_t job, pose;
  unsigned status; /* bits: 0 a pair collides, 1 some collisions are undecided, 2 stopped, 3
                      damaged, 4 bus error, 5 refused. With bit 3, 4 or 5 there is no verdict */
  bool last;       /* the batch ends with this pose */
  uint32_t steps, cycles, near, collisions, warnings, out_of_range, pairs, rows, entries;
  uint32_t first[2]; /* the first collision: triangles of A and B; 0 without a collision */
  uint32_t row[2];   /* the first collision as a first row, for sepax_tree_device_work.row */
} sepax_outcome;

typedef enum {
  SEPAX_TREE_DEVICE_OK,
  SEPAX_TREE_DEVICE_NONE, /* the ID register is not that of a tree engine */
  SEPAX_TREE_DEVICE_BUS,  /* an access failed or was answered with SLVERR. The engine answers so if
                        a batch is running, has no jobs, or if the address of the list is not
                        a multiple of 128 */
  SEPAX_TREE_DEVICE_INCOMPLETE, /* the engine sent another number of pairs than it counted */
  SEPAX_TREE_DEVICE_NO_VERDICT  /* the pose has no verdict: see outcome->status */
} sepax_tree_device_status;

/* A short English text for a status. */
const char *sepax_tree_device_text(sepax_tree_device_status status);

/* Check that a tree engine answers, and read its word and margin. */
sepax_tree_device_status sepax_tree_device_open(sepax_tree_device *device,
                                                const sepax_tree_device_bus *bus);

/* Begin a batch of `jobs` jobs, 1 or more, of which the first is at the address `list`, a multiple
 * of 128. Not while another batch runs. */
sepax_tree_device_status sepax_tree_device_start(sepax_tree_device *device, uint64_t list,
                                                 uint32_t jobs);

/* End the batch with the pose that is being walked. The end of this pose must still be taken. */
sepax_tree_device_status sepax_tree_device_stop(sepax_tree_device *device);

/* Wait for the end of a pose. `found` (NULL: not called) gets each pair of the pose before. */
sepax_tree_device_status sepax_tree_device_take(sepax_tree_device *device,
                                                void (*found)(void *context,
                                                              const sepax_contact *contact),
                                                void *context, sepax_outcome *outcome);

/* *busy is true while a batch runs. A batch ends some cycles after its last pose was taken. */
sepax_tree_device_status sepax_tree_device_busy(sepax_tree_device *device, bool *busy);

#endif
