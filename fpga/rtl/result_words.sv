// Markers and ends of frames as records of words (docs/registers.md).
module result_words #(
    parameter FINE = 0,        // corners of the hardware profile: signed, in sixteenths of a pixel
    parameter XW = 10,         // bits of a corner's place
    parameter YW = 9,
    parameter BW = 9,          // of a row
    parameter IW = 10,
    parameter RW = 10,
    parameter EW = 10
) (
    input  logic            clk,
    input  logic            reset,
    input  logic            marker_valid,
    output logic            marker_ready,
    input  logic [4*XW-1:0] marker_x,
    input  logic [4*YW-1:0] marker_y,
    input  logic [  BW-1:0] marker_bottom,
    input  logic            marker_hole,
    input  logic [  IW-1:0] marker_id,
    input  logic [     1:0] marker_rotation,
    input  logic [     5:0] marker_errors,
    input  logic [    19:0] marker_clearance,
    input  logic [    19:0] marker_scale,
    input  logic            marker_end,
    input  logic [    15:0] frame,           // what is said at the end of a frame
    input  logic            frame_malformed,
    input  logic            frame_lost,
    input  logic            frame_dropped,
    input  logic [EW+RW-1:0] frame_peaks,
    output logic            word_valid,
    input  logic            word_ready,
    output logic [    31:0] word_data,
    output logic            word_last
);
`include "registers.svh"
  logic [3:0] number;
  wire [1:0] corner = FINE != 0 ? 2'(number[3:1] - 3'd2) : 2'(number - 4'd2);
  wire signed [XW-1:0] x = marker_x[XW*corner+:XW];
  wire signed [YW-1:0] y = marker_y[YW*corner+:YW];
  always_comb begin
    word_data = '0;
    if (number == 4'd0) begin
      word_data[RECORD_END] = marker_end;
      if (marker_end) begin
        word_data[RECORD_ID+:16] = frame;
        word_data[RECORD_MALFORMED] = frame_malformed;
        word_data[RECORD_LOST] = frame_lost;
        word_data[RECORD_DROPPED] = frame_dropped;
      end else begin
        word_data[RECORD_ID+:IW] = marker_id;
        word_data[RECORD_ERRORS+:RECORD_ERRORS_BITS] = marker_errors;
        word_data[RECORD_FINE] = FINE != 0;
        word_data[RECORD_ROTATION+:RECORD_ROTATION_BITS] = marker_rotation;
        word_data[RECORD_INVERTED] = marker_hole;
      end
    end else if (number == 4'd1 && marker_end) begin
      word_data[RECORD_RECORD_PEAK+:RW] = frame_peaks[RW-1:0];
      word_data[RECORD_END_PEAK+:EW] = frame_peaks[RW+:EW];
    end else if (number == 4'd1) begin
      word_data[RECORD_BOTTOM+:BW] = marker_bottom;
    end else if (FINE == 0) begin
      word_data[RECORD_X+:16] = 16'($unsigned(x));
      word_data[RECORD_Y+:16] = 16'($unsigned(y));
    end else if (number == 4'd2) begin
      word_data = {12'b0, marker_clearance};
    end else if (number == 4'd3) begin
      word_data = {12'b0, marker_scale};
    end else begin
      word_data = number[0] ? 32'(y) : 32'(x);
    end
  end
  assign word_last = number == (marker_end ? 4'd1 : FINE != 0 ? 4'd11 : 4'd5);
  assign word_valid = marker_valid;
  assign marker_ready = word_ready && word_last;
  always_ff @(posedge clk) begin
    if (reset || (marker_valid && marker_ready)) number <= '0;
    else if (marker_valid && word_ready) number <= number + 1'b1;
  end
endmodule
