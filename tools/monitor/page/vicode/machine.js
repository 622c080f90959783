// A component of the model as the canvas shows it: states with all their parts, and an arrow for each source of a transition.

const nameOf = (one) => one.function.name.text;

/** Key of a state, and of an arrow: the number of its attribute, and its source. */
export const stateKey = (name) => `s:${name}`;
export const arrowKey = (name, arrow, from) => `t:${name}:${arrow}:${from}`;

/** What a key is of: {kind: 'state', name}, {kind: 'arrow', name, arrow, from} or {kind: 'note'}. */
export function parsed(key) {
  const [kind, name, arrow, from] = key.split(':');
  if (kind === 'n') return { kind: 'note' };
  return kind === 's' ? { kind: 'state', name } : { kind: 'arrow', name, arrow: Number(arrow), from };
}

const links = (owner) => owner.arguments.filter(({ input }) => input === 'link').map(({ kind, child, name }) => ({ kind, child, argument: name.text, by: owner.name.text }));

/** Ages and outcomes for which functions ask, each once: `age of Marker`. */
const asks = (functions) => [...new Set(functions.flatMap((one) => one.arguments).filter(({ input }) => input === 'age' || input === 'outcome').map(({ input, of }) => `${input} of ${of}`))];

/** Children of several functions, each once; what is written by one of them is a modulation. */
function children(functions) {
  const found = new Map();
  for (const one of functions.flatMap(links)) {
    const known = found.get(one.child);
    if (!known || (known.kind !== 'modulation' && one.kind === 'modulation')) found.set(one.child, one);
  }
  return [...found.values()];
}

function stateOf(component, state) {
  const name = nameOf(state);
  const hooks = component.hooks.filter((hook) => hook.states.some((one) => one.text === name));
  const found = hooks.filter(({ role }) => role === 'entry').flatMap((hook) => hook.function.arguments).find(({ input }) => input === 'found');
  return {
    key: stateKey(name),
    name,
    docs: state.function.docs.text,
    initial: state.initial,
    last: state.last,
    end: state.end,
    takes: found?.of ?? null,
    hooks: hooks.map((hook) => ({ name: nameOf(hook), role: hook.role })),
    asks: asks([state.function, ...hooks.map((hook) => hook.function)]),
    children: children([state.function, ...hooks.map((hook) => hook.function)]),
    function: state.function,
  };
}

/** The arrows of a condition or, `bare`, of a state: no function decides there, and the name is what the arrow waits for. */
function arrowsOf(transition, bare) {
  const owner = nameOf(transition);
  return transition.arrows.flatMap((arrow, index) => {
    const any = arrow.from === 'any';
    const sources = any ? ['*'] : arrow.from.these.map((one) => one.text);
    return sources.map((from) => ({
      key: arrowKey(owner, index, from),
      name: bare ? (arrow.when?.[0] ?? 'timer') : owner,
      owner,
      bare,
      parts: transition.arrows.length,
      arrow: index,
      from,
      any,
      sources,
      to: arrow.to.text,
      after_ms: arrow.after_ms?.[0] ?? null,
      after: arrow.after?.[0] ?? null,
      when: arrow.when?.[0] ?? null,
      times: arrow.times?.[0] ?? null,
      carries: transition.function.carries?.text ?? null,
      docs: bare ? '' : transition.function.docs.text,
      children: bare ? [] : children([transition.function]),
      asks: bare ? [] : asks([transition.function]),
      function: transition.function,
    }));
  });
}

/** A component as a machine; null if there is none of the key. */
export function machineOf(model, name) {
  const component = model?.components.find((one) => one.key === name);
  if (!component) return null;
  const states = component.states.map((state) => stateOf(component, state));
  const known = new Set(states.map((state) => state.name));
  const arrows = [...component.states.flatMap((one) => arrowsOf(one, true)), ...component.transitions.flatMap((one) => arrowsOf(one, false))];
  return {
    component,
    name,
    states,
    // An arrow whose ends are not known is shown in the list of mistakes only.
    arrows: arrows.filter(({ from, to, any }) => known.has(to) && (any || known.has(from))),
    byKey: new Map([...states, ...arrows].map((one) => [one.key, one])),
    start: component.hooks.filter(({ role }) => role === 'start'),
    stop: component.hooks.filter(({ role }) => role === 'stop'),
    step: component.step,
  };
}

/** All functions of a component. */
export function functionsOf(component) {
  const { states, transitions, hooks, info, modulations, work, others, step } = component;
  return [...states, ...transitions, ...hooks, ...info, ...modulations, ...work].map((one) => one.function).concat(others, step ?? []);
}

/** A name that no function of the component has: `name`, `name_2`, …. */
export function freeName(component, wished, taken = []) {
  const known = new Set([...functionsOf(component).map((one) => one.name.text), ...taken]);
  if (!known.has(wished)) return wished;
  let number = 2;
  while (known.has(`${wished}_${number}`)) number += 1;
  return `${wished}_${number}`;
}
