"""A third baseline: the paper's equations typed in one after the other, as a first working script has them.

The same scheme as `baselines.numpy_loop` (uniform grid, central differences, explicit in time, vectorised over x), but nothing
is precomputed, folded or turned into Python floats: every step evaluates (15)-(18) and (26)-(28) as they are printed, with
NumPy's functions, and stores the whole of w(x, t) and phi(x, t) for the plots.
"""

from __future__ import annotations

import time

import numpy as np
from baselines import Run

rho, L, M, EI, I_rho, J, K = 1.0, 1.0, 0.1, 35.0, 2.0, 0.1, 15.0
m, B_r, B_l = 0.3, 0.1, -0.2
C1 = C2 = 0.2
d_bar, f_bar, T_b = 0.3, 0.15, 2.0
alpha = np.array([np.nan, 1, 1, 0.1, 1, 1, 0.1, 1, 0.1, 0.1])


def deadzone(xi):
    width = m * (B_r - B_l)
    return np.where(xi <= 0, xi, np.where(xi < width, 0.0, xi - width))


def backlash(B, xi):
    return np.minimum(np.maximum(B, xi - m * (B_r - B_l)), xi)


def barrier(q, C):
    return q / (C**2 - q**2) * np.log(C**2 / (C**2 - q**2))


def paper_loop(trials: int = 25, nx: int = 21, dt: float = 1e-3) -> Run:
    """All trials; see the module's docstring."""
    begin = time.perf_counter()
    x = np.linspace(0, L, nx)
    dx, nt = x[1] - x[0], round(T_b / dt)
    zeta_u, zeta_tau, d1, d2 = np.zeros((4, nt))
    B_u = B_tau = 0.0
    w_now, phi_now = 0.16 * x, 0.18 * x
    w_t, phi_t = np.full(nx, 0.1), np.full(nx, 0.1)
    w_t[0] = phi_t[0] = 0.0
    peak_w, peak_phi = [], []
    for j in range(trials):
        w, phi = np.zeros((nt + 1, nx)), np.zeros((nt + 1, nx))
        w[0], phi[0] = w_now, phi_now
        for k in range(nt):
            t = k * dt
            a = (j + 1) * np.pi * t
            d_w = (np.cos(a) + np.cos(2 * a) + np.cos(3 * a)) / 10
            d_phi = (np.cos(2 * a) + np.cos(4 * a) + np.cos(6 * a)) / 10
            f = (np.sin(a * x) + np.sin(2 * a * x) + np.sin(3 * a * x)) / 20

            xi_u = zeta_u[k] - alpha[4] * w_t[-1]
            d1[k] = d1[k] + alpha[8] * np.abs(w_t[-1])
            xi_u0 = (
                xi_u - (d1[k] + 2 * alpha[1] * f_bar * L + alpha[2] * d_bar) * np.sign(w_t[-1]) - alpha[3] * barrier(w[k, -1], C1)
            )
            zeta_u[k] = deadzone(xi_u)
            B_u = backlash(B_u, xi_u0)
            xi_tau = zeta_tau[k] - alpha[7] * phi_t[-1]
            d2[k] = d2[k] + alpha[9] * np.abs(phi_t[-1])
            xi_tau0 = xi_tau - (d2[k] + alpha[5] * d_bar) * np.sign(phi_t[-1]) - alpha[6] * barrier(phi[k, -1], C2)
            zeta_tau[k] = deadzone(xi_tau)
            B_tau = backlash(B_tau, xi_tau0)

            shear = K * ((w[k, 1:] - w[k, :-1]) / dx - (phi[k, 1:] + phi[k, :-1]) / 2)
            moment = EI * (phi[k, 1:] - phi[k, :-1]) / dx
            w_tt, phi_tt = np.zeros(nx), np.zeros(nx)
            w_tt[1:-1] = ((shear[1:] - shear[:-1]) / dx + f[1:-1]) / rho
            phi_tt[1:-1] = ((moment[1:] - moment[:-1]) / dx + (shear[1:] + shear[:-1]) / 2) / I_rho
            w_tt[-1] = (-shear[-1] + f[-1] * dx / 2 + d_w + B_u) / (M + rho * dx / 2)
            phi_tt[-1] = (-moment[-1] + shear[-1] * dx / 2 + d_phi + B_tau) / (J + I_rho * dx / 2)
            w_t = w_t + dt * w_tt
            phi_t = phi_t + dt * phi_tt
            w[k + 1] = w[k] + dt * w_t
            phi[k + 1] = phi[k] + dt * phi_t
        w_now, phi_now = w[-1], phi[-1]
        peak_w.append(float(np.abs(w[:, -1]).max()))
        peak_phi.append(float(np.abs(phi[:, -1]).max()))
    return Run(peak_w, peak_phi, trials * nt, time.perf_counter() - begin)
