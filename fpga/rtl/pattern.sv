// The paper's pattern core: an 8x8 grid built on the first edge of a quad (src/pattern/square_grid.h), the
// pixel in the middle of each cell, and a search for the 36 inner cells in a dictionary at four rotations. The 28
// cells round them must be black; those that are not count as wrong bits. Quads that are too small, too large or
// not convex are put aside while the pixels are being read.
module pattern #(
    parameter XW = 10,
    parameter YW = 9,
    parameter CODES = 1024,
    parameter IW = $clog2(CODES)
) (
    input  logic            clk,
    input  logic            reset,
    input  logic [  XW-1:0] last_x,
    input  logic [  YW-1:0] last_y,
    input  logic [     8:0] level,
    input  logic            above_is_dark,
    input  logic            filtered,      // contours run a row late
    input  logic [XW+YW+1:0] min_area,      // of the quad, in half pixels
    input  logic [XW+YW+1:0] max_area,
    input  logic [     5:0] max_errors,    // wrong bits
    input  logic [    IW:0] codes,         // in the dictionary
    input  logic            write,         // a code: bit 35 is the top-left cell, row by row; 1 = white
    input  logic [  IW-1:0] write_at,
    input  logic [    35:0] write_code,

    input  logic            quad_valid,
    output logic            quad_ready,
    input  logic [4*XW-1:0] quad_x,
    input  logic [4*YW-1:0] quad_y,
    input  logic [  YW-1:0] quad_bottom,
    input  logic            quad_hole,
    input  logic            quad_end,

    output logic            read_valid,    // pixels to be read; answers come in the same order
    input  logic            read_ready,
    output logic [  XW-1:0] read_x,
    output logic [  YW-1:0] read_y,
    input  logic            grey_valid,
    input  logic [     7:0] grey,

    output logic            marker_valid,
    input  logic            marker_ready,
    output logic [4*XW-1:0] marker_x,      // cracks; top-left, top-right, bottom-right, bottom-left of the marker as drawn
    output logic [4*YW-1:0] marker_y,
    output logic [  YW-1:0] marker_bottom,
    output logic            marker_hole,
    output logic [  IW-1:0] marker_id,
    output logic [     1:0] marker_rotation,
    output logic [     5:0] marker_errors,
    output logic            marker_end     // no marker: the frame's last has been handed on
);
  localparam W = (XW > YW ? XW : YW) + 1;  // of a signed difference
  localparam PW = W + 6;                   // of a grid point in sixteenths

  localparam [2:0] IDLE = 3'd0, SET = 3'd1, READ = 3'd2, WAIT = 3'd3, MATCH = 3'd4, EMIT = 3'd5;
  logic [2:0] state;

  // The corners, clockwise; they turn with the code.
  logic [XW-1:0] x[0:3];
  logic [YW-1:0] y[0:3];
  logic turn;
  assign marker_x = {x[3], x[2], x[1], x[0]};
  assign marker_y = {y[3], y[2], y[1], y[0]};

  // The corners turn once round while their shape is looked at.
  logic shape_busy, shape_good, shape_turn;
  quad_shape #(.XW(XW), .YW(YW)) shape (
      .clk(clk), .reset(reset), .clear(state == IDLE), .start(state == IDLE && quad_valid && !quad_end),
      .min_area(min_area), .max_area(max_area), .corners_x(marker_x), .corners_y(marker_y), .turn(shape_turn),
      .busy(shape_busy), .good(shape_good));

  // The grid.
  logic signed [W-1:0] u_x, u_y;
  logic signed [PW-1:0] row_x, row_y, cell_x, cell_y;
  logic [2:0] column, row;
  wire signed [PW-1:0] wide_u_x = PW'(u_x);
  wire signed [PW-1:0] wide_u_y = PW'(u_y);
  wire signed [PW-1:0] two_u_x = wide_u_x <<< 1;
  wire signed [PW-1:0] two_u_y = wide_u_y <<< 1;
  wire outside = cell_x[PW-1] || cell_y[PW-1] || cell_x[PW-2:4] > {{(PW - 5 - XW) {1'b0}}, last_x}
              || cell_y[PW-2:4] > {{(PW - 5 - YW) {1'b0}}, last_y};
  // The square may reach a little below the rows that have come in.
  wire [YW:0] lowest = {1'b0, marker_bottom} + {{YW{1'b0}}, filtered};
  logic reading;
  assign read_valid = reading && !outside;
  assign read_x = cell_x[XW+3:4];
  assign read_y = {1'b0, cell_y[YW+3:4]} > lowest ? lowest[YW-1:0] : cell_y[YW+3:4];

  // The answers.
  logic [6:0] asked, answered;
  logic missed;
  logic [35:0] code;
  logic [4:0] border_errors;
  wire border_bad = {1'b0, border_errors} > max_errors;  // then no code can match
  wire white = (({1'b0, grey} >= level) == above_is_dark) == marker_hole;
  wire in_border = answered[2:0] == 3'd0 || answered[2:0] == 3'd7 || answered[5:3] == 3'd0 || answered[5:3] == 3'd7;

  // The search: a code a clock, its wrong bits four clocks later.
  logic [35:0] dictionary[0:CODES-1];
  logic [35:0] entry, different;
  logic [IW:0] search_at;
  logic [3:0] searching;  // the codes on their way
  logic [6:0] errors;
  wire search_more = state == MATCH && search_at != codes;
  wire hit = searching[3] && errors <= {1'b0, max_errors};
  function automatic [2:0] ones(input [5:0] b);
    ones = {2'b0, b[0]} + {2'b0, b[1]} + {2'b0, b[2]} + {2'b0, b[3]} + {2'b0, b[4]} + {2'b0, b[5]};
  endfunction
  logic [2:0] row_errors[0:5];
  wire [6:0] code_errors = {2'b0, border_errors} + {4'b0, row_errors[0]} + {4'b0, row_errors[1]}
                         + {4'b0, row_errors[2]} + {4'b0, row_errors[3]} + {4'b0, row_errors[4]} + {4'b0, row_errors[5]};
  logic [35:0] turned;  // the code, a quarter turn back
  always_comb begin
    for (int r = 0; r < 6; r++) for (int c = 0; c < 6; c++) turned[35-(6*r+c)] = code[35-(6*c+5-r)];
  end
  // How far search_at is past the code whose errors stand in `errors`: it stops at the last.
  wire [IW:0] hit_distance = (IW + 1)'(1) + {{IW{1'b0}}, searching[0]} + {{IW{1'b0}}, searching[1]} + {{IW{1'b0}}, searching[2]};
  wire search_over = state == MATCH && !search_more && searching == '0;
  wire next_rotation = search_over && marker_rotation != 2'd3;
  assign turn = shape_turn || next_rotation;

  always_ff @(posedge clk) begin
    if (write) dictionary[write_at] <= write_code;
    entry <= dictionary[search_at[IW-1:0]];
  end

  assign quad_ready = state == IDLE;
  assign marker_valid = state == EMIT;

  integer i;
  always_ff @(posedge clk) begin
    if (state == IDLE) begin
      for (i = 0; i < 4; i = i + 1) begin  // a hole is followed the other way round
        x[i] <= quad_hole ? quad_x[XW*(3-i)+:XW] : quad_x[XW*i+:XW];
        y[i] <= quad_hole ? quad_y[YW*(3-i)+:YW] : quad_y[YW*i+:YW];
      end
    end else if (turn) begin
      for (i = 0; i < 4; i = i + 1) begin
        x[i] <= x[(i+1)%4];
        y[i] <= y[(i+1)%4];
      end
    end

    if (state == IDLE) begin
      marker_bottom <= quad_bottom;
      marker_hole <= quad_hole;
      marker_end <= quad_end;
    end

    case (state)
      IDLE: if (quad_valid) state <= quad_end ? EMIT : SET;
      SET: begin
        // Cell (0, 0): 16 a + u + v, with v = (-u_y, u_x).
        u_x <= $signed(W'(x[1])) - $signed(W'(x[0]));
        u_y <= $signed(W'(y[1])) - $signed(W'(y[0]));
        state <= READ;
      end
      READ: state <= WAIT;
      WAIT: if (answered == asked && !reading && !shape_busy)
        state <= missed || !shape_good || border_bad ? IDLE : MATCH;
      MATCH: begin
        if (hit) state <= EMIT;
        else if (search_over && marker_rotation == 2'd3) state <= IDLE;
      end
      default: if (marker_ready) state <= IDLE;
    endcase

    if (state == SET) begin
      column <= '0;
      row <= '0;
      asked <= '0;
      answered <= '0;
      missed <= 1'b0;
      border_errors <= '0;
      marker_rotation <= '0;
      // The corners may turn before the state is READ: the first is kept here.
      cell_x <= PW'($signed({1'b0, x[0], 4'b0}));
      cell_y <= PW'($signed({1'b0, y[0], 4'b0}));
    end
    if (state == READ) begin
      cell_x <= cell_x + wide_u_x - wide_u_y;
      cell_y <= cell_y + wide_u_y + wide_u_x;
      row_x <= cell_x + wide_u_x - wide_u_y;
      row_y <= cell_y + wide_u_y + wide_u_x;
      reading <= 1'b1;
    end else if (reading) begin
      if (outside) begin
        missed <= 1'b1;
        reading <= 1'b0;
      end else if (read_ready) begin
        asked <= asked + 1'b1;
        column <= column + 1'b1;
        if (column == 3'd7) begin
          row <= row + 1'b1;
          reading <= row != 3'd7;
          cell_x <= row_x - two_u_y;
          cell_y <= row_y + two_u_x;
          row_x <= row_x - two_u_y;
          row_y <= row_y + two_u_x;
        end else begin
          cell_x <= cell_x + two_u_x;
          cell_y <= cell_y + two_u_y;
        end
      end
    end
    if (grey_valid) begin
      answered <= answered + 1'b1;
      if (in_border) border_errors <= border_errors + {4'b0, white};
      else code <= {code[34:0], white};
    end

    // The search.
    different <= entry ^ code;
    for (i = 0; i < 6; i = i + 1) row_errors[i] <= ones(different[6*i+:6]);
    errors <= code_errors;
    searching <= {searching[2:0], search_more} & {4{state == MATCH && !hit}};
    if (state != MATCH) search_at <= '0;
    else if (search_more) search_at <= search_at + 1'b1;
    if (next_rotation) begin
      search_at <= '0;
      code <= turned;
      marker_rotation <= marker_rotation + 1'b1;
    end
    if (hit) begin
      marker_id <= IW'(search_at - hit_distance);
      marker_errors <= errors[5:0];
    end

    if (reset) begin
      state <= IDLE;
      reading <= 1'b0;
      searching <= '0;
    end
  end
endmodule
