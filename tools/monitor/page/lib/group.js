// Robots of a group in one view: what names a session, which sessions are of one group, and all of a tree side by side.

import { effect, untracked, useEffect, useRef } from './dom.js';
import { resolved } from './curves.js';
import { text, valueAt } from './format.js';
import { putBeside, session, sessions, watch } from './store.js';
import { curveColour } from './theme.js';

/** Names of outputs in a label such as `{Game.team}-{Game.player}`. */
const PARTS = /\{([^{}]+)\}/g;

/** The shown value of an output of a session as text; empty without one. */
export function shownText(of, name) {
  const place = resolved(of, name)?.place;
  const value = place && valueAt(of.output(...place).now.value?.value, resolved(of, name).path);
  return value === null || value === undefined ? '' : text(value);
}

const partsOf = (label) => [...label.matchAll(PARTS)].map(([, name]) => name);

/** A label with its values; empty for a session without all of them. */
export const labelOf = (of, label) => (partsOf(label).every((name) => shownText(of, name)) ? label.replace(PARTS, (_, name) => shownText(of, name)) : '');

/** The outputs of labels, as a page watches them. */
export const placesOf = (of, labels) => labels.flatMap(partsOf).flatMap((name) => resolved(of, name)?.inputs ?? []).map(({ place }) => [...place, 10]);

const CURVES = [0, 6, 2, 5];

/** A colour for each value of an output, which names the group of a session: Map from value to colour. */
export function groupsOf(all, name) {
  const values = [...new Set(all.map((of) => shownText(of, name)))].sort((one, other) => one.localeCompare(other, 'en', { numeric: true }));
  return new Map(values.map((value, index) => [value, curveColour(CURVES[index % CURVES.length])]));
}

/** Watches the outputs of labels, and the one that names the group, of all sessions. */
export function useLabels(all, [...labels], group, visible) {
  const named = group ? [...labels, `{${group}}`] : labels;
  useEffect(() => {
    if (!visible.value || named.length === 0) return undefined;
    const ends = all.map((of) => watch({ info: placesOf(of, named) }, of));
    return () => ends.forEach((end) => end());
  }, [visible.value, all.map(({ id }) => id).join(), named.join()]);
}

/** Shows all sessions with the tree of the chosen one beside it, also those that come later. One that somebody puts away stays away. */
export function useAllBeside(on) {
  const known = useRef(new Set());
  useEffect(() => (on ? effect(() => {
    const chosen = session.value;
    const isReady = (of) => of.info.value.kind === 'recording' || of.live.value !== null;
    const name = chosen?.description.value?.name;
    for (const of of sessions.value.values()) {
      if (of === chosen || known.current.has(of.id) || !name || of.description.value?.name !== name || !isReady(of) || !isReady(chosen)) continue;
      known.current.add(of.id);
      untracked(() => putBeside(of.id, true));
    }
  }) : undefined), [on]);
}
