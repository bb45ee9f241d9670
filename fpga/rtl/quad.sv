// The corner core of the hardware profile (src/corner/integer_quad.h is its definition): the quadrilateral that a
// closed chain draws, at any rotation. Walks the chain once for its extreme vertices and area, chooses four of them as
// rough corners, walks it again to fit a line to the cracks of each side, and lets neighbouring lines meet. One
// multiplier and one serial divider, used by one part after the other.
//
// The second walk goes on from the tail to the head until it is back at the first corner, so that one side at a time
// is added up.
module quad #(
    parameter XW = 10,
    parameter YW = 9,            // at most XW
    parameter RW = 10,
    parameter SW = XW + 6,       // signed, of a corner in sixteenths of a pixel
    parameter AW = XW + YW + 1   // of an area
) (
    input  logic            clk,
    input  logic            reset,
    input  logic [  AW-1:0] min_area,     // pixels
    input  logic [  AW-1:0] max_area,
    input  logic [  XW-1:0] min_side,

    input  logic            chain_valid,
    output logic            chain_ready,
    input  logic [  RW-1:0] chain_head,
    input  logic [  RW-1:0] chain_tail,
    input  logic            chain_hole,
    input  logic            chain_end,
    output logic            walk_read,
    input  logic            walk_granted,
    output logic [  RW-1:0] walk_record,
    input  logic [  XW-1:0] walk_x,
    input  logic [  YW-1:0] walk_y,
    input  logic [  RW-1:0] walk_next,
    output logic            release_valid,
    input  logic            release_ready,
    output logic [  RW-1:0] release_head,
    output logic [  RW-1:0] release_tail,

    output logic            quad_valid,
    input  logic            quad_ready,
    output logic [4*SW-1:0] quad_x,       // clockwise in the image, the first in the low bits
    output logic [4*SW-1:0] quad_y,
    output logic [  YW-1:0] quad_bottom,  // crack line on which the chain closed
    output logic            quad_hole,
    output logic            quad_end      // no quad: the frame's last has been handed on
);
  localparam NW = RW + 1;
  localparam CW = XW + 1;                     // of a signed place or difference of places
  localparam MW = 2 * CW > 18 ? 2 * CW : 18;  // of the multiplier's first factor; the second has 18 bits
  localparam PW = MW + 18;
  localparam VW = 2 * CW + 2;                 // of an area in a scan
  localparam SUM = 2 * XW + YW + 2;           // of a sum over all cracks of an image by their place
  localparam DW = 3 * XW + 5 > 36 ? 3 * XW + 5 : 36;

  localparam [4:0] IDLE = 5'd0, TAIL = 5'd1, TAIL_IN = 5'd2, READ = 5'd3, RECORD_IN = 5'd4, VERTICES = 5'd5,
      PRODUCT = 5'd6, AREA_ADD = 5'd7, AREA = 5'd8, LIMITS = 5'd9, CORNERS = 5'd10, UPRIGHT = 5'd11,
      UPRIGHT_END = 5'd12,
      LEVEL = 5'd13, LEVEL_END = 5'd14, SOLVE = 5'd15, NEXT_SIDE = 5'd16, SIDE_IN = 5'd17, LENGTH_IN = 5'd18,
      SET_UP = 5'd19, SET_UP_IN = 5'd20, MEET = 5'd21, RELEASE = 5'd22, EMIT = 5'd23;
  logic [4:0] state;
  logic good;

  // The walk.
  logic [RW-1:0] head, tail, record, next_record;
  logic hole, second_walk;
  logic [XW-1:0] at_x, to_x;
  logic [YW-1:0] at_y, to_y;
  logic [NW-1:0] number;  // of the next vertex
  wire at_tail = record == tail;
  assign chain_ready = state == IDLE;
  assign walk_read = state == TAIL || state == READ;
  assign walk_record = record;
  assign release_valid = state == RELEASE;
  assign release_head = head;
  assign release_tail = tail;
  assign quad_valid = state == EMIT;
  assign quad_hole = hole;

  // The multiplier and a sum of its products.
  logic signed [MW-1:0] corners_f, side_f, meet_f;
  logic signed [17:0] corners_g, side_g, meet_g;
  logic corners_add, side_add, meet_add;
  logic signed [PW-1:0] product;
  wire signed [CW-1:0] run_back = $signed({1'b0, at_x} - {1'b0, to_x});
  wire walk_multiplies = state == VERTICES;
  multiply_add #(.FW(MW), .GW(18)) multiplier (
      .clk(clk), .f((walk_multiplies ? MW'(to_y) : '0) | corners_f | side_f | meet_f),
      .g((walk_multiplies ? 18'(run_back) : '0) | corners_g | side_g | meet_g),
      .add(corners_add | side_add | meet_add), .product(product));

  logic signed [SUM-1:0] sum;
  wire [VW:0] sum_size_1 = {sum[VW-1:0] ^ {VW{sum[SUM-1]}}, 1'b1} + {{VW{1'b0}}, sum[SUM-1]};
  wire [VW-1:0] sum_size = sum_size_1[VW:1];
  logic corners_sum, side_sum;

  logic side_divide, meet_divide, dividing, side_opposite, meet_opposite;
  logic signed [DW-1:0] side_dividend, meet_dividend;
  logic [DW-1:0] side_divisor, meet_divisor;
  logic [4:0] side_steps, meet_steps;
  logic [17:0] quotient;
  logic signed [17:0] result;
  divider #(.W(DW), .QW(18)) divider_i (
      .clk(clk), .reset(reset), .start(side_divide || meet_divide), .dividend(side_dividend | meet_dividend),
      .divisor(side_divisor | meet_divisor), .steps(side_steps | meet_steps),
      .opposite(side_opposite || meet_opposite), .busy(dividing), .quotient(quotient), .result(result));

  // The first walk: area and extremes, and from them the rough corners.
  logic run_busy, settled;
  logic [AW:0] area;
  wire fits = area >= {1'b0, min_area} && area <= {1'b0, max_area};
  logic corners_done, corners_failed, meet_advance, across;
  logic [XW-1:0] from_x, side_to_x;
  logic [YW-1:0] from_y, side_to_y;
  logic [NW-1:0] from_number, to_number;
  logic signed [CW-1:0] side_x, side_y;
  logic [CW-1:0] length;
  logic [XW+3:0] perimeter;
  quad_corners #(.XW(XW), .YW(YW), .NW(NW), .AW(AW), .MW(MW)) corners (
      .clk(clk), .reset(reset), .run(state == VERTICES && !run_busy), .run_from(at_x), .run_to(to_x), .run_y(to_y),
      .run_number(number), .run_busy(run_busy), .settled(settled), .start(state == LIMITS && fits),
      .advance(state == NEXT_SIDE || meet_advance), .hole(hole), .min_side(min_side), .area(area),
      .done(corners_done), .failed(corners_failed),
      .from_x(from_x), .from_y(from_y), .from_number(from_number),
      .to_x(side_to_x), .to_y(side_to_y), .to_number(to_number),
      .side_x(side_x), .side_y(side_y), .across(across), .length(length), .perimeter(perimeter),
      .f(corners_f), .g(corners_g), .add(corners_add), .product(product[VW-1:0]),
      .sum_add(corners_sum), .sum_size(sum_size));

  // The second walk: the line of a side after the other.
  logic active;  // past the first corner
  logic from_level;  // a corner was met behind a level run
  logic [1:0] side;
  wire meets_corner = number == (active ? to_number : from_number);
  wire upright = state == UPRIGHT || state == UPRIGHT_END;
  wire ends = state == UPRIGHT_END || state == LEVEL_END;
  logic side_ready, side_done, side_failed;
  logic signed [SW-1:0] line_x, line_y;
  logic signed [16:0] line_slope;
  quad_side #(.XW(XW), .YW(YW), .SW(SW), .MW(MW), .DW(DW)) side_i (
      .clk(clk), .reset(reset), .set_up(state == SET_UP), .from_x(from_x), .from_y(from_y),
      .to_x(side_to_x), .to_y(side_to_y), .side_x(side_x), .side_y(side_y), .across(across), .length(length),
      .ready(side_ready), .run(active && (state == UPRIGHT && !across || state == LEVEL && across)),
      .run_along(upright ? ends ? XW'(to_y) : XW'(at_y) : ends ? to_x : at_x), .run_over(upright ? at_x : XW'(at_y)),
      .sum_add(side_sum), .sum(sum),
      .fit(state == SOLVE && side_ready && !side_done && !side_failed), .done(side_done), .failed(side_failed),
      .line_x(line_x), .line_y(line_y), .line_slope(line_slope),
      .f(side_f), .g(side_g), .add(side_add), .product(product),
      .divide(side_divide), .dividend(side_dividend), .divisor(side_divisor), .steps(side_steps),
      .opposite(side_opposite), .dividing(dividing), .quotient(quotient), .result(result));

  logic meet_done, meet_failed;
  quad_meet #(.XW(XW), .YW(YW), .SW(SW), .MW(MW), .DW(DW)) meet (
      .clk(clk), .reset(reset), .line_write(side_done), .line_side(side), .line_across(across),
      .line_x(line_x), .line_y(line_y), .line_slope(line_slope),
      .start(state == NEXT_SIDE && side == 2'd3), .done(meet_done), .failed(meet_failed), .hole(hole),
      .from_x(from_x), .from_y(from_y), .advance(meet_advance), .perimeter(perimeter),
      .corners_x(quad_x), .corners_y(quad_y), .f(meet_f), .g(meet_g), .add(meet_add), .product(product),
      .divide(meet_divide), .dividend(meet_dividend), .divisor(meet_divisor), .steps(meet_steps),
      .opposite(meet_opposite), .dividing(dividing), .quotient(quotient), .result(result));

  always_ff @(posedge clk) begin
    if (state == IDLE || state == LIMITS || state == SET_UP) sum <= '0;
    else if (state == AREA_ADD || corners_sum || side_sum) sum <= sum + SUM'(product);
    case (state)
      IDLE: begin
        head <= chain_head;
        tail <= chain_tail;
        hole <= chain_hole;
        quad_end <= chain_end;
        record <= chain_tail;
        second_walk <= 1'b0;
        number <= '0;
        active <= 1'b0;
        side <= '0;
        good <= 1'b0;
        if (chain_valid) state <= chain_end ? EMIT : TAIL;
      end
      TAIL: if (walk_granted) state <= TAIL_IN;
      TAIL_IN: begin
        at_x <= walk_x;
        quad_bottom <= walk_y;
        record <= head;
        state <= READ;
      end
      READ: if (walk_granted) state <= RECORD_IN;
      RECORD_IN: begin
        to_x <= walk_x;
        to_y <= walk_y;
        next_record <= walk_next;
        state <= second_walk ? UPRIGHT : VERTICES;
      end
      VERTICES: if (!run_busy) begin
        number <= number + NW'(2);
        state <= PRODUCT;
      end
      PRODUCT: state <= AREA_ADD;
      AREA_ADD: begin
        at_x <= to_x;
        at_y <= to_y;
        record <= next_record;
        state <= at_tail ? AREA : READ;
      end
      AREA: begin
        area <= sum_size[AW:0];
        if (settled) state <= LIMITS;
      end
      LIMITS: begin
        number <= '0;
        record <= head;
        second_walk <= 1'b1;
        state <= fits ? CORNERS : RELEASE;
      end
      CORNERS: begin
        if (corners_done) state <= READ;
        if (corners_failed) state <= RELEASE;
      end

      UPRIGHT: begin
        from_level <= 1'b0;
        state <= UPRIGHT_END;
      end
      UPRIGHT_END: begin
        number <= number + 1'b1;
        at_y <= to_y;
        active <= active || meets_corner;
        state <= !meets_corner ? LEVEL : active ? SOLVE : SET_UP;
      end
      LEVEL: begin
        from_level <= 1'b1;
        state <= LEVEL_END;
      end
      LEVEL_END: begin
        number <= at_tail ? '0 : number + 1'b1;
        at_x <= to_x;
        record <= at_tail ? head : next_record;
        active <= active || meets_corner;
        state <= !meets_corner ? READ : active ? SOLVE : SET_UP;
      end
      SOLVE: begin
        if (side_done) state <= NEXT_SIDE;
        if (side_failed) state <= RELEASE;
      end
      NEXT_SIDE: begin
        side <= side + 1'b1;
        state <= side == 2'd3 ? MEET : SIDE_IN;
      end
      SIDE_IN: state <= LENGTH_IN;
      LENGTH_IN: state <= SET_UP;
      SET_UP: state <= SET_UP_IN;
      SET_UP_IN: if (side_ready) state <= from_level ? READ : LEVEL;
      MEET: begin
        if (meet_done) good <= 1'b1;
        if (meet_done || meet_failed) state <= RELEASE;
      end
      RELEASE: if (release_ready) state <= good ? EMIT : IDLE;
      default: if (quad_ready) state <= IDLE;
    endcase
    if (reset) state <= IDLE;
  end
  wire unused = &{1'b0, sum_size_1[0]};
endmodule
