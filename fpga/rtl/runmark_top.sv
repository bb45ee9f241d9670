// The system as one core, of either profile: video in, markers out, the grey frame in the memory outside
// (docs/hardware-top.md; registers and results: docs/registers.md).
module runmark_top #(
    parameter HARDWARE = 0,     // the profile: 0 paper, 1 hardware
    parameter MAX_WIDTH = 640,  // 65 to 4096
    parameter MAX_HEIGHT = 480,
    parameter RECORDS = HARDWARE != 0 ? 2047 : 1023,
    parameter EVENTS = 512,
    parameter QUEUE = HARDWARE != 0 ? 64 : 16,  // closed chains that may wait
    parameter CODES = 1024,
    parameter RESULTS = 512     // words that may wait to be read
) (
    input  logic        clk,
    input  logic        reset,

    input  logic        s_video_tvalid,
    output logic        s_video_tready,
    input  logic [23:0] s_video_tdata,
    input  logic        s_video_tuser,
    input  logic        s_video_tlast,

    input  logic [ 7:0] s_axil_awaddr,
    input  logic        s_axil_awvalid,
    output logic        s_axil_awready,
    input  logic [31:0] s_axil_wdata,
    input  logic        s_axil_wvalid,
    output logic        s_axil_wready,
    output logic [ 1:0] s_axil_bresp,
    output logic        s_axil_bvalid,
    input  logic        s_axil_bready,
    input  logic [ 7:0] s_axil_araddr,
    input  logic        s_axil_arvalid,
    output logic        s_axil_arready,
    output logic [31:0] s_axil_rdata,
    output logic [ 1:0] s_axil_rresp,
    output logic        s_axil_rvalid,
    input  logic        s_axil_rready,
    output logic        irq,

    output logic [31:0] m_axi_awaddr,
    output logic [ 7:0] m_axi_awlen,
    output logic [ 2:0] m_axi_awsize,
    output logic [ 1:0] m_axi_awburst,
    output logic        m_axi_awvalid,
    input  logic        m_axi_awready,
    output logic [63:0] m_axi_wdata,
    output logic [ 7:0] m_axi_wstrb,
    output logic        m_axi_wlast,
    output logic        m_axi_wvalid,
    input  logic        m_axi_wready,
    input  logic [ 1:0] m_axi_bresp,
    input  logic        m_axi_bvalid,
    output logic        m_axi_bready,
    output logic [31:0] m_axi_araddr,
    output logic [ 7:0] m_axi_arlen,
    output logic [ 2:0] m_axi_arsize,
    output logic [ 1:0] m_axi_arburst,
    output logic        m_axi_arvalid,
    input  logic        m_axi_arready,
    input  logic [63:0] m_axi_rdata,
    input  logic [ 1:0] m_axi_rresp,
    input  logic        m_axi_rvalid,
    output logic        m_axi_rready,

    output logic        m_result_tvalid,
    input  logic        m_result_tready,
    output logic [31:0] m_result_tdata,
    output logic        m_result_tlast
);
`include "registers.svh"
  localparam XW = $clog2(MAX_WIDTH);
  localparam YW = $clog2(MAX_HEIGHT);
  localparam TW = 5;
  localparam IW = $clog2(CODES);
  localparam RW = $clog2(RECORDS + 1);
  localparam EW = $clog2(MAX_WIDTH + 1);
  localparam CXW = HARDWARE != 0 ? XW + 6 : XW;  // of a corner's place
  localparam CYW = HARDWARE != 0 ? XW + 6 : YW;

  // Registers.
  logic [31:0] control, size, chain_limits, min_area, max_area, match, square, frame_address, frames, result;
  logic [8:0] level;
  logic [5:0] cases;
  logic [7:0] corner_offset, min_contrast;
  logic code_write, result_valid, result_ready, frame_done;
  logic [IW-1:0] code_at;
  logic [63:0] code;
  logic fed_valid, fed_ready, lost, cut_frame, bad_line;
  logic [25:0] fed;
  logic dropped_full, dropped_rule, dropped_queue, count_abandoned;
  logic [EW-1:0] abandoned;
  logic [1:0] under_way;  // frames begun and not yet ended
  wire read_results = control[CONTROL_READ_RESULTS];
  wire bus_error = (m_axi_bvalid && m_axi_bready && m_axi_bresp != '0) || (m_axi_rvalid && m_axi_rready && m_axi_rresp != '0);
  logic waiting_valid, waiting_last;
  assign result_valid = waiting_valid && read_results;
  control_registers #(
      .HARDWARE(HARDWARE), .IW(IW), .LARGEST({16'(MAX_HEIGHT), 16'(MAX_WIDTH)}), .CAPACITY({16'(CODES), 16'(RECORDS)})
  ) registers (
      .pixel_valid(fed_valid), .pixel_ready(fed_ready), .pixel(fed), .frame_open(under_way != '0),
      .abandoned(count_abandoned ? {{(16 - EW) {1'b0}}, abandoned} : 16'b0), .*);

  logic [XW-1:0] last_x;
  logic [YW-1:0] last_y;
  always_ff @(posedge clk) begin
    last_x <= size[SIZE_WIDTH+:XW] - 1'b1;
    last_y <= size[SIZE_HEIGHT+:YW] - 1'b1;
  end

  // Video, from the stream or from the registers.
  wire feed = control[CONTROL_FEED];
  wire above_is_dark = control[CONTROL_ABOVE_IS_DARK];
  logic video_ready, pixel_valid, pixel_ready, pixel_sof;
  logic [23:0] pixel;
  assign s_video_tready = video_ready && !feed;
  assign fed_ready = video_ready && feed;
  video_guard #(.XW(XW), .YW(YW)) guard (
      .run(control[CONTROL_RUN]), .light({24{!above_is_dark}}),
      .video_valid(feed ? fed_valid : s_video_tvalid),
      .video_data(feed ? fed[PIXEL_DATA+:24] : s_video_tdata),
      .video_user(feed ? fed[PIXEL_USER] : s_video_tuser),
      .video_last(feed ? fed[PIXEL_LAST] : s_video_tlast),
      .out_valid(pixel_valid), .out_ready(pixel_ready), .out_data(pixel), .out_sof(pixel_sof), .*);

  logic grey_valid, grey_ready, grey_sof, read_valid, read_ready, answer_valid;
  logic [7:0] grey_level, answer;
  logic [XW-1:0] read_x;
  logic [YW-1:0] read_y, marker_bottom;
  logic marker_valid, marker_ready, marker_hole, marker_end;
  logic [4*CXW-1:0] marker_x;
  logic [4*CYW-1:0] marker_y;
  logic [IW-1:0] marker_id;
  logic [1:0] marker_rotation;
  logic [5:0] marker_errors;
  logic [19:0] marker_clearance, marker_scale;
  logic scan_begins, count_frame, count_quad, count_run, count_closed, count_handed_on;
  logic [EW-1:0] end_peak;
  logic [RW-1:0] record_peak;
  generate
    if (HARDWARE != 0) begin : g_hardware
      hardware_cores #(
          .MAX_WIDTH(MAX_WIDTH), .MAX_HEIGHT(MAX_HEIGHT), .RECORDS(RECORDS), .EVENTS(EVENTS), .CHAINS(QUEUE),
          .QUADS(2 * QUEUE), .CODES(CODES), .TW(TW)
      ) cores (
          .rgb(control[CONTROL_RGB]), .eight(control[CONTROL_EIGHT]), .give_up(control[CONTROL_GIVE_UP]),
          .holes(control[CONTROL_HOLES]), .patient(control[CONTROL_PATIENT]),
          .max_turns(chain_limits[CHAIN_LIMITS_MAX_TURNS+:TW]), .min_height(chain_limits[CHAIN_LIMITS_MIN_HEIGHT+:YW]),
          .min_area(min_area[XW+YW:0]), .max_area(max_area[XW+YW:0]), .min_side(square[SQUARE_MIN_SIDE+:XW]),
          .width(square[SQUARE_WIDTH+:4]), .min_margin(square[SQUARE_MIN_MARGIN+:8]),
          .max_errors(match[MATCH_MAX_ERRORS+:6]), .codes(match[MATCH_CODES+:IW+1]),
          .in_valid(pixel_valid), .in_ready(pixel_ready), .in_data(pixel), .in_sof(pixel_sof),
          .count_dropped_full(dropped_full), .count_dropped_rule(dropped_rule), .count_dropped_queue(dropped_queue), .*);
    end else begin : g_paper
      paper_cores #(
          .MAX_WIDTH(MAX_WIDTH), .MAX_HEIGHT(MAX_HEIGHT), .RECORDS(RECORDS), .EVENTS(EVENTS), .QUEUE(QUEUE),
          .CODES(CODES), .TW(TW)
      ) cores (
          .rgb(control[CONTROL_RGB]), .eight(control[CONTROL_EIGHT]), .give_up(control[CONTROL_GIVE_UP]),
          .holes(control[CONTROL_HOLES]), .patient(control[CONTROL_PATIENT]),
          .max_turns(chain_limits[CHAIN_LIMITS_MAX_TURNS+:TW]), .min_height(chain_limits[CHAIN_LIMITS_MIN_HEIGHT+:YW]),
          .min_area(min_area[XW+YW+1:0]), .max_area(max_area[XW+YW+1:0]), .code(code[35:0]),
          .max_errors(match[MATCH_MAX_ERRORS+:6]), .codes(match[MATCH_CODES+:IW+1]),
          .in_valid(pixel_valid), .in_ready(pixel_ready), .in_data(pixel), .in_sof(pixel_sof),
          .count_dropped_full(dropped_full), .count_dropped_rule(dropped_rule), .count_dropped_queue(dropped_queue), .*);
      assign marker_clearance = '0;
      assign marker_scale = '0;
    end
  endgenerate

  // The grey frame: one place in memory for each of two frames under way.
  logic read_place, begins;
  logic [YW:0] rows;
  grey_writer #(.XW(XW), .YW(YW)) writer (.base(frame_address), .may_begin(!under_way[1]), .*);
  grey_reader #(.XW(XW), .YW(YW)) reader (
      .base(frame_address), .place(read_place), .coming_in(under_way == 2'd1), .*);
  always_ff @(posedge clk) begin
    if (begins != frame_done) under_way <= begins ? under_way + 1'b1 : under_way - 1'b1;
    if (frame_done) read_place <= !read_place;
    if (reset) begin
      under_way <= '0;
      read_place <= 1'b1;
    end
  end

  // Results.
  logic frame_malformed, frame_lost, frame_dropped, word_valid, word_ready, word_last;
  logic [EW+RW-1:0] frame_peaks;
  logic [31:0] word_data;
  frame_notes #(.PW(EW + RW)) notes (
      .video_begins(pixel_valid && pixel_ready && pixel_sof), .scan_ends(count_frame),
      .dropped(dropped_full || dropped_queue), .peaks({end_peak, record_peak}), .frame(frames[1:0]), .*);
  result_words #(.FINE(HARDWARE), .XW(CXW), .YW(CYW), .BW(YW), .IW(IW), .RW(RW), .EW(EW)) words (.frame(frames[15:0]), .*);
  assign frame_done = marker_valid && marker_ready && marker_end;
  stream_fifo #(.WIDTH(33), .DEPTH(RESULTS)) results (
      .clear(reset), .in_valid(word_valid), .in_ready(word_ready), .in_data({word_last, word_data}),
      .out_valid(waiting_valid), .out_ready(read_results ? result_ready : m_result_tready),
      .out_data({waiting_last, result}), .*);
  assign m_result_tvalid = waiting_valid && !read_results;
  assign m_result_tdata = result;
  assign m_result_tlast = waiting_last;

  wire unused = &{1'b0, count_quad, count_run, count_closed, count_handed_on, frames, control, size, chain_limits, min_area,
                  max_area, match, square, min_contrast, level, corner_offset, code};
endmodule
