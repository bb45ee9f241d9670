// Divides as one does on paper: the dividend comes down bit by bit, a bit of the quotient a clock. `divisor` must stay
// until the quotient is there. The quotient has QW bits; where more are needed its first is set all the same, so that
// one bit more than is wanted shows that it is too large.
module long_divider #(
    parameter W = 24,
    parameter QW = 17
) (
    input  logic            clk,
    input  logic            reset,
    input  logic            start,
    input  logic [W+QW-2:0] dividend,
    input  logic [   W-1:0] divisor,
    output logic            busy,
    output logic [  QW-1:0] quotient
);
  // The rest, and below it what of the dividend has not come down; the quotient moves in from the other end.
  logic [W:0] rest;
  logic [QW-1:0] low;
  logic [QW-1:0] left;  // one bit, moving
  wire [W+1:0] less = {1'b0, rest} - {2'b0, divisor};
  wire fits = !less[W+1];
  assign busy = left != '0;
  assign quotient = low;

  always_ff @(posedge clk) begin
    if (start) begin
      rest <= {1'b0, dividend[W+QW-2:QW-1]};
      low <= {dividend[QW-2:0], 1'b0};
      left <= QW'(1);
    end else if (busy) begin
      rest <= {fits ? less[W-1:0] : rest[W-1:0], low[QW-1]};
      low <= {low[QW-2:0], fits};
      left <= left << 1;
    end
    if (reset) left <= '0;
  end
endmodule
