// The records of all chains: where each run is left, and which record comes next. Free records stand in a
// list through `next`; those never used since the last clear are free without being in it, so that their
// number is also the most that were ever in use. One operation of the contour core a clock; the walker of
// closed chains reads and gives back in the clocks between.
module record_pool #(
    parameter RECORDS = 1023,  // the index of all ones is no record
    parameter XW = 10,
    parameter YW = 9,
    parameter RW = $clog2(RECORDS + 1)
) (
    input  logic          clk,
    input  logic          clear,
    output logic          busy,          // none of the operations below in this clock
    output logic          none,          // no record is free
    output logic [RW-1:0] free_record,   // the one that `take` takes
    output logic [RW-1:0] peak,
    input  logic          take,
    input  logic [XW-1:0] take_x,
    input  logic [YW-1:0] take_y,
    input  logic          link,          // may come with take
    input  logic [RW-1:0] link_from,
    input  logic [RW-1:0] link_to,
    input  logic          give,          // a whole list
    input  logic [RW-1:0] give_head,
    input  logic [RW-1:0] give_tail,
    // The walker: `read` is answered in the next clock when it was granted.
    input  logic          read,
    output logic          read_granted,
    input  logic [RW-1:0] read_record,
    output logic [XW-1:0] read_x,
    output logic [YW-1:0] read_y,
    output logic [RW-1:0] read_next,
    input  logic          release_valid,
    output logic          release_ready,
    input  logic [RW-1:0] release_head,
    input  logic [RW-1:0] release_tail
);
  localparam [RW-1:0] NONE = '1;

  logic [XW+YW-1:0] place[0:RECORDS-1];
  logic [RW-1:0] next[0:RECORDS-1];

  logic [RW-1:0] free_head, untouched;
  logic have_free, have_untouched, refill;
  assign busy = refill;
  assign none = !have_free && !have_untouched;
  assign free_record = have_free ? free_head : untouched;
  assign peak = untouched;

  wire take_free = take && have_free;
  assign read_granted = !take_free;
  assign release_ready = !refill && !take && !link && !give;
  wire gives = give || (release_valid && release_ready);
  wire [RW-1:0] gives_head = give ? give_head : release_head;
  wire [RW-1:0] gives_tail = give ? give_tail : release_tail;

  always_ff @(posedge clk) begin
    if (take) place[free_record] <= {take_y, take_x};
    if (read) {read_y, read_x} <= place[read_record];
  end

  wire write_next = gives || link;
  wire [RW-1:0] write_at = link ? link_from : gives_tail;
  wire [RW-1:0] write_data = link ? link_to : have_free ? free_head : NONE;
  always_ff @(posedge clk) begin
    if (write_next) next[write_at] <= write_data;
    if (take_free || read) read_next <= next[take_free ? free_head : read_record];
  end

  always_ff @(posedge clk) begin
    if (clear) begin
      have_free <= 1'b0;
      have_untouched <= 1'b1;
      untouched <= '0;
      refill <= 1'b0;
    end else begin
      refill <= take_free;
      if (take && !have_free) begin
        untouched <= untouched + 1'b1;
        have_untouched <= untouched != RW'(RECORDS - 1);
      end
      if (take_free) have_free <= 1'b0;
      if (refill) begin
        have_free <= read_next != NONE;
        free_head <= read_next;
      end else if (gives) begin
        have_free <= 1'b1;
        free_head <= gives_head;
      end
    end
  end
endmodule
