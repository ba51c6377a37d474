"""What the triangles of the rock can show: how far they have moved, and the stress in them."""
import numpy as np

STRESSES = {"stress_xx": "stress xx", "stress_yy": "stress yy", "stress_xy": "shear stress xy"}


def _there(rock):
    """True of the triangles that have not dissolved."""
    if "gone" in rock.triangles:
        return rock.triangles["gone"].values < 0.5
    return np.ones(rock.triangles["vertices"].shape[0] // 3, dtype=bool)


def corners_of(rock):
    """Where the corners of the triangles that are left are now, (count, 3, 2) m; None without any."""
    if rock is None or "vertices" not in rock.triangles:
        return None
    corners = rock.triangles["vertices"].values[:, :2].reshape(-1, 3, 2)[_there(rock)]
    return corners if len(corners) else None


def _largest(values):
    """All but the few that stand out, as at the point of a load."""
    return float(np.percentile(np.abs(values), 99.5)) or None


def described(rock):
    """[(what a panel is made of, corners)]: the displacement and the components of the stress that are stored."""
    corners = corners_of(rock)
    if corners is None:
        return []
    fields, there, found = rock.triangles, _there(rock), []
    if "displacement" in fields:
        far = np.linalg.norm(fields["displacement"].values[there], axis=1)
        found.append({"name": "displacement", "title": "displacement", "unit": fields["displacement"].units, "values": far,
                      "colours": "viridis", "low": 0, "high": _largest(far)})
    for name, title in STRESSES.items():
        if name in fields:
            values = fields[name].values[there]
            most = _largest(values)
            found.append({"name": name, "title": title, "unit": fields[name].units, "values": values, "colours": "RdBu_r",
                          "low": -most if most else None, "high": most})
    return [(panel, corners) for panel in found]
