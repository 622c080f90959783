// Keys of the page. Panels add theirs; `?` shows the list.

const bindings = [];

/**
 * Adds a key: {key, text, group, run, where}. A key is `event.key`, with `Shift+`, `Ctrl+` or `Alt+` before. With `where`, a selector, it is
 * valid only where the focus is within such an element. Returns how to remove it.
 */
export function bind(binding) {
  bindings.push(binding);
  return () => bindings.splice(bindings.indexOf(binding), 1);
}

export const allKeys = () => bindings;

function nameOf(event) {
  const shift = event.shiftKey && event.key.length > 1 ? 'Shift+' : '';
  return `${event.ctrlKey || event.metaKey ? 'Ctrl+' : ''}${event.altKey ? 'Alt+' : ''}${shift}${event.key}`;
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
  if (event.defaultPrevented || isOrphan(event)) return;
  const name = nameOf(event);
  if (name === 'Escape' && isTaken(event)) event.target.blur();
  if (isTaken(event) && name !== 'Escape') return;
  const binding = bindings.findLast((one) => one.key === name && one.where && event.target.closest(one.where)) ?? bindings.findLast((one) => one.key === name && !one.where);
  if (!binding) return;
  event.preventDefault();
  binding.run(event);
});
