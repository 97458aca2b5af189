/* urdf.h - the parts of the reader of URDF (private). */
#ifndef FORMAT_URDF_H
#define FORMAT_URDF_H

#include "formats/formats.h"
#include "formats/packages.h"
#include "xml/xml.h"

typedef struct {
  xml_file file;
  format_robot *robot;
  const format_places *places;
  int minor;            /* of version 1.MINOR */
  const xmlNode **node; /* of each joint of the mechanism */
  size_t shape_capacity, nothing_capacity, joint_capacity, node_capacity, link_capacity;
} urdf_reader;

static const sepax_pose urdf_at_origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* The pose in <origin>; without one, the origin. */
bool urdf_read_origin(const urdf_reader *r, const xmlNode *of, sepax_pose *pose,
                      sepax_error *error);

/* The shape of a <collision> of this link. */
bool urdf_read_collision(urdf_reader *r, const xmlNode *node, size_t link, sepax_error *error);

/* The link of this name, or the number of links. */
size_t urdf_find_link(const sepax_mechanism *m, const char *name);

/* A link without geometry. Takes the name, also on failure. */
bool urdf_add_link(urdf_reader *r, const xmlNode *node, char *name, sepax_error *error);

/* A <joint>, whose links are there, without its <mimic>. */
bool urdf_read_joint(urdf_reader *r, const xmlNode *node, sepax_error *error);

/* The <mimic> of a joint, when all joints are there. */
bool urdf_read_mimic(const urdf_reader *r, const xmlNode *node, sepax_joint *joint,
                     sepax_error *error);

#endif
