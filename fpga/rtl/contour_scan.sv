// Binary pixels in, closed chains out: the pre-process core, the queue of its events and the contour core,
// as src/pipeline/contour_scan.h puts them together.
module contour_scan #(
    parameter MAX_WIDTH = 640,
    parameter MAX_HEIGHT = 480,
    parameter RECORDS = 1023,
    parameter EVENTS = 512,
    parameter QUEUE = 16,
    parameter XW = $clog2(MAX_WIDTH),
    parameter YW = $clog2(MAX_HEIGHT),
    parameter TW = 5,
    parameter RW = $clog2(RECORDS + 1),
    parameter EW = $clog2(MAX_WIDTH + 1)
) (
    input  logic          clk,
    input  logic          reset,
    input  logic [XW-1:0] last_x,
    input  logic [YW-1:0] last_y,
    input  logic [   5:0] cases,
    input  logic          eight,
    input  logic          give_up,
    input  logic [TW-1:0] max_turns,
    input  logic [YW-1:0] min_height,
    input  logic          holes,
    input  logic          patient,

    input  logic          in_valid,
    output logic          in_ready,
    input  logic          in_dark,
    input  logic          in_sof,

    output logic          chain_valid,
    input  logic          chain_ready,
    output logic [RW-1:0] chain_head,
    output logic [RW-1:0] chain_tail,
    output logic          chain_hole,
    output logic          chain_end,
    input  logic          walk_read,
    output logic          walk_granted,
    input  logic [RW-1:0] walk_record,
    output logic [XW-1:0] walk_x,
    output logic [YW-1:0] walk_y,
    output logic [RW-1:0] walk_next,
    input  logic          release_valid,
    output logic          release_ready,
    input  logic [RW-1:0] release_head,
    input  logic [RW-1:0] release_tail,

    output logic          lost,
    output logic          count_run,
    output logic          count_closed,
    output logic          count_handed_on,
    output logic          count_dropped_full,
    output logic          count_dropped_rule,
    output logic          count_dropped_queue,
    output logic          count_frame,
    output logic          count_abandoned,
    output logic [EW-1:0] abandoned,
    output logic [RW-1:0] record_peak,
    output logic [EW-1:0] end_peak
);
  localparam WIDTH = 5 + XW + YW;
  logic found_valid, found_ready, found_top, found_left_above;
  logic [2:0] found_kind;
  logic [XW-1:0] found_x;
  logic [YW-1:0] found_y;
  preprocess #(.MAX_WIDTH(MAX_WIDTH), .MAX_HEIGHT(MAX_HEIGHT)) preprocess_i (
      .out_valid(found_valid), .out_ready(found_ready), .out_kind(found_kind), .out_top(found_top),
      .out_left_above(found_left_above), .out_x(found_x), .out_y(found_y), .*);

  logic event_valid, event_ready, event_top, event_left_above;
  logic [2:0] event_kind;
  logic [XW-1:0] event_x;
  logic [YW-1:0] event_y;
  stream_fifo #(.WIDTH(WIDTH), .DEPTH(EVENTS)) events (
      .clear(reset), .in_valid(found_valid), .in_ready(found_ready),
      .in_data({found_kind, found_top, found_left_above, found_x, found_y}),
      .out_valid(event_valid), .out_ready(event_ready),
      .out_data({event_kind, event_top, event_left_above, event_x, event_y}), .*);

  contour #(.RECORDS(RECORDS), .ENDS(MAX_WIDTH), .QUEUE(QUEUE), .XW(XW), .YW(YW), .TW(TW)) contour_i (.*);
endmodule
