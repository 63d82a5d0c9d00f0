"""A steel bar clamped at x = 0 that bends in y: its mesh, and the free vibrations of
beam theory."""
import math

import scene_text

LENGTH, HEIGHT, WIDTH = 0.2, 0.01, 0.003
MODULUS, DENSITY = 210e9, 7850.0
AREA, SECOND_MOMENT = HEIGHT * WIDTH, WIDTH * HEIGHT**3 / 12


def write_mesh(folder):
    """bar.msh, in millimetres; groups x0 and x1."""
    scene_text.write_bar(folder, (LENGTH, HEIGHT, WIDTH), (12, 2, 1))


class Mode:
    """root: of cos b cosh b = -1."""

    def __init__(self, root):
        self.k = root / LENGTH
        self.ratio = ((math.cosh(root) + math.cos(root)) /
                      (math.sinh(root) + math.sin(root)))
        self.omega = self.k**2 * math.sqrt(MODULUS * SECOND_MOMENT / (DENSITY * AREA))
        self.root_curvature = 2 * self.k**2  # of shape()

    def shape(self, x):
        kx = self.k * x
        return (math.cosh(kx) - math.cos(kx) -
                self.ratio * (math.sinh(kx) - math.sin(kx)))


MODES = [Mode(root) for root in (1.875104068711961, 4.694091132974175,
                                 7.854757438237613, 10.995540734875467)]
