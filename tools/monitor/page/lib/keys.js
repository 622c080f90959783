// Keys of the page. Panels add theirs; `?` shows the list.

const bindings = [];

/**
 * Adds a key: {key, text, group, run, where, plain}. A key is `event.key`, with `Shift+`, `Ctrl+` or `Alt+` before. With `where`, a selector, it is
 * valid only where the focus is within such an element. A page that is restricted has only those with `plain`. Returns how to remove it.
 */
export function bind(binding) {
  bindings.push(binding);
  return () => bindings.splice(bindings.indexOf(binding), 1);
}

let isRestricted = () => false;

/** Sets the function that says whether the page has its `plain` keys only. */
export const restrict = (test) => { isRestricted = test; };

export const allKeys = () => bindings.filter(({ plain }) => plain || !isRestricted());

/** Whether a key belongs to an input method, such as Enter that ends a conversion: it is no command, and commits nothing. */
export const isComposed = (event) => event.isComposing || event.keyCode === 229;

// Before all other listeners. An editor of code composes by itself.
window.addEventListener('keydown', (event) => {
  if (isComposed(event) && !event.target.isContentEditable) event.stopImmediatePropagation();
}, true);

/**
 * Names of a key, the best first: as it was pressed; the sign alone that Alt or AltGr has made of it, as `[` on many keyboards; the digit or
 * Latin letter of its place, for keyboards with others.
 */
export function namesOf({ key, code = '', shiftKey, ctrlKey, metaKey, altKey }) {
  const name = (alt, text) => `${ctrlKey && (alt || !altKey) || metaKey ? 'Ctrl+' : ''}${alt ? 'Alt+' : ''}${shiftKey && text.length > 1 ? 'Shift+' : ''}${text}`;
  const isSign = key.length === 1 && !/[\p{L}\p{N}\s]/u.test(key);
  const [, letter, digit] = code.match(/^(?:Key([A-Z])|Digit(\d))$/) ?? [];
  const here = digit && key.length === 1 && !/\d/.test(key) && !shiftKey ? digit : letter && /[^\x20-\x7e]/.test(key) ? (shiftKey ? letter : letter.toLowerCase()) : null;
  return [name(altKey, key), ...(altKey && isSign ? [name(false, key)] : []), ...(here ? [name(altKey, here)] : [])];
}

const TYPED = new Set(['text', 'number', 'search', 'password']);

/** Whether the key belongs to the control that has the focus. */
function isTaken(event) {
  const { target, key } = event;
  const tag = target.tagName;
  if (tag === 'TEXTAREA' || target.isContentEditable) return true;
  if (tag === 'INPUT') return TYPED.has(target.type) || key.startsWith('Arrow') || key === ' ' || key === 'Home' || key === 'End';
  if (tag === 'SELECT') return !event.ctrlKey && key !== '?';
  if (tag === 'BUTTON' || tag === 'SUMMARY' || target.getAttribute('role') === 'tab') {
    return key === ' ' || key === 'Enter' || (target.getAttribute('role') === 'tab' && key.startsWith('Arrow'));
  }
  return false;
}

/** The text field that was focused last. */
let field = null;

/** Whether the focused field was removed: what is still typed is text, and no command. */
const isOrphan = ({ target, key }) => target === document.body && field !== null && (!field.isConnected || field.disabled) && key.length === 1;

window.addEventListener('focusin', ({ target }) => {
  field = target.isContentEditable || target.tagName === 'TEXTAREA' || (target.tagName === 'INPUT' && TYPED.has(target.type)) ? target : null;
});
window.addEventListener('focusout', ({ target }) => setTimeout(() => {
  if (field === target && target.isConnected && !target.disabled && document.activeElement !== target) field = null;
}));
window.addEventListener('pointerdown', () => { field = null; }, true);

// After a click on a button, its panel gets the focus. Otherwise Space would press the button again.
window.addEventListener('click', (event) => {
  const button = event.target.closest('button, summary, [role=tab]');
  if (event.detail === 0 || !button || button !== document.activeElement || button.closest('dialog')) return;
  const panel = button.closest('.panel');
  if (panel) panel.focus({ preventScroll: true });
  else button.blur();
});

/** The element that was focused by a click. */
let pointed = null;
window.addEventListener('focusin', () => { pointed = null; });
window.addEventListener('pointerup', () => { pointed = document.activeElement; }, true);

/** Whether an element was focused by a click. Then Space is a key of the page. */
export const isPointed = (element) => element === pointed;

// Escape closes the open menu wherever the focus is, and does nothing else then.
window.addEventListener('keydown', (event) => {
  const menu = event.key === 'Escape' && document.querySelector('.menu:popover-open');
  if (!menu) return;
  event.preventDefault();
  event.stopPropagation();
  menu.hidePopover();
}, true);

window.addEventListener('keydown', (event) => {
  // The browser closes a dialog by Escape, also if the focus is on STOP in it.
  if (event.defaultPrevented || isOrphan(event) || (event.key === 'Escape' && event.target.closest('dialog'))) return;
  const names = namesOf(event);
  const isEscape = names[0] === 'Escape';
  if (isEscape && isTaken(event)) event.target.blur();
  if (isTaken(event) && !isEscape) return;
  const valid = allKeys();
  const bound = (name) => valid.findLast((one) => one.key === name && one.where && event.target.closest(one.where)) ?? valid.findLast((one) => one.key === name && !one.where);
  const binding = names.map(bound).find(Boolean);
  if (!binding) return;
  event.preventDefault();
  binding.run(event);
});
