// Numbers as the reader's locale writes them.
const formats = new Map();

/** `value` with so many significant digits; "–" if there is none. */
export function number(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) {
    return "–";
  }
  if (!formats.has(digits)) {
    formats.set(digits, new Intl.NumberFormat(undefined,
      { maximumSignificantDigits: digits, useGrouping: false }));
  }
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) {
    const power = Math.floor(Math.log10(size));
    return `${number(value / 10 ** power, digits)}·10^${power}`;
  }
  return formats.get(digits).format(value);
}

export const withUnit = (value, unit, digits) =>
  Number.isFinite(value) ? `${number(value, digits)} ${unit}` : "–";

export const vector = (values, digits = 4) =>
  Array.from(values ?? [], (value) => number(value, digits)).join("; ");

export const band = (limits, digits = 4) =>
  limits ? `${number(limits[0], digits)} … ${number(limits[1], digits)}` : "–";
