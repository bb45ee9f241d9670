// The threshold core: pixels in, dark or light out, with the grey level beside it. Grey is
// (77 R + 150 G + 29 B + 128) / 256, as in src/threshold/grey.h; the weights add up to 256, so a grey pixel
// goes the same way with its level in all three colours.
module threshold (
    input  logic        clk,
    input  logic        reset,
    input  logic [ 8:0] level,          // 0 to 256
    input  logic        above_is_dark,  // grey >= level is dark, else grey < level
    input  logic        rgb,            // in_data is red, green, blue from the low byte up; else grey in the low byte
    input  logic        in_valid,
    output logic        in_ready,
    input  logic [23:0] in_data,
    input  logic        in_sof,         // first pixel of a frame
    input  logic        in_eol,         // last pixel of a line
    output logic        out_valid,
    input  logic        out_ready,
    output logic        out_dark,
    output logic [ 7:0] out_grey,
    output logic        out_sof,
    output logic        out_eol
);
  wire go = !out_valid || out_ready;
  assign in_ready = go;

  wire [7:0] red = in_data[7:0];
  wire [7:0] green = rgb ? in_data[15:8] : in_data[7:0];
  wire [7:0] blue = rgb ? in_data[23:16] : in_data[7:0];

  logic valid_1, sof_1, eol_1, valid_2, sof_2, eol_2;
  logic [14:0] red_77;
  logic [15:0] green_150;
  logic [12:0] blue_29;
  logic [ 7:0] grey_2;
  wire  [15:0] sum = {1'b0, red_77} + green_150 + {3'b0, blue_29} + 16'd128;

  always_ff @(posedge clk) begin
    if (reset) begin
      valid_1   <= 1'b0;
      valid_2   <= 1'b0;
      out_valid <= 1'b0;
      out_sof   <= 1'b0;
    end else if (go) begin
      valid_1   <= in_valid;
      valid_2   <= valid_1;
      out_valid <= valid_2;
      out_sof   <= sof_2;
    end
    if (go) begin
      red_77    <= {1'b0, red, 6'b0} + {4'b0, red, 3'b0} + {5'b0, red, 2'b0} + {7'b0, red};
      green_150 <= {1'b0, green, 7'b0} + {4'b0, green, 4'b0} + {6'b0, green, 2'b0} + {7'b0, green, 1'b0};
      blue_29   <= {blue, 5'b0} - {4'b0, blue, 1'b0} - {5'b0, blue};
      sof_1     <= in_sof;
      eol_1     <= in_eol;

      grey_2    <= sum[15:8];
      sof_2     <= sof_1;
      eol_2     <= eol_1;

      out_grey  <= grey_2;
      out_dark  <= ({1'b0, grey_2} >= level) == above_is_dark;
      out_eol   <= eol_2;
    end
  end

  wire unused = &{1'b0, sum[7:0]};
endmodule
