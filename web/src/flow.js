/// A plane of the flow through the axis, coloured by a field; nothing is drawn outside the tube.
import {
  DataTexture,
  DoubleSide,
  LinearFilter,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  SRGBColorSpace,
} from "three";
import { colourScale } from "./colours.js";
import { fieldValues, nearestFrame } from "./data.js";
import { between, insideSpans } from "./lumen.js";

const WIDTH = 1200; // pixels along the tube, about

export class Flow {
  constructor(data) {
    this.data = data;
    this.finer = Math.min(16, Math.max(1, Math.round(WIDTH / data.cells[0]))); // pixels per cell
    this.size = data.cells.map((n) => n * this.finer);
    this.texture = new DataTexture(new Uint8Array(4 * this.size[0] * this.size[1]), ...this.size);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.magFilter = LinearFilter;
    const material = new MeshBasicMaterial({ map: this.texture, side: DoubleSide, alphaTest: 0.5 });
    this.object = new Mesh(this.plane(), material);
    this.field = 0;
    this.frame = data.frames.length - 1;
  }

  get across() {
    return this.data.normal === "y" ? 2 : 1;
  }

  /// Where the plane stands along its normal.
  get level() {
    return this.data.origin[this.data.normal === "y" ? 1 : 2];
  }

  plane() {
    const { cells, origin, spacing, normal } = this.data;
    const width = cells[0] * spacing[0],
      height = cells[1] * spacing[this.across];
    const plane = new PlaneGeometry(width, height);
    if (normal === "y") plane.rotateX(Math.PI / 2);
    const centre = [origin[0] + width / 2, origin[1], origin[2]];
    centre[this.across] += height / 2;
    return plane.translate(...centre);
  }

  get scale() {
    return colourScale(this.data.fields[this.field], "warm");
  }

  /// The frame that belongs to time t: the nearest, if it is no further than half the time between
  /// frames, else -1.
  frameAt(t) {
    const { frames } = this.data;
    const n = nearestFrame(frames, t);
    const apart = (m) => (frames[m] ? Math.abs(frames[m].t - frames[n].t) : 0);
    const reach = Math.max(apart(n - 1), apart(n + 1)) / 2 + 1e-6 * Math.abs(t);
    return Math.abs(frames[n].t - t) <= reach ? n : -1;
  }

  /// Shows the flow at t inside the wall as it stands; returns its frame, or -1 where there is none
  /// and nothing is drawn.
  show(t, wall) {
    const frame = this.frameAt(t);
    this.object.visible = frame >= 0;
    if (frame < 0) return frame;
    this.frame = frame;
    this.spans = wall ? insideSpans(wall, this.data.normal, this.data.origin) : null;
    this.colour();
    return frame;
  }

  colourBy(field) {
    this.field = field;
    this.colour();
  }

  colour() {
    this.texture.image.data.fill(0);
    const values = fieldValues(this.data.fields[this.field], this.frame);
    for (let i = 0; i < this.size[0]; ++i) this.colourColumn(i, values, this.scale);
    this.texture.needsUpdate = true;
  }

  /// The pixels of one x, those that lie wholly inside the wall.
  colourColumn(i, values, scale) {
    const { origin, spacing, cells } = this.data;
    const pixel = spacing[this.across] / this.finer;
    const a = (i + 0.5) / this.finer;
    const spans = this.spans
      ? between(this.spans, origin[0] + a * spacing[0])
      : [[-Infinity, Infinity]];
    for (let j = 0; j < this.size[1]; ++j) {
      const place = origin[this.across] + (j + 0.5) * pixel;
      if (!spans.some(([low, high]) => low + pixel / 2 <= place && place <= high - pixel / 2))
        continue;
      const value = interpolated(values, cells, a - 0.5, (j + 0.5) / this.finer - 0.5);
      const at = 4 * (j * this.size[0] + i);
      if (Number.isFinite(value)) setPixel(this.texture.image.data, at, scale.colour(value));
    }
  }
}

function setPixel(pixels, at, [red, green, blue]) {
  pixels[at] = red;
  pixels[at + 1] = green;
  pixels[at + 2] = blue;
  pixels[at + 3] = 255;
}

/// Bilinear between cell centres, over those cells that hold a number.
function interpolated(values, [nx, ny], a, b) {
  const i = Math.floor(a),
    j = Math.floor(b);
  let sum = 0,
    weights = 0;
  for (let n = 0; n < 4; ++n) {
    const p = i + (n & 1),
      q = j + (n >> 1);
    if (p < 0 || q < 0 || p >= nx || q >= ny) continue;
    const value = values[q * nx + p];
    if (Number.isNaN(value)) continue;
    const weight = (n & 1 ? a - i : 1 - a + i) * (n >> 1 ? b - j : 1 - b + j) + 1e-9;
    sum += weight * value;
    weights += weight;
  }
  return weights > 0 ? sum / weights : NaN;
}
