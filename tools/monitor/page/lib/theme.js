// Dark and light; colours of the style sheet for what is drawn on a canvas.

import { signal } from './dom.js';
import { stored } from './stored.js';

const memory = stored('localStorage', 'jmanager-theme');
const cache = new Map();

/** `dark` or `light`. */
export const theme = signal(memory.read() ?? (matchMedia('(prefers-color-scheme: light)').matches ? 'light' : 'dark'));

export function applyTheme(name) {
  document.documentElement.dataset.theme = name;
  cache.clear();
  theme.value = name;
  memory.write(name);
}

export const toggleTheme = () => applyTheme(theme.value === 'dark' ? 'light' : 'dark');

/** A colour of the style sheet, as `css('--line')`. */
export function css(name) {
  let value = cache.get(name);
  if (!value) cache.set(name, (value = getComputedStyle(document.documentElement).getPropertyValue(name).trim()));
  return value;
}

const KINDS = { machine: '--machine', controller: '--control', perception: '--perceive', actuation: '--act' };

/** Colour of a component's kind. */
export const kindColour = (kind) => css(KINDS[kind] ?? '--dim');

/** Distinct colours of curves. */
export const curveColour = (index) => css(`--curve${index % 8}`);

/** Colour of a session that is shown beside the chosen one. */
export const besideColour = (place) => css(`--curve${[5, 4, 7, 3][place % 4]}`);

applyTheme(theme.value);
