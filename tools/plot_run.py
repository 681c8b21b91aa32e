#!/usr/bin/python3
"""Draws the results of a Starling run: profiles.png, history.png, tube.png, flow.png, waves.png
where the wall was written often, and breakdown.png where a run has broken down.

usage: plot_run.py DIR

Needs Debian's python3-matplotlib, python3-numpy and python3-h5py. Called by `starling plot DIR`.
"""
import csv
import json
import os
import re
import sys

try:
    import h5py
    import matplotlib
    import numpy as np
except ImportError as error:
    sys.exit(f"starling plot: {error}; install python3-matplotlib, python3-numpy and python3-h5py")

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
from matplotlib import cm, colors  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402

BLUE, RED, GREEN, GREY = "#1f5fa8", "#c8452c", "#2c8a5b", "#8a8f98"
STYLE = {
    "figure.dpi": 160, "savefig.dpi": 160, "figure.constrained_layout.use": True,
    "font.size": 10, "axes.titlesize": 11, "axes.labelsize": 10, "legend.fontsize": 9,
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
    "grid.color": "#e4e6ea", "grid.linewidth": 0.7, "axes.edgecolor": "#5a5f68",
    "axes.axisbelow": True, "lines.linewidth": 1.8, "legend.frameon": False,
    "mathtext.fontset": "dejavusans",
}


class Table:
    """A CSV file of Starling: columns by name, their units beside them."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as stream:
            rows = list(csv.reader(stream))
        titles = [re.fullmatch(r"(.*?)(?: \[(.*)\])?", title).groups() for title in rows[0]]
        self.units = {name: unit or "" for name, unit in titles}
        # A run that was killed may leave a last line that is not whole.
        whole = [row for row in rows[1:] if len(row) == len(titles)]
        values = np.array(whole, dtype=float).reshape(len(whole), len(titles))
        self.columns = {name: values[:, n] for n, (name, _) in enumerate(titles)}

    def __getitem__(self, name):
        return self.columns[name]

    def axis(self, *names):
        """The unit in which to draw these columns, which are alike."""
        return Axis(self.units[names[0]], np.concatenate([self[name] for name in names]))


# Multiples of SI units, from large to small: other units are drawn as they are.
MULTIPLES = {
    "m": {"m": 1, "mm": 1e-3, "µm": 1e-6},
    "s": {"s": 1, "ms": 1e-3, "µs": 1e-6},
    "Pa": {"MPa": 1e6, "kPa": 1e3, "Pa": 1, "mPa": 1e-3},
    "m/s": {"m/s": 1, "mm/s": 1e-3, "µm/s": 1e-6},
    "m^3/s": {"m^3/s": 1, "l/s": 1e-3, "ml/s": 1e-6, "µl/s": 1e-9, "nl/s": 1e-12, "pl/s": 1e-15},
}


class Axis:
    """The multiple of a unit in which the largest of the values is at least 1."""

    def __init__(self, unit, values):
        finite = np.abs(np.asarray(values, dtype=float))
        finite = finite[np.isfinite(finite)]
        largest = finite.max() if finite.size else 0
        multiples = MULTIPLES.get(unit, {unit: 1})
        fitting = [name for name, size in multiples.items() if largest >= size]
        self.unit = fitting[0] if fitting else list(multiples)[-1 if largest > 0 else 0]
        self.size = multiples[self.unit]

    def __call__(self, values):
        return values / self.size

    def label(self, words):
        return f"{words} [{pretty(self.unit)}]"


def pretty(unit):
    """A unit of a header for a picture: R_0^2 U_c -> R with index and exponent."""
    factors = re.sub(r"([A-Za-z]+)_([0-9a-z])(?:\^(\d))?", r"$\\mathit{\1}_{\2}^{\3}$", unit)
    factors = re.sub(r"([A-Za-z]+)\^(\d)", r"$\\mathrm{\1}^{\2}$", factors)
    return factors.replace("^{}", "").replace("rho", "ρ")


def read(directory, name):
    path = os.path.join(directory, name)
    return Table(path) if os.path.exists(path) else None


def save(figure, directory, name):
    path = os.path.join(directory, name)
    try:
        figure.savefig(path + ".new", format="png")
        os.replace(path + ".new", path)
    except OSError as error:
        if os.path.exists(path + ".new"):
            os.remove(path + ".new")
        sys.exit(f"starling plot: cannot write {path}: {error.strerror}")
    plt.close(figure)
    print(path)


def law_of(directory):
    """The elastic law in case.toml, or an empty name."""
    path = os.path.join(directory, "case.toml")
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as stream:
        found = re.search(r'^law = "(.*)"$', stream.read(), re.MULTILINE)
    return found[1] if found else ""


def laplace_label(law):
    """The law of Laplace is Hooke's: a picture of another wall says so."""
    return "law of Laplace, second order" + ("" if law == "hooke" else ", of a Hookean wall")


def plot_profiles(directory, profile, theory, law):
    """R(x) and P(x) of the run's end against theory."""
    figure, (top, bottom) = plt.subplots(2, 1, figsize=(7.2, 6.4), sharex=True)
    x_axis, R_axis, P_axis = profile.axis("x"), profile.axis("R_max"), profile.axis("P_centre")
    x = x_axis(profile["x"])
    top.fill_between(x, R_axis(profile["R_min"]), R_axis(profile["R_max"]), color=BLUE, alpha=0.15,
                     lw=0, label="smallest to largest")
    top.plot(x, R_axis(profile["R_mean"]), color=BLUE, label="Starling")
    bottom.plot(x, P_axis(profile["P_centre"]), color=BLUE, label="Starling, on the axis")
    if theory is not None:
        x = x_axis(theory["x"])
        top.plot(x, R_axis(theory["R"]), color=RED, ls=(0, (5, 2)), label="one-dimensional model")
        bottom.plot(x, P_axis(theory["P"]), color=RED, ls=(0, (5, 2)),
                    label="one-dimensional model")
        if np.isfinite(theory["R_second_order"]).any():
            top.plot(x, R_axis(theory["R_second_order"]), color=GREY, lw=1.2, ls=":",
                     label=laplace_label(law))
    top.set_ylabel(R_axis.label("radius"))
    bottom.set_ylabel(P_axis.label("pressure"))
    bottom.set_xlabel(x_axis.label("position along the tube"))
    top.set_title("The tube at the end of the run", loc="left")
    for axes in (top, bottom):
        axes.legend()
        axes.margins(x=0)
    save(figure, directory, "profiles.png")


def plot_history(directory, series, summary):
    """Q(t), the shape over time and the leak."""
    shapes = shape_panels(directory, series)
    figure, panels = plt.subplots(len(shapes) + 2, 1, figsize=(7.2, 4.9 + 2.7 * len(shapes)),
                                  sharex=True, height_ratios=(3, *[3] * len(shapes), 2))
    t_axis = series.axis("t")
    t = t_axis(series["t"])
    theory = summary.get("theory") or {}
    draw_flow_rates(panels[0], t, series, theory)
    for draw, panel in zip(shapes, panels[1:]):
        draw(panel, t_axis, theory)
    draw_leak(panels[-1], t, series)
    panels[-1].set_xlabel(t_axis.label("time"))
    panels[0].set_title("From rest to " + ("the steady state" if summary.get("converged") else
                                           "the end of the run"), loc="left")
    for axes in panels:
        axes.margins(x=0)
    save(figure, directory, "history.png")


COLLAPSED = 0.95  # area over the undeformed one, below which a tube is drawn as one that collapses
WIDENED = 1.005   # largest radius over the undeformed one, above which it is worth a panel there


def shape_panels(directory, series):
    """What draws the shape over time: the radius of a tube that widens; the narrowest section and
    its waves of one that collapses."""
    def radius(axes, t_axis, theory):
        draw_largest_radius(axes, t_axis(series["t"]), series, theory)

    def narrowest(axes, t_axis, _):
        draw_narrowest(axes, t_axis(series["t"]), series)

    def waves(axes, t_axis, _):
        draw_waves(axes, t_axis, frames)

    if not (series["min_area_ratio"] < COLLAPSED).any():
        return [radius]
    frames = waves_of_frames(directory)
    panels = [narrowest] if frames is None else [narrowest, waves]
    return [radius, *panels] if series["R_max"].max() > WIDENED * series["R_max"][0] else panels


def draw_flow_rates(axes, t, series, theory):
    names = ("Q_in", "Q_mid", "Q_out")
    Q_axis = series.axis(*names)
    for name, words, color in zip(names, ("inlet", "middle", "outlet"), (RED, BLUE, GREEN)):
        axes.plot(t, Q_axis(series[name]), color=color, label=words)
    model = Q_axis(theory["Q_1d"]) if "Q_1d" in theory else None
    if model is not None:
        axes.axhline(model, color=GREY, lw=1.2, ls=(0, (5, 2)), label="one-dimensional model")
    limit_to_bulk(axes, Q_axis(np.concatenate([series[n] for n in names])), model)
    axes.set_ylabel(Q_axis.label("flow rate"))
    axes.legend(ncol=2)


def draw_largest_radius(axes, t, series, theory):
    R_axis = series.axis("R_max")
    axes.plot(t, R_axis(series["R_max"]), color=BLUE, label="Starling")
    if "R_max_1d" in theory:
        axes.axhline(R_axis(theory["R_max_1d"]), color=GREY, lw=1.2, ls=(0, (5, 2)),
                     label="one-dimensional model")
    axes.set_ylabel(R_axis.label("largest radius"))
    axes.legend()


def draw_narrowest(axes, t, series):
    """The smallest section and the smallest gap, both over their undeformed values."""
    axes.plot(t, series["min_area_ratio"], color=BLUE, label="smallest section")
    axes.plot(t, series["smallest_gap"] / series["smallest_gap"][0], color=RED,
              label="smallest gap")
    axes.set_ylim(bottom=0)
    axes.set_ylabel("over that at the start")
    axes.legend()


def draw_waves(axes, t_axis, frames):
    """The amplitudes of the waves around the tube, those that matter, at the frames of the wall."""
    times, amplitudes, unit = frames
    axis = Axis(unit, amplitudes)
    for n, color in zip(np.argsort(-amplitudes.max(axis=0))[:3], (BLUE, RED, GREEN)):
        axes.plot(t_axis(times), axis(amplitudes[:, n]), color=color, marker="o", ms=4,
                  lw=1.2 if len(times) > 2 else 0, label=f"{n + 2} lobes")
    axes.set_ylim(bottom=0)
    axes.set_ylabel(axis.label("amplitude in the radius"))
    axes.legend()


def waves_of_frames(directory, lobes=range(2, 9)):
    """Times of the frames of the wall, the largest amplitude along the tube of the waves of 2 to 8
    lobes in each, and their unit; None without frames."""
    path = os.path.join(directory, "wall.h5")
    if not os.path.exists(path):
        return None
    times, amplitudes = [], []
    with h5py.File(path, "r", locking=False) as file:
        for _, frame in sorted(file["frames"].items()):
            unit = unit_of(frame["points"])
            times.append(float(frame.attrs["t"]))
            amplitudes.append(largest_waves(frame, lobes))
    return np.array(times), np.array(amplitudes), unit


def largest_waves(frame, lobes):
    points = frame["points"][...].astype(float)
    rest = points - frame["displacement"][...]
    theta, radius = np.arctan2(rest[:, 2], rest[:, 1]), np.hypot(points[:, 1], points[:, 2])
    ring = np.unique(np.round(rest[:, 0] / np.ptp(rest[:, 0]), 5), return_inverse=True)[1]
    count = np.bincount(ring)
    return [np.hypot(*(2 * np.bincount(ring, radius * wave(n * theta)) / count
                       for wave in (np.cos, np.sin))).max() for n in lobes]


FEWEST_FRAMES = 12  # of the wall, for a picture over x and t


def wall_history(path):
    """Times of the frames of the wall, x of its rings, and (frames, rings) of their mean radius
    and transmural pressure; with the units of the two."""
    times, radii, pressures = [], [], []
    with h5py.File(path, "r", locking=False) as file:
        for _, frame in sorted(file["frames"].items()):
            points = frame["points"][...].astype(float)
            x = points[:, 0]
            ring = np.unique(np.round(x / np.ptp(x), 5), return_inverse=True)[1]
            count = np.bincount(ring)
            times.append(float(frame.attrs["t"]))
            radii.append(np.bincount(ring, np.hypot(points[:, 1], points[:, 2])) / count)
            pressures.append(np.bincount(ring, frame["transmural_pressure"][...]) / count)
            units = unit_of(frame["points"]), unit_of(frame["transmural_pressure"])
    x = np.bincount(ring, x) / count
    return np.array(times), x, np.array(radii), np.array(pressures), units


def plot_waves(directory, t_unit):
    """Radius and transmural pressure over x and t."""
    path = os.path.join(directory, "wall.h5")
    if not os.path.exists(path):
        return
    with h5py.File(path, "r", locking=False) as file:
        if len(file["frames"]) < FEWEST_FRAMES:
            return
    times, x, radii, pressures, units = wall_history(path)
    t_axis, x_axis = Axis(t_unit, times), Axis(units[0], x)
    figure, panels = plt.subplots(1, 2, figsize=(9, 4.6), sharey=True)
    for axes, values, unit, words in zip(
            panels, (radii - radii[0], pressures), units,
            ("radius less that at the start", "pressure inside less outside")):
        axis = Axis(unit, values)
        low, high = axis(np.percentile(values, [0.2, 99.8]))
        signs = low < -0.1 * high
        bound = max(-low, high) or 1
        picture = axes.pcolormesh(x_axis(x), t_axis(times), axis(values), shading="gouraud",
                                  cmap="RdBu_r" if signs else "viridis", rasterized=True,
                                  vmin=-bound if signs else 0, vmax=bound)
        axes.set_xlabel(x_axis.label("position along the tube"))
        axes.grid(False)
        bar = figure.colorbar(picture, ax=axes, location="top", shrink=0.9, aspect=30)
        bar.set_label(axis.label(words))
        bar.outline.set_visible(False)
    panels[0].set_ylabel(t_axis.label("time"))
    save(figure, directory, "waves.png")


def draw_leak(axes, t, series):
    flow = np.maximum(np.abs(series["Q_in"]), np.abs(series["Q_out"]))
    leak = 100 * series["leak"] / np.where(flow > 0.05 * np.max(flow), flow, np.nan)
    axes.plot(t, leak, color=BLUE)
    late = np.abs(leak)[len(t) // 4:]
    if np.isfinite(late).any():  # the start-up, with hardly any flow yet, would hide the rest
        bound = max(1.0, 1.5 * np.nanmax(late))
        axes.set_ylim(-bound, bound)
    axes.set_ylabel("leak [% of the flow]")


def limit_to_bulk(axes, values, reference):
    """Keeps a short start-up peak from flattening the rest of the curve."""
    values = values[np.isfinite(values)]
    if values.size < 20:
        return
    low, high = np.percentile(values, [1, 97])
    high = max(high, reference or high)
    margin = 0.12 * (high - low) + 1e-30
    axes.set_ylim(low - margin, high + margin)


def last_frame(file):
    return file["frames"][sorted(file["frames"])[-1]]


def unit_of(dataset):
    unit = dataset.attrs.get("unit", "")
    return unit.decode() if isinstance(unit, bytes) else str(unit)


def face_values(frame, name, triangles):
    """Values per triangle of an array on vertices or triangles."""
    values = frame[name][...].astype(float)
    if values.ndim == 2:
        values = np.linalg.norm(values, axis=1)
    return values if len(values) == len(triangles) else values[triangles].mean(axis=1)


def pick_colouring(frame):
    """The array that tells most about the wall, and its words."""
    for name, words in (("transmural_pressure", "transmural pressure"),
                        ("displacement", "displacement")):
        if name in frame:
            return name, words
    return None, None


def view_axes(azimuth, elevation):
    """Right, up and towards-the-viewer directions of an orthographic view, angles in degrees."""
    a, e = np.radians([azimuth, elevation])
    toward = np.array([np.sin(a) * np.cos(e), -np.cos(a) * np.cos(e), np.sin(e)])
    right = np.cross([0, 0, 1], toward)
    right /= np.linalg.norm(right)
    return right, np.cross(toward, right), toward


def shade(corners, tint, lamp, toward):
    """Triangle colours `tint` darkened by the angle of their visible side to a lamp."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True) + 1e-300
    normal *= np.where(normal @ toward < 0, -1, 1)[:, None]
    facing = np.clip(normal @ (lamp / np.linalg.norm(lamp)), 0, 1)
    shaded = tint.copy()
    shaded[:, :3] *= (0.45 + 0.55 * facing)[:, None]
    shaded[:, :3] += (0.25 * facing ** 24)[:, None] * (1 - shaded[:, :3])
    return shaded


def draw_surface(axes, points, triangles, tint):
    """The triangles as seen from the side and a little from above, farthest first."""
    right, up, toward = view_axes(azimuth=-24, elevation=20)
    corners = points[triangles]
    order = np.argsort((corners @ toward).mean(axis=1))
    face = shade(corners, tint, toward - 0.4 * right + 0.8 * up, toward)[order]
    flat = np.stack([corners @ right, corners @ up], axis=-1)[order]
    axes.add_collection(PolyCollection(flat, facecolors=face, edgecolors=face, linewidths=0.25))
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_axis_off()


def plot_tube(directory, unit):
    """The wall at the end, shaded and coloured."""
    path = os.path.join(directory, "wall.h5")
    if not os.path.exists(path):
        return
    with h5py.File(path, "r", locking=False) as file:
        frame = last_frame(file)
        points, triangles = frame["points"][...].astype(float), file["triangles"][...]
        name, words = pick_colouring(frame)
        if name is None or len(triangles) == 0:
            return
        values = face_values(frame, name, triangles)
        axis = Axis(unit_of(frame[name]), values)
        values = axis(values)
    low, high = np.percentile(values, [0.5, 99.5])
    norm = colors.Normalize(low, high if high > low else low + 1)
    figure, axes = plt.subplots(figsize=(9, 3.9))
    draw_surface(axes, points, triangles, matplotlib.colormaps["viridis"](norm(values)))
    bar = figure.colorbar(cm.ScalarMappable(norm, "viridis"), ax=axes, shrink=0.8, pad=0.01,
                          aspect=18)
    bar.set_label(axis.label(words))
    bar.outline.set_visible(False)
    length = np.ptp(points[:, 0])
    x_axis = Axis(unit, [length])
    axes.set_title(f"The wall at the end of the run; length {x_axis(length):.4g} "
                   f"{pretty(x_axis.unit)}", loc="left")
    save(figure, directory, "tube.png")


def wall_section(corners, normal, place=0.0):
    """Where triangles cut the plane in which coordinate `normal` is `place`: segments in the other
    two coordinates."""
    corners = corners[np.isfinite(corners).all(axis=(1, 2))]
    others = [c for c in range(3) if c != normal]
    z = corners[:, :, normal] - place + 1e-9 * np.ptp(corners[:, :, normal])  # no vertex in the plane
    crossing = []
    for a, b in ((0, 1), (1, 2), (2, 0)):
        span = z[:, a] - z[:, b]
        part = z[:, a] / np.where(span == 0, 1, span)
        cut = (corners[:, a] + part[:, None] * (corners[:, b] - corners[:, a]))[:, others]
        crossing.append(np.where((z[:, a] * z[:, b] < 0)[:, None], cut, np.nan))
    crossing = np.stack(crossing, axis=1)
    hit = np.isfinite(crossing[:, :, 0])
    return [c[h] for c, h in zip(crossing, hit) if h.sum() == 2]


def wall_corners(path, frame=-1):
    """Corners of the triangles of a frame."""
    with h5py.File(path, "r", locking=False) as file:
        name = sorted(file["frames"])[frame]
        return file["frames"][name]["points"][...].astype(float)[file["triangles"][...]]


def plot_flow(directory, unit):
    """Axial velocity in a plane through the axis, with the wall's outline: z = 0, or y = 0 where
    frames hold no other."""
    if not all(os.path.exists(os.path.join(directory, name))
               for name in ("wall.h5", "fluid.h5")):
        return
    with h5py.File(os.path.join(directory, "fluid.h5"), "r", locking=False) as file:
        frame = last_frame(file)
        velocity, origin, spacing = frame["velocity"], frame.attrs["origin"], frame.attrs["spacing"]
        u_unit = unit_of(velocity)
        normal = 1 if velocity.shape[1] == 1 else 2
        across = 3 - normal
        u = middle_layers(velocity, origin, spacing, normal)
    x_axis, u_axis = Axis(unit, [origin[0] + spacing[0] * u.shape[1]]), Axis(u_unit, u)
    begin, u = x_axis(origin[[0, across]]), u_axis(u)
    ends = begin + x_axis(spacing[[0, across]]) * np.array(u.shape)[::-1]
    shape = (ends[0] - begin[0]) / (ends[1] - begin[1])
    figure, axes = plt.subplots(figsize=(np.clip(3 * shape + 2.2, 5, 9), 3.8))
    high = np.nanpercentile(np.abs(u), 99.8) or 1
    picture = axes.imshow(u, origin="lower", extent=(begin[0], ends[0], begin[1], ends[1]),
                          interpolation="bilinear", cmap="RdBu_r", vmin=-high, vmax=high)
    corners = wall_corners(os.path.join(directory, "wall.h5"))
    wall = [x_axis(segment) for segment in wall_section(corners, normal)]
    hide_ghost_nodes(axes, wall, x_axis(spacing[[0, across]]), (begin, ends))
    axes.add_collection(LineCollection(wall, colors="#20242b", linewidths=1.6, capstyle="round"))
    axes.set(aspect="equal", xlabel=x_axis.label("$x$"), ylabel=x_axis.label(f"${' yz'[across]}$"))
    axes.grid(False)
    axes.set_title("Axial velocity in the plane of the axis\n"
                   "black: the wall; grey: ghost nodes, no flow", loc="left")
    bar = figure.colorbar(picture, ax=axes, shrink=0.8, pad=0.02)
    bar.set_label(u_axis.label("$u$"))
    bar.outline.set_visible(False)
    save(figure, directory, "flow.png")


GHOST_REACH = 2  # spacings outside the wall within which ghost nodes show in a picture


def hide_ghost_nodes(axes, wall, spacing, box):
    """Covers what lies just outside the wall: values there continue the flow inside backwards, to
    hold it at rest at the wall, and are no flow."""
    fine = 4  # pixels per spacing
    begin, ends = box
    x, y = (np.arange(b, e, h / fine) + h / (2 * fine) for b, e, h in zip(begin, ends, spacing))
    inside = inside_wall(x, y, wall)
    hidden = widened(inside, GHOST_REACH * fine) & ~inside
    axes.imshow(np.where(hidden, 1.0, np.nan), origin="lower", interpolation="nearest",
                extent=(begin[0], ends[0], begin[1], ends[1]), cmap=colors.ListedColormap(["#b9bcc2"]))


def inside_wall(x, y, wall):
    """Which points (y, x) of a grid have the wall an odd number of times below them."""
    crossings = np.zeros((len(y), len(x)), dtype=int)
    for (x0, y0), (x1, y1) in wall:
        for column in np.flatnonzero((x0 < x) != (x1 < x)):
            crossings[:, column] += y > y0 + (x[column] - x0) / (x1 - x0) * (y1 - y0)
    return crossings % 2 == 1


def widened(mask, radius):
    """The mask and all that is at most so many pixels from it."""
    padded, wide = np.pad(mask, radius), np.zeros_like(mask)
    rows, columns = mask.shape
    for row in range(-radius, radius + 1):
        reach = int(np.sqrt(radius ** 2 - row ** 2))
        for column in range(-reach, reach + 1):
            wide |= padded[radius + row:radius + row + rows, radius + column:radius + column + columns]
    return wide


def middle_layers(velocity, origin, spacing, normal):
    """Axial velocity in the plane through the axis: the mean of the layers beside it."""
    count = velocity.shape[2 - normal]
    middle = int(np.clip(round(-origin[normal] / spacing[normal]), 1, max(count - 1, 1)))
    layers = slice(max(middle - 1, 0), min(middle + 1, count))
    layer = velocity[layers, :, :, 0] if normal == 2 else velocity[:, layers, :, 0]
    return layer.astype(float).mean(axis=2 - normal)


def draw_breakdown(axes, fluid, walls, normal, place, unit):
    """Speed of the broken state in a plane through the place, with the wall before and after."""
    velocity = fluid["velocity"][...].astype(float)
    origin, spacing = fluid.attrs["origin"], fluid.attrs["spacing"]
    layer = int(np.clip((place[normal] - origin[normal]) / spacing[normal], 0,
                        velocity.shape[2 - normal] - 1))
    speed = np.linalg.norm(np.take(velocity, layer, axis=2 - normal), axis=-1)
    across, up = [c for c in range(3) if c != normal]
    u_axis = Axis(unit_of(fluid["velocity"]), speed)
    x_axis = Axis(unit, [np.max(spacing * np.array(velocity.shape[2::-1]))])
    begin, ends = origin, origin + spacing * np.array(velocity.shape[2::-1])
    with np.errstate(invalid="ignore"):
        high = np.percentile(speed[np.isfinite(speed)], 99) if np.isfinite(speed).any() else 1
    picture = axes.imshow(u_axis(speed), origin="lower", cmap="viridis", vmin=0,
                          vmax=u_axis(high) or 1,
                          extent=[x_axis(e) for e in (begin[across], ends[across], begin[up], ends[up])])
    for corners, color, width in zip(walls, ("#ffffff", RED), (2.2, 1.2)):
        section = wall_section(corners, normal, place[normal])
        axes.add_collection(LineCollection([x_axis(s) for s in section], colors=color,
                                           linewidths=width))
    axes.plot(*x_axis(place[[across, up]]), marker="o", ms=14, mfc="none", mec=RED, mew=2)
    axes.set(aspect="equal", xlabel=x_axis.label(f"${'xyz'[across]}$"),
             ylabel=x_axis.label(f"${'xyz'[up]}$"), facecolor="#d0d0d0",
             xlim=x_axis(np.array([begin[across], ends[across]])),
             ylim=x_axis(np.array([begin[up], ends[up]])))
    axes.grid(False)
    return picture, u_axis


def plot_breakdown(directory, unit, summary):
    """The neighbourhood of a breakdown: across the tube and along it."""
    paths = [os.path.join(directory, f"breakdown_{name}.h5") for name in ("wall", "fluid")]
    if not summary.get("breakdown") or not all(os.path.exists(p) for p in paths):
        return
    place = np.array([summary["breakdown"][c] for c in "xyz"])
    walls = [wall_corners(paths[0], frame) for frame in (0, -1)]
    figure, (section, side) = plt.subplots(1, 2, figsize=(9, 4.6))
    with h5py.File(paths[1], "r", locking=False) as file:
        fluid = last_frame(file)
        draw_breakdown(section, fluid, walls, 0, place, unit)
        along = 1 if abs(place[2]) > abs(place[1]) else 2
        picture, u_axis = draw_breakdown(side, fluid, walls, along, place, unit)
        step = fluid.attrs["step"]
    bar = figure.colorbar(picture, ax=side, shrink=0.8, pad=0.02)
    bar.set_label(u_axis.label("speed"))
    bar.outline.set_visible(False)
    section.set_title(f"Where step {step} broke down (circle)", loc="left")
    side.set_title("wall: white before, red then; grey: not finite", loc="left", fontsize=9)
    save(figure, directory, "breakdown.png")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    directory = sys.argv[1]
    series, profile = read(directory, "series.csv"), read(directory, "profile.csv")
    if series is None:
        sys.exit(f"starling plot: {directory} holds no series.csv")
    summary = {}
    if os.path.exists(os.path.join(directory, "summary.json")):
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as stream:
            summary = json.load(stream)
    with plt.rc_context(STYLE):
        plot_history(directory, series, summary)
        if profile is not None:
            plot_profiles(directory, profile, read(directory, "theory.csv"), law_of(directory))
        else:
            print("no profile.csv: the run has not ended; profiles.png left out")
        plot_tube(directory, series.units["R_max"])
        plot_flow(directory, series.units["R_max"])
        plot_waves(directory, series.units["t"])
        plot_breakdown(directory, series.units["R_max"], summary)


if __name__ == "__main__":
    main()
