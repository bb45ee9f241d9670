// Searches the cells of a marker in the dictionary, at four rotations: the inner cells come in one by one and are
// packed into a code for each rotation, then all codes go by, one a clock.
module code_search #(
    parameter CODES = 1024,
    parameter IW = $clog2(CODES)
) (
    input  logic          clk,
    input  logic          reset,
    input  logic [   3:0] width,       // of a marker, border included
    input  logic [   5:0] max_errors,  // wrong bits
    input  logic [  IW:0] codes,       // in the dictionary
    input  logic          write,       // a code: row by row, the last cell in bit 0; 1 = white
    input  logic [  IW-1:0] write_at,
    input  logic [  63:0] write_code,

    input  logic          cell_write,  // a cell's colour
    input  logic [   2:0] cell_row,    // of the inner ones
    input  logic [   2:0] cell_column,
    input  logic          cell_white,

    input  logic          start,
    output logic          found,       // for a clock; the rest stays
    output logic          over,        // it is not in the dictionary
    output logic          turn,        // on to the next rotation
    output logic [IW-1:0] id,
    output logic [   1:0] rotation,
    output logic [   5:0] errors
);
  localparam [1:0] REST = 2'd0, PACK = 2'd1, MATCH = 2'd2;
  logic [1:0] state;

  // The cells, seen as the marker is turned.
  logic grid[0:63];
  always_ff @(posedge clk) if (cell_write) grid[{cell_row, cell_column}] <= cell_white;
  logic [2:0] row, column;
  wire [2:0] last = width[2:0] - 3'd3;  // 4 to 8 cells a side
  logic [5:0] pack_from;
  always_comb begin
    case (rotation)
      2'd0: pack_from = {row, column};
      2'd1: pack_from = {column, last - row};
      2'd2: pack_from = {last - row, last - column};
      default: pack_from = {last - column, row};
    endcase
  end

  logic [63:0] dictionary[0:CODES-1];
  logic [63:0] code, entry;
  logic [IW:0] search_at, checked;
  always_ff @(posedge clk) begin
    if (write) dictionary[write_at] <= write_code;
    entry <= dictionary[search_at[IW-1:0]];
  end

  // How many bits differ: counted in threes, then in sixes the ones and the twos of these counts.
  wire [65:0] different = {2'b0, entry ^ code};
  logic [23:0] ones, twos;
  function automatic [2:0] six(input [5:0] v);
    logic a, b, c, d, both;
    a = v[0] ^ v[1] ^ v[2];
    b = v[3] ^ v[4] ^ v[5];
    c = (v[0] & v[1]) | (v[0] & v[2]) | (v[1] & v[2]);
    d = (v[3] & v[4]) | (v[3] & v[5]) | (v[4] & v[5]);
    both = a & b;
    six = {(c & d) | (c & both) | (d & both), c ^ d ^ both, a ^ b};
  endfunction
  logic [2:0] sum_ones[0:3];
  logic [2:0] sum_twos[0:3];
  logic [6:0] wrong;
  wire [4:0] all_ones = ({2'b0, sum_ones[0]} + {2'b0, sum_ones[1]}) + ({2'b0, sum_ones[2]} + {2'b0, sum_ones[3]});
  wire [4:0] all_twos = ({2'b0, sum_twos[0]} + {2'b0, sum_twos[1]}) + ({2'b0, sum_twos[2]} + {2'b0, sum_twos[3]});

  logic [3:0] searching;  // the codes on their way
  wire search_more = state == MATCH && search_at != codes;
  wire hit = state == MATCH && searching[3] && wrong <= {1'b0, max_errors};
  wire search_over = state == MATCH && !search_more && searching == '0;
  assign turn = search_over && rotation != 2'd3;

  always_ff @(posedge clk) begin
    for (int i = 0; i < 22; i++) begin
      ones[i] <= different[3*i] ^ different[3*i+1] ^ different[3*i+2];
      twos[i] <= (different[3*i] & different[3*i+1]) | (different[3*i] & different[3*i+2])
               | (different[3*i+1] & different[3*i+2]);
    end
    {ones[23:22], twos[23:22]} <= '0;
    for (int i = 0; i < 4; i++) begin
      sum_ones[i] <= six(ones[6*i+:6]);
      sum_twos[i] <= six(twos[6*i+:6]);
    end
    wrong <= {2'b0, all_ones} + {1'b0, all_twos, 1'b0};

    found <= hit;
    over <= search_over && rotation == 2'd3 && !hit;
    searching <= {searching[2:0], search_more} & {4{state == MATCH && !hit}};
    if (state != MATCH) begin
      search_at <= '0;
      checked <= '0;
    end else begin
      if (search_more) search_at <= search_at + 1'b1;
      if (searching[3]) checked <= checked + 1'b1;
    end
    if (hit) begin
      id <= checked[IW-1:0];
      errors <= wrong[5:0];
    end

    case (state)
      REST: begin
        code <= '0;
        row <= '0;
        column <= '0;
        rotation <= start ? '0 : rotation;
        if (start) state <= PACK;
      end
      PACK: begin
        code <= {code[62:0], grid[pack_from]};
        column <= column == last ? '0 : column + 1'b1;
        if (column == last) row <= row == last ? '0 : row + 1'b1;
        if (column == last && row == last) state <= MATCH;
      end
      default: begin
        if (turn) begin
          code <= '0;
          rotation <= rotation + 1'b1;
        end
        if (hit || search_over) state <= turn && !hit ? PACK : REST;
      end
    endcase
    if (reset) begin
      state <= REST;
      searching <= '0;
    end
  end
  wire unused = &{1'b0, width[3]};
endmodule
