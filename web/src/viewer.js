/// Wall and flow in three dimensions, with all that steers them.
import { Mesh, MeshBasicMaterial, SphereGeometry } from "three";
import { gradient } from "./colours.js";
import { nearestFrame } from "./data.js";
import { byId, choice, element, labelled } from "./dom.js";
import { Flow } from "./flow.js";
import { Player } from "./player.js";
import { VIEWS, View3D } from "./scene.js";
import { Section } from "./section.js";
import { numberText, quantityText, shownIn } from "./units.js";
import { Wall } from "./wall.js";

/// A colour bar with the limits of its scale; `update` follows the object's field.
class ColourBar {
  constructor(name, object) {
    this.object = object;
    this.title = element("span", { class: "bar-title" });
    this.bar = element("div", { class: "bar" });
    this.limits = element("div", { class: "bar-limits" });
    this.node = element(
      "div",
      { class: "bar-box", id: `${name}-bar` },
      this.title,
      this.bar,
      this.limits,
    );
    this.name = name;
    this.update();
  }

  update() {
    const { object } = this;
    const field = object.data.fields[object.field],
      { scale } = object;
    const shown = shownIn(field.unit, Math.max(Math.abs(scale.from), Math.abs(scale.to)));
    this.title.textContent = `${this.name}: ${field.label}${shown.unit ? ` [${shown.unit}]` : ""}`;
    this.bar.style.background = gradient(scale);
    const numbers = [scale.from, (scale.from + scale.to) / 2, scale.to];
    this.limits.replaceChildren(
      ...numbers.map((v) => element("span", {}, numberText(v / shown.factor, 3))),
    );
  }
}

/// How much of the wall is taken away to show the flow.
const CUTS = [
  { part: "quarter", label: "a quarter cut away" },
  { part: "half", label: "half cut away" },
  { part: "whole", label: "whole" },
];

class Viewer {
  constructor(run, place) {
    this.run = run;
    this.t = NaN; // the time that is shown
    this.followers = []; // called when it changes
    this.canvas = element("div", { class: "canvas" });
    this.side = element("div", { class: "side" });
    this.bars = element("div", { class: "bars" });
    place.append(
      element("div", { class: "stage" }, this.canvas, this.side),
      this.bars,
      element(
        "p",
        { class: "remark" },
        "Drag to turn, wheel to zoom, right button to move. Fluid flows " +
          "along x, from left to right; y is up. The flow is shown in the plane through the axis, " +
          "inside the tube.",
      ),
    );
    this.view = new View3D(this.canvas);
    this.tools = element("div", { class: "tools" });
    this.addWall();
    this.addFlow();
    this.addBreakdown();
    this.wall?.show(this.frames.length - 1);
    this.view.fit((this.wall ?? this.flow).object);
    this.addTools(place);
    this.player.go(this.frames.length - 1);
  }

  get frames() {
    return (this.run.wall ?? this.run.flow).frames;
  }

  addWall() {
    if (!this.run.wall) return;
    this.wall = new Wall(this.run.wall);
    this.view.add(this.wall.object);
    this.view.add(this.wall.outline);
    this.section = new Section(this.side, this.wall, this.extreme(), () => this.view.draw());
    this.addColours("wall", this.wall);
  }

  /// Where the tube is narrowest, or widest if it has not collapsed.
  extreme() {
    const { summary } = this.run;
    return summary?.min_area_ratio < 0.99 ? summary.x_min_area : summary?.x_R_max;
  }

  addFlow() {
    if (!this.run.flow) return;
    this.flow = new Flow(this.run.flow);
    this.view.add(this.flow.object);
    this.addColours("flow", this.flow);
  }

  addColours(name, object) {
    if (!object.data.fields.length) return;
    const bar = new ColourBar(name, object);
    this.bars.append(bar.node);
    this.tools.append(
      labelled(
        `Colour of the ${name}`,
        choice(`${name}-field`, object.data.fields, (n) => {
          object.colourBy(n);
          bar.update();
          this.view.draw();
        }),
      ),
    );
  }

  /// A red ball where the computation broke down.
  addBreakdown() {
    const at = this.run.summary?.breakdown;
    if (!at || !this.wall) return;
    const radius = 0.06 * Math.max(...this.wall.section(0).flat().map(Math.abs));
    const ball = new Mesh(new SphereGeometry(radius), new MeshBasicMaterial({ color: "#d40000" }));
    ball.position.set(at.x, at.y, at.z);
    this.view.add(ball);
    this.tools.append(element("span", { class: "ball" }, "● where it broke down"));
  }

  addTools(place) {
    const views = Object.keys(VIEWS).map((name) =>
      element("button", { type: "button", click: () => this.view.look(name) }, name),
    );
    if (this.wall) this.addWallTools();
    this.canvas.append(element("div", { class: "views" }, ...views));
    this.player = new Player(this.frames, (n) => this.show(n));
    headingOf(place).after(this.tools, this.player.controls);
  }

  addWallTools() {
    const cut = choice("cut", CUTS, (n) => this.cut(CUTS[n].part));
    cut.value = this.flow ? 0 : CUTS.length - 1;
    const opacity = element("input", {
      id: "opacity",
      type: "range",
      min: 0.1,
      max: 1,
      step: 0.05,
      value: 1,
      input: (e) => {
        this.wall.opacity(Number(e.target.value));
        this.view.draw();
      },
    });
    this.tools.append(labelled("Wall", cut), labelled("Opacity", opacity));
    this.cut(CUTS[cut.value].part);
  }

  cut(part) {
    this.wall.object.updateWorldMatrix(true, false);
    this.wall.cut(this.flow?.data.normal ?? "z", this.flow?.level ?? 0, part);
    this.view.draw();
  }

  /// Shows the frame nearest in time to t; a film stops there.
  goTo(t) {
    this.player.choose(nearestFrame(this.frames, t));
  }

  /// Shows a frame; returns what it is in words.
  show(n) {
    const { t, step } = this.frames[n];
    this.wall?.show(n);
    const flow = this.flow ? this.flow.show(t, this.wall) : -1;
    this.section?.draw();
    this.view.draw();
    this.t = t;
    this.followers.forEach((follow) => follow());
    const unit = this.run.unit_of_t;
    return (
      `t = ${quantityText(t, unit)} (step ${step}, frame ${n + 1} of ${this.frames.length})` +
      this.flowText(flow, t, unit)
    );
  }

  flowText(frame, t, unit) {
    if (!this.flow || !this.wall) return "";
    if (frame < 0) return "; no frame of the flow at this time";
    const at = this.flow.data.frames[frame].t;
    return at === t ? "" : `; flow at t = ${quantityText(at, unit)}`;
  }
}

const headingOf = (place) => place.querySelector("h2");

/// Builds the view; without WebGL says so instead. Returns it, or null.
export function showViewer(run) {
  const place = byId("viewer");
  if (!run.wall && !run.flow) {
    place.append(
      element("p", {}, "This run has written no frames of wall or flow that could be shown."),
    );
    return null;
  }
  try {
    return new Viewer(run, place);
  } catch (error) {
    if (!/WebGL/i.test(String(error))) throw error;
    place.replaceChildren(
      headingOf(place),
      element(
        "p",
        { class: "box warn" },
        "This browser has no WebGL, so wall and flow cannot be shown in three dimensions.",
      ),
    );
    return null;
  }
}
