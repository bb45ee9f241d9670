// What is to be said of a frame at its end, collected where it happens: up to three frames are under way at once,
// one in the video guard, one in the cores, one whose last markers are being read.
module frame_notes #(
    parameter PW = 26
) (
    input  logic          clk,
    input  logic          reset,
    input  logic          video_begins,  // a frame's first pixel leaves the guard
    input  logic          bad_line,
    input  logic          cut_frame,     // the frame before was cut off
    input  logic          scan_begins,   // a frame's first pixel reaches the preprocess core
    input  logic          lost,
    input  logic          scan_ends,     // the contour core has handed on a frame's last chain
    input  logic          dropped,
    input  logic [PW-1:0] peaks,
    input  logic [   1:0] frame,         // the frame that is asked for, counted from reset
    output logic          frame_malformed,
    output logic          frame_lost,
    output logic          frame_dropped,
    output logic [PW-1:0] frame_peaks
);
  logic [1:0] at_video, at_scan, at_chains;
  logic [3:0] malformed_of, lost_of, dropped_of;
  logic [PW-1:0] peaks_of[0:3];
  assign frame_malformed = malformed_of[frame];
  assign frame_lost = lost_of[frame];
  assign frame_dropped = dropped_of[frame];
  assign frame_peaks = peaks_of[frame];

  always_ff @(posedge clk) begin
    if (bad_line) malformed_of[at_video] <= 1'b1;
    if (cut_frame) malformed_of[at_video-2'd1] <= 1'b1;
    if (video_begins) begin
      at_video <= at_video + 1'b1;
      malformed_of[at_video+2'd1] <= 1'b0;
    end
    if (lost) lost_of[at_scan] <= 1'b1;
    if (scan_begins) begin
      at_scan <= at_scan + 1'b1;
      lost_of[at_scan+2'd1] <= 1'b0;
    end
    if (dropped) dropped_of[at_chains] <= 1'b1;
    if (scan_ends) begin
      at_chains <= at_chains + 1'b1;
      peaks_of[at_chains] <= peaks;
      dropped_of[at_chains+2'd1] <= 1'b0;
    end
    if (reset) begin
      at_video <= '1;
      at_scan <= '1;
      at_chains <= '0;
      dropped_of <= '0;
    end
  end
endmodule
