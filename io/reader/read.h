/* read.h - the mesh of bytes (private). */
#ifndef SEPAX_READ_H
#define SEPAX_READ_H

#include "sepax_io.h"

/* As sepax_mesh_read, of the bytes of a file, a '\0' behind them. `name` stands for its path in
 * messages, and its ending for the format where the content says none. */
bool sepax__mesh_parse(sepax_soup *soup, sepax_mesh_account *account, const char *bytes,
                       size_t size, const char *name, const sepax_mesh_reading *how,
                       sepax_error *error);

#endif
