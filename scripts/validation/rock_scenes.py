"""Rock of the example cases in cases/rock, read from the columns of their history, and its elasticity."""
import re

from .records import section, table


def per_cent(value):
    return f"{100 * (value - 1):+.1f} %"


def elasticity(records, _figures):
    rows = records["elasticity"]
    if not rows:
        return None
    return section(
        "Elasticity of bonded rock", "Elasticity",
        "The bonds of a generated block (60 mm, elements of 1.5 mm) are given the moduli that should yield E and ν: "
        "M_n = χ E/(1 - ν) and M_t = χ E/(1 + 3ν). The block is pressed, and its E and ν are measured.",
        table(["ν given", "E measured / given", "ν measured"],
              [(f"{r['nu']:.3f}", f"{r['young']:.4f}", f"{r['poisson']:.4f}") for r in rows]),
        overview=("E and ν of a generated block", "those given",
                  f"E within {100 * max(abs(r['young'] - 1) for r in rows):.1f} %, "
                  f"ν within {max(abs(r['poisson'] - r['nu']) for r in rows):.4f}"))


def statics(records, _figures):
    bent, arm, across, along, warm, split, hole = (
        records[n] for n in ("three_point_bending", "cantilever", "layered", "layered_along", "layered_heat", "double_cantilever", "kirsch"))
    if not (bent and arm and across and along and warm and split and hole):
        return None
    rows = [
        ("three_point_bending", "sag in the middle", "Timoshenko", per_cent(bent[-1]["sag"])),
        ("three_point_bending", "stress below", "M y / I", per_cent(bent[-1]["stress"])),
        ("three_point_bending", "force of a bearing", "P / 2", per_cent(bent[-1]["bearing"])),
        ("cantilever", "deflection of the tip", "Timoshenko", per_cent(arm[-1]["tip"])),
        ("double_cantilever", "compliance gained by 30 mm of crack", "Fichter 1983, dC/da = 2 G / P²", per_cent(split[-1]["gain"])),
        ("layered", "modulus across the layers", "Reuss", per_cent(across[-1]["across"])),
        ("layered, pulled along", "stress of soft and stiff layers", "Voigt", f"{per_cent(along[-1]['soft'])}, {per_cent(along[-1]['stiff'])}"),
        ("layers with α and 2 α, warm", "stress of core and rind", "laminate theory", f"{per_cent(warm[-1]['core'])}, {per_cent(warm[-1]['rind'])}"),
    ]
    rows += [("hole_in_a_plate", f"stress along and across, {r['gauge']} the hole" if r["gauge"] != "rim" else "stress along and across at the rim",
              "Kirsch, mean over the gauge",
              ", ".join(per_cent(1 + (r[c] - r[f"exact_{c}"]) / max(1, abs(r[f"exact_{c}"]))) for c in ("xx", "yy"))
              + " of the stress or the pull, which is larger")
             for r in {r["gauge"]: r for r in hole}.values()]
    most = max(abs(float(number)) for row in rows for number in re.findall(r"[-+]\d+\.\d+(?= %)", row[-1]))
    return section(
        "Beams, layers and holes", "ThreePointBending, Cantilever, DoubleCantilever, LayeredRock, HoleInAPlate",
        "The example cases of `cases/rock` under steady loads, read from the gauges in their `history.csv`.",
        table(["case", "number", "against", "deviation"], rows),
        limits="Beams of 12 to 20 triangles in their height are 2 to 3 % too stiff, of first order in the size of the "
        "triangles. Bearings stand at centroids.",
        overview=("beams, layers, a hole under steady loads", "Timoshenko, Fichter, laminate theory, Kirsch",
                  f"within {most:.1f} %"))


def dynamics(records, _figures):
    wave, crack, meeting = (records[n] for n in ("impact", "impact_crack", "meeting_bodies"))
    if not (wave and crack and meeting):
        return None
    w, c, m = wave[-1], crack[-1], meeting[-1]
    return section(
        "Impact", "Impact, MeetingBodies",
        "In `cases/rock/impact.toml` a side is struck; waves travel at c = (E/(1 - ν²)/ρ)^½. The wave comes back as "
        "tension from the free side and starts a crack at a notch. In a second test two halves of a bar meet at a "
        "crack and must exchange their speeds.",
        table(["number", "against", "measured"],
              [("speed of the wave", "c", per_cent(w["speed"])),
               ("its stress", "ρ c v", per_cent(w["stress"])),
               ("largest speed of the crack over 6 µs", "below Rayleigh's", f"{c['fastest']:.2f} of it"),
               ("speeds after two halves have met", "0 and 1 m/s", f"{m['left']:.3f} and {m['right']:.3f} m/s")]),
        overview=("speed and stress of the wave of an impact", "c, ρ c v",
                  f"{per_cent(w['speed'])} and {per_cent(w['stress'])}"))


entries = [elasticity, statics, dynamics]
