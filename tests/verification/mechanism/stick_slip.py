"""Exact stick-slip of a mass on a platform whose motion is given. Independent
of clevis."""
import math

from pieces import Swing, first_crossing


def swinging(t, amplitude=0.010, w=2 * math.pi):
    """(x, v, a) of a lower platform on a sine."""
    sine, cosine = math.sin(w * t), math.cos(w * t)
    return amplitude * sine, amplitude * w * cosine, -amplitude * w * w * sine


def belt(t, speed=0.020):
    return speed * t, speed, 0.0


def cranked(t, r=0.010, rod=0.060, w=2 * math.pi):
    """... behind a crank from its outer dead centre, where x = 0."""
    c, s = r * math.cos(w * t), r * math.sin(w * t)
    root = math.sqrt(rod * rod - s * s)
    slope = -s * c / root  # of the root by the angle
    bend = (s * s - c * c - slope * slope) / root
    return c + root - r - rod, w * (slope - s), w * w * (bend - c)


class Tribometer:
    """Upper platform (mass, stiffness of its springs) on a lower one whose
    motion is given; Coulomb friction with stick."""

    def __init__(self, lower, m=0.5, k=1000.0, breakaway=4.5, kinetic=3.0):
        self.lower, self.m, self.k = lower, m, k
        self.breakaway, self.kinetic = breakaway, kinetic

    def dragging(self, t, offset):
        """Friction [N] that a stuck upper platform needs."""
        x, _, a = self.lower(t)
        return self.m * a + self.k * (x + offset)

    def slide(self, start, sense, x):
        """Motion of the upper platform from the end of a stick on."""
        return Swing(self.m, 0.0, self.k, sense * self.kinetic, x,
                     self.lower(start)[1])

    def pieces(self, end, step=1e-4):
        """[(start, end, event at the end, position(t) of the upper one)] from
        both at rest on one another; no event at the end of the last."""
        t, offset, sense, done = 0.0, 0.0, 0, []
        while True:
            start = t
            if sense == 0:
                def place(s, offset=offset):
                    return self.lower(s)[0] + offset

                def left(s, start=start, offset=offset):
                    needed = self.dragging(start + s, offset)
                    return self.breakaway - abs(needed)
            else:
                slide = self.slide(start, sense, done[-1][3](start))

                def place(s, slide=slide, start=start):
                    return slide.at(s - start)[0]

                def left(s, slide=slide, start=start, sense=sense):
                    return sense * (self.lower(start + s)[1] - slide.at(s)[1])
            length = first_crossing(left, step, end - start)
            if length is None:
                return done + [(start, end, None, place)]
            t = start + length
            done.append((start, t, "stick" if sense else "slip", place))
            if sense:
                offset, sense = place(t) - self.lower(t)[0], 0
                if abs(self.dragging(t, offset)) > self.breakaway:
                    raise ValueError("slides on to the other side")
            else:
                sense = 1 if self.dragging(t, offset) > 0 else -1

    def events(self, end):
        return [(t, event) for _, t, event, _ in self.pieces(end) if event]

    def positions(self, times):
        """Of the upper platform [m] at rising times."""
        pieces = self.pieces(times[-1])
        at = 0
        for t in times:
            while t > pieces[at][1]:
                at += 1
            yield pieces[at][3](t)


class Stribeck(Tribometer):
    """... whose friction falls with the sliding speed: kinetic + (breakaway -
    kinetic) exp(-(v/speed)^2)."""

    def __init__(self, lower, speed=0.005, **of_tribometer):
        super().__init__(lower, **of_tribometer)
        self.speed = speed

    def slide(self, start, sense, x):
        def acceleration(s, x, v):
            ratio = (self.lower(start + s)[1] - v) / self.speed
            force = self.kinetic + (self.breakaway -
                                    self.kinetic) * math.exp(-ratio * ratio)
            return (sense * force - self.k * x) / self.m

        return Followed(acceleration, x, self.lower(start)[1])


class Followed:
    """x'' = acceleration(t, x, v) by Runge's and Kutta's method in steps of 20
    us (errors of 1e-12 of the amplitude), cubic between them."""

    STEP = 2e-5

    def __init__(self, acceleration, x, v):
        self.acceleration = acceleration
        self.states = [(x, v, acceleration(0.0, x, v))]

    def extend(self):
        h, f = self.STEP, self.acceleration
        t = (len(self.states) - 1) * h
        x, v, a = self.states[-1]
        v2 = v + 0.5 * h * a
        a2 = f(t + 0.5 * h, x + 0.5 * h * v, v2)
        v3 = v + 0.5 * h * a2
        a3 = f(t + 0.5 * h, x + 0.5 * h * v2, v3)
        v4 = v + h * a3
        a4 = f(t + h, x + h * v3, v4)
        x += h * (v + 2 * v2 + 2 * v3 + v4) / 6
        v += h * (a + 2 * a2 + 2 * a3 + a4) / 6
        self.states.append((x, v, f(t + h, x, v)))

    def at(self, t):
        """(x, v)"""
        i = int(t / self.STEP)
        while len(self.states) < i + 2:
            self.extend()
        (x, v, a), (x1, v1, a1) = self.states[i:i + 2]
        h, s = self.STEP, t / self.STEP - i

        def cubic(y, slope, y1, slope1):
            return (y + s * s * (3 - 2 * s) * (y1 - y) + h * s * (1 - s) *
                    ((1 - s) * slope - s * slope1))

        return cubic(x, v, x1, v1), cubic(v, a, v1, a1)
