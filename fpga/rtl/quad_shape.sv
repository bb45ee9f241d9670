// Whether four corners are convex and clockwise and enclose an area within limits: four cross products of neighbouring
// sides, the corners turning once round, then the area, by one serial multiplier.
module quad_shape #(
    parameter XW = 10,
    parameter YW = 9
) (
    input  logic             clk,
    input  logic             reset,
    input  logic             clear,
    input  logic             start,      // the corners are there in the next clock
    input  logic [XW+YW+1:0] min_area,   // in half pixels
    input  logic [XW+YW+1:0] max_area,
    input  logic [ 4*XW-1:0] corners_x,
    input  logic [ 4*YW-1:0] corners_y,
    output logic             turn,       // the corners, by one
    output logic             busy,
    output logic             good
);
  localparam W = (XW > YW ? XW : YW) + 1;  // of a signed difference
  logic [XW-1:0] x[0:3];
  logic [YW-1:0] y[0:3];
  assign {x[3], x[2], x[1], x[0]} = corners_x;
  assign {y[3], y[2], y[1], y[0]} = corners_y;

  function automatic signed [W-1:0] minus_x(input [XW-1:0] p, input [XW-1:0] q);
    minus_x = $signed({{(W - XW) {1'b0}}, p}) - $signed({{(W - XW) {1'b0}}, q});
  endfunction
  function automatic signed [W-1:0] minus_y(input [YW-1:0] p, input [YW-1:0] q);
    minus_y = $signed({{(W - YW) {1'b0}}, p}) - $signed({{(W - YW) {1'b0}}, q});
  endfunction

  logic running;
  logic side_done, area_done;  // its product stands there
  assign busy = running || area_done;
  logic [2:0] step;
  logic second_factor;
  logic [$clog2(W + 1)-1:0] bit_at;
  logic signed [2*W:0] product, factor;
  logic [W-1:0] multiplier;
  wire area_step = step[2];
  wire signed [W-1:0] factor_1 = second_factor ? minus_y(area_step ? y[2] : y[1], y[0]) : minus_x(area_step ? x[2] : x[1], x[0]);
  wire signed [W-1:0] factor_2 = second_factor ? (area_step ? minus_x(x[3], x[1]) : minus_x(x[2], x[0]))
                                               : (area_step ? minus_y(y[3], y[1]) : minus_y(y[2], y[0]));
  wire load = bit_at == '0;
  wire sum = bit_at == ($clog2(W + 1))'(W);
  wire last = sum && second_factor;
  // Two's complement: the top bit of the multiplier weighs negative.
  wire subtract = second_factor != sum;
  wire signed [2*W:0] added = multiplier[0] ? factor : '0;
  wire signed [2*W:0] new_product = subtract ? product - added : product + added;
  assign turn = running && last && !area_step;

  always_ff @(posedge clk) begin
    if (clear) begin
      step <= '0;
      bit_at <= '0;
      second_factor <= 1'b0;
      good <= 1'b1;
    end else if (running) begin
      multiplier <= load ? factor_2 : {1'b0, multiplier[W-1:1]};
      factor <= load ? (2 * W + 1)'(factor_1) : factor <<< 1;
      if (load) product <= second_factor ? product : '0;
      else product <= new_product;
      bit_at <= sum ? '0 : bit_at + 1'b1;
      if (sum) second_factor <= !second_factor;
      if (last) step <= step + 1'b1;
    end
    side_done <= running && last && !area_step;
    area_done <= running && last && area_step;
    if (side_done && (product[2*W] || product == '0)) good <= 1'b0;
    if (area_done && (product[2*W] || product[XW+YW+1:0] < min_area || product[XW+YW+1:0] > max_area)) good <= 1'b0;
    running <= (running && !(last && area_step)) || start;
    if (reset) running <= 1'b0;
  end
endmodule
