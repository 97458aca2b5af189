/* SPDX-License-Identifier: MIT */
/* tool_rows.h - rows of a file of tools as numbers and words, and the profiles that they describe
 * (private to the readers of tools). */
#ifndef SEPAX_NC_TOOL_ROWS_H
#define SEPAX_NC_TOOL_ROWS_H

#include "nc/tools.h"

/* The numbers of a row; NAN: the cell is empty or the column is missing. */
typedef enum {
  TOOL_DIAMETER,
  TOOL_CORNER, /* corner radius */
  TOOL_TIP,    /* tip angle, degrees */
  TOOL_TAPER,  /* taper angle, degrees */
  TOOL_FLUTE,  /* flute length */
  TOOL_NECK,   /* neck diameter */
  TOOL_USABLE, /* usable length */
  TOOL_SHANK,  /* shank diameter */
  TOOL_OUT,    /* stick-out */
  TOOL_LENGTH,
  TOOL_NUMBERS
} tool_number;

/* A list of steps (docs/reference/tools.md); NULL: none. */
typedef struct {
  char *text;
  double unit; /* mm */
} tool_steps;

typedef struct nc_tool_row {
  const char *path; /* for messages */
  size_t line;
  int number; /* -1: the row `default` */
  char *name;
  nc_tool_kind kind;
  double value[TOOL_NUMBERS]; /* mm or degrees */
  tool_steps steps[NC_TOOL_PARTS];
} nc_tool_row;

typedef struct {
  nc_tool_row *row;
  size_t rows, capacity;
} nc_tool_rows;

bool nc_tool_rows_read(nc_tool_rows *rows, const char *path, sepax_error *error);
void nc_tool_rows_free(nc_tool_rows *rows);
void nc_tool_row_free(nc_tool_row *row);

/* The name of a column: "corner radius". */
const char *nc_tool_number_name(tool_number number);

/* Fail with FORMAT, file, line and tool. Returns false. */
bool nc_tool_refuse(const nc_tool_row *row, sepax_error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The parts of a tool from its row, without what the table says. On failure *tool is zero. */
bool nc_tool_shape(nc_turned_tool *tool, const nc_tool_row *row, sepax_error *error);
void nc_turned_tool_free(nc_turned_tool *tool);

/* Append the steps of a part to its profile. *z is the height of the first step and becomes the end
 * of the last. */
bool nc_tool_add_steps(turned_profile *profile, const nc_tool_row *row, nc_tool_part part,
                       double *z, sepax_error *error);

/* Append a point; a point that repeats the one before is left out. */
bool nc_tool_add_point(turned_profile *profile, const nc_tool_row *row, double z, double r,
                       double bend, sepax_error *error);

/* If the length is known: it is not below a part that ends at the holder, and the holder reaches
 * the nose of the spindle. */
bool nc_tool_check_length(const nc_turned_tool *tool, const nc_tool_row *row, sepax_error *error);

#endif
