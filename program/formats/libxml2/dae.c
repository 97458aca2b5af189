/* dae.c - DAE by assimp, which does not notice a document type, or a unit of 0. */
#include "formats/formats.h"
#include "formats/mesh_format_table.h"
#include "util/error.h"
#include "util/plain_numbers.h"

#include <libxml/xmlreader.h>
#include <string.h>

typedef struct {
  const char *path;
  double metres; /* of the first unit; 0: none yet */
} head;

static int line_of(xmlTextReader *in) { return xmlTextReaderGetParserLineNumber(in); }

/* Binary32, in which assimp has it, must hold it, and no coordinate leave its range by it. */
static bool read_unit(xmlTextReader *in, head *h, sepax_error *error) {
  static const double least = 1e-9;
  static const double most = 1e9;
  xmlChar *value = xmlTextReaderGetAttribute(in, (const xmlChar *)"meter");
  const char *text = value != NULL ? (const char *)value : "1";
  double metres = 0;
  bool ok = (format_number(text, strlen(text), &metres) && metres >= least && metres <= most) ||
            sepax_fail(error, SEPAX_ERROR_FORMAT,
                       "%.240s:%d: <unit meter=\"%.40s\">: give a number of 1e-9 ... 1e9", h->path,
                       line_of(in), text);
  ok = ok && (h->metres == 0 || (metres >= h->metres && metres <= h->metres) ||
              sepax_fail(error, SEPAX_ERROR_FORMAT,
                         "%.240s:%d: a second <unit>, of %.9g m after one of %.9g m; export "
                         "it in one",
                         h->path, line_of(in), metres, h->metres));
  h->metres = metres;
  xmlFree(value);
  return ok;
}

/* Node by node, nothing of it kept. What is no XML is left to assimp. */
static bool read_nodes(xmlTextReader *in, head *h, sepax_error *error) {
  while (xmlTextReaderRead(in) == 1) {
    int type = xmlTextReaderNodeType(in);
    if (type == XML_READER_TYPE_DOCUMENT_TYPE) {
      return sepax_fail(error, SEPAX_ERROR_FORMAT,
                        "%.240s: it has a document type (<!DOCTYPE>); take it out", h->path);
    }
    if (type == XML_READER_TYPE_ELEMENT &&
        strcmp((const char *)xmlTextReaderConstLocalName(in), "unit") == 0 &&
        !read_unit(in, h, error)) {
      return false;
    }
  }
  return true;
}

/* For a process of its own: of any length, without document type, with one unit. */
static bool is_right(const char *path, sepax_error *error) {
  enum { OPTIONS = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_HUGE };
  head h = {.path = path};
  xmlTextReader *in = xmlReaderForFile(path, NULL, OPTIONS);
  if (in == NULL) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: it cannot be read; give a readable file",
                      path);
  }
  plain_numbers plain = plain_numbers_begin();
  bool ok = read_nodes(in, &h, error);
  plain_numbers_end(plain);
  xmlFreeTextReader(in);
  return ok;
}

bool mesh_read_dae(sepax_soup *mesh, const char *path, sepax_error *error) {
  *mesh = (sepax_soup){0};
  return is_right(path, error) && mesh_read_assimp(mesh, path, error);
}
