/* SPDX-License-Identifier: MIT */
/* tools.h - parts of tools: bodies that a certificate describes, on a link of the robot. */
#ifndef CERTIFICATE_TOOLS_H
#define CERTIFICATE_TOOLS_H

#include "lines.h"

/* Add a link for each part of a tool, fixed to the link of the tools, whose own geometry goes. What
 * that link is compared with, the parts are compared with, too, except for pairs that the
 * certificate leaves out. Prints what is taken from the certificate. */
void tools_add(robot *r, const certificate *c);

#endif
