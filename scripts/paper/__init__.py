"""The paper's nine conditions: what a run measured (run_data), its type (regimes), and the figures (figures)."""
