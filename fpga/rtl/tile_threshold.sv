// The light-following threshold core (src/threshold/integer_tiles.h is its definition): grey pixels in, dark or light
// pixels out, eight rows later. Tiles of 4x4 pixels: least and greatest level of each, spread over its 3x3
// neighbours, and half-way between them the level of the tile; the contrast below which a tile is all light follows
// the noise. When the frame's last pixel is in, the rows still held follow by themselves.
//
// Everything moves one step for each pixel. The store of eight rows is a ring: what is written replaces what is read.
// Rows go on being counted while the rest is sent, so that a band of tiles cut short by the frame's end is finished
// like any other.
//
// The first pixel of a frame lies on its border, light whatever it was, and goes out at once: what is behind begins the
// frame when it begins here, and ends the one before if that was cut off.
module tile_threshold #(
    parameter MAX_WIDTH = 640,
    parameter MAX_HEIGHT = 480,
    parameter XW = $clog2(MAX_WIDTH),
    parameter YW = $clog2(MAX_HEIGHT)
) (
    input  logic          clk,
    input  logic          reset,
    input  logic [XW-1:0] last_x,        // width - 1: at least 15
    input  logic [YW-1:0] last_y,        // height - 1
    input  logic [   7:0] min_contrast,
    input  logic          in_valid,
    output logic          in_ready,
    input  logic [   7:0] in_grey,
    input  logic          in_sof,        // first pixel: a frame begins, whatever became of the one before
    output logic          out_valid,
    input  logic          out_ready,
    output logic          out_dark,
    output logic          out_sof
);
  localparam TW = XW - 2;
  localparam TILES = (MAX_WIDTH + 3) / 4;
  localparam [15:0] NOTHING = {8'd0, 8'd255};  // greatest and least of no pixels

  // Where the frame stands.
  logic [XW-1:0] x;
  logic [YW:0] y;  // goes on below the frame
  logic filling, flushing;
  wire go = !out_valid || out_ready;
  assign in_ready = go && !flushing;
  wire takes = in_valid && in_ready && (in_sof || filling);
  wire step = takes || (flushing && go);
  wire fresh = in_sof && !flushing;
  wire [XW-1:0] here_x = fresh ? '0 : x;
  wire [YW:0] here_y = fresh ? '0 : y;
  wire ends_line = here_x == last_x;
  wire [XW-1:0] next_x = ends_line ? '0 : here_x + 1'b1;
  wire [YW:0] below = {1'b0, last_y} + (YW + 1)'(8);  // the row with which the last row goes out
  wire flushed = flushing && here_y > below && here_x[3:0] == '1;

  // The rows held.
  logic [7:0] ring[0:8*MAX_WIDTH-1];
  logic [XW+2:0] ring_at;
  logic [7:0] old;  // eight rows above the pixel that comes in
  wire [XW+2:0] ring_here = fresh ? '0 : ring_at;
  wire [XW+2:0] ring_next = ring_here == {last_x, 3'b111} ? '0 : ring_here + 1'b1;
  always_ff @(posedge clk) begin
    if (step) ring[ring_here] <= in_grey;
    if (step) old <= ring[ring_next];
  end

  // The extremes of the tiles of this band so far, {greatest, least}.
  function automatic [15:0] both(input [15:0] a, input [15:0] b);
    both = {a[15:8] > b[15:8] ? a[15:8] : b[15:8], a[7:0] < b[7:0] ? a[7:0] : b[7:0]};
  endfunction
  logic [15:0] band[0:TILES-1];
  logic [15:0] band_read, band_before, tile_so_far;
  wire [TW-1:0] tile = here_x[XW-1:2];
  wire tile_begins = here_x[1:0] == 2'd0;
  wire tile_ends = here_x[1:0] == 2'd3 || ends_line;
  wire [15:0] tile_before = !tile_begins ? tile_so_far : here_y[1:0] == 2'd0 ? NOTHING : band_before;
  wire [15:0] tile_now = flushing ? tile_before : both(tile_before, {in_grey, in_grey});
  // Read two pixels ahead, written one behind.
  logic [XW-1:0] last_but_one;  // stays all the frame
  wire [TW-1:0] tile_ahead = ends_line || here_x == last_but_one ? '0 : tile + TW'(here_x[1]);
  logic ended;
  logic [TW-1:0] ended_tile;
  always_ff @(posedge clk) begin
    if (step && ended) band[ended_tile] <= tile_so_far;
    if (step) band_read <= band[tile_ahead];
    if (step) band_before <= band_read;
    last_but_one <= last_x - 1'b1;
  end

  // A tile that is complete, then it and its neighbours left and right.
  logic done, done_last, done_real, done_first;
  logic [15:0] done_range, left, far_left;  // of the tiles before
  logic [TW-1:0] done_tile;
  logic rest;  // the last tile of the row is to be spread
  logic spread, spread_first;
  logic [15:0] spread_range;
  logic [TW-1:0] spread_tile;
  wire spreads = rest || (done && done_tile != '0);
  wire [TW-1:0] spreads_tile = rest ? done_tile : done_tile - 1'b1;

  // The two bands above, then the levels: {contrast, least}.
  logic [31:0] above[0:TILES-1];
  logic [31:0] above_range;
  wire [15:0] one_above = above_range[15:0];
  logic merged, leveled;
  logic [15:0] merged_range, two_above, level_range;
  logic [TW-1:0] merged_tile, level_tile;
  logic [15:0] levels[0:TILES-1];
  logic [15:0] level_1;
  always_ff @(posedge clk) begin
    if (step && spread) above[spread_tile] <= {spread_first ? NOTHING : one_above, spread_range};
    if (step) above_range <= above[spreads_tile];
    if (step && leveled) levels[level_tile] <= {level_range[15:8] - level_range[7:0], level_range[7:0]};
    if (step) level_1 <= levels[tile];
  end

  // The noise: the lower quartile of the tiles' ranges, in 1/64.
  logic ranged;
  logic [7:0] range;
  logic [13:0] quartile;
  wire [17:0] nine_quartiles = {1'b0, quartile, 3'b0} + {4'b0, quartile};
  wire [9:0] noise = nine_quartiles[17:8];
  wire [7:0] low_limit = min_contrast > 8'd40 ? min_contrast : 8'd40;
  logic [7:0] limit;

  // The pixels on their way out.
  logic valid_1, valid_2, valid_3;
  logic [7:0] grey_1, grey_2, grey_3, level_3, contrast_3;
  logic [15:0] level_2;
  wire first = here_y == (YW + 1)'(8) && here_x == '0;
  wire sends = here_y[YW:3] != '0 && here_y <= below && !first;

  always_ff @(posedge clk) begin
    if (takes) begin
      filling <= !(ends_line && here_y == {1'b0, last_y});
      flushing <= ends_line && here_y == {1'b0, last_y};
    end else if (step && flushed) begin
      flushing <= 1'b0;
    end

    if (step) begin
      x <= next_x;
      y <= ends_line ? here_y + 1'b1 : here_y;
      ring_at <= ring_next;
      tile_so_far <= tile_now;
      ended <= tile_ends;
      ended_tile <= tile;

      done <= tile_ends && here_y[1:0] == 2'd3;
      if (tile_ends) begin
        done_range <= tile_now;
        done_tile <= tile;
        done_last <= ends_line;
        done_real <= here_y[YW:2] <= {1'b0, last_y[YW-1:2]};
        done_first <= here_y[YW:2] == '0;
      end

      if (done) begin
        left <= done_range;
        far_left <= done_tile == '0 ? NOTHING : left;
      end
      rest <= done && done_last && !fresh;
      spread <= spreads && !fresh;
      spread_tile <= spreads_tile;
      spread_range <= done_real ? both(both(left, rest ? NOTHING : done_range), far_left) : NOTHING;
      spread_first <= done_first;

      merged <= spread && !fresh;
      merged_tile <= spread_tile;
      merged_range <= both(spread_range, one_above);
      two_above <= above_range[31:16];
      leveled <= merged && !fresh;
      level_tile <= merged_tile;
      level_range <= both(merged_range, two_above);

      ranged <= done && done_real && !fresh;
      range <= done_range[15:8] - done_range[7:0];
      if (fresh) quartile <= '0;
      else if (ranged) begin
        if ({range, 6'b0} > quartile) quartile <= quartile + 1'b1;
        else if (quartile >= 14'd3) quartile <= quartile - 14'd3;
      end
      if (here_x == XW'(2) && here_y[1:0] == 2'd0) begin
        limit <= noise < {2'b0, min_contrast} ? min_contrast : noise < {2'b0, low_limit} ? noise[7:0] : low_limit;
      end

      valid_1 <= sends && !fresh;
      grey_1 <= old;
      valid_2 <= valid_1 && !fresh;
      grey_2 <= grey_1;
      level_2 <= level_1;
      valid_3 <= valid_2 && !fresh;
      grey_3 <= grey_2;
      level_3 <= level_2[7:0] + {1'b0, level_2[15:9]};
      contrast_3 <= level_2[15:8];
      out_dark <= grey_3 < level_3 && contrast_3 >= limit && !fresh;
      out_sof <= fresh;
    end
    if (go) out_valid <= step && (fresh || valid_3);

    if (reset) begin
      filling <= 1'b0;
      flushing <= 1'b0;
      out_valid <= 1'b0;
      valid_1 <= 1'b0;
      valid_2 <= 1'b0;
      valid_3 <= 1'b0;
      done <= 1'b0;
      rest <= 1'b0;
      spread <= 1'b0;
      merged <= 1'b0;
      leveled <= 1'b0;
      ranged <= 1'b0;
    end
  end

  wire unused = &{1'b0, nine_quartiles[7:0]};
endmodule
