// The registers on AXI4-Lite (fpga/registers.json): whole words, byte strobes are not looked at. A write is taken when
// its address and its data are both there.
module control_registers #(
    parameter IW = 10,
    parameter [31:0] LARGEST = '0,
    parameter [31:0] CAPACITY = '0,
    parameter HARDWARE = 0  // the profile: 0 paper
) (
    input  logic          clk,
    input  logic          reset,
    input  logic [   7:0] s_axil_awaddr,
    input  logic          s_axil_awvalid,
    output logic          s_axil_awready,
    input  logic [  31:0] s_axil_wdata,
    input  logic          s_axil_wvalid,
    output logic          s_axil_wready,
    output logic [   1:0] s_axil_bresp,
    output logic          s_axil_bvalid,
    input  logic          s_axil_bready,
    input  logic [   7:0] s_axil_araddr,
    input  logic          s_axil_arvalid,
    output logic          s_axil_arready,
    output logic [  31:0] s_axil_rdata,
    output logic [   1:0] s_axil_rresp,
    output logic          s_axil_rvalid,
    input  logic          s_axil_rready,
    output logic          irq,

    output logic [  31:0] control,
    output logic [  31:0] size,
    output logic [   8:0] level,
    output logic [   5:0] cases,
    output logic [  31:0] chain_limits,
    output logic [   7:0] corner_offset,
    output logic [  31:0] min_area,
    output logic [  31:0] max_area,
    output logic [  31:0] match,
    output logic [   7:0] min_contrast,
    output logic [  31:0] square,
    output logic          code_write,
    output logic [IW-1:0] code_at,
    output logic [  63:0] code,
    output logic [  31:0] frame_address,

    output logic          pixel_valid,   // video written by the registers
    input  logic          pixel_ready,
    output logic [  25:0] pixel,
    input  logic          result_valid,
    output logic          result_ready,
    input  logic [  31:0] result,
    input  logic          frame_open,

    input  logic          frame_done,    // pulses to be counted
    input  logic          dropped_full,
    input  logic [  15:0] abandoned,     // more of them, when not 0
    input  logic          dropped_rule,
    input  logic          dropped_queue,
    input  logic          lost,
    input  logic          cut_frame,
    input  logic          bad_line,
    input  logic          bus_error,
    output logic [  31:0] frames
);
`include "registers.svh"
  logic [15:0] code_index;
  logic [31:0] code_high;
  logic done;
  logic [31:0] full_count, rule_count, queue_count, lost_count, cut_count, line_count, error_count;

  wire writes = s_axil_awvalid && s_axil_wvalid && !s_axil_bvalid;
  wire reads = s_axil_arvalid && (!s_axil_rvalid || s_axil_rready);
  assign s_axil_awready = writes;
  assign s_axil_wready = writes;
  assign s_axil_arready = reads;
  assign s_axil_bresp = 2'b00;
  assign s_axil_rresp = 2'b00;
  assign result_ready = reads && s_axil_araddr == REG_RESULT;
  assign code_at = code_index[IW-1:0];
  assign irq = (done && control[CONTROL_INTERRUPT_FRAME]) || (result_valid && control[CONTROL_INTERRUPT_RESULT]);

  logic [31:0] status;
  always_comb begin
    status = '0;
    status[STATUS_FRAME_DONE] = done;
    status[STATUS_RESULT_READY] = result_valid;
    status[STATUS_PIXEL_FREE] = !pixel_valid;
    status[STATUS_FRAME_OPEN] = frame_open;
  end

  always_ff @(posedge clk) begin
    code_write <= 1'b0;
    s_axil_bvalid <= writes || (s_axil_bvalid && !s_axil_bready);
    s_axil_rvalid <= reads || (s_axil_rvalid && !s_axil_rready);
    if (code_write) code_index <= code_index + 1'b1;
    if (pixel_ready) pixel_valid <= 1'b0;
    if (writes) begin
      case (s_axil_awaddr)
        REG_CONTROL: control <= s_axil_wdata;
        REG_SIZE: size <= s_axil_wdata;
        REG_THRESHOLD: level <= s_axil_wdata[8:0];
        REG_FILTER: cases <= s_axil_wdata[5:0];
        REG_CHAIN_LIMITS: chain_limits <= s_axil_wdata;
        REG_CORNER_OFFSET: corner_offset <= s_axil_wdata[7:0];
        REG_MIN_AREA: min_area <= s_axil_wdata;
        REG_MAX_AREA: max_area <= s_axil_wdata;
        REG_MATCH: match <= s_axil_wdata;
        REG_CODE_INDEX: code_index <= s_axil_wdata[15:0];
        REG_CODE_HIGH: code_high <= s_axil_wdata;
        REG_CODE_LOW: begin
          code <= {code_high, s_axil_wdata};
          code_write <= 1'b1;
        end
        REG_FRAME_ADDRESS: frame_address <= s_axil_wdata;
        REG_MIN_CONTRAST: min_contrast <= s_axil_wdata[7:0];
        REG_SQUARE: square <= s_axil_wdata;
        REG_PIXEL: if (!pixel_valid) begin
          pixel <= s_axil_wdata[25:0];
          pixel_valid <= 1'b1;
        end
        default: ;
      endcase
    end
    if (reads) begin
      case (s_axil_araddr)
        REG_ID: s_axil_rdata <= 32'h524D4B31;
        REG_CONTROL: s_axil_rdata <= control;
        REG_SIZE: s_axil_rdata <= size;
        REG_THRESHOLD: s_axil_rdata <= {23'b0, level};
        REG_FILTER: s_axil_rdata <= {26'b0, cases};
        REG_CHAIN_LIMITS: s_axil_rdata <= chain_limits;
        REG_CORNER_OFFSET: s_axil_rdata <= {24'b0, corner_offset};
        REG_MIN_AREA: s_axil_rdata <= min_area;
        REG_MAX_AREA: s_axil_rdata <= max_area;
        REG_MATCH: s_axil_rdata <= match;
        REG_CODE_INDEX: s_axil_rdata <= {16'b0, code_index};
        REG_CODE_HIGH: s_axil_rdata <= code_high;
        REG_FRAME_ADDRESS: s_axil_rdata <= frame_address;
        REG_STATUS: s_axil_rdata <= status;
        REG_RESULT: s_axil_rdata <= result_valid ? result : '0;
        REG_LARGEST: s_axil_rdata <= LARGEST;
        REG_CAPACITY: s_axil_rdata <= CAPACITY;
        REG_FRAMES: s_axil_rdata <= frames;
        REG_DROPPED_FULL: s_axil_rdata <= full_count;
        REG_DROPPED_RULE: s_axil_rdata <= rule_count;
        REG_DROPPED_QUEUE: s_axil_rdata <= queue_count;
        REG_LOST_FRAMES: s_axil_rdata <= lost_count;
        REG_CUT_FRAMES: s_axil_rdata <= cut_count;
        REG_BAD_LINES: s_axil_rdata <= line_count;
        REG_BUS_ERRORS: s_axil_rdata <= error_count;
        REG_PROFILE: s_axil_rdata <= HARDWARE;
        REG_MIN_CONTRAST: s_axil_rdata <= {24'b0, min_contrast};
        REG_SQUARE: s_axil_rdata <= square;
        default: s_axil_rdata <= '0;
      endcase
    end

    if (frame_done) done <= 1'b1;
    else if (writes && s_axil_awaddr == REG_STATUS && s_axil_wdata[STATUS_FRAME_DONE]) done <= 1'b0;
    frames <= frames + {31'b0, frame_done};
    full_count <= full_count + {31'b0, dropped_full} + {16'b0, abandoned};
    rule_count <= rule_count + {31'b0, dropped_rule};
    queue_count <= queue_count + {31'b0, dropped_queue};
    lost_count <= lost_count + {31'b0, lost};
    cut_count <= cut_count + {31'b0, cut_frame};
    line_count <= line_count + {31'b0, bad_line};
    error_count <= error_count + {31'b0, bus_error};

    if (reset) begin
      s_axil_bvalid <= 1'b0;
      s_axil_rvalid <= 1'b0;
      control <= '0;
      match <= '0;
      frame_address <= '0;
      code_index <= '0;
      pixel_valid <= 1'b0;
      done <= 1'b0;
      frames <= '0;
      full_count <= '0;
      rule_count <= '0;
      queue_count <= '0;
      lost_count <= '0;
      cut_count <= '0;
      line_count <= '0;
      error_count <= '0;
    end
  end
endmodule
