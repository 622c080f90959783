// Numbers, times and values as text.

/** A number to read, with four significant digits; whole numbers have all of theirs. `exact` is the text to edit. */
export function number(value) {
  if (value === null || value === undefined) return '–';
  if (typeof value !== 'number' || Number.isSafeInteger(value)) return String(value);
  const digits = Math.abs(value) < 1e15 ? Math.max(4, String(Math.trunc(Math.abs(value))).length) : 4;
  const rounded = Number(value.toPrecision(digits));
  return exact(Number.isFinite(rounded) ? rounded : value);
}

/** The shortest text that reads back as the same number. */
export const exact = (value) => String(value).replace('e+', 'e');

/** The number of a text that somebody typed; NaN without one. A whole number that a `number` cannot hold is a BigInt. */
export function typedNumber(text) {
  const plain = text.trim().replace('−', '-').replace(/^([^,.]*),([^,.]*)$/, '$1.$2');
  const value = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
  return /^-?\d+$/.test(plain) && !Number.isSafeInteger(value) ? BigInt(plain) : value;
}

/** Texts of the marks of an axis: with the digits by which they differ. */
export function ticks(values) {
  const step = Math.abs(values[1] - values[0]);
  if (!(step > 0)) return values.map(number);
  const unit = Math.floor(Math.log10(step)) - 1;
  return values.map((value) => {
    const digits = Math.floor(Math.log10(Math.abs(value))) - unit + 1;
    const rounded = digits < 1 ? 0 : Number(value.toPrecision(Math.min(digits, 17)));
    return exact(Math.abs(rounded) < 1e6 ? rounded : rounded.toExponential());
  });
}

/** A step of a slider: about a two-hundredth of its range, with one digit. */
export const niceStep = (span) => 10 ** Math.floor(Math.log10(span / 100));

/** Times from here on, µs, are of a clock that counts from 1970: the local time of the day is shown. */
const UNIX = 1e15;

/** A time of the robot, as 1:02.345. */
export function time(us, digits = 2) {
  if (us === null || us === undefined) return '–';
  if (us >= UNIX) {
    const parts = new Date(us / 1000).toTimeString().split(':');
    return `${parts[0]}:${parts[1]}:${((us / 1e6) % 60).toFixed(digits).padStart(digits > 0 ? digits + 3 : 2, '0')}`;
  }
  const seconds = Number((us / 1e6).toFixed(digits));
  const minutes = Math.floor(seconds / 60);
  if (minutes === 0) return `${seconds.toFixed(digits)} s`;
  const rest = (seconds - minutes * 60).toFixed(digits).padStart(digits > 0 ? digits + 3 : 2, '0');
  return minutes < 60
    ? `${minutes}:${rest}`
    : `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, '0')}:${rest}`;
}

/** A duration, with a unit that suits it. */
export function duration(us) {
  if (us === 0) return '0 s';
  if (us < 1000) return `${number(us)} µs`;
  if (us < 1e6) return `${number(us / 1000)} ms`;
  if (us < 60e6) return `${(us / 1e6).toFixed(1)} s`;
  return `${Math.floor(us / 60e6)} min ${Math.floor((us % 60e6) / 1e6)} s`;
}

export function bytes(count) {
  if (count < 1000) return `${count} B`;
  if (count < 1e6) return `${(count / 1e3).toFixed(0)} kB`;
  if (count < 1e9) return `${(count / 1e6).toFixed(1)} MB`;
  return `${(count / 1e9).toFixed(2)} GB`;
}

/** A value of an output as short text. */
export function text(value) {
  if (value === null || value === undefined) return '–';
  if (typeof value === 'number' || typeof value === 'bigint') return number(value);
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value === 'string') return value;
  if (Array.isArray(value)) {
    if (value.length > 6) return `${value.slice(0, 6).map(text).join(', ')} … (${value.length})`;
    return value.map(text).join(', ') || 'none';
  }
  return Object.entries(value).map(([name, inner]) => `${name} ${text(inner)}`).join(', ');
}

/** The numbers in a value: a list of [path, number]. */
export function numbers(value, path = '', found = []) {
  if (typeof value === 'number' || typeof value === 'bigint') found.push([path, value]);
  else if (typeof value === 'boolean') found.push([path, value ? 1 : 0]);
  else if (Array.isArray(value)) value.forEach((inner, index) => numbers(inner, `${path}[${index}]`, found));
  else if (value && typeof value === 'object') {
    for (const [name, inner] of Object.entries(value)) numbers(inner, `${path}.${name}`, found);
  }
  return found;
}

/** The value at a path of `numbers`. */
export const valueAt = (value, path) => (path.match(/[^.[\]]+/g) ?? []).reduce((inner, part) => inner?.[part], value);

/** The number at a path of `numbers`; a BigInt if a `number` cannot hold it, null if there is none. */
export function numberAt(value, path) {
  const inner = valueAt(value, path);
  if (typeof inner === 'boolean') return inner ? 1 : 0;
  return typeof inner === 'number' || typeof inner === 'bigint' ? inner : null;
}

/** A text that its remedy can follow: with a sign at its end. */
export const sentence = (text) => (/[.!?…]”?$/.test(text) ? text : `${text}.`);

/** A name of code in words: `near_speed` becomes `near speed`. */
export const words = (name) => name.replaceAll('_', ' ');
