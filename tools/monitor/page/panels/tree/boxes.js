// The boxes of the tree: their widths, and what stands in them now.

import { duration, number } from '../../lib/format.js';
import { write } from '../../lib/ui.js';

/** Heights of a box with one line and with two, px. */
export const [LOW, TALL] = [26, 44];
/** Shares of the budget from which the cost is drawn as a warning, and as an error. */
const [NEAR, OVER] = [0.8, 1];
const PADDING = 14;
/** Mark of a component that several others write in one cycle. */
export const SEVERAL = ' ⇶';
/** Usual width of a letter of a rate, px. */
const LETTER = 6.5;

const context = document.createElement('canvas').getContext('2d');

/** The width of each box: its name and the longest state fit, so that places do not change with states. */
export function widthsOf(components) {
  const font = getComputedStyle(document.documentElement).fontFamily;
  return components.map(({ name, states, writers }) => {
    context.font = `600 11.5px ${font}`;
    const own = context.measureText(name + (writers ? SEVERAL : '')).width;
    context.font = `11.5px ${font}`;
    const longest = Math.max(0, ...states.map((state) => context.measureText(state.name).width + 6));
    return Math.ceil(own + longest + PADDING);
  });
}

/** Who writes a component in one cycle, if several do, and whose values count. */
export function writtenBy({ components }, { writers }) {
  const name = ({ by }) => components[by]?.name;
  return writers && `written by ${writers.map(name).join(', then ')}; in force: ${name(writers.find((one) => one.in_force) ?? {})}`;
}

/** Writes the state of a component to its box. */
export function drawBox(element, box, { component, now, cost, window, gone, folded, found, other }) {
  const active = now?.[0] ?? false;
  const held = now && now[1] !== 'tree' ? now[1] : '';
  const { classList } = element;
  for (const [name, on] of Object.entries({ active, gone, found, other, folded, holding: held !== '' })) classList.toggle(name, on);
  const [, , title, sub, bar, badge] = element.children;
  const runs = cost && window ? (cost[0] / window) * 1e6 : null;
  const state = now?.[2] === null || now?.[2] === undefined ? null : component.states[now[2]]?.name;
  write(title.lastElementChild, state ?? '');
  title.lastElementChild.setAttribute('dx', state ? '6' : '0');
  const rate = box.height >= TALL ? rateText(component, now, runs, active) : '';
  // A narrow box has the reached rate only.
  write(sub, rate.length * LETTER > box.width ? rate.replace(/ of .*/, ' Hz') : rate);
  const share = component.budget_us && cost?.[0] ? cost[1] / component.budget_us : 0;
  bar.setAttribute('width', String(Math.min(share, 1) * (box.width - 12)));
  bar.setAttribute('class', `cost ${share > OVER ? 'over' : share > NEAR ? 'nearly' : ''}`);
  const mark = held || (folded ? '…' : '');
  badge.setAttribute('visibility', mark ? 'visible' : 'hidden');
  write(badge.lastElementChild, mark);
  const text = [active ? 'active' : 'latent', state && `state ${state}`, held && `held ${held}`, runs !== null && active && `${runs.toFixed(0)} Hz`,
    cost?.[0] && `${duration(cost[1])}${component.budget_us ? ` of ${number(component.budget_us)} µs` : ''}`].filter(Boolean).join(', ');
  if (element.getAttribute('aria-description') !== text) element.setAttribute('aria-description', text);
}

function rateText(component, now, runs, active) {
  const wanted = now?.[3] ?? component.hz;
  if (!active) return wanted ? `${number(wanted)} Hz` : '';
  const reached = runs !== null && runs > 0 ? runs.toFixed(0) : null;
  if (!wanted) return reached ? `${reached} Hz` : 'each cycle';
  return reached ? `${reached} of ${number(wanted)} Hz` : `${number(wanted)} Hz`;
}
