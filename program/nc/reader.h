/* SPDX-License-Identifier: MIT */
/* reader.h - the state of the reader of canonical motion (private to program/nc). */
#ifndef SEPAX_NC_READER_H
#define SEPAX_NC_READER_H

#include "nc/canon.h"
#include "nc/words.h"

enum { NC_FILES_MOST = 4096 };

typedef struct {
  nc_words words;
  nc_program *program;
  size_t file_capacity, tool_capacity, record_capacity;
  bool started; /* the record `start` was read */
  bool ended;
} nc_reader;

/* Report that memory ran out, and return false. */
bool nc_no_memory(const nc_reader *r);

/* Read the rest of the line of a record of this name into r->program. */
bool nc_read_file(nc_reader *r);
bool nc_read_machine(nc_reader *r);
bool nc_read_parameter(nc_reader *r);
bool nc_read_joint(nc_reader *r);
bool nc_read_limits(nc_reader *r);
bool nc_read_servo(nc_reader *r);
bool nc_read_tool(nc_reader *r);
bool nc_read_start(nc_reader *r);

#endif
