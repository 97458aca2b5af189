// SPDX-License-Identifier: MIT
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
  Bus(uint64_t seed, const char *wave)
      : patient(seed % 4 == 1), top(wave, seed), stress(seed != 0), state(seed) {
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
    // What comes without valid is anything.
    uint64_t any = draw();
    top->s_axi_awaddr = (uint8_t)((top->s_axi_awvalid ? write_address : any) & 0x7f);
    top->s_axi_wdata = top->s_axi_wvalid ? write_data : (uint32_t)(any >> 7);
    top->s_axi_wstrb = (uint8_t)((top->s_axi_wvalid ? write_strobes : any >> 39) & 15);
    top->s_axi_araddr = (uint8_t)((top->s_axi_arvalid ? read_address : any >> 43) & 0x7f);
    drive_objects();
    top->s_axi_bready = gap() && (!patient || top->s_axi_bvalid);
    top->s_axi_rready = gap() && (!patient || top->s_axi_rvalid);
    top->m_axis_tready = !blocked && gap() && (!patient || top->m_axis_tvalid);
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
      responded = cycles;
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
    rose = top->irq && !interrupt ? cycles : rose;
    interrupt = top->irq;
    half_cycles();
    settle(top->s_axi_awvalid, want_aw, aw);
    settle(top->s_axi_wvalid, want_w, w);
    settle(top->s_axi_arvalid, want_ar, ar);
    settle_objects();
    beats += (uint64_t)aw + w + ar + t + b + r + m;
    waited = aw || w || ar || t > 0 || b || r || m ? 0 : waited + 1;
  }

  bool write(uint32_t address, uint32_t value, unsigned strobes) {
    uint64_t before = responses;
    write_address = address;
    write_data = value;
    write_strobes = strobes;
    want_aw = want_w = true;
    return until([&] { return responses != before; }) && response == 0;
  }

  bool read(uint32_t address, uint32_t *value) {
    uint64_t before = answers;
    read_address = address;
    want_ar = true;
    bool ok = until([&] { return answers != before; }) && answer_response == 0;
    *value = answer;
    return ok;
  }

  // Every channel goes on by itself, with gaps.
  void crowd(bus_access *list, size_t count, bool patiently) {
    const bool before[] = {stress, patient};
    size_t at[] = {0, 0, 0, 0, 0}; // the next of a channel: AW, W, B, AR, R
    uint64_t counted[] = {responses, answers};
    auto more = [&](int channel) {
      size_t &n = at[channel];
      while (n < count && (list[n].strobes != 0) != (channel < 3)) {
        n++;
      }
      return n < count;
    };
    stress = true;
    patient = patiently;
    until([&] {
      if (responses != counted[0] && more(2)) {
        list[at[2]++].ok = response == 0;
      }
      if (answers != counted[1] && more(4)) {
        list[at[4]].value = answer;
        list[at[4]++].ok = answer_response == 0;
      }
      counted[0] = responses;
      counted[1] = answers;
      if (!want_aw && more(0)) {
        write_address = list[at[0]++].address;
        want_aw = true;
      }
      if (!want_w && more(1)) {
        write_data = list[at[1]].value;
        write_strobes = list[at[1]++].strobes;
        want_w = true;
      }
      if (!want_ar && more(3)) {
        read_address = list[at[3]++].address;
        want_ar = true;
      }
      return !more(2) && !more(4);
    });
    stress = before[0];
    patient = before[1];
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
    offer(vertex, last, to_b, 1);
    return sent();
  }

  void offer(const int32_t vertex[3], bool last, bool to_b, uint64_t after) {
    for (int i = 0; i < 3; i++) {
      offered[i] = (uint32_t)vertex[i];
    }
    last_offered = last;
    offered_to_b = to_b;
    until_t = after;
  }

  bool sent() {
    return until([&] { return until_t == 0 && !want_t; });
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
  bool patient;                               // ready comes after valid alone
  uint64_t rose = 0, responded = 0, came = 0; // cycles of an interrupt, a response, a vertex
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
    if (top->m_axi_arvalid && (top->m_axi_arsize != 4 || top->m_axi_arburst != 1)) {
      breach("a burst that is not of 16 bytes a beat, or not INCR");
    }
    unsigned transfers = (unsigned)(top->m_axi_arvalid && top->m_axi_arready) +
                         (unsigned)(top->m_axi_rvalid && top->m_axi_rready);
    memory_clock(&external, &master);
    return transfers;
  }
  void settle_objects() {}
  memory external{};
#else
  void reset_objects() {
    want_t = top->s_axis_tvalid = false;
    until_t = 0;
  }
  void drive_objects() {
    want_t = want_t || until_t == 1;
    until_t -= until_t > 0;
    choose(top->s_axis_tvalid, want_t);
    uint64_t any = draw();
    for (int i = 0; i < 4; i++) { // the highest word is unused
      top->s_axis_tdata[i] = top->s_axis_tvalid && i < 3 ? offered[i] : (uint32_t)(any >> 8 * i);
    }
    top->s_axis_tlast = top->s_axis_tvalid ? last_offered : any >> 62 & 1;
    top->s_axis_tdest = top->s_axis_tvalid ? offered_to_b : any >> 63;
  }
  unsigned transfers_of_objects() {
    taken_t = top->s_axis_tvalid && top->s_axis_tready;
    came = taken_t ? cycles : came;
    return taken_t;
  }
  void settle_objects() { settle(top->s_axis_tvalid, want_t, taken_t); }
  bool want_t = false, taken_t = false;
  uint64_t until_t = 0; // cycles until a vertex is offered
  uint32_t offered[3] = {0, 0, 0};
  bool last_offered = false, offered_to_b = false;
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
#ifdef HASTY // a mutant: one is enough
    std::exit(1);
#endif
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
  uint32_t write_address = 0, write_data = 0, write_strobes = 0, read_address = 0;
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
void bus_offer(const int32_t vertex[3], bool last, bool to_b, uint64_t after) {
  bus->offer(vertex, last, to_b, after);
}
bool bus_sent(void) { return bus->sent(); }
#endif
void bus_crowd(bus_access *list, size_t count, bool patient) { bus->crowd(list, count, patient); }
bool bus_receive(void *, uint64_t *result, bool *last) { return bus->receive(result, last); }
void bus_block_results(bool block) { bus->blocked = block; }
void bus_idle(uint64_t cycles) {
  while (cycles-- > 0) {
    bus->tick();
  }
}
bool bus_interrupt(void) { return bus->interrupt; }
uint64_t bus_rose(void) { return bus->rose; }
uint64_t bus_responded(void) { return bus->responded; }
uint64_t bus_came(void) { return bus->came; }
uint64_t bus_beats(void) { return bus->beats; }
uint64_t bus_cycles(void) { return bus->cycles; }
uint64_t bus_breaches(void) { return bus->breaches; }
