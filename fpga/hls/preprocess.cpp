#include "cores.h"
#include "preprocess/filter_table.h"

namespace runmark::hls_form {

// The paper's Fig. 4: the rows above stand in line buffers, and a window moves along them. The window of
// unfiltered pixels is a row and a column behind the pixel that comes in, so a row and a column of light
// pixels follow the image.
void preprocess(const Settings& settings, BitStream& dark, RunStream& runs) {
#pragma HLS INTERFACE s_axilite port = settings
#pragma HLS INTERFACE axis port = dark
#pragma HLS INTERFACE axis port = runs
  static bool above_1[max_width + 1];      // the row above, unfiltered
  static bool above_2[max_width + 1];      // the one above that
  static bool clean_above[max_width + 1];  // the filtered row above
#pragma HLS BIND_STORAGE variable = above_1 type = ram_2p
#pragma HLS BIND_STORAGE variable = above_2 type = ram_2p
#pragma HLS BIND_STORAGE variable = clean_above type = ram_2p
  unsigned window = 0;      // bits as in filter_table.h
  bool above_left = false;  // the 2x2 window of filtered pixels
  bool current_left = false;
  bool inside = false;  // a run has begun and not ended
  CrackRun run;

  int x = 0;
  int y = 0;
  const int steps = (settings.width + 1) * (settings.height + 1);
  for (int i = 0; i < steps; ++i) {
#pragma HLS PIPELINE II = 1
#pragma HLS DEPENDENCE variable = above_1 inter false
#pragma HLS DEPENDENCE variable = above_2 inter false
#pragma HLS DEPENDENCE variable = clean_above inter false
    const bool in_image = x < settings.width && y < settings.height;
    const bool border = x == 0 || x == settings.width - 1 || y == 0 || y == settings.height - 1;
    const bool pixel = in_image && dark.read() != 0 && !border;

    // The column that comes in, and the filtered pixel in the window's middle: (x - 1, y - 1).
    const bool n = y > 1 && x < settings.width && above_2[x];
    const bool middle = y > 0 && x < settings.width && above_1[x];
    if (x < settings.width) {
      above_2[x] = middle;
      above_1[x] = pixel;
    }
    if (x == 0) {
      window = 0;
      above_left = current_left = inside = false;
    }
    constexpr unsigned left_and_middle = 0b011'011'011;
    window = (window >> 1 & left_and_middle) | (n ? 4U : 0U) | (middle ? 32U : 0U) | (pixel ? 256U : 0U);

    if (x > 0 && y > 0) {
      const bool current = filter_pixel(static_cast<Window>(window), settings.cases);
      const bool above = y > 1 && clean_above[x - 1];
      clean_above[x - 1] = current;
      const bool crack_above = above_left != above;
      const bool in_run = above_left != current_left;
      const bool run_next = above != current;
      const bool crosswise = in_run && run_next && crack_above;
      const bool takes_above = crosswise ? current_left == settings.eight : crack_above;
      // A run ends where the rows stop to differ, or differ the other way round.
      if (inside && (!run_next || crosswise)) {
        run.x1 = static_cast<std::uint16_t>(x - 1);
        run.right_above = takes_above;
        runs.write(run_word(run));
      }
      if (run_next && (!in_run || crosswise)) {
        run.x0 = static_cast<std::uint16_t>(x - 1);
        run.top = current;
        run.left_above = crosswise ? !takes_above : crack_above;
      }
      inside = run_next;
      above_left = above;
      current_left = current;
      if (x == settings.width) runs.write(line_end_word(y - 1, y == settings.height));
    }
    if (x == settings.width) {
      x = 0;
      ++y;
    } else {
      ++x;
    }
  }
}

}  // namespace runmark::hls_form
