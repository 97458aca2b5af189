/* SPDX-License-Identifier: MIT */
/* command_table.h - the list of commands of sepax. CONTRIBUTING.md says how one is added. */
#ifndef SEPAX_COMMAND_TABLE_H
#define SEPAX_COMMAND_TABLE_H

/* A row for each command, in the order of `sepax --help`: its name and what it does. `gen` is
 * int cli_gen(int argc, char **argv), where argv[0] is "sepax gen"; it returns the exit status. */
#define COMMANDS(ROW)                                                            \
  ROW(gen, "generate the Verilog of a design")                                   \
  ROW(explore, "write a page with all designs of a word length, to choose one")  \
  ROW(size, "find the smallest design that is fast enough for a scene")          \
  ROW(check, "tell whether two bodies collide, and which triangles do")          \
  ROW(path, "tell which bodies of a machine collide on a path")                  \
  ROW(judge, "print the verdict of a design on pairs of triangles")              \
  ROW(accuracy, "count the wrong verdicts of a design and how far off they are") \
  ROW(vectors, "print hard pairs of triangles as test vectors")                  \
  ROW(mesh, "write a sample object as an STL file")                              \
  ROW(tree, "write a body as a tree for the tree engine")                        \
  ROW(name, "print the name of a design, or list all design options")            \
  ROW(multiplier, "generate the Verilog of one multiplier")

#define COMMAND_DECLARED(name, about) int cli_##name(int argc, char **argv);
COMMANDS(COMMAND_DECLARED)
#undef COMMAND_DECLARED

#endif
