// The vertices of a chain that lie farthest in sixteen directions (src/corner/chain_extremes.h is the definition). Runs
// of cracks come in, eight clocks each: a direction and its opposite a clock. Of a run's two vertices only the one that
// lies farther can count, or the first where neither does.
module chain_extremes #(
    parameter XW = 10,
    parameter YW = 9,
    parameter NW = 11
) (
    input  logic          clk,
    input  logic          reset,
    input  logic          run,         // while not busy
    output logic          busy,
    output logic          settled,     // all runs are in
    input  logic [XW-1:0] run_from,
    input  logic [XW-1:0] run_to,
    input  logic [YW-1:0] run_y,
    input  logic [NW-1:0] run_number,  // of its first vertex: even
    input  logic [   3:0] at,          // which of the sixteen is shown a clock later
    output logic [XW-1:0] x,
    output logic [YW-1:0] y,
    output logic [NW-1:0] number
);
  localparam W = (XW > YW ? XW : YW) + 3;
  logic [3:0] step;
  assign busy = !step[3] && step[2:0] != 3'd7;
  logic [XW-1:0] from, to;
  logic [YW-1:0] level;
  logic [NW-1:1] pair;
  logic rightwards, leftwards;
  // Which vertex lies farther in this direction, which in the opposite one; neither along y.
  wire along_y = step[2:0] == 3'd4;
  wire most_second = !along_y && (step[2] ? leftwards : rightwards);
  wire least_second = !along_y && (step[2] ? rightwards : leftwards);

  // How far they lie.
  logic valid_1, valid_2;
  logic [2:0] way_1, way_2;
  logic [YW-1:0] level_1, level_2;
  logic [NW-1:1] pair_1, pair_2;
  logic [XW:0] most_1, most_2, least_1, least_2;  // {second, x}
  logic signed [W-1:0] most_reach, least_reach;
  assign settled = step[3] && !valid_1 && !valid_2;
  // x, 2 x + y, x + y, x + 2 y, y, 2 y - x, y - x, y - 2 x
  function automatic [W-1:0] x_part(input [2:0] way, input [XW-1:0] v);
    x_part = ((way == 3'd1 || way == 3'd7 ? W'({v, 1'b0}) : W'(v)) & {W{way != 3'd4}}) ^ {W{way[2]}};
  endfunction
  wire [W-1:0] y_part = (way_1 == 3'd3 || way_1 == 3'd5 ? W'({level_1, 1'b0}) : W'(level_1)) & {W{way_1 != '0}};
  wire [W:0] most_sum = {x_part(way_1, most_1[XW-1:0]), 1'b1} + {y_part, way_1[2]};
  wire [W:0] least_sum = {x_part(way_1, least_1[XW-1:0]), 1'b1} + {y_part, way_1[2]};

  logic signed [W-1:0] most[0:7];
  logic signed [W-1:0] least[0:7];
  logic [XW+YW+NW-1:0] most_point[0:7];
  logic [XW+YW+NW-1:0] least_point[0:7];
  wire first = pair_2 == '0;
  wire more = valid_2 && (first || most_reach > most[way_2]);
  wire less = valid_2 && (first || least_reach < least[way_2]);

  always_ff @(posedge clk) begin
    {number, y, x} <= at[3] ? least_point[at[2:0]] : most_point[at[2:0]];
    if (run) begin
      {from, to, level, pair} <= {run_from, run_to, run_y, run_number[NW-1:1]};
      rightwards <= run_to > run_from;
      leftwards <= run_to < run_from;
      step <= '0;
    end else if (!step[3]) begin
      step <= step + 1'b1;
    end
    {valid_1, way_1, level_1, pair_1} <= {!step[3], step[2:0], level, pair};
    most_1 <= {most_second, most_second ? to : from};
    least_1 <= {least_second, least_second ? to : from};
    {valid_2, way_2, level_2, pair_2, most_2, least_2} <= {valid_1, way_1, level_1, pair_1, most_1, least_1};
    most_reach <= $signed(most_sum[W:1]);
    least_reach <= $signed(least_sum[W:1]);
    if (more) begin
      most[way_2] <= most_reach;
      most_point[way_2] <= {pair_2, most_2[XW], level_2, most_2[XW-1:0]};
    end
    if (less) begin
      least[way_2] <= least_reach;
      least_point[way_2] <= {pair_2, least_2[XW], level_2, least_2[XW-1:0]};
    end
    if (reset) begin
      step <= 4'd8;
      valid_1 <= 1'b0;
    end
  end
  wire unused = &{1'b0, run_number[0], most_sum[0], least_sum[0]};
endmodule
