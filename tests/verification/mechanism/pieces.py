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


class Drop:
    """Mass m that falls on the ground, spring k and damper b that never pull
    and grow over `transition`; depth is < 0 above the ground."""

    def __init__(self, transition=0.0, m=1.0, k=1e6, b=1e3, g=9.81):
        self.transition, self.m, self.k, self.b = transition, m, k, b
        self.g = g

    def full(self, depth, rate):
        return self.k * depth + self.b * rate

    def growth(self, depth):
        if self.transition == 0:
            return 1.0
        t = min(max(depth / self.transition, 0.0), 1.0)
        return t * t * (3 - 2 * t)

    def press(self, rate, step=2e-7):
        """(duration, depth, rate) at the end of a contact that begins with
        `rate`: classical Runge-Kutta, independent of clevis."""
        def slope(y):
            force = self.growth(y[0]) * self.full(*y)
            return y[1], self.g - force / self.m

        def after(y, h):
            a = slope(y)
            b = slope([y[i] + h / 2 * a[i] for i in (0, 1)])
            c = slope([y[i] + h / 2 * b[i] for i in (0, 1)])
            d = slope([y[i] + h * c[i] for i in (0, 1)])
            return [y[i] + h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i])
                    for i in (0, 1)]

        t, y = 0.0, [0.0, rate]
        while self.full(*(later := after(y, step))) > 0:
            t, y = t + step, later
        low, high = 0.0, step
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = ((middle, high) if self.full(*after(y, middle)) > 0
                         else (low, middle))
        return t + low, *after(y, low)

    def bounces(self, height, number):
        """Times of the first presses and releases; each bounce must leave the
        ground."""
        t, depth, rate, times = 0.0, -height, 0.0, []
        for _ in range(number):
            # back to depth 0, falling
            fall = (-rate + math.sqrt(rate**2 - 2 * self.g * depth)) / self.g
            t, rate = t + fall, rate + self.g * fall
            length, depth, rate = self.press(rate)
            times += [t, t + length]
            t += length
        return times

    def static_depth(self):
        low, high = 0.0, self.m * self.g / self.k + self.transition
        for _ in range(100):
            middle = 0.5 * (low + high)
            force = self.growth(middle) * self.k * middle
            low, high = ((middle, high) if force < self.m * self.g
                         else (low, middle))
        return low
