/// The case and its results in words and numbers.
import { byId, element } from "./dom.js";
import { numberText, pretty, quantityText } from "./units.js";

/// How the run stands: [class of the badge, words].
function state(run) {
  if (run.running) return ["going", "still running: these are the results so far"];
  const { summary } = run;
  if (!summary) return ["broken", "has not ended: these are the results up to where it stopped"];
  if (summary.reason.startsWith("numerical error"))
    return ["broken", "broke down: the numbers are those of the last sound state"];
  if (summary.converged) return ["good", "steady"];
  return ["going", `ended: ${summary.reason}; not steady`];
}

const endOf = ({ columns, rows }, name) => columns.get(name).values[rows - 1];

/// Steps, time and cost, as far as they are known.
function ending(run) {
  const { summary, series } = run;
  const parts = [];
  const t = summary ? summary.t : series && endOf(series, "t");
  const steps = summary ? summary.steps : series && endOf(series, "step");
  const unit = series?.columns.get("t").unit ?? summary?.units?.t ?? "";
  if (Number.isFinite(t)) parts.push(`t = ${quantityText(t, unit)}`);
  if (Number.isFinite(steps)) parts.push(`${steps} steps`);
  if (summary)
    parts.push(
      `${summary.cells.toLocaleString("en")} cells`,
      `${summary.vertices.toLocaleString("en")} wall vertices`,
    );
  return parts.join(" · ");
}

export function showHead(run) {
  const [kind, words] = state(run);
  const title = run.title || run.directory;
  document.title = `${title} – Starling`;
  byId("head").append(
    element("div", { class: "kicker" }, `Starling · ${run.directory}`),
    element("h1", {}, title),
    element(
      "p",
      { class: "standing" },
      element("span", { class: `badge ${kind}`, id: "state" }, words),
      element("span", { class: "ending" }, ending(run)),
    ),
  );
  byId("foot").textContent = `Written by ${run.generator}.`;
}

function box(kind, heading, lines) {
  const items = lines.map((line) => element("li", {}, line));
  return element(
    "div",
    { class: `box ${kind}` },
    element("strong", {}, heading),
    element("ul", {}, ...items),
  );
}

export function showNotes(run) {
  const reason = run.summary?.reason ?? "";
  if (reason.startsWith("numerical error"))
    byId("notes").append(box("bad", "The computation broke down", reason.split("\n")));
  const warnings = run.summary?.warnings ?? [];
  if (warnings.length) byId("notes").append(box("warn", "Before the numbers are used", warnings));
  if (run.notes.length) byId("notes").append(box("info", "About this page", run.notes));
}

function resultRow({ label, value, unit, theory, difference }) {
  const larger = Math.max(Math.abs(value), Math.abs(theory ?? 0)); // both in one multiple of the unit
  const number = (v) =>
    element("td", { class: "number" }, v === undefined ? "" : quantityText(v, unit, larger));
  const percent =
    difference === undefined
      ? ""
      : `${difference >= 0 ? "+" : "−"}${numberText(Math.abs(100 * difference), 2)} %`;
  return element(
    "tr",
    {},
    element("th", {}, pretty(label)),
    number(value),
    number(theory),
    element("td", { class: "number" }, percent),
  );
}

export function showResults(run) {
  if (!run.results?.length) return byId("results").remove();
  const titles = ["", "run", "theory", "difference"].map((t) => element("th", {}, t));
  byId("results").append(
    element(
      "table",
      {},
      element("thead", {}, element("tr", {}, ...titles)),
      element("tbody", {}, ...run.results.map(resultRow)),
    ),
  );
  if (run.summary?.theory)
    byId("results").append(
      element(
        "p",
        { class: "remark" },
        "Theory is the one-dimensional model of the same clamped tube.",
      ),
    );
  else if (run.results.some((r) => r.theory !== undefined))
    byId("results").append(
      element(
        "p",
        { class: "remark" },
        "Theory is the linear theory of buckling under the pressures of the case.",
      ),
    );
}

export function showCase(run) {
  if (!run.case) {
    byId("case").remove();
    return byId("case-text").remove();
  }
  const rows = run.case.rows.map(({ label, value, unit }) =>
    element(
      "tr",
      {},
      element("th", {}, pretty(label)),
      element("td", { class: "number" }, quantityText(value, unit)),
    ),
  );
  byId("case").append(
    element("p", {}, pretty(run.case.words)),
    element("table", {}, element("tbody", {}, ...rows)),
  );
  byId("case-text").querySelector("pre").textContent = run.case.text;
}
