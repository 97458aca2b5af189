/* SPDX-License-Identifier: MIT */
/* tools.c - tools of a file of tools, completed by a control's tool table. */
#include "nc/tools.h"
#include "nc/tool_rows.h"
#include "util/error.h"
#include "util/list.h"
#include "util/memory.h"
#include "util/plain_numbers.h"

#include <math.h>
#include <string.h>

/* Numbers of the two files that differ by less agree, in mm, because tables in inches are rounded.
 */
static const double same = 1e-4;

void nc_tools_free(nc_tools *tools) {
  for (size_t n = 0; n < tools->tools; n++) {
    nc_turned_tool_free(&tools->tool[n]);
  }
  if (tools->common != NULL) {
    nc_tool_row_free(tools->common);
  }
  sepax_release(tools->common);
  sepax_release(tools->tool);
  sepax_release(tools->path);
  sepax_release(tools->table);
  *tools = (nc_tools){0};
}

static bool no_memory(const nc_tools *tools, sepax_error *error) {
  return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.300s: no memory for its tools",
                    tools->path != NULL ? tools->path : "tools");
}

static char *copy_of(const char *text) {
  char *copy = sepax_allocate(strlen(text) + 1);
  return copy != NULL ? strcpy(copy, text) : NULL;
}

static nc_turned_tool *add_tool(nc_tools *tools, sepax_error *error) {
  nc_turned_tool *grown = list_grow(tools->tool, &tools->capacity, tools->tools, sizeof *grown);
  if (grown == NULL) {
    no_memory(tools, error);
    return NULL;
  }
  tools->tool = grown;
  grown[tools->tools] = (nc_turned_tool){0};
  return &grown[tools->tools];
}

/* -------------------------------------------------------------------- the file */

/* The row `default` moves to the tools. Its diameter and length are the table's. */
static bool take_common(nc_tools *tools, nc_tool_row *row, sepax_error *error) {
  if (row->kind == NC_TOOL_FORM || !isnan(row->value[TOOL_DIAMETER]) ||
      !isnan(row->value[TOOL_LENGTH])) {
    return nc_tool_refuse(row, error,
                          "diameter and length come from the tool table; leave these cells empty, "
                          "and give another kind than form");
  }
  tools->common = sepax_allocate(sizeof *tools->common);
  if (tools->common == NULL) {
    return no_memory(tools, error);
  }
  *tools->common = *row;
  tools->common->path = tools->path;
  *row = (nc_tool_row){0};
  return true;
}

static bool take_row(nc_tools *tools, nc_tool_row *row, sepax_error *error) {
  if (row->number < 0) {
    return take_common(tools, row, error);
  }
  nc_turned_tool *tool = add_tool(tools, error);
  if (tool == NULL || !nc_tool_shape(tool, row, error)) {
    return false;
  }
  tool->name = row->name;
  row->name = NULL;
  tools->tools++;
  return true;
}

bool nc_tools_read(nc_tools *tools, const char *path, sepax_error *error) {
  nc_tool_rows rows;
  *tools = (nc_tools){0};
  if (!nc_tool_rows_read(&rows, path, error)) {
    return false;
  }
  tools->path = copy_of(path);
  bool ok = tools->path != NULL || no_memory(tools, error);
  for (size_t n = 0; n < rows.rows && ok; n++) {
    ok = take_row(tools, &rows.row[n], error);
  }
  nc_tool_rows_free(&rows);
  if (!ok) {
    nc_tools_free(tools);
  }
  return ok;
}

/* ------------------------------------------------------------------- the table */

static nc_turned_tool *find(const nc_tools *tools, int number) {
  for (size_t n = 0; n < tools->tools; n++) {
    if (tools->tool[n].number == number) {
      return &tools->tool[n];
    }
  }
  return NULL;
}

static bool agree(double file, double table) {
  return isnan(file) || table == 0 || fabs(file - table) <= same;
}

static bool complete_one(const nc_tools *tools, nc_turned_tool *tool, const nc_tool *from,
                         sepax_error *error) {
  const nc_tool_row place = {.path = tools->path, .line = tool->line, .number = tool->number};
  const struct {
    const char *what;
    double file, table;
  } both[] = {{"diameter", tool->diameter, from->diameter},
              {"length", tool->length, from->offset[NC_Z]}};
  for (size_t n = 0; n < sizeof both / sizeof both[0]; n++) {
    if (!agree(both[n].file, both[n].table)) {
      return nc_tool_refuse(&place, error,
                            "its %s is %.9g mm, but %.9g mm in %.100s; mend one of the files",
                            both[n].what, both[n].file, both[n].table, tools->table);
    }
  }
  memcpy(tool->offset, from->offset, sizeof tool->offset);
  tool->length = isnan(tool->length) && from->offset[NC_Z] != 0 ? from->offset[NC_Z] : tool->length;
  return nc_tool_check_length(tool, &place, error);
}

/* Keep why a tool cannot be loaded. */
static bool keep_refusal(nc_tools *tools, nc_turned_tool *tool, const char *why,
                         sepax_error *error) {
  tool->refusal = copy_of(why);
  return tool->refusal != NULL || no_memory(tools, error);
}

/* A tool that only the table has. */
static bool add_common(nc_tools *tools, const nc_tool *from, sepax_error *error) {
  nc_turned_tool *tool = add_tool(tools, error);
  sepax_error why = {0};
  if (tool == NULL) {
    return false;
  }
  bool ok = true;
  if (tools->common == NULL) {
    snprintf(why.text, sizeof why.text,
             "%.180s: no tool %d, which %.180s has; add it, or a row 'default'", tools->path,
             from->number, tools->table);
  } else {
    nc_tool_row row = *tools->common;
    row.number = from->number;
    row.value[TOOL_DIAMETER] = from->diameter != 0 ? from->diameter : NAN;
    row.value[TOOL_LENGTH] = from->offset[NC_Z] != 0 ? from->offset[NC_Z] : NAN;
    ok = nc_tool_shape(tool, &row, &why) || why.code != SEPAX_ERROR_MEMORY;
  }
  tools->tools++;
  tool->number = from->number;
  memcpy(tool->offset, from->offset, sizeof tool->offset);
  tool->name = copy_of(from->comment != NULL ? from->comment : "");
  return ((ok && tool->name != NULL) || no_memory(tools, error)) &&
         (why.text[0] == '\0' || keep_refusal(tools, tool, why.text, error));
}

bool nc_tools_complete(nc_tools *tools, const nc_tool *table, size_t count, const char *path,
                       sepax_error *error) {
  tools->table = copy_of(path);
  bool ok = tools->table != NULL || no_memory(tools, error);
  plain_numbers plain = plain_numbers_begin();
  for (size_t n = 0; n < count && ok; n++) {
    nc_turned_tool *tool = find(tools, table[n].number);
    ok = tool != NULL ? complete_one(tools, tool, &table[n], error)
                      : add_common(tools, &table[n], error);
  }
  plain_numbers_end(plain);
  return ok;
}

/* --------------------------------------------------------------------- a tool */

static bool is_in_line(const nc_tools *tools, const nc_turned_tool *tool, sepax_error *error) {
  for (int axis = 0; axis < NC_AXES; axis++) {
    if (axis != NC_Z && tool->offset[axis] != 0) {
      return sepax_fail(error, SEPAX_ERROR_FORMAT,
                        "%.300s: tool %d has an offset %c of %g, so its axis is not the spindle's; "
                        "only offsets Z are supported",
                        tools->table, tool->number, nc_letter(axis), tool->offset[axis]);
    }
  }
  return true;
}

const nc_turned_tool *nc_tools_find(const nc_tools *tools, int number, sepax_error *error) {
  const nc_turned_tool *tool = find(tools, number);
  if (tool == NULL) {
    sepax_fail(error, SEPAX_ERROR_FORMAT, "%.300s: no tool %d; add a row for it", tools->path,
               number);
    return NULL;
  }
  if (tool->refusal != NULL) {
    sepax_fail(error, SEPAX_ERROR_FORMAT, "%s", tool->refusal);
    return NULL;
  }
  if (isnan(tool->length)) {
    sepax_fail(error, SEPAX_ERROR_FORMAT,
               "%.180s:%zu: tool %d: no length here and none in %.180s; give 'length'", tools->path,
               tool->line, number, tools->table != NULL ? tools->table : "a tool table");
    return NULL;
  }
  return is_in_line(tools, tool, error) ? tool : NULL;
}
