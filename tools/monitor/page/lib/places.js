// Places of panels in layouts.

export const right = (beside, size) => ({ beside, direction: 'right', size });
export const below = (beside, size) => ({ beside, direction: 'below', size });
export const within = (beside, inactive = true) => ({ beside, direction: 'within', inactive });

/** On a narrow window all panels share two groups. */
export function narrow(first, rest, bottom) {
  return [
    [first, {}],
    ...rest.map((name) => [name, within(first)]),
    [bottom[0], below(first, 300)],
    ...bottom.slice(1).map((name) => [name, within(bottom[0])]),
  ];
}
