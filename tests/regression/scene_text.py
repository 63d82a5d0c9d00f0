"""Pieces of scene files that scripts share, and the mesh of the bar that many of them
have."""
import hex_mesh
import support

WEIGHTLESS = """[world]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
"""

BAR = """[[part]]
name = "bar"
mesh = "bar.msh"
length_unit = "mm"
material = "steel"
"""


def head(name, material=support.STEEL, world=WEIGHTLESS):
    """world: "" of parts without a mechanism."""
    return f'schema = 1\nname = "{name}"\n{world}{material}'


def lengths(values):
    """Of values in mm, as TOML."""
    return "[" + ", ".join(f'"{value} mm"' for value in values) + "]"


def part_body(name):
    return f'[[body]]\nname = "{name}"\npart = "{name}"\n'


def body(name, mass, inertia, center=(0, 0, 0), origin=None):
    """mass and inertia with their units; places in mm."""
    placement = f"placement = {{ origin = {lengths(origin)} }}\n" if origin else ""
    return f"""[[body]]
name = "{name}"
mass = "{mass}"
center_of_mass = {lengths(center)}
inertia = ["{inertia}", "{inertia}", "{inertia}"]
{placement}"""


def joint(name, kind, first, second, point=(0, 0, 0), axis=None):
    """point in mm."""
    along = f"axis = {list(axis)}\n" if axis else ""
    return f"""[[joint]]
name = "{name}"
type = "{kind}"
between = ["{first}", "{second}"]
point = {lengths(point)}
{along}"""


def write_bar(folder, size, cells, off=0.0):
    """bar.msh: a bar from x = 0 along x about the line y = off, z = 0; size in m."""
    x_size, y_size, z_size = (1e3 * value for value in size)
    hex_mesh.write(folder / "bar.msh", hex_mesh.block(
        cells, lambda x, y, z: (x_size * x, y_size * (y - 0.5) + 1e3 * off,
                                z_size * (z - 0.5))))
