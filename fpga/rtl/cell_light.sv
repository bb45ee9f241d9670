// The light on a marker and the colours of its cells (src/pattern/integer_light.h and `read_cells` in
// src/pattern/integer_reader.h are the definition). Samples come in row by row from the ring outside on; when the last
// is in, the cells are gone through twice: their distance from the half-way level, and their colours after what blur
// took has been given back. One multiplier does all of it, a product a clock.
module cell_light (
    input  logic        clk,
    input  logic        reset,
    input  logic        clear,
    input  logic [ 3:0] width,          // cells along a side, border included: 6 to 10
    input  logic [ 7:0] min_margin,     // in 1/256 of the contrast

    input  logic        sampled,        // at most one in eight clocks
    input  logic [11:0] sample_grey,
    input  logic [ 3:0] sample_column,  // from the ring outside on
    input  logic [ 3:0] sample_row,
    input  logic        sample_last,

    output logic        cell_write,     // the colour of an inner cell
    output logic [ 2:0] cell_row,
    output logic [ 2:0] cell_column,
    output logic        cell_white,
    output logic        done,
    output logic        failed,
    output logic [19:0] clearance,
    output logic [19:0] scale
);
  localparam [4:0] SAMPLES = 5'd0, MOMENT_1 = 5'd1, MOMENT_2 = 5'd2, WHITE = 5'd3, BLACK = 5'd4, WHITE_2 = 5'd5,
      BLACK_2 = 5'd6, ACROSS = 5'd7, DOWN = 5'd8, ACROSS_IN = 5'd9, DOWN_IN = 5'd10, LEVEL_1 = 5'd11,
      LEVEL_2 = 5'd12, LEVEL_3 = 5'd13, LEVEL_4 = 5'd14, LEVEL_5 = 5'd15, SHARP = 5'd16, SHARP_IN = 5'd17,
      SHARPENED = 5'd18, SCALE_1 = 5'd19, SCALE_2 = 5'd20, SCALE_3 = 5'd21, MARGIN_1 = 5'd22, MARGIN_2 = 5'd23,
      MARGIN_3 = 5'd24, MARGIN_4 = 5'd25;
  logic [4:0] state;

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

  localparam FW = 25;
  localparam GW = 16;
  logic signed [FW-1:0] f;
  logic signed [GW-1:0] g;
  logic add;
  logic signed [FW+GW-1:0] product;
  multiply_add #(.FW(FW), .GW(GW)) multiplier (.clk(clk), .f(f), .g(g), .add(add), .product(product));

  // Sums over the two rings, and moments, of which the plane follows: the one in hand and the other one.
  wire [3:0] beyond = width + 1'b1;
  wire outside = sample_column == '0 || sample_column == beyond || sample_row == '0 || sample_row == beyond;
  wire edging = sample_column == 4'd1 || sample_column == width || sample_row == 4'd1 || sample_row == width;
  logic [17:0] white_sum, black_sum;
  wire [17:0] ring_sum = (outside ? white_sum : black_sum) + {6'b0, sample_grey};
  logic signed [FW-1:0] plane, other_plane;
  logic signed [13:0] level, contrast;
  logic last;
  logic [2:0] adding;  // when the products of a sample are there

  // The cells, row by row: grey levels, then distances from half-way.
  logic signed [15:0] cells[0:127];
  logic [6:0] at, read_at;
  logic write;
  logic [6:0] write_at;
  logic signed [15:0] written;
  wire signed [15:0] seen = cells[read_at];
  always_ff @(posedge clk) if (write) cells[write_at] <= written;
  logic [3:0] column, row;
  wire [3:0] last_cell = width - 1'b1;
  wire [3:0] last_inside = width - 4'd2;
  wire border = column == '0 || row == '0 || column == last_cell || row == last_cell;
  logic leveled, leveled_border, written_border;
  logic signed [15:0] kept;
  logic [6:0] kept_at;
  logic [3:0] white_border;
  logic [2:0] count;
  logic [6:0] beside;  // what is read next, from the cell
  always_comb begin
    case (count)
      3'd0: beside = 7'h7f;
      3'd1: beside = 7'd1;
      3'd2: beside = -{3'b0, width};
      default: beside = {3'b0, width};
    endcase
  end
  logic sized;
  logic [19:0] size;
  wire [19:0] wide_contrast = 20'(contrast);
  assign cell_column = 3'(column - 4'd1);
  assign cell_row = 3'(row - 4'd1);
  assign cell_write = state == SHARPENED;
  assign cell_white = !product[19] && product[19:0] != '0;

  // From the middle of the marker, in half cells: of a sample or of a cell.
  wire of_sample = state == SAMPLES || state == MOMENT_1;
  wire down = state == MOMENT_1 || state == LEVEL_3;
  wire [3:0] centred_cell = of_sample ? (down ? sample_row : sample_column) : (down ? row : column);
  wire signed [5:0] centred = $signed({1'b0, centred_cell, 1'b1} - {2'b0, width + {2'b0, of_sample, 1'b0}});

  always_comb begin
    add = 1'b0;
    case (state)
      WHITE, WHITE_2: {f, g} = {FW'({1'b0, white_sum}), GW'({1'b0, share_white})};
      BLACK: {f, g} = {FW'({1'b0, black_sum}), GW'({1'b0, share_black})};
      BLACK_2: {f, g} = {FW'({1'b0, black_sum}), -(GW'({1'b0, share_black}))};
      ACROSS, DOWN: {f, g} = {plane, GW'({1'b0, share_moment})};
      LEVEL_1: {f, g} = {FW'(level), GW'(256)};
      LEVEL_2, LEVEL_3: {f, g} = {plane, GW'(centred)};
      SHARP: {f, g} = {FW'(seen), count == '0 ? GW'(6) : GW'(-1)};
      SCALE_1: {f, g} = {FW'(contrast), GW'({1'b0, cells_inside, 1'b0})};
      MARGIN_1: {f, g} = {FW'({1'b0, scale}), GW'({1'b0, min_margin})};
      MARGIN_2: {f, g} = {FW'({1'b0, clearance}), GW'(-256)};
      default: {f, g} = {FW'({1'b0, sample_grey}), GW'(centred)};
    endcase
    if (state == BLACK || state == BLACK_2 || state == LEVEL_2 || state == LEVEL_3 || state == MARGIN_2
        || (state == SHARP && count != '0)) add = 1'b1;
  end

  always_ff @(posedge clk) begin
    write <= 1'b0;
    done <= 1'b0;
    failed <= 1'b0;
    adding <= {adding[1:0], 1'b0};
    count <= '0;
    read_at <= state == SHARP ? at + beside : at;
    leveled <= 1'b0;
    sized <= 1'b0;
    if (sized) clearance <= clearance + (size < wide_contrast ? size : wide_contrast);
    written_border <= leveled && leveled_border;
    if (written_border && !written[15] && white_border != '1) white_border <= white_border + 1'b1;
    case (state)
      SAMPLES: begin
        if (sampled) begin
          if (outside) white_sum <= ring_sum;
          else begin
            if (edging) black_sum <= ring_sum;
            write <= 1'b1;
            at <= at + 1'b1;
          end
          write_at <= at;
          written <= {4'b0, sample_grey};
          adding[0] <= outside || edging;
          last <= sample_last;
          state <= MOMENT_1;
        end
      end
      MOMENT_1: state <= MOMENT_2;
      MOMENT_2: state <= last ? WHITE : SAMPLES;

      WHITE: state <= BLACK;
      BLACK: state <= WHITE_2;
      WHITE_2: state <= BLACK_2;
      BLACK_2: begin
        level <= 14'(product >>> 16);
        state <= ACROSS;
      end
      ACROSS: state <= DOWN;
      DOWN: begin
        contrast <= 14'(product >>> 15);
        state <= ACROSS_IN;
      end
      ACROSS_IN: begin
        failed <= contrast < 14'sd128;
        state <= contrast < 14'sd128 ? SAMPLES : DOWN_IN;
      end
      DOWN_IN: begin
        column <= '0;
        row <= '0;
        at <= '0;
        white_border <= '0;
        state <= LEVEL_1;
      end

      LEVEL_1: state <= LEVEL_2;
      LEVEL_2: state <= LEVEL_3;
      LEVEL_3: state <= LEVEL_4;
      LEVEL_4: begin  // the product comes with the next cell
        leveled <= 1'b1;
        leveled_border <= border;
        column <= column == last_cell ? '0 : column + 1'b1;
        if (column == last_cell) row <= row + 1'b1;
        at <= column == last_cell && row == last_cell ? {3'b0, width} + 7'd1 : at + 1'b1;
        kept <= seen;
        kept_at <= at;
        state <= column == last_cell && row == last_cell ? LEVEL_5 : LEVEL_1;
      end
      LEVEL_5: begin
        column <= 4'd1;
        row <= 4'd1;
        clearance <= '0;
        state <= SHARP;
      end

      SHARP: begin
        count <= count + 1'b1;
        if (count == 3'd4) state <= SHARP_IN;
        if (white_border > {2'b0, most_white}) begin
          failed <= 1'b1;
          state <= SAMPLES;
        end
      end
      SHARP_IN: begin
        at <= column == last_inside ? at + 7'd3 : at + 7'd1;
        state <= SHARPENED;
      end
      SHARPENED: begin
        size <= product[19:0] ^ {20{product[19]}};
        sized <= 1'b1;
        column <= column == last_inside ? 4'd1 : column + 1'b1;
        if (column == last_inside) row <= row + 1'b1;
        state <= column == last_inside && row == last_inside ? SCALE_1 : SHARP;
      end

      SCALE_1: state <= SCALE_2;
      SCALE_2: state <= SCALE_3;
      SCALE_3: begin
        scale <= product[19:0];
        state <= MARGIN_1;
      end
      MARGIN_1: state <= MARGIN_2;
      MARGIN_2: state <= MARGIN_3;
      MARGIN_3: state <= MARGIN_4;
      default: begin  // positive when there is less than the least margin
        done <= product[29] || product[29:0] == '0;
        failed <= !product[29] && product[29:0] != '0;
        state <= SAMPLES;
      end
    endcase

    if (leveled) begin
      write <= 1'b1;
      write_at <= kept_at;
      written <= kept - $signed(product[23:8]);
    end
    // The moments take turns; so does the plane.
    if (adding[1] || adding[2]) {plane, other_plane} <= {other_plane, plane + FW'(product)};
    if (state == ACROSS_IN || state == DOWN_IN) {plane, other_plane} <= {other_plane, FW'(product >>> 16)};
    if (state == ACROSS || state == DOWN || state == LEVEL_2 || state == LEVEL_3)
      {plane, other_plane} <= {other_plane, plane};
    if (clear) begin
      at <= '0;
      white_sum <= '0;
      black_sum <= '0;
      plane <= '0;
      other_plane <= '0;
    end
    if (clear || reset) adding <= '0;
    if (clear || reset) state <= SAMPLES;
  end
endmodule
