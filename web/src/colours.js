/// Colours of numbers: two sequential scales, and one about zero for numbers of both signs.

const SEQUENTIAL = [
  "#440154",
  "#482878",
  "#3e4989",
  "#31688e",
  "#26828e",
  "#1f9e89",
  "#35b779",
  "#6ece58",
  "#b5de2b",
  "#fde725",
];
const WARM = [
  "#0d0887",
  "#46039f",
  "#7201a8",
  "#9c179e",
  "#bd3786",
  "#d8576b",
  "#ed7953",
  "#fb9f3a",
  "#fdca26",
  "#f0f921",
];
const DIVERGING = [
  "#1f4e9c",
  "#4f86c6",
  "#9cc3e4",
  "#e3edf5",
  "#f4f2ef",
  "#f7e0d4",
  "#eda98a",
  "#d4604a",
  "#a51f2d",
];

const channels = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

function table(stops, size = 256) {
  const colours = stops.map(channels);
  return Array.from({ length: size }, (_, n) => {
    const place = (n / (size - 1)) * (colours.length - 1);
    const a = Math.min(Math.floor(place), colours.length - 2);
    return colours[a].map((c, k) => c + (place - a) * (colours[a + 1][k] - c));
  });
}

const tables = { sequential: table(SEQUENTIAL), warm: table(WARM), diverging: table(DIVERGING) };

/// The scale of a field: its limits are the field's, made even about zero where it changes sign
/// (diverging); else "sequential" or "warm".
export function colourScale({ low, high }, kind = "sequential") {
  const signs = low < 0 && high > 0 && Math.min(-low, high) > 0.15 * Math.max(-low, high);
  const limit = Math.max(-low, high);
  const [from, to] = signs ? [-limit, limit] : [low, high];
  const colours = tables[signs ? "diverging" : kind];
  const width = to - from || 1;
  /// [red, green, blue] from 0 to 255.
  const colour = (value) => {
    const n = Math.round(((value - from) / width) * 255);
    return colours[Math.min(255, Math.max(0, n))];
  };
  return { from, to, colour };
}

/// A CSS gradient from the low to the high end.
export function gradient(scale) {
  const stops = Array.from({ length: 17 }, (_, n) => {
    const [r, g, b] = scale.colour(scale.from + (n / 16) * (scale.to - scale.from)).map(Math.round);
    return `rgb(${r},${g},${b})`;
  });
  return `linear-gradient(to right, ${stops.join(",")})`;
}
