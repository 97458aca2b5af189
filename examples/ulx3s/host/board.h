/* SPDX-License-Identifier: MIT */
/* board.h - the four accesses of drivers/object_engine/sepax_driver.h over the serial line of a
 * ULX3S.
 *
 * Requests and replies are those of ../README.md. A request that the board refuses, a reply that is
 * damaged, and 2 s without a reply make an access fail; board_error says what it was, and the
 * session is over. */
#ifndef ULX3S_BOARD_H
#define ULX3S_BOARD_H

#include "sepax_driver.h"

enum { BOARD_AHEAD = 64, BOARD_REQUEST = 16, BOARD_REPLY = 12 };

typedef struct {
  int line;        /* file descriptor */
  uint8_t number;  /* of the next request */
  size_t asked;    /* requests without a reply so far, at most BOARD_AHEAD */
  bool vertices;   /* these are vertices */
  size_t gathered; /* bytes of `out` that are not sent yet */
  uint8_t out[BOARD_AHEAD * BOARD_REQUEST];
  uint64_t result[BOARD_AHEAD]; /* fetched, not received by the driver yet */
  bool last[BOARD_AHEAD];
  size_t results, taken;
  uint32_t clock_hz;   /* of the engine, as the board says */
  uint64_t sent, came; /* bytes */
  char error[160];
} board;

/* Open the line at `port` (the path of a terminal), at a rate of the list in board.c, and begin a
 * session: the engine is reset. False, with an error, if that fails. */
bool board_open(board *b, const char *port, unsigned long baud);
void board_close(board *b);

/* What the driver needs; the context is b. */
sepax_bus board_bus(board *b);

/* What failed last; "" if nothing did. */
const char *board_error(const board *b);

#endif
