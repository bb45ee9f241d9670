// Keeps the grey frame in memory by AXI4 writes of up to 8 beats of 8 bytes, in two places by turns, and knows how
// many rows have been acknowledged. A frame begins when all writes of the one before have been answered and the
// place it goes to has been read.
module grey_writer #(
    parameter XW = 10,  // at least 7
    parameter YW = 9
) (
    input  logic          clk,
    input  logic          reset,
    input  logic [XW-1:0] last_x,
    input  logic [  31:0] base,
    input  logic          may_begin,     // the place of the frame to come is free

    input  logic          grey_valid,
    output logic          grey_ready,
    input  logic [   7:0] grey_level,
    input  logic          grey_sof,
    output logic          begins,        // pulse
    output logic [  YW:0] rows,          // of this frame that have been acknowledged

    output logic [  31:0] m_axi_awaddr,
    output logic [   7:0] m_axi_awlen,
    output logic [   2:0] m_axi_awsize,
    output logic [   1:0] m_axi_awburst,
    output logic          m_axi_awvalid,
    input  logic          m_axi_awready,
    output logic [  63:0] m_axi_wdata,
    output logic [   7:0] m_axi_wstrb,
    output logic          m_axi_wlast,
    output logic          m_axi_wvalid,
    input  logic          m_axi_wready,
    input  logic          m_axi_bvalid,
    output logic          m_axi_bready
);
  localparam BX = XW - 6;  // bits of a burst's number in its row
  logic place, idle;
  logic [XW-1:0] x;
  logic [YW-1:0] y;
  logic [63:0] bytes;      // of the beat so far
  wire [XW-1:0] here_x = grey_sof ? '0 : x;
  wire [YW-1:0] here_y = grey_sof ? '0 : y;
  wire ends_line = here_x == last_x;
  wire ends_beat = ends_line || here_x[2:0] == 3'd7;
  wire ends_burst = ends_line || here_x[5:0] == 6'd63;
  logic [63:0] beat_so_far;
  always_comb begin
    beat_so_far = here_x[2:0] == 3'd0 ? '0 : bytes;
    beat_so_far[8*here_x[2:0]+:8] = grey_level;
  end

  // Beats wait here, and then the bursts that they make up: an address goes out when all of its data are there.
  logic beat_room, burst_room, burst_valid, beat_valid;
  logic [2:0] burst_length;
  logic [BX-1:0] burst_x;
  logic [YW-1:0] burst_y;
  assign grey_ready = (!grey_sof || (may_begin && idle)) && beat_room && burst_room;
  wire takes = grey_valid && grey_ready;
  wire queues = takes && ends_burst;
  assign begins = takes && grey_sof;
  stream_fifo #(.WIDTH(65), .DEPTH(64)) beats (
      .clear(reset), .in_valid(takes && ends_beat), .in_ready(beat_room), .in_data({ends_burst, beat_so_far}),
      .out_valid(beat_valid), .out_ready(m_axi_wvalid && m_axi_wready), .out_data({m_axi_wlast, m_axi_wdata}), .*);
  stream_fifo #(.WIDTH(3 + BX + YW), .DEPTH(8)) bursts (
      .clear(reset), .in_valid(queues), .in_ready(burst_room), .in_data({here_x[5:3], here_x[XW-1:6], here_y}),
      .out_valid(burst_valid), .out_ready(m_axi_awvalid && m_axi_awready),
      .out_data({burst_length, burst_x, burst_y}), .*);

  logic [4:0] queued;         // bursts not yet asked for
  logic [3:0] asked;          // bursts not yet acknowledged
  logic [3:0] ahead;          // bursts asked for whose data are still to go
  logic [BX-1:0] answered;    // bursts of the row that have been acknowledged
  wire asks = m_axi_awvalid && m_axi_awready;
  wire sends = m_axi_wvalid && m_axi_wready && m_axi_wlast;
  wire row_done = m_axi_bvalid && answered == last_x[XW-1:6];

  assign m_axi_awvalid = burst_valid && asked != '1;
  assign m_axi_awaddr = base + {{(31 - YW - XW) {1'b0}}, place, burst_y, burst_x, 6'b0};
  assign m_axi_awlen = {5'b0, burst_length};
  assign m_axi_awsize = 3'd3;
  assign m_axi_awburst = 2'b01;
  assign m_axi_wvalid = beat_valid && ahead != '0;
  assign m_axi_wstrb = '1;
  assign m_axi_bready = 1'b1;

  always_ff @(posedge clk) begin
    if (takes) begin
      x <= ends_line ? '0 : here_x + 1'b1;
      y <= ends_line ? here_y + 1'b1 : here_y;
      bytes <= beat_so_far;
    end
    if (queues != asks) queued <= queues ? queued + 1'b1 : queued - 1'b1;
    if (asks != m_axi_bvalid) asked <= asks ? asked + 1'b1 : asked - 1'b1;
    if (asks != sends) ahead <= asks ? ahead + 1'b1 : ahead - 1'b1;
    idle <= queued == '0 && asked == '0 && !queues;
    if (m_axi_bvalid) answered <= row_done ? '0 : answered + 1'b1;
    if (row_done) rows <= rows + 1'b1;
    if (begins) begin
      rows <= '0;
      answered <= '0;
      place <= !place;
    end
    if (reset) begin
      queued <= '0;
      asked <= '0;
      ahead <= '0;
      place <= 1'b0;
      idle <= 1'b1;
      rows <= '0;
    end
  end
endmodule
