// The contour core: events in raster order in, closed chains out (src/contour/contour_linker.h is its
// definition). The open ends of all chains stand in one queue in the order of their cracks: an event takes
// the cracks of the row above from its head and puts those of the current row at its tail. Straight cracks
// take 1 clock, shifts 3, starts 4, joins that close a chain 6, others 10.
//
// A closed chain's records stay in the pool until the walker has been along it and gives them back. With
// `patient` the core waits for that before it goes on, so that free records do not depend on the walker's pace.
module contour #(
    parameter RECORDS = 1023,
    parameter ENDS = 640,      // the widest image; cannot run out
    parameter QUEUE = 16,      // closed chains that may wait for the walker
    parameter XW = 10,
    parameter YW = 9,
    parameter TW = 5,          // bits of a chain's turns
    parameter RW = $clog2(RECORDS + 1)
) (
    input  logic          clk,
    input  logic          reset,
    input  logic [TW-1:0] max_turns,
    input  logic [YW-1:0] min_height,
    input  logic          holes,
    input  logic          patient,

    input  logic          event_valid,
    output logic          event_ready,
    input  logic [   2:0] event_kind,
    input  logic          event_top,
    input  logic          event_left_above,
    input  logic [XW-1:0] event_x,
    input  logic [YW-1:0] event_y,

    output logic          chain_valid,
    input  logic          chain_ready,
    output logic [RW-1:0] chain_head,
    output logic [RW-1:0] chain_tail,   // the run that closed it
    output logic          chain_hole,
    output logic          chain_end,    // no chain: all chains of a frame have been handed on

    input  logic          walk_read,    // answered in the next clock when granted
    output logic          walk_granted,
    input  logic [RW-1:0] walk_record,
    output logic [XW-1:0] walk_x,
    output logic [YW-1:0] walk_y,
    output logic [RW-1:0] walk_next,
    input  logic          release_valid,
    output logic          release_ready,
    input  logic [RW-1:0] release_head,
    input  logic [RW-1:0] release_tail,

    // Pulses to be counted.
    output logic          count_run,
    output logic          count_closed,
    output logic          count_handed_on,
    output logic          count_dropped_full,
    output logic          count_dropped_rule,
    output logic          count_dropped_queue,
    output logic          count_frame,        // a frame's last chain has been handed on
    output logic          count_abandoned,    // a frame ended with open chains; how many:
    output logic [$clog2(ENDS + 1)-1:0] abandoned,
    output logic [RW-1:0] record_peak,
    output logic [$clog2(ENDS + 1)-1:0] end_peak
);
  localparam EW = $clog2(ENDS + 1);
  localparam AW = $clog2(ENDS);
  localparam [EW-1:0] NO_END = '1;
  localparam [RW-1:0] NO_RECORD = '1;
  localparam CW = $clog2(QUEUE + 4);

  localparam [2:0] STRAIGHT = 3'd0, SHIFT = 3'd1, START = 3'd2, JOIN = 3'd3, BEGIN_FRAME = 3'd4, END_FRAME = 3'd5;

  localparam [4:0] IDLE = 5'd0, SHIFTED = 5'd1, START_LEFT = 5'd2, START_RIGHT = 5'd3, JOIN_LEFT = 5'd4,
      JOIN_RIGHT = 5'd5, JOIN_BOTH = 5'd6, DROP_CLOSED = 5'd7, CONNECT_UP = 5'd8, CONNECT_DOWN = 5'd9,
      CONNECTED = 5'd10, GIVE_UP = 5'd11, JOIN_TOP = 5'd12, CONNECT_SUM = 5'd13,
      CONNECT_OTHER = 5'd14, CLOSED = 5'd15,
      SHIFT_READ = 5'd16, GIVE_READ = 5'd17, START_READ = 5'd18;
  logic [4:0] state;

  // The cracks: open ends in raster order.
  logic clear;
  logic crack_valid, crack_pop, crack_push, crack_room;
  logic [EW-1:0] crack, crack_in;
  stream_fifo #(.WIDTH(EW), .DEPTH(ENDS)) cracks (
      .in_valid(crack_push), .in_ready(crack_room), .in_data(crack_in),
      .out_valid(crack_valid), .out_ready(crack_pop), .out_data(crack), .*);

  // The records.
  logic pool_busy, pool_none, pool_take, pool_link, pool_give;
  logic [RW-1:0] new_record, link_from, link_to, give_head, give_tail;
  record_pool #(.RECORDS(RECORDS), .XW(XW), .YW(YW)) pool (
      .busy(pool_busy), .none(pool_none), .free_record(new_record), .peak(record_peak),
      .take(pool_take), .take_x(event_x), .take_y(event_y), .link(pool_link), .give(pool_give),
      .read(walk_read), .read_granted(walk_granted), .read_record(walk_record),
      .read_x(walk_x), .read_y(walk_y), .read_next(walk_next), .*);

  // The table of open ends. Free ones stand in a list through their partners, always two and two.
  // A dead end has no record.
  logic [EW+RW+TW+YW-1:0] ends[0:ENDS-1];
  logic read_end, write_end;
  logic [EW-1:0] read_at, write_at, write_partner;
  logic [RW-1:0] write_record;
  logic [TW-1:0] write_turns;
  logic [YW-1:0] write_top;
  logic [EW-1:0] q_partner;
  logic [RW-1:0] q_record;
  logic [TW-1:0] q_turns;
  logic [YW-1:0] q_top;
  always_ff @(posedge clk) begin
    if (write_end) ends[write_at[AW-1:0]] <= {write_partner, write_record, write_turns, write_top};
    if (read_end) {q_partner, q_record, q_turns, q_top} <= ends[read_at[AW-1:0]];
  end
  wire q_dead = q_record == NO_RECORD;

  logic [EW-1:0] free_end, untouched_end;
  wire have_free_end = free_end != NO_END;
  assign end_peak = untouched_end;

  // What is kept from one clock of an event to the next.
  logic [EW-1:0] left, right;  // the ends of the event
  logic left_listed;           // a start's left end came from the free list
  logic [EW-1:0] left_partner, up_partner, down_partner;
  logic [RW-1:0] left_record, up_record, down_record;
  logic [TW-1:0] left_turns, up_turns, down_turns;
  logic [YW-1:0] left_top, up_top, down_top;
  logic left_dead, up_dead, down_dead, closes;
  logic [EW-1:0] abandoned_chains;
  logic give_is_tail, give_second;
  logic [RW-1:0] given_record;
  logic [TW:0] joined_turns;  // of the half that takes in the down end
  logic [YW-1:0] joined_top;
  logic [RW-1:0] joined_record;
  logic broken;

  wire append = event_top == event_left_above;
  logic [TW:0] both_turns;  // of a chain that closes: without the run that closes it
  logic [YW-1:0] both_top;
  logic [YW-1:0] height;
  logic obeys;
  logic [TW:0] other_turns;  // of the half that takes in the up end
  logic [YW-1:0] other_top;
  wire [YW-1:0] least_top_down = q_top < down_top ? q_top : down_top;
  wire [YW-1:0] least_top_up = q_top < up_top ? q_top : up_top;

  // Closed chains waiting, and all that the walker has not given back yet.
  logic chain_push, chain_room, chain_push_end;
  logic [CW-1:0] walking;
  logic walk_idle;
  logic [2*RW+1:0] chain_out;
  stream_fifo #(.WIDTH(2 * RW + 2), .DEPTH(QUEUE)) chains (
      .clear(reset), .in_valid(chain_push), .in_ready(chain_room),
      .in_data({chain_push_end, event_top, up_record, given_record}),
      .out_valid(chain_valid), .out_ready(chain_ready), .out_data(chain_out), .*);
  assign {chain_end, chain_hole, chain_head, chain_tail} = chain_out;

  wire waits = patient && !walk_idle;
  wire goes = state == IDLE && event_valid && !waits;
  wire pool_can = !pool_busy;
  wire release_now = release_valid && release_ready;
  wire handed_on = chain_push && chain_room && !chain_push_end;
  logic in_frame;
  assign clear = reset || (goes && event_kind == BEGIN_FRAME && walk_idle && !in_frame);

  always_comb begin
    event_ready = 1'b0;
    crack_pop = 1'b0;
    crack_push = 1'b0;
    crack_in = left;
    read_end = 1'b0;
    read_at = crack;
    write_end = 1'b0;
    write_at = left;
    write_partner = left_partner;
    write_record = new_record;
    write_turns = left_turns;
    write_top = left_top;
    pool_take = 1'b0;
    pool_link = 1'b0;
    pool_give = 1'b0;
    link_from = down_record;
    link_to = new_record;
    give_head = up_record;
    give_tail = down_record;
    chain_push = 1'b0;
    chain_push_end = 1'b0;
    count_run = 1'b0;
    count_closed = 1'b0;
    count_dropped_full = 1'b0;
    count_dropped_rule = 1'b0;
    count_dropped_queue = 1'b0;
    count_abandoned = 1'b0;

    case (state)
      IDLE: if (goes) begin
        case (event_kind)
          STRAIGHT: begin
            crack_pop = 1'b1;
            crack_push = crack_valid;
            crack_in = crack;
            event_ready = crack_valid;
          end
          SHIFT, JOIN: begin
            crack_pop = 1'b1;
            read_end = 1'b1;
          end
          START: begin
            read_end = 1'b1;
            read_at = free_end;
          end
          BEGIN_FRAME: begin
            chain_push = in_frame;  // the frame before was cut off
            chain_push_end = 1'b1;
            event_ready = walk_idle && !in_frame;
            count_abandoned = event_ready && abandoned_chains != '0;
          end
          END_FRAME: begin
            chain_push = 1'b1;
            chain_push_end = 1'b1;
            event_ready = chain_room;
            count_abandoned = chain_room && abandoned_chains != '0;
          end
          default: event_ready = 1'b1;
        endcase
      end

      SHIFTED: begin
        if (left_dead || pool_can) begin
          crack_push = 1'b1;
          event_ready = left_dead || !pool_none;
          count_run = 1'b1;
        end
        if (!left_dead && pool_can) begin
          write_end = 1'b1;
          if (pool_none) begin
            write_record = NO_RECORD;
            read_end = 1'b1;
            read_at = left_partner;
            count_dropped_full = 1'b1;
          end else begin
            pool_take = 1'b1;
            pool_link = 1'b1;
            link_from = append ? left_record : new_record;
            link_to = append ? new_record : left_record;
          end
        end
      end

      START_LEFT: begin
        read_at = right;
        if (pool_can) begin
          pool_take = !pool_none;
          count_dropped_full = pool_none;
          read_end = left_listed;
          write_end = 1'b1;
          write_partner = right;
          write_record = pool_none ? NO_RECORD : new_record;
          write_turns = TW'(1);
          write_top = event_y;
          crack_push = 1'b1;
        end
      end
      START_RIGHT: begin
        write_end = 1'b1;
        write_at = right;
        write_partner = left;
        write_record = given_record;
        write_turns = '0;
        write_top = event_y;
        crack_push = 1'b1;
        crack_in = right;
        event_ready = 1'b1;
        count_run = 1'b1;
      end

      JOIN_LEFT: begin
        crack_pop = 1'b1;
        read_end = crack_valid;
      end
      JOIN_RIGHT: begin
        write_end = 1'b1;
        write_at = left;
        write_partner = free_end;
      end
      JOIN_TOP: begin
      end
      JOIN_BOTH: begin
        write_end = 1'b1;  // the two ends are free: right, left, and those before
        write_at = right;
        write_partner = left;
        read_end = 1'b1;
        read_at = up_dead ? down_partner : down_dead ? up_partner : down_partner;
        if (up_dead && down_dead) begin
          event_ready = 1'b1;
          count_run = 1'b1;
        end else if (up_dead || down_dead) begin
          count_dropped_rule = 1'b1;
        end else if (pool_can) begin
          if (pool_none) begin
            count_dropped_full = 1'b1;
            count_closed = closes;
            pool_give = closes;
            event_ready = closes;
            count_run = closes;
          end else begin
            pool_take = 1'b1;
            pool_link = 1'b1;
            count_closed = closes;
          end
        end
      end
      CLOSED: begin
        chain_push = obeys;
        count_dropped_rule = !obeys;
        count_dropped_queue = obeys && !chain_room;
        event_ready = obeys && chain_room;
        count_run = obeys && chain_room;
      end
      DROP_CLOSED: begin
        give_tail = given_record;
        if (pool_can) begin
          pool_give = 1'b1;
          event_ready = 1'b1;
          count_run = 1'b1;
        end
      end

      CONNECT_UP: begin  // the up end whose half the down end's is added to is being read
        read_at = up_partner;
        link_from = given_record;
        link_to = up_record;
        if (pool_can) begin
          pool_link = 1'b1;
          read_end = 1'b1;
        end
      end
      CONNECT_DOWN, CONNECT_SUM: begin
      end
      CONNECT_OTHER: begin
        write_end = 1'b1;
        write_at = up_partner;
        write_partner = down_partner;
        write_record = broken ? NO_RECORD : given_record;
        write_turns = other_turns[TW-1:0];
        write_top = other_top;
      end
      CONNECTED: begin
        write_end = 1'b1;
        write_at = down_partner;
        write_partner = up_partner;
        write_record = broken ? NO_RECORD : joined_record;
        write_turns = joined_turns[TW-1:0];
        write_top = joined_top;
        give_head = joined_record;
        give_tail = given_record;
        if (!broken || pool_can) begin
          pool_give = broken;
          count_dropped_rule = broken;
          event_ready = 1'b1;
          count_run = 1'b1;
        end
      end

      GIVE_UP: begin  // the other end of a chain that has been given up has been read
        write_end = 1'b1;
        write_at = left_partner;
        write_record = NO_RECORD;
        give_head = give_is_tail ? joined_record : given_record;
        give_tail = give_is_tail ? given_record : joined_record;
        read_at = up_partner;
        if (pool_can) begin
          pool_give = 1'b1;
          read_end = give_second;
          count_dropped_full = give_second;
          event_ready = !give_second;
          // The run of a shift has been counted.
          count_run = !give_second && event_kind == JOIN;
        end
      end
      default: begin
      end
    endcase
  end
  assign count_handed_on = handed_on;
  assign count_frame = chain_push && chain_push_end && chain_room;
  assign abandoned = abandoned_chains;

  always_ff @(posedge clk) begin
    case (state)
      IDLE: if (goes) begin
        case (event_kind)
          SHIFT: if (crack_valid) state <= SHIFT_READ;
          JOIN: if (crack_valid) state <= JOIN_LEFT;
          START: state <= have_free_end ? START_READ : START_LEFT;
          default: ;
        endcase
        left <= event_kind == START ? (have_free_end ? free_end : untouched_end) : crack;
        left_listed <= have_free_end;
        right <= untouched_end + 1'b1;
        if (event_kind == START && !have_free_end) untouched_end <= untouched_end + 1'b1;
      end
      SHIFT_READ: begin
        left_partner <= q_partner;
        left_record <= q_record;
        left_turns <= q_turns;
        left_top <= q_top;
        left_dead <= q_dead;
        state <= SHIFTED;
      end
      SHIFTED: begin
        given_record <= left_record;
        give_is_tail <= append;
        give_second <= 1'b0;
        if (left_dead || pool_can) state <= left_dead || !pool_none ? IDLE : GIVE_READ;
      end
      START_READ: begin
        right <= q_partner;
        state <= START_LEFT;
      end
      START_LEFT: if (pool_can) begin
        if (!left_listed) untouched_end <= untouched_end + 1'b1;
        given_record <= pool_none ? NO_RECORD : new_record;
        state <= START_RIGHT;
      end
      START_RIGHT: begin
        if (left_listed) free_end <= q_partner;
        state <= IDLE;
      end
      JOIN_LEFT: begin
        left_partner <= q_partner;
        left_record <= q_record;
        left_turns <= q_turns;
        left_top <= q_top;
        left_dead <= q_dead;
        right <= crack;
        if (crack_valid) state <= JOIN_RIGHT;
      end
      JOIN_RIGHT: begin
        down_partner <= event_top ? left_partner : q_partner;
        down_record <= event_top ? left_record : q_record;
        down_turns <= event_top ? left_turns : q_turns;
        down_top <= event_top ? left_top : q_top;
        down_dead <= event_top ? left_dead : q_dead;
        up_partner <= event_top ? q_partner : left_partner;
        up_record <= event_top ? q_record : left_record;
        up_turns <= event_top ? q_turns : left_turns;
        up_top <= event_top ? q_top : left_top;
        up_dead <= event_top ? q_dead : left_dead;
        both_top <= q_top < left_top ? q_top : left_top;
        closes <= !left_dead && !q_dead && left_partner == right;
        state <= JOIN_TOP;
      end
      JOIN_TOP: begin
        both_turns <= {1'b0, up_turns} + {1'b0, down_turns};
        height <= event_y - both_top;
        state <= JOIN_BOTH;
      end
      JOIN_BOTH: begin
        give_second <= 1'b0;
        obeys <= both_turns < {1'b0, max_turns} && height >= min_height && (holes || !event_top);
        left_partner <= up_dead ? down_partner : down_dead ? up_partner : down_partner;
        if (up_dead && down_dead) begin
          state <= IDLE;
        end else if (up_dead || down_dead) begin
          give_is_tail <= up_dead;
          given_record <= up_dead ? down_record : up_record;
          state <= GIVE_READ;
        end else if (pool_can) begin
          if (pool_none) begin
            give_is_tail <= 1'b1;
            given_record <= down_record;
            give_second <= 1'b1;
            state <= closes ? IDLE : GIVE_READ;
          end else begin
            given_record <= new_record;
            state <= closes ? CLOSED : CONNECT_UP;
          end
        end
        free_end <= right;
      end
      CLOSED: state <= obeys && chain_room ? IDLE : DROP_CLOSED;
      DROP_CLOSED: if (pool_can) state <= IDLE;
      CONNECT_UP: if (pool_can) begin
        joined_record <= q_record;
        joined_turns <= {1'b0, q_turns} + {1'b0, down_turns} + 1'b1;
        joined_top <= least_top_down;
        state <= CONNECT_DOWN;
      end
      CONNECT_DOWN: begin
        given_record <= q_record;
        other_turns <= {1'b0, q_turns} + {1'b0, up_turns};
        other_top <= least_top_up;
        state <= CONNECT_SUM;
      end
      CONNECT_SUM: begin
        broken <= {1'b0, other_turns} + {1'b0, joined_turns} > {2'b0, max_turns};
        state <= CONNECT_OTHER;
      end
      CONNECT_OTHER: state <= CONNECTED;
      CONNECTED: if (!broken || pool_can) state <= IDLE;
      GIVE_READ: begin
        joined_record <= q_record;
        state <= GIVE_UP;
      end
      GIVE_UP: if (pool_can) begin
        give_second <= 1'b0;
        give_is_tail <= 1'b0;
        given_record <= up_record;
        left_partner <= up_partner;
        state <= give_second ? GIVE_READ : IDLE;
      end
      default: state <= IDLE;
    endcase

    if (goes && event_kind == START) abandoned_chains <= abandoned_chains + 1'b1;
    if (state == JOIN_LEFT && crack_valid) abandoned_chains <= abandoned_chains - 1'b1;

    if (handed_on != release_now) walking <= handed_on ? walking + 1'b1 : walking - 1'b1;
    walk_idle <= handed_on ? 1'b0 : walking == '0 || (walking == CW'(1) && release_now);

    if (goes && event_kind == BEGIN_FRAME && event_ready) in_frame <= 1'b1;
    else if (count_frame) in_frame <= 1'b0;

    if (clear || count_abandoned) abandoned_chains <= '0;
    if (clear) begin
      free_end <= NO_END;
      untouched_end <= '0;
    end
    if (reset) begin
      state <= IDLE;
      walking <= '0;
      in_frame <= 1'b0;
      walk_idle <= 1'b1;
    end
  end

`ifdef VERILATOR
  always_ff @(posedge clk) begin
    if (crack_push && !crack_room) $error("contour: the crack queue is full");
  end
`endif
endmodule
