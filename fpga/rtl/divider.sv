// Divides a signed dividend and rounds down, a bit of the quotient a clock: of the complement when the dividend is
// negative, ones following its last bit, and the quotient is complemented too. `divisor` is given shifted up to the
// weight of the quotient's first bit.
//
// The quotient has one bit more than is wanted: when the first is set it is too large for the others.
module divider #(
    parameter W = 36,
    parameter QW = 18
) (
    input  logic                 clk,
    input  logic                 reset,
    input  logic                 start,
    input  logic signed [ W-1:0] dividend,
    input  logic        [ W-1:0] divisor,
    input  logic        [   4:0] steps,
    input  logic                 opposite,  // the quotient of the opposite number is wanted
    output logic                 busy,
    output logic        [QW-1:0] quotient,  // its size
    output logic signed [QW-1:0] result
);
  logic [W:0] rest;
  logic [W-1:0] by;
  logic [4:0] left;
  logic negative, turned;
  wire [W+1:0] less = {1'b0, rest} - {2'b0, by};
  wire fits = !less[W+1];
  assign busy = left != '0;
  assign result = $signed(quotient ^ {QW{negative != turned}});

  always_ff @(posedge clk) begin
    if (start) begin
      rest <= {1'b0, dividend ^ {W{dividend[W-1]}}};
      by <= divisor;
      left <= steps;
      quotient <= '0;
      negative <= dividend[W-1];
      turned <= opposite;
    end else if (busy) begin
      rest <= {fits ? less[W-1:0] : rest[W-1:0], negative};
      quotient <= {quotient[QW-2:0], fits};
      left <= left - 1'b1;
    end
    if (reset) left <= '0;
  end
endmodule
