/// Units and numbers for people.

/// SI units and what they are drawn in, from large to small; other units stay as they are.
const MULTIPLES = {
  m: [
    ["m", 1],
    ["mm", 1e-3],
    ["µm", 1e-6],
  ],
  "m^2": [
    ["m²", 1],
    ["mm²", 1e-6],
    ["µm²", 1e-12],
  ],
  "m^3": [
    ["m³", 1],
    ["l", 1e-3],
    ["ml", 1e-6],
    ["µl", 1e-9],
    ["nl", 1e-12],
  ],
  s: [
    ["s", 1],
    ["ms", 1e-3],
    ["µs", 1e-6],
  ],
  "m/s": [
    ["m/s", 1],
    ["mm/s", 1e-3],
    ["µm/s", 1e-6],
  ],
  "m^3/s": [
    ["l/s", 1e-3],
    ["ml/s", 1e-6],
    ["µl/s", 1e-9],
    ["nl/s", 1e-12],
  ],
  Pa: [
    ["kPa", 1e3],
    ["Pa", 1],
    ["mPa", 1e-3],
  ],
  "N/m": [
    ["N/m", 1],
    ["mN/m", 1e-3],
    ["µN/m", 1e-6],
  ],
  J: [
    ["J", 1],
    ["mJ", 1e-3],
    ["µJ", 1e-6],
    ["nJ", 1e-9],
    ["pJ", 1e-12],
  ],
};

/// Units in a text as they are printed: R_0^2 as R₀².
export const pretty = (text) =>
  text.replace(/_0/g, "₀").replace(/\^2/g, "²").replace(/\^3/g, "³").replace(/rho/g, "ρ");

/// The unit in which numbers up to `largest` are shown: {unit, factor}, value/factor is shown.
export function shownIn(unit, largest) {
  const multiples = MULTIPLES[unit];
  if (!multiples) return { unit: unit === "1" ? "" : pretty(unit), factor: 1 };
  const size = Math.abs(largest) || 1;
  const [name, factor] =
    multiples.find(([, f]) => size >= 0.9999 * f) ?? multiples[multiples.length - 1];
  return { unit: name, factor };
}

/// Largest magnitude of the numbers that are finite.
export function largestOf(...arrays) {
  let largest = 0;
  for (const values of arrays)
    for (const v of values) if (Number.isFinite(v)) largest = Math.max(largest, Math.abs(v));
  return largest;
}

/// Five digits, as a power of ten where that is shorter.
export function numberText(value, digits = 5) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  return magnitudeText(value, digits).replace("-", "−");
}

function magnitudeText(value, digits) {
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) return String(Number(value.toPrecision(digits)));
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  const raised = String(Number(exponent)).replace(
    /[-\d]/g,
    (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)],
  );
  return `${Number(mantissa)}·10${raised}`;
}

/// A number with its unit, in the multiple that suits `largest`; shares in per cent to three digits.
export function quantityText(value, unit, largest = value) {
  const shown = shownIn(unit, largest);
  const number = numberText(value / shown.factor, unit === "%" ? 3 : 5);
  return shown.unit ? `${number} ${shown.unit}` : number;
}
