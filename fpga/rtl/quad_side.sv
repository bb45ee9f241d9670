// The line of one side of a quadrilateral (src/corner/side_fit.h is its definition). Runs of cracks come in, at most
// one in six clocks, and are added up in the background; then the line is solved for.
module quad_side #(
    parameter XW = 10,
    parameter YW = 9,
    parameter SW = XW + 6,
    parameter CW = XW + 1,
    parameter MW = 22,
    parameter PW = MW + 18,
    parameter SUM = 2 * XW + YW + 2,  // of a sum over all cracks of an image by their place
    parameter DW = 36
) (
    input  logic                 clk,
    input  logic                 reset,

    input  logic                 set_up,     // for the side in hand
    input  logic        [XW-1:0] from_x,
    input  logic        [YW-1:0] from_y,
    input  logic        [XW-1:0] to_x,
    input  logic        [YW-1:0] to_y,
    input  logic signed [CW-1:0] side_x,
    input  logic signed [CW-1:0] side_y,
    input  logic                 across,
    input  logic        [CW-1:0] length,
    output logic                 ready,

    input  logic                 run,        // the next clock brings its end
    input  logic        [XW-1:0] run_along,
    input  logic        [XW-1:0] run_over,   // in the next clock
    output logic                 sum_add,    // the product to the sum
    input  logic signed [SUM-1:0] sum,

    input  logic                 fit,
    output logic                 done,       // for a clock; the line stays
    output logic                 failed,
    output logic signed [SW-1:0] line_x,     // sixteenths of a pixel on the grid of cracks
    output logic signed [SW-1:0] line_y,
    output logic signed [  16:0] line_slope,

    output logic signed [MW-1:0] f,          // to the multiplier, 0 when not in use
    output logic signed [  17:0] g,
    output logic                 add,
    input  logic signed [PW-1:0] product,
    output logic                 divide,     // the rest is 0 when not in use
    output logic signed [DW-1:0] dividend,
    output logic        [DW-1:0] divisor,
    output logic        [   4:0] steps,
    output logic                 opposite,
    input  logic                 dividing,
    input  logic        [  17:0] quotient,
    input  logic signed [  17:0] result
);
  localparam SHORTEST = 2 * XW + 2 * YW + 4;
  localparam MOM = SHORTEST > DW ? SHORTEST : DW;  // of a sum by place and three times the distance
  localparam RW2 = 3 * XW + 3;                     // of three lengths multiplied
  localparam [3:0] REST = 4'd0, SET_2 = 4'd1, SET_3 = 4'd2, DRAIN = 4'd3, SQUARE = 4'd4, SQUARE_IN = 4'd5, CUBE = 4'd6,
      SPREAD = 4'd7, SPREAD_IN = 4'd8, MOMENT = 4'd9, SLOPE = 4'd10, MEAN = 4'd11, MEAN_IN = 4'd12, OFF = 4'd13;
  logic [3:0] state;
  assign ready = state == REST;

  logic backwards;
  logic [XW-1:0] low, high, start_over;
  logic signed [CW-1:0] over;
  logic [CW-1:0] columns, low_and_high;
  wire turned = across ? side_x[CW-1] : side_y[CW-1];
  wire [XW-1:0] from_along = across ? from_x : XW'(from_y);
  wire [XW-1:0] to_along = across ? to_x : XW'(to_y);
  wire [XW-1:0] margin = length < CW'(5) ? '0 : XW'(1) + XW'(length >> 4);

  // The runs: their ends within the limits, the product of length and place, that by three times the distance.
  logic [6:1] runs;
  wire [XW-1:0] clamped = run_along < low ? low : run_along > high ? high : run_along;
  logic [XW-1:0] run_from, run_to;
  logic signed [CW-1:0] run_off;
  logic signed [CW-1:0] middle;
  logic signed [MOM-1:0] moment;
  wire signed [CW+1:0] three_middles = (CW + 2)'(middle) + ((CW + 2)'(middle) <<< 1);
  assign sum_add = runs[4];

  // The line.
  logic signed [XW+5:0] mean;
  logic signed [XW+6:0] off_middle;
  // Whether a magnitude is greater than a limit, its sign being the last bit's carry.
  wire [XW+7:0] middle_left = {(XW + 7)'(32) + (XW + 7)'(length), 1'b1}
                            + {~off_middle ^ {(XW + 7) {off_middle[XW+6]}}, !off_middle[XW+6]};
  wire signed [SW-1:0] along_place = $signed({{(SW - CW - 3) {1'b0}}, low_and_high, 3'b0});
  wire signed [SW-1:0] over_place = $signed({{(SW - XW - 4) {1'b0}}, start_over, 4'b0}) + SW'(mean);
  assign line_x = across ? along_place : over_place;
  assign line_y = across ? over_place : along_place;

  always_comb begin
    {f, g, add} = '0;
    if (runs[2]) begin
      f = MW'($signed({1'b0, run_to} - {1'b0, run_from}));
      g = 18'(run_off);
    end
    if (runs[4] || state == CUBE) f = product[MW-1:0];
    if (runs[4]) g = 18'(three_middles);
    if (state == SQUARE) f = MW'($signed(columns));
    if (state == SPREAD) f = '1;
    if (state == SQUARE || state == CUBE || state == SPREAD) g = 18'($signed(columns));
    add = state == SPREAD;

    {divide, dividend, divisor, steps, opposite} = '0;
    if (state == MOMENT) begin  // the product is the spread
      divide = 1'b1;
      dividend = DW'(moment) <<< 1;
      divisor = DW'({product[RW2-1:0], 1'b0});
      steps = 5'd16;
    end
    if (state == SLOPE && !dividing) begin
      divide = 1'b1;
      dividend = DW'(sum);
      divisor = DW'(columns) << XW;
      steps = 5'(XW + 5);
    end
    if (state == MOMENT || state == SLOPE) opposite = backwards;
  end

  always_ff @(posedge clk) begin
    done <= 1'b0;
    failed <= 1'b0;
    case (state)
      REST: begin
        backwards <= turned;
        if (set_up) begin
          low <= turned ? to_along : from_along;
          high <= turned ? from_along : to_along;
          start_over <= across ? XW'(from_y) : from_x;
          over <= across ? side_y : side_x;
          state <= SET_2;
        end
        if (fit) state <= DRAIN;
      end
      SET_2: begin
        low <= low + margin;
        high <= high - margin;
        moment <= '0;
        state <= SET_3;
      end
      SET_3: begin
        columns <= {1'b0, high} - {1'b0, low};
        low_and_high <= {1'b0, high} + {1'b0, low};
        state <= REST;
      end

      DRAIN: if (runs == '0) state <= SQUARE;
      SQUARE: begin
        failed <= columns < CW'(2);
        state <= columns < CW'(2) ? REST : SQUARE_IN;
      end
      SQUARE_IN: state <= CUBE;
      CUBE: state <= SPREAD;
      SPREAD: state <= SPREAD_IN;
      SPREAD_IN: state <= MOMENT;
      MOMENT: begin
        failed <= moment[MOM-1:DW-2] != '0 && moment[MOM-1:DW-2] != '1;
        state <= moment[MOM-1:DW-2] != '0 && moment[MOM-1:DW-2] != '1 ? REST : SLOPE;
      end
      SLOPE: if (!dividing) begin
        line_slope <= result[16:0];
        failed <= quotient[15];
        state <= quotient[15] ? REST : MEAN;
      end
      MEAN: if (!dividing) begin
        mean <= (XW + 6)'(result);
        failed <= quotient[XW+4];
        state <= quotient[XW+4] ? REST : MEAN_IN;
      end
      MEAN_IN: begin
        off_middle <= (XW + 7)'(mean) - ((XW + 7)'(over) <<< 3);
        state <= OFF;
      end
      default: begin
        done <= !middle_left[XW+7];
        failed <= middle_left[XW+7];
        state <= REST;
      end
    endcase

    runs <= {runs[5:1], run};
    if (run) run_from <= clamped;
    if (runs[1]) begin
      run_to <= clamped;
      run_off <= $signed({1'b0, run_over}) - $signed({1'b0, start_over});
    end
    if (runs[2]) middle <= $signed({1'b0, run_from} + {1'b0, run_to} - low_and_high);
    if (runs[6]) moment <= moment + MOM'(product);
    if (reset) begin
      state <= REST;
      runs <= '0;
    end
  end
  wire unused = &{1'b0, result[17]};
endmodule
