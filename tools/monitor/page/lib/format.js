// Numbers, times and values as text.

/** A number with about four significant digits. */
export function number(value) {
  if (value === null || value === undefined) return '–';
  if (typeof value !== 'number') return String(value);
  if (Number.isInteger(value)) return String(value);
  const size = Math.abs(value);
  if (size >= 1000) return value.toFixed(0);
  if (size >= 100) return value.toFixed(1);
  if (size >= 10) return value.toFixed(2);
  return value.toFixed(3);
}

/** A time of the robot, as 1:02.345. */
export function time(us, digits = 2) {
  if (us === null || us === undefined) return '–';
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

/** A value of information as short text. */
export function text(value) {
  if (value === null || value === undefined) return '–';
  if (typeof value === 'number') return number(value);
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
  if (typeof value === 'number') found.push([path, value]);
  else if (typeof value === 'boolean') found.push([path, value ? 1 : 0]);
  else if (Array.isArray(value)) value.forEach((inner, index) => numbers(inner, `${path}[${index}]`, found));
  else if (value && typeof value === 'object') {
    for (const [name, inner] of Object.entries(value)) numbers(inner, `${path}.${name}`, found);
  }
  return found;
}

/** The value at a path of `numbers`. */
export const valueAt = (value, path) => (path.match(/[^.[\]]+/g) ?? []).reduce((inner, part) => inner?.[part], value);

/** The number at a path of `numbers`; null if there is none. */
export function numberAt(value, path) {
  const inner = valueAt(value, path);
  if (typeof inner === 'boolean') return inner ? 1 : 0;
  return typeof inner === 'number' ? inner : null;
}

/** A name of code in words: `near_speed` becomes `near speed`. */
export const words = (name) => name.replaceAll('_', ' ');
