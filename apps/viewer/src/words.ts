// Numbers and sentences for people. The relation's words are the engine's; numbers are those of the report, shortened.
import type { Header, Pair, Report, Vec } from './data';

export function numberText(x: number): string {
  if (x === 0) return '0';
  return String(Number(x.toPrecision(6)));
}

export function lengthText(x: number, unit: string): string {
  return unit === 'unit' ? numberText(x) : `${numberText(x)} ${unit}`;
}

export function countText(n: number, one: string, many = `${one}s`): string {
  return `${n.toLocaleString('en-US')} ${n === 1 ? one : many}`;
}

export function vectorText(v: Vec): string {
  return `(${v.map((x) => numberText(x)).join(', ')})`;
}

/// Of length 1: six decimals tell it, and what is less is rounding.
export function directionText(v: Vec): string {
  return `(${v.map((x) => String(Number(x.toFixed(6)) + 0)).join(', ')})`;
}

/// How many faces meet, where at least one of the two is made of faces; other shapes are one element each.
function facesText(header: Header, report: Report, index: number): string {
  const pair = report.pairs[index];
  const count = header.words[index].face_pairs;
  const meshes = [pair.a_index, pair.b_index].filter((i) => report.objects[i].triangles > 0).length;
  if (count === undefined || meshes === 0) return '';
  if (count === 0) return pair.containment !== 'none' ? 'no faces meet' : '';
  return meshes === 2 ? countText(count, 'face pair') : countText(count, 'face');
}

/// The one number of a pair that people sort by: "0.5 m deep", "2 m apart", "24 face pairs".
export function pairNumber(header: Header, report: Report, index: number): string {
  const pair = report.pairs[index];
  if (pair.distance && pair.distance.upper > 0) return `${lengthText(pair.distance.upper, report.unit)} apart`;
  if (pair.penetration && pair.penetration.upper > 0) return `${lengthText(pair.penetration.upper, report.unit)} deep`;
  return facesText(header, report, index);
}

function depthText(pair: Pair, unit: string): string[] {
  const depth = pair.penetration;
  if (!depth || depth.upper === 0) return [];
  const lower = numberText(depth.lower);
  const range = lower === numberText(depth.upper) ? '' : `${lower} to `;
  const way = `moving B by it along ${directionText(depth.direction)} parts them`;
  return [`${range}${lengthText(depth.upper, unit)} deep; ${way}`];
}

/// What is known of a pair beside its sentence, a line each.
export function pairFacts(header: Header, report: Report, index: number): string[] {
  const pair = report.pairs[index];
  const facts: string[] = [];
  if (pair.distance && pair.distance.upper > 0)
    facts.push(
      `${lengthText(pair.distance.upper, report.unit)} apart, from ${vectorText(pair.distance.on_a)} to ${vectorText(pair.distance.on_b)}`,
    );
  facts.push(...depthText(pair, report.unit));
  const faces = facesText(header, report, index);
  if (faces) facts.push(faces.startsWith('no') ? faces : `${faces} in contact`);
  if (pair.regions && pair.regions.length > 0) facts.push(countText(pair.regions.length, 'region of contact', 'regions of contact'));
  if (pair.manifold) facts.push(countText(pair.manifold.points.length, 'point of contact', 'points of contact'));
  facts.push(pair.status === 'exact' ? 'decided exactly' : `status: ${pair.status.replace('_', ' ')}`);
  return facts;
}

export type Order = 'deepest' | 'largest' | 'nearest' | 'listed';

const depthOf = (pair: Pair) => pair.penetration?.upper ?? 0;
const gapOf = (pair: Pair) => (pair.relation === 'apart' ? (pair.distance?.upper ?? Infinity) : 0);

/// The numbers of the pairs in that order; those that are equal in it stay as listed.
export function sortedPairs(header: Header, report: Report, order: Order): number[] {
  const pairs = report.pairs;
  const faces = (i: number) => header.words[i].face_pairs ?? 0;
  const numbers = pairs.map((_, i) => i);
  if (order === 'deepest')
    numbers.sort((i, j) => depthOf(pairs[j]) - depthOf(pairs[i]) || compare(gapOf(pairs[i]), gapOf(pairs[j])) || faces(j) - faces(i) || i - j);
  if (order === 'largest') numbers.sort((i, j) => faces(j) - faces(i) || i - j);
  if (order === 'nearest') numbers.sort((i, j) => compare(gapOf(pairs[i]), gapOf(pairs[j])) || i - j);
  return numbers;
}

const compare = (a: number, b: number) => (a < b ? -1 : a > b ? 1 : 0);
