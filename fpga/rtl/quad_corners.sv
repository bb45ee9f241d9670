// The rough corners of a quadrilateral: four of a chain's extreme vertices that span a wide one, in the order of the
// chain. Then whether its sides are long enough and its area that of the chain. A corner is kept as the number of its
// extreme vertex; `from` and `to` are those of the side in hand.
module quad_corners #(
    parameter XW = 10,
    parameter YW = 9,
    parameter NW = 11,
    parameter AW = XW + YW + 1,
    parameter CW = XW + 1,
    parameter MW = 22,
    parameter VW = 2 * CW + 2  // of an area in a scan
) (
    input  logic                 clk,
    input  logic                 reset,
    input  logic                 run,          // of cracks, while not busy: the chain's in their order
    input  logic        [XW-1:0] run_from,
    input  logic        [XW-1:0] run_to,
    input  logic        [YW-1:0] run_y,
    input  logic        [NW-1:0] run_number,   // of its first vertex
    output logic                 run_busy,
    output logic                 settled,      // all runs are in
    input  logic                 start,
    input  logic                 advance,      // on to the next side
    input  logic                 hole,         // is followed the other way round
    input  logic        [XW-1:0] min_side,
    input  logic        [  AW:0] area,
    output logic                 done,
    output logic                 failed,

    output logic        [XW-1:0] from_x,
    output logic        [YW-1:0] from_y,
    output logic        [NW-1:0] from_number,
    output logic        [XW-1:0] to_x,
    output logic        [YW-1:0] to_y,
    output logic        [NW-1:0] to_number,
    output logic signed [CW-1:0] side_x,       // to - from, a clock later
    output logic signed [CW-1:0] side_y,
    output logic                 across,       // and what follows from it, two clocks later
    output logic        [CW-1:0] length,
    output logic        [XW+3:0] perimeter,

    output logic signed [MW-1:0] f,            // to the multiplier, 0 when not in use
    output logic signed [  17:0] g,
    output logic                 add,
    input  logic signed [VW-1:0] product,
    output logic                 sum_add,      // the product to the sum, which is 0 at the start
    input  logic        [VW-1:0] sum_size
);
  localparam [3:0] REST = 4'd0, AT_BASE = 4'd1, BASE = 4'd2, END = 4'd3, LINE = 4'd4, SCAN = 4'd5, SCANNED = 4'd6,
      ORDER = 4'd7, SIDES = 4'd8, FILL = 4'd9, FILLED = 4'd10, DONE = 4'd11;
  logic [3:0] state;
  logic [5:0] count;
  logic [1:0] side;
  assign done = state == DONE;

  // The scans: the farthest point from the first one (a), the farthest from that (c), then on either side of a line.
  logic [2:0] scan;
  logic [3:0] order[0:3];
  wire distances = scan < 3'd2;
  wire crosswise = scan[0];  // of the line scans: from b to d
  wire [3:0] base = scan == '0 ? 4'd0 : crosswise && !distances ? order[1] : order[0];
  logic [3:0] at;  // which extreme vertex is read; it comes a clock later
  logic [XW-1:0] point_x;
  logic [YW-1:0] point_y;
  logic [NW-1:0] point_number;
  chain_extremes #(.XW(XW), .YW(YW), .NW(NW)) extremes (
      .clk(clk), .reset(reset), .run(run), .busy(run_busy), .settled(settled), .run_from(run_from), .run_to(run_to),
      .run_y(run_y), .run_number(run_number), .at(at), .x(point_x), .y(point_y), .number(point_number));
  always_comb begin
    case (state)
      AT_BASE: at = base;
      BASE: at = crosswise ? order[3] : order[2];
      SCAN: at = count[4:1];
      default: at = order[0];
    endcase
  end
  // Two products for each point: from the line, or the squares of a distance. They are there six clocks later.
  wire second = count[0];
  logic signed [CW-1:0] apart;
  logic signed [VW-1:0] best, left;
  logic [3:0] best_at, left_at;
  wire below = product[VW-1];
  wire [VW-1:0] rival = below ? left : best;
  // Below, the product counts when it is less than what there is, else when it is greater.
  wire [VW+1:0] beats = {1'b0, !below, product[VW-2:0], 1'b1} + {1'b0, rival[VW-1], ~rival[VW-2:0], below};
  wire counts = beats[VW+1] != below;
  wire [3:0] first_pick = hole && !distances ? left_at : best_at;
  wire [3:0] second_pick = hole || distances ? best_at : left_at;

  // The sides: twice the area is the sum of (2 from_x + side_x) side_y.
  always_comb begin
    {f, g, add} = '0;
    if (state == SCAN) begin
      f = distances ? MW'(apart) : second ? MW'(side_x) : MW'(side_y);
      g = 18'(apart);
      add = second;
    end else if (state == SIDES) begin
      f = second ? MW'($signed({1'b0, from_x, 1'b0})) : MW'(side_x);
      g = 18'(side_y);
      add = !second;
    end
  end
  assign sum_add = state == SIDES && count[2:0] == 3'd4;
  // A magnitude: the complement, and the sign the last bit's carry.
  wire [CW:0] size_x_1 = {side_x ^ {CW{side_x[CW-1]}}, 1'b1} + {{CW{1'b0}}, side_x[CW-1]};
  wire [CW:0] size_y_1 = {side_y ^ {CW{side_y[CW-1]}}, 1'b1} + {{CW{1'b0}}, side_y[CW-1]};
  wire [CW-1:0] size_x = size_x_1[CW:1];
  wire [CW-1:0] size_y = size_y_1[CW:1];
  wire wider = size_x >= size_y;
  logic [CW-2:0] half_shorter;
  // Whether a magnitude is greater than a limit.
  logic signed [VW:0] span_off;
  logic [VW:0] span_room;
  wire [VW+1:0] span_left = {span_room, 1'b1} + {~span_off ^ {(VW + 1) {span_off[VW]}}, !span_off[VW]};

  wire move = advance || (state == ORDER && count[0]) || sum_add;
  always_ff @(posedge clk) begin
    failed <= 1'b0;
    apart <= $signed((second ? CW'(from_x) : CW'(point_y)) - (second ? CW'(point_x) : CW'(from_y)));
    side_x <= $signed({1'b0, to_x}) - $signed({1'b0, from_x});
    side_y <= $signed(CW'(to_y)) - $signed(CW'(from_y));
    across <= wider;
    length <= wider ? size_x : size_y;
    half_shorter <= wider ? size_y[CW-1:1] : size_x[CW-1:1];
    span_off <= $signed({1'b0, sum_size}) - $signed((VW + 1)'({area, 1'b0}));
    span_room <= (VW + 1)'(sum_size[VW-1:3]) + (VW + 1)'(perimeter);

    count <= count + 1'b1;
    case (state)
      REST: begin
        scan <= '0;
        if (start) state <= AT_BASE;
      end
      AT_BASE: state <= BASE;
      BASE: state <= END;
      END: state <= LINE;
      LINE: begin
        count <= '0;
        best <= '0;
        left <= '0;
        best_at <= base;
        left_at <= base;
        state <= SCAN;
      end
      SCAN: begin
        if (second && count[5:2] != '0 && counts) begin
          if (below) {left, left_at} <= {product, count[4:1] - 4'd2};
          else {best, best_at} <= {product, count[4:1] - 4'd2};
        end
        if (count == 6'd35) state <= SCANNED;
      end
      SCANNED: begin
        count <= '0;
        scan <= scan + 1'b1;
        state <= scan == 3'd5 ? ORDER : AT_BASE;
      end
      ORDER: begin  // until the first along the chain is the first, and all pairs have been seen
        side <= '0;
        perimeter <= '0;
        if (count[0] && count >= 6'd5 && from_number == to_number) begin
          failed <= 1'b1;
          state <= REST;
        end else if (count[0] && count >= 6'd11 && to_number < from_number) begin
          count <= '0;
          state <= SIDES;
        end
      end
      SIDES: begin
        if (count[2:0] == 3'd2) begin
          perimeter <= perimeter + (XW + 4)'(length) + (XW + 4)'(half_shorter);
          if (length < CW'(min_side)) begin
            failed <= 1'b1;
            state <= REST;
          end
        end
        if (sum_add) begin
          count <= '0;
          side <= side + 1'b1;
          if (side == 2'd3) state <= FILL;
        end
      end
      FILL: state <= FILLED;
      FILLED: begin
        failed <= span_left[VW+1];
        state <= span_left[VW+1] ? REST : DONE;
      end
      default: state <= REST;
    endcase

    if (state == BASE) {from_x, from_y, from_number} <= {point_x, point_y, point_number};
    else if (move) {from_x, from_y, from_number} <= {to_x, to_y, to_number};
    if (state == END || move) {to_x, to_y, to_number} <= {point_x, point_y, point_number};
    if (state == SCANNED) begin
      if (scan == '0 || (!distances && crosswise)) order[0] <= first_pick;
      if (scan == 3'd1 || (!distances && crosswise)) order[2] <= second_pick;
      if (!distances && !crosswise) begin
        order[1] <= first_pick;
        order[3] <= second_pick;
      end
    end else if (move) begin
      for (int i = 0; i < 4; i++) order[i] <= order[(i+1)%4];
    end
    if (reset) state <= REST;
  end
  wire unused = &{1'b0, size_x_1[0], size_y_1[0]};
endmodule
