import viridis from "./viridis.json";

// Viridis [van der Walt, Smith]: even in lightness, readable for the
// colour-blind and in grey.
const ANCHORS = viridis.map((hex) =>
  [0, 2, 4].map((i) => parseInt(hex.slice(i, i + 2), 16)));

/** Colour of 0 … 1 as three bytes. */
export function colour(share) {
  const at = Math.min(1, Math.max(0, share)) * (ANCHORS.length - 1);
  const low = Math.min(Math.floor(at), ANCHORS.length - 2);
  return ANCHORS[low].map((value, c) =>
    Math.round(value + (at - low) * (ANCHORS[low + 1][c] - value)));
}

/** Bytes of a texture of `size` colours. */
export function colourBytes(size) {
  const bytes = new Uint8Array(4 * size);
  for (let i = 0; i < size; ++i) {
    bytes.set([...colour(i / (size - 1)), 255], 4 * i);
  }
  return bytes;
}

/** Series of charts: Okabe and Ito's colours, dark enough for lines. */
export const SERIES = ["#0072b2", "#b34700", "#00664d", "#8a4a78", "#5c5c5c",
  "#7a6500", "#1f6f9f", "#000000"];
export const DASHES = [[], [8, 3], [2, 3], [10, 3, 2, 3], [5, 5], [1, 2]];
