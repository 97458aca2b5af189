/* SPDX-License-Identifier: MIT */
/* urdf.h - the parts of the reader of URDF (private). */
#ifndef SEPAX_URDF_H
#define SEPAX_URDF_H

#include "robot/robot.h"
#include "robot/packages.h"
#include "xml/xml.h"

typedef struct {
  xml_file file;
  sepax_robot *robot;
  const mesh_places *places;
  int minor;            /* the minor version: 1.MINOR */
  const xmlNode **node; /* node[j]: the element of joint j */
  size_t shape_capacity, nothing_capacity, joint_capacity, node_capacity, link_capacity;
} urdf_reader;

static const sepax_pose urdf_at_origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* Read the pose of <origin>; without <origin> it is the identity. */
bool sepax__urdf_read_origin(const urdf_reader *r, const xmlNode *of, sepax_pose *pose,
                             sepax_error *error);

/* Read the shape of a <collision> of this link. */
bool sepax__urdf_read_collision(urdf_reader *r, const xmlNode *node, size_t link,
                                sepax_error *error);

/* The number of the link of this name, or the number of links if there is none. */
size_t sepax__urdf_find_link(const sepax_mechanism *m, const char *name);

/* Add a link without geometry. It takes over the name, also on failure. */
bool sepax__urdf_add_link(urdf_reader *r, const xmlNode *node, char *name, sepax_error *error);

/* Read a <joint> without its <mimic>. Its links exist already. */
bool sepax__urdf_read_joint(urdf_reader *r, const xmlNode *node, sepax_error *error);

/* Read the <mimic> of a joint. All joints exist already. */
bool sepax__urdf_read_mimic(const urdf_reader *r, const xmlNode *node, sepax_joint *joint,
                            sepax_error *error);

#endif
