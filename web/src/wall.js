/// The wall as a surface, coloured by a field.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  LineBasicMaterial,
  LineLoop,
  Mesh,
  MeshLambertMaterial,
  Plane,
  Vector3,
} from "three";
import { colourScale } from "./colours.js";
import { fieldValues, floats, integers } from "./data.js";

const NO_COLOUR = [190, 194, 200];

/// Red, green and blue of each vertex, as the shader wants them: linear.
function paint(colours, values, scale) {
  for (let v = 0; v < values.length; ++v) {
    const rgb = Number.isFinite(values[v]) ? scale.colour(values[v]) : NO_COLOUR;
    for (let c = 0; c < 3; ++c) colours[3 * v + c] = (rgb[c] / 255) ** 2.2;
  }
}

export class Wall {
  constructor(data) {
    this.data = data;
    const geometry = new BufferGeometry();
    geometry.setIndex(new BufferAttribute(integers(data.triangles), 1));
    geometry.setAttribute("position", new BufferAttribute(floats(data.points[0]), 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(3 * data.vertices), 3));
    this.material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide });
    this.object = new Mesh(geometry, this.material);
    this.rings = ringsOf(floats(data.points[0]));
    this.outline = new LineLoop(new BufferGeometry(), new LineBasicMaterial({ color: "#111418" }));
    this.field = 0;
    this.frame = 0;
    this.ring = 0;
  }

  get points() {
    return this.object.geometry.getAttribute("position").array;
  }
  get scale() {
    return colourScale(this.data.fields[this.field]);
  }

  show(frame) {
    this.frame = frame;
    const { geometry } = this.object;
    geometry.getAttribute("position").copyArray(floats(this.data.points[frame])).needsUpdate = true;
    geometry.computeVertexNormals();
    geometry.computeBoundingSphere();
    this.colour();
    this.mark(this.ring);
  }

  colourBy(field) {
    this.field = field;
    this.colour();
  }

  colour() {
    const colours = this.object.geometry.getAttribute("color");
    if (this.data.fields.length)
      paint(colours.array, fieldValues(this.data.fields[this.field], this.frame), this.scale);
    else colours.array.fill(0.6);
    colours.needsUpdate = true;
  }

  /// Points y, z of a ring as it stands now.
  section(ring) {
    const { begin, end } = this.rings[ring];
    return Array.from({ length: end - begin }, (_, n) => {
      const at = 3 * (begin + n);
      return [this.points[at + 1], this.points[at + 2]];
    });
  }

  /// Largest |y| or |z| of a vertex at any time.
  reach() {
    let reach = 1e-30;
    for (const frame of this.data.points)
      floats(frame).forEach((v, n) => {
        if (n % 3 > 0) reach = Math.max(reach, Math.abs(v));
      });
    return reach;
  }

  /// Draws a line around the tube at a ring.
  mark(ring) {
    this.ring = ring;
    const { begin, end } = this.rings[ring];
    const line = this.points.slice(3 * begin, 3 * end);
    this.outline.geometry.setAttribute("position", new BufferAttribute(line, 3));
  }

  /// Hides nothing ("whole"), what stands in front of the plane of the flow ("half"), which is of
  /// constant y or z (`normal`) at `level`, or of that what lies beyond the other plane through the
  /// axis ("quarter").
  cut(normal, level, part) {
    const [y, z] = [new Vector3(0, -1, 0), new Vector3(0, 0, -1)];
    const front = new Plane(normal === "y" ? y : z, level);
    const other = new Plane(normal === "y" ? z : y, 0);
    const planes = { whole: [], half: [front], quarter: [front, other] }[part];
    for (const plane of planes) plane.applyMatrix4(this.object.matrixWorld);
    this.material.clippingPlanes = planes;
    this.material.clipIntersection = true; // hidden is what lies beyond all of the planes
    this.material.needsUpdate = true;
  }

  opacity(value) {
    this.material.opacity = value;
    this.material.transparent = value < 1;
    this.material.depthWrite = value === 1;
    this.material.needsUpdate = true;
  }
}

/// Vertices of one x follow one another: {x, begin, end} of each ring.
function ringsOf(points) {
  const rings = [];
  for (let v = 0; v < points.length / 3; ++v) {
    if (rings.length === 0 || points[3 * v] !== rings[rings.length - 1].x)
      rings.push({ x: points[3 * v], begin: v, end: v });
    rings[rings.length - 1].end = v + 1;
  }
  return rings;
}
