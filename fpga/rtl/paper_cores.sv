// The five cores of the paper in a row: pixels in, markers out. Grey levels go out beside the pixels to be kept
// until the pattern core asks for some of them; by whom and where is not these cores' business.
module paper_cores #(
    parameter MAX_WIDTH = 640,
    parameter MAX_HEIGHT = 480,
    parameter RECORDS = 1023,
    parameter EVENTS = 512,
    parameter QUEUE = 16,     // closed chains, and quads, that may wait
    parameter CODES = 1024,
    parameter XW = $clog2(MAX_WIDTH),
    parameter YW = $clog2(MAX_HEIGHT),
    parameter TW = 5,
    parameter IW = $clog2(CODES),
    parameter RW = $clog2(RECORDS + 1),
    parameter EW = $clog2(MAX_WIDTH + 1)
) (
    input  logic            clk,
    input  logic            reset,
    input  logic [  XW-1:0] last_x,
    input  logic [  YW-1:0] last_y,
    input  logic [     8:0] level,
    input  logic            above_is_dark,
    input  logic            rgb,
    input  logic [     5:0] cases,
    input  logic            eight,
    input  logic            give_up,
    input  logic [  TW-1:0] max_turns,
    input  logic [  YW-1:0] min_height,
    input  logic            holes,
    input  logic            patient,
    input  logic [     7:0] corner_offset,
    input  logic [XW+YW+1:0] min_area,
    input  logic [XW+YW+1:0] max_area,
    input  logic [     5:0] max_errors,
    input  logic [    IW:0] codes,
    input  logic            code_write,
    input  logic [  IW-1:0] code_at,
    input  logic [    35:0] code,

    input  logic            in_valid,
    output logic            in_ready,
    input  logic [    23:0] in_data,
    input  logic            in_sof,

    output logic            grey_valid,
    input  logic            grey_ready,
    output logic [     7:0] grey_level,
    output logic            grey_sof,

    output logic            read_valid,
    input  logic            read_ready,
    output logic [  XW-1:0] read_x,
    output logic [  YW-1:0] read_y,
    input  logic            answer_valid,
    input  logic [     7:0] answer,

    output logic            marker_valid,
    input  logic            marker_ready,
    output logic [4*XW-1:0] marker_x,
    output logic [4*YW-1:0] marker_y,
    output logic [  YW-1:0] marker_bottom,
    output logic            marker_hole,
    output logic [  IW-1:0] marker_id,
    output logic [     1:0] marker_rotation,
    output logic [     5:0] marker_errors,
    output logic            marker_end,

    output logic            scan_begins,  // pulse: a frame's first pixel has reached the preprocess core
    output logic            lost,
    output logic            count_quad,
    output logic            count_run,
    output logic            count_closed,
    output logic            count_handed_on,
    output logic            count_dropped_full,
    output logic            count_dropped_rule,
    output logic            count_dropped_queue,
    output logic            count_frame,
    output logic            count_abandoned,
    output logic [  EW-1:0] abandoned,
    output logic [  RW-1:0] record_peak,
    output logic [  EW-1:0] end_peak
);
  logic pixel_valid, pixel_ready, scan_ready, dark, sof, unused_eol;
  threshold threshold_i (
      .in_eol(1'b0), .out_valid(pixel_valid), .out_ready(pixel_ready), .out_dark(dark), .out_grey(grey_level),
      .out_sof(sof), .out_eol(unused_eol), .*);
  assign pixel_ready = scan_ready && grey_ready;
  assign grey_valid = pixel_valid && scan_ready;
  assign grey_sof = sof;
  assign scan_begins = pixel_valid && pixel_ready && sof;

  logic chain_valid, chain_ready, chain_hole, chain_end, walk_read, walk_granted, release_valid, release_ready;
  logic [RW-1:0] chain_head, chain_tail, walk_record, walk_next, release_head, release_tail;
  logic [XW-1:0] walk_x;
  logic [YW-1:0] walk_y;
  contour_scan #(
      .MAX_WIDTH(MAX_WIDTH), .MAX_HEIGHT(MAX_HEIGHT), .RECORDS(RECORDS), .EVENTS(EVENTS), .QUEUE(QUEUE), .TW(TW)
  ) scan (
      .in_valid(pixel_valid && grey_ready), .in_ready(scan_ready), .in_dark(dark), .in_sof(sof), .*);

  localparam QW = 4 * (XW + YW) + YW + 2;
  logic found_valid, found_ready, found_hole, found_end, quad_valid, quad_ready, quad_hole, quad_end;
  logic [4*XW-1:0] found_x, quad_x;
  logic [4*YW-1:0] found_y, quad_y;
  logic [YW-1:0] found_bottom, quad_bottom;
  corner #(.XW(XW), .YW(YW), .RW(RW)) corner_i (
      .threshold(corner_offset), .quad_valid(found_valid), .quad_ready(found_ready), .quad_x(found_x),
      .quad_y(found_y), .quad_bottom(found_bottom), .quad_hole(found_hole), .quad_end(found_end), .*);
  assign count_quad = found_valid && found_ready && !found_end;

  stream_fifo #(.WIDTH(QW), .DEPTH(QUEUE)) quads (
      .clear(reset), .in_valid(found_valid), .in_ready(found_ready),
      .in_data({found_end, found_hole, found_bottom, found_y, found_x}),
      .out_valid(quad_valid), .out_ready(quad_ready),
      .out_data({quad_end, quad_hole, quad_bottom, quad_y, quad_x}), .*);

  pattern #(.XW(XW), .YW(YW), .CODES(CODES)) pattern_i (
      .filtered(cases != '0), .write(code_write), .write_at(code_at), .write_code(code),
      .grey_valid(answer_valid), .grey(answer), .*);

  wire unused = &{1'b0, unused_eol};
endmodule
