// The paper's corner core (src/corner/corner_state_machine.h is its definition): walks a closed chain twice, in
// two clocks a record, and hands on its corners when there are four. The chain's records are given back when the
// walk is over, before the pattern core looks at the pixels.
//
// Of the paper's two counters only the one across the direction of travel is ever read, and it begins anew at
// every corner, so there is one. An offset that has made no corner is below the threshold: nothing saturates.
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
  localparam SW = (W > 10 ? W : 10) + 1;  // of an offset and a step together

  localparam [3:0] IDLE = 4'd0, TAIL = 4'd1, READ = 4'd2, UPRIGHT = 4'd3, LEVEL = 4'd4, RELEASE = 4'd5, LAST = 4'd6,
      COUNT = 4'd7, EMIT = 4'd8;
  logic [3:0] state;
  logic second_round;
  logic [RW-1:0] head, tail, record;
  logic hole;

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

  // One move a clock, upright or level: first where it goes, then how far, then what it does to the offset.
  logic [XW-1:0] at_x, to_x, from_x;
  logic [YW-1:0] at_y, to_y, from_y;
  logic signed [W-1:0] step;
  logic came, came_last;      // a record was read in the clock before; it ends the first round
  logic stepped, step_level, step_last, level_next, last_next;

  // How much further the offset may go in either direction without making a corner: negative when it has.
  logic upright;  // travelling up or down
  logic signed [SW-1:0] room_up, room_down;
  logic [2:0] corners;  // saturates at 5
  logic [XW-1:0] corner_x[0:3];
  logic [YW-1:0] corner_y[0:3];
  wire signed [SW-1:0] whole_room = $signed({{(SW - 8) {1'b0}}, threshold}) - 1'b1;
  logic signed [SW-1:0] room;  // of a new offset
  wire across = upright == step_level;
  wire signed [SW-1:0] change = across ? SW'(step) : '0;
  wire signed [SW-1:0] new_up = room_up - change;
  wire signed [SW-1:0] new_down = room_down + change;
  wire turns = stepped && (new_up[SW-1] || new_down[SW-1]);

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
        second_round <= 1'b0;
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
        if (tail_read) begin
          quad_bottom <= walk_y;
          state <= READ;
        end else begin
          record_to_read <= at_tail ? head : walk_next;
          state <= LEVEL;
        end
      end
      LEVEL: begin
        record <= record_to_read;
        second_round <= second_round || at_tail;
        state <= last ? RELEASE : walk_granted ? UPRIGHT : READ;
      end
      RELEASE: if (release_ready) state <= LAST;
      LAST: state <= COUNT;  // the last move is still on its way
      COUNT: state <= corners == 3'd4 ? EMIT : IDLE;
      default: if (quad_ready) state <= IDLE;
    endcase
    if (reset) state <= IDLE;
  end

  always_ff @(posedge clk) begin
    // Where to.
    came <= state == UPRIGHT && !tail_read;
    came_last <= at_tail && !second_round;
    if (state == UPRIGHT) begin
      to_x <= walk_x;
      to_y <= walk_y;
      if (tail_read) begin
        at_x <= walk_x;
        at_y <= walk_y;
      end
    end

    // How far, from where: upright first.
    stepped <= came || level_next;
    step_level <= level_next;
    step_last <= level_next && last_next;
    level_next <= came;
    last_next <= came_last;
    from_x <= at_x;
    from_y <= at_y;
    if (came) begin
      step <= W'($signed({{(W - YW) {1'b0}}, to_y}) - $signed({{(W - YW) {1'b0}}, at_y}));
      at_y <= to_y;
    end else if (level_next) begin
      step <= W'($signed({{(W - XW) {1'b0}}, to_x}) - $signed({{(W - XW) {1'b0}}, at_x}));
      at_x <= to_x;
    end

    // The offset.
    room <= whole_room;
    if (state == IDLE) begin
      room_up <= whole_room;
      room_down <= whole_room;
      upright <= 1'b1;
      corners <= '0;
    end else if (stepped) begin
      room_up <= turns ? room : new_up;
      room_down <= turns ? room : new_down;
      upright <= upright != turns;
      if (turns && corners < 3'd4) begin
        corner_x[corners[1:0]] <= from_x;
        corner_y[corners[1:0]] <= from_y;
      end
      if (step_last) corners <= '0;
      else if (turns && corners < 3'd5) corners <= corners + 1'b1;
    end
    if (reset) begin
      came <= 1'b0;
      level_next <= 1'b0;
      stepped <= 1'b0;
    end
  end

  assign quad_x = {corner_x[3], corner_x[2], corner_x[1], corner_x[0]};
  assign quad_y = {corner_y[3], corner_y[2], corner_y[1], corner_y[0]};
  assign quad_hole = hole;
endmodule
