/* SPDX-License-Identifier: MIT */
/* registers.c - the register map of the tree engine (docs/reference/tree-engine.md, Registers). */
#include "tree_engine/registers.h"

static const engine_register table[] = {
    {"ID", ENGINE_CONSTANT, "", 0, 32, "0x53505854, \"SPXT\""},
    {"GENERATOR", ENGINE_CONSTANT, "", 0, 32, "its version"},
    {"MAJOR", ENGINE_FIELD, "", 16, 8, ""},
    {"MINOR", ENGINE_FIELD, "", 8, 8, ""},
    {"PATCH", ENGINE_FIELD, "", 0, 8, ""},
    {"DESIGN", ENGINE_CONSTANT, "", 0, 32, "what was generated"},
    {"WORD", ENGINE_FIELD, "", 0, 6, "bits of a coordinate"},
    {"CORES", ENGINE_FIELD, "", 16, 4, "exact cores"},
    {"II", ENGINE_FIELD, "", 24, 5, "cycles a pair of each core"},
    {"MARGIN", ENGINE_CONSTANT, "", 0, 32,
     "of AABBs, LSB: 0, or 1 + the largest clearance + 2 ... 5 for poses"},
    {"COMMAND", ENGINE_WRITE, "", 0, 32, "one bit, written as 1"},
    {"START", ENGINE_FIELD, "", 0, 1, "begin a batch; refused while busy, or if JOBS is 0"},
    {"STOP", ENGINE_FIELD, "", 1, 1, "end the batch with the pose that is walked"},
    {"STATUS", ENGINE_READ, "status", 0, 32, "of the batch: what was true of any of its poses"},
    {"BUSY", ENGINE_FIELD, "", 0, 1, "a batch is worked on"},
    {"HIT", ENGINE_FIELD, "", 1, 1, "a pair collides"},
    {"OUT_OF_RANGE", ENGINE_FIELD, "", 2, 1, "some of these pairs are undecided"},
    {"STOPPED", ENGINE_FIELD, "", 3, 1, "by BUDGET or STOP; what was not found is undecided"},
    {"DAMAGED", ENGINE_FIELD, "", 4, 1, "a tree is damaged: the batch ended, no verdict"},
    {"BUS", ENGINE_FIELD, "", 5, 1, "memory answered with an error: the same"},
    {"REFUSED", ENGINE_FIELD, "", 6, 1, "a number of a job or pose is out of range: the same"},
    {"ENABLE", ENGINE_READ_WRITE, "{29'd0, enable_q}", 0, 32,
     "which of PENDING raise the interrupt"},
    {"DONE", ENGINE_FIELD, "", 0, 1, ""},
    {"HIT", ENGINE_FIELD, "", 1, 1, ""},
    {"POSE", ENGINE_FIELD, "", 2, 1, ""},
    {"PENDING", ENGINE_CLEAR, "{29'd0, pending_q}", 0, 32, "write 1 to clear"},
    {"DONE", ENGINE_FIELD, "", 0, 1, "a batch has ended"},
    {"HIT", ENGINE_FIELD, "", 1, 1, "a pose has found its first collision"},
    {"POSE", ENGINE_FIELD, "", 2, 1, "a pose has ended"},
    {"LIST_LOW", ENGINE_READ_WRITE, "{list[24:0], 7'd0}", 0, 32,
     "address of the first job, a multiple of 128, bits 31:0; not writable while busy"},
    {"LIST_HIGH", ENGINE_READ_WRITE, "{24'd0, list[32:25]}", 0, 32, "its bits 39:32; likewise"},
    {"JOBS", ENGINE_READ_WRITE, "jobs", 0, 32, "how many jobs; likewise"},
    {"JOB", ENGINE_READ, "job", 0, 32, "number of the job that is worked on, from 0"},
    {"POSE", ENGINE_READ, "pose", 0, 32, "number of its pose, from 0"},
    {"POSES", ENGINE_READ, "poses", 0, 32, "poses of the batch that have ended"},
    {"HITS", ENGINE_READ, "hits", 0, 32, "of these, poses with a collision"},
    {"HIT_JOB", ENGINE_READ, "hit_job", 0, 32, "the first of them: number of its job"},
    {"HIT_POSE", ENGINE_READ, "hit_pose", 0, 32, "number of the pose"},
    {"CYCLES", ENGINE_READ, "cycles", 0, 32, "clock cycles of the batch"},
};

const engine_registers tree_engine_registers = {
    "sepax_tree_registers", 0x53505854, table, sizeof table / sizeof table[0],
    "What is read is of the last batch, undefined before the "
    "first;\nHIT_JOB and HIT_POSE of the last with a "
    "collision."};
