// Numbers for people: those of the report, shortened.
import type { Vec } from './data';

export function numberText(x: number): string {
  if (x === 0) return '0';
  return String(Number(x.toPrecision(6)));
}

/// Null stands for lengths beyond the largest double.
export function lengthText(x: number | null, unit: string): string {
  if (x === null) return `more than ${lengthText(Number.MAX_VALUE, unit)}`;
  return withUnit(numberText(x), unit);
}

const mostDigits = 6;

/// The exponent of the greatest power of ten that is no more than x.
const decadeOf = (x: number) => Math.floor(Math.log10(x));

/// A bound with as many digits. A part in 10⁹ of it is taken for its rounding.
function roundedOutward(x: number, digits: number, way: 'down' | 'up'): string {
  if (!(x > 0)) return '0';
  const step = 10 ** Math.max(decadeOf(x) - digits + 1, -300);
  const steps = way === 'up' ? Math.ceil((x / step) * (1 - 1e-9)) : Math.floor((x / step) * (1 + 1e-9));
  return String(Number(Math.min(steps * step, Number.MAX_VALUE).toPrecision(12)));
}

/// A unit that is a number of others is multiplied: "2 × 0.3 m".
export const withUnit = (text: string, unit: string) => (unit === 'unit' ? text : `${text} ${/^[-+.\d]/.test(unit) ? '× ' : ''}${unit}`);

/// The bounds of a length, by the rule of bracket_text in the library (toccata/reports/report.hpp): one number where
/// both are the same in six digits, else both, rounded outward.
export function boundTexts(lower: number, upper: number): string[] {
  if (numberText(lower) === numberText(upper)) return [numberText(upper)];
  const width = decadeOf(upper - lower);
  const digitsOf = (x: number) => (x > 0 ? Math.min(Math.max(2 + decadeOf(x) - width, 2), mostDigits) : 1);
  return [roundedOutward(lower, digitsOf(lower), 'down'), roundedOutward(upper, digitsOf(upper), 'up')];
}

/// "20 to 21 mm".
export function bracketText(lower: number | null, upper: number | null, unit: string): string {
  if (lower === null) return lengthText(null, unit);
  return upper === null ? `at least ${lowerBoundText(lower, unit)}` : withUnit(boundTexts(lower, upper).join(' to '), unit);
}

/// One bound alone.
export const lowerBoundText = (x: number, unit: string) => withUnit(roundedOutward(x, mostDigits, 'down'), unit);
export const upperBoundText = (x: number, unit: string) => withUnit(roundedOutward(x, mostDigits, 'up'), unit);

/// Made once: to make one anew takes longer than all else that is done for a row of a list.
const grouping = new Intl.NumberFormat('en-US');

/// 1234567 as "1,234,567".
export const groupedText = (n: number) => grouping.format(n);

export function countText(n: number, one: string, many = `${one}s`): string {
  return `${groupedText(n)} ${n === 1 ? one : many}`;
}

export function vectorText(v: Vec): string {
  return `(${v.map((x) => numberText(x)).join(', ')})`;
}

/// A direction has length 1, so six decimals tell it, and what is less is rounding.
export function directionText(v: Vec): string {
  return `(${v.map((x) => String(Number(x.toFixed(6)) + 0)).join(', ')})`;
}
