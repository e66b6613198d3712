"""All ports of one step: each port's closure is solved inside the response of the ports before it.

The ports are coupled by v = v_free + G B. Port p is solved with the later ports' forces as guessed. How its own force would
answer to theirs, answer_p = dB_p/dv_free, is then eliminated from the equations of the later ports, as in Gaussian elimination;
back substitution follows, and every port but the last is checked against the forces that came out. Where no port changed
between sticking and slipping that is Newton's method on a piecewise smooth problem: one round settles it, however strongly
the ports are coupled. Should rounds ever cycle, plain sweeps take over, which always converge here.
"""

from __future__ import annotations

from dampen.simulation.closure import answer, confirm, port_force, through

NEWTON_ROUNDS = 20
ROUNDS = 300
SETTLED = 1e-11
PORTS = 0  # the number of ports: bound to the scenario's before use, so that loops over ports are unrolled


def close_ports(ports, stages, g, coupling, dt):
    """Solve the closure of every port; `force` brings the guess, `coupling` (ports, ports) is scratch. True if settled."""
    for attempt in range(ROUNDS):
        forward(ports, stages, g, coupling, dt, attempt < NEWTON_ROUNDS)
        settled = True
        for p in range(PORTS - 2, -1, -1):
            for r in range(p + 1, PORTS):
                ports[p].force += ports[p].answer * coupling[p, r] * (ports[r].force - ports[r].guess)
        for p in range(PORTS - 1):
            predicted = ports[p].force
            v_others = velocity(p, ports, g) - g[p, p] * predicted
            settled &= confirm(ports[p], stages, v_others, g[p, p], dt)
            for r in range(PORTS):
                moved = abs(g[r, p] * (ports[p].force - predicted))
                settled &= r == p or moved <= SETTLED * g[r, r] * (abs(ports[r].force) + abs(predicted))
        if settled:
            return True
        if unmoved(ports):
            break
    for p in range(PORTS):  # what was tried last is not what was found: lead the stages to where the command found leads them
        through(ports[p], ports[p].command, stages)
    return unmoved(ports)


def unmoved(ports):
    """Whether a whole round has left every force as it was."""
    still = True
    for p in range(PORTS):
        still &= abs(ports[p].force - ports[p].guess) <= SETTLED * abs(ports[p].force)
    return still


def forward(ports, stages, g, coupling, dt, newton):
    """Solve port after port, each with the ports before it eliminated."""
    for p in range(PORTS):
        port = ports[p]
        port.guess = port.force
        port.v_others = velocity(p, ports, g) - g[p, p] * port.force
        for r in range(PORTS):
            coupling[p, r] = g[p, r]
    for p in range(PORTS):
        port = ports[p]
        port_force(port, stages, port.v_others, coupling[p, p], dt)
        if p + 1 < PORTS:
            port.answer = answer(port, coupling[p, p]) if newton else 0.0
        for r in range(p + 1, PORTS):
            passed = coupling[r, p] * port.answer
            ports[r].v_others += coupling[r, p] * (port.force - port.guess) - passed * coupling[p, r] * ports[r].guess
            for t in range(p + 1, PORTS):
                coupling[r, t] += passed * coupling[p, t]


def velocity(p, ports, g):
    """Mean velocity of port p over the step under the forces of all."""
    v = ports[p].v_free
    for r in range(PORTS):
        v += g[p, r] * ports[r].force
    return v
