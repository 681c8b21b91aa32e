/// A plane of the flow through the axis, coloured by a field; nothing is drawn outside the tube.
import {
  DataTexture, DoubleSide, LinearFilter, Mesh, MeshBasicMaterial, PlaneGeometry, SRGBColorSpace,
} from "three";
import { colourScale } from "./colours.js";
import { fieldValues, nearestFrame } from "./data.js";

export class Flow {
  constructor(data) {
    this.data = data;
    const [nx, ny] = data.cells;
    this.texture = new DataTexture(new Uint8Array(4 * nx * ny), nx, ny);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.magFilter = LinearFilter;
    const material = new MeshBasicMaterial({ map: this.texture, side: DoubleSide, alphaTest: 0.5 });
    this.object = new Mesh(this.plane(), material);
    this.field = 0;
    this.frame = data.frames.length - 1;
    this.colour();
  }

  plane() {
    const { cells, origin, spacing, normal } = this.data;
    const across = normal === "y" ? spacing[2] : spacing[1];
    const width = cells[0] * spacing[0], height = cells[1] * across;
    const plane = new PlaneGeometry(width, height);
    if (normal === "y") plane.rotateX(Math.PI / 2);
    const centre = [origin[0] + width / 2, origin[1], origin[2]];
    centre[normal === "y" ? 2 : 1] += height / 2;
    return plane.translate(...centre);
  }

  get scale() {
    return colourScale(this.data.fields[this.field]);
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

  /// Shows the flow at t; returns its frame, or -1 where there is none and nothing is drawn.
  show(t) {
    const frame = this.frameAt(t);
    this.object.visible = frame >= 0;
    if (frame >= 0 && frame !== this.frame) {
      this.frame = frame;
      this.colour();
    }
    return frame;
  }

  colourBy(field) {
    this.field = field;
    this.colour();
  }

  colour() {
    const values = fieldValues(this.data.fields[this.field], this.frame);
    const scale = this.scale, pixels = this.texture.image.data;
    values.forEach((value, n) => {
      const inside = Number.isFinite(value);
      pixels.set(inside ? scale.colour(value).map(Math.round) : [0, 0, 0], 4 * n);
      pixels[4 * n + 3] = inside ? 255 : 0;
    });
    spreadOutwards(pixels, this.data.cells);
    this.texture.needsUpdate = true;
  }
}

/// Gives cells outside the tube the colour of a neighbour inside, so that the edge is not darkened
/// where the texture is interpolated.
function spreadOutwards(pixels, [nx, ny]) {
  for (let j = 0; j < ny; ++j)
    for (let i = 0; i < nx; ++i) {
      const at = 4 * (j * nx + i);
      if (pixels[at + 3] !== 0) continue;
      const inside = [[0, 1], [0, -1], [1, 0], [-1, 0]]
        .map(([a, b]) => [i + a, j + b])
        .filter(([a, b]) => a >= 0 && a < nx && b >= 0 && b < ny)
        .map(([a, b]) => 4 * (b * nx + a))
        .find((from) => pixels[from + 3] === 255);
      if (inside !== undefined) pixels.copyWithin(at, inside, inside + 3);
    }
}
