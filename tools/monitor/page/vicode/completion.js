// Completion: methods of children, states, components.

import { session } from '../lib/store.js';
import { functionsOf } from './machine.js';
import { list, machine, opened } from './sources.js';

const base = (type) => type.replace(/<.*$/, '').split('::').at(-1);

/** Outputs and modulations of a component: of the robot's description, and of the open file. */
function methodsOf(child) {
  const name = base(child);
  const described = session.value?.description.value?.components.find((one) => one.name === name);
  const found = new Map();
  for (const { name: label, type, doc } of described?.info ?? []) found.set(label, { label, detail: type, info: doc || undefined, type: 'property', apply: `${label}()` });
  for (const { name: label, doc, arguments: args } of described?.modulations ?? []) {
    found.set(label, { label, detail: `(${(args ?? []).map((one) => one.name).join(', ')})`, info: doc || undefined, type: 'method', apply: `${label}(` });
  }
  const here = opened.value?.model.components.find((one) => base(one.name.text) === name);
  for (const [which, end] of [['info', '()'], ['modulations', '(']]) {
    for (const { function: own } of here?.[which] ?? []) {
      if (!found.has(own.name.text)) found.set(own.name.text, { label: own.name.text, detail: which === 'info' ? 'output' : 'modulation', info: own.docs.text || undefined, type: 'method', apply: own.name.text + end });
    }
  }
  return [...found.values()];
}

/** The arguments that the text before the cursor declares last: the function that is being written. */
function argumentsBefore(text) {
  const at = text.lastIndexOf('fn ');
  const found = new Map();
  if (at < 0) return found;
  for (const [, name, type] of text.slice(at).split('{')[0].matchAll(/(\p{XID_Continue}+)\s*:\s*&(?:mut\s+)?([\p{XID_Continue}:<>, ]+?)(?=[,)])/gu)) found.set(name, type.replace(/^Rate<(.*)>$/, '$1'));
  return found;
}

/** Letters of a name of Rust. */
const WORD = /^\p{XID_Continue}*$/u;

export function complete(context) {
  const before = context.state.sliceDoc(Math.max(0, context.pos - 4000), context.pos);
  const own = machine.value;
  const dot = /(\p{XID_Continue}+)\.(\p{XID_Continue}*)$/u.exec(before);
  if (dot) {
    const from = context.pos - dot[2].length;
    if (dot[1] === 'self') return { from, options: functionsOf(own?.component ?? { states: [], transitions: [], hooks: [], info: [], modulations: [], work: [], others: [], step: null }).map((one) => ({ label: one.name.text, type: 'method', info: one.docs.text || undefined })), validFor: WORD };
    const child = argumentsBefore(before).get(dot[1]);
    return child ? { from, options: methodsOf(child), validFor: WORD } : null;
  }
  const attribute = /#\[(transition|entry|exit|before)\(([^\])]*)$/.exec(before);
  const word = context.matchBefore(/\p{XID_Continue}*/u);
  if (attribute && own) {
    const options = own.states.map(({ name, docs }) => ({ label: name, type: 'enum', info: docs || undefined }));
    if (attribute[1] === 'transition') for (const label of ['after_ms', 'after', 'when', 'times']) options.push({ label, type: 'keyword', apply: `${label} = ` });
    return { from: word.from, options, validFor: WORD };
  }
  if (/&(mut\s+)?\p{XID_Continue}*$/u.test(before) || (context.explicit && word.text)) {
    const names = [...new Set((list.value ?? []).flatMap((file) => file.components.map((one) => one.name)))];
    return { from: word.from, options: names.map((label) => ({ label, type: 'class', detail: 'component' })), validFor: WORD };
  }
  return null;
}
