// The paper's corner core (src/corner/corner_state_machine.h is its definition): walks a closed chain twice, in
// two clocks a record, and hands on its corners when there are four. The chain's records are given back when the
// walk is over, before the pattern core looks at the pixels.
//
// Of the paper's two counters only the one across the direction of travel is ever read, and it begins anew at
// every corner, so there is one.
module corner #(
    parameter XW = 10,
    parameter YW = 9,
    parameter RW = 10
) (
    input  logic            clk,
    input  logic            reset,
    input  logic [     7:0] threshold,    // pixels across the direction of travel that make a corner

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
    output logic [4*XW-1:0] quad_x,       // in the order of the chain, the first in the low bits
    output logic [4*YW-1:0] quad_y,
    output logic [  YW-1:0] quad_bottom,  // crack line on which the chain closed
    output logic            quad_hole,
    output logic            quad_end      // no quad: the frame's last has been handed on
);
  localparam W = (XW > YW ? XW : YW) + 1;

  localparam [2:0] IDLE = 3'd0, TAIL = 3'd1, READ = 3'd2, UPRIGHT = 3'd3, LEVEL = 3'd4, RELEASE = 3'd5, EMIT = 3'd6;
  logic [2:0] state;
  logic second_round;
  logic [RW-1:0] head, tail, record;
  logic hole;

  logic [XW-1:0] at_x, to_x;
  logic [YW-1:0] at_y;
  logic upright;  // travelling up or down
  logic signed [8:0] offset;
  logic [2:0] corners;  // saturates at 5
  logic [XW-1:0] corner_x[0:3];
  logic [YW-1:0] corner_y[0:3];

  // One move, upright or level; it adds to the offset when it lies across the direction of travel.
  wire moves = state == UPRIGHT || state == LEVEL;
  wire across = upright == (state == LEVEL);
  wire signed [W-1:0] step = state == LEVEL ? $signed({{(W - XW) {1'b0}}, to_x}) - $signed({{(W - XW) {1'b0}}, at_x})
                                            : $signed({{(W - YW) {1'b0}}, walk_y}) - $signed({{(W - YW) {1'b0}}, at_y});
  wire signed [W+1:0] sum = (W + 2)'(step) + (W + 2)'(offset);
  wire signed [8:0] saturated = sum > (W + 2)'(255) ? 9'sd255 : sum < -(W + 2)'(255) ? -9'sd255 : sum[8:0];
  wire signed [8:0] new_offset = across ? saturated : offset;
  wire [8:0] distance = new_offset[8] ? -new_offset : new_offset;
  wire turns = distance >= {1'b0, threshold};

  wire at_tail = record == tail;
  wire last = at_tail && second_round;
  assign walk_read = state == TAIL || state == READ || (state == LEVEL && !last);
  logic [RW-1:0] record_to_read;
  assign walk_record = record_to_read;
  logic tail_read;  // the answer is the tail, from which the walk sets out
  assign release_valid = state == RELEASE;
  assign release_head = head;
  assign release_tail = tail;
  assign chain_ready = state == IDLE;
  assign quad_valid = state == EMIT;

  always_ff @(posedge clk) begin
    case (state)
      IDLE: begin
        head <= chain_head;
        tail <= chain_tail;
        hole <= chain_hole;
        quad_end <= chain_end;
        record_to_read <= chain_tail;
        if (chain_valid) state <= chain_end ? EMIT : TAIL;
        tail_read <= 1'b1;
        upright <= 1'b1;
        offset <= '0;
        second_round <= 1'b0;
        corners <= '0;
      end
      TAIL: if (walk_granted) begin
        record_to_read <= head;
        state <= UPRIGHT;
      end
      READ: if (walk_granted) begin
        record <= record_to_read;
        state <= UPRIGHT;
      end
      UPRIGHT: begin
        tail_read <= 1'b0;
        at_y <= walk_y;
        to_x <= walk_x;
        if (tail_read) begin
          at_x <= walk_x;
          quad_bottom <= walk_y;
          state <= READ;
        end else begin
          record_to_read <= at_tail ? head : walk_next;
          state <= LEVEL;
        end
      end
      LEVEL: begin
        at_x <= to_x;
        record <= record_to_read;
        second_round <= second_round || at_tail;
        state <= last ? RELEASE : walk_granted ? UPRIGHT : READ;
      end
      RELEASE: if (release_ready) state <= corners == 3'd4 ? EMIT : IDLE;
      default: if (quad_ready) state <= IDLE;
    endcase

    if (moves && !tail_read) begin
      offset <= turns ? '0 : new_offset;
      if (turns) begin
        upright <= !upright;
        if (corners < 3'd5) corners <= corners + 1'b1;
        if (corners < 3'd4) begin
          corner_x[corners[1:0]] <= at_x;
          corner_y[corners[1:0]] <= at_y;
        end
      end
      if (state == LEVEL && at_tail && !second_round) corners <= '0;
    end
    if (reset) state <= IDLE;
  end

  assign quad_x = {corner_x[3], corner_x[2], corner_x[1], corner_x[0]};
  assign quad_y = {corner_y[3], corner_y[2], corner_y[1], corner_y[0]};
  assign quad_hole = hole;
endmodule
