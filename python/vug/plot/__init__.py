"""Pictures of runs; needs matplotlib.

    import vug, vug.plot

    run = vug.open("runs/quickstart")
    vug.plot.overview(run[-1], "overview.png")
    vug.plot.topic(run.history, "acid", "acid.png")
"""
from .fields import field, overview, overview_figure, panels_of
from .histories import draw_curves, histories, topic, topics_of
from .movie import movie
from .panel import Frame, draw_panel
from .studies import draw_result, regime_map

__all__ = ["Frame", "draw_curves", "draw_panel", "draw_result", "field", "histories", "movie", "overview",
           "overview_figure", "panels_of", "regime_map", "topic", "topics_of"]
