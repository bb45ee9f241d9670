// A multiplier that adds up, as one DSP block does it: two factors a clock, and two clocks later their product, or with
// `add` the sum of what was there and the product.
module multiply_add #(
    parameter FW = 25,
    parameter GW = 18,
    parameter PW = FW + GW
) (
    input  logic                 clk,
    input  logic signed [FW-1:0] f,
    input  logic signed [GW-1:0] g,
    input  logic                 add,
    output logic signed [PW-1:0] product
);
  logic signed [FW-1:0] first;
  logic signed [GW-1:0] second;
  logic adding;
  wire signed [PW-1:0] times = first * second;
  wire signed [PW-1:0] so_far = adding ? product : '0;
  always_ff @(posedge clk) begin
    first <= f;
    second <= g;
    adding <= add;
    product <= so_far + times;
  end
endmodule
