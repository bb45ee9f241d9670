// Where the cells of a square lie in the image (src/pattern/projective_grid.h is the definition), row by row from the
// ring outside on, cells counted from there. First the areas of the four triangles of neighbouring corners, twice: how
// many bits they have, then their first bits. Then for each cell its weight and its place times the weight by one
// multiplier, while two serial dividers are busy with the cell before.
module sample_places #(
    parameter XW = 10,
    parameter YW = 9,
    parameter SW = XW + 6  // signed, of a corner in sixteenths of a pixel
) (
    input  logic            clk,
    input  logic            reset,
    input  logic            start,
    input  logic [     3:0] width,
    input  logic [  XW-1:0] last_x,
    input  logic [  YW-1:0] last_row,
    input  logic [4*SW-1:0] corners_x,
    input  logic [4*SW-1:0] corners_y,
    output logic            turn,       // the corners, by one
    output logic            failed,     // not convex
    output logic            horizon,    // a cell lies beyond it: there are no more places
    output logic            held,       // a place is there
    input  logic            take,
    output logic [  XW+3:0] held_x,     // within the frame
    output logic [  YW+3:0] held_y,
    output logic [     3:0] held_column,
    output logic [     3:0] held_row,
    output logic            held_last
);
  localparam BITS = 14;           // kept of the largest area
  localparam KW = 2 * SW + 2;     // of an area
  localparam WW = BITS + 7;       // of a weight
  localparam NW = SW + BITS + 7;  // of a place times its weight
  localparam FW = WW;             // of the multiplier's first factor
  localparam GW = SW + 1;
  localparam [4:0] REST = 5'd0, CROSS_1 = 5'd1, CROSS_2 = 5'd2, CROSS_3 = 5'd3, CROSS_4 = 5'd4, CROSS_5 = 5'd5,
      CROSS_6 = 5'd6, CROSS_7 = 5'd7, AREA = 5'd8, COUNT = 5'd9, SHIFT = 5'd10, ALONG = 5'd11, DOWN = 5'd12,
      ALONG_IN = 5'd13, DOWN_IN = 5'd14, WEIGH_2 = 5'd15, WEIGH_3 = 5'd16, WEIGH_4 = 5'd17, WEIGHT = 5'd18,
      X_1 = 5'd19, X_2 = 5'd20, Y_1 = 5'd21, Y_2 = 5'd22, Y_3 = 5'd23, DIVIDE = 5'd24, NEXT = 5'd25;
  logic [4:0] state;

  logic signed [FW-1:0] f, a, b;
  logic signed [GW-1:0] g;
  logic add;
  logic signed [NW-1:0] product;
  multiply_add #(.FW(FW), .GW(GW), .PW(NW)) multiplier (.clk(clk), .f(f), .g(g), .add(add), .product(product));

  // To corner 0 from the one before, from corner 0 to the next.
  wire out = state == CROSS_5 || state == CROSS_6 || state == X_1 || state == Y_1;
  wire of_y = state == CROSS_1 || state == CROSS_6 || state == Y_1 || state == Y_2;
  wire signed [SW-1:0] x0 = $signed(corners_x[SW-1:0]);
  wire signed [SW-1:0] y0 = $signed(corners_y[SW-1:0]);
  wire signed [SW-1:0] edge_to = of_y ? (out ? $signed(corners_y[2*SW-1:SW]) : y0)
                                      : (out ? $signed(corners_x[2*SW-1:SW]) : x0);
  wire signed [SW-1:0] edge_from = of_y ? (out ? y0 : $signed(corners_y[4*SW-1:3*SW]))
                                        : (out ? x0 : $signed(corners_x[4*SW-1:3*SW]));
  wire signed [GW-1:0] side = GW'(edge_to) - GW'(edge_from);

  // The areas.
  logic shrink;  // the second time
  logic [1:0] corner;
  logic [KW-BITS-1:0] above;  // the bits that some area has too many
  logic [4:0] shifts, shifts_left;
  logic [KW-1:0] shifted;
  logic [BITS-1:0] areas[0:3];
  wire [1:0] area_at = state == ALONG ? 2'd3 : state == DOWN ? 2'd1 : 2'd2;
  wire signed [FW-1:0] area_seen = $signed({{(FW - BITS) {1'b0}}, areas[area_at]});
  always_ff @(posedge clk) if (state == SHIFT && shifts_left == '0) areas[corner] <= shifted[BITS-1:0];
  assign turn = state == AREA;

  // The cells.
  logic [3:0] column, row;
  logic beyond_horizon;
  wire [3:0] beyond = width + 1'b1;
  wire outside_both = (column == '0 || column == beyond) && (row == '0 || row == beyond);
  logic signed [5:0] half_cells;  // in half cells from corner 0: right, up, and both from the far side
  always_comb begin
    case (state)
      ALONG: half_cells = $signed({1'b0, column, 1'b0} - 6'd1);
      DOWN: half_cells = $signed(6'd1 - {1'b0, row, 1'b0});
      WEIGH_2: half_cells = 6'sd1;
      WEIGH_3: half_cells = $signed({5'({1'b0, beyond} - {1'b0, column} - {1'b0, row}), 1'b0});
      default: half_cells = -6'sd1;
    endcase
  end
  always_comb begin
    case (state)
      ALONG, DOWN, WEIGH_3: f = area_seen;
      CROSS_6, DOWN_IN, X_2, Y_2: f = b;
      default: f = a;
    endcase
    case (state)
      CROSS_5, CROSS_6, X_1, X_2, Y_1, Y_2: g = side;
      default: g = GW'(half_cells);
    endcase
    add = state == CROSS_6 || state == DOWN_IN || state == WEIGH_3 || state == X_2 || state == Y_2;
  end

  // The dividers. Rounded down: the complement of the complement divided.
  logic [WW-1:0] next_weight, weight;
  logic dividing_x, unused_dividing, x_done, divided;
  logic x_negative, y_negative;
  logic [SW:0] quotient_x, quotient_y;
  wire negative = product[NW-1];
  wire [WW+SW-1:0] dividend = (WW + SW)'(product ^ {NW{negative}});
  long_divider #(.W(WW), .QW(SW + 1)) divider_x (
      .clk(clk), .reset(reset), .start(state == Y_2), .dividend(dividend), .divisor(weight),
      .busy(dividing_x), .quotient(quotient_x));
  long_divider #(.W(WW), .QW(SW + 1)) divider_y (
      .clk(clk), .reset(reset), .start(state == DIVIDE), .dividend(dividend), .divisor(weight),
      .busy(unused_dividing), .quotient(quotient_y));

  // The places, x and then y. What is farther than any quotient shows is outside of any frame all the same.
  logic [1:0] keeping;
  wire keep_y = keeping[0];
  wire [SW:0] quotient = keep_y ? quotient_y : quotient_x;
  wire [SW-1:0] size = quotient[SW-1:0] | {SW{quotient[SW]}};
  wire signed [SW+1:0] off = $signed({2'b0, size} ^ {(SW + 2) {keep_y ? y_negative : x_negative}});
  logic signed [SW+1:0] place;
  wire [XW-1:0] last = keeping[1] ? XW'(last_row) : last_x;
  wire signed [SW+1:0] most = $signed({{(SW - XW - 2) {1'b0}}, last, 4'b0});
  wire [XW+3:0] kept = place[SW+1] ? '0 : place > most ? most[XW+3:0] : place[XW+3:0];
  logic [3:0] divided_column, divided_row;
  assign horizon = beyond_horizon && !divided && keeping == '0 && !held;
  wire ready = divided && x_done && !held && keeping == '0;  // y follows two clocks behind x

  always_ff @(posedge clk) begin
    failed <= 1'b0;
    case (state)
      REST: begin
        shrink <= 1'b0;
        corner <= '0;
        above <= '0;
        shifts <= '0;
        column <= 4'd1;
        row <= '0;
        if (start) beyond_horizon <= 1'b0;
        if (start) state <= CROSS_1;
      end
      // Corner 0 with its neighbours 3 and 1, then the next.
      CROSS_1: begin
        a <= FW'(side);
        state <= CROSS_2;
      end
      CROSS_2: state <= CROSS_3;
      CROSS_3: begin
        b <= FW'(side);
        state <= CROSS_4;
      end
      CROSS_4: begin
        a <= product[FW-1:0];
        state <= CROSS_5;
      end
      CROSS_5: state <= CROSS_6;
      CROSS_6: state <= CROSS_7;
      CROSS_7: state <= AREA;
      AREA: begin
        shifted <= product[KW-1:0];
        shifts_left <= shifts;
        if (!shrink) above <= above | product[KW-1:BITS];
        if (!shrink) corner <= corner + 1'b1;
        state <= shrink ? SHIFT : corner == 2'd3 ? COUNT : CROSS_1;
        if (product[NW-1] || product == '0) begin
          failed <= 1'b1;
          state <= REST;
        end
      end
      COUNT: begin
        above <= above >> 1;
        shrink <= 1'b1;
        if (above == '0) state <= CROSS_1;
        else shifts <= shifts + 1'b1;
      end
      SHIFT: begin
        shifted <= shifted >> 1;
        shifts_left <= shifts_left - 1'b1;
        if (shifts_left == '0) begin
          corner <= corner + 1'b1;
          state <= corner == 2'd3 ? ALONG : CROSS_1;
        end
      end

      ALONG: state <= DOWN;
      DOWN: state <= ALONG_IN;
      ALONG_IN: begin
        a <= product[FW-1:0];
        state <= WEIGH_2;
      end
      WEIGH_2: begin
        b <= product[FW-1:0];
        state <= DOWN_IN;
      end
      DOWN_IN: state <= WEIGH_3;
      WEIGH_3: state <= WEIGH_4;
      WEIGH_4: state <= WEIGHT;
      WEIGHT: begin
        next_weight <= product[WW-1:0];
        state <= X_1;
      end
      X_1: begin
        if (next_weight[WW-1] || next_weight == '0) begin
          beyond_horizon <= 1'b1;
          state <= REST;
        end else if (!divided || keeping[0]) begin
          weight <= next_weight;
          divided_column <= column;
          divided_row <= row;
          state <= X_2;
        end
      end
      X_2: state <= Y_1;
      Y_1: state <= Y_2;
      Y_2: begin
        x_negative <= negative;
        state <= Y_3;
      end
      Y_3: state <= DIVIDE;
      DIVIDE: begin
        y_negative <= negative;
        column <= column == beyond ? '0 : column + 1'b1;
        if (column == beyond) row <= row + 1'b1;
        state <= NEXT;
      end
      default: begin  // the rings have no corners
        if (outside_both) begin
          column <= column == beyond ? '0 : column + 1'b1;
          if (column == beyond) row <= row + 1'b1;
        end else begin
          state <= ALONG;
        end
        if (column == beyond && row == beyond) state <= REST;
      end
    endcase

    x_done <= !dividing_x;
    keeping <= {keeping[0], ready};
    if (state == DIVIDE) divided <= 1'b1;
    else if (keeping[0]) divided <= 1'b0;
    if (ready || keeping[0]) place <= (keep_y ? (SW + 2)'(y0) : (SW + 2)'(x0)) + off;
    if (keeping[0]) begin
      held_x <= kept;
      held_column <= divided_column;
      held_row <= divided_row;
      held_last <= divided_column == width && divided_row == beyond;  // the corner after it is none
    end
    if (keeping[1]) held_y <= kept[YW+3:0];
    if (keeping[1]) held <= 1'b1;
    else if (take) held <= 1'b0;
    if (reset) begin
      state <= REST;
      divided <= 1'b0;
      keeping <= '0;
      held <= 1'b0;
    end
  end
  wire unused = &{1'b0, corners_x[3*SW-1:2*SW], corners_y[3*SW-1:2*SW], unused_dividing};
endmodule
