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

window.addEventListener('keydown', (event) => {
  if (event.defaultPrevented) return;
  const name = nameOf(event);
  if (name === 'Escape' && isTaken(event)) event.target.blur();
  if (isTaken(event) && name !== 'Escape') return;
  const binding = bindings.findLast((one) => one.key === name && one.where && event.target.closest(one.where)) ?? bindings.findLast((one) => one.key === name && !one.where);
  if (!binding) return;
  event.preventDefault();
  binding.run(event);
});
