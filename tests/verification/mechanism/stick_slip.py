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
                slide = Swing(self.m, 0.0, self.k, sense * self.kinetic,
                              done[-1][3](start), self.lower(start)[1])

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
