// Numbers for people: those of the report, shortened.
import type { Vec } from './data';

export function numberText(x: number): string {
  if (x === 0) return '0';
  return String(Number(x.toPrecision(6)));
}

/// A unit that is a number of others is multiplied: "2 × 0.3 m". Null stands for lengths beyond the largest double.
export function lengthText(x: number | null, unit: string): string {
  if (x === null) return `more than ${lengthText(Number.MAX_VALUE, unit)}`;
  if (unit === 'unit') return numberText(x);
  return `${numberText(x)} ${/^[-+.\d]/.test(unit) ? '× ' : ''}${unit}`;
}

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
