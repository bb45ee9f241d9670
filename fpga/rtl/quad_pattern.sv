// The pattern core of the hardware profile (src/pattern/integer_reader.h is its definition): the cells of a square
// marker placed from all four corners of a quad, the light from its border and the ring outside, a check of the
// border, and a search for the cells in a dictionary at four rotations.
//
// One half of it places the samples, a row of cells after the other from the ring outside on, with two serial
// dividers; the other reads four pixels for each and weighs them. Then the cells are gone through twice: their distance
// from the half-way level, and their colours after what blur took has been given back.
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
  localparam FW = 25;            // of a multiplier's factors
  localparam GW = SW + 2;
  localparam PW = FW + GW;
  localparam KW = 2 * SW + 2;    // of twice a triangle's area
  localparam BITS = 14;          // kept of the largest of them
  localparam NW = SW + BITS + 7;  // of a sample's place times its weight
  localparam AW = SW + BITS + 2;  // of a corner's place times its weight
  localparam WW = BITS + 7;      // of a weight

  localparam [4:0] IDLE = 5'd0, CROSS = 5'd1, SHRINK = 5'd2, ALONG = 5'd3, DOWN = 5'd4, ALONG_IN = 5'd5, DOWN_IN = 5'd6,
      FIRST_IN = 5'd7, BEGIN = 5'd8, SAMPLE = 5'd9, LIGHT_1 = 5'd10, LIGHT_2 = 5'd11, LIGHT_3 = 5'd12, LIGHT_4 = 5'd13,
      LEVEL_1 = 5'd14, LEVEL_2 = 5'd15, LEVEL_3 = 5'd16, LEVEL_4 = 5'd17, SHARP = 5'd18, SHARPENED = 5'd19,
      MARGIN_1 = 5'd20, MARGIN_2 = 5'd21, MARGIN_3 = 5'd22, MARGIN_4 = 5'd23, MARGIN_5 = 5'd24, PACK = 5'd25,
      MATCH = 5'd26, EMIT = 5'd27;
  logic [4:0] state;
  logic [2:0] count;
  assign quad_ready = state == IDLE;
  assign marker_valid = state == EMIT;

  // Constants that follow from the width (src/pattern/integer_light.cpp).
  logic [11:0] share_black, share_white;  // one over twice the cells of a ring, in 1/2^16
  logic [14:0] share_moment;              // one over the sum of squared distances, in 1/2^24
  logic [6:0] cells_inside;
  logic [1:0] most_white;                 // cells of the border
  always_comb begin
    case (width)
      4'd6: {share_black, share_white, share_moment, cells_inside, most_white} = {12'd1638, 12'd1365, 15'd15709, 7'd16, 2'd2};
      4'd7: {share_black, share_white, share_moment, cells_inside, most_white} = {12'd1365, 12'd1170, 15'd9846, 7'd25, 2'd2};
      4'd8: {share_black, share_white, share_moment, cells_inside, most_white} = {12'd1170, 12'd1024, 15'd6564, 7'd36, 2'd3};
      4'd9: {share_black, share_white, share_moment, cells_inside, most_white} = {12'd1024, 12'd910, 15'd4589, 7'd49, 2'd3};
      default: {share_black, share_white, share_moment, cells_inside, most_white} = {12'd910, 12'd819, 15'd3331, 7'd64, 2'd3};
    endcase
  end
  wire [3:0] last_cell = width - 1'b1;

  // The multipliers: factors, a clock later products.
  logic signed [FW-1:0] f1, f2;
  logic signed [GW-1:0] g1, g2;
  logic signed [PW-1:0] p1, p2;
  always_ff @(posedge clk) begin
    p1 <= f1 * g1;
    p2 <= f2 * g2;
  end
  wire signed [29:0] p_sum = p1[29:0] + p2[29:0];  // no use is longer
  wire signed [2*SW+4:0] p_difference = p1[2*SW+4:0] - p2[2*SW+4:0];

  // The corners; they turn while the triangles' areas are taken and with the code.
  logic signed [SW-1:0] x[0:3];
  logic signed [SW-1:0] y[0:3];
  logic turn;
  assign marker_x = {x[3], x[2], x[1], x[0]};
  assign marker_y = {y[3], y[2], y[1], y[0]};
  function automatic signed [GW-1:0] minus(input signed [SW-1:0] p, input signed [SW-1:0] q);
    minus = GW'(p) - GW'(q);
  endfunction

  // To corner 0 from the one before, from corner 0 to the next.
  wire signed [GW-1:0] x_in = minus(x[0], x[3]);
  wire signed [GW-1:0] y_in = minus(y[0], y[3]);
  wire signed [GW-1:0] x_out = minus(x[1], x[0]);
  wire signed [GW-1:0] y_out = minus(y[1], y[0]);

  // The projective map.
  logic [KW-1:0] k[0:3];
  wire k_large = (|k[0][KW-1:BITS]) || (|k[1][KW-1:BITS]) || (|k[2][KW-1:BITS]) || (|k[3][KW-1:BITS]);
  logic signed [BITS:0] w_along, w_down;
  logic signed [AW-1:0] x_along, x_up, y_along, y_up;
  logic signed [WW-1:0] w_row, w_here;
  logic signed [NW-1:0] x_row, x_here, y_row, y_here;
  wire signed [WW-1:0] w_next_row = w_row + (WW'(w_down) <<< 1);
  wire signed [NW-1:0] x_next_row = x_row - (NW'(x_up) <<< 1);
  wire signed [NW-1:0] y_next_row = y_row - (NW'(y_up) <<< 1);
  logic [YW-1:0] last_row;
  wire [YW:0] rows_in = {1'b0, marker_bottom} + (YW + 1)'(4);

  // The half that places: cells are counted from the ring outside, so that 0 is column -1.
  localparam [2:0] REST = 3'd0, START = 3'd1, DIVIDE = 3'd2, ADD = 3'd3, KEEP = 3'd4, HELD = 3'd5;
  logic [2:0] placing;
  logic [3:0] column, row;
  wire [3:0] beyond = width + 1'b1;
  wire outside_column = column == '0 || column == beyond;
  wire outside_row = row == '0 || row == beyond;
  wire last_column = column == beyond;
  wire last_place = last_column && row == beyond;
  logic horizon;  // a sample lies beyond it
  logic divide, dividing, unused_dividing;
  logic [SW:0] quotient_x, quotient_y;
  // Rounded down: the complement of the complement divided.
  wire x_negative = x_here[NW-1];
  wire y_negative = y_here[NW-1];
  wire [NW-1:0] dividend_x = x_here ^ {NW{x_negative}};
  wire [NW-1:0] dividend_y = y_here ^ {NW{y_negative}};
  long_divider #(.W(WW), .QW(SW + 1)) divider_x (
      .clk(clk), .reset(reset), .start(divide), .dividend((WW + SW)'(dividend_x)), .divisor(w_here),
      .busy(dividing), .quotient(quotient_x));
  long_divider #(.W(WW), .QW(SW + 1)) divider_y (
      .clk(clk), .reset(reset), .start(divide), .dividend((WW + SW)'(dividend_y)), .divisor(w_here),
      .busy(unused_dividing), .quotient(quotient_y));
  // What is farther than any quotient shows is outside of any frame all the same.
  wire [SW-1:0] x_size = quotient_x[SW] ? '1 : quotient_x[SW-1:0];
  wire [SW-1:0] y_size = quotient_y[SW] ? '1 : quotient_y[SW-1:0];
  wire signed [SW+1:0] x_off = $signed({2'b0, x_size} ^ {(SW + 2) {x_negative}});
  wire signed [SW+1:0] y_off = $signed({2'b0, y_size} ^ {(SW + 2) {y_negative}});
  logic signed [SW+1:0] place_x, place_y;
  wire signed [SW+1:0] most_x = $signed({{(SW - XW - 2) {1'b0}}, last_x, 4'b0});
  wire signed [SW+1:0] most_y = $signed({{(SW - YW - 2) {1'b0}}, last_row, 4'b0});
  logic [XW+3:0] held_x;
  logic [YW+3:0] held_y;
  logic [3:0] held_column, held_row;
  logic held_last;

  // The half that reads.
  logic reading, weighing;
  logic [1:0] asked;
  logic [2:0] answered;
  logic [XW+3:0] sample_x;
  logic [YW+3:0] sample_y;
  logic [3:0] sample_column, sample_row;
  logic sample_last;
  wire take = placing == HELD && !reading && !weighing;
  wire [XW-1:0] pixel_x = sample_x[XW+3:4];
  wire [YW-1:0] pixel_y = sample_y[YW+3:4];
  assign read_valid = reading;
  assign read_x = asked[0] && pixel_x != last_x ? pixel_x + 1'b1 : pixel_x;
  assign read_y = asked[1] && pixel_y != last_row ? pixel_y + 1'b1 : pixel_y;
  wire [4:0] share_x = answered[0] ? {1'b0, sample_x[3:0]} : 5'd16 - {1'b0, sample_x[3:0]};
  wire [4:0] share_y = answered[1] ? {1'b0, sample_y[3:0]} : 5'd16 - {1'b0, sample_y[3:0]};
  logic [8:0] pixel_share;
  logic [7:0] pixel_grey;
  logic [16:0] pixel_part;
  logic part_1, part_2;
  logic [16:0] total;  // in 1/256
  logic [2:0] settle;
  wire [11:0] level_seen = total[15:4];
  wire [11:0] fine_grey = marker_hole ? 12'd4080 - level_seen : level_seen;
  logic sampled;  // one more is complete
  logic [11:0] sample_grey;
  wire sample_outside = sample_column == '0 || sample_column == beyond || sample_row == '0 || sample_row == beyond;
  wire sample_edge = sample_column == 4'd1 || sample_column == width || sample_row == 4'd1 || sample_row == width;
  logic moment_1, moment_2, last_1, last_2;

  // The light.
  logic [17:0] white_sum, black_sum;
  logic signed [FW-1:0] moment_x, moment_y;
  logic signed [13:0] level;
  logic signed [13:0] contrast;
  logic signed [FW-1:0] across, down;

  // The cells, row by row: grey levels, then distances from half-way.
  logic signed [15:0] cells[0:127];
  logic [6:0] cell_at, cell_read;
  logic cell_write;
  logic [6:0] cell_write_at;
  logic signed [15:0] cell_new;
  wire signed [15:0] cell_seen = cells[cell_read];
  always_ff @(posedge clk) if (cell_write) cells[cell_write_at] <= cell_new;
  wire cell_border = column == '0 || row == '0 || column == last_cell || row == last_cell;
  function automatic signed [GW-1:0] centred(input [3:0] cell_number, input [3:0] cells_across);
    centred = $signed({{(GW - 5) {1'b0}}, cell_number, 1'b1}) - $signed({{(GW - 4) {1'b0}}, cells_across});
  endfunction
  logic [3:0] white_border;
  logic signed [19:0] sharp;
  logic [19:0] sharp_size;
  wire signed [19:0] wide_cell = 20'(cell_seen);
  wire [3:0] last_inside = width - 4'd2;
  logic grid[0:63];  // colours of the inner cells, eight a row
  logic white_cell;
  always_comb begin
    case (count)
      3'd2: cell_read = cell_at - 1'b1;
      3'd3: cell_read = cell_at + 1'b1;
      3'd4: cell_read = cell_at - {3'b0, width};
      3'd5: cell_read = cell_at + {3'b0, width};
      default: cell_read = cell_at;
    endcase
  end

  // The search.
  wire [2:0] last_bit = width[2:0] - 3'd3;  // 4 to 8 cells a side
  wire [2:0] pack_row = row[2:0];
  wire [2:0] pack_column = column[2:0];
  logic [5:0] pack_from;
  always_comb begin
    case (marker_rotation)
      2'd0: pack_from = {pack_row, pack_column};
      2'd1: pack_from = {pack_column, last_bit - pack_row};
      2'd2: pack_from = {last_bit - pack_row, last_bit - pack_column};
      default: pack_from = {last_bit - pack_column, pack_row};
    endcase
  end
  logic [63:0] dictionary[0:CODES-1];
  logic [63:0] code, entry, different;
  logic [IW:0] search_at, checked;
  logic [3:0] searching;  // the codes on their way
  logic [3:0] part_errors[0:7];
  logic [6:0] errors;
  wire search_more = state == MATCH && search_at != codes;
  wire hit = state == MATCH && searching[3] && errors <= {1'b0, max_errors};
  wire search_over = state == MATCH && !search_more && searching == '0;
  function automatic [3:0] ones(input [7:0] b);
    ones = {3'b0, b[0]} + {3'b0, b[1]} + {3'b0, b[2]} + {3'b0, b[3]}
         + {3'b0, b[4]} + {3'b0, b[5]} + {3'b0, b[6]} + {3'b0, b[7]};
  endfunction
  logic [6:0] all_errors;
  always_comb begin
    all_errors = '0;
    for (int i = 0; i < 8; i++) all_errors = all_errors + {3'b0, part_errors[i]};
  end
  always_ff @(posedge clk) begin
    if (write) dictionary[write_at] <= write_code;
    entry <= dictionary[search_at[IW-1:0]];
  end
  wire next_rotation = search_over && marker_rotation != 2'd3;
  assign turn = (state == CROSS && !count[2]) || next_rotation;

  integer i;
  always_ff @(posedge clk) begin
    if (state == IDLE) begin
      for (i = 0; i < 4; i = i + 1) begin
        x[i] <= quad_x[SW*i+:SW];
        y[i] <= quad_y[SW*i+:SW];
      end
    end else if (turn) begin
      for (i = 0; i < 4; i = i + 1) begin
        x[i] <= x[(i+1)%4];
        y[i] <= y[(i+1)%4];
      end
    end

    cell_write <= 1'b0;
    case (state)
      IDLE: begin
        marker_bottom <= quad_bottom;
        marker_hole <= quad_hole;
        marker_end <= quad_end;
        marker_rotation <= '0;
        count <= '0;
        if (quad_valid) state <= quad_end ? EMIT : CROSS;
      end

      CROSS: begin  // corner 0 with its neighbours 3 and 1, then the next
        f1 <= FW'(x_in);
        g1 <= y_out;
        f2 <= FW'(y_in);
        g2 <= x_out;
        if (count >= 3'd2) begin
          k[3] <= p_difference[KW-1:0];
          for (i = 0; i < 3; i = i + 1) k[i] <= k[i+1];
        end
        count <= count + 1'b1;
        last_row <= rows_in > {1'b0, last_y} ? last_y : rows_in[YW-1:0];
        if (count >= 3'd2 && (p_difference[2*SW+4] || p_difference == '0)) state <= IDLE;
        else if (count == 3'd5) state <= SHRINK;
      end
      SHRINK: begin
        if (k_large) for (i = 0; i < 4; i = i + 1) k[i] <= k[i] >> 1;
        else state <= ALONG;
      end
      ALONG: begin  // the first sample lies half a cell up and left of corner 0
        w_along <= (BITS + 1)'(k[3]) - (BITS + 1)'(k[2]);
        w_down <= (BITS + 1)'(k[1]) - (BITS + 1)'(k[2]);
        f1 <= FW'($signed({1'b0, k[1][BITS-1:0]}));
        g1 <= x_in;
        f2 <= FW'($signed({1'b0, k[3][BITS-1:0]}));
        g2 <= x_out;
        state <= DOWN;
      end
      DOWN: begin
        g1 <= y_in;
        g2 <= y_out;
        state <= ALONG_IN;
      end
      ALONG_IN: begin
        x_up <= AW'(p1);
        x_along <= AW'(p2);
        x_row <= NW'(p_difference);
        f1 <= FW'($signed({1'b0, k[2][BITS-1:0]}));
        g1 <= $signed({{(GW - 5) {1'b0}}, beyond, 1'b0});
        state <= DOWN_IN;
      end
      DOWN_IN: begin
        y_up <= AW'(p1);
        y_along <= AW'(p2);
        y_row <= NW'(p_difference);
        w_row <= WW'(0) - WW'($signed({1'b0, k[1][BITS-1:0]})) - WW'($signed({1'b0, k[3][BITS-1:0]}));
        state <= FIRST_IN;
      end
      FIRST_IN: begin
        w_row <= w_row + WW'(p1);
        state <= BEGIN;
      end
      BEGIN: begin
        white_sum <= '0;
        black_sum <= '0;
        moment_x <= '0;
        moment_y <= '0;
        cell_at <= '0;
        count <= '0;
        state <= SAMPLE;
      end
      SAMPLE: begin
        if (sampled) begin
          if (sample_outside) white_sum <= white_sum + {6'b0, sample_grey};
          else begin
            if (sample_edge) black_sum <= black_sum + {6'b0, sample_grey};
            cell_write <= 1'b1;
            cell_write_at <= cell_at;
            cell_new <= {4'b0, sample_grey};
            cell_at <= cell_at + 1'b1;
          end
          f1 <= FW'($signed({1'b0, sample_grey}));
          g1 <= centred(sample_column, width + 4'd2);
          f2 <= FW'($signed({1'b0, sample_grey}));
          g2 <= centred(sample_row, width + 4'd2);
        end
        if (moment_2) begin
          moment_x <= moment_x + FW'(p1);
          moment_y <= moment_y + FW'(p2);
        end
        if (horizon) begin
          if (!reading && !weighing) state <= IDLE;
        end else if (last_2) state <= LIGHT_1;
      end

      LIGHT_1: begin
        f1 <= FW'($signed({1'b0, white_sum}));
        g1 <= $signed({{(GW - 12) {1'b0}}, share_white});
        f2 <= FW'($signed({1'b0, black_sum}));
        g2 <= $signed({{(GW - 12) {1'b0}}, share_black});
        state <= LIGHT_2;
      end
      LIGHT_2: begin
        f1 <= moment_x;
        g1 <= $signed({{(GW - 15) {1'b0}}, share_moment});
        f2 <= moment_y;
        g2 <= $signed({{(GW - 15) {1'b0}}, share_moment});
        state <= LIGHT_3;
      end
      LIGHT_3: begin
        level <= p_sum[29:16];
        contrast <= p_difference[28:15];
        state <= LIGHT_4;
      end
      LIGHT_4: begin
        across <= FW'($signed(p1[PW-1:16]));
        down <= FW'($signed(p2[PW-1:16]));
        column <= '0;
        row <= '0;
        cell_at <= '0;
        white_border <= '0;
        state <= contrast < 14'sd128 ? IDLE : LEVEL_1;
      end

      LEVEL_1: begin
        f1 <= across;
        g1 <= centred(column, width);
        f2 <= down;
        g2 <= centred(row, width);
        state <= LEVEL_2;
      end
      LEVEL_2: state <= LEVEL_3;
      LEVEL_3: begin
        cell_write <= 1'b1;
        cell_write_at <= cell_at;
        cell_new <= cell_seen - 16'(level) - $signed(p_sum[23:8]);
        state <= LEVEL_4;
      end
      LEVEL_4: begin
        if (cell_border && !cell_new[15] && white_border != '1) white_border <= white_border + 1'b1;
        column <= column == last_cell ? '0 : column + 1'b1;
        if (column == last_cell) row <= row + 1'b1;
        cell_at <= cell_at + 1'b1;
        state <= LEVEL_1;
        if (column == last_cell && row == last_cell) begin
          column <= 4'd1;
          row <= 4'd1;
          cell_at <= {3'b0, width} + 7'd1;
          count <= '0;
          marker_clearance <= '0;
          state <= SHARP;
        end
      end

      SHARP: begin
        sharp <= count == '0 ? wide_cell <<< 1 : count == 3'd1 ? sharp + (wide_cell <<< 2) : sharp - wide_cell;
        count <= count + 1'b1;
        if (count == 3'd5) state <= SHARPENED;
        if (white_border > {2'b0, most_white}) state <= IDLE;
      end
      SHARPENED: begin
        count <= count + 1'b1;
        if (count == 3'd6) begin
          white_cell <= !sharp[19] && sharp != '0;
          sharp_size <= sharp ^ {20{sharp[19]}};
        end else begin
          grid[{3'(row - 4'd1), 3'(column - 4'd1)}] <= white_cell;
          marker_clearance <= marker_clearance + (sharp_size < 20'(contrast) ? sharp_size : 20'(contrast));
          count <= '0;
          column <= column == last_inside ? 4'd1 : column + 1'b1;
          cell_at <= column == last_inside ? cell_at + 7'd3 : cell_at + 7'd1;
          if (column == last_inside) row <= row + 1'b1;
          state <= column == last_inside && row == last_inside ? MARGIN_1 : SHARP;
        end
      end

      MARGIN_1: begin
        f1 <= FW'(contrast);
        g1 <= $signed({{(GW - 8) {1'b0}}, cells_inside, 1'b0});
        state <= MARGIN_2;
      end
      MARGIN_2: state <= MARGIN_3;
      MARGIN_3: begin
        marker_scale <= p1[19:0];
        f1 <= FW'($signed({1'b0, p1[19:0]}));
        g1 <= $signed({{(GW - 8) {1'b0}}, min_margin});
        state <= MARGIN_4;
      end
      MARGIN_4: state <= MARGIN_5;
      MARGIN_5: begin
        column <= '0;
        row <= '0;
        state <= {marker_clearance, 8'b0} < p1[27:0] ? IDLE : PACK;
      end

      PACK: begin
        code <= {code[62:0], grid[pack_from]};
        column <= pack_column == last_bit ? '0 : column + 1'b1;
        if (pack_column == last_bit) row <= row + 1'b1;
        if (pack_column == last_bit && pack_row == last_bit) state <= MATCH;
      end
      MATCH: begin
        column <= '0;
        row <= '0;
        if (hit) state <= EMIT;
        else if (next_rotation) state <= PACK;
        else if (search_over) state <= IDLE;
      end
      default: if (marker_ready) state <= IDLE;
    endcase
    if (state == MARGIN_5 || next_rotation) code <= '0;
    if (next_rotation) marker_rotation <= marker_rotation + 1'b1;

    // The half that places.
    divide <= 1'b0;
    case (placing)
      REST: if (state == BEGIN) begin
        column <= '0;
        row <= '0;
        horizon <= 1'b0;
        {w_here, x_here, y_here} <= {w_row, x_row, y_row};
        placing <= START;
      end
      START: begin
        if (outside_column && outside_row) begin  // the rings have no corners
          placing <= KEEP;
        end else if (w_here[WW-1] || w_here == '0) begin
          horizon <= 1'b1;
          placing <= REST;
        end else begin
          divide <= 1'b1;
          placing <= DIVIDE;
        end
      end
      DIVIDE: if (!divide && !dividing) begin
        place_x <= (SW + 2)'(x[0]) + x_off;
        place_y <= (SW + 2)'(y[0]) + y_off;
        placing <= ADD;
      end
      ADD: begin
        held_x <= place_x[SW+1] ? '0 : place_x > most_x ? most_x[XW+3:0] : place_x[XW+3:0];
        held_y <= place_y[SW+1] ? '0 : place_y > most_y ? most_y[YW+3:0] : place_y[YW+3:0];
        held_column <= column;
        held_row <= row;
        held_last <= column == width && row == beyond;  // the corner after it is none
        placing <= HELD;
      end
      HELD: if (take) placing <= KEEP;
      default: begin  // on to the next
        if (last_place) begin
          placing <= REST;
        end else begin
          placing <= START;
          if (last_column) begin
            column <= '0;
            row <= row + 1'b1;
            {w_row, w_here} <= {2{w_next_row}};
            {x_row, x_here} <= {2{x_next_row}};
            {y_row, y_here} <= {2{y_next_row}};
          end else begin
            column <= column + 1'b1;
            w_here <= w_here + (WW'(w_along) <<< 1);
            x_here <= x_here + (NW'(x_along) <<< 1);
            y_here <= y_here + (NW'(y_along) <<< 1);
          end
        end
      end
    endcase

    // The half that reads.
    if (take) begin
      sample_x <= held_x;
      sample_y <= held_y;
      sample_column <= held_column;
      sample_row <= held_row;
      sample_last <= held_last;
      reading <= 1'b1;
      weighing <= 1'b1;
      asked <= '0;
      answered <= '0;
      total <= '0;
    end else begin
      if (reading && read_ready) begin
        asked <= asked + 1'b1;
        if (asked == 2'd3) reading <= 1'b0;
      end
      if (grey_valid) answered <= answered + 1'b1;
      if (part_2) total <= total + pixel_part;
    end
    pixel_share <= share_x * share_y;
    pixel_grey <= grey;
    part_1 <= grey_valid;
    pixel_part <= pixel_share * pixel_grey;
    part_2 <= part_1;
    settle <= {settle[1:0], weighing && answered == 3'd4 && !take};
    sampled <= weighing && settle[2] && !sampled;
    if (weighing && settle[2] && !sampled) sample_grey <= fine_grey;
    if (sampled) weighing <= 1'b0;
    if (!weighing) settle <= '0;
    moment_1 <= sampled && (sample_outside || sample_edge);
    moment_2 <= moment_1;
    last_1 <= sampled && sample_last;
    last_2 <= last_1;

    // The search.
    different <= entry ^ code;
    for (i = 0; i < 8; i = i + 1) part_errors[i] <= ones(different[8*i+:8]);
    errors <= all_errors;
    searching <= {searching[2:0], search_more} & {4{state == MATCH && !hit}};
    if (state != MATCH || next_rotation) begin
      search_at <= '0;
      checked <= '0;
    end else begin
      if (search_more) search_at <= search_at + 1'b1;
      if (searching[3]) checked <= checked + 1'b1;
    end
    if (hit) begin
      marker_id <= checked[IW-1:0];
      marker_errors <= errors[5:0];
    end

    if (reset) begin
      state <= IDLE;
      placing <= REST;
      reading <= 1'b0;
      weighing <= 1'b0;
      sampled <= 1'b0;
      settle <= '0;
      part_1 <= 1'b0;
      part_2 <= 1'b0;
      searching <= '0;
    end
  end

  wire unused = &{1'b0, unused_dividing, p_sum[7:0]};
endmodule
