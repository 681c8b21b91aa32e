/// Which plots a run has.
import { byId, element } from "./dom.js";
import { drawChart, shareTime } from "./charts.js";

const MODES = [2, 3, 4, 5, 6, 7, 8];

const isCollapsed = (run) =>
  run.series?.columns.get("min_area_ratio")?.values.some((v) => v < 0.99) ?? false;

/// Columns of a table that hold numbers other than zero.
function present(table, names) {
  const has = ([name]) =>
    table.columns.get(name)?.values.some((v) => Number.isFinite(v) && v !== 0);
  return names.filter(has).map(([name, label]) => ({ ...table.columns.get(name), label }));
}

/// A constant beside the lines, such as what theory says.
function constant(rows, value, unit, label) {
  return Number.isFinite(value) && rows > 0
    ? [{ label, unit, values: new Float32Array(rows).fill(value), dashed: true }]
    : [];
}

/// A column of the model at the x of the profile.
function ofModel(run, name, label) {
  if (!run.theory?.columns.has(name)) return [];
  const { unit, values } = run.theory.columns.get(name);
  const from = run.theory.columns.get("x").values;
  const at = run.profile.columns.get("x").values;
  return [{ label, unit, values: at.map((x) => interpolated(from, values, x)), dashed: true }];
}

function interpolated(xs, values, x) {
  let n = xs.findIndex((v) => v >= x);
  if (n < 0) n = xs.length - 1;
  if (n === 0) n = 1;
  const share = (x - xs[n - 1]) / (xs[n] - xs[n - 1]);
  return values[n - 1] + Math.min(1, Math.max(0, share)) * (values[n] - values[n - 1]);
}

function chartsOverTime(run) {
  const { series, summary } = run;
  const theory = summary?.theory;
  const of = (...names) => present(series, names);
  const charts = [
    {
      key: "flow",
      title: "Flow rate in the tube",
      y: "Q",
      lines: [
        ...of(["Q_in", "inlet"], ["Q_mid", "half way"], ["Q_out", "outlet"]),
        ...constant(series.rows, theory?.Q_1d, series.columns.get("Q_mid").unit, "1-D model"),
      ],
    },
    {
      key: "radius",
      title: "Radius of the tube",
      y: "R",
      lines: [
        ...of(["R_max", "largest (ring mean)"], ["R_min", "smallest (of a vertex)"]),
        ...constant(
          series.rows,
          theory?.R_max_1d,
          series.columns.get("R_max").unit,
          "1-D model, largest",
        ),
      ],
    },
    {
      key: "leak",
      title: "Volume balance",
      y: "rate",
      lines: of(["dV_dt", "dV/dt"], ["leak", "leak through the wall"]),
    },
    {
      key: "displacement",
      title: "Displacement",
      y: "|d|",
      lines: of(["largest_displacement", "largest of a vertex"]),
    },
    { key: "strain", title: "Strain", y: "λ₁ − 1", lines: of(["max_strain", "largest principal"]) },
    {
      key: "energy",
      title: "Energies",
      y: "E",
      lines: of(
        ["kinetic_energy", "kinetic"],
        ["elastic_energy", "elastic"],
        ["bending_energy", "bending"],
      ),
    },
    {
      key: "power",
      title: "Balance of power",
      y: "power",
      lines: of(
        ["power_in", "inlet"],
        ["power_out", "outlet"],
        ["power_viscous", "viscous"],
        ["power_kinetic", "kinetic"],
        ["power_wall", "wall"],
        ["power_residual", "left over"],
      ),
    },
    { key: "cfl", title: "Courant number", y: "CFL", lines: of(["cfl", "CFL"]) },
  ];
  const collapse = [
    {
      key: "area",
      title: "Smallest cross-section",
      y: "A/A₀",
      lines: of(["min_area_ratio", "A/A₀"]),
    },
    {
      key: "gap",
      title: "Gap between opposite walls",
      y: "gap",
      lines: of(["smallest_gap", "smallest"]),
    },
  ];
  if (isCollapsed(run)) charts.splice(2, 0, ...collapse);
  return charts;
}

function chartsAlongTube(run) {
  const of = (...names) => present(run.profile, names);
  const charts = [
    {
      key: "profile-radius",
      title: "Radius",
      y: "R",
      lines: [
        ...of(["R_mean", "mean"], ["R_min", "smallest"], ["R_max", "largest"]),
        ...ofModel(run, "R", "1-D model"),
      ],
    },
    {
      key: "profile-pressure",
      title: "Pressure",
      y: "P",
      lines: [
        ...of(["P_centre", "on the axis"], ["P_transmural", "internal − external"]),
        ...ofModel(run, "P", "1-D model, axis"),
      ],
    },
    { key: "profile-flow", title: "Flow rate", y: "Q", lines: of(["Q", "inside the tube"]) },
    { key: "profile-area", title: "Cross-section", y: "A", lines: of(["area", "area"]) },
  ];
  const lobed = [
    {
      key: "profile-gap",
      title: "Gap between opposite walls",
      y: "gap",
      lines: of(["gap", "smallest"]),
    },
    {
      key: "profile-modes",
      title: "Waves around the tube",
      y: "amplitude",
      lines: of(...MODES.map((n) => [`mode_${n}`, `${n} lobes`])),
    },
  ];
  return isCollapsed(run) ? [...charts, ...lobed] : charts;
}

function draw(parent, charts, x, plots, viewer) {
  const grid = element("div", { class: "charts" });
  parent.append(
    element(
      "p",
      { class: "remark" },
      "Point to read values, drag to zoom in, double-click to zoom out; click a name to hide it." +
        (viewer ? " Click in a plot to see wall and flow at that time, the dotted line." : ""),
    ),
    grid,
  );
  for (const chart of charts)
    if (chart.lines.length) {
      plots[chart.key] = drawChart(grid, { ...chart, x });
      if (viewer) shareTime(plots[chart.key], viewer);
    }
}

/// Draws all plots; returns them by their keys. Those over time and `viewer`, if there is one, show
/// the same time.
export function showCharts(run, viewer) {
  const plots = {};
  if (run.series)
    draw(
      byId("over-time"),
      chartsOverTime(run),
      { label: "t", ...run.series.columns.get("t") },
      plots,
      viewer,
    );
  else byId("over-time").remove();
  if (run.profile)
    draw(
      byId("along-tube"),
      chartsAlongTube(run),
      { label: "x", ...run.profile.columns.get("x") },
      plots,
    );
  else byId("along-tube").remove();
  return plots;
}
