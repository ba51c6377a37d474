"""The sections of docs/validation.md, one module per field of physics."""
from .records import Records, overview, wrap
from . import coupling, flow, heat, rock, rock_scenes, solute

chapters = [
    ("Flow", flow.entries),
    ("Heat", heat.entries),
    ("Solutes and dissolution", solute.entries),
    ("Rock", rock.entries + rock_scenes.entries),
    ("Couplings", coupling.entries),
]
__all__ = ["Records", "chapters", "overview", "wrap"]
