"""A mass that falls on the ground, by an integration independent of clevis."""
import math


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
