/* SPDX-License-Identifier: MIT */
/* tools.h - the tools of an NC program as turned profiles: flutes, shank and holder.
 *
 * A file of tools (docs/reference/tools.md) describes the shapes; the control's tool table, which
 * the interpreter hands on, completes it. Lengths are in mm. Heights are above the tip of the tool,
 * along its axis, up to the spindle. */
#ifndef SEPAX_NC_TOOLS_H
#define SEPAX_NC_TOOLS_H

#include "mesh/revolve.h"
#include "nc/canon.h"

typedef enum {
  NC_TOOL_FLAT,
  NC_TOOL_BALL,
  NC_TOOL_BULL,
  NC_TOOL_DRILL,
  NC_TOOL_TAPER,
  NC_TOOL_FACE,
  NC_TOOL_PROBE,
  NC_TOOL_FORM,
  NC_TOOL_KINDS
} nc_tool_kind;

typedef enum { NC_FLUTES, NC_SHANK, NC_HOLDER, NC_TOOL_PARTS } nc_tool_part;

/* A tool. A part without points does not exist. The flutes of a probe are its ball. Each part is a
 * legal profile (sepax__turned_check). Parts of a tool touch or overlap each other. */
typedef struct {
  int number;
  char *name;  /* may be empty */
  size_t line; /* of the file of tools; of the row `default` for a tool that only the table has */
  nc_tool_kind kind;
  double diameter;        /* the greatest of the flutes; of a tapered mill that of its tip */
  double length;          /* from the tip to the nose of the spindle; NAN: not known */
  double offset[NC_AXES]; /* of the tool table; mm, degrees */
  char *refusal;          /* why the tool cannot be loaded; NULL: it can */
  turned_profile part[NC_TOOL_PARTS];
} nc_turned_tool;

struct nc_tool_row;

typedef struct {
  char *path, *table;         /* of both files in messages; `table` is NULL before completion */
  nc_turned_tool *tool;       /* in the order of the file, then those of the table */
  size_t tools, capacity;     /* capacity: private */
  struct nc_tool_row *common; /* row `default`, private; NULL: none */
} nc_tools;

/* Read a file of tools. Errors, each with file, line and cure: FILE; FORMAT if the file breaks the
 * rules of docs/reference/tools.md; LIMIT on more than 10,000 tools or 16 MiB; MEMORY. After a
 * failure *tools is zero. */
bool nc_tools_read(nc_tools *tools, const char *path, sepax_error *error);
void nc_tools_free(nc_tools *tools);

/* Complete the tools by those of a tool table, once. `path` names the table in messages. In a row
 * of the table, a diameter of 0 or a Z of 0 says nothing.
 *   - A tool that both files have gets its length from the table if its file says none. If both
 *     give a diameter or a length, then they must agree within 1e-6 mm.
 *   - A tool that only the table has gets the shape of the row `default`, with the diameter and the
 *     length of the table. If there is no such row, or if it does not suit the diameter, then
 *     nc_tools_find refuses the tool.
 * Errors: FORMAT if the files disagree, or if the holder of a tool of both files does not suit the
 * length; MEMORY. After a failure the tools may be completed in part; free them. */
bool nc_tools_complete(nc_tools *tools, const nc_tool *table, size_t count, const char *path,
                       sepax_error *error);

/* The tool that a program loads. NULL with an error (FORMAT) that names both files if the tool is
 * unknown, if its length is, or if the table has an offset other than Z, because then the axis of
 * the tool is not the axis of the spindle. */
const nc_turned_tool *nc_tools_find(const nc_tools *tools, int number, sepax_error *error);

/* "flat", "ball", ...; "flutes", "shank", "holder". */
const char *nc_tool_kind_name(nc_tool_kind kind);
const char *nc_tool_part_name(nc_tool_part part);

#endif
