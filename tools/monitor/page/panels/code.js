// The code of the open file, or only of what is selected in the designer. Both are the same text.

import { effect, html, signal, useEffect, useRef, useSignal } from '../lib/dom.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';
import { EditorSelection, EditorView, setDiagnostics } from '../vendor/codemirror.js';
import { makeEditor, setShown } from '../vicode/editor.js';
import { setFocusCode } from '../vicode/focus.js';
import { Lines, plain } from '../vicode/lines.js';
import { keyAt, problems, wanted } from '../vicode/problems.js';
import { choose, chosen, offsets, onChange, opened, openedFile, openedText, selection, setCode } from '../vicode/sources.js';
import { Typing, remote } from '../vicode/typing.js';

/** Whether only what is selected is shown. */
const onlyChosen = signal(false);

/** The editor that exists; there is one code panel. */
let editor = null;
onChange((change) => editor?.typing.received(change));
setCode({ settle: async () => editor?.typing.settled(), hold: () => editor?.typing.hold() ?? (() => {}) });

/** Offsets of the editor of a part of the file. */
function placeOf(span) {
  const lines = new Lines(openedText.value);
  return span.map((byte) => Math.min(editor.typing.place(lines.toEditor(offsets.value.index(byte))), editor.view.state.doc.length));
}

export function Code({ retitle }) {
  const file = openedFile.value;
  const at = useSignal('');
  useEffect(() => { if (file) retitle(file.split('/').at(-1)); }, [file]);
  if (!file) return html`<${Empty} what="No file is open" help="Choose a component in Sources, or “edit states” in the tab of a component." />`;
  return html`<${Bar} label="Code">
      <${Toggle} on=${!onlyChosen.value} label="Whole file" title="All of the file" onChange=${() => { onlyChosen.value = false; }} />
      <${Toggle} on=${onlyChosen.value} label="Selected only" title="Only the state or transition that is selected in the designer" onChange=${() => { onlyChosen.value = true; }} />
      <span class="grow"></span><span class="dim wide">${chosen.value?.name ?? ''}</span><span class="dim n" role="status" aria-label="Place in the code">${at.value}</span>
    <//><${Editor} key=${file} at=${at} />`;
}

function Editor({ at }) {
  const place = useRef(null);
  useEffect(() => {
    const onUpdate = (update) => {
      if (!editor) return;
      const isRemote = update.transactions.some((one) => one.annotation(remote));
      if (update.docChanged && !isRemote) editor.typing.local(update.changes);
      const { head } = update.state.selection.main;
      const line = update.state.doc.lineAt(head);
      at.value = `${line.number}:${head - line.from + 1}`;
      if (update.selectionSet && !update.docChanged && !isRemote && update.view.hasFocus) follow(head);
    };
    const leave = () => document.querySelector('.machine-canvas svg.machine')?.focus();
    const view = makeEditor(place.current, { text: plain(opened.value.text), label: `Code of ${opened.value.file}`, onUpdate, leave });
    editor = { view, typing: new Typing(view) };
    editor.typing.base = opened.value.text;
    setFocusCode(() => {
      const body = chosen.value?.function.body;
      if (body) view.dispatch({ selection: EditorSelection.cursor(placeOf(body)[0]), scrollIntoView: true });
      view.focus();
    });
    const ends = [effect(showChosen), effect(showProblems), effect(showWanted)];
    return () => {
      ends.forEach((end) => end());
      setFocusCode(null);
      // A closed editor gets changes until what was typed in it is sent.
      const closed = editor;
      closed.typing.emptied().then(() => {
        view.destroy();
        if (editor === closed) editor = null;
      });
    };
  }, []);
  return html`<div class="code fill" ref=${place}></div>`;
}

/** The canvas shows what the cursor is in. */
function follow(head) {
  if (editor.typing.isBehind) return;
  const key = keyAt(offsets.value.byte(new Lines(opened.value.text).toText(head)));
  if (key && !selection.value.includes(key)) choose([key]);
}

let shownKey = null;

/** Marks what is chosen in the canvas, and brings it into view. */
function showChosen() {
  const one = chosen.value;
  const only = onlyChosen.value;
  const span = one?.function.span;
  if (!editor) return;
  const range = span ? placeOf(span) : null;
  const effects = [setShown.of({ only: only && range ? range : null, chosen: range })];
  const isNew = one?.key !== shownKey;
  shownKey = one?.key ?? null;
  if (range && isNew && !editor.view.hasFocus) effects.push(EditorView.scrollIntoView(range[0], { y: 'start', yMargin: 60 }));
  editor.view.dispatch({ effects });
}

function showProblems() {
  const list = problems.value;
  const file = openedFile.value;
  if (!editor || !file) return;
  const diagnostics = list.filter((one) => one.file === file && one.span).map(({ span, level, text, help }) => {
    const [from, to] = placeOf(span);
    return { from, to: Math.max(to, Math.min(from + 1, editor.view.state.doc.length)), severity: level, message: help ? `${text}\n${help}` : text };
  });
  editor.view.dispatch(setDiagnostics(editor.view.state, diagnostics));
}

function showWanted() {
  const wish = wanted.value;
  if (!wish || !editor) return;
  const [place] = placeOf([wish.byte]);
  onlyChosen.value = false;
  editor.view.dispatch({ selection: EditorSelection.cursor(place), effects: EditorView.scrollIntoView(place, { y: 'center' }) });
  editor.view.focus();
}
