/* SPDX-License-Identifier: MIT */
/* dae.c - COLLADA: what becomes triangles, what is named, and what is refused with its line. */
#include "unit/io/reading.h"

#include <math.h>

#define SPACE14 "http://www.collada.org/2005/11/COLLADASchema"
#define ROOT "<COLLADA xmlns='" SPACE14 "' version='1.4.1'>\n"
#define ASSET "<asset><unit name='meter' meter='1'/><up_axis>Z_UP</up_axis></asset>\n"
/* Four vertices: 0, x, y, z. */
#define SOURCE                                                                            \
  "<source id='p'><float_array id='a' count='12'>0 0 0 1 0 0 0 2 0 0 0 3</float_array>"   \
  "<technique_common><accessor source='#a' count='4' stride='3'><param name='X' "         \
  "type='float'/><param name='Y' type='float'/><param name='Z' type='float'/></accessor>" \
  "</technique_common></source><vertices id='v'><input semantic='POSITION' source='#p'/>" \
  "</vertices>\n"
#define VERTEX "<input semantic='VERTEX' source='#v' offset='0'/>"
#define ONE "<triangles count='1'>" VERTEX "<p>0 1 2</p></triangles>\n"
#define GEOMETRY(id, primitives) \
  "<geometry id='" id "'><mesh>\n" SOURCE primitives "</mesh></geometry>\n"
#define GEOMETRIES(all) "<library_geometries>\n" all "</library_geometries>\n"
#define SCENE(nodes)                                     \
  "<library_visual_scenes><visual_scene id='s'>\n" nodes \
  "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>\n"
#define NODE(inside) "<node>" inside "<instance_geometry url='#g'/></node>\n"
#define END "</COLLADA>\n"
#define MESH(primitives) ROOT ASSET GEOMETRIES(GEOMETRY("g", primitives)) SCENE(NODE("")) END
#define PLACED(nodes) ROOT ASSET GEOMETRIES(GEOMETRY("g", ONE)) SCENE(nodes) END

static void read_text(const char *text) {
  assert_works(sepax_mesh_read(&soup, &account, put_file("a.dae", text), NULL, &fault));
  assert_string_equal(account.format, "DAE");
}

static void refuse(const char *text, const char *part) {
  assert_fault(sepax_mesh_read(&soup, &account, put_file("a.dae", text), NULL, &fault), part);
  assert_message("a.dae");
}

static void assert_read(size_t faces, size_t triangles) {
  assert_int_equal(account.faces, faces);
  assert_int_equal(account.triangles, triangles);
  assert_int_equal(soup.count, triangles);
}

CASE(primitives) {
  read_text(MESH(ONE));
  assert_read(1, 1);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  assert_int_equal(account.others, 0);
  sepax_soup_free(&soup);
  read_text(MESH("<polylist count='3'>" VERTEX "<vcount>3 4 3</vcount>"
                 "<p>0 1 2 0 1 2 3 3 2 1</p></polylist>"
                 "<polygons count='1'>" VERTEX "<p>0 2 3</p></polygons>"));
  assert_read(4, 5);
  assert_int_equal(account.divided, 1);
  TRIANGLE(4, 0, 0, 0, 0, 2, 0, 0, 0, 3);
  sepax_soup_free(&soup);
  read_text(MESH("<tristrips count='2'>" VERTEX "<p>0 1 2 3</p><p>3 2 1</p></tristrips>"
                 "<trifans count='1'>" VERTEX "<p>0 1 2 3</p></trifans>"));
  assert_read(3, 5);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  TRIANGLE(1, 0, 2, 0, 1, 0, 0, 0, 0, 3); /* turned over, as strips are */
  TRIANGLE(4, 0, 0, 0, 0, 2, 0, 0, 0, 3);
  sepax_soup_free(&soup);
}

/* Corners that are no triangle are a segment or a point of the surface. */
CASE(polygons_of_one_or_two_corners) {
  read_text(MESH(ONE "<polylist count='2'>" VERTEX "<vcount>2 1</vcount><p>0 1 3</p></polylist>"));
  assert_read(3, 3);
  TRIANGLE(1, 0, 0, 0, 1, 0, 0, 1, 0, 0);
  TRIANGLE(2, 0, 0, 3, 0, 0, 3, 0, 0, 3);
  sepax_soup_free(&soup);
  refuse(MESH("<polylist count='1'>" VERTEX "<vcount>0</vcount><p/></polylist>"),
         "a.dae:6: polygon 0 has no corners");
}

CASE(offsets_of_inputs) {
  read_text(MESH("<triangles count='1'><input semantic='NORMAL' source='#n' offset='0'/>"
                 "<input semantic='VERTEX' source='#v' offset='2'/>"
                 "<input semantic='TEXCOORD' source='#t' offset='1' set='0'/>"
                 "<p>9 9 0 9 9 1 9 9 3</p></triangles>"));
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 0, 3);
  assert_int_equal(others("inputs NORMAL"), 1);
  assert_int_equal(others("inputs TEXCOORD"), 1);
  sepax_soup_free(&soup);
}

#define ACCESSED(count, array, accessor)                                                        \
  ROOT "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' "         \
       "count='" count "'>" array "</float_array><technique_common>\n" accessor                 \
       "</accessor></technique_common></source><vertices id='v'><input semantic='POSITION' "    \
       "source='#p'/></vertices>" ONE "</mesh></geometry></library_geometries>" SCENE(NODE("")) \
           END
#define PARAM(name) "<param name='" name "' type='float'/>"

CASE(accessors) {
  read_text(ACCESSED("14", "9 9 0 0 0 5 1 0 0 5 0 1e0 .1 5",
                     "<accessor source='#a' count='3' offset='2' stride='4'>" PARAM("X") PARAM("Y")
                         PARAM("Z")));
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 1, 0.1);
  sepax_soup_free(&soup);
  read_text(ACCESSED("9", "0 0 1 0 1 0 1 0 0",
                     "<accessor source='#a' count='3' stride='3'>" PARAM("Z") PARAM("Y")
                         PARAM("X")));
  TRIANGLE(0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
  sepax_soup_free(&soup);
  read_text(ACCESSED("12", "7 0 0 1 7 0 1 0 7 1 0 0",
                     "<accessor source='#a' count='3' stride='4'><param type='float'/>" PARAM("X")
                         PARAM("Y") PARAM("Z")));
  TRIANGLE(0, 0, 0, 1, 0, 1, 0, 1, 0, 0);
  sepax_soup_free(&soup);
#define THREE PARAM("X") PARAM("Y") PARAM("Z")
  refuse(ACCESSED("9", "0 0 1 0 1 0 1 0 0", "<accessor source='#a' count='4' stride='3'>" THREE),
         "a.dae:3: <accessor> takes 4 elements of 3 numbers from number 0, but the array has 9");
  refuse(ACCESSED("9", "0.0 0 1 0 1 0 1 0", "<accessor source='#a' count='3' stride='3'>" THREE),
         "<float_array> has 8 numbers, not 9");
  refuse(ACCESSED("4000000000", "0 0 1", "<accessor source='#a' count='3' stride='3'>" THREE),
         "<float_array count=\"4000000000\"> has fewer numbers");
  refuse(ACCESSED("9", "0 0 1 0 NaN 0 1 0 0", "<accessor source='#a' count='3' stride='3'>" THREE),
         "<float_array>: number 4 is \"NaN\"; give a decimal number");
  refuse(ACCESSED("9", "0,5 0 1 0 1 0 1 0 0", "<accessor source='#a' count='3' stride='3'>" THREE),
         "number 0 is \"0,5\"");
  refuse(ACCESSED("9", "0 0 1 0 1 0 1 0 0",
                  "<accessor source='#a' count='3' stride='3'>" PARAM("X") PARAM("Y")),
         "<accessor> of positions with 2 parameters");
  refuse(ACCESSED("9", "0 0 1 0 1 0 1 0 0", "<accessor source='#b' count='3' stride='3'>" THREE),
         "no <float_array> has this id");
}

/* A placement that mirrors turns triangles round, so their outer sides stay outside; two that do
 * leave them. */
CASE(mirrors) {
  read_text(PLACED(NODE("<scale>-1 1 1</scale>")));
  TRIANGLE(0, 0, 0, 0, 0, 2, 0, -1, 0, 0);
  sepax_soup_free(&soup);
  read_text(PLACED(NODE("<scale>-1 1 -1</scale>")));
  TRIANGLE(0, 0, 0, 0, -1, 0, 0, 0, 2, 0);
  sepax_soup_free(&soup);
  read_text(PLACED("<node><scale>1 1 -1</scale>" NODE(
      "<matrix>0 1 0 0 1 0 0 0 0 0 1 5 0 0 0 1</matrix>") "</node>"));
  TRIANGLE(0, 0, 0, -5, 0, 1, -5, 2, 0, -5);
  sepax_soup_free(&soup);
  read_text(PLACED(
      "<node><rotate>0 0 1 90</rotate>" NODE("<scale>1e-90 1e-90 -1e-90</scale>") "</node>"));
  TRIANGLE(0, 0, 0, 0, -2e-90, 0, 0, 0, 1e-90, 0);
  sepax_soup_free(&soup);
}

CASE(transformations) {
  read_text(PLACED(NODE("<translate>3 0 0</translate><rotate>0 0 2 90</rotate>")));
  TRIANGLE(0, 3, 0, 0, 3, 1, 0, 1, 0, 0);
  sepax_soup_free(&soup);
  read_text(PLACED(NODE("<matrix>0 -1 0 5 1 0 0 6 0 0 1 7 0 0 0 1</matrix>"
                        "<scale>2 3 4</scale>")));
  TRIANGLE(0, 5, 6, 7, 5, 8, 7, -1, 6, 7);
  sepax_soup_free(&soup);
  read_text(PLACED("<node><translate>0 0 1</translate>" NODE("<translate>10 0 0</translate>")
                       NODE("") "</node>"));
  assert_read(1, 2);
  TRIANGLE(0, 10, 0, 1, 11, 0, 1, 10, 2, 1);
  TRIANGLE(1, 0, 0, 1, 1, 0, 1, 0, 2, 1);
  sepax_soup_free(&soup);
  read_text(PLACED(NODE("<translate>3 0 0</translate><rotate>0 0 0 0</rotate>")));
  TRIANGLE(0, 3, 0, 0, 4, 0, 0, 3, 2, 0);
  sepax_soup_free(&soup);
  read_text(PLACED(NODE("<rotate>1 0 0 30</rotate>")));
  assert_true(fabs(soup.facet[0].v[2][1] - 2 * cos(PI / 6)) < 1e-15);
  assert_true(fabs(soup.facet[0].v[2][2] - 1) < 1e-15);
  sepax_soup_free(&soup);
  refuse(PLACED(NODE("<lookat>0 0 0 1 0 0 0 0 1</lookat>")), "<lookat> is not read");
  refuse(PLACED(NODE("<skew>45 1 0 0 0 1 0</skew>")), "<skew> is not read");
  refuse(PLACED(NODE("<scale>1 0 1</scale>")), "<scale> makes every mesh that it places flat");
  refuse(PLACED(NODE("<translate>1 2</translate>")), "<translate> has 2 numbers, not 3");
  refuse(PLACED(NODE("<rotate>0 0 0 90</rotate>")), "give an axis that is not zero");
  refuse(PLACED(NODE("<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1</matrix>")),
         "its last row is not 0 0 0 1");
}

#define SKIN(matrix)                                                                     \
  "<library_controllers><controller id='c'><skin source='#g'><bind_shape_matrix>" matrix \
  "</bind_shape_matrix><joints/><vertex_weights count='0'/></skin></controller>"         \
  "<controller id='m'><morph source='#g'/></controller></library_controllers>\n"

#define MOVED_SKIN SKIN("1 0 0 0 0 1 0 0 0 0 1 5 0 0 0 1")
#define SKINNED_NODE                                         \
  "<library_nodes><node id='k'><translate>0 7 0</translate>" \
  "<instance_controller url='#c'/></node></library_nodes>\n"
#define ITS_INSTANCE "<node><translate>1 0 0</translate><instance_node url='#k'/></node>"

CASE(instances) {
  read_text(ROOT GEOMETRIES(GEOMETRY("g", ONE)) MOVED_SKIN SKINNED_NODE SCENE(ITS_INSTANCE) END);
  TRIANGLE(0, 1, 7, 5, 2, 7, 5, 1, 9, 5);
  assert_int_equal(others("skins, read as they were bound"), 1);
  sepax_soup_free(&soup);
  refuse(ROOT GEOMETRIES(GEOMETRY("g", ONE))
             MOVED_SKIN SCENE("<node><instance_controller url='#m'/></node>") END,
         "<controller> that is no skin");
  refuse(PLACED("<node><instance_geometry url='b.dae#g'/></node>"),
         "refers to another file, which is not read; put it into this one");
  refuse(PLACED("<node><instance_geometry url='#h'/></node>"), "no <geometry> has this id");
  refuse(PLACED("<node><instance_node url='#h'/></node>"), "no <node> has this id");
  refuse(PLACED("<node id='k'><instance_node url='#k'/></node>"), "<node> that contains itself");
  refuse(ROOT GEOMETRIES(GEOMETRY("g", ONE)) END, "it has no <scene>");
  refuse(PLACED("<node/>"), "the scene places no mesh");
  refuse(MESH("<triangles count='0'>" VERTEX "</triangles>"),
         "the meshes that the scene places have no faces");
  refuse(PLACED("<node><instance_geometry url='#g'/><translate>1 0 0</translate></node>"),
         "<translate> after an element that the node places; transformations must come first");
  refuse(PLACED(NODE("<scale>1e-200 1e-200 1e-200</scale><scale>1e-200 1e-200 1e-200</scale>"
                     "<scale>1e200 1e200 1e200</scale><scale>1e200 1e200 1e200</scale>")),
         "makes a mesh flat, or too small or too large for a double");
  refuse(PLACED("triangles" NODE("")), "has text between its elements");
  refuse(ROOT "<asset><unit name='millimeter'/></asset>" GEOMETRIES(GEOMETRY("g", ONE))
             SCENE(NODE("")) END,
         "<unit name=\"millimeter\"> without meter");
}

CASE(a_geometry_that_nothing_places) {
  read_text(ROOT GEOMETRIES("<geometry id='h'><mesh><source id='q'><float_array id='b' count='9'>"
                            "0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor "
                            "source='#b' count='3' stride='3'/></technique_common></source>"
                            "<vertices id='w'><input semantic='POSITION' source='#q'/></vertices>"
                            "<triangles count='2'><input semantic='VERTEX' source='#w' offset='0'/>"
                            "<p>0 1 2 2 1 0</p></triangles></mesh></geometry>" GEOMETRY("g", ONE))
                SCENE(NODE("")) END);
  assert_read(3, 1);
  assert_int_equal(account.unplaced, 2);
  sepax_soup_free(&soup);
}

CASE(units_and_axes) {
  read_text(ROOT
            "<asset><unit name='inch' meter='0.0254'/><up_axis>Y_UP</up_axis></asset>" GEOMETRIES(
                GEOMETRY("g", ONE)) SCENE(NODE("")) END);
  assert_string_equal(account.unit, "inch");
  assert_true(account.unit_mm == 25.4);
  assert_int_equal(others("up_axis Y_UP, which is not applied"), 1);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  sepax_soup_free(&soup);
  read_text(ROOT GEOMETRIES(GEOMETRY("g", ONE)) SCENE(NODE("")) END);
  assert_string_equal(account.unit, "meter");
  assert_true(account.unit_mm == 1000);
  sepax_soup_free(&soup);
  refuse(ROOT ASSET GEOMETRIES("<asset><unit meter='0.001'/></asset>" GEOMETRY("g", ONE))
             SCENE(NODE("")) END,
         "a unit of 0.001 m in a document of 1 m");
  refuse(ROOT "<asset><unit meter='-1'/></asset>" GEOMETRIES(GEOMETRY("g", ONE)) SCENE(NODE(""))
             END,
         "give a length above 0");
  static const char *const axes[] = {"FOO", "", "Z_UPX", "Z_UP Z_UP", "z_up"};
  for (size_t n = 0; n < LENGTH(axes); n++) {
    char text[4000];
    snprintf(text, sizeof text, "%s%s%s", ROOT "<asset><up_axis>", axes[n],
             "</up_axis></asset>" GEOMETRIES(GEOMETRY("g", ONE)) SCENE(NODE("")) END);
    refuse(text, "give X_UP, Y_UP or Z_UP");
  }
}

CASE(versions) {
  read_text("\xef\xbb\xbf<?xml version='1.0' encoding='utf-8'?>\n<!-- a --><c:COLLADA "
            "xmlns:c='http://www.collada.org/2008/03/COLLADASchema' version='1.5.0'>"
            "<c:library_geometries><c:geometry id='g'><c:mesh><c:source id='p'><c:float_array "
            "id='a' count='9'>0 0 0 1 <!-- b -->0 0 <![CDATA[0 1]]> 0</c:float_array>"
            "<c:technique_common><c:accessor source='#a' count='3' stride='3'/>"
            "</c:technique_common></c:source><c:vertices id='v'><c:input semantic='POSITION' "
            "source='#p'/></c:vertices><c:triangles count='1'><c:input semantic='VERTEX' "
            "source='#v' offset='0'/><c:p>0 1 2</c:p></c:triangles></c:mesh></c:geometry>"
            "</c:library_geometries><c:library_visual_scenes><c:visual_scene id='s'><c:node>"
            "<c:instance_geometry url='#g'/></c:node></c:visual_scene></c:library_visual_scenes>"
            "<c:scene><c:instance_visual_scene url='#s'/></c:scene></c:COLLADA>");
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 1, 0);
  sepax_soup_free(&soup);
  refuse("<COLLADA xmlns='" SPACE14 "' version='1.3.0'/>", "COLLADA version \"1.3.0\"");
  refuse("<COLLADA version='1.4.1'/>", "of namespace \"\" is not read");
  refuse("<!DOCTYPE COLLADA><COLLADA version='1.4.1'/>", "it has a document type");
  refuse("\xff\xfe<\0?\0", "a.dae");
}

CASE(what_has_no_surface) {
  read_text(ROOT "<library_effects><effect id='e'/><effect id='f'/></library_effects>"
                 "<library_joints><joint id='j'/></library_joints>" GEOMETRIES(
                     GEOMETRY("g", ONE "<lines count='3'>" VERTEX "<p>0 1 1 2 2 3</p></lines>"
                                       "<linestrips count='1'>" VERTEX "<p>0 1</p></linestrips>"
                                       "<extra/>"))
                     SCENE("<node><instance_camera url='#x'/><instance_geometry url='#g'>"
                           "<bind_material/></instance_geometry></node>") END);
  assert_read(1, 1);
  assert_int_equal(others("effects"), 2);
  assert_int_equal(others("kinematics"), 1);
  assert_int_equal(others("lines"), 3);
  assert_int_equal(others("linestrips"), 1);
  assert_int_equal(others("placed cameras"), 1);
  assert_int_equal(others("bound materials"), 1);
  sepax_soup_free(&soup);
}

CASE(what_is_refused) {
  refuse(MESH("<polygons count='1'>" VERTEX "<ph><p>0 1 2</p><h>1 2 3</h></ph></polygons>"),
         "a.dae:6: a polygon with holes (<ph>) is not read; export triangles");
  refuse(MESH("<triangles count='1'>" VERTEX "<p>0 1 4</p></triangles>"),
         "<p>: index 4, but there are 4 vertices");
  refuse(MESH("<triangles count='1'>" VERTEX "<p>0 1 -1</p></triangles>"), "an index is \"-1\"");
  refuse(MESH("<triangles count='2'>" VERTEX "<p>0 1 2 0 1</p></triangles>"),
         "<p> has too few indices");
  refuse(MESH("<triangles count='1'>" VERTEX "<p>0 1 2 0</p></triangles>"),
         "<p> has more numbers than its count says");
  refuse(MESH("<triangles>" VERTEX "<p>0 1 2</p></triangles>"), "<triangles> without a count");
  refuse(MESH("<triangles count='1'><p>0 1 2</p></triangles>"), "without an input VERTEX");
  refuse(MESH("<triangles count='1'>" VERTEX "</triangles>"), "without <p>");
  refuse(MESH("<polylist count='2'>" VERTEX "<vcount>3</vcount><p>0 1 2</p></polylist>"),
         "<vcount> has 1 whole numbers, not 2");
  refuse(MESH("<tristrips count='2'>" VERTEX "<p>0 1 2</p></tristrips>"),
         "<tristrips count=\"2\"> has 1 of them");
  refuse(MESH("<trifans count='1'>" VERTEX "<p>0 1</p></trifans>"), "a strip or fan of 2 vertices");
  refuse(MESH("<quads count='1'/>"), "a.dae:6: <quads> in <mesh> is not of COLLADA");
  refuse(MESH("<triangles count='1' cuont='1'>" VERTEX "<p>0 1 2</p></triangles>"),
         "<triangles cuont=...> is not of COLLADA");
  refuse(MESH("<x:triangles xmlns:x='y' count='1'/>"), "<triangles> in <mesh> is not of COLLADA");
  refuse(ROOT "<library_shapes/>" END, "<library_shapes> in <COLLADA> is not of COLLADA");
  refuse(ROOT GEOMETRIES("<geometry id='g'><convex_mesh convex_hull_of='#h'/></geometry>")
             SCENE(NODE("")) END,
         "a convex hull of another mesh is not read");
  refuse(ROOT GEOMETRIES("<geometry id='g'><spline/></geometry>") SCENE(NODE("")) END,
         "<spline> is not read");
  refuse(ROOT GEOMETRIES(GEOMETRY("g", ONE)) SCENE(NODE("")), "mend the XML");
  /* In what is passed over, faces are still counted. */
  refuse(MESH(ONE "<extra><technique><triangles count='5'/></technique></extra>"),
         "1 faces were read, but a second count finds 6");
}

/* Each node places the next twice: 2^60 triangles, which are refused at once; and 2^60 times
 * nothing, which takes no time. */
CASE(nodes_that_double) {
  enum { LEVELS = 60 };
  for (int with = 0; with < 2; with++) {
    static char text[20000];
    int used =
        snprintf(text, sizeof text, "%s", ROOT GEOMETRIES(GEOMETRY("g", ONE)) "<library_nodes>\n");
    for (int n = 0; n < LEVELS; n++) {
      used += snprintf(text + used, sizeof text - (size_t)used,
                       "<node id='n%d'><instance_node url='#n%d'/><instance_node url='#n%d'/>"
                       "</node>\n",
                       n, n + 1, n + 1);
    }
    snprintf(text + used, sizeof text - (size_t)used, "<node id='n%d'>%s</node></library_nodes>%s",
             LEVELS, with ? "<instance_geometry url='#g'/>" : "",
             SCENE(NODE("") "<node><instance_node url='#n0'/></node>") END);
    if (with) {
      refuse(text, "times; simplify it");
      assert_int_equal(fault.code, SEPAX_ERROR_LIMIT);
    } else {
      read_text(text);
      assert_read(1, 1);
      sepax_soup_free(&soup);
    }
  }
}

CASE(an_id_of_two_meshes) {
  read_text(ROOT GEOMETRIES(GEOMETRY("g", ONE) GEOMETRY("h", ONE))
                SCENE(NODE("") "<node><instance_geometry url='#h'/></node>") END);
  assert_read(2, 2);
  sepax_soup_free(&soup);
  refuse(ROOT GEOMETRIES(GEOMETRY("g", ONE) GEOMETRY("g", ONE)) SCENE(NODE("")) END,
         "two <geometry id=\"g\">; give each its own id");
}

/* A tag that would take libxml2 long. */
CASE(a_long_tag) {
  static char text[20000];
  int used = snprintf(text, sizeof text, "<COLLADA");
  for (int n = 0; n < 1001; n++) {
    used += snprintf(text + used, sizeof text - (size_t)used, " a%d='>'", n);
  }
  snprintf(text + used, sizeof text - (size_t)used, "/>");
  refuse(text, "a tag or comment of more than 1000 attributes or 1 MiB; simplify it");
}

CASE(each_allocation_refused) { refuse_each_allocation(put_file("a.dae", MESH(ONE))); }
