// The vertices of a chain that lie farthest in sixteen directions (src/corner/chain_extremes.h is the definition): one
// vertex a clock, in by two clocks later.
module chain_extremes #(
    parameter XW = 10,
    parameter YW = 9,
    parameter NW = 11
) (
    input  logic          clk,
    input  logic          vertex,         // there is one; the first has number 0
    input  logic [XW-1:0] vertex_x,
    input  logic [YW-1:0] vertex_y,
    input  logic [NW-1:0] vertex_number,
    input  logic [   3:0] at,             // which of the sixteen is shown
    output logic [XW-1:0] x,
    output logic [YW-1:0] y,
    output logic [NW-1:0] number
);
  localparam W = (XW > YW ? XW : YW) + 3;
  logic valid;
  logic [XW-1:0] new_x;
  logic [YW-1:0] new_y;
  logic [NW-1:0] new_number;
  logic signed [W-1:0] reach[0:7];
  wire first = new_number == '0;

  wire signed [W-1:0] wide_x = $signed({{(W - XW) {1'b0}}, vertex_x});
  wire signed [W-1:0] wide_y = $signed({{(W - YW) {1'b0}}, vertex_y});
  always_ff @(posedge clk) begin
    valid <= vertex;
    new_x <= vertex_x;
    new_y <= vertex_y;
    new_number <= vertex_number;
    reach[0] <= wide_x;
    reach[1] <= (wide_x <<< 1) + wide_y;
    reach[2] <= wide_x + wide_y;
    reach[3] <= wide_x + (wide_y <<< 1);
    reach[4] <= wide_y;
    reach[5] <= (wide_y <<< 1) - wide_x;
    reach[6] <= wide_y - wide_x;
    reach[7] <= wide_y - (wide_x <<< 1);
  end

  logic [XW+YW+NW-1:0] farthest[0:15];
  generate
    for (genvar i = 0; i < 8; i++) begin : g_direction
      logic signed [W-1:0] most, least;
      always_ff @(posedge clk) begin
        if (valid && (first || reach[i] > most)) begin
          most <= reach[i];
          farthest[i] <= {new_number, new_y, new_x};
        end
        if (valid && (first || reach[i] < least)) begin
          least <= reach[i];
          farthest[i+8] <= {new_number, new_y, new_x};
        end
      end
    end
  endgenerate
  assign {number, y, x} = farthest[at];
endmodule
