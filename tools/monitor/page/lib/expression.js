// Expressions over outputs and parameters, as `hypot(Cart.place.x, Cart.place.y)` or `rate(Lamp.angle) > 0.5`.

const FUNCTIONS = {
  sqrt: Math.sqrt, abs: Math.abs, min: Math.min, max: Math.max, hypot: Math.hypot, sin: Math.sin, cos: Math.cos, atan2: Math.atan2, sign: Math.sign, floor: Math.floor,
};
/** Operators by precedence, the weakest first. */
const LEVELS = [['||'], ['&&'], ['>', '<', '>=', '<=', '==', '!='], ['+', '-'], ['*', '/']];
const APPLY = {
  '||': (a, b) => a || b, '&&': (a, b) => a && b, '>': (a, b) => Number(a > b), '<': (a, b) => Number(a < b), '>=': (a, b) => Number(a >= b), '<=': (a, b) => Number(a <= b),
  '==': (a, b) => Number(a === b), '!=': (a, b) => Number(a !== b),
  '+': (a, b) => a + b, '-': (a, b) => a - b, '*': (a, b) => a * b, '/': (a, b) => a / b, '^': (a, b) => a ** b,
};
const TOKEN = /\s*(\d+(?:\.\d+)?(?:e[+-]?\d+)?|[A-Za-z_][\w.[\]]*|>=|<=|==|!=|&&|\|\||[-+*/^()<>,])/gy;

/**
 * Reads an expression: {names, begin}. `begin()` starts a course of samples; it returns a function of the time, s, and of the values of
 * `names`. `rate` is the change per second since the sample before. Throws an error that says what was wrong.
 */
export function expression(text) {
  const tokens = [];
  TOKEN.lastIndex = 0;
  for (let found = TOKEN.exec(text); found; found = TOKEN.exec(text)) tokens.push(found[1]);
  if (tokens.join('') !== text.replace(/\s+/g, '')) throw new Error(`“${text}” has a sign that is none of + - * / ^ ( ) < > = ! , && ||`);
  const names = [];
  let at = 0;
  let rates = 0;
  const expect = (token) => {
    if (tokens[at] !== token) throw new Error(`“${text}” lacks “${token}” before “${tokens[at] ?? 'its end'}”`);
    at += 1;
  };
  const call = (name) => {
    const given = [binary(0)];
    while (tokens[at] === ',') {
      at += 1;
      given.push(binary(0));
    }
    expect(')');
    if (name === 'rate') {
      const slot = rates++;
      return (now) => {
        const [value, before] = [given[0](now), now.memory[slot]];
        now.memory[slot] = { value, time: now.time };
        return before && now.time > before.time ? (value - before.value) / (now.time - before.time) : NaN;
      };
    }
    if (!FUNCTIONS[name]) throw new Error(`there is no function “${name}”; there are rate, ${Object.keys(FUNCTIONS).join(', ')}`);
    return (now) => FUNCTIONS[name](...given.map((one) => one(now)));
  };
  const single = () => {
    const token = tokens[at];
    at += 1;
    if (token === '-') {
      const inner = power();
      return (now) => -inner(now);
    }
    if (token === '(') {
      const inner = binary(0);
      expect(')');
      return inner;
    }
    if (/^\d/.test(token ?? '')) return () => Number(token);
    if (!/^[A-Za-z_]/.test(token ?? '')) throw new Error(`“${text}” lacks a value before “${token ?? 'its end'}”`);
    if (tokens[at] === '(') {
      at += 1;
      return call(token);
    }
    if (!names.includes(token)) names.push(token);
    const index = names.indexOf(token);
    return (now) => now.values[index];
  };
  const power = () => {
    const base = single();
    if (tokens[at] !== '^') return base;
    at += 1;
    const exponent = power();
    return (now) => APPLY['^'](base(now), exponent(now));
  };
  const binary = (level) => {
    if (level === LEVELS.length) return power();
    let left = binary(level + 1);
    while (LEVELS[level].includes(tokens[at])) {
      const [operator, before] = [tokens[at], left];
      at += 1;
      const right = binary(level + 1);
      left = (now) => APPLY[operator](before(now), right(now));
    }
    return left;
  };
  const root = binary(0);
  if (at < tokens.length) throw new Error(`“${text}” has “${tokens[at]}” where an operator was expected`);
  return {
    names,
    begin() {
      const memory = [];
      return (time, values) => root({ time, values, memory });
    },
  };
}
