/* SPDX-License-Identifier: MIT */
/* board.c - see board.h. Rates above 38400 baud are no part of POSIX. */
#define _DEFAULT_SOURCE // NOLINT(bugprone-reserved-identifier)
#include "board.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

enum { HELLO = 1, READ = 2, WRITE = 3, VERTEX = 4, VERTEX_LAST = 1, VERTEX_TO_B = 2, RECEIVE = 8 };
enum { DONE, LAST, NOT_NOW, ERROR, DAMAGED, ORDER, UNKNOWN };

static const uint32_t protocol = 0x756c7831; /* "ulx1" */
static const int quiet_ms = 100;             /* the board forgets what was cut short */
static const int reply_ms = 2000;
static const int run_s = 60; /* without any result */

static bool fail(board *b, const char *what) {
  snprintf(b->error, sizeof b->error, "%s", what);
  return false;
}

static bool fail_by_system(board *b, const char *what) {
  snprintf(b->error, sizeof b->error, "%s: %s", what, strerror(errno));
  return false;
}

static uint16_t crc16(const uint8_t *byte, size_t count) {
  uint16_t crc = 0xffff;
  for (size_t i = 0; i < count; i++) {
    crc = (uint16_t)(crc ^ byte[i] << 8);
    for (int k = 0; k < 8; k++) {
      crc = (uint16_t)(crc << 1 ^ ((crc & 0x8000) != 0 ? 0x1021 : 0));
    }
  }
  return crc;
}

static void put32(uint8_t *at, uint32_t value) {
  for (int i = 0; i < 4; i++) {
    at[i] = (uint8_t)(value >> 8 * i);
  }
}

static uint32_t get32(const uint8_t *at) {
  return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* Send what was gathered. */
static bool flush(board *b) {
  for (size_t i = 0; i < b->gathered;) {
    ssize_t n = write(b->line, b->out + i, b->gathered - i);
    if (n < 0 && errno != EINTR) {
      return fail_by_system(b, "cannot write to the line");
    }
    i += n > 0 ? (size_t)n : 0;
  }
  b->sent += b->gathered;
  b->gathered = 0;
  return true;
}

static bool ask(board *b, unsigned operation, const uint32_t word[3]) {
  uint8_t *r = b->out + b->gathered;
  r[0] = (uint8_t)operation;
  r[1] = b->number++;
  for (int i = 0; i < 3; i++) {
    put32(r + 2 + 4 * i, word[i]);
  }
  uint16_t crc = crc16(r, BOARD_REQUEST - 2);
  r[BOARD_REQUEST - 2] = (uint8_t)(crc >> 8);
  r[BOARD_REQUEST - 1] = (uint8_t)crc;
  b->gathered += BOARD_REQUEST;
  b->asked++;
  return b->gathered < sizeof b->out || flush(b);
}

/* Read bytes until there are `size`, or none came for a while: how many. */
static size_t listen_to(board *b, uint8_t *byte, size_t size, int ms) {
  size_t got = 0;
  while (got < size) {
    struct pollfd event = {.fd = b->line, .events = POLLIN};
    int ready = poll(&event, 1, ms);
    if (ready < 0 && errno == EINTR) {
      continue;
    }
    ssize_t n = ready > 0 ? read(b->line, byte + got, size - got) : 0;
    if (n <= 0) {
      break;
    }
    got += (size_t)n;
  }
  b->came += got;
  return got;
}

/* The reply to the oldest request: its code, and its words. */
static bool reply(board *b, int *code, uint32_t word[2]) {
  static const char *const refusal[] = {
      "the engine refuses an access", "the board got a damaged packet", "the board missed a packet",
      "the board does not know a request: another bitstream?"};
  uint8_t r[BOARD_REPLY];
  if (!flush(b)) {
    return false;
  }
  size_t got = listen_to(b, r, sizeof r, reply_ms);
  if (got < sizeof r) {
    return fail(b, got == 0 ? "no reply from the board" : "a reply of the board is cut short");
  }
  uint8_t number = (uint8_t)(b->number - b->asked);
  if (crc16(r, sizeof r - 2) != (r[10] << 8 | r[11])) {
    return fail(b, "a reply of the board is damaged");
  }
  if (r[0] >= ERROR) {
    return fail(b, r[0] <= UNKNOWN ? refusal[r[0] - ERROR] : "a reply of an unknown kind");
  }
  if (r[1] != number) {
    return fail(b, "a reply of the board was lost");
  }
  b->asked--;
  *code = r[0];
  word[0] = get32(r + 2);
  word[1] = get32(r + 6);
  return true;
}

/* Wait until no more than `left` vertices are without a reply. */
static bool settle(board *b, size_t left) {
  while (b->asked > left) {
    int code = 0;
    uint32_t word[2];
    if (!reply(b, &code, word)) {
      return false;
    }
    if (code != DONE) {
      return fail(b, "the engine takes no vertex during a run");
    }
  }
  return true;
}

/* One request and its reply. */
static bool exchange(board *b, unsigned operation, uint32_t first, uint32_t second,
                     uint32_t answer[2]) {
  const uint32_t word[3] = {first, second, 0};
  int code = 0;
  return settle(b, 0) && ask(b, operation, word) && reply(b, &code, answer);
}

static bool board_read(void *context, uint32_t address, uint32_t *value) {
  uint32_t answer[2] = {0, 0};
  bool ok = exchange(context, READ, address, 0, answer);
  *value = answer[0];
  return ok;
}

static bool board_write(void *context, uint32_t address, uint32_t value) {
  uint32_t answer[2];
  return exchange(context, WRITE, address, value, answer);
}

/* Half of the requests that are ahead are sent at once. */
static bool board_send(void *context, const int32_t vertex[3], bool last, bool to_b) {
  board *b = context;
  const uint32_t word[3] = {(uint32_t)vertex[0], (uint32_t)vertex[1], (uint32_t)vertex[2]};
  unsigned operation = VERTEX | (last ? VERTEX_LAST : 0) | (to_b ? VERTEX_TO_B : 0);
  return (b->asked < BOARD_AHEAD || settle(b, BOARD_AHEAD / 2)) && ask(b, operation, word) &&
         (!last || settle(b, 0));
}

/* Ask for some results at once; those that are not there are not there. */
static bool fetch(board *b) {
  static const uint32_t none[3] = {0, 0, 0};
  b->results = 0;
  b->taken = 0;
  for (int i = 0; i < BOARD_AHEAD / 2; i++) {
    if (!ask(b, RECEIVE, none)) {
      return false;
    }
  }
  while (b->asked > 0) {
    int code = 0;
    uint32_t word[2] = {0, 0};
    if (!reply(b, &code, word)) {
      return false;
    }
    if (code != NOT_NOW) {
      b->result[b->results] = (uint64_t)word[1] << 32 | word[0];
      b->last[b->results++] = code == LAST;
    }
  }
  return true;
}

static bool board_receive(void *context, uint64_t *result, bool *last) {
  board *b = context;
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  for (time_t end = now.tv_sec + run_s; b->taken == b->results;) {
    if (!settle(b, 0) || !fetch(b)) {
      return false;
    }
    clock_gettime(CLOCK_MONOTONIC, &now);
    if (b->results == 0 && now.tv_sec > end) {
      return fail(b, "the run does not end");
    }
  }
  *result = b->result[b->taken];
  *last = b->last[b->taken++];
  return true;
}

static bool set_line(board *b, const char *port, unsigned long baud) {
  static const struct {
    unsigned long baud;
    speed_t speed;
  } rates[] = {{115200, B115200},   {230400, B230400},   {460800, B460800},  {921600, B921600},
               {1000000, B1000000}, {2000000, B2000000}, {3000000, B3000000}};
  size_t i = 0;
  while (i < sizeof rates / sizeof rates[0] && rates[i].baud != baud) {
    i++;
  }
  if (i == sizeof rates / sizeof rates[0]) {
    return fail(b, "no such rate; 115200, 230400, 460800, 921600, 1000000, 2000000 or 3000000");
  }
  struct termios mode;
  b->line = open(port, O_RDWR | O_NOCTTY);
  if (b->line < 0) {
    return fail_by_system(b, port);
  }
  if (tcgetattr(b->line, &mode) != 0) {
    return fail_by_system(b, port);
  }
  cfmakeraw(&mode);
  mode.c_cflag |= CLOCAL | CREAD;
  mode.c_cflag &= ~(tcflag_t)(CRTSCTS | CSTOPB | PARENB);
  mode.c_cc[VMIN] = 1;
  mode.c_cc[VTIME] = 0;
  return (cfsetispeed(&mode, rates[i].speed) == 0 && cfsetospeed(&mode, rates[i].speed) == 0 &&
          tcsetattr(b->line, TCSANOW, &mode) == 0) ||
         fail_by_system(b, port);
}

bool board_open(board *b, const char *port, unsigned long baud) {
  *b = (board){.line = -1};
  if (!set_line(b, port, baud)) {
    return false;
  }
  uint8_t old[256];
  while (listen_to(b, old, sizeof old, quiet_ms) > 0) {}
  b->came = 0;
  uint32_t answer[2] = {0, 0};
  if (!exchange(b, HELLO, 0, 0, answer)) {
    return false;
  }
  b->clock_hz = answer[1];
  return answer[0] == protocol || fail(b, "what answers is no engine of this example");
}

void board_close(board *b) {
  if (b->line >= 0) {
    close(b->line);
    b->line = -1;
  }
}

sepax_bus board_bus(board *b) {
  return (sepax_bus){b, board_read, board_write, board_send, board_receive};
}

const char *board_error(const board *b) { return b->error; }
