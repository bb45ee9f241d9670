"""A core placed and routed on the Lattice iCE40 HX8K, the part that open tools know to the end.

The part has fewer pins than a core has ports, so the core stands in a frame of registers: its inputs come from
a shift register, its outputs go into another."""
import json
import os
import re
import tempfile

from synthesis import RTL, Failed, run, sources

FRAME = """module frame (input wire clk, input wire in, output reg out);
  reg [{inputs}-1:0] from;
  reg [{outputs}-1:0] to;
  wire [{outputs}-1:0] now;
  always @(posedge clk) begin
    from <= {{from, in}};
    to <= in ? now : to >> 1;
    out <= to[0];
  end
  {module} core ({ports});
endmodule
"""


def frame_of(module, directory):
    """The frame as Verilog, and how many flip-flops it has."""
    path = os.path.join(directory, "ports.json")
    run(["yosys", "-Q", "-p", f"read_verilog -sv -I. {sources(module)}; hierarchy -top {module}; proc; "
         f"write_json {path}"], cwd=RTL)
    with open(path) as file:
        ports = json.load(file)["modules"][module]["ports"]
    bits = {"input": 0, "output": 0}
    wired = []
    for name, port in ports.items():
        if name == "clk":
            wired.append(".clk(clk)")
            continue
        low = bits[port["direction"]]
        bits[port["direction"]] += len(port["bits"])
        vector = "from" if port["direction"] == "input" else "now"
        wired.append(f".{name}({vector}[{bits[port['direction']] - 1}:{low}])")
    text = FRAME.format(inputs=bits["input"], outputs=bits["output"], module=module, ports=", ".join(wired))
    return text, bits["input"] + bits["output"] + 1


def place(core, module):
    """Logic cells, memory blocks and clock after routing; `why` instead where it does not fit."""
    with tempfile.TemporaryDirectory() as directory:
        text, own = frame_of(module, directory)
        frame = os.path.join(directory, "frame.v")
        netlist = os.path.join(directory, "frame.json")
        with open(frame, "w") as file:
            file.write(text)
        run(["yosys", "-Q", "-p", f"read_verilog -sv -I. {sources(module)} {frame}; "
             f"synth_ice40 -top frame -json {netlist}"], cwd=RTL)
        try:
            log = run(["nextpnr-ice40", "--hx8k", "--package", "ct256", "--freq", "100", "--seed", "1",
                       "--timing-allow-fail", "--json", netlist])
        except Failed as why:
            return {"core": core, "why": str(why)}
    cells = re.search(r"ICESTORM_LC:\s+(\d+)/", log)
    blocks = re.search(r"ICESTORM_RAM:\s+(\d+)/", log)
    clock = re.findall(r"Max frequency for clock '\S+': ([\d.]+) MHz", log)
    return {"core": core, "cells": int(cells.group(1)), "frame": own, "blocks": int(blocks.group(1)),
            "mhz": float(clock[-1])}

