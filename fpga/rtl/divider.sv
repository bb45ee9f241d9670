// Divides two magnitudes, a bit of the quotient a clock, zeros or ones following the dividend's last bit. `divisor` is
// given shifted up to the weight of the quotient's first bit, and must stay until the quotient is there.
//
// The quotient has one bit more than is wanted: when the first is set it is too large for the others.
module divider #(
    parameter W = 36,
    parameter QW = 18
) (
    input  logic          clk,
    input  logic          reset,
    input  logic          start,
    input  logic [ W-1:0] dividend,
    input  logic          ones,      // what follows the dividend
    input  logic [ W-1:0] divisor,
    input  logic [   4:0] steps,
    output logic          busy,
    output logic [QW-1:0] quotient
);
  logic [W:0] rest;
  logic [4:0] left;
  wire [W+1:0] less = {1'b0, rest} - {2'b0, divisor};
  wire fits = !less[W+1];
  assign busy = left != '0;

  always_ff @(posedge clk) begin
    if (start) begin
      rest <= {1'b0, dividend};
      left <= steps;
      quotient <= '0;
    end else if (busy) begin
      rest <= {fits ? less[W-1:0] : rest[W-1:0], ones};
      quotient <= {quotient[QW-2:0], fits};
      left <= left - 1'b1;
    end
    if (reset) left <= '0;
  end
endmodule
