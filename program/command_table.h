/* command_table.h - the list of commands of sepax. CONTRIBUTING.md says how one is added. */
#ifndef SEPAX_COMMAND_TABLE_H
#define SEPAX_COMMAND_TABLE_H

/* A row for each command, in the order of `sepax --help`: its name and what it does. `gen` is
 * int cli_gen(int argc, char **argv), where argv[0] is "sepax gen"; it returns the exit status. */
#define COMMANDS(ROW)                                                       \
  ROW(gen, "generate the Verilog of a design")                              \
  ROW(size, "what a scene needs, and the design for it")                    \
  ROW(check, "do two bodies collide, and which of their triangles?")        \
  ROW(path, "which bodies of a mechanism collide on a path?")               \
  ROW(judge, "verdicts for pairs given as text")                            \
  ROW(accuracy, "how often a design is wrong, on which pairs, by how much") \
  ROW(vectors, "test vectors of hard cases as text")                        \
  ROW(mesh, "write a sample object as STL")                                 \
  ROW(tree, "a body as a tree for the tree engine")                         \
  ROW(name, "the name of a design, and the list of options")                \
  ROW(multiplier, "generate the Verilog of one multiplier")

#define COMMAND_DECLARED(name, about) int cli_##name(int argc, char **argv);
COMMANDS(COMMAND_DECLARED)
#undef COMMAND_DECLARED

#endif
