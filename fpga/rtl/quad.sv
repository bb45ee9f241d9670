// The corner core of the hardware profile (src/corner/integer_quad.h is its definition): the quadrilateral that a
// closed chain draws, at any rotation. Walks the chain once for its extreme vertices and area, chooses four of them as
// rough corners, walks it again to fit a line to the cracks of each side, and lets neighbouring lines meet. Two
// multipliers and one serial divider, used one step after the other.
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
  localparam CW = XW + 1;                   // of a signed place or difference of places
  localparam MW = 2 * CW > 18 ? 2 * CW : 18;  // of a multiplier's first factor; the second has 18 bits
  localparam PW = MW + 18;
  localparam VW = 2 * CW + 2;               // of an area in a scan
  localparam SUM = 2 * XW + YW + 2;         // of a sum over all cracks of an image by their place,
  localparam MOM = 2 * XW + 2 * YW + 2;     // and by their distance too
  localparam RW2 = 3 * XW + 3;              // of three lengths multiplied
  localparam DW = RW2 + 2 > 36 ? RW2 + 2 : 36;
  localparam FAR = XW + 5;                   // bits of a distance in sixteenths that no image is wide

  localparam [5:0] IDLE = 6'd0, TAIL = 6'd1, TAIL_IN = 6'd2, READ = 6'd3, RECORD_IN = 6'd4, VERTEX_1 = 6'd5,
      VERTEX_2 = 6'd6, VERTICES = 6'd7, AREA = 6'd8, SCAN_SET = 6'd9, SCAN_LINE = 6'd10, SCAN = 6'd11,
      SCANNED = 6'd12, TURN_ROUND = 6'd13, SIDES = 6'd14, SIDE_LENGTH = 6'd15, SPAN = 6'd16, SPANNED = 6'd17, FILLED = 6'd18,
      UPRIGHT = 6'd19, UPRIGHT_END = 6'd20, LEVEL = 6'd21, LEVEL_END = 6'd22, SEGMENT_1 = 6'd23, SEGMENT_2 = 6'd24,
      SEGMENT_3 = 6'd25, SEGMENT_4 = 6'd26, SEGMENT_5 = 6'd27, SEGMENT_6 = 6'd28, SETUP_1 = 6'd29, SETUP_2 = 6'd30,
      SETUP_3 = 6'd31, SETUP_4 = 6'd32, SOLVE_1 = 6'd33, SOLVE_2 = 6'd34, SOLVE_3 = 6'd35, SOLVE_4 = 6'd36,
      SOLVE_5 = 6'd37, SOLVE_6 = 6'd38, SLOPE = 6'd39, MEAN = 6'd40, MEAN_IN = 6'd41, OFF = 6'd42, LINE = 6'd43,
      MEET_1 = 6'd44, MEET_2 = 6'd45, MEET_3 = 6'd46, MEET_4 = 6'd47, MEET_5 = 6'd48, MEET_6 = 6'd49, REACH = 6'd50,
      PLACE_1 = 6'd51, PLACE_2 = 6'd52, PLACE_3 = 6'd53, PLACE_4 = 6'd54, RELEASE = 6'd55, EMIT = 6'd56,
      PLACE_5 = 6'd57, FILL = 6'd58,
      PLACE_6 = 6'd59, SPAN_LEFT = 6'd60, SIDE_SIZE = 6'd61, PLACE_7 = 6'd62;
  logic [5:0] state;
  logic good;
  logic [4:0] count;

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

  function automatic signed [CW-1:0] wide_x(input [XW-1:0] v);
    wide_x = $signed({{(CW - XW) {1'b0}}, v});
  endfunction
  function automatic signed [CW-1:0] wide_y(input [YW-1:0] v);
    wide_y = $signed({{(CW - YW) {1'b0}}, v});
  endfunction
  function automatic signed [CW-1:0] minus(input signed [CW-1:0] p, input signed [CW-1:0] q);
    minus = p - q;
  endfunction
  function automatic [CW-1:0] magnitude(input signed [CW-1:0] v);
    magnitude = v[CW-1] ? -v : v;
  endfunction

  // The multipliers: factors, a clock later products.
  logic signed [MW-1:0] f1, f2;
  logic signed [17:0] g1, g2;
  logic signed [PW-1:0] p1;
  logic signed [SW+18:0] p2;  // no use is longer
  always_ff @(posedge clk) begin
    p1 <= f1 * g1;
    p2 <= (SW + 19)'(f2 * g2);
  end
  wire signed [SW+3:0] whole_1 = p1[SW+17:14];
  wire signed [SW+3:0] whole_2 = p2[SW+17:14];
  wire signed [VW-1:0] p_sum = p1[VW-1:0] + p2[VW-1:0];
  wire signed [SW+18:0] p_difference = p1[SW+18:0] - p2[SW+18:0];

  wire signed [VW-1:0] p_area = p_difference[VW-1:0];
  wire [VW-1:0] p_area_size = p_area[VW-1] ? -p_area : p_area;

  logic divide, dividing;
  logic signed [DW-1:0] dividend;
  logic [DW-1:0] divisor;
  logic negative;  // the dividend is complemented, and so is the quotient: it is rounded down
  logic [4:0] steps;
  logic [17:0] quotient;
  logic opposite;  // the quotient of the opposite number is wanted
  wire signed [17:0] result = $signed(quotient ^ {18{negative != opposite}});
  divider #(.W(DW), .QW(18)) divider_i (
      .clk(clk), .reset(reset), .start(divide), .dividend(dividend), .ones(negative), .divisor(divisor),
      .steps(steps), .busy(dividing), .quotient(quotient));

  // The first walk: area and extremes.
  logic signed [SUM-1:0] area;
  logic [AW:0] area_size;
  logic [XW-1:0] point_x;
  logic [YW-1:0] point_y;
  logic [NW-1:0] point_number;
  chain_extremes #(.XW(XW), .YW(YW), .NW(NW)) extremes (
      .clk(clk), .vertex(state == VERTEX_1 || state == VERTEX_2), .vertex_x(state == VERTEX_1 ? at_x : to_x),
      .vertex_y(to_y), .vertex_number(number), .at(count[3:0]),
      .x(point_x), .y(point_y), .number(point_number));

  // The rough corners; while they are looked for, a scan's base and the best of its points so far.
  logic [XW-1:0] corner_x[0:3];
  logic [YW-1:0] corner_y[0:3];
  logic [NW-1:0] corner_number[0:3];
  logic [2:0] scan;
  logic [XW-1:0] base_x, best_x, left_x, point_x_1, point_x_2;
  logic [YW-1:0] base_y, best_y, left_y, point_y_1, point_y_2;
  logic [NW-1:0] base_number, best_number, left_number, point_number_1, point_number_2;
  logic signed [CW-1:0] u_x, u_y;
  logic signed [VW-1:0] best, left;
  wire distances = scan < 3'd2;
  wire crosswise = scan[0];  // of the line scans: from b to d
  wire signed [CW-1:0] from_base_x = wide_x(point_x) - wide_x(base_x);
  wire signed [CW-1:0] from_base_y = wide_y(point_y) - wide_y(base_y);
  // What is scanned from, and the other end of the line.
  wire [1:0] base_corner = distances ? 2'd0 : {1'b0, crosswise};
  wire [1:0] end_corner = {1'b1, crosswise};
  // A hole is followed the other way round.
  wire [XW+YW+NW-1:0] of_best = {best_x, best_y, best_number};
  wire [XW+YW+NW-1:0] of_left = {left_x, left_y, left_number};
  wire [XW+YW+NW-1:0] first_pick = hole && !distances ? of_left : of_best;
  wire [XW+YW+NW-1:0] second_pick = hole || distances ? of_best : of_left;
  logic round;  // the corners move up by one
  assign round = (state == TURN_ROUND && corner_number[0] > corner_number[3]) || (state == SIDE_LENGTH) || (state == LINE) || (state == PLACE_7);

  // A side.
  logic [1:0] side;
  wire [1:0] next_side = side + 1'b1;
  logic active, from_level;  // the walk is past the first corner; it stands behind a level run
  logic signed [CW-1:0] side_x, side_y;
  logic across, backwards;
  logic signed [CW-1:0] low, high, start_over, over;
  logic [CW-1:0] length;
  logic [CW-2:0] over_half;
  logic [XW+3:0] perimeter;
  logic signed [CW-1:0] segment_from, segment_to, segment_over, segment_a, segment_b;
  logic signed [CW+1:0] segment_x;
  logic signed [SUM-1:0] sum;
  logic signed [MOM-1:0] moment;
  wire signed [RW2-3:0] low_moment = moment[RW2-3:0];
  wire signed [DW-1:0] six_moments = (DW'(low_moment) <<< 2) + (DW'(low_moment) <<< 1);
  logic [CW-1:0] columns;
  logic signed [16:0] slope;
  logic signed [XW+5:0] mean;
  wire [CW-1:0] margin = length < CW'(5) ? '0 : CW'(1) + (length >> 4);
  wire signed [CW-1:0] from_x = wide_x(corner_x[0]);
  wire signed [CW-1:0] from_y = wide_y(corner_y[0]);
  wire signed [CW-1:0] to_corner_x = wide_x(corner_x[1]);
  wire signed [CW-1:0] to_corner_y = wide_y(corner_y[1]);
  wire [CW-1:0] size_x = magnitude(side_x);
  wire [CW-1:0] size_y = magnitude(side_y);
  wire [CW-1:0] longer = size_x >= size_y ? size_x : size_y;
  wire [CW-2:0] half_shorter = size_x >= size_y ? size_y[CW-1:1] : size_x[CW-1:1];
  wire meets_corner = number == (active ? corner_number[1] : corner_number[0]);
  function automatic signed [CW-1:0] clamped(input signed [CW-1:0] v);
    clamped = v < low ? low : v > high ? high : v;
  endfunction

  // The four lines: across, place of a point, slope.
  logic line_across[0:3];
  logic signed [SW-1:0] line_x[0:3];
  logic signed [SW-1:0] line_y[0:3];
  logic signed [16:0] line_slope[0:3];
  localparam signed [16:0] ONE = 17'sd16384;
  logic signed [16:0] a_x, a_y, b_x, b_y;
  logic signed [SW:0] apart_x, apart_y;
  logic signed [19:0] sine;
  logic signed [SW+18:0] apart;
  logic [19:0] sine_size;
  logic signed [17:0] t;
  logic signed [SW+3:0] meet_x, meet_y, off_x, off_y;
  wire signed [SW-1:0] along_place = (SW'(low) + SW'(high)) <<< 3;
  wire signed [SW-1:0] over_place = (SW'(start_over) <<< 4) + SW'(mean);
  function automatic [SW+3:0] size_of(input signed [SW+3:0] v);
    size_of = v[SW+3] ? -v : v;
  endfunction
  logic [SW+4:0] off_all;
  logic [XW+4:0] perimeter_room;  // of how far a corner may be from its rough one
  logic signed [SW-1:0] out_x[0:3];
  logic signed [SW-1:0] out_y[0:3];
  assign quad_x = {out_x[3], out_x[2], out_x[1], out_x[0]};
  assign quad_y = {out_y[3], out_y[2], out_y[1], out_y[0]};

  // Tests whose terms are registered a state before.
  logic signed [XW+6:0] off_middle;
  // Whether a magnitude is greater than a limit, its sign being the last bit's carry.
  wire [XW+7:0] middle_left = {(XW + 7)'(32) + (XW + 7)'(length), 1'b1}
                            + {~off_middle ^ {(XW + 7) {off_middle[XW+6]}}, !off_middle[XW+6]};
  logic [VW-1:0] spanned;  // twice the area of the rough corners
  wire signed [VW:0] span_off = $signed({1'b0, spanned}) - $signed((VW + 1)'({area_size, 1'b0}));
  wire [VW:0] span_room = (VW + 1)'(spanned[VW-1:3]) + (VW + 1)'(perimeter);
  logic [VW+1:0] span_left;

  always_ff @(posedge clk) begin
    divide <= 1'b0;
    case (state)
      IDLE: begin
        head <= chain_head;
        tail <= chain_tail;
        hole <= chain_hole;
        quad_end <= chain_end;
        record <= chain_tail;
        second_walk <= 1'b0;
        number <= '0;
        area <= '0;
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
        state <= second_walk ? UPRIGHT : VERTEX_1;
      end
      VERTEX_1: begin
        f1 <= MW'(wide_y(to_y));
        g1 <= 18'(minus(wide_x(at_x), wide_x(to_x)));
        number <= number + 1'b1;
        state <= VERTEX_2;
      end
      VERTEX_2: begin
        number <= number + 1'b1;
        state <= VERTICES;
      end
      VERTICES: begin
        area <= area + SUM'(p1);
        at_x <= to_x;
        at_y <= to_y;
        record <= next_record;
        count <= '0;
        state <= at_tail ? AREA : READ;
      end

      AREA: begin
        // The extremes take in the last vertex meanwhile.
        area_size <= area[SUM-1] ? (AW + 1)'(-area) : (AW + 1)'(area);
        count <= count + 1'b1;
        scan <= '0;
        if (count == 5'd2) begin
          count <= '0;
          state <= area_size < {1'b0, min_area} || area_size > {1'b0, max_area} ? RELEASE : SCAN_SET;
        end
      end

      // The farthest point from the first one (a), the farthest from that (c), then on either side of a line.
      SCAN_SET: begin
        base_x <= scan == '0 ? point_x : corner_x[base_corner];
        base_y <= scan == '0 ? point_y : corner_y[base_corner];
        base_number <= scan == '0 ? point_number : corner_number[base_corner];
        u_x <= wide_x(corner_x[end_corner]) - wide_x(corner_x[base_corner]);
        u_y <= wide_y(corner_y[end_corner]) - wide_y(corner_y[base_corner]);
        state <= SCAN_LINE;
      end
      SCAN_LINE: begin
        best <= distances ? '1 : '0;
        left <= '0;
        {best_x, best_y, best_number} <= {base_x, base_y, base_number};
        {left_x, left_y, left_number} <= {base_x, base_y, base_number};
        state <= SCAN;
      end
      SCAN: begin
        f1 <= distances ? MW'(from_base_x) : MW'(u_x);
        g1 <= distances ? 18'(from_base_x) : 18'(from_base_y);
        f2 <= distances ? MW'(from_base_y) : MW'(u_y);
        g2 <= distances ? 18'(from_base_y) : 18'(from_base_x);
        {point_x_1, point_y_1, point_number_1} <= {point_x, point_y, point_number};
        {point_x_2, point_y_2, point_number_2} <= {point_x_1, point_y_1, point_number_1};
        if (count >= 5'd2) begin
          if ((distances ? p_sum : p_area) > best) begin
            best <= distances ? p_sum : p_area;
            {best_x, best_y, best_number} <= {point_x_2, point_y_2, point_number_2};
          end
          if (p_area < left) begin
            left <= p_area;
            {left_x, left_y, left_number} <= {point_x_2, point_y_2, point_number_2};
          end
        end
        count <= count + 1'b1;
        if (count == 5'd17) state <= SCANNED;
      end
      SCANNED: begin  // the corners in the order of the chain, but for which is the first
        count <= '0;
        scan <= scan + 1'b1;
        state <= scan == 3'd5 ? TURN_ROUND : SCAN_SET;
      end
      TURN_ROUND: begin  // until the first along the chain is the first
        side <= '0;
        perimeter <= '0;
        if (corner_number[0] == corner_number[1] || corner_number[1] == corner_number[2]
            || corner_number[2] == corner_number[3] || corner_number[3] == corner_number[0]) state <= RELEASE;
        else if (corner_number[0] < corner_number[3] || count == 5'd4) state <= SIDES;
        count <= count + 1'b1;
      end
      SIDES: begin
        side_x <= to_corner_x - from_x;
        side_y <= to_corner_y - from_y;
        state <= SIDE_SIZE;
      end
      SIDE_SIZE: begin
        length <= longer;
        over_half <= half_shorter;
        state <= SIDE_LENGTH;
      end
      SIDE_LENGTH: begin
        perimeter <= perimeter + (XW + 4)'(length) + (XW + 4)'(over_half);
        side <= next_side;
        state <= length < CW'(min_side) ? RELEASE : side == 2'd3 ? SPAN : SIDES;
      end
      SPAN: begin
        f1 <= MW'(minus(wide_x(corner_x[2]), wide_x(corner_x[0])));
        g1 <= 18'(minus(wide_y(corner_y[3]), wide_y(corner_y[1])));
        f2 <= MW'(minus(wide_x(corner_x[3]), wide_x(corner_x[1])));
        g2 <= 18'(minus(wide_y(corner_y[2]), wide_y(corner_y[0])));
        state <= SPANNED;
      end
      SPANNED: state <= FILL;
      FILL: begin
        spanned <= p_area_size;
        state <= FILLED;
      end
      FILLED: begin
        span_left <= {span_room, 1'b1} + {~span_off ^ {(VW + 1) {span_off[VW]}}, !span_off[VW]};
        perimeter_room <= (XW + 5)'(perimeter) + (XW + 5)'(32);
        state <= SPAN_LEFT;
      end
      SPAN_LEFT: begin
        second_walk <= 1'b1;
        record <= head;
        number <= '0;
        active <= 1'b0;
        state <= span_left[VW+1] ? RELEASE : READ;
      end

      // The second walk.
      UPRIGHT: begin
        segment_from <= wide_y(at_y);
        segment_to <= wide_y(to_y);
        segment_over <= wide_x(at_x);
        from_level <= 1'b0;
        state <= active && !across ? SEGMENT_1 : UPRIGHT_END;
      end
      UPRIGHT_END: begin
        number <= number + 1'b1;
        at_y <= to_y;
        active <= active || meets_corner;
        state <= !meets_corner ? LEVEL : active ? SOLVE_1 : SETUP_1;
      end
      LEVEL: begin
        segment_from <= wide_x(at_x);
        segment_to <= wide_x(to_x);
        segment_over <= wide_y(at_y);
        from_level <= 1'b1;
        state <= active && across ? SEGMENT_1 : LEVEL_END;
      end
      LEVEL_END: begin
        number <= at_tail ? '0 : number + 1'b1;
        at_x <= to_x;
        record <= at_tail ? head : next_record;
        active <= active || meets_corner;
        state <= !meets_corner ? READ : active ? SOLVE_1 : SETUP_1;
      end
      SEGMENT_1: begin
        segment_a <= clamped(segment_from);
        segment_b <= clamped(segment_to);
        g1 <= 18'(minus(segment_over, start_over));
        state <= SEGMENT_2;
      end
      SEGMENT_2: begin
        f1 <= MW'(minus(segment_b, segment_a));
        segment_x <= (CW + 2)'(segment_a) + (CW + 2)'(segment_b) - (CW + 2)'(low) - (CW + 2)'(high);
        state <= SEGMENT_3;
      end
      SEGMENT_3: state <= SEGMENT_4;
      SEGMENT_4: begin
        sum <= sum + SUM'(p1);
        f1 <= p1[MW-1:0];
        g1 <= 18'(segment_x);
        state <= SEGMENT_5;
      end
      SEGMENT_5: state <= SEGMENT_6;
      SEGMENT_6: begin
        moment <= moment + MOM'(p1);
        state <= from_level ? LEVEL_END : UPRIGHT_END;
      end

      // The limits of a side.
      SETUP_1: begin
        side_x <= to_corner_x - from_x;
        side_y <= to_corner_y - from_y;
        state <= SETUP_2;
      end
      SETUP_2: begin
        across <= size_x >= size_y;
        length <= longer;
        state <= SETUP_3;
      end
      SETUP_3: begin
        over <= across ? side_y : side_x;
        start_over <= across ? from_y : from_x;
        backwards <= across ? side_x[CW-1] : side_y[CW-1];
        if (across) begin
          low <= side_x[CW-1] ? to_corner_x : from_x;
          high <= side_x[CW-1] ? from_x : to_corner_x;
        end else begin
          low <= side_y[CW-1] ? to_corner_y : from_y;
          high <= side_y[CW-1] ? from_y : to_corner_y;
        end
        state <= SETUP_4;
      end
      SETUP_4: begin
        low <= low + $signed(margin);
        high <= high - $signed(margin);
        sum <= '0;
        moment <= '0;
        state <= from_level ? READ : LEVEL;
      end

      // The line of a side.
      SOLVE_1: begin
        columns <= high - low;
        state <= SOLVE_2;
      end
      SOLVE_2: begin
        f1 <= MW'($signed(columns));
        g1 <= 18'($signed(columns));
        state <= columns < CW'(2) ? RELEASE : SOLVE_3;
      end
      SOLVE_3: state <= SOLVE_4;
      SOLVE_4: begin
        f1 <= MW'(p1) - MW'(1);
        state <= SOLVE_5;
      end
      SOLVE_5: state <= SOLVE_6;
      SOLVE_6: begin  // the product is the spread
        negative <= moment[MOM-1];
        opposite <= backwards;
        dividend <= six_moments ^ {DW{moment[MOM-1]}};
        divisor <= DW'({p1[RW2-1:0], 1'b0});
        steps <= 5'd16;
        divide <= 1'b1;
        state <= moment[MOM-1:RW2-3] != '0 && moment[MOM-1:RW2-3] != '1 ? RELEASE : SLOPE;
      end
      SLOPE: if (!divide && !dividing) begin
        slope <= result[16:0];
        negative <= sum[SUM-1];
        dividend <= DW'(sum) ^ {DW{sum[SUM-1]}};
        divisor <= DW'(columns) << XW;
        steps <= 5'(XW + 5);
        divide <= 1'b1;
        state <= quotient[15] ? RELEASE : MEAN;
      end
      MEAN: begin
        if (!divide && !dividing) begin
          mean <= (XW + 6)'(result);
          state <= quotient[XW+4] ? RELEASE : MEAN_IN;
        end
      end
      MEAN_IN: begin
        off_middle <= (XW + 7)'(mean) - ((XW + 7)'(over) <<< 3);
        state <= OFF;
      end
      OFF: state <= middle_left[XW+7] ? RELEASE : LINE;
      LINE: begin
        side <= next_side;
        state <= side == 2'd3 ? MEET_1 : SETUP_1;
      end

      // Where the line of a side meets the one before.
      MEET_1: begin
        a_x <= line_across[3] ? ONE : line_slope[3];
        a_y <= line_across[3] ? line_slope[3] : ONE;
        b_x <= line_across[0] ? ONE : line_slope[0];
        b_y <= line_across[0] ? line_slope[0] : ONE;
        apart_x <= (SW + 1)'(line_x[0]) - (SW + 1)'(line_x[3]);
        apart_y <= (SW + 1)'(line_y[0]) - (SW + 1)'(line_y[3]);
        state <= MEET_2;
      end
      MEET_2: begin
        f1 <= MW'(a_x);
        g1 <= 18'(b_y);
        f2 <= MW'(a_y);
        g2 <= 18'(b_x);
        state <= MEET_3;
      end
      MEET_3: begin
        f1 <= MW'(apart_x);
        f2 <= MW'(apart_y);
        state <= MEET_4;
      end
      MEET_4: begin
        sine <= p_difference[31:12];
        state <= MEET_5;
      end
      MEET_5: begin
        apart <= p_difference[SW+18:0];
        sine_size <= sine[19] ? -sine : sine;
        state <= MEET_6;
      end
      MEET_6: begin
        state <= sine_size < 20'd4096 ? RELEASE : REACH;
        count <= '0;
      end
      REACH: begin
        negative <= apart[SW+18];
        opposite <= sine[19];
        dividend <= (DW'(apart) <<< 2) ^ {DW{apart[SW+18]}};
        divisor <= DW'(sine_size) << FAR;
        steps <= 5'(FAR + 1);
        divide <= count == '0;
        count <= 5'd1;
        if (count != '0 && !divide && !dividing) begin
          t <= result;
          state <= quotient[FAR] ? RELEASE : PLACE_1;
        end
      end
      PLACE_1: begin
        f1 <= MW'(a_x);
        g1 <= t;
        f2 <= MW'(a_y);
        g2 <= t;
        state <= PLACE_2;
      end
      PLACE_2: state <= PLACE_3;
      PLACE_3: begin
        meet_x <= (SW + 4)'(line_x[3]) + whole_1;
        meet_y <= (SW + 4)'(line_y[3]) + whole_2;
        state <= PLACE_4;
      end
      PLACE_4: begin
        off_x <= meet_x + (SW + 4)'(8) - ((SW + 4)'(from_x) <<< 4);
        off_y <= meet_y + (SW + 4)'(8) - ((SW + 4)'(from_y) <<< 4);
        state <= PLACE_5;
      end
      PLACE_5: begin
        off_x <= $signed(size_of(off_x));
        off_y <= $signed(size_of(off_y));
        state <= PLACE_6;
      end
      PLACE_6: begin
        off_all <= {1'b0, off_x} + {1'b0, off_y};
        state <= PLACE_7;
      end
      PLACE_7: begin
        out_x[hole?~side : side] <= meet_x[SW-1:0];  // a hole is followed the other way round
        out_y[hole?~side : side] <= meet_y[SW-1:0];
        side <= next_side;
        good <= 1'b1;
        if (off_all > (SW + 5)'(perimeter_room)) begin
          good <= 1'b0;
          state <= RELEASE;
        end else begin
          state <= side == 2'd3 ? RELEASE : MEET_1;
        end
      end
      RELEASE: if (release_ready) state <= good ? EMIT : IDLE;
      default: if (quad_ready) state <= IDLE;
    endcase
    if (state == SCANNED) begin
      if (scan == '0 || (!distances && crosswise)) {corner_x[0], corner_y[0], corner_number[0]} <= first_pick;
      if (scan == 3'd1 || (!distances && crosswise)) {corner_x[2], corner_y[2], corner_number[2]} <= second_pick;
      if (!distances && !crosswise) begin
        {corner_x[1], corner_y[1], corner_number[1]} <= first_pick;
        {corner_x[3], corner_y[3], corner_number[3]} <= second_pick;
      end
    end else if (round) begin
      for (int i = 0; i < 4; i++) begin
        corner_x[i] <= corner_x[(i+1)%4];
        corner_y[i] <= corner_y[(i+1)%4];
        corner_number[i] <= corner_number[(i+1)%4];
      end
    end
    if (state == LINE || state == PLACE_7) begin
      for (int i = 0; i < 3; i++) begin
        line_across[i] <= line_across[i+1];
        line_x[i] <= line_x[i+1];
        line_y[i] <= line_y[i+1];
        line_slope[i] <= line_slope[i+1];
      end
      line_across[3] <= state == LINE ? across : line_across[0];
      line_x[3] <= state == LINE ? (across ? along_place : over_place) - SW'(8) : line_x[0];
      line_y[3] <= state == LINE ? (across ? over_place : along_place) - SW'(8) : line_y[0];
      line_slope[3] <= state == LINE ? slope : line_slope[0];
    end
    // A corner that was placed counts only with all four.
    if (state != PLACE_7 && state != RELEASE && state != EMIT) good <= 1'b0;
    if (reset) state <= IDLE;
  end
endmodule
