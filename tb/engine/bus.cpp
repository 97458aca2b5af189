// bus.cpp - see bus.h.
#include "bus.h"

#include "Vsepax_engine.h"
#include "cosim/verilated_top.h"
#include "sepax_params.h"

#include <cstdio>
#include <cstdlib>
#include <deque>
#include <memory>

#ifndef PATIENCE
#define PATIENCE 10000000 // cycles without a transfer while one is waited for
#endif

namespace {

// One direction of a channel that the engine drives: valid and data stand until ready.
struct Watch {
  const char *name;
  bool was_blocked = false;
  uint64_t data = 0;
};

struct Result {
  uint64_t data;
  bool last;
};

struct {
  int count = 0;
  char **word = nullptr;
} arguments;

class Bus {
public:
  Bus(uint64_t seed, const char *wave) : top(wave, seed), stress(seed != 0), state(seed) {
    top.arguments(arguments.count, arguments.word);
    top->s_axi_awvalid = top->s_axi_wvalid = top->s_axi_bready = 0;
    top->s_axi_arvalid = top->s_axi_rready = 0;
    top->m_axis_tready = 0;
    reset();
  }

  void reset() {
    top->aresetn = 0;
    top->s_axi_awvalid = top->s_axi_wvalid = top->s_axi_arvalid = 0;
    want_aw = want_w = want_ar = false;
    reset_objects();
    half_cycles();
    half_cycles();
    top->aresetn = 1;
    results.clear();
    for (Watch *w : {&watch_b, &watch_r, &watch_m}) {
      w->was_blocked = false;
    }
    if (top->s_axi_bvalid || top->s_axi_rvalid || top->m_axis_tvalid) {
      breach("valid after reset");
    }
  }

  // One clock cycle. Requests that are pending keep their valid; ready as it comes.
  void tick() {
    choose(top->s_axi_awvalid, want_aw);
    choose(top->s_axi_wvalid, want_w);
    choose(top->s_axi_arvalid, want_ar);
    drive_objects();
    top->s_axi_bready = gap();
    top->s_axi_rready = gap();
    top->m_axis_tready = !blocked && gap();
    top->eval();
    bool aw = top->s_axi_awvalid && top->s_axi_awready;
    bool w = top->s_axi_wvalid && top->s_axi_wready;
    bool ar = top->s_axi_arvalid && top->s_axi_arready;
    unsigned t = transfers_of_objects();
    bool b = follow(watch_b, top->s_axi_bvalid, top->s_axi_bready, top->s_axi_bresp);
    bool r = follow(watch_r, top->s_axi_rvalid, top->s_axi_rready,
                    top->s_axi_rdata | (uint64_t)top->s_axi_rresp << 32);
    bool m = follow(watch_m, top->m_axis_tvalid, top->m_axis_tready,
                    top->m_axis_tdata ^ (uint64_t)top->m_axis_tlast << 61);
    if (b) {
      responses++;
      response = top->s_axi_bresp;
    }
    if (r) {
      answers++;
      answer = top->s_axi_rdata;
      answer_response = top->s_axi_rresp;
    }
    if (m) {
      results.push_back({top->m_axis_tdata, top->m_axis_tlast != 0});
    }
    bool irq = top->irq;
    half_cycles();
    interrupt = irq;
    settle(top->s_axi_awvalid, want_aw, aw);
    settle(top->s_axi_wvalid, want_w, w);
    settle(top->s_axi_arvalid, want_ar, ar);
    settle_objects();
    beats += (uint64_t)aw + w + ar + t + b + r + m;
    waited = aw || w || ar || t > 0 || b || r || m ? 0 : waited + 1;
  }

  bool write(uint32_t address, uint32_t value, unsigned strobes) {
    uint64_t before = responses;
    top->s_axi_awaddr = (uint8_t)(address & 0x7f);
    top->s_axi_wdata = value;
    top->s_axi_wstrb = (uint8_t)strobes;
    want_aw = want_w = true;
    return until([&] { return responses != before; }) && response == 0;
  }

  bool read(uint32_t address, uint32_t *value) {
    uint64_t before = answers;
    top->s_axi_araddr = (uint8_t)(address & 0x7f);
    want_ar = true;
    bool ok = until([&] { return answers != before; }) && answer_response == 0;
    *value = answer;
    return ok;
  }

#ifdef SEPAX_TREE
  // Trees are in memory.
  void attach(const memory_options *options) {
    memory_open(&external, options);
    drive_objects();
  }
  const memory *attached() const { return &external; }
#else
  bool send(const int32_t vertex[3], bool last, bool to_b) {
    for (int i = 0; i < 3; i++) {
      top->s_axis_tdata[i] = (uint32_t)vertex[i];
    }
    top->s_axis_tdata[3] = (uint32_t)draw(); // unused
    top->s_axis_tlast = last;
    top->s_axis_tdest = to_b;
    want_t = true;
    return until([&] { return !want_t; });
  }
#endif

  bool receive(uint64_t *result, bool *last) {
    if (!until([&] { return !results.empty(); })) {
      return false;
    }
    *result = results.front().data;
    *last = results.front().last;
    results.pop_front();
    return true;
  }

  bool blocked = false, interrupt = false;
  uint64_t limit = UINT64_MAX;
  uint64_t beats = 0, cycles = 0, breaches = 0;

private:
#ifdef SEPAX_TREE
  void reset_objects() {
    memory_reset(&external);
    drive_objects();
  }
  void drive_objects() {
    const memory_slave *slave = memory_drive(&external);
    top->m_axi_arready = slave->arready;
    top->m_axi_rvalid = slave->rvalid;
    top->m_axi_rlast = slave->rlast;
    top->m_axi_rresp = (uint8_t)slave->rresp;
    for (int k = 0; k < 4; k++) {
      top->m_axi_rdata[k] = slave->rdata[k];
    }
  }
  unsigned transfers_of_objects() {
    const memory_master master = {top->m_axi_arvalid != 0, top->m_axi_rready != 0,
                                  top->m_axi_araddr, top->m_axi_arlen};
    unsigned transfers = (unsigned)(top->m_axi_arvalid && top->m_axi_arready) +
                         (unsigned)(top->m_axi_rvalid && top->m_axi_rready);
    memory_clock(&external, &master);
    return transfers;
  }
  void settle_objects() {}
  memory external{};
#else
  void reset_objects() { want_t = top->s_axis_tvalid = false; }
  void drive_objects() { choose(top->s_axis_tvalid, want_t); }
  unsigned transfers_of_objects() { return taken_t = top->s_axis_tvalid && top->s_axis_tready; }
  void settle_objects() { settle(top->s_axis_tvalid, want_t, taken_t); }
  bool want_t = false, taken_t = false;
#endif

  template <typename Condition> bool until(Condition met) {
    waited = 0;
    uint64_t begin = cycles;
    while (!met()) {
      if (waited > PATIENCE || cycles - begin > limit) {
        breach("it hangs");
        return false;
      }
      tick();
    }
    return true;
  }

  void half_cycles() {
    top.rise();
    top.settle();
    cycles++;
  }

  // Raise valid of a pending request sooner or later; it then stays.
  void choose(CData &valid, bool wanted) { valid = wanted && (valid || gap()); }
  static void settle(CData &valid, bool &wanted, bool taken) {
    if (taken) {
      valid = 0;
      wanted = false;
    }
  }

  bool follow(Watch &w, bool valid, bool ready, uint64_t data) {
    if (w.was_blocked && (!valid || data != w.data)) {
      breach(w.name);
    }
    w.was_blocked = valid && !ready;
    w.data = data;
    return valid && ready;
  }

  void breach(const char *what) {
    breaches++;
    std::fprintf(stderr, "engine: cycle %llu: %s\n", (unsigned long long)cycles, what);
  }

  // 1 at rates that change from stretch to stretch; always without stress.
  bool gap() {
    if (!stress) {
      return true;
    }
    if (draw() % 64 == 0) {
      rate = draw() % 5;
    }
    static const uint64_t eighths[] = {1, 2, 4, 7, 8};
    return draw() % 8 < eighths[rate];
  }

  uint64_t draw() { // splitmix64
    uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
  }

  VerilatedTop<Vsepax_engine> top;
  bool stress;
  uint64_t state, rate = 4, waited = 0;
  bool want_aw = false, want_w = false, want_ar = false;
  uint64_t responses = 0, answers = 0;
  uint32_t response = 0, answer = 0, answer_response = 0;
  Watch watch_b{"a response to a write moves before it is taken"};
  Watch watch_r{"read data move before they are taken"};
  Watch watch_m{"a result moves before it is taken"};
  std::deque<Result> results;
};

std::unique_ptr<Bus> bus;

} // namespace

void bus_arguments(int argc, char **argv) { arguments = {argc, argv}; }
void bus_limit(uint64_t cycles) { bus->limit = cycles; }
void bus_open(uint64_t stress, const char *wave) { bus.reset(new Bus(stress, wave)); }
void bus_close(void) { bus.reset(); }
void bus_reset(void) { bus->reset(); }
bool bus_read(void *, uint32_t address, uint32_t *value) { return bus->read(address, value); }
bool bus_write(void *, uint32_t address, uint32_t value) { return bus->write(address, value, 15); }
bool bus_write_part(uint32_t address, uint32_t value, unsigned strobes) {
  return bus->write(address, value, strobes);
}
#ifdef SEPAX_TREE
void bus_memory(const memory_options *options) { bus->attach(options); }
const memory *bus_attached(void) { return bus->attached(); }
#else
bool bus_send(void *, const int32_t vertex[3], bool last, bool to_b) {
  return bus->send(vertex, last, to_b);
}
#endif
bool bus_receive(void *, uint64_t *result, bool *last) { return bus->receive(result, last); }
void bus_block_results(bool block) { bus->blocked = block; }
void bus_idle(uint64_t cycles) {
  while (cycles-- > 0) {
    bus->tick();
  }
}
bool bus_interrupt(void) { return bus->interrupt; }
uint64_t bus_beats(void) { return bus->beats; }
uint64_t bus_cycles(void) { return bus->cycles; }
uint64_t bus_breaches(void) { return bus->breaches; }
