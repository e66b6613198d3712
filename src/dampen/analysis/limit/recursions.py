"""What runs step by step: response, adjoint, Riccati recursion, the sweeps of its factors. Plain Python, compiled before use.

All work on one trial at a time, and the records carry on from one to the next. The state of a mode is z = (s q, q'), with s
its frequency, so that both parts weigh alike. Without forces it goes by the 2 by 2 block A of its own,

    z+ = A z + sum_p b_p u_p,    e = c z1 at every `every`-th time, both ends of the trial included.
"""

from __future__ import annotations

import numpy as np

from dampen.simulation.compiled import reassociated
from dampen.simulation.kernel import MODES_AT_MOST

# Rows of fixed size in records: the compiler then knows that they do not overlap, as in the kernel.
_ROW = (float, MODES_AT_MOST + 32)
_BLOCK = (("m11", *_ROW), ("m12", *_ROW), ("m21", *_ROW), ("m22", *_ROW))
MODAL = np.dtype([*((name, *_ROW) for name in ("z1", "z2", "a11", "a12", "a21", "a22", "e1", "e2")), ("count", int)])
PORT = np.dtype([(name, *_ROW) for name in ("b1", "b2", "w1", "w2", "x1", "x2", "g1", "g2")])
BLOCKS = np.dtype([*_BLOCK])


def respond(modal, ports, forces, load, every, outputs, found):
    """The motion under port forces (steps, ports) and a modal load (steps, modes) or none, (0, 0); z is carried in `modal`.

    outputs: (outputs, modes), on z1.   found: (times, outputs), filled.
    """
    m, steps = modal[0], len(forces)
    look(m, outputs, found[0])
    for k in range(steps):
        turn(m)
        for p in range(len(ports)):
            push(m, ports[p], forces[k, p])
        if len(load):
            carry(m, load[k])
        if (k + 1) % every == 0:
            look(m, outputs, found[(k + 1) // every])


def pull_back(modal, ports, errors, every, outputs, slopes):
    """The adjoint: slopes (steps, ports) = what `errors` (times, outputs), weighted with what they answer to each force, add
    up to. The costate is carried in `modal`, and trials come in reverse."""
    m, steps = modal[0], len(slopes)
    for k in range(steps, -1, -1):
        if k < steps:
            for p in range(len(ports)):
                slopes[k, p] = seen(m, ports[p])
            turn_back(m)
        if k % every == 0:
            charge(m, outputs, errors[k // every])


def factorise(modal, ports, blocks, weighting, every, cost, gains, inverses, scratch):
    """The Riccati recursion through one trial in reverse; P is carried in `blocks`, its lower half, and P b in `ports`.

        S = cost 1 + b' P b,    K = S^-1 b' P A,    P- = A' (P - P b S^-1 b' P) A,    and P + weighting at every measured time

    gains (steps, ports, 2, modes): K.   inverses (steps, ports, ports): S^-1.   scratch: (ports, ports).
    """
    m, steps = modal[0], len(gains)
    for i in range(m.count):
        weigh(blocks[i], weighting[i], i)
    collect(m, ports, blocks)
    for k in range(steps - 1, -1, -1):
        invert(m, ports, cost, scratch, inverses[k])
        for p in range(len(ports)):
            find_gain(m, ports, inverses[k, p], ports[p])
            write_gain(m, ports[p], gains[k, p])
        for p in range(len(ports)):
            restart(m, ports[p])
        for i in range(m.count):
            for p in range(len(ports)):
                lower(blocks[i], ports[p], i)
            transform(m, blocks[i], i)
            if k % every == 0:
                weigh(blocks[i], weighting[i], i)
            for p in range(len(ports)):
                project(blocks[i], ports[p], i)
        for p in range(len(ports)):
            adopt(m, ports[p])


def sweep_back(modal, ports, gains, inverses, slopes, found):
    """found = S^-1 (slopes + b' x),  x- = A' x - K' (slopes + b' x): the upper factor solved; x is carried in `modal`."""
    m, count = modal[0], len(ports)
    for k in range(len(slopes) - 1, -1, -1):
        for p in range(count):
            slopes[k, p] += seen(m, ports[p])
        turn_back(m)
        for p in range(count):
            add_gain(m, gains[k, p], -slopes[k, p])
            found[k, p] = 0.0
            for r in range(count):
                found[k, p] += inverses[k, p, r] * slopes[k, r]


def sweep_forward(modal, ports, gains, forces):
    """forces - K z,  z+ = A z + b forces: the lower factor solved, in place; z is carried in `modal`."""
    m = modal[0]
    for k in range(len(forces)):
        for p in range(len(ports)):
            forces[k, p] -= through_gain(m, gains[k, p])
        turn(m)
        for p in range(len(ports)):
            push(m, ports[p], forces[k, p])


@reassociated
def turn(m):
    """z+ = A z."""
    for i in range(m.count):
        z1, z2 = m.z1[i], m.z2[i]
        m.z1[i] = m.a11[i] * z1 + m.a12[i] * z2
        m.z2[i] = m.a21[i] * z1 + m.a22[i] * z2


@reassociated
def turn_back(m):
    """z- = A' z."""
    for i in range(m.count):
        z1, z2 = m.z1[i], m.z2[i]
        m.z1[i] = m.a11[i] * z1 + m.a21[i] * z2
        m.z2[i] = m.a12[i] * z1 + m.a22[i] * z2


@reassociated
def push(m, port, force):
    """z + b force."""
    for i in range(m.count):
        m.z1[i] += port.b1[i] * force
        m.z2[i] += port.b2[i] * force


@reassociated
def carry(m, load):
    """z + what a modal load does to it."""
    for i in range(m.count):
        m.z1[i] += m.e1[i] * load[i]
        m.z2[i] += m.e2[i] * load[i]


@reassociated
def seen(m, port):
    """b' z."""
    total = 0.0
    for i in range(m.count):
        total += port.b1[i] * m.z1[i] + port.b2[i] * m.z2[i]
    return total


@reassociated
def look(m, outputs, found):
    """c z1."""
    for o in range(len(outputs)):
        row, total = outputs[o], 0.0
        for i in range(m.count):
            total += row[i] * m.z1[i]
        found[o] = total


@reassociated
def charge(m, outputs, errors):
    """z1 + c' errors."""
    for o in range(len(outputs)):
        row, error = outputs[o], errors[o]
        for i in range(m.count):
            m.z1[i] += row[i] * error


@reassociated
def through_gain(m, gain):
    """K z."""
    first, second, total = gain[0], gain[1], 0.0
    for i in range(m.count):
        total += first[i] * m.z1[i] + second[i] * m.z2[i]
    return total


@reassociated
def add_gain(m, gain, factor):
    """z + K' factor."""
    first, second = gain[0], gain[1]
    for i in range(m.count):
        m.z1[i] += first[i] * factor
        m.z2[i] += second[i] * factor


@reassociated
def invert(m, ports, cost, scratch, inverse):
    """inverse = (cost 1 + b' w)^-1, w = P b, by Gauss-Jordan: the matrix is positive definite, so no pivots are sought."""
    count = len(ports)
    for p in range(count):
        for r in range(count):
            total = 0.0
            for i in range(m.count):
                total += ports[p].b1[i] * ports[r].w1[i] + ports[p].b2[i] * ports[r].w2[i]
            scratch[p, r] = total + (cost if p == r else 0.0)
            inverse[p, r] = 1.0 if p == r else 0.0
    for p in range(count):
        pivot = scratch[p, p]
        for r in range(count):
            scratch[p, r] /= pivot
            inverse[p, r] /= pivot
        for q in range(count):
            factor = scratch[q, p]
            if q != p:
                for r in range(count):
                    scratch[q, r] -= factor * scratch[p, r]
                    inverse[q, r] -= factor * inverse[p, r]


@reassociated
def find_gain(m, ports, row, port):
    """port.g = P b S^-1, the column of this port."""
    for i in range(m.count):
        port.g1[i] = 0.0
        port.g2[i] = 0.0
    for r in range(len(ports)):
        other, factor = ports[r], row[r]
        for i in range(m.count):
            port.g1[i] += factor * other.w1[i]
            port.g2[i] += factor * other.w2[i]


@reassociated
def write_gain(m, port, gain):
    """K = g' A."""
    first, second = gain[0], gain[1]
    for i in range(m.count):
        first[i] = port.g1[i] * m.a11[i] + port.g2[i] * m.a21[i]
        second[i] = port.g1[i] * m.a12[i] + port.g2[i] * m.a22[i]


def restart(m, port):
    """Nothing yet of the next P b."""
    for i in range(m.count):
        port.x1[i] = 0.0
        port.x2[i] = 0.0


def adopt(m, port):
    """The next P b is the present one."""
    for i in range(m.count):
        port.w1[i] = port.x1[i]
        port.w2[i] = port.x2[i]


@reassociated
def lower(row, port, i):
    """P - g w', row i of blocks up to the diagonal."""
    g1, g2 = port.g1[i], port.g2[i]
    for j in range(i + 1):
        row.m11[j] -= g1 * port.w1[j]
        row.m12[j] -= g1 * port.w2[j]
        row.m21[j] -= g2 * port.w1[j]
        row.m22[j] -= g2 * port.w2[j]


@reassociated
def transform(m, row, i):
    """A' P A, row i of blocks up to the diagonal."""
    a11, a12, a21, a22 = m.a11[i], m.a12[i], m.a21[i], m.a22[i]
    for j in range(i + 1):
        n11 = a11 * row.m11[j] + a21 * row.m21[j]
        n12 = a11 * row.m12[j] + a21 * row.m22[j]
        n21 = a12 * row.m11[j] + a22 * row.m21[j]
        n22 = a12 * row.m12[j] + a22 * row.m22[j]
        row.m11[j] = n11 * m.a11[j] + n12 * m.a21[j]
        row.m12[j] = n11 * m.a12[j] + n12 * m.a22[j]
        row.m21[j] = n21 * m.a11[j] + n22 * m.a21[j]
        row.m22[j] = n21 * m.a12[j] + n22 * m.a22[j]


@reassociated
def weigh(row, weighting, i):
    """P + weighting, which sits on the first part of the states."""
    for j in range(i + 1):
        row.m11[j] += weighting[j]


@reassociated
def project(row, port, i):
    """port.x gets what row i of blocks, and by symmetry column i, add to P b."""
    s1, s2, b1, b2 = 0.0, 0.0, port.b1[i], port.b2[i]
    for j in range(i):
        m11, m12, m21, m22 = row.m11[j], row.m12[j], row.m21[j], row.m22[j]
        s1 += m11 * port.b1[j] + m12 * port.b2[j]
        s2 += m21 * port.b1[j] + m22 * port.b2[j]
        port.x1[j] += m11 * b1 + m21 * b2
        port.x2[j] += m12 * b1 + m22 * b2
    port.x1[i] += s1 + row.m11[i] * b1 + row.m12[i] * b2
    port.x2[i] += s2 + row.m21[i] * b1 + row.m22[i] * b2


def collect(m, ports, blocks):
    """P b of all ports, from the whole of P."""
    for p in range(len(ports)):
        restart(m, ports[p])
        for i in range(m.count):
            project(blocks[i], ports[p], i)
        adopt(m, ports[p])
