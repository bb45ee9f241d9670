#include "contour/record_pool.h"
#include "cores.h"
#include "corner/corner_state_machine.h"

namespace runmark::hls_form {

void corner(const Settings& settings, ChainStream& chains, QuadStream& quads) {
#pragma HLS INTERFACE s_axilite port = settings
#pragma HLS INTERFACE axis port = chains
#pragma HLS INTERFACE axis port = quads
  static Record records[max_records];
#pragma HLS BIND_STORAGE variable = records type = ram_2p
  RecordPool pool(records);
  pool.reset();
  ClosedChain chain;
  chain.pool = &pool;

  for (Word word = chains.read(); word != frame_end; word = chains.read()) {
#pragma HLS PIPELINE off
    const auto y = static_cast<std::uint16_t>(field(word, 16, 16));
    const RecordIndex record = pool.take(static_cast<std::uint16_t>(field(word, 0, 16)), y, no_record);
    if (chain.records == 0) {
      chain.head = record;
    } else {
      pool.link(chain.tail, record);
    }
    chain.tail = record;
    ++chain.records;
    if (field(word, 32, 1) == 0) continue;

    chain.bottom = y;
    const auto corners = four_corners(chain, settings.corner_offset);
    if (corners) {
      quads.write(places_word((*corners)[0], (*corners)[1]));
      quads.write(places_word((*corners)[2], (*corners)[3]));
      quads.write(quad_word(chain.bottom, field(word, 33, 1) != 0));
    }
    pool.reset();
    chain.records = 0;
  }
  quads.write(frame_end);
}

}  // namespace runmark::hls_form
