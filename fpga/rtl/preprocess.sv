// The pre-process core: lays the white border, filters with a 3x3 window and turns what is left into the
// events the contour core follows (docs/hardware.md, events). One line store of three bits a pixel: the two
// unfiltered rows above and the filtered row above. Everything moves one step for each pixel taken in; when
// the frame's last pixel is in, as many steps follow by themselves as the filter runs behind.
//
// The image wraps round at its sides: the white border makes that harmless.
module preprocess #(
    parameter MAX_WIDTH = 640,
    parameter MAX_HEIGHT = 480,
    parameter XW = $clog2(MAX_WIDTH),
    parameter YW = $clog2(MAX_HEIGHT)
) (
    input  logic          clk,
    input  logic          reset,
    input  logic [XW-1:0] last_x,          // width - 1
    input  logic [YW-1:0] last_y,          // height - 1
    input  logic [   5:0] cases,           // which cases of Fig. 2 are mended
    input  logic          eight,           // dark pixels that meet at a corner only are connected
    input  logic          give_up,         // when events are held back, drop the rest of the frame
    input  logic          in_valid,
    output logic          in_ready,
    input  logic          in_dark,
    input  logic          in_sof,          // first pixel: a frame begins, whatever became of the one before
    output logic          out_valid,
    input  logic          out_ready,
    output logic [   2:0] out_kind,        // of the events below
    output logic          out_top,         // the run is dark below, else dark above
    output logic          out_left_above,  // of a shift: the run's left end is the crack of the row above
    output logic [XW-1:0] out_x,           // crack at which the run is left
    output logic [YW-1:0] out_y,           // crack line
    output logic          lost             // pulse: the rest of a frame is being dropped
);
  localparam [2:0] STRAIGHT = 3'd0;  // a crack goes on downwards
  localparam [2:0] SHIFT = 3'd1;     // a run from a crack above to one below
  localparam [2:0] START = 3'd2;     // a run between two cracks below
  localparam [2:0] JOIN = 3'd3;      // a run between two cracks above
  localparam [2:0] BEGIN_FRAME = 3'd4;
  localparam [2:0] END_FRAME = 3'd5;

  // Where the frame stands: the pixel to come in next, and whether it is to come from the input.
  logic [XW-1:0] x;
  logic [YW-1:0] y;
  logic filling, flushing, ending;

  wire blocked = out_valid && !out_ready;
  logic lost_rest;  // the rest of this frame goes by unseen
  logic event_here;
  wire losing = blocked && give_up && event_here && !lost_rest && (flushing || (in_valid && filling));
  wire free = !blocked || lost_rest || !event_here;
  assign in_ready = free && !flushing && !ending && !(in_valid && in_sof && blocked);
  wire begins = in_valid && in_ready && in_sof;
  wire takes = in_valid && in_ready && (in_sof || filling);
  wire step = takes || (flushing && free);

  // The same as `begins` where a step is taken, and known sooner.
  wire fresh = in_sof && !flushing;
  wire [XW-1:0] here_x = fresh ? '0 : x;
  wire [YW-1:0] here_y = fresh ? '0 : y;
  wire ends_line = here_x == last_x;
  wire border = here_x == '0 || ends_line || here_y == '0 || here_y == last_y;
  wire raw = in_dark && !border && !flushing;

  // The line store, read one step ahead.
  (* ram_style = "block" *) logic [2:0] line[0:MAX_WIDTH-1];
  logic [2:0] stored;
  wire [XW-1:0] next_x = ends_line ? '0 : here_x + 1'b1;
  logic first_row;  // the store still holds the frame before
  wire masks = fresh || first_row;
  wire above_1 = stored[0] && !masks;
  wire above_2 = stored[1] && !masks;
  wire clean_above = stored[2] && !masks;

  logic clean;
  always_ff @(posedge clk) begin
    if (step) line[here_x] <= {clean && !fresh, above_1, raw};
    if (step) stored <= line[next_x];
  end

  // The window: columns of {below, middle, above}; its middle is two steps and a row behind.
  logic [2:0] west, middle, east;
  logic filtered;
  filter filter_i (
      .window({east[2], middle[2], west[2], east[1], middle[1], west[1], east[0], middle[0], west[0]}),
      .cases(cases),
      .dark(filtered)
  );

  // The 2x2 window of filtered pixels, and where it stands: four steps and a row behind.
  logic a, c, a_left, c_left;
  logic [XW-1:0] at_x;
  logic [YW:0] at_y;  // negative before the first row
  logic [3:0] begun;  // the begin of the frame on its way here

  wire crack_above = a_left ^ a;
  wire crack_below = c_left ^ c;
  wire in_run = a_left ^ c_left;
  wire run_next = a ^ c;
  wire crosswise = in_run && run_next && crack_above;
  wire end_run = in_run && (crack_above || crack_below);
  wire begin_run = run_next && (crack_above || crack_below);
  wire left_takes_above = crosswise ? c_left == eight : crack_above;
  wire straight = crack_above && crack_below && !in_run && !run_next;
  logic [XW-1:0] run_x;
  logic run_above;

  wire last_step = flushing && at_x == last_x && at_y == {1'b0, last_y};
  assign event_here = straight || end_run;
  wire emits = step && event_here && !lost_rest;

  always_ff @(posedge clk) begin
    lost <= losing && !reset;
    if (reset) begin
      filling <= 1'b0;
      flushing <= 1'b0;
      ending <= 1'b0;
      lost_rest <= 1'b0;
      out_valid <= 1'b0;
    end else begin
      if (begins) lost_rest <= 1'b0;
      else if (losing) lost_rest <= 1'b1;

      if (takes) begin
        filling <= !(ends_line && here_y == last_y);
        flushing <= ends_line && here_y == last_y;
      end else if (last_step && step) begin
        flushing <= 1'b0;
        ending <= 1'b1;
      end else if (ending && !blocked) begin
        ending <= 1'b0;
      end

      if (!blocked) out_valid <= begins || emits || ending;
    end

    if (begins) first_row <= 1'b1;
    else if (step && ends_line && last_x != '0) first_row <= 1'b0;  // one column alone is all border

    if (step) begin
      x <= next_x;
      if (fresh) y <= ends_line ? YW'(1) : '0;
      else if (ends_line) y <= y + 1'b1;

      east <= {raw, above_1, above_2};
      middle <= fresh ? '0 : east;
      west <= fresh ? '0 : middle;
      clean <= !fresh && filtered;
      c <= !fresh && clean;
      a <= clean_above;
      c_left <= !fresh && c;
      a_left <= !fresh && a;

      begun <= {begun[2:0] & {3{!fresh}}, fresh};
      if (fresh) begin
        at_y <= '1;
      end else if (begun[3]) begin
        at_x <= last_x == '0 ? '0 : XW'(1);
        at_y <= last_x == '0 ? '0 : '1;
      end else if (begun == '0) begin
        at_x <= at_x == last_x ? '0 : at_x + 1'b1;
        if (at_x == last_x) at_y <= at_y + 1'b1;
      end
      if (begin_run) begin
        run_x <= at_x;
        run_above <= crosswise ? !left_takes_above : crack_above;
      end
    end

    if (!blocked) begin
      out_kind <= begins ? BEGIN_FRAME : ending ? END_FRAME : straight ? STRAIGHT
                : run_above != left_takes_above ? SHIFT : run_above ? JOIN : START;
      out_top <= c_left;
      out_left_above <= run_above;
      out_x <= c_left ? at_x : run_x;
      out_y <= at_y[YW-1:0];
    end
  end
endmodule
