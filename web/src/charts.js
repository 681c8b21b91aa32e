/// Plots of the columns of a table: a cursor that reads values, zoom by dragging.
import uPlot from "uplot";
import { element } from "./dom.js";
import { largestOf, numberText, shownIn } from "./units.js";

const COLOURS = ["#1f5fa8", "#c8452c", "#2c8a5b", "#8452a8", "#b8860b", "#3a9aa8", "#6b6f78"];
const HEIGHT = 250;
const FEW = 3; // points

const points = (values) => Array.from(values, (v) => (Number.isFinite(v) ? v : null));

function axis(label, shown, extra) {
  return {
    label: shown.unit ? `${label} [${shown.unit}]` : label,
    labelFont: "13px system-ui, sans-serif",
    font: "12px system-ui, sans-serif",
    stroke: "#4a505a",
    grid: { stroke: "#e8eaee", width: 1 },
    ticks: { stroke: "#c9cdd4", width: 1 },
    values: (_, splits) => splits.map((v) => numberText(v / shown.factor)),
    ...extra,
  };
}

/// The number at the cursor, or the last one while there is none.
const readOut =
  ({ factor }) =>
  (plot, value, column, row) => {
    const shown = row === null ? plot.data[column].at(-1) : value;
    return numberText(shown === null ? NaN : shown / factor);
  };

function line({ label, dashed, values }, n, shown) {
  const few = values.length < FEW; // which lines alone would not show
  return {
    label,
    stroke: dashed ? "#6b6f78" : COLOURS[n % COLOURS.length],
    width: dashed ? 1.5 : 2,
    dash: dashed ? [6, 4] : undefined,
    points: { show: few },
    spanGaps: false,
    value: readOut(shown),
  };
}

/// Limits that leave a flat line in the middle of the plot instead of magnifying round-off.
function limits(_, low, high) {
  if (low === null) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const margin = Math.max(0.06 * (high - low), 1e-6 * size) || 1;
  return [low - margin, high + margin];
}

/// Draws `chart` = {title, x: {label, unit, values}, lines: [{label, unit, values, dashed}]} into
/// `parent` and returns the plot.
export function drawChart(parent, chart) {
  const x = shownIn(chart.x.unit, largestOf(chart.x.values));
  const y = shownIn(chart.lines[0].unit, largestOf(...chart.lines.map((l) => l.values)));
  const place = element("div", { class: "chart" }, element("h3", {}, chart.title));
  parent.append(place);
  const options = {
    width: place.clientWidth || 480,
    height: HEIGHT,
    scales: { x: { time: false }, y: { range: limits } },
    cursor: { drag: { x: true, y: true, uni: 30 } },
    series: [
      { label: chart.x.label, value: readOut(x) },
      ...chart.lines.map((l, n) => line(l, n, y)),
    ],
    axes: [
      axis(chart.x.label, x, { labelSize: 22 }),
      axis(chart.y ?? "", y, { size: 74, labelSize: 22 }),
    ],
  };
  const plot = new uPlot(
    options,
    [points(chart.x.values), ...chart.lines.map((l) => points(l.values))],
    place,
  );
  new ResizeObserver(() => plot.setSize({ width: place.clientWidth, height: HEIGHT })).observe(
    place,
  );
  return plot;
}

/// Marks the time that `viewer` shows in a plot over time; a click in the plot sets it.
export function shareTime(plot, viewer) {
  (plot.hooks.draw ??= []).push(() => markTime(plot, viewer.t));
  viewer.followers.push(() => plot.redraw(false));
  plot.redraw(false);
  let pressed = 0;
  plot.over.addEventListener("mousedown", (e) => (pressed = e.clientX));
  plot.over.addEventListener("click", (e) => {
    const dragged = Math.abs(e.clientX - pressed) > 3; // to zoom
    if (!dragged) viewer.goTo(plot.posToVal(e.offsetX, "x"));
  });
}

function markTime({ ctx, bbox, valToPos }, t) {
  const x = valToPos(t, "x", true);
  if (!(x >= bbox.left && x <= bbox.left + bbox.width)) return;
  ctx.save();
  ctx.strokeStyle = "#1d2129";
  ctx.lineWidth = window.devicePixelRatio;
  ctx.setLineDash([2, 3].map((n) => n * window.devicePixelRatio));
  ctx.beginPath();
  ctx.moveTo(x, bbox.top);
  ctx.lineTo(x, bbox.top + bbox.height);
  ctx.stroke();
  ctx.restore();
}
