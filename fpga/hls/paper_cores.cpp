#include "cores.h"

namespace runmark::hls_form {

void paper_cores(const Settings& settings, const std::uint64_t codes[max_codes], PixelStream& pixels,
                 GreyStream& grey, ReadStream& reads, GreyStream& answers, MarkerStream& markers) {
#pragma HLS INTERFACE s_axilite port = settings
#pragma HLS INTERFACE bram port = codes
#pragma HLS INTERFACE axis port = pixels
#pragma HLS INTERFACE axis port = grey
#pragma HLS INTERFACE axis port = reads
#pragma HLS INTERFACE axis port = answers
#pragma HLS INTERFACE axis port = markers
#pragma HLS DATAFLOW
  BitStream dark("dark");
  RunStream runs("runs");
  ChainStream chains("chains");
  QuadStream quads("quads");
  RUNMARK_PROCESS(threshold_core, threshold(settings, pixels, dark, grey));
  RUNMARK_PROCESS(preprocess_core, preprocess(settings, dark, runs));
  RUNMARK_PROCESS(contour_core, contour(settings, runs, chains));
  RUNMARK_PROCESS(corner_core, corner(settings, chains, quads));
  RUNMARK_PROCESS(pattern_core, pattern(settings, codes, quads, reads, answers, markers));
}

}  // namespace runmark::hls_form
