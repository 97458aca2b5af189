// SPDX-License-Identifier: MIT
// board.cpp - the verilated top of a board behind a pseudo-terminal, in place of its USB bridge:
// bytes that a program writes to the terminal go bit by bit to the serial line, and back. The
// board's ports.h names its pins.
//   board [--damage=N] [--lose=N]   the highest bit of byte N that comes, from 0, is turned over;
//                                   N bytes are lost, from byte 4000 on
// The first line that it prints is the path of the terminal. It runs until it is ended by a signal
// or a program closes the terminal.
#include <ports.h> // of the board
#include "verilated.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace {

const int clocks = BOARD_CLOCKS; // cycles a bit, as the top has them

// Sends bytes to the line, one after the other.
struct Sender {
  std::deque<uint8_t> bytes;
  unsigned shift = 1;
  int bits = 0, wait = 0;

  bool busy() const { return bits > 0 || !bytes.empty(); }
  bool tick() {
    if (wait > 0) {
      wait--;
    } else if (bits > 0) {
      shift >>= 1;
      bits--;
      wait = clocks - 1;
    }
    if (bits == 0 && !bytes.empty()) {
      shift = bytes.front() << 1 | 0x600u; // two stop bits
      bytes.pop_front();
      bits = 11;
      wait = clocks - 1;
    }
    return bits == 0 || (shift & 1) != 0;
  }
};

// Hears bytes from the line.
struct Listener {
  unsigned shift = 0;
  int bits = 0, wait = 0;

  // A byte, or -1; -2: its stop bit was 0.
  int tick(bool line) {
    if (bits == 0) {
      if (!line) {
        bits = 10;
        wait = clocks / 2;
      }
      return -1;
    }
    if (--wait > 0) {
      return -1;
    }
    shift = shift >> 1 | (line ? 0x200u : 0u);
    wait = clocks;
    if (--bits > 0) {
      return -1;
    }
    return line ? (int)(shift >> 1 & 0xff) : -2;
  }
};

// A pseudo-terminal that passes bytes as they are.
int open_terminal() {
  int line = posix_openpt(O_RDWR | O_NOCTTY);
  struct termios mode;
  if (line < 0 || grantpt(line) != 0 || unlockpt(line) != 0 || tcgetattr(line, &mode) != 0) {
    return -1;
  }
  cfmakeraw(&mode);
  return tcsetattr(line, TCSANOW, &mode) == 0 ? line : -1;
}

struct Faults {
  long damage = -1, lose = 0, count = 0;
};

// Bytes that came from the program; false: it has closed the terminal.
bool hear(int terminal, int ms, Sender *sender, Faults *faults) {
  static bool met = false;
  struct pollfd event = {terminal, POLLIN, 0};
  uint8_t byte[4096];
  if (poll(&event, 1, ms) <= 0) {
    return true;
  }
  ssize_t n = (event.revents & POLLIN) != 0 ? read(terminal, byte, sizeof byte) : -1;
  for (ssize_t i = 0; i < n; i++, faults->count++) {
    if (faults->count < 4000 || faults->count >= 4000 + faults->lose) {
      sender->bytes.push_back(byte[i] ^ (faults->count == faults->damage ? 0x80 : 0));
    }
  }
  met = met || n > 0;
  if (n <= 0 && !met) {
    poll(nullptr, 0, 10); // nobody has opened it yet
  }
  return n > 0 || !met;
}

int serve(int terminal, Faults *faults) {
  VerilatedContext context;
  context.randReset(2);
  std::unique_ptr<Top> top(new Top(&context));
  Sender sender;
  Listener listener;
  const int idle_cycles = 100000; // then it waits for bytes in between
  long idle = 0;
  release_buttons(*top);
  clock_of(*top) = 0;
  to_board(*top) = 1;
  for (long cycle = 0; !context.gotFinish(); cycle++) {
    if (cycle % 64 == 0 && !hear(terminal, idle > idle_cycles ? 1 : 0, &sender, faults)) {
      break;
    }
    idle = sender.busy() || listener.bits > 0 ? 0 : idle + 1;
    to_board(*top) = sender.tick();
    clock_of(*top) = 1;
    top->eval();
    clock_of(*top) = 0;
    top->eval();
    int heard = cycle < 100 ? -1 : listener.tick(from_board(*top));
    if (heard == -2) {
      std::fprintf(stderr, "board: a byte without a stop bit\n");
      return 1;
    }
    uint8_t byte = (uint8_t)heard;
    if (heard >= 0 && write(terminal, &byte, 1) != 1) {
      std::fprintf(stderr, "board: the terminal: %s\n", std::strerror(errno));
      return 1;
    }
  }
  top->final();
  return context.gotFinish();
}

} // namespace

int main(int argc, char **argv) {
  Faults faults;
  for (int i = 1; i < argc; i++) {
    char *end = nullptr;
    if (std::strncmp(argv[i], "--damage=", 9) == 0) {
      faults.damage = std::strtol(argv[i] + 9, &end, 10);
    } else if (std::strncmp(argv[i], "--lose=", 7) == 0) {
      faults.lose = std::strtol(argv[i] + 7, &end, 10);
    }
    if (end == nullptr || *end != '\0') {
      std::fprintf(stderr, "usage: board [--damage=N] [--lose=N]\n");
      return 2;
    }
  }
  int terminal = open_terminal();
  const char *path = terminal < 0 ? nullptr : ptsname(terminal);
  if (path == nullptr) {
    std::fprintf(stderr, "board: no pseudo-terminal: %s\n", std::strerror(errno));
    return 2;
  }
  std::printf("%s\n", path);
  std::fflush(stdout);
  return serve(terminal, &faults);
}
