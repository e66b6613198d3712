"""The figures of section V, with the paper's numbers."""

from __future__ import annotations

from dampen.scenarios.figures import FigurePlan

FIGURES = (
    FigurePlan("fig05", "field", "w", "w(x, t) without control", controlled=False),
    FigurePlan("fig06", "field", "phi", "phi(x, t) without control", controlled=False),
    FigurePlan("fig07", "port", "tip_w", "w(L, t) without control", controlled=False),
    FigurePlan("fig08", "port", "tip_phi", "phi(L, t) without control", controlled=False),
    FigurePlan("fig09", "field", "w", "w(x, t) under control"),
    FigurePlan("fig10", "field", "phi", "phi(x, t) under control"),
    FigurePlan("fig11", "port", "tip_w", "w(L, t) under control"),
    FigurePlan("fig12", "port", "tip_phi", "phi(L, t) under control"),
    FigurePlan("fig13", "peaks", "w", "largest |w| of each trial"),
    FigurePlan("fig14", "peaks", "phi", "largest |phi| of each trial"),
    FigurePlan("fig15", "delivered", "tip_w", "delivered force B(u_0)"),
    FigurePlan("fig16", "delivered", "tip_phi", "delivered torque B(tau_0)"),
)

KEY = "F5 to F16: what the paper's figures of these numbers show; T1, T2a to T2d: its theorems 1 and 2."
GAINS = "The paper's gains are lost but for alpha_9 = 0.1: those used here are ours."
NOTE = "The amplitude of the load (1/20, by analogy) and B = 0 before trial 0, the state of the backlash, are ours."
