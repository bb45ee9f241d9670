// Reads single pixels of the grey frame for the pattern core, and only such rows whose writes have been acknowledged.
// The frame it reads may be the one coming in or the one before.
module grey_reader #(
    parameter XW = 10,
    parameter YW = 9
) (
    input  logic          clk,
    input  logic          reset,
    input  logic [  31:0] base,
    input  logic          place,        // of the frame that is read
    input  logic          coming_in,    // that frame is still coming in
    input  logic [  YW:0] rows,         // of it that have been acknowledged
    input  logic          read_valid,
    output logic          read_ready,
    input  logic [XW-1:0] read_x,
    input  logic [YW-1:0] read_y,
    output logic          answer_valid,
    output logic [   7:0] answer,

    output logic [  31:0] m_axi_araddr,
    output logic [   7:0] m_axi_arlen,
    output logic [   2:0] m_axi_arsize,
    output logic [   1:0] m_axi_arburst,
    output logic          m_axi_arvalid,
    input  logic          m_axi_arready,
    input  logic [  63:0] m_axi_rdata,
    input  logic          m_axi_rvalid,
    output logic          m_axi_rready
);
  logic there;
  logic [XW-1:0] x;
  logic [YW-1:0] y;
  // Once a request may go it may until it has gone: rows only grow, and start anew when `coming_in` ends.
  wire may = !coming_in || {1'b0, y} < rows;
  logic room, lane_valid;
  logic [2:0] lane;
  assign m_axi_arvalid = there && may && room;
  assign m_axi_araddr = base + {{(31 - YW - XW) {1'b0}}, place, y, x[XW-1:3], 3'b0};
  assign m_axi_arlen = '0;
  assign m_axi_arsize = 3'd3;
  assign m_axi_arburst = 2'b01;
  wire asks = m_axi_arvalid && m_axi_arready;
  assign read_ready = !there || asks;

  // Which byte of the word it was, for each answer on its way.
  stream_fifo #(.WIDTH(3), .DEPTH(16)) lanes (
      .clear(reset), .in_valid(asks), .in_ready(room), .in_data(x[2:0]),
      .out_valid(lane_valid), .out_ready(m_axi_rvalid), .out_data(lane), .*);
  assign m_axi_rready = lane_valid;
  assign answer_valid = m_axi_rvalid && m_axi_rready;
  assign answer = m_axi_rdata[8*lane+:8];

  always_ff @(posedge clk) begin
    if (read_ready) begin
      there <= read_valid;
      x <= read_x;
      y <= read_y;
    end
    if (reset) there <= 1'b0;
  end
endmodule
