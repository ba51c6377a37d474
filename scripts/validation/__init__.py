"""The sections of docs/validation.md, one module per field of physics."""
from .records import Records
from . import flow, heat, solute, rock

chapters = [
    ("Flow", flow.entries),
    ("Heat", heat.entries),
    ("Solutes and dissolution", solute.entries),
    ("Rock", rock.entries),
]
__all__ = ["Records", "chapters"]
