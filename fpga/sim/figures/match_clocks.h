#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "Vpattern.h"
#include "clocked.h"

namespace runmark::rtl {

/// Clocks the pattern core is busy with a quad that matches none of `codes` codes: 64 pixels read from a
/// memory that answers after `latency` clocks, all rotations searched.
inline std::uint64_t match_clocks(unsigned codes, unsigned latency) {
  Clocked<Vpattern> core;
  drive(core->last_x, 639);
  drive(core->last_y, 479);
  drive(core->level, 128);
  drive(core->codes, codes);
  drive(core->max_area, (1U << 21) - 1);
  core->min_area = 0;
  core->max_errors = 0;
  core->above_is_dark = 0;
  core->write = 1;
  for (unsigned i = 0; i < codes; ++i) {
    drive(core->write_at, i);
    drive(core->write_code, 1 + i);
    core.tick();
  }
  core->write = 0;
  // A black square of 40 pixels, clockwise from its top-left corner.
  drive(core->quad_x, 20ULL | 60ULL << 10 | 60ULL << 20 | 20ULL << 30);
  drive(core->quad_y, 20ULL | 20ULL << 9 | 60ULL << 18 | 60ULL << 27);
  drive(core->quad_bottom, 60);
  core->quad_hole = 0;
  core->quad_end = 0;
  core->quad_valid = 1;
  core->read_ready = 1;
  core->marker_ready = 1;
  core->grey = 0;
  std::deque<std::uint64_t> due;
  const std::uint64_t begin = core.cycles();
  do {
    core->grey_valid = !due.empty() && due.front() <= core.cycles();
    core.settle();
    if (core->grey_valid) due.pop_front();
    if (core->read_valid) due.push_back(core.cycles() + 1 + latency);
    core.tick();
    core->quad_valid = 0;
    core.settle();
  } while (!core->quad_ready && core.cycles() - begin < 1000000);
  return core.cycles() - begin;
}

}  // namespace runmark::rtl
