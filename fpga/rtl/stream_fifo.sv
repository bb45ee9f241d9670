// A first-in first-out queue in block RAM with valid/ready at both ends. The RAM's read latch and an output
// register stand behind one another, so that the output is a plain register: the data of an event or a crack
// decide much in the cycle they are seen.
module stream_fifo #(
    parameter WIDTH = 32,
    parameter DEPTH = 512
) (
    input  logic             clk,
    input  logic             clear,
    input  logic             in_valid,
    output logic             in_ready,
    input  logic [WIDTH-1:0] in_data,
    output logic             out_valid,
    input  logic             out_ready,
    output logic [WIDTH-1:0] out_data
);
  localparam AW = $clog2(DEPTH);
  localparam CW = $clog2(DEPTH + 1);
  localparam [AW-1:0] LAST = AW'(DEPTH - 1);

  logic [WIDTH-1:0] memory[0:DEPTH-1];
  logic [WIDTH-1:0] latch;
  logic latch_valid;
  logic [AW-1:0] write_at, read_at;
  logic [CW-1:0] stored;  // in memory; the latch and the output hold two more
  logic full, empty;

  wire move = latch_valid && (!out_valid || out_ready);
  wire fetch = !empty && (!latch_valid || move);
  wire store = in_valid && in_ready;
  assign in_ready = !full;

  always_ff @(posedge clk) begin
    if (store) memory[write_at] <= in_data;
    if (fetch) latch <= memory[read_at];
  end

  always_ff @(posedge clk) begin
    if (clear) begin
      write_at <= '0;
      read_at <= '0;
      stored <= '0;
      full <= 1'b0;
      empty <= 1'b1;
      latch_valid <= 1'b0;
      out_valid <= 1'b0;
    end else begin
      if (store) write_at <= write_at == LAST ? '0 : write_at + 1'b1;
      if (fetch) read_at <= read_at == LAST ? '0 : read_at + 1'b1;
      if (store && !fetch) begin
        stored <= stored + 1'b1;
        full <= stored == CW'(DEPTH - 1);
        empty <= 1'b0;
      end else if (fetch && !store) begin
        stored <= stored - 1'b1;
        full <= 1'b0;
        empty <= stored == CW'(1);
      end
      latch_valid <= fetch || (latch_valid && !move);
      out_valid <= move || (out_valid && !out_ready);
    end
    if (move) out_data <= latch;
  end
endmodule
