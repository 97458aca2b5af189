/* sepax_tree_driver.h - driver of a tree engine, for bare metal: no heap, no operating system, C11.
 *
 * Trees are files of `sepax tree`, anywhere in the engine's memory; jobs, poses and results are
 * those of docs/reference/tree-engine.md. The registers are those of sepax_registers.h, which sepax
 * gen writes beside the Verilog. The three accesses are yours. What the engine is to read must be
 * written before sepax_device_start and be visible to it (caches of the processor flushed), and
 * stand until the batch has ended. Results must be taken: the engine waits while nobody takes them.
 * One call at a time; not from an interrupt while another runs. */
#ifndef SEPAX_TREE_DRIVER_H
#define SEPAX_TREE_DRIVER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SEPAX_DEVICE_BODY = 32, SEPAX_DEVICE_POSE = 144, SEPAX_DEVICE_JOB = 128 }; /* bytes */

/* How the engine is reached; `context` is handed on. false: the access failed. */
typedef struct {
  void *context;
  bool (*read)(void *context, uint32_t address, uint32_t *value);
  bool (*write)(void *context, uint32_t address, uint32_t value);
  /* Wait for a transfer of the result stream and take it; `last`: its TLAST. */
  bool (*receive)(void *context, uint64_t *result, bool *last);
} sepax_device_bus;

typedef struct {
  sepax_device_bus bus;
  int word, margin; /* of the design: bits of a coordinate; LSB by which AABBs are larger */
} sepax_device;

/* ---------------------------------------------------------------- memory */

/* The body record of a file of `sepax tree` that is at `address`, a multiple of 4096. False: it is
 * none, or not of this version. Only its head is looked at; `sepax tree FILE` checks all. */
bool sepax_device_body(uint8_t record[SEPAX_DEVICE_BODY], const uint8_t *file, uint64_t address);

/* Can the engine test the files a and b against each other? Only if both are trees of one
 * resolution and of no more bits than it has. Ask once for each pair of bodies: the engine sees
 * neither, and would read wrong coordinates without a word. */
bool sepax_device_fits(const sepax_device *device, const uint8_t *a, const uint8_t *b);

/* A pose: the rotation, rounded to 2^-20, and the shift of B in A's coordinates, in 2^-20 LSB of
 * the trees' resolution: v = matrix p + shift, both bodies' offsets counted in. With B turned by R
 * and moved by T that is shift = (R offset_b + T - offset_a) / resolution, in double precision; a
 * clearance is proved for a shift that is wrong by less than 2^-17 LSB. `word` and `margin` are
 * those of the sepax_device. A's boxes are turned by the transposed matrix; by how much they must
 * be larger is computed here, exactly, and holds for any matrix. False: a number does not fit, or
 * the matrix is too far from a rotation. */
bool sepax_device_pose(uint8_t pose[SEPAX_DEVICE_POSE], const int32_t matrix[3][3],
                       const int64_t shift[3], int word, int margin);

/* Modes of a job. */
enum {
  SEPAX_DEVICE_FIRST = 1, /* a pose ends at its first collision */
  SEPAX_DEVICE_QUIET = 2, /* pairs are counted, not sent */
  SEPAX_DEVICE_ROW = 4,   /* `row` is valid */
  SEPAX_DEVICE_AGAIN = 8, /* what collided first is tried first in the poses behind */
  SEPAX_DEVICE_COLD = 16, /* caches are empty at each pose, else at the job's first */
  SEPAX_DEVICE_WARM = 32, /* not at the job's first: its bodies are those of the job before */
  SEPAX_DEVICE_LEAVE = 64 /* the first pose that collides ends the job */
};

/* Two bodies and a queue of poses, 256 bytes each from the multiple of 256 `poses` on. */
typedef struct {
  uint8_t body[2][SEPAX_DEVICE_BODY];
  uint64_t poses;
  uint32_t count, modes; /* of poses; SEPAX_DEVICE_FIRST ... */
  uint32_t budget; /* cycles after which a pose is stopped, 0: none; it ends when the bursts that
                      are open have come */
  uint32_t row[2]; /* as a sepax_outcome has it */
} sepax_device_work;
void sepax_device_job(uint8_t job[SEPAX_DEVICE_JOB], const sepax_device_work *work);

/* ---------------------------------------------------------------- lists */

/* The jobs of a list in a file, for sepax_device_start. */
typedef struct {
  uint64_t list;
  uint32_t jobs, poses; /* of each job */
} sepax_device_list;

/* A list of `sepax path --jobs` whose bytes are at `address`, a multiple of 4096, and at `file` for
 * the processor: its jobs are told where it is. False: it is none, or for a design of another word
 * or other clearances. Only its head is looked at; `sepax tree FILE` checks all. */
bool sepax_device_place(const sepax_device *device, sepax_device_list *list, uint8_t *file,
                        uint64_t address);

/* ---------------------------------------------------------------- runs */

/* A pair that collides, or is too near, by its numbers in the trees. The table at the end of a file
 * of `sepax tree` has the numbers in the STL file (docs/reference/tree-engine.md, The file). */
typedef struct {
  uint32_t a, b;
  bool coplanar;
  bool out_of_range; /* undecided, called a collision */
  bool warning;      /* no collision, but too near (engines with a warning limit) */
} sepax_contact;

/* The end of a pose. */
typedef struct {
  uint32_t job, pose;
  unsigned status; /* bits: 0 a pair collides, 1 some undecided, 2 stopped, 3 damaged, 4 error of
                      the bus, 5 refused; with one of 3 ... 5 there is no verdict */
  bool last;       /* the batch ends with this pose */
  uint32_t steps, cycles, near, collisions, warnings, out_of_range, pairs, rows, entries;
  uint32_t first[2]; /* with a collision: the first */
  uint32_t row[2];   /* to be tried first in a pose like this one */
} sepax_outcome;

typedef enum {
  SEPAX_DEVICE_OK,
  SEPAX_DEVICE_NONE,       /* ID is not what it must be */
  SEPAX_DEVICE_BUS,        /* an access failed or was answered with SLVERR: a batch that begins
                              while another runs, of no jobs, from no multiple of 128 */
  SEPAX_DEVICE_INCOMPLETE, /* the engine sent another number of pairs than it counted */
  SEPAX_DEVICE_NO_VERDICT  /* of the last pose that was taken: see its status */
} sepax_device_status;

const char *sepax_device_text(sepax_device_status status);

/* Is the engine there, and what is it like. */
sepax_device_status sepax_device_open(sepax_device *device, const sepax_device_bus *bus);

/* Begin a batch: `jobs` jobs from `list` on, a multiple of 128. Not while another runs. */
sepax_device_status sepax_device_start(sepax_device *device, uint64_t list, uint32_t jobs);

/* The batch is to end with the pose that is walked; its end is still to be taken. */
sepax_device_status sepax_device_stop(sepax_device *device);

/* Wait until a pose has ended. Each of its pairs is handed to `found` (NULL: to nobody) before. */
sepax_device_status sepax_device_take(sepax_device *device,
                                      void (*found)(void *context, const sepax_contact *contact),
                                      void *context, sepax_outcome *outcome);

/* Has the batch ended? Some cycles after its last pose was taken it has. */
sepax_device_status sepax_device_busy(sepax_device *device, bool *busy);

#endif
