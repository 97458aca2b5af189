/* SPDX-License-Identifier: MIT */
/* mesh_writer.c - a torus of 2 * AROUND * ALONG triangles as a file of each format, to be read by
 * readers that are timed.
 *   mesh_writer AROUND ALONG FOLDER   writes ascii.stl, binary.stl, torus.obj, ascii.ply,
 * binary.ply, torus.dae and, where libzip is installed, torus.3mf
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef ZIP
#include <zip.h>
#endif

typedef struct {
  int around, along;
  size_t vertices, triangles;
  float (*vertex)[3];
  int32_t (*triangle)[3];
  const char *folder;
} torus;

static void *space(size_t count, size_t size) {
  void *memory = calloc(count, size);
  if (memory == NULL) {
    fputs("mesh_writer: no memory\n", stderr);
    exit(2);
  }
  return memory;
}

static torus make(int around, int along, const char *folder) {
  torus t = {.folder = folder};
  t.around = around;
  t.along = along;
  t.vertices = (size_t)around * (size_t)along;
  t.triangles = 2 * t.vertices;
  t.vertex = space(t.vertices, sizeof *t.vertex);
  t.triangle = space(t.triangles, sizeof *t.triangle);
  const double turn = 2 * acos(-1);
  for (int32_t n = 0; n < around; n++) {
    for (int32_t k = 0; k < along; k++) {
      double a = turn * n / around;
      double b = turn * k / along;
      float *v = t.vertex[n * along + k];
      v[0] = (float)((100 + 30 * cos(b)) * cos(a));
      v[1] = (float)((100 + 30 * cos(b)) * sin(a));
      v[2] = (float)(30 * sin(b));
      int32_t corner[2][2];
      for (int i = 0; i < 4; i++) {
        corner[i / 2][i % 2] = (n + i / 2) % around * along + (k + i % 2) % along;
      }
      int32_t *one = t.triangle[2 * (n * along + k)];
      int32_t *other = t.triangle[2 * (n * along + k) + 1];
      one[0] = other[0] = corner[0][0];
      one[1] = corner[1][0];
      one[2] = other[1] = corner[1][1];
      other[2] = corner[0][1];
    }
  }
  return t;
}

static FILE *open_file(const torus *t, const char *name) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s", t->folder, name);
  FILE *out = fopen(path, "wb");
  if (out == NULL) {
    perror(path);
    exit(2);
  }
  return out;
}

static void close_file(FILE *out) {
  if (ferror(out) != 0 || fclose(out) != 0) {
    perror("mesh_writer");
    exit(2);
  }
}

static void write_ascii_stl(const torus *t) {
  FILE *out = open_file(t, "ascii.stl");
  fputs("solid torus\n", out);
  for (size_t n = 0; n < t->triangles; n++) {
    fputs("facet normal 0.0 0.0 1.0\nouter loop\n", out);
    for (int k = 0; k < 3; k++) {
      const float *v = t->vertex[t->triangle[n][k]];
      fprintf(out, "vertex %.9g %.9g %.9g\n", (double)v[0], (double)v[1], (double)v[2]);
    }
    fputs("endloop\nendfacet\n", out);
  }
  fputs("endsolid torus\n", out);
  close_file(out);
}

static void write_binary_stl(const torus *t) {
  FILE *out = open_file(t, "binary.stl");
  char title[80] = "torus";
  uint32_t count = (uint32_t)t->triangles;
  fwrite(title, 1, sizeof title, out);
  fwrite(&count, sizeof count, 1, out);
  for (size_t n = 0; n < t->triangles; n++) {
    float facet[12] = {0, 0, 1};
    for (int k = 0; k < 3; k++) {
      memcpy(facet + 3 + 3 * k, t->vertex[t->triangle[n][k]], sizeof *t->vertex);
    }
    fwrite(facet, sizeof facet, 1, out);
    fwrite("\0", 2, 1, out);
  }
  close_file(out);
}

static void write_obj(const torus *t) {
  FILE *out = open_file(t, "torus.obj");
  for (size_t n = 0; n < t->vertices; n++) {
    const float *v = t->vertex[n];
    fprintf(out, "v %.9g %.9g %.9g\n", (double)v[0], (double)v[1], (double)v[2]);
  }
  for (size_t n = 0; n < t->triangles; n++) {
    const int32_t *c = t->triangle[n];
    fprintf(out, "f %d %d %d\n", c[0] + 1, c[1] + 1, c[2] + 1);
  }
  close_file(out);
}

static void write_ply_head(const torus *t, FILE *out, const char *format) {
  fprintf(out,
          "ply\nformat %s 1.0\nelement vertex %zu\nproperty float x\nproperty float y\n"
          "property float z\nelement face %zu\nproperty list uchar int vertex_indices\n"
          "end_header\n",
          format, t->vertices, t->triangles);
}

static void write_ascii_ply(const torus *t) {
  FILE *out = open_file(t, "ascii.ply");
  write_ply_head(t, out, "ascii");
  for (size_t n = 0; n < t->vertices; n++) {
    const float *v = t->vertex[n];
    fprintf(out, "%.9g %.9g %.9g\n", (double)v[0], (double)v[1], (double)v[2]);
  }
  for (size_t n = 0; n < t->triangles; n++) {
    const int32_t *c = t->triangle[n];
    fprintf(out, "3 %d %d %d\n", c[0], c[1], c[2]);
  }
  close_file(out);
}

static void write_binary_ply(const torus *t) {
  FILE *out = open_file(t, "binary.ply");
  write_ply_head(t, out, "binary_little_endian");
  fwrite(t->vertex, sizeof *t->vertex, t->vertices, out);
  for (size_t n = 0; n < t->triangles; n++) {
    fputc(3, out);
    fwrite(t->triangle[n], sizeof *t->triangle, 1, out);
  }
  close_file(out);
}

static void write_dae(const torus *t) {
  FILE *out = open_file(t, "torus.dae");
  fprintf(out,
          "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
          "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n"
          "<asset><unit name=\"meter\" meter=\"1\"/><up_axis>Z_UP</up_axis></asset>\n"
          "<library_geometries><geometry id=\"g\"><mesh><source id=\"p\">\n"
          "<float_array id=\"a\" count=\"%zu\">\n",
          3 * t->vertices);
  for (size_t n = 0; n < t->vertices; n++) {
    const float *v = t->vertex[n];
    fprintf(out, "%.9g %.9g %.9g\n", (double)v[0], (double)v[1], (double)v[2]);
  }
  fprintf(out,
          "</float_array><technique_common><accessor source=\"#a\" count=\"%zu\" stride=\"3\">\n"
          "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
          "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>\n"
          "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>\n"
          "<triangles count=\"%zu\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>\n",
          t->vertices, t->triangles);
  for (size_t n = 0; n < t->triangles; n++) {
    const int32_t *c = t->triangle[n];
    fprintf(out, "%d %d %d\n", c[0], c[1], c[2]);
  }
  fputs("</p></triangles></mesh></geometry></library_geometries>\n"
        "<library_visual_scenes><visual_scene id=\"s\"><node id=\"n\">"
        "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>\n"
        "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n",
        out);
  close_file(out);
}

#ifdef ZIP
static void write_model(const torus *t) {
  FILE *out = open_file(t, "model");
  fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
        "<resources><object id=\"1\" type=\"model\"><mesh><vertices>\n",
        out);
  for (size_t n = 0; n < t->vertices; n++) {
    const float *v = t->vertex[n];
    fprintf(out, "<vertex x=\"%.9g\" y=\"%.9g\" z=\"%.9g\"/>\n", (double)v[0], (double)v[1],
            (double)v[2]);
  }
  fputs("</vertices><triangles>\n", out);
  for (size_t n = 0; n < t->triangles; n++) {
    const int32_t *c = t->triangle[n];
    fprintf(out, "<triangle v1=\"%d\" v2=\"%d\" v3=\"%d\"/>\n", c[0], c[1], c[2]);
  }
  fputs("</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>\n",
        out);
  close_file(out);
}

static bool add_text(zip_t *zip, const char *name, const char *text) {
  zip_source_t *source = zip_source_buffer(zip, text, strlen(text), 0);
  return zip_file_add(zip, name, source, 0) >= 0;
}

static void write_3mf(const torus *t) {
  static const char types[] =
      "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
      "<Default Extension=\"rels\" "
      "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
      "<Default Extension=\"model\" "
      "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>";
  static const char root[] =
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
      "<Relationship Target=\"/3D/3dmodel.model\" Id=\"r\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
  char path[4096];
  char model[4096];
  write_model(t);
  snprintf(path, sizeof path, "%s/torus.3mf", t->folder);
  snprintf(model, sizeof model, "%s/model", t->folder);
  int status;
  zip_t *zip = zip_open(path, ZIP_CREATE | ZIP_TRUNCATE, &status);
  if (zip == NULL || !add_text(zip, "[Content_Types].xml", types) ||
      !add_text(zip, "_rels/.rels", root) ||
      zip_file_add(zip, "3D/3dmodel.model", zip_source_file(zip, model, 0, -1), 0) < 0 ||
      zip_close(zip) != 0 || remove(model) != 0) {
    fprintf(stderr, "mesh_writer: %s cannot be written\n", path);
    exit(2);
  }
}
#else
static void write_3mf(const torus *t) { (void)t; }
#endif

int main(int count, char **words) {
  int around = count == 4 ? atoi(words[1]) : 0;
  int along = count == 4 ? atoi(words[2]) : 0;
  if (around < 3 || along < 3 || around > 20000 || along > 20000) {
    fputs("usage: mesh_writer AROUND ALONG FOLDER\n", stderr);
    return 2;
  }
  torus t = make(around, along, words[3]);
  write_ascii_stl(&t);
  write_binary_stl(&t);
  write_obj(&t);
  write_ascii_ply(&t);
  write_binary_ply(&t);
  write_dae(&t);
  write_3mf(&t);
  free(t.vertex);
  free(t.triangle);
  return 0;
}
