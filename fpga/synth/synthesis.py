"""What yosys makes of a core: LUT, FF, DSP, RAM and the slowest path before routing."""
import json
import os
import re
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RTL = os.path.join(ROOT, "fpga", "rtl")

# A RAM or shift register in LUTs counts as many as it fills.
LUTS_OF = {"RAM32M": 4, "RAM64M": 4, "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1D": 4, "RAM32X1S": 1, "RAM64X1S": 1,
           "SRL16E": 1, "SRLC32E": 1, "INV": 1, "LUT1": 1, "LUT2": 1, "LUT3": 1, "LUT4": 1, "LUT5": 1, "LUT6": 1}
LISTS = re.compile(r"(pool\.(place|next)|ends|cracks\.memory)$")  # the paper's run lengths and segments
LINES = re.compile(r"(^|\.)(line|ring|band|above|levels)$")  # rows of pixels and of tiles


class Failed(Exception):
    pass


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        lines = [line for line in (done.stderr + done.stdout).splitlines() if "ERROR" in line]
        raise Failed(f"{os.path.basename(command[0])}: {(lines or ['failed'])[0]}")
    return done.stdout + done.stderr


def sources(module):
    """The files of a module and of all it is made of."""
    known = {name[:-3] for name in os.listdir(RTL) if name.endswith(".sv")}
    found, open_ones = [], [module]
    while open_ones:
        name = open_ones.pop()
        if name in found:
            continue
        found.append(name)
        with open(os.path.join(RTL, name + ".sv")) as file:
            words = re.findall(r"^\s*(\w+)\s+(?:#\s*\(|\w+\s*\()", file.read(), re.M)
        open_ones += [word for word in words if word in known]
    return " ".join(name + ".sv" for name in sorted(found))


def memories(netlist):
    """Bits of each memory as written, whatever it is mapped to."""
    # Its name says its parameters where they were changed.
    top = next(module for module in netlist["modules"].values() if "top" in module["attributes"])
    found = {}
    for name, cell in top["cells"].items():
        if cell["type"] in ("$mem", "$mem_v2"):
            parameters = cell["parameters"]
            found[name.lstrip("\\")] = int(parameters["WIDTH"], 2) * int(parameters["SIZE"], 2)
    return found


def synthesise(core, module, parameters=None):
    """One entry of the report. `parameters` replace those of the module."""
    change = "".join(f"chparam -set {name} {value} {module}; " for name, value in (parameters or {}).items())
    with tempfile.TemporaryDirectory() as directory:
        netlist = os.path.join(directory, "memories.json")
        log = run(["yosys", "-Q", "-p",
                   f"read_verilog -sv -I. {sources(module)}; {change} design -save rtl; "
                   f"hierarchy -top {module}; proc; opt_clean; flatten; memory_dff; memory_collect; "
                   f"write_json {netlist}; design -load rtl; "
                   f"synth_xilinx -family xc7 -flatten -top {module}; tee -a /dev/stdout stat; "
                   # Without the timing of the library's cells read again, sta skips carry and mux paths.
                   "read_verilog -overwrite -lib -specify +/xilinx/cells_sim.v; sta"], cwd=RTL)
        with open(netlist) as file:
            memory = memories(json.load(file))
    if "no timing arcs" in log:
        raise Failed(f"{core}: sta: " + re.search(r"Module '\S+' has no timing arcs", log).group(0))
    arrival = re.search(r"Latest arrival time in '\S+' is (\d+)", log)
    if not arrival:
        raise Failed(f"{core}: sta found no path")
    stat = log[log.rindex("Number of cells:"):]
    cells = {name: int(count) for name, count in re.findall(r"^\s+([A-Z][A-Z0-9_]+)\s+(\d+)\s*$", stat, re.M)}
    return {"core": core,
            "lut": sum(LUTS_OF[name] * count for name, count in cells.items() if name in LUTS_OF),
            "ff": sum(count for name, count in cells.items() if name.startswith("FD")),
            "ram_bits": sum(memory.values()),
            "list_bits": sum(bits for name, bits in memory.items() if LISTS.search(name)),
            "line_bits": sum(bits for name, bits in memory.items() if LINES.search(name)),
            "ramb18": cells.get("RAMB18E1", 0) + 2 * cells.get("RAMB36E1", 0),
            "dsp": cells.get("DSP48E1", 0),
            "path_ps": int(arrival.group(1))}


def yosys_version():
    return run(["yosys", "-V"]).split()[1]
