// Names of robots by their outputs, as extensions declare them: of the robots of a match the addresses say little.

import { EXTENSIONS } from '../extensions.js';
import { effect } from './dom.js';
import { labelOf, placesOf } from './group.js';
import { sessions, watch } from './store.js';

const LABELS = EXTENSIONS.flatMap(({ label }) => label ?? []);
/** How to end the watches of sessions whose names are not known yet. */
const ends = new Map();

effect(() => new Set([...ends.keys(), ...sessions.value.values()]).forEach((of) => {
  const isNameless = sessions.value.has(of.id) && of.info.peek().kind === 'robot' && of.description.value && !of.label.value;
  const places = isNameless ? placesOf(of, LABELS) : [];
  if (places.length > 0) of.label.value = LABELS.map((label) => labelOf(of, label)).find(Boolean) ?? '';
  ends.get(of)?.();
  ends.delete(of);
  if (places.length > 0 && !of.label.value) ends.set(of, watch({ info: places }, of));
}));
