// Marks on the drawing that come from a trial or from the coverage: classes and the texts beside names.

import { ALL } from './canvas/rows.js';
import { stage } from './canvas/stage.js';
import { machine } from './sources.js';

const FLAGS = ['lit', 'resting', 'leaves', 'holds', 'fails', 'visited', 'unvisited'];
const still = ({ initial, last }) => (initial ? 'initial' : last ? 'last' : '');

/** Number of visits and their time, as far as there is room. */
export const countText = ({ visits, us }) => (stage.look.value.level > ALL && stage.view.isAutomatic ? `${visits}×` : `${visits}× ${(us / 1e6).toFixed(1)} s`);

function put(element, flags, text) {
  if (!element) return;
  for (const flag of FLAGS) element.classList.toggle(flag, flags.includes(flag));
  const live = element.querySelector('text.live');
  if (live && live.textContent !== text) live.textContent = text;
}

/**
 * Marks states and arrows. `ofState` and `ofArrow` return {flags, text}; `ofArrow` also `count`, which is added for a bundle. Without
 * them all marks are removed.
 */
export function paint(ofState = (state) => ({ flags: [], text: still(state) }), ofArrow = () => ({ flags: [], text: '', count: 0 })) {
  const own = machine.value;
  if (!own) return;
  for (const state of own.states) {
    const { flags, text } = ofState(state);
    put(stage.elements.get(state.key), flags, text || still(state));
  }
  const names = new Map();
  for (const arrow of own.arrows) {
    const one = ofArrow(arrow);
    put(stage.elements.get(arrow.key), one.flags, '');
    // A bundle has one name.
    const owner = stage.courses.get(arrow.key)?.owner ?? arrow.key;
    const known = names.get(owner) ?? { flags: [], text: '', count: 0 };
    names.set(owner, { flags: [...known.flags, ...one.flags], text: one.text || known.text, count: known.count + one.count });
  }
  for (const [owner, { flags, text, count }] of names) {
    const shown = flags.includes('visited') ? flags.filter((flag) => flag !== 'unvisited') : flags;
    put(stage.labels.get(owner), shown, [count > 0 ? `${count}×` : '', text].filter(Boolean).join(' · '));
  }
}
