// Ways through a state machine.

/** The shortest way of transitions from a state to another, as their numbers; null if none leads there. */
export function shortestWay({ transitions }, from, to) {
  const before = new Map([[from, null]]);
  const open = [from];
  while (open.length > 0 && !before.has(to)) {
    const state = open.shift();
    transitions.forEach((one, number) => {
      if (one.from !== state || before.has(one.to)) return;
      before.set(one.to, number);
      open.push(one.to);
    });
  }
  if (!before.has(to)) return null;
  const way = [];
  for (let at = to; at !== from; at = transitions[before.get(at)].from) way.unshift(before.get(at));
  return way;
}

/** The state that is farthest from the initial one: what a machine is for, as long as nobody names another state; the last of several. */
export function farthest(component) {
  const initial = Math.max(0, component.states.findIndex((state) => state.initial));
  const away = component.states.map((_, state) => shortestWay(component, initial, state)?.length ?? -1);
  return away.lastIndexOf(Math.max(...away));
}
