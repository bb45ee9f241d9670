// The grey level of a place between four pixels (`grey_between` in src/pattern/integer_reader.h): reads them, weighs
// them, and turns the level round for a light square.
module sample_reader #(
    parameter XW = 10,
    parameter YW = 9
) (
    input  logic          clk,
    input  logic          reset,
    input  logic [XW-1:0] last_x,
    input  logic [YW-1:0] last_row,
    input  logic          inverted,

    input  logic          held,        // a place is there
    output logic          take,
    input  logic [XW+3:0] held_x,
    input  logic [YW+3:0] held_y,
    input  logic [   3:0] held_column,
    input  logic [   3:0] held_row,
    input  logic          held_last,
    output logic          idle,

    output logic          read_valid,
    input  logic          read_ready,
    output logic [XW-1:0] read_x,
    output logic [YW-1:0] read_y,
    input  logic          grey_valid,
    input  logic [   7:0] grey,

    output logic          sampled,     // for a clock; the rest stays until the next place is taken
    output logic [  11:0] sample_grey,
    output logic [   3:0] sample_column,
    output logic [   3:0] sample_row,
    output logic          sample_last
);
  logic reading, weighing;
  logic [1:0] asked;
  logic [2:0] answered;
  assign idle = !reading && !weighing;
  assign take = held && idle;
  logic [XW-1:0] pixel_x;
  logic [YW-1:0] pixel_y;
  assign read_valid = reading;
  assign read_x = asked[0] && pixel_x != last_x ? pixel_x + 1'b1 : pixel_x;
  assign read_y = asked[1] && pixel_y != last_row ? pixel_y + 1'b1 : pixel_y;
  // Of the pixel that is answered next and of its neighbour, across and down: they take turns.
  logic [4:0] share_x, other_x, share_y, other_y;
  logic [8:0] pixel_share;
  logic [7:0] pixel_grey;
  logic [16:0] pixel_part;
  logic part_1, part_2;
  logic [16:0] total;  // in 1/256
  logic [2:0] settle;
  wire [11:0] level_seen = total[15:4];

  always_ff @(posedge clk) begin
    if (take) begin
      pixel_x <= held_x[XW+3:4];
      pixel_y <= held_y[YW+3:4];
      sample_column <= held_column;
      sample_row <= held_row;
      sample_last <= held_last;
      reading <= 1'b1;
      weighing <= 1'b1;
      {share_x, other_x} <= {5'd16 - {1'b0, held_x[3:0]}, 1'b0, held_x[3:0]};
      {share_y, other_y} <= {5'd16 - {1'b0, held_y[3:0]}, 1'b0, held_y[3:0]};
      asked <= '0;
      answered <= '0;
      total <= '0;
    end else begin
      if (reading && read_ready) begin
        asked <= asked + 1'b1;
        if (asked == 2'd3) reading <= 1'b0;
      end
      if (grey_valid) answered <= answered + 1'b1;
      if (grey_valid) {share_x, other_x} <= {other_x, share_x};
      if (grey_valid && answered[0]) {share_y, other_y} <= {other_y, share_y};
      if (part_2) total <= total + pixel_part;
    end
    pixel_share <= share_x * share_y;
    pixel_grey <= grey;
    part_1 <= grey_valid;
    pixel_part <= pixel_share * pixel_grey;
    part_2 <= part_1;
    settle <= {settle[1:0], weighing && answered == 3'd4 && !take};
    sampled <= weighing && settle[2] && !sampled;
    if (weighing && settle[2] && !sampled) sample_grey <= inverted ? 12'd4080 - level_seen : level_seen;
    if (sampled) weighing <= 1'b0;
    if (!weighing) settle <= '0;
    if (reset) begin
      reading <= 1'b0;
      weighing <= 1'b0;
      sampled <= 1'b0;
      settle <= '0;
      part_1 <= 1'b0;
      part_2 <= 1'b0;
    end
  end
  wire unused = &{1'b0, total[16], total[3:0]};
endmodule
