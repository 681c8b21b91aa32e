/// The outline of one cross-section, seen from the inlet, at the time that is shown and in the
/// first frame; at first the section at `x`.
import { element } from "./dom.js";
import { quantityText } from "./units.js";

const SIZE = 240;
const SVG = "http://www.w3.org/2000/svg";

function shape(name, attributes) {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  return node;
}

export class Section {
  constructor(place, wall, x, changed) {
    this.wall = wall;
    this.changed = changed;
    this.first = wall.rings.map((_, n) => wall.section(n));
    this.factor = (0.44 * SIZE) / wall.reach();
    this.before = shape("path", { class: "before" });
    this.now = shape("path", { class: "now" });
    const picture = shape("svg", {
      viewBox: `${-SIZE / 2} ${-SIZE / 2} ${SIZE} ${SIZE}`,
      role: "img",
    });
    picture.append(this.before, this.now);
    this.slider = element("input", {
      id: "section-x",
      type: "range",
      min: 0,
      max: wall.rings.length - 1,
      value: this.nearest(x),
      input: () => this.choose(),
    });
    this.words = element("output", {});
    place.append(
      element("h3", {}, "Cross-section"),
      picture,
      this.slider,
      this.words,
      element(
        "p",
        { class: "remark" },
        "Blue: now; grey: in the first frame. y up, z to the right.",
      ),
    );
    this.choose();
  }

  /// Number of the ring nearest to x; half way where x is not known.
  nearest(x) {
    const { rings } = this.wall;
    if (!Number.isFinite(x)) return Math.floor(rings.length / 2);
    const apart = rings.map((ring) => Math.abs(ring.x - x));
    return apart.indexOf(Math.min(...apart));
  }

  choose() {
    this.wall.mark(Number(this.slider.value));
    this.draw();
    this.changed();
  }

  draw() {
    const ring = Number(this.slider.value);
    const path = (points) =>
      "M" +
      points
        .map(([y, z]) => `${(z * this.factor).toFixed(2)},${(-y * this.factor).toFixed(2)}`)
        .join("L") +
      "Z";
    this.before.setAttribute("d", path(this.first[ring]));
    this.now.setAttribute("d", path(this.wall.section(ring)));
    this.words.textContent = `x = ${quantityText(this.wall.rings[ring].x, this.wall.data.unit)}`;
  }
}
