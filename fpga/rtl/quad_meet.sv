// The corners of a quadrilateral: each side's line meets the one before (`meet` in src/corner/side_fit.h), not too far
// from its rough corner. `from` is the rough corner in hand.
module quad_meet #(
    parameter XW = 10,
    parameter YW = 9,
    parameter SW = XW + 6,
    parameter MW = 22,
    parameter PW = MW + 18,
    parameter DW = 36
) (
    input  logic                 clk,
    input  logic                 reset,
    input  logic                 line_write,
    input  logic        [   1:0] line_side,
    input  logic                 line_across,
    input  logic signed [SW-1:0] line_x,
    input  logic signed [SW-1:0] line_y,
    input  logic signed [  16:0] line_slope,

    input  logic                 start,
    output logic                 done,
    output logic                 failed,
    input  logic                 hole,       // is followed the other way round
    input  logic        [XW-1:0] from_x,
    input  logic        [YW-1:0] from_y,
    output logic                 advance,    // on to the next corner
    input  logic        [XW+3:0] perimeter,
    output logic        [4*SW-1:0] corners_x,
    output logic        [4*SW-1:0] corners_y,

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
  localparam FAR = XW + 5;  // bits of a distance in sixteenths that no image is wide
  localparam [3:0] REST = 4'd0, SINE_1 = 4'd1, SINE_2 = 4'd2, APART_1 = 4'd3, APART_2 = 4'd4, SIZE = 4'd5, REACH = 4'd6,
      ALONG_1 = 4'd7, ALONG_2 = 4'd8, PLACE_X = 4'd9, PLACE_Y = 4'd10, OFF_X = 4'd11, OFF_Y = 4'd12, NEAR = 4'd13;
  logic [3:0] state;
  logic [1:0] side;

  // The line before and that of the side. A direction's longer part is one.
  localparam LW = 2 * SW + 18;
  localparam signed [16:0] ONE = 17'sd16384;
  logic [LW-1:0] lines[0:3];
  always_ff @(posedge clk) if (line_write) lines[line_side] <= {line_across, line_slope, line_y, line_x};
  wire [LW-1:0] line_seen = lines[state == REST ? 2'd3 : side];
  logic a_across;
  logic signed [SW-1:0] a_x, a_y;
  logic signed [16:0] a_slope;
  wire b_across = line_seen[LW-1];
  wire signed [16:0] b_slope = $signed(line_seen[LW-2-:17]);
  wire signed [SW-1:0] b_x = $signed(line_seen[SW-1:0]);
  wire signed [SW-1:0] b_y = $signed(line_seen[2*SW-1:SW]);

  wire down = state == SINE_2 || state == APART_2 || state == ALONG_2 || state == PLACE_Y;  // y, not x
  wire signed [16:0] a_part = a_across != down ? ONE : a_slope;
  // Of the line of the side, y, then the opposite of x.
  wire signed [16:0] b_part = b_across != down ? b_slope : ONE;
  wire [17:0] b_crosswise_1 = {b_part ^ {17{down}}, 1'b1} + {17'b0, down};
  wire signed [16:0] b_crosswise = $signed(b_crosswise_1[17:1]);
  logic signed [SW:0] apart;  // x, then y

  logic [19:0] sine;  // its size, later
  wire [20:0] sine_size = {sine ^ {20{sine[19]}}, 1'b1} + {20'b0, sine[19]};
  logic turned;
  logic signed [SW+3:0] place, off;
  wire signed [SW+3:0] whole = product[SW+17:14];
  // Down plus across, less two pixels.
  logic signed [SW+5:0] off_all;
  wire [SW+6:0] off_more = {off_all, 1'b1} + {2'b0, off ^ {(SW + 4) {off[SW+3]}}, off[SW+3]};
  wire far = off_all > $signed((SW + 6)'(perimeter));
  wire [1:0] corner = hole ? ~side : side;
  logic signed [SW-1:0] out_x[0:3];
  logic signed [SW-1:0] out_y[0:3];
  assign corners_x = {out_x[3], out_x[2], out_x[1], out_x[0]};
  assign corners_y = {out_y[3], out_y[2], out_y[1], out_y[0]};
  // A crack lies half a pixel before the centre of the pixel behind it.
  wire signed [SW-1:0] centred = place[SW-1:0] - SW'(8);

  always_comb begin
    {f, g, add} = '0;
    case (state)
      SINE_1, SINE_2: {f, g} = {MW'(a_part), 18'(b_crosswise)};
      APART_1, APART_2: {f, g} = {MW'(apart), 18'(b_crosswise)};
      ALONG_1, ALONG_2: {f, g} = {MW'(result), 18'(a_part)};
      default: ;
    endcase
    add = state == SINE_2 || state == APART_2;
    {divide, dividend, divisor, steps, opposite} = '0;
    if (state == REACH) begin
      divide = 1'b1;
      dividend = DW'(product) <<< 2;
      divisor = DW'(sine) << FAR;
      steps = 5'(FAR + 1);
      opposite = turned;
    end
  end

  assign advance = state == NEAR;
  always_ff @(posedge clk) begin
    done <= 1'b0;
    failed <= 1'b0;
    apart <= state == APART_1 ? (SW + 1)'(b_y) - (SW + 1)'(a_y) : (SW + 1)'(b_x) - (SW + 1)'(a_x);
    if (state == REST || state == NEAR) {a_across, a_slope, a_y, a_x} <= line_seen;
    case (state)
      REST: begin
        side <= '0;
        if (start) state <= SINE_1;
      end
      SINE_1: begin
        off_all <= (SW + 6)'(-32);
        state <= SINE_2;
      end
      SINE_2: state <= APART_1;
      APART_1: state <= APART_2;
      APART_2: begin
        sine <= product[31:12];
        state <= SIZE;
      end
      SIZE: begin
        sine <= sine_size[20:1];
        turned <= sine[19];
        state <= REACH;
      end
      REACH: begin
        failed <= sine < 20'd4096;
        state <= sine < 20'd4096 ? REST : ALONG_1;
      end
      ALONG_1: if (!dividing) begin
        failed <= quotient[FAR];
        state <= quotient[FAR] ? REST : ALONG_2;
      end
      ALONG_2: state <= PLACE_X;
      PLACE_X: begin
        place <= (SW + 4)'(a_x) + whole;
        state <= PLACE_Y;
      end
      PLACE_Y: begin
        place <= (SW + 4)'(a_y) + whole;
        out_x[corner] <= centred;
        off <= place - $signed({{(SW - XW) {1'b0}}, from_x, 4'b0});
        state <= OFF_X;
      end
      OFF_X: begin
        out_y[corner] <= centred;
        off <= place - $signed({{(SW - YW) {1'b0}}, from_y, 4'b0});
        off_all <= $signed(off_more[SW+6:1]);
        state <= OFF_Y;
      end
      OFF_Y: begin
        off_all <= $signed(off_more[SW+6:1]);
        state <= NEAR;
      end
      default: begin
        side <= side + 1'b1;
        done <= !far && side == 2'd3;
        failed <= far;
        state <= far || side == 2'd3 ? REST : SINE_1;
      end
    endcase
    if (reset) state <= REST;
  end
  wire unused = &{1'b0, product[PW-1:SW+20], off_more[0], b_crosswise_1[0], sine_size[0]};
endmodule
