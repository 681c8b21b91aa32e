/// What the program has put into the page: src/report makes it.

const NO_NUMBER = 65535;

function bytes(text) {
  const raw = atob(text);
  const all = new Uint8Array(raw.length);
  for (let n = 0; n < raw.length; ++n) all[n] = raw.charCodeAt(n);
  return all.buffer;
}

export const floats = (text) => new Float32Array(bytes(text));
export const integers = (text) => new Uint32Array(bytes(text));

/// A field's numbers in one frame; NaN where there is none.
export function fieldValues(field, frame) {
  const steps = new Uint16Array(bytes(field.values[frame]));
  const scale = (field.high - field.low) / 65534;
  return Float32Array.from(steps, (s) => (s === NO_NUMBER ? NaN : field.low + s * scale));
}

/// A table with its columns by name: {unit, values}.
function table(data) {
  if (!data) return null;
  const columns = new Map();
  for (const c of data.columns) columns.set(c.name, { unit: c.unit, values: floats(c.values) });
  return { rows: data.rows, columns };
}

export function readRun() {
  const run = JSON.parse(document.getElementById("run").textContent);
  for (const name of ["series", "profile", "theory"]) run[name] = table(run[name]);
  return run;
}

/// Number of the frame nearest in time to t.
export function nearestFrame(frames, t) {
  let best = 0;
  frames.forEach((f, n) => {
    if (Math.abs(f.t - t) < Math.abs(frames[best].t - t)) best = n;
  });
  return best;
}
