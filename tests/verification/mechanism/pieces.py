"""Exact motions of one mass whose law changes at events: between them the
equation is linear, and its solution known. Independent of clevis."""
import math


class Swing:
    """m x'' + c x' + k x = f from (x, v) at t = 0; k > 0 and oscillating, or
    k = c = 0."""

    def __init__(self, m, c, k, f, x, v):
        self.x, self.v, self.free = x, v, k == 0
        if self.free:
            self.a = f / m
            return
        self.middle = f / k
        self.decay = c / (2 * m)
        self.w = math.sqrt(k / m - self.decay**2)
        self.p = x - self.middle
        self.q = (v + self.decay * self.p) / self.w

    def at(self, t):
        """(x, v)"""
        if self.free:
            return (self.x + (self.v + 0.5 * self.a * t) * t,
                    self.v + self.a * t)
        sine, cosine = math.sin(self.w * t), math.cos(self.w * t)
        size = math.exp(-self.decay * t)
        y = size * (self.p * cosine + self.q * sine)
        turn = size * self.w * (self.q * cosine - self.p * sine)
        return self.middle + y, turn - self.decay * y


def first_crossing(value, step, end):
    """First t > 0 where value(t) falls through 0, or None before `end`; two
    zeros within one step are missed."""
    low = 1e-9 * step
    while low < end:
        high = low + step
        if value(low) > 0 >= value(high):
            for _ in range(200):
                middle = 0.5 * (low + high)
                low, high = ((middle, high) if value(middle) > 0
                             else (low, middle))
            return 0.5 * (low + high)
        low = high
    return None


class Wall:
    """Mass m on a spring k (relaxed at the wall, x = 0) with friction, against
    a wall of k_c and b_c at x < 0."""

    def __init__(self, m=1.0, k=100.0, k_c=1e5, b_c=20.0, pulls=False,
                 breakaway=0.0, kinetic=0.0, viscous=0.0):
        self.m, self.k, self.k_c, self.b_c = m, k, k_c, b_c
        self.pulls, self.breakaway = pulls, breakaway
        self.kinetic, self.viscous = kinetic, viscous

    def swing(self, touching, sense, x, v):
        return Swing(self.m, self.viscous + touching * self.b_c,
                     self.k + touching * self.k_c, -sense * self.kinetic, x, v)

    def watched(self, swing, touching, sense):
        """{event: function of t, positive until it}"""
        functions = {}
        if touching and self.pulls:
            functions["release"] = lambda t: -swing.at(t)[0]
        elif touching:
            def force(t):
                x, v = swing.at(t)
                return -self.k_c * x - self.b_c * v
            functions["release"] = force
        elif sense < 0:
            functions["press"] = lambda t: swing.at(t)[0]
        functions["turn"] = lambda t: sense * swing.at(t)[1]
        return functions

    def events(self, x, v, end):
        """[(t, event, x, v)] from (x, v) outside the wall at t = 0."""
        t, touching, found = 0.0, False, []
        sense = (v > 0) - (v < 0) or (-1 if x > 0 else 1)
        while True:
            swing = self.swing(touching, sense, x, v)
            step = 0.02 * math.sqrt(self.m / (self.k + touching * self.k_c + 1))
            crossings = [(s, event) for event, value in
                         self.watched(swing, touching, sense).items()
                         if (s := first_crossing(value, step, end - t))
                         is not None]
            if not crossings:
                return found
            s, event = min(crossings)
            t += s
            x, v = swing.at(s)
            if event == "turn":
                pull = self.k * x
                if touching:
                    pull += self.k_c * x
                if abs(pull) <= self.breakaway:
                    return found + [(t, "stick", x, 0.0)]
                v, sense = 0.0, -sense
            else:
                touching = event == "press"
            if event != "turn" or self.kinetic > 0:
                found.append((t, event, x, v))


def restitution(k, m, b, pulls=False):
    """(part of the speed that comes back, duration of the contact) of a free
    mass against spring and damper that let go at zero force, or where the
    depth is zero if they pull."""
    z = b / (2 * math.sqrt(k * m))
    root = math.sqrt(1 - z * z)
    w = math.sqrt(k / m) * root
    if pulls:
        return math.exp(-math.pi * z / root), math.pi / w
    turn = 2 * math.atan(root / z)
    return math.exp(-z / root * turn), turn / w
