#include "contour/contour_linker.h"

#include "cores.h"

namespace runmark::hls_form {

// The linker takes a row of runs at a time: they wait in an array until the row has ended.
void contour(const Settings& settings, RunStream& runs, ChainStream& chains) {
#pragma HLS INTERFACE s_axilite port = settings
#pragma HLS INTERFACE axis port = runs
#pragma HLS INTERFACE axis port = chains
  static Record records[max_records];
  static ChainEnd ends[max_width + 2];
  static EndIndex end_at[max_width + 1];
  static CrackRun row[max_width + 1];
#pragma HLS BIND_STORAGE variable = records type = ram_2p
#pragma HLS BIND_STORAGE variable = ends type = ram_2p
#pragma HLS BIND_STORAGE variable = end_at type = ram_2p
#pragma HLS BIND_STORAGE variable = row type = ram_1p
  ChainLimits limits;
  limits.max_turns = settings.max_turns;
  limits.max_records = max_records + 1;  // none but the pool's
  limits.min_height = static_cast<std::uint16_t>(settings.min_height);
  limits.holes = settings.holes;
  ContourLinker linker(records, ends, end_at, limits);

  std::size_t count = 0;
  bool ended = false;
  while (!ended) {
#pragma HLS PIPELINE off
    const Word word = runs.read();
    if (is_line_end(word)) {
      linker.row(static_cast<std::uint16_t>(field(word, 0, 16)), std::span<const CrackRun>(row, count),
                 [&](const ClosedChain& chain) {
                   for (RecordIndex i = chain.head;; i = (*chain.pool)[i].next) {
                     const Record& record = (*chain.pool)[i];
                     chains.write(record_word(record.x, record.y, i == chain.tail, chain.hole));
                     if (i == chain.tail) break;
                   }
                 });
      count = 0;
      ended = is_last(word);
    } else {
      row[count++] = run_of(word);
    }
  }
  chains.write(frame_end);
}

}  // namespace runmark::hls_form
