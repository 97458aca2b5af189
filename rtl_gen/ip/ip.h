/* SPDX-License-Identifier: MIT */
/* ip.h - the top of a design for other tools and languages. The emitter has a design and all its
 * modules; an error is the emitter's. */
#ifndef SEPAX_IP_H
#define SEPAX_IP_H

#include "emit/ports.h"
#include "engine/registers.h"

/* A VHDL package sepax_pkg with the component of the top; ports are std_logic and
 * std_logic_vector. */
void ip_vhdl(const emitter *e, const emit_ports *ports, emit_text *out);

/* A SystemVerilog interface for each group of ports, and a module TOP_if that has them and the top.
 */
void ip_systemverilog(const emitter *e, const emit_ports *ports, emit_text *out);

/* A component of IP-XACT (IEEE 1685-2014): ports, buses, registers (NULL: none), files. `single`:
 * the file of the top has all modules. */
void ip_xact(const emitter *e, const emit_ports *ports, const engine_registers *map, bool single,
             emit_text *out);

/* The registers in CMSIS-SVD 1.3. */
void ip_svd(const emitter *e, const emit_ports *ports, const engine_registers *map, emit_text *out);

#endif
