// The 3x3 filter of the paper's Fig. 2: the middle pixel once the cases that are on are mended, as
// src/preprocess/filter_table.h defines it. Window bits: 0 1 2 above, 3 4 5 beside, 6 7 8 below; 1 = dark.
module filter (
    input  logic [8:0] window,
    input  logic [5:0] cases,  // bits (a) to (f)
    output logic       dark
);
  wire nw = window[0], n = window[1], ne = window[2];
  wire w = window[3], c = window[4], e = window[5];
  wire sw = window[6], s = window[7], se = window[8];

  wire any_dark = nw | ne | sw | se;
  wire any_light = !(nw & ne & sw & se);
  wire dark_side = (nw | se) & (ne | sw);
  wire light_side = (!nw | !se) & (!ne | !sw);

  wire single = c & !(n | s | w | e);
  wire hole = !c & n & s & w & e;
  wire column = !c & w & e & !(n & s) & (n | (nw & ne)) & (s | (sw & se));

  wire flip = (hole & light_side & cases[0])
            | (single & any_dark & !dark_side & cases[1])
            | (hole & any_light & !light_side & cases[2])
            | (single & !any_dark & cases[3])
            | (hole & !any_light & cases[4])
            | (column & cases[5]);
  assign dark = c ^ flip;
endmodule
