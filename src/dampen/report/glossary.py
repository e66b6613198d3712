"""What the words, signs and columns of a report mean: for the page itself, and for the documentation."""

from __future__ import annotations

WORDS = {
    "y, v, u, B": (
        "a port's displacement or rotation, the rate that the law sees, the law's command (before any compensation), and "
        "the force or torque B(u) that the actuator delivers to the structure. Exactly v = 0: the port sticks."
    ),
    "C, C1, C2": "the constraint |y| < C; C1 that of w(L, t), C2 that of phi(L, t).",
    "margin": (
        "the share of the constraint that was never used: 1 - largest |y|/C. Negative: the constraint was passed by that share."
    ),
    "peak": (
        "the largest value over the whole structure and every step. Fields are kept at some points and times only, so "
        "that a peak may lie at a port, between two of these snapshots."
    ),
    "residual": "the root mean square of a port's error in the last five trials (of all, if there are fewer).",
    "effort": (
        "the root mean square of what an actuator delivered, at a port in its own unit. Of a limit: of all ports "
        "together, a torque divided by the structure's length, in N."
    ),
    "stuck": "the share of steps in which a port's v was exactly zero.",
    "static": "the part of the energy that bends the structure to where its stuck ports stand: it is not a vibration.",
    "n/a": "nothing can be said of it in this run; the row says why.",
    "signals that do not grow": (
        "y, v, command, delivered force and each of the law's memories at every port, and the structure's energy: the "
        "largest of the last fifth of the trials, five at the least, is at most 105 % of the largest before. Where trials differ "
        "by chance, most of that fifth must be above to count as growth. Claim T1 counts E_j among them."
    ),
    "zeta, d_hat": (
        "memories of the paper's law: what is learned, zeta_j = zeta_(j-1) - alpha_4 v, the outer loop; and the estimate "
        "of the disturbance's bound, d_hat, which grows by alpha_8 |v| and never falls, the inner loop."
    ),
    "f_bar, d_bar": "the bounds of the load and of a port's disturbance that the law was told.",
    "V": "energy of the structure and of the law's barrier and springs; its bound follows from the stated bounds alone.",
    "E_j(T_b)": (
        "the composite energy of the paper's proof at the end of trial j: E1 the structure's and E2 the payload's energy, "
        "E3 the barrier's, E4 what is learned, E5 the observer's; the first three weighted by e^(-lambda t). (46) is the "
        "equation of the paper by which it should fall."
    ),
    "slack": "by how much an inequality holds; of two, the first and the second part of it. Negative: by so much it does not.",
    "port disturbances, load": "d at the ports, f(x, t) along the structure; works are counted one by one, from what acted.",
    "closing error": (
        "change of energy minus all works, as a share of the largest energy: over the whole run in the energy account, "
        "the largest over the run and each trial in the audit."
    ),
    "numerical compliance": (
        "a small spring and damper, proportional to the step, between the law and the port, which lets a stuck port hold "
        "its force without flipping it. What it stores and takes is in the account."
    ),
    "B = 0 before trial 0": "where the backlash stood when the run began: it delivered nothing.",
    "without a part": (
        "credit: the run again with this part of the law left out; the number behind the times sign is the ratio to the "
        "whole law, above 1 where the part helps."
    ),
    "mean energy": "of the structure in the last five trials; the account's energy at the end is that of the last instant.",
    "finer": "the same gains on twice the modes with half the step.",
}
