// The pattern core of the hardware profile (src/pattern/integer_reader.h is its definition): the cells of a square
// marker placed from all four corners of a quad, the light from its border and the ring outside, a check of the
// border, and a search for the cells in a dictionary at four rotations.
module quad_pattern #(
    parameter XW = 10,
    parameter YW = 9,           // at most XW
    parameter CODES = 1024,
    parameter IW = $clog2(CODES),
    parameter SW = XW + 6       // signed, of a corner in sixteenths of a pixel
) (
    input  logic            clk,
    input  logic            reset,
    input  logic [  XW-1:0] last_x,
    input  logic [  YW-1:0] last_y,
    input  logic [     3:0] width,         // cells along a side, border included: 6 to 10
    input  logic [     7:0] min_margin,    // in 1/256 of the contrast
    input  logic [     5:0] max_errors,    // wrong bits
    input  logic [    IW:0] codes,         // in the dictionary
    input  logic            write,         // a code: row by row, the last cell in bit 0; 1 = white
    input  logic [  IW-1:0] write_at,
    input  logic [    63:0] write_code,

    input  logic            quad_valid,
    output logic            quad_ready,
    input  logic [4*SW-1:0] quad_x,
    input  logic [4*SW-1:0] quad_y,
    input  logic [  YW-1:0] quad_bottom,
    input  logic            quad_hole,
    input  logic            quad_end,

    output logic            read_valid,    // pixels to be read; answers come in the same order
    input  logic            read_ready,
    output logic [  XW-1:0] read_x,
    output logic [  YW-1:0] read_y,        // at most four rows below the last one of the contour
    input  logic            grey_valid,
    input  logic [     7:0] grey,

    output logic            marker_valid,
    input  logic            marker_ready,
    output logic [4*SW-1:0] marker_x,      // top-left, top-right, bottom-right, bottom-left of the marker as drawn
    output logic [4*SW-1:0] marker_y,
    output logic [  YW-1:0] marker_bottom,
    output logic            marker_hole,
    output logic [  IW-1:0] marker_id,
    output logic [     1:0] marker_rotation,
    output logic [     5:0] marker_errors,
    output logic [    19:0] marker_clearance,  // the margin is clearance / scale
    output logic [    19:0] marker_scale,
    output logic            marker_end     // no marker: the frame's last has been handed on
);
  localparam [2:0] IDLE = 3'd0, CLEAR = 3'd1, READ = 3'd2, SEARCH = 3'd3, EMIT = 3'd4;
  logic [2:0] state;
  assign quad_ready = state == IDLE;
  assign marker_valid = state == EMIT;

  // The corners: they turn while their triangles' areas are taken, and with the code.
  logic [4*SW-1:0] x, y;
  logic place_turn, code_turn;
  assign marker_x = x;
  assign marker_y = y;
  logic [YW-1:0] last_row;
  wire [YW:0] rows_in = {1'b0, marker_bottom} + (YW + 1)'(4);

  logic not_convex, horizon, held, take, held_last;
  logic [XW+3:0] held_x;
  logic [YW+3:0] held_y;
  logic [3:0] held_column, held_row;
  sample_places #(.XW(XW), .YW(YW), .SW(SW)) places (
      .clk(clk), .reset(reset), .start(state == CLEAR), .width(width), .last_x(last_x), .last_row(last_row),
      .corners_x(x), .corners_y(y), .turn(place_turn), .failed(not_convex), .horizon(horizon), .held(held),
      .take(take), .held_x(held_x), .held_y(held_y), .held_column(held_column), .held_row(held_row),
      .held_last(held_last));

  logic reader_idle, sampled, sample_last;
  logic [11:0] sample_grey;
  logic [3:0] sample_column, sample_row;
  sample_reader #(.XW(XW), .YW(YW)) reader (
      .clk(clk), .reset(reset), .last_x(last_x), .last_row(last_row), .inverted(marker_hole),
      .held(held), .take(take), .held_x(held_x), .held_y(held_y), .held_column(held_column), .held_row(held_row),
      .held_last(held_last), .idle(reader_idle), .read_valid(read_valid), .read_ready(read_ready), .read_x(read_x),
      .read_y(read_y), .grey_valid(grey_valid), .grey(grey), .sampled(sampled), .sample_grey(sample_grey),
      .sample_column(sample_column), .sample_row(sample_row), .sample_last(sample_last));

  logic cell_write, cell_white, light_done, light_failed;
  logic [2:0] cell_row, cell_column;
  cell_light light (
      .clk(clk), .reset(reset), .clear(place_turn), .width(width), .min_margin(min_margin), .sampled(sampled),
      .sample_grey(sample_grey), .sample_column(sample_column), .sample_row(sample_row), .sample_last(sample_last),
      .cell_write(cell_write), .cell_row(cell_row), .cell_column(cell_column), .cell_white(cell_white),
      .done(light_done), .failed(light_failed), .clearance(marker_clearance), .scale(marker_scale));

  logic found, not_found;
  code_search #(.CODES(CODES)) search (
      .clk(clk), .reset(reset), .width(width), .max_errors(max_errors), .codes(codes), .write(write),
      .write_at(write_at), .write_code(write_code), .cell_write(cell_write), .cell_row(cell_row),
      .cell_column(cell_column), .cell_white(cell_white), .start(light_done), .found(found), .over(not_found),
      .turn(code_turn), .id(marker_id), .rotation(marker_rotation), .errors(marker_errors));

  always_ff @(posedge clk) begin
    if (state == IDLE) {x, y} <= {quad_x, quad_y};
    else if (place_turn || code_turn) {x, y} <= {x[SW-1:0], x[4*SW-1:SW], y[SW-1:0], y[4*SW-1:SW]};
    last_row <= rows_in > {1'b0, last_y} ? last_y : rows_in[YW-1:0];
    case (state)
      IDLE: begin
        marker_bottom <= quad_bottom;
        marker_hole <= quad_hole;
        marker_end <= quad_end;
        if (quad_valid) state <= quad_end ? EMIT : CLEAR;
      end
      CLEAR: state <= READ;
      READ: begin
        if (not_convex || light_failed || (horizon && reader_idle)) state <= IDLE;
        else if (light_done) state <= SEARCH;
      end
      SEARCH: begin
        if (found) state <= EMIT;
        else if (not_found) state <= IDLE;
      end
      default: if (marker_ready) state <= IDLE;
    endcase
    if (reset) state <= IDLE;
  end
endmodule
