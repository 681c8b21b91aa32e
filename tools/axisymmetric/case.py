"""The parts of a Starling case file (docs/case_file.md) that an axisymmetric tube needs."""
import dataclasses
import tomllib

from .membrane import Hooke, MooneyRivlin, NeoHookean, Skalak


class CaseError(ValueError):
    """The case cannot be read, or is not one for this tool."""


@dataclasses.dataclass(frozen=True)
class Case:
    """A clamped tube. Lengths in R_0; pressures in mu U_c/R_0, relative to the one outside."""

    reynolds: float
    length: float
    rigid_inlet: float
    rigid_outlet: float
    pressure_inlet: float
    pressure_outlet: float
    law: object  # with G_s = 1/eps
    pressure_external: float = 0.0  # in rho U_c^2, for output only


def override_value(text):
    """The value as in TOML; anything else is a bare string."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text


def apply_overrides(document, overrides):
    """Changes keys by "section.key=value"; an empty value removes the key."""
    for assignment in overrides:
        name, equals, text = assignment.partition("=")
        section, dot, key = name.strip().partition(".")
        if not equals or not section or (dot and not key):
            raise CaseError(f"--set '{assignment}': must be section.key=value")
        table, key = (document.setdefault(section, {}), key) if dot else (document, section)
        table.pop(key, None)
        if text.strip():
            table[key] = override_value(text.strip())


def number(document, section, key, default=None):
    value = document.get(section, {}).get(key, default)
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise CaseError(f"{section}.{key}: " + ("is required" if value is None
                                                else f"must be a number, not {value!r}"))
    return float(value)


def positive(document, section, key, default=None):
    value = number(document, section, key, default)
    if value <= 0:
        raise CaseError(f"{section}.{key}: must be greater than 0")
    return value


def make_law(document):
    """The wall's law with G_s = 1/eps."""
    G_s = 1 / positive(document, "wall", "eps")
    name = document.get("wall", {}).get("law")
    if name == "hooke":
        return Hooke(G_s, number(document, "wall", "poisson_ratio", 0.5))
    if name == "neo-hookean":
        return NeoHookean(G_s)
    if name == "mooney-rivlin":
        return MooneyRivlin(G_s, number(document, "wall", "psi", 0.5))
    if name == "skalak":
        nu = number(document, "wall", "poisson_ratio", 0.5)
        return Skalak(G_s, number(document, "wall", "skalak_C", nu / (1 - nu)))
    raise CaseError(f"wall.law: must be hooke, neo-hookean, mooney-rivlin or skalak, not {name!r}")


def pressures(document, Re, length):
    """Inlet, outlet and external pressure in rho U_c^2."""
    external = number(document, "drive", "pressure_external", 0)
    outlet = number(document, "drive", "pressure_outlet", 0)
    drive = document.get("drive", {})
    if "pressure_ratio" not in drive:
        return number(document, "drive", "pressure_inlet"), outlet, external
    drop = number(document, "drive", "pressure_ratio") * 4 * length / Re
    if "pressure_inlet" in drive:
        inlet = number(document, "drive", "pressure_inlet")
        return inlet, inlet - drop, external
    return outlet + drop, outlet, external


def make_case(document):
    """The case of a parsed file. Other keys (grid, time, ...) do not matter here and are not
    checked: `starling check` does that. Raises CaseError."""
    if document.get("units", "dimensionless") != "dimensionless":
        raise CaseError("units: only dimensionless cases")
    if document.get("vessel", {}).get("rigid", False):
        raise CaseError("vessel.rigid: the tube must be compliant")
    wall = document.get("wall", {})
    if wall.get("bending", 0) != 0 or "bending_thickness" in wall:
        raise CaseError("wall.bending: the wall must be a membrane")
    Re = positive(document, "fluid", "reynolds")
    length, inlet, outlet = (positive(document, "vessel", key)
                             for key in ("length", "rigid_inlet", "rigid_outlet"))
    if length <= inlet + outlet:
        raise CaseError("vessel.length: must be greater than that of the rigid parts")
    P_inlet, P_outlet, P_external = pressures(document, Re, length)
    if P_inlet <= P_outlet:
        raise CaseError("drive: the pressure must fall from inlet to outlet")
    if P_outlet < P_external:
        raise CaseError("drive: the outlet pressure must not be below the one outside: a tube that "
                        "is narrower than at rest wrinkles or buckles")
    return Case(Re, length, inlet, outlet, Re * (P_inlet - P_external),
                Re * (P_outlet - P_external), make_law(document), P_external)


def read_case(path, overrides=()):
    """The case of a file, with "section.key=value" overrides. Raises CaseError."""
    try:
        with open(path, "rb") as stream:
            document = tomllib.load(stream)
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise CaseError(f"{path}: {error}") from error
    apply_overrides(document, overrides)
    return make_case(document)
