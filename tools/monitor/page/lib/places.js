// Places of panels in layouts.

export const right = (beside, size) => ({ beside, direction: 'right', size });
export const below = (beside, size) => ({ beside, direction: 'below', size });
export const within = (beside, inactive = true) => ({ beside, direction: 'within', inactive });
/** Below a panel of a wide window; a tab beside it in a narrower one, where both would be too small. */
export const belowIfWide = (beside, size, width) => (width < 1400 ? within(beside) : below(beside, size));

const LOWER = /^(timeline|plot|watches|log|latency|code|inspector)/;

/** The panels of a layout on a narrow window, where they share two groups. */
export function narrowed(panels) {
  const [upper, lower] = [false, true].map((isLower) => panels.filter(([id]) => LOWER.test(id) === isLower));
  if (lower.length === 0 && upper.length > 1) lower.push(...upper.splice(Math.ceil(upper.length / 2)));
  const group = (all, where) => all.map(([id, { params, title }], index) => [id, { ...(index === 0 ? where : within(all[0][0])), params, title }]);
  return [...group(upper, {}), ...group(lower, below(upper[0]?.[0], 300))];
}

/** The panels that are offered; the first one beside a missing panel takes the place of that panel. */
export function fitted(panels, isOffered) {
  const missing = new Map();
  return panels.flatMap(([id, where]) => {
    const gap = missing.get(where.beside);
    const place = !gap ? where : gap.by ? { ...where, beside: gap.by } : { ...gap.where, params: where.params };
    if (!isOffered(id)) {
      missing.set(id, { where: place });
      return [];
    }
    if (gap) gap.by ??= id;
    return [[id, place]];
  });
}
