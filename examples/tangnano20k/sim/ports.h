/* SPDX-License-Identifier: MIT */
/* ports.h - what board.cpp calls the pins of tangnano20k_top. */
#ifndef PORTS_H
#define PORTS_H

#include "Vtangnano20k_top.h"

using Top = Vtangnano20k_top;

inline CData &clock_of(Top &top) { return top.clk_27mhz; }
inline CData &to_board(Top &top) { return top.uart_rx; }
inline bool from_board(const Top &top) { return top.uart_tx != 0; }
inline void release_buttons(Top &top) { top.button = 0; }

#endif
