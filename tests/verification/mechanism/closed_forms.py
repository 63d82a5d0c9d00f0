"""Closed forms of the source systems, independent of clevis."""
import math


def smallest(cosine, sine, right):
    """The root nearest to 0 of cosine cos t + sine sin t = right."""
    middle = math.atan2(sine, cosine)
    half = math.acos(right / math.hypot(cosine, sine))
    return min((middle + half, middle - half), key=abs)


def antenna(elevation, azimuth, lever=100.0, crank=62.0, rod=200.0):
    """Angles (a, b) [rad] of the reflector, R = Rx(a) Ry(b), for the angles of
    the cranks: each rod keeps its length. [mm]"""
    s_y = lever - crank + crank * math.cos(elevation)
    s_z = -rod + crank * math.sin(elevation)
    a = smallest(s_y, s_z, (lever**2 + s_y**2 + s_z**2 - rod**2) / (2 * lever))
    s_x = -(lever - crank + crank * math.cos(azimuth))
    s_z = -rod + crank * math.sin(azimuth)
    w = (s_x, math.sin(a) * s_z, math.cos(a) * s_z)  # turned back by a
    square = sum(x * x for x in w)
    b = smallest(-w[0], w[2], (lever**2 + square - rod**2) / (2 * lever))
    return a, b


class FiveBar:
    """The 5R linkage: inputs phi (counter-clockwise) and lam (clockwise), both
    from y; AB = CD = l1 with twist a1, BC = AD = l2 with twist a2."""

    def __init__(self, a2, l1=100.0, a1=math.radians(30)):
        self.l1, self.a1, self.a2 = l1, a1, a2
        self.l2 = l1 * math.sin(a2) / math.sin(a1)

    def gamma(self, phi, lam):
        """(sin, cos) of CD against AD; Bennett's with delta = phi + lam."""
        l1, l2 = self.l1, self.l2
        c1, c2 = math.cos(self.a1), math.cos(self.a2)
        k1, k2 = l2 * l2 * c1 + l1 * l1 * c2, l1 * l2 * (c1 + c2)
        delta = phi + lam
        v = k1 - k2 * math.cos(delta)
        return ((l2 * l2 - l1 * l1) * math.sin(delta) / v,
                (k1 * math.cos(delta) - k2) / v)

    def gamma_published(self, phi, lam):
        """Equations (2), (3) and (6) as printed."""
        l1, l2 = self.l1, self.l2
        c1, c2 = math.cos(self.a1), math.cos(self.a2)
        k = [l2 * l2 * c1 + l1 * l1 * c2, l1 * l1 * c2 - l2 * l2 * c1,
             l1 * l2 * c2, l1 * l2 * c1, l1 * l2 * (c1 + c2),
             l1 * l2 * (c1 - c2), l1 * l1 * c2, l2 * l2 * c1]
        cc = math.cos(phi) * math.cos(lam)
        ss = math.sin(phi) * math.sin(lam)
        v = -cc * k[4] + ss * k[5] + math.cos(2 * lam) * k[6] + k[7]
        return (math.sin(phi + lam) * (l2 * l2 - l1 * l1) / v,
                (cc * k[0] + ss * k[1] - math.cos(2 * lam) * k[2] - k[3]) / v)

    def point_c(self, lam, gamma):
        """C from gamma = (sin, cos): on the circle about D. [mm]"""
        sine, cosine = gamma
        along = self.l2 + self.l1 * cosine
        across = -self.l1 * sine * math.cos(self.a2)
        # AD along (sin, cos, 0), its y is (-cos, sin, 0)
        return (along * math.sin(lam) - across * math.cos(lam),
                along * math.cos(lam) + across * math.sin(lam),
                -self.l1 * sine * math.sin(self.a2))

    def length_cd(self, phi, lam, gamma):
        """|CD| if C is where gamma at B puts it. [mm]"""
        sine, cosine = gamma
        c1, s1 = math.cos(self.a1), math.sin(self.a1)
        r, t = (-math.sin(phi), math.cos(phi)), (math.cos(phi), math.sin(phi))
        c = [(self.l1 + self.l2 * cosine) * r[i] + self.l2 * sine * c1 * t[i]
             for i in range(2)] + [-self.l2 * sine * s1]
        d = (self.l2 * math.sin(lam), self.l2 * math.cos(lam), 0.0)
        return math.dist(c, d)

    def faults_of_published(self):
        """Largest sin^2 + cos^2 - 1 and | |CD| - l1 | [mm] of the published
        formulas over all inputs, by whole degrees."""
        unit = length = 0.0
        angles = [math.radians(i) for i in range(360)]
        for phi in angles:
            for lam in angles:
                gamma = self.gamma_published(phi, lam)
                unit = max(unit, abs(math.hypot(*gamma)**2 - 1))
                off = abs(self.length_cd(phi, lam, gamma) - self.l1)
                length = max(length, off)
        return unit, length

    def phi(self, lam, gamma):
        """The inverse problem, for a2 = 90 deg."""
        return 2 * math.atan(math.tan(gamma / 2) / math.sqrt(3)) - lam


def bennett_second(theta, alpha, beta):
    """Angle of the second hinge of Bennett's loop."""
    product = (math.sin(0.5 * (beta + alpha)) /
               math.sin(0.5 * (beta - alpha)))
    return 2 * math.atan(product / math.tan(0.5 * theta))


class LandingGear:
    """The slide-lever mechanism at cylinder length l_x, corrected (section
    2 of the source), in mm: pins, and T, the wheel's lowest point, 140 mm
    under C."""

    def __init__(self, l_x, FD=210.24, DD1=210.0):
        turned = (FD**2 + 60**2 - l_x**2) / (2 * FD * 60)
        q3 = math.acos(turned) - math.acos(DD1 / FD)
        corner = math.acos((60**2 + 140**2 - 145**2) / (2 * 60 * 140))
        theta = math.pi - corner - q3
        self.A, self.D = (0.0, 0.0), (0.0, 60.0)
        self.F = (-DD1, 60 - math.sqrt(FD**2 - DD1**2))
        self.E = (-60 * math.cos(q3), 60 + 60 * math.sin(q3))
        self.C = (140 * math.cos(theta), 60 + 140 * math.sin(theta))
        self.B = (self.C[0], self.C[1] - 60)
        self.T = (self.C[0], self.C[1] - 140)
        # dT/dl_x: DC turns against q3
        rate = l_x / (FD * 60 * math.sqrt(1 - turned**2))
        self.slope = (140 * math.sin(theta) * rate,
                      -140 * math.cos(theta) * rate)

    def statics(self, load):
        """{pin: force [N]} and the cylinder's push [N], without masses, under
        a load (x, y) at T: AB and FE are rods."""
        def cross(a, b, force):
            return (a[0] - b[0]) * force[1] - (a[1] - b[1]) * force[0]

        def unit(a, b):
            length = math.dist(a, b)
            return (a[0] - b[0]) / length, (a[1] - b[1]) / length

        along = unit(self.B, self.A)
        rod = (-cross(self.T, self.C, load) / cross(self.B, self.C, along))
        at_c = [rod * along[i] + load[i] for i in (0, 1)]  # of BC on DCE
        axis = unit(self.E, self.F)
        push = (-cross(self.C, self.D, at_c) / cross(self.E, self.D, axis))
        at_d = [at_c[i] + push * axis[i] for i in (0, 1)]
        pins = {"A": abs(rod), "B": abs(rod), "C": math.hypot(*at_c),
                "D": math.hypot(*at_d), "E": abs(push), "F": abs(push)}
        return pins, push

    def mass_along_path(self, l_x):
        """Mass [kg] that the cylinder's free motion moves at T, for the
        masses of ground_by_force.toml: kinetic energy / (v_T^2 / 2)."""
        speed = math.hypot(*self.slope)  # of T, per unit of l_x
        turn = speed / 140  # of AB and DCE, 1/mm
        square = (1e-6 * (200 + 0.105 * 70**2) + 1e-6 *
                  (1500 + 0.517 * (49**2 + 20**2))) * (1e3 * turn)**2
        axis = [(self.E[i] - self.F[i]) / l_x for i in (0, 1)]
        across = (-axis[1], axis[0])
        e = [self.E[0] - self.D[0], self.E[1] - self.D[1]]
        # E goes round D the way C does: dE/dl_x = -turn x e
        v_e = (turn * e[1], -turn * e[0])
        swing = sum(across[i] * v_e[i] for i in (0, 1)) / l_x
        square += 1e-6 * (330 + 0.144 * 78**2 + 160 + 0.096 *
                          (l_x - 64)**2) * (1e3 * swing)**2
        return (square + 0.096 + (0.073 + 0.30) * speed**2) / speed**2
