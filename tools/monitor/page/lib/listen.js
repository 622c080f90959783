// Listeners that end together.

/** Listens to events of a target, {type: function}; returns how to end it. */
export function on(target, listeners, options) {
  const all = Object.entries(listeners);
  for (const [type, run] of all) target.addEventListener(type, run, options);
  return () => all.forEach(([type, run]) => target.removeEventListener(type, run, options));
}
