// The five cores of the hardware profile in a row: pixels in, markers out, bit for bit `--pipeline hardware`. Grey
// levels go out beside the pixels to be kept until the pattern core asks for some of them, at most four rows below a
// marker's contour, which the threshold is behind by eight rows.
module hardware_cores #(
    parameter MAX_WIDTH = 640,
    parameter MAX_HEIGHT = 480,
    parameter RECORDS = 2047,
    parameter EVENTS = 512,
    parameter CHAINS = 64,    // closed chains that may wait
    parameter QUADS = 128,    // quads that may wait
    parameter CODES = 1024,
    parameter XW = $clog2(MAX_WIDTH),
    parameter YW = $clog2(MAX_HEIGHT),
    parameter TW = 5,
    parameter SW = XW + 6,
    parameter AW = XW + YW + 1,
    parameter IW = $clog2(CODES),
    parameter RW = $clog2(RECORDS + 1),
    parameter EW = $clog2(MAX_WIDTH + 1)
) (
    input  logic            clk,
    input  logic            reset,
    input  logic [  XW-1:0] last_x,        // at least 15
    input  logic [  YW-1:0] last_y,
    input  logic            rgb,
    input  logic [     7:0] min_contrast,
    input  logic [     5:0] cases,
    input  logic            eight,
    input  logic            give_up,
    input  logic [  TW-1:0] max_turns,
    input  logic [  YW-1:0] min_height,
    input  logic            holes,
    input  logic            patient,
    input  logic [  AW-1:0] min_area,
    input  logic [  AW-1:0] max_area,
    input  logic [  XW-1:0] min_side,
    input  logic [     3:0] width,         // of a marker, in cells with its border
    input  logic [     7:0] min_margin,
    input  logic [     5:0] max_errors,
    input  logic [    IW:0] codes,
    input  logic            code_write,
    input  logic [  IW-1:0] code_at,
    input  logic [    63:0] code,

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
    output logic [4*SW-1:0] marker_x,      // sixteenths of a pixel, signed
    output logic [4*SW-1:0] marker_y,
    output logic [  YW-1:0] marker_bottom,
    output logic            marker_hole,
    output logic [  IW-1:0] marker_id,
    output logic [     1:0] marker_rotation,
    output logic [     5:0] marker_errors,
    output logic [    19:0] marker_clearance,
    output logic [    19:0] marker_scale,
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
  // Grey levels as in the other profile; its comparison is not used.
  logic pixel_valid, pixel_ready, tiles_ready, unused_dark, sof, unused_eol;
  threshold grey_i (
      .clk(clk), .reset(reset), .level(9'd0), .above_is_dark(1'b0), .rgb(rgb),
      .in_valid(in_valid), .in_ready(in_ready), .in_data(in_data), .in_sof(in_sof), .in_eol(1'b0),
      .out_valid(pixel_valid), .out_ready(pixel_ready), .out_dark(unused_dark), .out_grey(grey_level),
      .out_sof(sof), .out_eol(unused_eol));
  assign pixel_ready = tiles_ready && grey_ready;
  assign grey_valid = pixel_valid && tiles_ready;
  assign grey_sof = sof;

  logic bit_valid, bit_ready, dark, bit_sof;
  tile_threshold #(.MAX_WIDTH(MAX_WIDTH), .MAX_HEIGHT(MAX_HEIGHT)) tiles (
      .clk(clk), .reset(reset), .last_x(last_x), .last_y(last_y), .min_contrast(min_contrast),
      .in_valid(pixel_valid && grey_ready), .in_ready(tiles_ready), .in_grey(grey_level), .in_sof(sof),
      .out_valid(bit_valid), .out_ready(bit_ready), .out_dark(dark), .out_sof(bit_sof));
  assign scan_begins = bit_valid && bit_ready && bit_sof;

  logic chain_valid, chain_ready, chain_hole, chain_end, walk_read, walk_granted, release_valid, release_ready;
  logic [RW-1:0] chain_head, chain_tail, walk_record, walk_next, release_head, release_tail;
  logic [XW-1:0] walk_x;
  logic [YW-1:0] walk_y;
  contour_scan #(
      .MAX_WIDTH(MAX_WIDTH), .MAX_HEIGHT(MAX_HEIGHT), .RECORDS(RECORDS), .EVENTS(EVENTS), .QUEUE(CHAINS), .TW(TW)
  ) scan (
      .clk(clk), .reset(reset), .last_x(last_x), .last_y(last_y), .cases(cases), .eight(eight), .give_up(give_up),
      .max_turns(max_turns), .min_height(min_height), .holes(holes), .patient(patient),
      .in_valid(bit_valid), .in_ready(bit_ready), .in_dark(dark), .in_sof(bit_sof),
      .chain_valid(chain_valid), .chain_ready(chain_ready), .chain_head(chain_head), .chain_tail(chain_tail),
      .chain_hole(chain_hole), .chain_end(chain_end),
      .walk_read(walk_read), .walk_granted(walk_granted), .walk_record(walk_record),
      .walk_x(walk_x), .walk_y(walk_y), .walk_next(walk_next),
      .release_valid(release_valid), .release_ready(release_ready),
      .release_head(release_head), .release_tail(release_tail), .lost(lost),
      .count_run(count_run), .count_closed(count_closed), .count_handed_on(count_handed_on),
      .count_dropped_full(count_dropped_full), .count_dropped_rule(count_dropped_rule),
      .count_dropped_queue(count_dropped_queue), .count_frame(count_frame), .count_abandoned(count_abandoned),
      .abandoned(abandoned), .record_peak(record_peak), .end_peak(end_peak));

  localparam QW = 8 * SW + YW + 2;
  logic found_valid, found_ready, found_hole, found_end, quad_valid, quad_ready, quad_hole, quad_end;
  logic [4*SW-1:0] found_x, found_y, quad_x, quad_y;
  logic [YW-1:0] found_bottom, quad_bottom;
  quad #(.XW(XW), .YW(YW), .RW(RW)) quad_i (
      .clk(clk), .reset(reset), .min_area(min_area), .max_area(max_area), .min_side(min_side),
      .chain_valid(chain_valid), .chain_ready(chain_ready), .chain_head(chain_head), .chain_tail(chain_tail),
      .chain_hole(chain_hole), .chain_end(chain_end),
      .walk_read(walk_read), .walk_granted(walk_granted), .walk_record(walk_record),
      .walk_x(walk_x), .walk_y(walk_y), .walk_next(walk_next),
      .release_valid(release_valid), .release_ready(release_ready),
      .release_head(release_head), .release_tail(release_tail),
      .quad_valid(found_valid), .quad_ready(found_ready), .quad_x(found_x), .quad_y(found_y),
      .quad_bottom(found_bottom), .quad_hole(found_hole), .quad_end(found_end));
  assign count_quad = found_valid && found_ready && !found_end;

  stream_fifo #(.WIDTH(QW), .DEPTH(QUADS)) quads (
      .clk(clk), .clear(reset), .in_valid(found_valid), .in_ready(found_ready),
      .in_data({found_end, found_hole, found_bottom, found_y, found_x}),
      .out_valid(quad_valid), .out_ready(quad_ready),
      .out_data({quad_end, quad_hole, quad_bottom, quad_y, quad_x}));

  quad_pattern #(.XW(XW), .YW(YW), .CODES(CODES)) pattern_i (
      .clk(clk), .reset(reset), .last_x(last_x), .last_y(last_y), .width(width), .min_margin(min_margin),
      .max_errors(max_errors), .codes(codes), .write(code_write), .write_at(code_at), .write_code(code),
      .quad_valid(quad_valid), .quad_ready(quad_ready), .quad_x(quad_x), .quad_y(quad_y),
      .quad_bottom(quad_bottom), .quad_hole(quad_hole), .quad_end(quad_end),
      .read_valid(read_valid), .read_ready(read_ready), .read_x(read_x), .read_y(read_y),
      .grey_valid(answer_valid), .grey(answer),
      .marker_valid(marker_valid), .marker_ready(marker_ready), .marker_x(marker_x), .marker_y(marker_y),
      .marker_bottom(marker_bottom), .marker_hole(marker_hole), .marker_id(marker_id),
      .marker_rotation(marker_rotation), .marker_errors(marker_errors),
      .marker_clearance(marker_clearance), .marker_scale(marker_scale), .marker_end(marker_end));

  wire unused = &{1'b0, unused_dark, unused_eol};
endmodule
