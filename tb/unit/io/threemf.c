/* SPDX-License-Identifier: MIT */
/* threemf.c - 3MF: the package, its model parts, what they build, and what is refused. */
#include "unit/io/reading.h"

#include <zip.h>

#define TYPES "<?xml version=\"1.0\"?><Types/>"
#define RELATION(target, rest)                     \
  "<Relationship Target='" target "' Id='r" target \
  "' Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel' " rest "/>"
#define RELATIONS(all)                                                                         \
  "<Relationships xmlns='http://schemas.openxmlformats.org/package/2006/relationships'>\n" all \
  "</Relationships>"
#define CORE "xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02' "
#define PRODUCTION "xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06' "
#define MODEL(attributes, inside) "<model " CORE attributes ">\n" inside "</model>"
#define RESOURCES(inside) "<resources>\n" inside "</resources>\n"
#define BUILD(inside) "<build>" inside "</build>\n"
#define ITEM(id, rest) "<item objectid='" id "' " rest "/>"
/* Four vertices: 0, x, y, z. */
#define VERTICES                                                                         \
  "<vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='2' " \
  "z='0'/><vertex x='0' y='0' z='3'/></vertices>\n"
#define FACE(a, b, c) "<triangle v1='" a "' v2='" b "' v3='" c "'/>"
#define MESH "<mesh>" VERTICES "<triangles>" FACE("0", "1", "2") "</triangles></mesh>"
#define OBJECT(id, inside) "<object id='" id "'>" inside "</object>\n"
#define COMPONENTS(inside) "<components>" inside "</components>"
#define COMPONENT(id, rest) "<component objectid='" id "' " rest "/>"
#define PLAIN(inside) MODEL("", RESOURCES(inside) BUILD(ITEM("1", "")))

/* An archive: names and texts in turn, up to NULL. */
static const char *put_archive(const char *const entry[], int method) {
  const char *at = in_folder("a.3mf");
  zip_t *zip = zip_open(at, ZIP_CREATE | ZIP_TRUNCATE, NULL);
  assert_non_null(zip);
  for (size_t n = 0; entry[n] != NULL; n += 2) {
    zip_source_t *source = zip_source_buffer(zip, entry[n + 1], strlen(entry[n + 1]), 0);
    zip_int64_t index = zip_file_add(zip, entry[n], source, ZIP_FL_ENC_UTF_8);
    assert_true(index >= 0);
    assert_int_equal(zip_set_file_compression(zip, (zip_uint64_t)index, method, 0), 0);
  }
  assert_int_equal(zip_close(zip), 0);
  return at;
}

static const char *put_model(const char *model) {
  const char *const entry[] = {
      "[Content_Types].xml", TYPES, "_rels/.rels", RELATIONS(RELATION("/3D/3dmodel.model", "")),
      "3D/3dmodel.model",    model, NULL};
  return put_archive(entry, ZIP_CM_DEFLATE);
}

static void read_archive(const char *at) {
  assert_works(sepax_mesh_read(&soup, &account, at, NULL, &fault));
  assert_string_equal(account.format, "3MF");
}

static void read_model(const char *model) { read_archive(put_model(model)); }

static void refuse_archive(const char *at, const char *part) {
  assert_fault(sepax_mesh_read(&soup, &account, at, NULL, &fault), part);
  assert_message("a.3mf");
}

static void refuse(const char *model, const char *part) { refuse_archive(put_model(model), part); }

static void assert_read(size_t faces, size_t triangles, size_t unplaced) {
  assert_int_equal(account.faces, faces);
  assert_int_equal(account.triangles, triangles);
  assert_int_equal(account.unplaced, unplaced);
  assert_int_equal(soup.count, triangles);
}

CASE(a_mesh) {
  read_model(PLAIN(OBJECT("1", MESH)));
  assert_read(1, 1, 0);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  assert_int_equal(account.others, 0);
  sepax_soup_free(&soup);
  /* Decimals are rounded once, to the nearest double; blanks around them are no harm. */
  read_model(PLAIN(OBJECT(
      "1", "<mesh><vertices><vertex x=' 0.1 ' y='-1e-3' z='16777217.25'/><vertex x='+.5' y='5' "
           "z='1E2'/></vertices><triangles>" FACE("0", "1", "1") "</triangles></mesh>")));
  TRIANGLE(0, 0.1, -1e-3, 16777217.25, .5, 5, 100, .5, 5, 100);
  sepax_soup_free(&soup);
}

CASE(units) {
  static const struct {
    const char *model, *unit;
    double mm;
  } given[] = {
      {PLAIN(OBJECT("1", MESH)), "millimeter", 1},
      {MODEL("unit='micron'", RESOURCES(OBJECT("1", MESH)) BUILD(ITEM("1", ""))), "micron", 0.001},
      {MODEL("unit='centimeter'", RESOURCES(OBJECT("1", MESH)) BUILD(ITEM("1", ""))), "centimeter",
       10},
      {MODEL("unit='inch'", RESOURCES(OBJECT("1", MESH)) BUILD(ITEM("1", ""))), "inch", 25.4},
      {MODEL("unit='foot'", RESOURCES(OBJECT("1", MESH)) BUILD(ITEM("1", ""))), "foot", 304.8},
      {MODEL("unit='meter'", RESOURCES(OBJECT("1", MESH)) BUILD(ITEM("1", ""))), "meter", 1000},
  };
  for (size_t n = 0; n < LENGTH(given); n++) {
    read_model(given[n].model);
    assert_string_equal(account.unit, given[n].unit);
    assert_true(account.unit_mm == given[n].mm);
    TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
    sepax_soup_free(&soup);
  }
  refuse(MODEL("unit='yard'", ""), "unit=\"yard\": give micron, millimeter");
}

CASE(transforms) {
  read_model(MODEL("", RESOURCES(OBJECT("1", MESH) OBJECT(
                           "2", COMPONENTS(COMPONENT("1", "transform='1 0 0 0 1 0 0 0 1 0 0 7'")
                                               COMPONENT("1", ""))))
                           BUILD(ITEM("2", "transform='0 1 0 -1 0 0 0 0 1 5 0 0'"))));
  assert_read(1, 2, 0);
  TRIANGLE(0, 5, 0, 7, 5, 1, 7, 3, 0, 7);
  TRIANGLE(1, 5, 0, 0, 5, 1, 0, 3, 0, 0);
  sepax_soup_free(&soup);
  /* A mirrored one keeps its outer side. */
  read_model(MODEL("", RESOURCES(OBJECT("1", MESH))
                           BUILD(ITEM("1", "transform='-1 0 0 0 1 0 0 0 1 0 0 0'"))));
  TRIANGLE(0, 0, 0, 0, 0, 2, 0, -1, 0, 0);
  sepax_soup_free(&soup);
#define MOVED(matrix) \
  MODEL("", RESOURCES(OBJECT("1", MESH)) BUILD(ITEM("1", "transform='" matrix "'")))
  refuse(MOVED("1 0 0 0 1 0 0 0 1 0 0"), "give 12 finite numbers");
  refuse(MOVED("1 0 0 0 1 0 0 0 1 0 0 0 1"), "give 12 finite numbers");
  refuse(MOVED("1 0 0 0 1 0 0 0 nan 0 0 0"), "give 12 finite numbers");
  refuse(MOVED("1 0 0 0 1 0 1 1 0 0 0 0"), "makes the object flat");
}

CASE(objects_that_are_not_built) {
  read_model(
      PLAIN(OBJECT("7", MESH) OBJECT("1", MESH) "<object id='9' type='other'>" MESH "</object>\n"));
  assert_read(3, 1, 2);
  sepax_soup_free(&soup);
  refuse(MODEL("", RESOURCES("<object id='9' type='other'>" MESH "</object>\n" OBJECT(
                       "1", COMPONENTS(COMPONENT("9", "")))) BUILD(ITEM("1", ""))),
         "3dmodel.model:7: it builds object 9, whose type is \"other\"");
  refuse(MODEL("", RESOURCES(OBJECT("7", MESH)) BUILD("")), "it has no triangles that it places");
  refuse(MODEL("", RESOURCES(OBJECT("7", MESH))), "it has no <build>");
  refuse(PLAIN(OBJECT("1", "<mesh>" VERTICES "<triangles>" FACE("0", "1", "2") //
                      "triangle v1='0'</triangles></mesh>")),
         "text between elements");
#define SMALL "1e-200 0 0 0 1e-200 0 0 0 1e-200 0 0 0"
  refuse(MODEL("", RESOURCES(OBJECT("1", MESH)
                                 OBJECT("2", COMPONENTS(COMPONENT("1", "transform='" SMALL "'"))))
                       BUILD(ITEM("2", "transform='" SMALL "'"))),
         "too small or too large for a double");
#define ALTERNATIVES "xmlns:mc='http://schemas.openxmlformats.org/markup-compatibility/2006' "
  refuse(MODEL(ALTERNATIVES,
               RESOURCES(OBJECT("1", MESH)) "<build><mc:AlternateContent/>" ITEM("1", "") //
               "</build>"),
         "<AlternateContent>: alternatives are not read");
  refuse(MODEL(ALTERNATIVES "mc:MustUnderstand='q'",
               RESOURCES(OBJECT("1", MESH)) BUILD(ITEM("1", ""))),
         "MustUnderstand=\"q\" is not read");
}

CASE(supports_and_what_is_not_printed_are_read) {
  read_model(MODEL("", RESOURCES("<object id='1' type='support'>" MESH "</object>\n")
                           BUILD(ITEM("1", "printable='0' partnumber='x'"))));
  assert_read(1, 1, 0);
  assert_int_equal(others("printing supports, which are read"), 1);
  assert_int_equal(others("items not to be printed, which are read"), 1);
  sepax_soup_free(&soup);
}

/* ------------------------------------------------------------ what is remarked on */

/* The tetrahedron of the vertices; its faces run clockwise, as seen from outside. */
#define INWARD FACE("0", "1", "2") FACE("0", "3", "1") FACE("0", "2", "3") FACE("1", "3", "2")
#define OUTWARD FACE("0", "2", "1") FACE("0", "1", "3") FACE("0", "3", "2") FACE("1", "2", "3")
#define SOLID(id, faces) OBJECT(id, "<mesh>" VERTICES "<triangles>" faces "</triangles></mesh>")

static void expect_remark(size_t n, const char *what, size_t count, const char *which) {
  assert_true(n < account.remarks);
  assert_string_equal(account.remark[n].what, what);
  assert_int_equal(account.remark[n].count, count);
  assert_string_equal(account.remark[n].which, which);
}

static const char inside_out[] = "meshes inside out, which are turned";

CASE(meshes_inside_out_are_turned) {
  read_model(PLAIN(SOLID("1", INWARD)));
  TRIANGLE(0, 0, 0, 0, 0, 2, 0, 1, 0, 0);
  TRIANGLE(3, 1, 0, 0, 0, 2, 0, 0, 0, 3);
  assert_int_equal(account.remarks, 1);
  expect_remark(0, inside_out, 1, "object 1");
  sepax_soup_free(&soup);
  read_model(PLAIN(SOLID("1", OUTWARD)));
  TRIANGLE(0, 0, 0, 0, 0, 2, 0, 1, 0, 0);
  assert_int_equal(account.remarks, 0);
  sepax_soup_free(&soup);
  /* Mirrored, and with it back: of each object once, and not of what is not placed. */
#define MIRROR "transform='1 0 0 0 1 0 0 0 -1 0 0 0'"
  read_model(MODEL("", RESOURCES(SOLID("1", INWARD) SOLID("3", INWARD) SOLID("4", INWARD))
                           BUILD(ITEM("1", MIRROR) ITEM("1", "") ITEM("4", ""))));
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  TRIANGLE(4, 0, 0, 0, 0, 2, 0, 1, 0, 0);
  expect_remark(0, inside_out, 2, "object 1, object 4");
  sepax_soup_free(&soup);
}

/* The volume of an open mesh, or of one whose sides cancel, says nothing; nor does that of a mesh
 * of which a triangle is turned. A cavity is wound inwards, but there is less of it. */
CASE(meshes_that_stay_as_they_are) {
#define HOLLOW                                                                                 \
  OBJECT("1",                                                                                  \
         "<mesh><vertices><vertex x='9' y='9' z='9'/><vertex x='-9' y='9' z='-9'/>"            \
         "<vertex x='9' y='-9' z='-9'/><vertex x='-9' y='-9' z='9'/><vertex x='1' y='1' "      \
         "z='1'/><vertex x='-1' y='1' z='-1'/><vertex x='1' y='-1' z='-1'/><vertex "           \
         "x='-1' y='-1' z='1'/></vertices><triangles>" FACE("0", "2", "1") FACE("0", "1", "3") \
             FACE("0", "3", "2") FACE("1", "2", "3") FACE("4", "5", "6") FACE("4", "7", "5")   \
                 FACE("4", "6", "7") FACE("5", "7", "6") "</triangles></mesh>")
  static const char *const models[] = {
      PLAIN(SOLID("1", FACE("0", "1", "2") FACE("0", "3", "1") FACE("0", "2", "3"))),
      PLAIN(SOLID("1",
                  FACE("0", "1", "2") FACE("0", "3", "1") FACE("0", "2", "3") FACE("1", "2", "3"))),
      PLAIN(SOLID("1", INWARD OUTWARD)),
      PLAIN(SOLID("1", FACE("0", "1", "2") FACE("0", "2", "1"))),
      PLAIN(HOLLOW),
  };
  for (size_t n = 0; n < LENGTH(models); n++) {
    read_model(models[n]);
    assert_int_equal(account.remarks, 0);
    if (n < 4) {
      TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
    }
    sepax_soup_free(&soup);
  }
}

/* Both sides of tetrahedra, in any order: rounding may leave a sum that is not 0. */
CASE(rounding_turns_nothing) {
  for (int n = 0; n < 200; n++) {
    static const char *const faces[8] = {
        FACE("0", "1", "2"), FACE("0", "2", "1"), FACE("0", "3", "1"), FACE("0", "1", "3"),
        FACE("0", "2", "3"), FACE("0", "3", "2"), FACE("1", "3", "2"), FACE("1", "2", "3")};
    int order[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    char text[3000] = "<model " CORE "><resources><object id='1'><mesh><vertices>";
    for (int k = 0; k < 4; k++) {
      snprintf(text + strlen(text), 120, "<vertex x='%.17g' y='%.17g' z='%.17g'/>", random_unit(),
               random_unit(), random_unit());
    }
    strcat(text, "</vertices><triangles>");
    for (int k = 8; k > 0; k--) {
      int at = random_below(k);
      strcat(text, faces[order[at]]);
      order[at] = order[k - 1];
    }
    strcat(text, "</triangles></mesh></object></resources>" BUILD(ITEM("1", "")) "</model>");
    read_model(text);
    assert_int_equal(account.remarks, 0);
    sepax_soup_free(&soup);
  }
}

/* Vertices of the same place are one vertex, though the file repeats them; -0 is 0. */
CASE(inside_out_by_places) {
  read_model(PLAIN(OBJECT(
      "1", "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' "
           "y='2' z='0'/><vertex x='0' y='0' z='3'/><vertex x='0' y='-0' z='3'/></vertices>"
           "<triangles>" FACE("0", "1", "2") FACE("0", "3", "1") FACE("0", "2", "4")
               FACE("1", "4", "2") "</triangles></mesh>")));
  expect_remark(0, inside_out, 1, "object 1");
  sepax_soup_free(&soup);
}

static const char *put_settings(const char *name, const char *settings) {
  const char *const entry[] = {"_rels/.rels",
                               RELATIONS(RELATION("/3D/3dmodel.model", "")),
                               "3D/3dmodel.model",
                               PLAIN(OBJECT("1", MESH)),
                               name,
                               settings,
                               NULL};
  return put_archive(entry, ZIP_CM_DEFLATE);
}

static void read_settings(const char *name, const char *settings) {
  read_archive(put_settings(name, settings));
  assert_read(1, 1, 0);
  assert_int_equal(others("parts of the package that are no models"), 1);
}

#define BAMBU "Metadata/model_settings.config"
#define PRUSA "Metadata/Slic3r_PE_model.config"
#define KEY(key, value) "<metadata type='volume' key='" key "' value='" value "'/>"
#define VOLUME(first, last, inside) \
  "<volume firstid='" first "' lastid='" last "'>" inside "<mesh edges_fixed='0'/></volume>"

/* What slicers say is no material is read, and named. */
CASE(volumes_of_slicers) {
  read_settings(BAMBU,
                "<?xml version='1.0'?><config><object id='3'><metadata key='name' "
                "value='modifier'/><part id='1' subtype='normal_part'/>"
                "<part id='2' subtype='modifier_part'><metadata key='name' value='x'/></part>"
                "<part id='4' subtype='negative_part'/></object><object id='7'>"
                "<part id='5' subtype='modifier_part'/><part id='6' "
                "subtype='support_blocker'/><part id='8' subtype='support_enforcer'/>"
                "<part id='9'/></object><plate/></config>");
  assert_int_equal(account.remarks, 4);
  expect_remark(0, "modifiers, which count as material", 2,
                "part 2 of object 3, part 5 of object 7");
  expect_remark(1, "negative volumes, which count as material", 1, "part 4 of object 3");
  expect_remark(2, "support blockers, which count as material", 1, "part 6 of object 7");
  expect_remark(3, "support enforcers, which count as material", 1, "part 8 of object 7");
  sepax_soup_free(&soup);
  read_settings(
      PRUSA,
      "<config><object id='1'>" VOLUME("0", "11", KEY("volume_type", "ModelPart")) VOLUME(
          "12", "23", KEY("name", "m") KEY("modifier", "1") KEY("volume_type", "ParameterModifier"))
          VOLUME("24", "35", KEY("volume_type", "NegativeVolume"))
              VOLUME("36", "47", KEY("modifier", "1")) VOLUME("48", "59", KEY("modifier", "0"))
                  VOLUME("60", "71", KEY("volume_type", "SupportBlocker"))
                      VOLUME("72", "83", KEY("volume_type", "SupportEnforcer")) //
      "</object></config>");
  assert_int_equal(account.remarks, 4);
  expect_remark(0, "modifiers, which count as material", 2,
                "triangles 12 ... 23 of object 1, triangles 36 ... 47 of object 1");
  expect_remark(1, "negative volumes, which count as material", 1,
                "triangles 24 ... 35 of object 1");
  sepax_soup_free(&soup);
  refuse_archive(put_settings(BAMBU, "<config><object></config>"),
                 "part Metadata/model_settings.config:1: ");
}

/* Names that have no space are told by "...", and counted. */
CASE(many_remarks) {
  static char text[100 * 60 + 100] = "<config><object id='3'>";
  for (int n = 0; n < 100; n++) {
    snprintf(text + strlen(text), 60, "<part id='%d' subtype='modifier_part'/>", n);
  }
  strcat(text, "</object></config>");
  read_settings(BAMBU, text);
  expect_remark(0, "modifiers, which count as material", 100,
                "part 0 of object 3, part 1 of object 3, part 2 of object 3, part 3 of object 3, "
                "part 4 of object 3, part 5 of object 3, part 6 of object 3, ...");
  sepax_soup_free(&soup);
}

/* Each part has its own objects; an extension is known by its namespace, whatever its prefix. */
CASE(production) {
  static const char root[] = MODEL(
      PRODUCTION "requiredextensions='p' xmlns:b='http://schemas.bambulab.com/package/2021'",
      "<metadata name='Application'>x</metadata>" RESOURCES(
          OBJECT("1", "<mesh>" VERTICES "<triangles>" FACE("1", "2", "3")
                          FACE("3", "2", "1") "</triangles></mesh>")
              OBJECT("2",
                     COMPONENTS(COMPONENT("1", "p:path='/3D/Objects/Object_1.model' p:UUID='u'"))))
          BUILD(
              ITEM("2", "p:UUID='v' auto_drop='1'") "<item objectid='1' p:path='/3D/x%20y.bin'/>"));
  static const char other[] =
      "<c:model xmlns:c='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'><c:resources>"
      "<c:object id='1'><c:mesh><c:vertices><c:vertex x='5' y='0' z='0'/><c:vertex x='6' y='0' "
      "z='0'/><c:vertex x='5' y='1' z='0'/></c:vertices><c:triangles><c:triangle v1='0' v2='1' "
      "v3='2' paint_color='4'/></c:triangles></c:mesh></c:object></c:resources></c:model>";
  const char *const entry[] = {"3d/3DMODEL.model",
                               root,
                               "3D/Objects/object_1.model",
                               other,
                               "3D/x y.bin",
                               PLAIN(OBJECT("1", MESH)),
                               "3D/alone.model",
                               PLAIN(OBJECT("1", MESH)),
                               "Metadata/model_settings.config",
                               "<config/>",
                               "__MACOSX/3D/._3dmodel.model",
                               "no XML",
                               "Metadata/plate_1.png",
                               "\x89PNG",
                               "_rels/.rels",
                               RELATIONS(RELATION("3D/3dmodel.model", "")),
                               NULL};
  for (int method = 0; method < 2; method++) {
    read_archive(put_archive(entry, method ? ZIP_CM_STORE : ZIP_CM_DEFLATE));
    assert_read(5, 2, 3);
    TRIANGLE(0, 5, 0, 0, 6, 0, 0, 5, 1, 0);
    TRIANGLE(1, 0, 0, 0, 1, 0, 0, 0, 2, 0);
    assert_int_equal(others("p:UUID attributes"), 2);
    assert_int_equal(others("paint_color attributes"), 1);
    assert_int_equal(others("metadata"), 1);
    assert_int_equal(others("images"), 1);
    assert_int_equal(others("parts of the package that are no models"), 2);
    assert_int_equal(others("build items of other parts than the first"), 2);
    sepax_soup_free(&soup);
  }
  refuse(MODEL(PRODUCTION, RESOURCES(OBJECT(
                               "1", COMPONENTS(COMPONENT("1", "p:path='/3D/b.model'")))) BUILD("")),
         "p:path=\"/3D/b.model\" is no part of the package");
}

CASE(extensions) {
  read_model(MODEL(
      "requiredextensions='m t' recommendedextensions='q' "
      "xmlns:m='http://schemas.microsoft.com/3dmanufacturing/material/2015/02' "
      "xmlns:t='http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07' "
      "xmlns:q='http://example.org/q'",
      "<q:note><q:part/></q:note>" RESOURCES(
          "<m:colorgroup id='5'><m:color color='#FF0000'/></m:colorgroup>"
          "<basematerials id='6'><base name='x' displaycolor='#FFFFFF'/></basematerials>" OBJECT(
              "1", "<mesh q:kind='x'>" VERTICES
                   "<triangles>" FACE("0", "1", "2") "</triangles><t:trianglesets/></mesh>"))
          BUILD(ITEM("1", ""))));
  assert_read(1, 1, 0);
  assert_int_equal(others("m:colorgroup elements"), 1);
  assert_int_equal(others("base materials"), 1);
  assert_int_equal(others("t:trianglesets elements"), 1);
  assert_int_equal(others("q:note elements"), 1);
  assert_int_equal(others("q:kind attributes"), 1);
  sepax_soup_free(&soup);
#define BEAMS "xmlns:b='http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02' "
  refuse(MODEL(BEAMS "requiredextensions='b'", ""),
         "3dmodel.model:1: it requires the extension b (http://schemas.microsoft.com/"
         "3dmanufacturing/beamlattice/2017/02), which is not read; export triangles alone");
  refuse(MODEL("xmlns:z='http://example.org/z' requiredextensions='z'", ""),
         "it requires the extension z (http://example.org/z)");
  refuse(MODEL("requiredextensions='z'", ""), "has no namespace of this prefix");
  /* What adds a surface is refused though the file does not require it. */
  refuse(MODEL(BEAMS, RESOURCES(OBJECT("1", "<mesh>" VERTICES "<triangles/><b:beamlattice/>"
                                            "</mesh>")) BUILD("")),
         "<beamlattice> of the extension");
}

CASE(the_core_is_strict) {
  refuse(PLAIN(OBJECT("1", MESH "<volume/>")), "<volume> in <object> is not in the specification");
  refuse(PLAIN("<object id='1' idd='2'>" MESH "</object>"),
         "<object idd=...> is not in the specification");
  refuse(PLAIN("<object q:id='1'>" MESH "</object>"), "q:id has a prefix without a namespace");
  refuse(PLAIN(OBJECT("1", MESH "<q:mesh/>")), "<mesh> in <object> is not in the specification");
  refuse(PLAIN("<object>" MESH "</object>"), "<object> without id=");
  refuse(PLAIN("<object id='one'>" MESH "</object>"), "id=\"one\": give a whole number");
  refuse(PLAIN("<object id='1' type='solid'>" MESH "</object>"), "type=\"solid\": give model");
  refuse(PLAIN(OBJECT("1", MESH) OBJECT("1", MESH)), "a second object 1; give each its own id");
  refuse(PLAIN(OBJECT("1", MESH MESH)), "a second <mesh>");
  refuse(PLAIN(OBJECT("1", MESH COMPONENTS(COMPONENT("2", "")))), "has a mesh and components");
  refuse(PLAIN(OBJECT("1", "")), "object 1 has neither a mesh nor components");
  refuse(PLAIN(OBJECT("2", MESH)), "object 1 is not in part 3D/3dmodel.model");
  refuse(PLAIN(OBJECT("1", COMPONENTS(COMPONENT("2", "")))), "3dmodel.model:3: object 2 is not in");
  refuse(PLAIN(OBJECT("1", COMPONENTS(COMPONENT("1", "")))), "has itself as a component");
#define FACES(triangles) \
  PLAIN(OBJECT("1", "<mesh>" VERTICES "<triangles>" triangles "</triangles></mesh>"))
  refuse(FACES(FACE("0", "1", "4")), "3dmodel.model:4: v3=\"4\", but the mesh has 4 vertices");
  refuse(FACES(FACE("0", "1", "-1")), "v3=\"-1\": give a whole number");
  refuse(FACES("<triangle v1='0' v2='1'/>"), "<triangle> without v1, v2 and v3");
  refuse(PLAIN(OBJECT("1", "<mesh><vertices><vertex x='0' y='0'/></vertices></mesh>")),
         "<vertex> without x, y and z");
  refuse(PLAIN(OBJECT("1", "<mesh><vertices><vertex x='0' y='0' z='1,5'/></vertices></mesh>")),
         "z=\"1,5\": give a finite number");
  refuse(PLAIN(OBJECT("1", "<mesh><vertices><vertex x='0' y='0' z='inf'/></vertices></mesh>")),
         "z=\"inf\": give a finite number");
  refuse(PLAIN(OBJECT("1", "<mesh><triangles/></mesh>")), "<triangles> before <vertices>");
  refuse("<model/>", "its root is no <model> of http");
  refuse("<!DOCTYPE model [<!ENTITY e 'x'>]>" PLAIN(OBJECT("1", MESH)), "it has a document type");
  refuse("<model " CORE ">", "mend the XML");
  refuse("", "it is empty");
  refuse("\xff\xfe<?", "mend the XML");
  /* In what is passed over, triangles are still counted. */
  refuse(PLAIN(OBJECT("1", MESH "<q:a xmlns:q='b'>" FACE("0", "1", "2") "</q:a>")),
         "1 faces were read, but a second count finds 2");
}

CASE(the_second_count_knows_xml) {
  read_model("<?xml version='1.0'?><!-- <triangle/> -->" PLAIN(
      OBJECT("1", MESH "<!-- <triangle/> --><!--><triangle/>--><!---><triangle/>-->")));
  assert_read(1, 1, 0);
  sepax_soup_free(&soup);
  read_model(MODEL("", "<metadata name='a>b'><![CDATA[<triangle/>]]>&lt;triangle/></metadata>"
                       "<?x <triangle ?>" RESOURCES(OBJECT("1", MESH)) BUILD(ITEM("1", ""))));
  assert_read(1, 1, 0);
  sepax_soup_free(&soup);
}

CASE(packages) {
  static const char model[] = PLAIN(OBJECT("1", MESH));
#define PACKAGE(relations) \
  (const char *const[]){"_rels/.rels", (relations), "3D/a.model", model, NULL}
  refuse_archive(put_archive((const char *const[]){"3D/a.model", model, NULL}, ZIP_CM_STORE),
                 "the archive has no part _rels/.rels, so it is no 3MF");
  refuse_archive(put_archive(PACKAGE(RELATIONS("")), ZIP_CM_STORE), "no relationship to a 3dmodel");
  refuse_archive(put_archive(PACKAGE(RELATIONS(RELATION("/3D/b.model", ""))), ZIP_CM_STORE),
                 "its model /3D/b.model is not in the package");
  refuse_archive(
      put_archive(PACKAGE(RELATIONS(RELATION("http://a.example/3D/a.model", ""))), ZIP_CM_STORE),
      "its model http://a.example/3D/a.model is outside of the package");
  refuse_archive(put_archive(PACKAGE(RELATIONS(RELATION("/3D/a.model", "TargetMode='External'"))),
                             ZIP_CM_STORE),
                 "is outside of the package");
  refuse_archive(
      put_archive(PACKAGE(RELATIONS(RELATION("/3D/a.model", "") RELATION("/3D/a.model", ""))),
                  ZIP_CM_STORE),
      "a second model");
  refuse_archive(put_archive(PACKAGE("<Relationships/>"), ZIP_CM_STORE), "no <Relationships> of");
  refuse_archive(put_archive((const char *const[]){"3D/a.model", model, "3d/A.model", model, NULL},
                             ZIP_CM_STORE),
                 "two parts have the name");
  refuse_archive(put_bytes("a.3mf", "PK\3\4 and no more", 16), "the archive cannot be opened");
}

/* 70 MiB of blanks, which pack into 70 KiB. */
CASE(a_bomb) {
  enum { SIZE = 70 << 20 };
  char *text = malloc(SIZE + 1);
  assert_non_null(text);
  memset(text, ' ', SIZE);
  text[0] = '<';
  text[SIZE] = '\0';
  refuse(text, "part 3D/3dmodel.model: it would unpack to more than 100 times its length");
  free(text);
}

/* Tags that would take libxml2 long: the time grows with the square of either. */
CASE(long_tags) {
  enum { SIZE = 2 << 20 };
  char *text = malloc(SIZE + 1);
  assert_non_null(text);
  int used = sprintf(text, "<model " CORE "><!-- ' <a \" --><![CDATA[<b ']]><?c ' ?><q:z d='>' ");
  for (int n = 0; n < 1001; n++) {
    used += sprintf(text + used, " a%d='>'", n);
  }
  strcpy(text + used, "/></model>");
  refuse(text, "a tag or comment of more than 1000 attributes or 1 MiB; simplify it");
  used = sprintf(text, "<model " CORE "><z a='");
  memset(text + used, 'x', (size_t)(SIZE - used));
  text[SIZE] = '\0';
  refuse(text, "a tag or comment of more than 1000 attributes or 1 MiB; simplify it");
  free(text);
}

/* A byte of the packed model is turned over. */
CASE(a_damaged_archive) {
  const char *at = put_model(PLAIN(OBJECT("1", MESH)));
  FILE *file = fopen(at, "r+b");
  assert_non_null(file);
  char bytes[4000];
  size_t size = fread(bytes, 1, sizeof bytes, file);
  fclose(file);
  size_t begin = 0;
  while (memcmp(bytes + begin, "3D/3dmodel.model", 16) != 0) {
    begin++;
  }
  bytes[begin + 60] ^= 4;
  refuse_archive(put_bytes("a.3mf", bytes, size), "part 3D/3dmodel.model");
}

/* Each object has the next one twice: 2^60 triangles, which are refused at once; and 2^60 times
 * nothing, which takes no time. */
CASE(components_that_double) {
  enum { LEVELS = 60 };
  for (int with = 0; with < 2; with++) {
    static char text[20000];
    int used = snprintf(text, sizeof text, "<model " CORE "><resources>%s", OBJECT("999", MESH));
    for (int n = 1; n <= LEVELS; n++) {
      used += snprintf(text + used, sizeof text - (size_t)used,
                       "<object id='%d'><components><component objectid='%d'/>"
                       "<component objectid='%d'/></components></object>",
                       n, n + 1, n + 1);
    }
    snprintf(text + used, sizeof text - (size_t)used,
             "<object id='%d'><mesh>" VERTICES "<triangles>%s</triangles></mesh></object>"
             "</resources><build><item objectid='1'/><item objectid='999'/></build></model>",
             LEVELS + 1, with ? FACE("0", "1", "2") : "");
    if (with) {
      refuse(text, "simplify it");
      assert_int_equal(fault.code, SEPAX_ERROR_LIMIT);
    } else {
      read_model(text);
      assert_read(1, 1, 0);
      sepax_soup_free(&soup);
    }
  }
}

CASE(a_limit_of_triangles) {
  const sepax_mesh_reading how = {.size = sizeof how, .most = 2};
  const char *at = put_model(
      MODEL("", RESOURCES(OBJECT("1", MESH)) BUILD(ITEM("1", "") ITEM("1", "") ITEM("1", ""))));
  assert_fault(sepax_mesh_read(&soup, &account, at, &how, &fault),
               "its items make more than 2 triangles");
  assert_int_equal(fault.code, SEPAX_ERROR_LIMIT);
}

CASE(each_allocation_refused) { refuse_each_allocation(put_model(PLAIN(OBJECT("1", MESH)))); }
