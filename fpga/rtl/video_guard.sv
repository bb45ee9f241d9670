// Makes frames of exactly the size that is set out of whatever video comes in: lines that end early are filled up
// with light pixels, what is beyond the width or below the last line is dropped, and a start of frame in the middle of
// a line begins the next frame once the line has been filled up.
module video_guard #(
    parameter XW = 10,
    parameter YW = 9
) (
    input  logic          clk,
    input  logic          reset,
    input  logic          run,          // take in frames
    input  logic [XW-1:0] last_x,
    input  logic [YW-1:0] last_y,
    input  logic [  23:0] light,        // a light pixel
    input  logic          video_valid,
    output logic          video_ready,
    input  logic [  23:0] video_data,
    input  logic          video_user,   // first pixel of a frame
    input  logic          video_last,   // last pixel of a line
    output logic          out_valid,
    input  logic          out_ready,
    output logic [  23:0] out_data,
    output logic          out_sof,
    output logic          cut_frame,    // pulses: the frame before was cut off
    output logic          bad_line
);
  localparam [1:0] BETWEEN = 2'd0, LINE = 2'd1, FILL = 2'd2, REST = 2'd3;
  logic [1:0] state;  // between frames; in a line; filling one up; dropping what is too long
  logic [XW-1:0] x;
  logic [YW-1:0] y;
  wire middle = x != '0 || y != '0;

  wire user = video_valid && video_user;
  wire fills = state == FILL;
  wire early = state == LINE && user && x != '0;  // waits until the line is full
  wire starts = user && run && !fills && !early;
  wire stops = user && !run && !fills && !early;
  wire pixel = state == LINE && video_valid && !video_user;
  assign out_valid = fills || starts || pixel;
  assign out_data = fills ? light : video_data;
  assign out_sof = starts;
  assign video_ready = starts || pixel ? out_ready : !fills && !early;

  wire moves = out_valid && out_ready;
  wire [XW-1:0] here_x = starts ? '0 : x;
  wire [YW-1:0] here_y = starts ? '0 : y;
  wire at_end = here_x == last_x;
  wire at_bottom = here_y == last_y;
  always_ff @(posedge clk) begin
    cut_frame <= moves && starts && middle;
    bad_line <= early || (moves && !fills && video_last != at_end);
    if (moves) begin
      x <= at_end ? '0 : here_x + 1'b1;
      y <= !at_end ? here_y : at_bottom ? '0 : here_y + 1'b1;
      if (!at_end) state <= fills || video_last ? FILL : LINE;
      else if (!fills && !video_last) state <= REST;
      else state <= at_bottom ? BETWEEN : LINE;
    end else if (early) begin
      state <= FILL;
    end else if (stops) begin
      state <= BETWEEN;
    end else if (state == REST && video_valid && !video_user && video_last) begin
      state <= middle ? LINE : BETWEEN;
    end
    if (reset) begin
      state <= BETWEEN;
      x <= '0;
      y <= '0;
      cut_frame <= 1'b0;
      bad_line <= 1'b0;
    end
  end
endmodule
