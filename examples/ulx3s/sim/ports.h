/* SPDX-License-Identifier: MIT */
/* ports.h - what board.cpp calls the pins of ulx3s_top. */
#ifndef PORTS_H
#define PORTS_H

#include "Vulx3s_top.h"

using Top = Vulx3s_top;

inline CData &clock_of(Top &top) { return top.clk_25mhz; }
inline CData &to_board(Top &top) { return top.ftdi_txd; }
inline bool from_board(const Top &top) { return top.ftdi_rxd != 0; }
inline void release_buttons(Top &top) { top.btn = 1; }

#endif
