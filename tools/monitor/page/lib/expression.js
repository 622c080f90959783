// Expressions over outputs and parameters, as `hypot(Cart.place.x, Cart.place.y)` or `rate(Lamp.angle) > 0.5`.

import { typedNumber } from './format.js';

const FUNCTIONS = {
  sqrt: Math.sqrt, abs: Math.abs, min: Math.min, max: Math.max, hypot: Math.hypot, sin: Math.sin, cos: Math.cos, atan2: Math.atan2, sign: Math.sign, floor: Math.floor,
};
/** Operators by precedence, the weakest first. */
const LEVELS = [['||'], ['&&'], ['>', '<', '>=', '<=', '==', '!='], ['+', '-'], ['*', '/']];
/** The same kind of number on both sides: whole numbers stay exact beside a BigInt. */
function alike(a, b) {
  if (typeof a === typeof b) return [a, b];
  return [a, b].every((one) => typeof one === 'bigint' || Number.isInteger(one)) ? [BigInt(a), BigInt(b)] : [Number(a), Number(b)];
}
const exactly = (apply) => (a, b) => apply(...alike(a, b));
const roughly = (apply) => (a, b) => apply(Number(a), Number(b));
const APPLY = {
  '||': (a, b) => a || b, '&&': (a, b) => a && b, '>': (a, b) => Number(a > b), '<': (a, b) => Number(a < b), '>=': (a, b) => Number(a >= b), '<=': (a, b) => Number(a <= b),
  '==': exactly((a, b) => Number(a === b)), '!=': exactly((a, b) => Number(a !== b)),
  '+': exactly((a, b) => a + b), '-': exactly((a, b) => a - b), '*': exactly((a, b) => a * b), '/': roughly((a, b) => a / b), '^': roughly((a, b) => a ** b),
};
/** The difference of two numbers; a BigInt stays exact. */
export const minus = APPLY['-'];
const NUMBER = /^\d+(?:\.\d+)?(?:e[+-]?\d+)?|^\.\d+(?:e[+-]?\d+)?/i;
/** A name, and the path to a part of its value. */
const NAME = /^[\p{XID_Start}_]\p{XID_Continue}*/u;
const PATH = /^(?:\.\p{XID_Continue}+|\[\d+\])*/u;
const SIGN = /^(?:>=|<=|==|!=|&&|\|\||[-+*/^()<>,])/;

/** The parts of an expression. A name may begin with one of `components`, as `Filter<3>.value`. */
function tokensOf(text, components) {
  const tokens = [];
  for (let rest = text.trimStart(); rest; rest = rest.trimStart()) {
    const component = components.find((name) => rest.startsWith(`${name}.`)) ?? rest.match(NAME)?.[0];
    const token = component ? component + rest.slice(component.length).match(PATH)[0] : (rest.match(NUMBER) ?? rest.match(SIGN))?.[0];
    if (!token) throw new Error(`“${text}” has “${[...rest][0]}”, which is no name, no number and none of + - * / ^ ( ) < > = ! , && ||`);
    tokens.push({ token, isName: Boolean(component) });
    rest = rest.slice(token.length);
  }
  return tokens;
}

/**
 * Reads an expression: {names, begin}. `begin()` starts a course of samples; it returns a function of the time, s, and of the values of
 * `names`. `rate` is the change per second since the sample before. `components` are the names of a tree, which
 * may have signs. Throws an error that says what was wrong.
 */
export function expression(text, components = []) {
  const all = tokensOf(text, components);
  const tokens = all.map(({ token }) => token);
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
        return before && now.time > before.time ? Number(minus(value, before.value)) / (now.time - before.time) : NaN;
      };
    }
    if (!FUNCTIONS[name]) throw new Error(`there is no function “${name}”; there are rate, ${Object.keys(FUNCTIONS).join(', ')}`);
    return (now) => FUNCTIONS[name](...given.map((one) => Number(one(now))));
  };
  const single = () => {
    const [token, { isName = false } = {}] = [tokens[at], all[at]];
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
    if (/^\.?\d/.test(token ?? '')) {
      const value = typedNumber(token);
      return () => value;
    }
    if (!isName) throw new Error(`“${text}” lacks a value before “${token ?? 'its end'}”`);
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
