// Mistakes: those of the macros and of Rust's syntax at once, those of the compiler when it has run.

import { computed, effect, signal } from '../lib/dom.js';
import { listen, request } from '../lib/connection.js';
import { functionsOf } from './machine.js';
import { ask, choose, component, edit, machine, model, offsets, onChange, open, opened, openedFile, openedText } from './sources.js';
import { bytesOf } from './offsets.js';

/** The last message of a check: {state, seconds, messages}; null before the first. */
export const check = signal(null);

listen((message) => {
  if (message?.type !== 'check') return;
  check.value = { ...message, messages: message.messages.map((one) => ({ ...one })) };
});

// Places of a check move with the text, as far as the text around them stays.
onChange(({ message }) => {
  if (!check.value || !message.splices) return;
  const moved = check.value.messages.map((one) => (one.file === message.file && one.span ? { ...one, span: message.splices.flat().reduce(shifted, one.span) } : one));
  check.value = { ...check.value, messages: moved };
});

function shifted([start, end], { span: [from, to], text }) {
  const by = bytesOf(text) - (to - from);
  if (to <= start) return [start + by, end + by];
  return from >= end ? [start, end] : [Math.min(start, from), Math.max(Math.min(start, from), end + by)];
}

/** The key of what a byte of the text belongs to, in the shown component; null if it is none. */
export function keyAt(byte) {
  const own = machine.value;
  const within = ({ function: { span } }) => span[0] <= byte && byte <= span[1];
  return own?.states.find(within)?.key ?? own?.arrows.find(within)?.key ?? null;
}

/** The name of the function that has a byte, in any component of the file. */
function placeAt(byte) {
  for (const one of model.value?.components ?? []) {
    const found = functionsOf(one).find(({ span }) => span[0] <= byte && byte <= span[1]);
    if (found) return found.name.text;
  }
  return null;
}

const lineOf = (span) => openedText.value.slice(0, offsets.value.index(span[0])).split('\n').length;

/** All mistakes, those of the open file first: {level, text, help, span, place, line, file, from}. */
export const problems = computed(() => {
  const own = openedFile.value;
  if (!own) return [];
  const now = model.value.problems.map(({ span, message, from }, number) => ({ number, level: 'error', text: message, help: '', span, place: placeAt(span[0]), line: lineOf(span), file: own, from }));
  const said = new Set(now.map(({ text, line }) => `${line} ${text}`));
  const later = (check.value?.messages ?? []).map((one) => {
    const here = one.file === own && one.span;
    return { ...one, place: here ? placeAt(one.span[0]) : null, line: here ? lineOf(one.span) : one.line, from: 'check' };
  });
  const order = (one) => (one.level === 'error' ? 0 : 2) + (one.file === own ? 0 : 1);
  return [...now, ...later.filter(({ text, line }) => !said.has(`${line} ${text}`)).sort((a, b) => order(a) - order(b))];
});

/** Fixes of the text of a version: {version, fixes: [[{label, edit}]]}; null before the first. */
const fixes = signal(null);
/** Time without typing after which fixes are searched, ms. */
const PAUSE = 400;

let timer = 0;
effect(() => {
  const [own, wrong] = [openedFile.value, model.value?.problems.length > 0];
  clearTimeout(timer);
  if (own && wrong) timer = setTimeout(async () => { fixes.value = (await request('source', { request: { type: 'fixes', file: own } }).catch(() => null)); }, PAUSE);
});

/** The fixes of a mistake of the text that is shown. */
export function fixesOf({ number }) {
  return number !== undefined && fixes.value?.version === opened.value?.version ? fixes.value.fixes[number] ?? [] : [];
}

export const mend = ({ edit: one }) => edit([one]);

/** Number of mistakes by key of the canvas. */
export const marked = computed(() => {
  const found = new Map();
  for (const { level, span, file } of problems.value) {
    if (!span || file !== openedFile.value) continue;
    const key = keyAt(span[0]);
    if (key && found.get(key) !== 'error') found.set(key, level);
  }
  return found;
});

/** A place that the code panel is to show: {byte, at}; a new object for each wish. */
export const wanted = signal(null);

/** Shows the place of a mistake or of a use, in canvas and code. */
export async function jump({ file, span }) {
  if (!file || !span) return;
  if (file !== opened.value?.file) {
    await open(file, null);
    setTimeout(() => { wanted.value = { byte: span[0] }; }, 300);
    return;
  }
  const of = opened.value.model.components.find((one) => one.span[0] <= span[0] && span[0] <= one.span[1]);
  if (of && of.key !== component.value) component.value = of.key;
  const key = keyAt(span[0]);
  if (key) choose([key]);
  wanted.value = { byte: span[0] };
}

export const startCheck = () => ask('check');
