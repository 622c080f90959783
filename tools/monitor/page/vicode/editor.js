// CodeMirror in the page's colours, with Rust.

import * as cm from '../vendor/codemirror.js';
import { complete } from './completion.js';
import { redo, undo } from './sources.js';

// The page's policy forbids style elements; sheets made by scripts of the page are allowed.
const sheet = new CSSStyleSheet();
let modules = [];
cm.StyleModule.mount = (_root, added) => {
  const all = [added].flat();
  if (all.every((one) => modules.includes(one))) return;
  modules = [...modules.filter((one) => !all.includes(one)), ...all];
  sheet.replaceSync(modules.map((one) => one.getRules()).join('\n'));
  if (!document.adoptedStyleSheets.includes(sheet)) document.adoptedStyleSheets.push(sheet);
};

const { tags } = cm;
const COLOURS = cm.HighlightStyle.define([
  { tag: [tags.keyword, tags.controlKeyword, tags.definitionKeyword, tags.modifier, tags.operatorKeyword, tags.self], color: 'var(--code-keyword)' },
  { tag: [tags.typeName, tags.className, tags.namespace], color: 'var(--code-type)' },
  { tag: [tags.function(tags.variableName), tags.function(tags.propertyName), tags.macroName], color: 'var(--code-function)' },
  { tag: [tags.string, tags.character, tags.escape], color: 'var(--code-string)' },
  { tag: [tags.number, tags.bool, tags.literal, tags.integer, tags.float], color: 'var(--code-number)' },
  { tag: [tags.comment, tags.lineComment, tags.blockComment, tags.docComment], color: 'var(--dim)' },
  { tag: [tags.meta, tags.attributeName, tags.labelName], color: 'var(--machine)' },
]);

/** The mark of a line with a mistake. */
const CROSS = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 40"><path stroke="#f43" stroke-width="8" stroke-linecap="round" d="M8 8L32 32M32 8L8 32"/></svg>';

const LOOKS = cm.EditorView.theme({
  '&': { height: '100%', fontSize: '12.5px', backgroundColor: 'transparent', color: 'var(--text)' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: 'ui-monospace, "DejaVu Sans Mono", monospace', lineHeight: '1.5' },
  '.cm-content': { caretColor: 'var(--text)', padding: '6px 0' },
  '.cm-gutters': { backgroundColor: 'transparent', color: 'var(--dim)', border: 'none' },
  '.cm-activeLine': { backgroundColor: 'var(--hover)' },
  '.cm-activeLineGutter': { backgroundColor: 'transparent', color: 'var(--text)' },
  '.cm-cursor, .cm-dropCursor': { borderLeftColor: 'var(--text)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': { backgroundColor: 'var(--selection)' },
  '.cm-selectionMatch': { backgroundColor: 'color-mix(in srgb, var(--machine) 22%, transparent)' },
  '.cm-chosen': { backgroundColor: 'color-mix(in srgb, var(--control) 15%, transparent)' },
  '.cm-matchingBracket, &.cm-focused .cm-matchingBracket': { backgroundColor: 'color-mix(in srgb, var(--control) 30%, transparent)' },
  '.cm-tooltip': { backgroundColor: 'var(--panel)', border: '1px solid var(--line)', borderRadius: '6px', color: 'var(--text)', boxShadow: '0 6px 20px #0006' },
  '.cm-tooltip-autocomplete > ul > li[aria-selected]': { backgroundColor: 'color-mix(in srgb, var(--control) 30%, var(--raised))', color: 'var(--text)' },
  '.cm-panels': { backgroundColor: 'var(--raised)', color: 'var(--text)', borderColor: 'var(--line)' },
  '.cm-panels input, .cm-panels button': { fontSize: '12px' },
  '.cm-button': { backgroundImage: 'none', backgroundColor: 'var(--raised)', border: '1px solid var(--line)', borderRadius: '5px' },
  '.cm-textfield': { backgroundColor: 'var(--field)', border: '1px solid var(--line)', borderRadius: '5px' },
  '.cm-diagnostic-error': { borderLeftColor: 'var(--error)' },
  // Not the dot of a breakpoint.
  '.cm-lint-marker-error': { content: `url('data:image/svg+xml,${encodeURIComponent(CROSS)}')` },
  '.cm-hidden-part': { color: 'var(--dim)', padding: '2px 12px', fontFamily: 'var(--font)', fontSize: '11.5px' },
});

/** Parts of the text that are not shown, and the lines of what is chosen: {only: [from, to] or null, chosen: [from, to] or null}. */
export const setShown = cm.StateEffect.define();

class Hidden extends cm.WidgetType {
  constructor(lines) {
    super();
    this.lines = lines;
  }

  eq(other) { return other.lines === this.lines; }

  toDOM() {
    const element = document.createElement('div');
    element.className = 'cm-hidden-part';
    element.textContent = `${this.lines} ${this.lines === 1 ? 'line is' : 'lines are'} not shown`;
    return element;
  }
}

function decorations(state, { only, chosen }) {
  const { doc } = state;
  const found = [];
  if (chosen) {
    for (let line = doc.lineAt(chosen[0]); ; line = doc.line(line.number + 1)) {
      found.push(cm.Decoration.line({ class: 'cm-chosen' }).range(line.from));
      if (line.to >= chosen[1] || line.number === doc.lines) break;
    }
  }
  if (only) {
    const [first, last] = [doc.lineAt(only[0]), doc.lineAt(only[1])];
    const hide = (from, to, lines) => found.push(cm.Decoration.replace({ block: true, widget: new Hidden(lines) }).range(from, to));
    if (first.number > 1) hide(0, first.from - 1, first.number - 1);
    if (last.number < doc.lines) hide(last.to + 1, doc.length, doc.lines - last.number);
  }
  return cm.Decoration.set(found, true);
}

const shownField = cm.StateField.define({
  create: () => ({ only: null, chosen: null, all: cm.Decoration.none }),
  update(value, transaction) {
    const effect = transaction.effects.find((one) => one.is(setShown));
    if (!effect && !transaction.docChanged) return value;
    const kept = (range) => range && [transaction.changes.mapPos(range[0], -1), transaction.changes.mapPos(range[1], 1)];
    const next = effect ? effect.value : { only: kept(value.only), chosen: kept(value.chosen) };
    return { ...next, all: decorations(transaction.state, next) };
  },
  provide: (field) => [
    cm.EditorView.decorations.from(field, ({ all }) => all),
    cm.EditorView.atomicRanges.of((view) => (view.state.field(field).only ? view.state.field(field).all : cm.Decoration.none)),
  ],
});

const save = (run) => () => {
  run();
  return true;
};

/** Makes the editor: `onUpdate` gets CodeMirror's updates, `leave` is what Escape does. */
export function makeEditor(parent, { text, label, onUpdate, leave }) {
  return new cm.EditorView({
    parent,
    state: cm.EditorState.create({
      doc: text,
      extensions: [
        cm.Prec.highest(cm.keymap.of([{ key: 'Mod-z', run: save(undo) }, { key: 'Mod-y', run: save(redo) }, { key: 'Mod-Shift-z', run: save(redo) }])),
        cm.lineNumbers(), cm.lintGutter(), cm.highlightActiveLine(), cm.highlightActiveLineGutter(), cm.highlightSpecialChars(), cm.drawSelection(), cm.dropCursor(),
        cm.indentUnit.of('    '), cm.indentOnInput(), cm.bracketMatching(), cm.closeBrackets(), cm.rust(), cm.syntaxHighlighting(COLOURS), cm.highlightSelectionMatches(),
        cm.search({ top: true }), cm.autocompletion({ override: [complete], icons: false }), shownField, LOOKS,
        cm.keymap.of([...cm.closeBracketsKeymap, ...cm.searchKeymap, ...cm.completionKeymap, ...cm.lintKeymap, ...cm.defaultKeymap, cm.indentWithTab, { key: 'Escape', run: save(leave) }]),
        cm.EditorView.contentAttributes.of({ 'aria-label': label, spellcheck: 'false' }),
        cm.EditorView.updateListener.of(onUpdate),
      ],
    }),
  });
}
