/* SPDX-License-Identifier: MIT */
/* mesh.c - what a mesh file has, as text and as JSON. */
#include "report/mesh.h"
#include "report/json.h"
#include "report/text.h"

#include <stdio.h>
#include <string.h>

bool report_mesh_is_plain(const report_mesh *mesh) {
  const sepax_mesh_account *a = &mesh->account;
  return a->others == 0 && a->remarks == 0 && a->divided == 0 && a->unplaced == 0 &&
         a->unit_mm <= 0 && mesh->unit_mm <= 0 && !mesh->welded;
}

/* ----------------------------------------------------------------------- text */

static void print_unit(int width, const report_mesh *mesh) {
  const sepax_mesh_account *a = &mesh->account;
  if (a->unit_mm <= 0 && mesh->unit_mm <= 0) {
    return;
  }
  printf("%*s", width, "");
  if (a->unit_mm > 0) {
    printf("its unit is %s%s%s mm", a->unit, a->unit[0] != '\0' ? ", " : "",
           report_exactly(a->unit_mm).text);
    /* a URDF's unit is the metre; DAE alone is converted to it */
    bool of_urdf = mesh->unit == 0 && strcmp(a->format, "DAE") != 0 && mesh->unit_mm <= 0;
    fputs(of_urdf ? "; 1 mm of it is 1 of the URDF before its scale" : "", stdout);
  }
  if (mesh->unit_mm > 0) {
    printf("%sa unit is taken to be %s mm (--unit)", a->unit_mm > 0 ? ", but " : "",
           report_exactly(mesh->unit_mm).text);
  }
  putchar('\n');
}

static void print_others(int width, const sepax_mesh_account *a) {
  for (size_t n = 0; n < a->others; n++) {
    if (n == 0) {
      printf("%*swithout a surface: ", width, "");
    }
    printf("%s%zu %s", n > 0 ? ", " : "", a->other[n].count, a->other[n].what);
  }
  fputs(a->others > 0 ? "\n" : "", stdout);
}

static void print_faces(int width, const sepax_mesh_account *a) {
  if (a->divided > 0) {
    printf("%*s", width, "");
    report_print_count(a->divided, "polygon");
    printf(" divided into triangles, %zu of them bent", a->bent);
    puts(a->bent > 0 ? ": no plane has all their corners" : "");
  }
  if (a->fans > 0) {
    printf("%*sof these, divided from the first corner because they cross themselves: %zu "
           "(--polygons=fan)\n",
           width, "", a->fans);
  }
  if (a->unplaced > 0) {
    printf("%*s", width, "");
    report_print_count(a->unplaced, "face");
    puts(" left out, because the file places their meshes nowhere");
  }
}

static void print_remarks(int width, const sepax_mesh_account *a) {
  for (size_t n = 0; n < a->remarks; n++) {
    const sepax_mesh_remark *r = &a->remark[n];
    printf("%*s%s: %zu (%s)\n", width, "", r->what, r->count, r->which);
  }
}

static void print_weld(int width, const report_mesh *mesh) {
  const sepax_weld *w = &mesh->weld;
  if (!mesh->welded) {
    return;
  }
  printf("%*swelded within %s mm: ", width, "",
         report_exactly(report_mm(w->length, mesh->unit)).text);
  printf("%zu vertices moved, by up to %.3g mm; %zu triangles without area and %zu that were "
         "there twice are left out; %zu edges divided; the verdict is that of the welded body\n",
         w->moved, report_mm(w->farthest, mesh->unit), w->degenerate, w->duplicates, w->divided);
}

void report_print_mesh(const char *name, int width, const char *path, const report_mesh *mesh) {
  const sepax_mesh_account *a = &mesh->account;
  printf("%-*s%s, %s, ", width, name, path, a->format);
  report_print_count(a->triangles, "triangle");
  putchar('\n');
  print_unit(width, mesh);
  print_faces(width, a);
  print_others(width, a);
  print_remarks(width, a);
  print_weld(width, mesh);
}

/* ----------------------------------------------------------------------- JSON */

static json_t *others_of(const sepax_mesh_account *a) {
  json_t *others = json_object();
  for (size_t n = 0; n < a->others; n++) {
    report_set_count(others, a->other[n].what, a->other[n].count);
  }
  return others;
}

static json_t *remarks_of(const sepax_mesh_account *a) {
  json_t *remarks = json_array();
  for (size_t n = 0; n < a->remarks; n++) {
    const sepax_mesh_remark *r = &a->remark[n];
    json_array_append_new(remarks, json_pack("{s:s, s:I, s:s}", "what", r->what, "count",
                                             (json_int_t)r->count, "which", r->which));
  }
  return remarks;
}

static json_t *weld_of(const report_mesh *mesh) {
  const sepax_weld *w = &mesh->weld;
  return json_pack("{s:f, s:I, s:f, s:I, s:I, s:I}", "length_mm", report_mm(w->length, mesh->unit),
                   "moved", (json_int_t)w->moved, "farthest_mm", report_mm(w->farthest, mesh->unit),
                   "without_area", (json_int_t)w->degenerate, "twice", (json_int_t)w->duplicates,
                   "edges_divided", (json_int_t)w->divided);
}

void report_set_mesh(json_t *to, const report_mesh *mesh) {
  const sepax_mesh_account *a = &mesh->account;
  json_object_set_new(to, "format", json_string(a->format));
  json_object_set_new(to, "unit_mm",
                      mesh->unit_mm > 0 ? json_real(mesh->unit_mm)
                      : a->unit_mm > 0  ? json_real(a->unit_mm)
                                        : json_null());
  report_set_count(to, "faces", a->faces);
  report_set_count(to, "polygons", a->divided);
  report_set_count(to, "polygons_bent", a->bent);
  report_set_count(to, "polygons_as_fans", a->fans);
  report_set_count(to, "faces_unplaced", a->unplaced);
  json_object_set_new(to, "without_surface", others_of(a));
  json_object_set_new(to, "remarks", remarks_of(a));
  if (mesh->welded) {
    json_object_set_new(to, "welded", weld_of(mesh));
  }
}
