/// Where a plane through the axis runs inside the tube.

/// For each ring of the wall {x, spans}: the intervals [low, high] of y (or z) inside it, on the
/// plane of constant z (or y) at `origin`.
export function insideSpans(wall, normal, origin) {
  const [along, across] = normal === "y" ? [1, 0] : [0, 1]; // of points [y, z]
  const level = normal === "y" ? origin[1] : origin[2];
  return wall.rings.map(({ x }, n) => ({
    x,
    spans: pairs(crossings(wall.section(n), along, across, level)),
  }));
}

/// Where a closed outline crosses the level, ascending.
function crossings(points, along, across, level) {
  const found = [];
  points.forEach((b, n) => {
    const a = points[(n || points.length) - 1];
    if (a[across] > level === b[across] > level) return;
    const share = (level - a[across]) / (b[across] - a[across]);
    found.push(a[along] + share * (b[along] - a[along]));
  });
  return found.sort((p, q) => p - q);
}

const pairs = (ends) =>
  Array.from({ length: ends.length / 2 }, (_, n) => [ends[2 * n], ends[2 * n + 1]]);

/// The intervals at x: between rings with equally many in proportion, else those of the nearer one.
export function between(rings, x) {
  let n = rings.findIndex((ring) => ring.x >= x);
  if (n < 0) n = rings.length - 1;
  const [a, b] = [rings[Math.max(0, n - 1)], rings[n]];
  const share = b.x > a.x ? Math.min(1, Math.max(0, (x - a.x) / (b.x - a.x))) : 1;
  if (a.spans.length !== b.spans.length) return (share < 0.5 ? a : b).spans;
  return a.spans.map((span, m) => span.map((end, k) => end + share * (b.spans[m][k] - end)));
}
